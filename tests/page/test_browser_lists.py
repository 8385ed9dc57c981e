"""Rz, branches of unlike sizes and a duty on the page, in a real browser: set, undone, linked and downloaded."""

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from browser import do, field, write

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "examples" / "planetary.toml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def served(served_text):
    """Takes the place of the server of the tutorial's joint."""
    return served_text(TEXT)


def press(page, name):
    do(page, lambda: page.get_by_role("button", name=name, exact=True).click())


def opened(page, *groups):
    for name in groups:
        page.evaluate(f"document.querySelector('details[data-group={name}]').open = true")


def downloaded(page, name, file):
    with page.expect_download() as waiting:
        page.get_by_role("link", name=name).click()
    waiting.value.save_as(file)
    return file.read_text(encoding="utf-8")


@pytest.mark.long
def test_rz_branches_and_a_duty_are_set_undone_linked_and_downloaded(page, chromium, tmp_path):
    opened(page, "surface", "branch", "duty", "drive")
    # Rz in place of G; the file keeps what was written
    page.get_by_label("roughness given as", exact=True).select_option("Rz")
    assert field(page, "surface.roughness_average").is_hidden()
    write(page, "surface.mean_roughness_depth", "0.4 um")
    assert field(page, "surface.fractal_roughness").input_value() == ""
    # a branch for each planet, whatever their number
    press(page, "Give each branch its own sizes")
    assert page.locator("[data-list=branch] fieldset").count() == 3
    write(page, "branch.1.planet_deviation", "1.5 um")
    write(page, "drive.planets", "4")
    assert page.locator("[data-list=branch] fieldset").count() == 4
    write(page, "branch.4.planet_deviation", "-1 um")
    slider = page.get_by_label("planet deviation, branch 2, slider")
    slider.focus()
    do(page, lambda: slider.press("ArrowRight"))
    assert float(field(page, "branch.2.planet_deviation").input_value().removesuffix(" um")) > 0.0
    # loads: the first is that of the joint, a second takes half of its time
    press(page, "Add a load")
    assert page.evaluate("document.activeElement.id") == "value-duty-1-output_torque"
    press(page, "Add a load")
    assert [field(page, f"duty.{i}.share").input_value() for i in (1, 2)] == ["0.5", "0.5"]
    write(page, "duty.2.output_torque", "-3 N*m")
    slider = page.get_by_label("share, load 1, slider")
    slider.focus()
    do(page, lambda: slider.press("ArrowRight"))
    shares = [float(field(page, f"duty.{i}.share").input_value()) for i in (1, 2)]
    assert shares[0] > 0.5
    assert sum(shares) == pytest.approx(1.0, abs=1e-12)
    assert page.locator("#error").is_hidden()
    # one step back, and forth
    do(page, lambda: page.keyboard.press("Control+z"))
    assert field(page, "duty.1.share").input_value() == "0.5"
    do(page, lambda: page.keyboard.press("Control+z"))
    do(page, lambda: page.keyboard.press("Control+z"))
    assert page.locator("[data-list=duty] fieldset").count() == 1
    for _ in range(3):
        press(page, "Redo")
    # the link shows the same
    page.wait_for_timeout(500)
    other = chromium.new_page()
    other.goto(page.url)
    other.wait_for_selector("html[data-state=ready]", timeout=60_000)
    for path in (
        "surface.mean_roughness_depth",
        "branch.2.planet_deviation",
        "branch.4.planet_deviation",
        "duty.2.share",
    ):
        assert field(other, path).input_value() == field(page, path).input_value() != ""
    assert other.locator("#cards").inner_text() == page.locator("#cards").inner_text()
    other.close()
    # the file says the same to the command
    text = downloaded(page, "Save joint file", tmp_path / "joint.toml")
    tables = tomllib.loads(text)
    assert tables["surface"]["mean_roughness_depth"] == "0.4 um"
    assert "roughness_average" not in tables["surface"]
    assert [each.get("planet_deviation") for each in tables["branch"]][::3] == ["1.5 um", "-1 um"]
    assert [each["share"] for each in tables["duty"]] == shares
    assert "# from the library: asperity materials" in text
    shown = json.loads(downloaded(page, "Save JSON", tmp_path / "page.json"))
    command = [sys.executable, "-c", "from asperity.cli import main; main()", "joint", "joint.toml", "--json"]
    told = json.loads(subprocess.run(command, cwd=tmp_path, capture_output=True, check=True).stdout)
    for part in ("torsional_stiffness", "forces"):
        one, other = (each["standing"] | each for each in (told, shown))
        assert flat(one[part]) == pytest.approx(flat(other[part]), rel=1e-9)


def flat(node, path=""):
    if isinstance(node, dict):
        return {
            key: value for name, each in node.items() for key, value in flat(each, f"{path}.{name}").items()
        }
    if isinstance(node, list):
        return flat(dict(enumerate(node)), path)
    return {path: node}


@pytest.mark.long
def test_shares_that_do_not_add_up_are_said_at_the_field_and_rows_stay(page):
    opened(page, "duty", "load")
    press(page, "Add a load")
    press(page, "Add a load")
    write(page, "duty.2.share", "30 %")
    error = page.locator("#value-duty-2-share-error")
    assert "the shares of [[duty]] must add up to 1, they add up to 0.8" in error.inner_text()
    assert page.locator("#list-duty-error").inner_text() == ""  # once in the group is enough
    assert page.locator("[data-list=duty] fieldset").count() == 2
    write(page, "duty.1.share", "0.7")
    assert error.inner_text() == ""
    assert page.locator("#error").is_hidden()
    press(page, "Remove load 1")
    assert field(page, "duty.1.share").input_value() == "1"
    assert page.get_by_label("share, load 1, slider").is_disabled()
    press(page, "Remove load 1")
    assert page.locator("[data-list=duty] fieldset").count() == 0
    assert page.evaluate("document.activeElement.textContent") == "Add a load"


@pytest.mark.long
def test_a_click_below_a_field_in_use_reaches_what_it_is_meant_for(page):
    """The help of the field closes as the focus leaves it, and everything below moves up: after the click."""
    opened(page, "duty")
    press(page, "Add a load")
    used = field(page, "duty.1.output_torque")
    used.click()
    shown = page.locator("#value-duty-1-output_torque-help")
    assert shown.is_visible()
    add = page.get_by_role("button", name="Add a load", exact=True)
    add.scroll_into_view_if_needed()
    box = add.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.wait_for_timeout(150)
    assert add.bounding_box() == box
    do(page, page.mouse.up)
    assert page.locator("[data-list=duty] fieldset").count() == 2
    shown.wait_for(state="hidden")
    # what is typed ends as the focus leaves; the click counts all the same
    used.fill("2 N*m")
    summary = page.locator("details[data-group=branch] summary")
    summary.scroll_into_view_if_needed()
    box = summary.bounding_box()
    page.mouse.move(box["x"] + 20, box["y"] + box["height"] / 2)
    do(page, page.mouse.down)  # the focus leaves, and the joint is computed
    assert summary.bounding_box() == box
    page.mouse.up()
    page.wait_for_selector("details[data-group=branch][open]", timeout=5_000)
    # with keys the help follows at once
    used.focus()
    assert shown.is_visible()
    page.get_by_label("sun speed, load 1", exact=True).focus()
    assert shown.is_hidden()
    assert page.locator("#value-duty-1-sun_speed-help").is_visible()


@pytest.mark.long
def test_what_is_saved_beside_an_error_is_said(page, tmp_path):
    opened(page, "duty")
    press(page, "Add a load")
    status = page.locator("#status")
    downloaded(page, "Save joint file", tmp_path / "good.toml")
    assert status.inner_text() == "The joint file is saved."
    write(page, "duty.1.share", "0.5")
    assert "must add up to 1" in page.locator("#value-duty-1-share-error").inner_text()
    assert page.locator("#list-duty-error").inner_text() == ""
    for name, ending in (("Save joint file", "toml"), ("Save JSON", "json")):
        downloaded(page, name, tmp_path / f"kept.{ending}")
        assert status.inner_text() == "Saved the last joint without errors; duty.1.share is not part of it."
    assert (tmp_path / "kept.toml").read_bytes() == (tmp_path / "good.toml").read_bytes()
    write(page, "load.preload", "not a force")
    with page.expect_download(timeout=300_000):
        page.get_by_role("button", name="Save report").click()
    said = "Saved the last joint without errors; duty.1.share, load.preload are not part of it."
    page.wait_for_function("said => document.querySelector('#status').textContent === said", arg=said)


def test_all_warnings_are_shown(page):
    """However many: this joint has none, and gets sixty."""
    assert page.locator("#warnings").inner_text() == "No warnings: all limits are met."
    page.evaluate(
        """() => { const list = document.createElement("ul");
            list.className = "warnings";
            for (let i = 0; i < 60; i++) {
                const item = document.createElement("li");
                item.className = "damage";
                item.textContent = "Damage: the Hertz pressure exceeds first yield, 1.2 times the yield strength";
                list.append(item);
            }
            document.querySelector("#warnings").replaceChildren(list); }"""
    )
    for width in (1400, 400):
        page.set_viewport_size({"width": width, "height": 900})
        hidden = "each => [each.scrollHeight - each.clientHeight, each.scrollWidth - each.clientWidth]"
        assert page.locator("#warnings").evaluate(hidden) == [0, 0]


@pytest.mark.long
def test_branches_need_an_interference_as_the_file_says(page):
    opened(page, "branch", "load")
    write(page, "load.preload", "1000 N")
    press(page, "Give each branch its own sizes")
    assert "[[branch]] needs load.interference" in page.locator("#list-branch-error").inner_text()
    assert field(page, "load.interference").get_attribute("aria-invalid") == "true"
    write(page, "load.interference", "30 um")
    assert page.locator("#error").is_hidden()
    assert field(page, "load.preload").input_value() == ""  # not what was typed before
    press(page, "Equal branches")
    assert page.locator("[data-list=branch] fieldset").count() == 0


@pytest.mark.long
def test_the_lists_of_a_file_are_edited_and_put_back(page, tmp_path):
    file = tmp_path / "duty.toml"
    rows = [
        f'{note}\n[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "1500 rpm"\nshare = "{share} %"\n'
        for note, torque, share in (("# hovering", 8, 40), ("# moving", -3, 25), ("# waiting", 1, 35))
    ]
    depth = TEXT.replace('fractal_roughness = "1.3e-7 mm"', 'mean_roughness_depth = "0.4 um +- 0.1 um"')
    file.write_text(depth + "\n" + "\n".join(rows), encoding="utf-8")
    do(page, lambda: page.locator("#open-file").set_input_files(file))
    opened(page, "duty", "surface")
    assert field(page, "duty.1.share").input_value() == "40 %"
    assert page.get_by_label("roughness given as", exact=True).input_value() == "Rz"
    assert field(page, "surface.mean_roughness_depth").input_value() == "0.4 um +- 0.1 um"
    press(page, "Remove load 2")
    assert [field(page, f"duty.{i}.share").input_value() for i in (1, 2)] == ["0.65", "35 %"]
    text = downloaded(page, "Save joint file", tmp_path / "saved.toml")
    assert "# moving" not in text
    assert text.index("# hovering") < text.index("# waiting") < text.index('"1 N*m"')
    assert 'mean_roughness_depth = "0.4 um +- 0.1 um"' in text
    press(page, "duty: back to the file")
    assert page.locator("[data-list=duty] fieldset").count() == 3
    # as Ra, the same joint
    before = page.locator("#cards").inner_text()
    do(page, lambda: page.get_by_label("roughness given as", exact=True).select_option("Ra"))
    assert page.locator("#cards").inner_text() == before
    assert field(page, "surface.roughness_average").is_visible()
    assert "mean_roughness_depth" not in downloaded(page, "Save joint file", tmp_path / "ra.toml")
    do(page, lambda: page.keyboard.press("Control+z"))
    assert page.get_by_label("roughness given as", exact=True).input_value() == "Rz"
    # another finish leaves the Rz of the drawing as it is
    do(page, lambda: page.locator("#value-finish").select_option("honed"))
    assert page.locator("#error").is_hidden()
    assert field(page, "surface.mean_roughness_depth").input_value() == "0.4 um +- 0.1 um"
    # every control has a name, and the rows fit a small screen
    page.set_viewport_size({"width": 400, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 400
    ids = page.evaluate("[...document.querySelectorAll('[id]')].map((each) => each.id)")
    assert len(ids) == len(set(ids))

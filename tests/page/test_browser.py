"""What a user does on the page, in a real browser; numbers are those of ``asperity joint``."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from browser import do, field, write

from asperity.api.comparison import compare
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.joint_file.solved_document import solve_case
from asperity.library import read_finishes
from asperity.units import format_quantity
from asperity.views.blocks import Table

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
FILE = ROOT / "examples" / "tutorial_joint.toml"


def solution(**changes):
    changes = {key.replace("__", "."): value for key, value in changes.items()}
    return solve_joint(joint_from_values(replace_values(si_values(read_case(FILE)), changes)))


def stiffness(**changes):
    """Assembled stiffness in N·m/arcmin with four digits, as the headline shows it."""
    return shown(solution(**changes))


def shown(solution):
    found = float(solution.result.assembly.stiffness.output_per_arcminute)
    return format_quantity(float(solution.result.assembly.stiffness.output), "N*m/arcmin").split(" ")[
        0
    ], found


def card(page, name="Stiffness"):
    return page.locator(f'[data-value="{name}"]').inner_text()


@pytest.mark.long
def test_numbers_have_the_digits_of_the_commands(page):
    values = [
        0.0,
        523899.3,
        833213.4,
        5.6119e7,
        16324.2,
        0.00065432,
        -1234.56,
        0.123456,
        12.3,
        999999.4,
        999999.6,
        3e-9,
    ]
    script = "([values, digits]) => import('/numbers.js').then((m) => values.map((x) => m.number(x, digits)))"
    for digits in (3, 4, 6):
        written = page.evaluate(script, [values, digits])
        assert written == [format_quantity(value, "1", digits) for value in values]


def test_a_number_alone_keeps_the_unit_of_its_field(page):
    script = "([text, other]) => import('/units.js').then((m) => m.withUnit(text, other))"
    for text, other, expected in (
        ("5", "4 mm", "5 mm"),
        ("5", "4 mm +- 5 um", "5 mm"),
        ("5", "4 mm ± 5 um, uniform", "5 mm"),
        ("1e-3", "3e4 N*m/rad", "1e-3 N*m/rad"),
        ("-3", " degC", "-3 degC"),
        ("5 in", "4 mm", "5 in"),
        ("5", "1.5e3", "5"),
        ("5", "", "5"),
        ("five", "4 mm", "five"),
        ("", "4 mm", ""),
    ):
        assert page.evaluate(script, [text, other]) == expected
    write(page, "load.preload", "1.1 kN")
    write(page, "load.preload", "1.2")
    assert field(page, "load.preload").input_value() == "1.2 kN"
    assert card(page) == stiffness(load__preload=1200.0)[0]


def test_a_unit_is_chosen_and_kept(page):
    document = stiffness()[1]

    def choose(path, unit):
        do(
            page,
            lambda: page.get_by_label(f"{path.split('.')[-1].replace('_', ' ')}, unit").select_option(unit),
        )

    choose("load.preload", "lbf")
    assert field(page, "load.preload").input_value() == "224.8089430997 lbf"  # 1 lbf = 4.4482216152605 N
    choose("drive.ring_wall_thickness", "in")
    assert field(page, "drive.ring_wall_thickness").input_value() == "0.472440944882 in"
    solved = float(card(page))
    assert solved == pytest.approx(document, rel=1e-3)
    found = page.evaluate("fetch(document.getElementById('save-json').href).then((answer) => answer.json())")
    stiff = found["torsional_stiffness"]["assembly"]["output_Nm_per_arcmin"]
    assert stiff == pytest.approx(document, rel=1e-11)
    write(page, "load.preload", "250")
    assert field(page, "load.preload").input_value() == "250 lbf"
    choose("load.preload", "N")
    assert field(page, "load.preload").input_value() == "1112.055403815 N"
    # back where it came from; a tolerance stays as it is written, and a slider writes in the unit of its field
    choose("drive.ring_wall_thickness", "mm")
    assert field(page, "drive.ring_wall_thickness").input_value() == "12 mm"
    write(page, "drive.ring_wall_thickness", "12 mm +- 5 um")
    choose("drive.ring_wall_thickness", "in")
    assert field(page, "drive.ring_wall_thickness").input_value() == "0.472440944882 in +- 5 um"
    slider = page.get_by_label("ring wall thickness, slider")
    slider.focus()
    do(page, lambda: slider.press("ArrowRight"))
    assert field(page, "drive.ring_wall_thickness").input_value().endswith(" in")
    # the zero of degrees Celsius; a unit in another spelling; one of another kind
    script = """async ([text, kind, unit, si]) => {
        const { UnitPicker } = await import("/units.js");
        const { units } = await (await fetch("/api/description")).json();
        return new UnitPicker("x", "x", units[kind], unit).converted(text, si);
    }"""
    for text, kind, unit, si, expected in (
        ("20 degC", "a temperature", "K", None, "293.15 K"),
        ("293.15 K", "a temperature", "degC", None, "20 degC"),
        ("5 N·m", "a torque", "N*mm", None, "5000 N*mm"),
        ("5 N m", "a torque", "N*mm", None, "5000 N*mm"),
        ("5 N-m", "a torque", "N*mm", None, "5000 N*mm"),
        ("5 lbf.in", "a torque", "lbf*in", None, "5 lbf.in"),
        ("3 arc-min", "an angle", "arcsec", None, "180 arcsec"),
        ("8 N-m/arc-min", "a torsional stiffness", "N*m/arcmin", None, "8 N-m/arc-min"),
        ("2 inches", "a length", "mm", 0.0508, "50.8 mm"),
        ("2 inches", "a length", "mm", None, None),
        ("0.2 1/MPa", "a reciprocal pressure", "1/GPa", None, "200 1/GPa"),
        ("-1e-3 rad", "an angle", "mrad", None, "-1 mrad"),
    ):
        assert page.evaluate(script, [text, kind, unit, si]) == expected


def test_two_files_are_compared(page, tmp_path):
    other = tmp_path / "thinner.toml"
    other.write_text(FILE.read_text(encoding="utf-8").replace('"12 mm"', '"10 mm"'), encoding="utf-8")
    page.locator("#compare-file").set_input_files(other)
    page.wait_for_selector("#compared[data-compared='1']", timeout=300_000)
    told = page.locator("#compared").inner_text()
    tables = [block for block in compare(FILE, other).blocks() if isinstance(block, Table)]
    for row in (row for table in tables for row in table.rows):
        assert " ".join(" ".join(row).split()) in " ".join(told.split()), row
    assert "drive.ring_wall_thickness\t12 mm\t10 mm\t-16.7 %" in told
    rows = page.locator("#compared tbody tr").count()
    page.get_by_label("Every result that differs").check()
    assert page.locator("#compared tbody tr").count() > 3 * rows
    # it follows the joint on the page, and says what is wrong with a file
    write(page, "drive.ring_wall_thickness", "10 mm")
    page.wait_for_selector("#compared:has-text('The files say the same.')", timeout=60_000)
    other.write_text("[drive]\n", encoding="utf-8")
    page.locator("#compare-file").set_input_files(other)
    page.wait_for_selector("html[data-refused='thinner.toml']")
    assert "thinner.toml: " in page.locator("#error").inner_text()
    page.locator("#compared").get_by_role("button", name="Close").click()
    assert page.locator("#compared").is_hidden()


def test_the_joint_in_numbers(page):
    document = json.loads(json.dumps(solve_case(read_case(FILE)).document))
    told = page.locator("#numbers").inner_text()
    for name, value, unit in (
        ("interference to be made", 1e6 * document["preload"]["interference_m"], "µm"),
        ("mass, planet", 1e3 * document["standing"]["forces"]["body_mass_kg"]["planet"], "g"),
        ("wedge angle beta", math.degrees(document["geometry"]["wedge_angle_rad"]), "deg"),
    ):
        assert f"{name}\n{format_quantity(value, '1')} {unit}" in told
    assert "force on the pin, left loading roller\nradial 0 N, tangential" in told
    for name, value in (
        ("Mass", document["mass_kg"]),
        ("Diameter", 1e3 * document["envelope_diameter_m"]),
    ):
        assert card(page, name) == format_quantity(value, "1")


def test_what_is_not_known_and_what_is_a_state_are_no_failures(page):
    rows = [["x", verdict] for verdict in ("FAIL", "unknown", "held by the pins", "pass")]
    block = {
        "kind": "table", "title": "t", "head": ["limit", "result"], "rows": rows, "words": [0], "verdicts": True,
        "shares": [],
    }  # fmt: skip
    script = (
        "(block) => import('/blocks.js').then((m) => m.elements([block])"
        ".flatMap((made) => [...made.querySelectorAll('tbody tr')]).map((row) => row.lastChild.textContent))"
    )
    assert page.evaluate(script, block) == ["✗ fail", "? unknown", "held by the pins", "✓ pass"]


def test_the_page_shows_what_the_command_says(page):
    text, exact = stiffness()
    assert card(page) == text
    assert float(card(page)) == pytest.approx(exact, rel=1e-3)
    assert float(card(page, "Drift")) > 0.0
    assert page.title() == "tutorial_joint.toml – asperity"
    assert page.locator("#plots svg[role=img]").count() >= 5
    assert "≤ 1" in page.locator("#margins").inner_text()


def test_a_slider_moves_the_number(page):
    slider = page.get_by_label("preload, slider")
    slider.focus()
    do(page, lambda: slider.press("ArrowRight"))
    written = field(page, "load.preload").input_value()
    assert written != "1000 N"
    value = float(written.removesuffix(" N"))
    assert value > 1000.0
    assert card(page) == stiffness(load__preload=value)[0]


def test_arrows_in_a_field_move_its_slider(page):
    """Up and down by one step; what was typed is taken first."""
    box = field(page, "load.preload")
    box.focus()
    do(page, lambda: box.press("ArrowUp"))
    value = float(box.input_value().removesuffix(" N"))
    assert 1000.0 < value < 1020.0
    assert card(page) == stiffness(load__preload=value)[0]
    do(page, lambda: box.press("ArrowDown"))
    assert float(box.input_value().removesuffix(" N")) == pytest.approx(1000.0, rel=1e-2)
    box.fill("1500 N")
    do(page, lambda: box.press("ArrowUp"))
    assert box.input_value() == "1500 N"
    assert card(page) == stiffness(load__preload=1500.0)[0]


def test_a_value_in_another_unit(page):
    write(page, "drive.ring_wall_thickness", "0.5 in")
    assert card(page) == stiffness(drive__ring_wall_thickness=0.5 * 25.4e-3)[0]
    write(page, "load.output_torque", "6000 N*mm")
    expected = stiffness(drive__ring_wall_thickness=0.5 * 25.4e-3, load__output_torque=6.0)[0]
    assert card(page) == expected


def test_a_wrong_value_is_said_at_its_field(page):
    before = card(page)
    write(page, "load.preload", "1000 mm")
    error = page.locator("#value-load-preload-error")
    assert "expected a force" in error.inner_text()
    assert field(page, "load.preload").get_attribute("aria-invalid") == "true"
    assert "expected a force" in page.locator("#error").inner_text()
    assert card(page) == before  # the last good results stay, greyed
    assert "stale" in page.locator("#answer").get_attribute("class")
    write(page, "load.preload", "1000 N")
    assert error.inner_text() == ""
    assert page.locator("#error").is_hidden()


def test_a_torque_beyond_the_capacity_is_said(page):
    write(page, "load.output_torque", "100 N*m")
    assert "beyond the standing torque capacity" in page.locator("#error").inner_text()


def test_undo_redo_and_back_to_the_file(page):
    start = card(page)
    write(page, "load.preload", "1500 N")
    changed = card(page)
    assert changed != start
    do(page, lambda: page.keyboard.press("Control+z"))
    assert card(page) == start
    do(page, lambda: page.get_by_role("button", name="Redo").click())
    assert card(page) == changed
    do(page, lambda: page.get_by_role("button", name="preload: back to the file's value").click())
    assert card(page) == start


def test_a_link_shows_the_same_joint(page, chromium):
    page.wait_for_function("() => location.hash.startsWith('#joint=')")
    before = page.url
    write(page, "load.preload", "1234 N")
    page.wait_for_function("before => location.href !== before", arg=before)
    other = chromium.new_page()
    other.goto(page.url)
    other.wait_for_selector("html[data-state=ready]", timeout=60_000)
    assert card(other) == card(page) == stiffness(load__preload=1234.0)[0]
    assert field(other, "load.preload").input_value() == "1234 N"
    other.close()


@pytest.mark.long
def test_choices_change_the_joint(page):
    page.locator("details[data-group=model] summary").click()
    do(page, lambda: page.locator("#value-model-closure").select_option("constant_pin_force"))
    do(page, lambda: page.locator("#value-bodies-ring").select_option("Si3N4"))
    text = FILE.read_text(encoding="utf-8").replace('closure = "elastic"', 'closure = "constant_pin_force"')
    text = text.replace('ring = "52100"', 'ring = "Si3N4"')
    assert card(page) == shown(solve_joint(joint_from_case(parse_case(text, source="changed"))))[0]


def test_a_baseline_is_compared(page):
    """Changes beside the figures, those that are better and worse by the direction of each."""

    def change(name):
        said = page.locator(f'#cards [data-change="{name}"]')
        return float(said.inner_text().split(" ")[0].replace("−", "-")), said.get_attribute("class")

    page.get_by_role("button", name="Pin as baseline").click()
    assert page.locator('#cards [data-change="Stiffness"]').inner_text().startswith("±0")
    write(page, "load.preload", "2000 N")
    found, before = (solution(load__preload=preload).result for preload in (2000.0, 1000.0))
    share, look = change("Stiffness")
    values = (float(each.assembly.stiffness.output) for each in (found, before))
    assert share == pytest.approx(100.0 * (next(values) / next(values) - 1.0), rel=5e-3)
    assert "better" in look
    share, look = change("Drift")
    drifts = (float(each.rolling.drift_per_output_turn) for each in (found, before))
    assert share == pytest.approx(100.0 * (next(drifts) / next(drifts) - 1.0), rel=5e-3)
    assert ("better" in look) == (share < 0.0)
    assert page.locator('#cards [data-change="Mass"]').inner_text().startswith("±0")
    assert page.locator("path.ghost").count() >= 2
    page.get_by_role("button", name="Remove baseline").click()
    assert page.locator("#cards [data-change]").count() == 0


def test_the_downloaded_file_solves_to_the_same_number(page, tmp_path):
    write(page, "load.preload", "1.2 kN")
    with page.expect_download() as waiting:
        page.get_by_role("link", name="Save joint file").click()
    file = tmp_path / waiting.value.suggested_filename
    waiting.value.save_as(file)
    assert file.name == "tutorial_joint.toml"
    text = file.read_text(encoding="utf-8")
    assert "1.2 kN" in text
    assert "# The joint of the tutorial" in text
    assert card(page) == shown(solve_joint(joint_from_case(parse_case(text, source=file.name))))[0]
    with page.expect_download() as waiting:
        page.get_by_role("link", name="Save JSON").click()
    waiting.value.save_as(tmp_path / "joint.json")
    document = json.loads((tmp_path / "joint.json").read_text(encoding="utf-8"))
    assert document["input"]["load"]["preload"] == 1200.0


def test_files_are_opened_and_wrong_ones_refused(page, tmp_path):
    before = card(page)
    (tmp_path / "picture.toml").write_bytes(b"\x89PNG\r\n\x1a\n\xff\xfe")
    page.locator("#open-file").set_input_files(tmp_path / "picture.toml")
    page.wait_for_selector("html[data-refused='picture.toml']")
    assert "picture.toml: this is not a text file" in page.locator("#error").inner_text()
    assert card(page) == before
    other = ROOT / "examples" / "zou2025.toml"
    do(page, lambda: page.locator("#open-file").set_input_files(other))
    assert page.locator("#file-name").inner_text() == "zou2025.toml"
    assert card(page) == shown(solve_joint(joint_from_case(read_case(other))))[0] != before
    assert page.locator("#error").is_hidden()


@pytest.mark.long
def test_choices_of_the_library_and_of_the_ring(page):
    do(page, lambda: page.locator("#value-bodies-sun").select_option("440C"))
    assert "stainless bearing steel" in page.locator("#value-bodies-sun-help").text_content()
    do(page, lambda: page.locator("#value-finish").select_option("honed coarsest"))
    coarsest = read_finishes()["honed"].fractal_roughness[1]
    expected = f"{1e3 * coarsest:.6g} mm".replace("e-0", "e-")
    assert field(page, "surface.fractal_roughness").input_value() == expected
    assert page.locator("#value-finish").input_value() == "honed coarsest"
    # a ring in an elastic housing needs the stiffness of the housing: both fields are marked, then it is given
    do(page, lambda: page.locator("#value-drive-ring_support").select_option("elastic_housing"))
    assert field(page, "compliance.ring_housing_stiffness").get_attribute("aria-invalid") == "true"
    write(page, "compliance.ring_housing_stiffness", "20 GPa/m")
    assert page.locator("#error").is_hidden()
    for _ in range(4):
        do(page, lambda: page.get_by_role("button", name="Undo").click())
    assert page.locator("#value-bodies-sun").input_value() == "52100"


def charted(page, action):
    """Do something and wait until the free chart has been drawn."""
    before = int(page.evaluate("document.querySelector('#chart').dataset.drawn || '0'"))
    action()
    page.wait_for_function(
        "before => Number(document.querySelector('#chart').dataset.drawn || 0) > before",
        arg=before,
        timeout=300_000,
    )


def test_a_chart_of_any_number_shows_where_there_is_no_result_and_why(page):
    charted(page, page.locator("#chart summary").click)
    drawn = page.locator("#chart-figure svg[role=img]")
    assert "over preload" in drawn.get_attribute("aria-label")
    charted(page, lambda: page.locator("#chart-over").select_option("load.output_torque"))
    assert drawn.locator("rect.shade").count() >= 1
    assert "beyond the standing torque capacity" in page.locator("#chart-figure").inner_text()
    page.get_by_role("button", name="Pin as baseline").click()
    charted(page, lambda: write(page, "load.preload", "2000 N"))
    assert drawn.locator("path.ghost").count() == 1
    charted(page, lambda: page.locator("#chart-family").select_option("drive.planets"))
    assert drawn.locator("path.curve:not(.ghost)").count() >= 3
    page.locator("#chart-from").fill("3 mm")
    charted(page, lambda: page.locator("#chart-from").press("Enter"))
    assert "expected a torque" in page.locator("#chart-message").inner_text()


@pytest.mark.long
def test_a_surface_is_measured_and_put_into_the_joint(page, chromium, tmp_path):
    heights = np.cumsum(np.random.default_rng(1).normal(size=4096)) * 1e-9
    rows = "".join(f"{2e-7 * i:.9g},{z:.9g}\n" for i, z in enumerate(heights))
    (tmp_path / "profile.csv").write_text("x [m],z [m]\n" + rows)
    page.locator("#open-file").set_input_files(tmp_path / "profile.csv")
    page.wait_for_selector("#use-surface", timeout=300_000)
    said = page.locator("#measured").inner_text()
    assert "fractal dimension D" in said
    assert " to " in said  # the intervals
    assert "Pq, µm, without a filter" in said
    # a profile needs its lay, which is measured with
    assert page.locator("#use-surface").is_disabled()
    page.locator("#surface-lay").select_option("axis")
    page.wait_for_selector("#use-surface:enabled", timeout=300_000)
    # it is of one body, unless it is said to be of both together
    assert page.locator("#surface-measurement_of").input_value() == "body"
    before = card(page)
    do(page, page.locator("#use-surface").click)
    assert page.locator("#error").is_hidden()
    assert card(page) != before
    levels = page.locator("#levels").inner_text()
    laws = page.locator('#levels [data-table="Contact laws side by side"] tbody tr').all_inner_texts()
    assert {row.split()[0]: "used here" in row for row in laws} == {"zou_2025": False, "exponential": True}
    assert "Interval of the contact law, and of the rms of the heights" in levels
    assert "Each body as measured: profile.csv." in page.locator("details[data-group=surface]").inner_text()
    assert field(page, "surface.fractal_dimension").count() == 0
    # the saved file makes the same joint of the saved measurement, the link too
    surfaces = page.locator("details[data-group=surface]")
    for link, name in (
        (page.get_by_role("link", name="Save joint file"), "saved.toml"),
        (surfaces.get_by_role("link", name="Save measurement"), "measured_surface.json"),
    ):
        with page.expect_download() as waiting:
            link.click()
        waiting.value.save_as(tmp_path / name)
    assert waiting.value.suggested_filename == "measured_surface.json"
    saved = read_case(tmp_path / "saved.toml")
    assert card(page) == shown(solve_joint(joint_from_case(saved)))[0]
    measured = card(page)
    do(page, lambda: page.locator("#remove-surface").click())
    assert card(page) == before
    assert field(page, "surface.fractal_dimension").input_value() == "1.5"
    do(page, lambda: page.keyboard.press("Control+z"))
    assert card(page) == measured
    page.wait_for_timeout(500)  # until the address has the joint
    other = chromium.new_page()
    other.goto(page.url)
    other.wait_for_selector("html[data-state=ready]", timeout=60_000)
    assert card(other) == measured
    other.close()
    # a surface without a power law makes a joint too
    rows = "".join(f"{1e-6 * i:.9g},{3e-7 * np.sin(0.1 * i):.9g}\n" for i in range(6000))
    (tmp_path / "sine.csv").write_text("x [m],z [m]\n" + rows)
    page.locator("#open-file").set_input_files(tmp_path / "sine.csv")
    page.wait_for_selector('#measured h2:has-text("sine.csv")', timeout=300_000)
    said = page.locator("#measured").inner_text()
    assert "Ra, µm, behind the cut-off 0.8 mm\t0.19" in said  # 0.6/pi
    assert "No power law" in said
    assert "The joint uses the measured spectrum" in said
    assert page.locator("#use-surface").count() == 1


def test_a_study_shows_its_progress_its_result_and_can_be_stopped(page, tmp_path):
    page.locator("#jobs > summary").click()
    page.locator("#begin-uncertainty").click()
    page.wait_for_selector("#job-message:not(:empty)", timeout=60_000)
    assert "states a tolerance but not its distribution" in page.locator("#job-message").inner_text()
    write(page, "load.preload", "1000 N +- 50 N")
    page.locator("#job-distribution").select_option("uniform")
    page.locator("#begin-uncertainty").click()
    page.locator("#begin-sensitivity").click()
    page.locator(".job[data-kind=sensitivity]").get_by_role("button", name="Stop").click()
    page.wait_for_selector(".job[data-kind=sensitivity][data-state=stopped]", timeout=300_000)
    page.wait_for_selector(".job[data-kind=uncertainty][data-state=done] .job-result a", timeout=300_000)
    assert "2.5 %" in page.locator(".job[data-state=done]").inner_text()
    with page.expect_download() as waiting:
        page.locator(".job[data-state=done]").get_by_role("link", name="Save JSON").click()
    waiting.value.save_as(tmp_path / "found.json")
    document = json.loads((tmp_path / "found.json").read_text(encoding="utf-8"))
    assert document["inputs"]["load.preload"]["tolerance"] == 50.0


@pytest.mark.long
def test_the_window_is_a_picture_with_its_words(page):
    page.locator("#jobs > summary").click()
    page.locator("#begin-window").click()
    page.wait_for_selector(".job[data-kind=window][data-state=done] .job-result img", timeout=300_000)
    picture = page.locator(".job[data-kind=window] img")
    assert picture.get_attribute("alt") == "Torques that the joint may pass"
    assert picture.evaluate("image => image.complete && image.naturalWidth > 300")
    said = page.locator(".job[data-kind=window]").inner_text()
    assert "lies inside the window at 1000 N of preload" in said
    assert "Which limit governs where" in said


@pytest.mark.long
def test_a_report_is_saved_as_html_and_pdf(page, tmp_path):
    for name, ending, begins in (("Save report", "html", b"<!doctype html"), ("Save PDF", "pdf", b"%PDF-")):
        with page.expect_download(timeout=300_000) as waiting:
            page.get_by_role("button", name=name).click()
        assert waiting.value.suggested_filename == f"tutorial_joint.{ending}"
        waiting.value.save_as(tmp_path / f"report.{ending}")
        assert (tmp_path / f"report.{ending}").read_bytes().lower().startswith(begins.lower())


def test_every_control_has_a_name_and_the_page_fits_400_px(page):
    unnamed = page.evaluate(
        """[...document.querySelectorAll("input, select, button, a")].filter((each) => !(each.labels?.length
            || each.getAttribute("aria-label") || each.textContent.trim())).map((each) => each.outerHTML)"""
    )
    assert unnamed == []
    # a narrow field cuts off what holds while it is empty; its title has the whole of it
    bore = field(page, "drive.planet_bore_diameter")
    assert (bore.get_attribute("title"), bore.get_attribute("placeholder")) == ("solid if absent", "solid")
    ids = page.evaluate("[...document.querySelectorAll('[id]')].map((each) => each.id)")
    assert len(ids) == len(set(ids))
    page.set_viewport_size({"width": 400, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 400


def test_the_policy_holds_in_the_browser(chromium, served):
    page = chromium.new_page()  # not the fixture, which takes the browser's report for an error
    page.goto(served.address)
    found = page.evaluate(
        """async () => {
            const script = document.createElement("script");
            script.textContent = "window.injected = 1";
            document.body.append(script);
            try { await fetch("http://127.0.0.1:9/"); } catch { return [window.injected ?? null, "blocked"]; }
        }"""
    )
    assert found == [None, "blocked"]
    page.close()


def test_a_server_that_stops_is_said_and_nothing_is_lost(chromium, serve):
    own = serve(FILE)
    page = chromium.new_page()
    page.goto(own.address)
    page.wait_for_selector("html[data-state=ready]", timeout=300_000)
    assert own.stop() == 0
    field(page, "load.preload").fill("1300 N")
    field(page, "load.preload").press("Enter")
    page.wait_for_selector("html[data-state=lost]", timeout=60_000)
    assert "The server does not answer" in page.locator("#banner").inner_text()
    assert field(page, "load.preload").input_value() == "1300 N"
    page.close()

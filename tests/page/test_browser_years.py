"""Wear and accuracy of a joint on the page, in a real browser: figures, curves, tables, and a baseline behind them."""

from pathlib import Path

import pytest
from browser import do, field, write

import asperity

pytestmark = pytest.mark.slow

WORN = Path(__file__).parents[2] / "examples" / "wear.toml"


#: Form errors of which three waves of the ring reach the carrier, and two do not: its planets are three.
FORM = """
[[form]]
part = "ring"
harmonics = { 2 = "1 um", 3 = "0.5 um" }

[[form]]
part = "planet"
harmonics = { 2 = "0.3 um" }
"""


@pytest.fixture(scope="module")
def served(served_text):
    """Takes the place of the server of the tutorial's joint."""
    return served_text(WORN.read_text(encoding="utf-8") + FORM)


def begun(page, kind, count):
    """Run a study; how many of this kind then stand on the page."""
    page.locator(f"#begin-{kind}").click()
    done = f".job[data-kind={kind}][data-state=done]:has(.job-result a)"
    page.wait_for_function(
        "([which, count]) => document.querySelectorAll(which).length === count",
        arg=[done, count],
        timeout=120_000,
    )
    return page.locator(done).first


def test_wear_has_its_hours_first_and_the_baseline_behind_its_curves(page):
    page.locator("#jobs > summary").click()
    job = begun(page, "wear", 1)
    first = job.locator(".job-result tbody tr").first
    hours = asperity.wear(asperity.load(WORN)).document["wear"]["first_slide_hours"]
    assert first.inner_text().split() == ["first", "contact", "slides", f"{hours:.0f}", "h", "sp", "slides"]
    titles = job.locator(".plots figcaption").all_inner_texts()
    assert titles == ["Preload", "Interference", "Torque of the first slide", "Drift"]
    assert job.locator(".plots .capacity").count() == 2 * len(titles)  # the required life, with its legend
    assert job.locator(".ghost").count() == 0
    page.locator("#pin").click()
    page.locator("#controls details[data-group=wear] > summary").click()
    write(page, "wear.coefficient", "2e-17 1/Pa")
    job = begun(page, "wear", 2)
    assert f"{hours / 2.0:.0f} h" in job.locator(".job-result tbody tr").first.inner_text()
    assert job.locator(".plots path.ghost:not(.sample path)").count() == len(titles)
    assert "The required life of 10000 h lies beyond." in job.inner_text()


def test_form_errors_are_added_changed_and_taken_away(page):
    group = page.locator("#controls details[data-group=form]")
    group.locator("summary").click()
    assert [field(page, f"form.{n}.part").input_value() for n in (1, 2)] == ["ring", "planet"]
    do(page, lambda: group.get_by_role("button", name="Add form errors of a part").click())
    assert field(page, "form.3.part").input_value() == "sun"  # the first that had none
    do(page, lambda: field(page, "form.3.part").select_option("left_loading_roller"))
    write(page, "form.3.harmonics.3", "0.2 um")
    do(page, lambda: group.get_by_role("button", name="Remove part 1").click())
    assert [field(page, f"form.{n}.part").input_value() for n in (1, 2)] == ["planet", "left_loading_roller"]
    assert [field(page, f"form.2.harmonics.{n}").input_value() for n in (2, 3)] == ["1 um", "0.2 um"]
    assert page.locator("#error").is_hidden()
    do(page, lambda: group.get_by_role("button", name="form: back to the file").click())
    assert field(page, "form.1.part").input_value() == "ring"
    assert group.locator("fieldset").count() == 2


def test_the_accuracy_has_a_line_for_every_order_and_both_directions(page):
    page.locator("#jobs > summary").click()
    page.locator("#job-reverse").check()
    job = begun(page, "accuracy", 1)
    assert job.locator(".job-result tbody tr").first.inner_text().startswith("transmission error")
    stems = job.locator(".plots .dot title")
    assert [text.split(":")[0] for text in stems.all_text_contents()] == ["ring, 3 waves", "planet, 2 waves"]
    assert "order 3," in stems.first.text_content()
    assert job.locator(".plots figure").count() == 4
    assert "difference at the same position" in job.inner_text()
    assert (
        job.locator('.plots svg[role="img"]')
        .nth(1)
        .get_attribute("aria-label")
        .startswith("Transmission error")
    )

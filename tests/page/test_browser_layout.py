"""What is seen of the page at three widths, for every kind of drive: nothing is cut, and the decision stays in view."""

from pathlib import Path

import pytest
from browser import do, write

pytestmark = pytest.mark.slow

EXAMPLES = Path(__file__).parents[2] / "examples"
WIDTHS = (1400, 1024)
NARROW = {"width": 390, "height": 844}
FIGURES = ("Stiffness", "Drift", "Torque capacity", "Life", "Efficiency", "Mass", "Diameter")
#: Height of the page on a narrow screen as it opens [px].
TALLEST = 5000

#: Elements that are wider than their place, or reach beyond the page, and do not say so by scrolling.
CUT = """() => {
  const width = document.documentElement.clientWidth;
  const unseen = "#status, thead, .long, .visually-hidden, .hidden-input, select, .unit-list, label[for=theme]";
  const all = document.querySelectorAll("header *, #headline, #headline *, #results *, #controls *");
  const found = [...all].filter((each) => {
    if (!(each instanceof HTMLElement) || each.closest(unseen) || !each.checkVisibility()) return false;
    const box = each.getBoundingClientRect();
    const inner = getComputedStyle(each).display !== "inline" && each.clientWidth > 0;
    const beyond = box.width > 0 && (box.right > width + 1 || box.left < -1);
    return beyond || (inner && each.scrollWidth > each.clientWidth + 1);
  }).map((each) => `${each.tagName}.${each.className} ${each.textContent.slice(0, 40)}`);
  return document.documentElement.scrollWidth > width ? ["the page itself", ...found] : found;
}"""
#: Tables whose last columns are beyond their panel, as seen by their cells.
HIDDEN_CELLS = """() => [...document.querySelectorAll("#answer .panel td")].filter((cell) => {
  const panel = cell.closest(".panel").getBoundingClientRect();
  const box = cell.getBoundingClientRect();
  return box.width > 0 && (box.right > panel.right + 1 || box.left < panel.left - 1);
}).map((cell) => cell.textContent)"""


def _open_all(page):
    page.evaluate("document.querySelectorAll('#answer details').forEach((each) => { each.open = true; })")
    page.wait_for_timeout(50)  # until what opens has filled itself


def _nothing_is_cut(page):
    assert page.evaluate(CUT) == []
    assert page.evaluate(HIDDEN_CELLS) == []


def _stays_in_view(page, height):
    """The headline at the top of the screen, with all figures in it."""
    page.evaluate("window.scrollTo(0, document.documentElement.scrollHeight / 2)")
    bar = page.locator("#headline").bounding_box()
    assert bar["y"] == 0
    for name in FIGURES:
        box = page.locator(f'#headline [data-value="{name}"]').bounding_box()
        assert 0 <= box["y"] <= bar["height"] - box["height"], name
    assert page.locator("#verdict strong").is_visible()
    assert bar["height"] < height


@pytest.mark.parametrize(
    "name",
    [
        "zou2025",
        *(
            pytest.param(each, marks=pytest.mark.long)
            for each in ("planetary", "multiroller", "stepped_planet", "planar", "wheel_pair")
        ),
    ],
)
def test_nothing_is_cut_and_the_decision_stays_in_view(serve, chromium, name):
    page = chromium.new_page(viewport={"width": WIDTHS[0], "height": 900})
    server = serve(EXAMPLES / f"{name}.toml")
    page.goto(server.address)
    page.wait_for_selector("html[data-state=ready]", timeout=300_000)
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        _open_all(page)
        _nothing_is_cut(page)
        _stays_in_view(page, 0.2 * 900)
    page.set_viewport_size(NARROW)
    page.reload()
    page.wait_for_selector("html[data-state=ready]", timeout=300_000)
    assert page.evaluate("document.documentElement.scrollHeight") <= TALLEST
    verdicts = page.locator("#margins tbody tr").count()
    assert (
        page.locator("#margins .pass:visible, #margins .fail:visible, #margins .outside:visible").count()
        > 0.5 * verdicts
    )
    _nothing_is_cut(page)
    _stays_in_view(page, 0.2 * NARROW["height"])
    _open_all(page)
    _nothing_is_cut(page)
    page.close()
    server.stop()


def test_figures_are_known_before_everything_else(page):
    """They stand in the headline while capacity, verdict and panels wait for the whole answer."""
    page.evaluate(
        """() => {
          window.seen = [];
          const seen = new MutationObserver(() => window.seen.push([
            document.querySelector('[data-value="Stiffness"]').textContent,
            document.querySelector('[data-cell="Torque capacity"]').classList.contains("waits"),
          ]));
          seen.observe(document.documentElement, { attributeFilter: ["data-figures", "data-revision"] });
        }"""
    )
    write(page, "load.preload", "1300 N")
    (early, waited), *_, (whole, waits) = page.evaluate("window.seen")
    assert early == whole
    assert (waited, waits) == (True, False)


def test_forces_are_switched_off_and_stay_so(page):
    names = page.locator("#drawing .force-name")
    assert names.first.is_visible()
    page.get_by_label("Forces", exact=True).uncheck()
    assert not names.first.is_visible()
    page.reload()
    page.wait_for_selector("html[data-state=ready]", timeout=300_000)
    assert not page.locator("#drawing .force-name").first.is_visible()
    page.get_by_label("Forces", exact=True).check()


def test_an_error_is_said_where_it_is_always_seen(page):
    before = page.locator("#cards").inner_text()
    do(page, lambda: (page.locator("#value-load-preload").fill("1 mm"), page.keyboard.press("Enter")))
    assert page.locator("#verdict").inner_text().startswith("✗ No result See the message")
    assert page.locator("#cards").inner_text() == before
    write(page, "load.preload", "1000 N")
    assert "Works" in page.locator("#verdict").inner_text()


def test_the_stiffness_is_drawn_over_the_torques_that_the_joint_bears(page):
    """From zero on a linear axis: the ticks are multiples of one step."""
    plot = page.locator("#plots figure", has_text="Stiffness over torque")
    ticks = [float(each.text_content()) for each in plot.locator('.tick[text-anchor="end"]').all()]
    assert ticks[0] == 0.0
    assert ticks == pytest.approx([n * ticks[1] for n in range(len(ticks))])
    stiffness = float(page.locator('[data-value="Stiffness"]').inner_text())
    assert stiffness < ticks[-1] + ticks[1] < 5.0 * stiffness

"""The page examined by axe-core, if it is installed: NODE_PATH or AXE_CORE names the folder of axe.min.js.

Install it anywhere with ``npm install axe-core`` and run with ``AXE_CORE=…/node_modules/axe-core``.
"""

import os
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def axe():
    places = [os.environ.get("AXE_CORE", "")]
    places += [
        str(Path(each, "axe-core")) for each in os.environ.get("NODE_PATH", "").split(os.pathsep) if each
    ]
    files = [Path(place, "axe.min.js") for place in places if place]
    found = next(filter(Path.is_file, files), None)
    if found is None:
        pytest.skip("axe-core is not installed: npm install axe-core, and name its folder in AXE_CORE")
    return found.read_text(encoding="utf-8")


def test_no_rule_is_broken(page, axe):
    for panel in ("#chart", "#jobs"):
        page.locator(f"{panel} > summary").click()
    page.locator("#compose > summary").click()
    page.locator("#add-limit").click()
    page.locator("#compare-file").set_input_files(ROOT / "examples" / "zou2025.toml")
    page.wait_for_selector("#compared[data-compared]", timeout=300_000)
    page.wait_for_selector("#chart[data-drawn]", timeout=300_000)
    page.evaluate("document.querySelectorAll('#controls details').forEach((each) => { each.open = true; })")
    page.evaluate(axe)
    assert violations(page) == {}
    page.locator("#chart > summary").click()
    page.get_by_role("button", name="Add a load").click()
    page.wait_for_selector("#value-duty-1-share")
    page.get_by_role("button", name="Give each branch its own sizes").click()
    # they need an interference, which the page says after its answer with the load; the results are greyed
    page.wait_for_selector("html[data-state=error]", timeout=300_000)
    assert violations(page, "'#controls'") == {}


def violations(page, part="document"):
    """Of a narrow and a wide page in both themes, where there are any."""
    found = {}
    for width in (400, 1400):
        page.set_viewport_size({"width": width, "height": 900})
        page.evaluate("document.getElementById('tools').open = true")  # a menu on a narrow screen
        for theme in ("light", "dark"):
            page.locator("#theme").select_option(theme)
            for each in page.evaluate(f"async () => (await axe.run({part})).violations"):
                found.setdefault((width, theme), []).append(
                    (each["id"], each["help"], each["nodes"][0]["html"])
                )
    return found

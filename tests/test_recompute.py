"""Pages show what their commands print now, and what is stale is found and mended."""

import importlib.util
import sys
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[1] / "docs"


def _module():
    spec = importlib.util.spec_from_file_location("recompute", DOCS / "recompute.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["recompute"] = module
    spec.loader.exec_module(module)
    return module


recompute = _module()
#: Pages whose commands take a few seconds; those of the others take more.
QUICK = {"README.md", "questions.md"}


@pytest.mark.parametrize(
    "page",
    [
        pytest.param(page, id=page.name, marks=[] if page.name in QUICK else [pytest.mark.slow])
        for page in recompute.pages()
    ],
)
def test_a_page_shows_what_its_commands_print(page):
    _, differences = recompute.recomputed(page.read_text(encoding="utf-8"))
    assert differences == [], f"run `python docs/recompute.py {page.relative_to(DOCS.parent)}`"


MASS = "mass_kg"  # of the rolling parts: π ρ Σ r² L of the sun, three planets and the ring
STALE = f"""# A page

It weighs 0.91 kg, or 905 g.

<!-- numbers: asperity joint examples/planetary.toml --json
0.91 kg = {MASS}
905 g = {MASS} in g
-->

<!-- output: asperity joint examples/planetary.toml | from "Works" until "Stiffness" -->
```text
Fails: everything.
```

# Another section

0.91 kg of another thing.
"""


def planetary_mass():
    """Sun of 10 mm, three planets of 20 mm, ring of 50 mm with a wall of 8 mm, all 10 mm long, of 7833 kg/m³ [kg]."""
    areas = 0.010**2 + 3 * 0.020**2 + (0.058**2 - 0.050**2)
    return 3.141592653589793 * areas * 0.010 * 7833.0


def test_stale_numbers_and_output_are_replaced_in_their_section_alone():
    page, differences = recompute.recomputed(STALE)
    mass = planetary_mass()
    assert len(differences) == 3
    assert f"It weighs {mass:.2f} kg, or {1e3 * mass:.0f} g." in page
    assert f"\n{mass:.2f} kg = {MASS}\n{1e3 * mass:.0f} g = {MASS} in g\n" in page
    assert "0.91 kg of another thing." in page
    assert "```text\nWorks: every requirement of function and strength is met." in page
    assert "Fails" not in page
    assert recompute.recomputed(page) == (page, [])


@pytest.mark.parametrize(
    ("one", "other", "alike"),
    [
        ("life 1.551e7 h", "life 1.552e7 h", True),  # the last digit
        ("life 1.551e7 h", "life 1.553e7 h", False),
        ("1500 MPa", "1501 MPa", True),
        ("1500 MPa", "1502 MPa", False),
        ("residual 9.3e-16", "residual 6.1e-17", True),  # what rounding leaves
        ("3 of 4 starts", "4 of 4 starts and more", False),
        ("sp slips", "pr slips", False),
    ],
)
def test_texts_are_alike_up_to_the_last_digit(one, other, alike):
    assert recompute._alike(one, other) is alike


def test_numbers_keep_their_digits_and_groups():
    assert recompute._as_written("16 200", 15_949.0) == "15 900"
    assert recompute._as_written("0.0690", 0.06805) == "0.0680"
    assert recompute._as_written("2.6e7", 2.7401e7) == "2.7e7"


def test_numbers_of_a_document():
    document = {
        "rows": [{"name": "a", "value": 2.0}, {"name": "b", "value": 8e-3}],
        "all": {"x": 3.0, "y": 5.0},
    }
    assert recompute._computed(document, "rows/name:b/value in mm") == pytest.approx(8.0)
    assert recompute._computed(document, "max all/*") == 5.0
    assert recompute._computed(document, "all/y over rows/0/value") == 2.5
    assert recompute._computed(document, "all/x in 1e3") == pytest.approx(3e-3)


def test_what_does_not_stand_there_is_an_error():
    numbers = "<!-- numbers: asperity joint examples/planetary.toml --json\n0.5 kg = mass_kg\n-->\n"
    with pytest.raises(ValueError, match=r"'0\.5 kg' does not stand in the section"):
        recompute.recomputed(f"# A page\n\nNothing.\n\n{numbers}")
    with pytest.raises(ValueError, match="no text block follows"):
        recompute.recomputed("<!-- output: asperity joint examples/planetary.toml -->\n\nNothing.\n")

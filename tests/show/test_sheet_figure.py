"""A sheet as a figure: true to scale on paper, black on white, the same file every time."""

import pytest
from matplotlib.patches import Circle as Patch

from asperity.show.sheet import Circle, Line, Sheet, Text
from asperity.show.sheet_figure import arrowheads, sheet_figure
from asperity.writing import write_image

SHEET = Sheet(
    100.0, 50.0, 2.0, (50.0, 25.0),
    (Circle((0.0, 0.0), 5.0), Line(((-5.0, 0.0), (5.0, 0.0)), arrows="both"), Text((0.0, 1.0), "a $b$ <c>")),
)  # fmt: skip


def test_a_circle_of_5_mm_is_10_mm_on_paper_at_2_to_1():
    figure = sheet_figure(SHEET)
    assert figure.get_size_inches() * 25.4 == pytest.approx([100.0, 50.0])
    (axes,) = figure.axes
    (circle,) = [patch for patch in axes.patches if isinstance(patch, Patch)]
    across = axes.transData.transform([(-circle.radius, 0.0), (circle.radius, 0.0)])
    assert (across[1, 0] - across[0, 0]) / figure.dpi * 25.4 == pytest.approx(20.0)
    assert circle.get_linewidth() == pytest.approx(0.5 / 25.4 * 72.0)
    assert axes.texts[0].get_text() == "a $b$ <c>"
    colours = {circle.get_edgecolor(), axes.lines[0].get_color(), axes.texts[0].get_color()}
    assert colours == {(0.0, 0.0, 0.0, 1.0), "black"}


def test_arrowheads_point_outwards_at_both_ends():
    first, last = arrowheads(SHEET.items[1], length=2.0)
    assert (first[0], last[0]) == ((-5.0, 0.0), (5.0, 0.0))
    assert {corner[0] for corner in first[1:]} == {-3.0}
    assert {corner[0] for corner in last[1:]} == {3.0}
    assert arrowheads(Line(((0.0, 0.0), (0.0, 0.0)), arrows="end"), length=1.0) == []


def test_heads_are_a_third_as_wide_as_long_of_forces_two_thirds():
    """On a line at an angle of 3, 4, 5, which starts at (1, 2)."""
    for style, half in (("thin", 5.0 / 6.0), ("force", 5.0 / 3.0)):
        ((tip, one, other),) = arrowheads(Line(((1.0, 2.0), (7.0, 10.0)), style, "start"), length=5.0)
        assert tip == (1.0, 2.0)
        assert one == pytest.approx((4.0 - 0.8 * half, 6.0 + 0.6 * half))
        assert other == pytest.approx((4.0 + 0.8 * half, 6.0 - 0.6 * half))


def test_capital_letters_have_their_height():
    """2.5 mm of capitals, which are 0.729 of the size of DejaVu Sans."""
    (axes,) = sheet_figure(SHEET).axes
    assert axes.texts[0].get_fontsize() == pytest.approx(2.5 / 0.729 / 25.4 * 72.0)


@pytest.mark.parametrize("suffix", ["svg", "pdf", "png"])
def test_the_same_sheet_makes_the_same_file(tmp_path, suffix):
    for name in "ab":
        write_image(sheet_figure(SHEET), tmp_path / f"{name}.{suffix}")
    a, b = ((tmp_path / f"{name}.{suffix}").read_bytes() for name in "ab")
    assert a == b
    assert b"dc:date" not in a
    assert b"CreationDate" not in a

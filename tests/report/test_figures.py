"""Pictures as SVG: the same text for the same figure."""

import xml.etree.ElementTree as ElementTree

from matplotlib.figure import Figure

from asperity.report.figures import figure_svg


def drawn(height):
    figure = Figure(figsize=(7.0, 3.5))
    figure.subplots().plot([0.0, 1.0], [0.0, height])
    return figure_svg(figure)


def test_one_figure_is_one_text():
    one = drawn(1.0)
    assert one == drawn(1.0)
    assert one != drawn(2.0)
    assert "dc:date" not in one


def test_it_has_its_size():
    """Seven inches by three and a half, at 72 points an inch."""
    root = ElementTree.fromstring(drawn(1.0))
    assert (root.get("width"), root.get("height")) == ("504pt", "252pt")

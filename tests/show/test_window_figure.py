"""The window as a picture: the region, the loads, and words that cover nothing."""

import itertools
from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.joint_file.window import joint_window
from asperity.show.window_figure import window_figure

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module", params=["wheel_pair", pytest.param("zou2025", marks=pytest.mark.slow)])
def drawn(request):
    joint = asperity.load(EXAMPLES / f"{request.param}.toml")
    window = joint_window(joint.case, start=150.0, stop=1500.0, points=4)
    return window, window_figure(window, title="a joint")


def words(figure):
    (axes,) = figure.axes
    return [text for text in (*figure.texts, *axes.texts) if text.get_text()]


def test_title_and_verdict(drawn):
    window, figure = drawn
    said = [text.get_text() for text in figure.texts]
    assert said[0] == "a joint"
    inside = bool(window.loads[0].inside[window.working])
    assert (
        said[-1]
        == f"The output torque of the file lies {'in' if inside else 'out'}side the window at 1000 N of preload"
    )


def test_the_border_is_the_capacity(drawn):
    window, figure = drawn
    (axes,) = figure.axes
    (thick,) = [line for line in axes.lines if line.get_linewidth() == 2.0 and len(line.get_xdata()) > 1]
    assert np.array_equal(thick.get_xdata(), window.at)
    assert np.array_equal(thick.get_ydata(), window.regions[0].capacity.torque)


def test_no_words_cover_other_words_or_lie_outside(drawn):
    _, figure = drawn
    renderer = figure.canvas.get_renderer()
    boxes = [text.get_window_extent(renderer) for text in words(figure)]
    assert len(boxes) >= 5
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))
    sheet = figure.bbox
    assert all(box.x0 >= sheet.x0 and box.x1 <= sheet.x1 and box.y1 <= sheet.y1 for box in boxes)


def test_the_load_is_at_its_torque_where_the_joint_works(drawn):
    window, figure = drawn
    (axes,) = figure.axes
    points = [line for line in axes.lines if line.get_marker() in ("o", "X", "s")]
    ((x, y),) = [(line.get_xdata()[0], line.get_ydata()[0]) for line in points]
    assert (x, y) == (1000.0, window.loads[0].load.torque)

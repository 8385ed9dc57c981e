"""Words in a panel stand where they cover nothing, or nowhere."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from asperity.show.placed_words import PlacedWords


@pytest.fixture
def words():
    figure = Figure(figsize=(4.0, 4.0))
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    return PlacedWords(axes)


CENTRED = {"xytext": (0, 0), "ha": "center", "va": "center"}


def test_the_first_free_place_is_taken(words):
    words.keep_free(np.array([0.0, 1.0]), np.array([0.5, 0.5]))  # a line across the panel
    assert words.place("above", [(0.5, 0.5, CENTRED), (0.5, 0.8, CENTRED)])
    assert [text.xy for text in words.axes.texts] == [(0.5, 0.8)]
    assert words.place("again", [(0.5, 0.8, CENTRED), (0.5, 0.2, CENTRED)])
    assert words.axes.texts[-1].xy == (0.5, 0.2)


def test_words_without_a_place_are_left_out(words):
    words.keep_free(np.array([0.5]), np.array([0.5]))
    assert not words.place("on a point", [(0.5, 0.5, CENTRED)])
    assert not words.place("beyond the panel", [(0.0, 0.5, CENTRED)])
    assert not words.axes.texts


def test_a_line_that_is_released_may_be_covered(words):
    line = words.keep_free(np.array([0.0, 1.0]), np.array([0.5, 0.5]))
    assert not words.place("on the line", [(0.5, 0.5, CENTRED)])
    words.release(line)
    assert words.place("on the line", [(0.5, 0.5, CENTRED)])

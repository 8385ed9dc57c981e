"""Rolling contacts by boundary elements: onset and strokes."""

import numpy as np
import pytest


@pytest.fixture
def example(load_example, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    return load_example("rolling_contact")


def test_rolling_starts_at_half_the_steady_creepage(example, tmp_path):
    histories = example.onset(example.LineContact(100), 2.0)
    for distance, shift in histories.values():
        assert (shift[1] - shift[0]) / (distance[1] - distance[0]) == pytest.approx(0.5, abs=0.01)
    with example.rc_context(example.STYLE):
        figure = example.Figure()
        panels = figure.subplots(1, 3)
        example.draw_onset(panels[0], histories)
        example.draw_lag(panels[1], histories)
        example.draw_layer(panels[2])
        figure.savefig(tmp_path / "picture.png")
    onset, lag, layer = panels
    assert [text.get_text() for text in onset.get_legend().get_texts()] == [
        f"$q$ = {q}" for q in (0.25, 0.5, 0.8)
    ]
    for line, (distance, shift) in zip(onset.lines, histories.values(), strict=True):
        creepage = np.diff(shift) / np.diff(distance)
        np.testing.assert_allclose(line.get_ydata()[: creepage.size], creepage, rtol=1e-9)
    table = lag.lines[-1]
    assert table.get_label() == "table $\\varphi$"
    assert table.get_ydata()[0] == 0.0
    for line in layer.lines[0:6:2]:  # the factor of a uniform layer over its limit of small slip
        assert line.get_ydata()[0] == pytest.approx(1.0, abs=0.02)
    assert [text.get_text() for text in layer.get_legend().get_texts()] == [
        f"$\\chi$ = {chi}" for chi in (0.1, 0.3, 1.0)
    ]


def test_short_strokes_do_not_drift(example):
    contact = example.LineContact(100)
    assert abs(example.drift(contact, 0.5, 30)) < 1e-3
    assert example.drift(contact, 0.5, 100) == pytest.approx(0.71, abs=0.02)

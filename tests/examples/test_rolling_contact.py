"""Rolling contacts by boundary elements: onset and strokes."""

import pytest


@pytest.fixture
def example(load_example, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    return load_example("rolling_contact")


@pytest.mark.slow
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
    assert (tmp_path / "picture.png").stat().st_size > 10_000


@pytest.mark.slow
def test_short_strokes_do_not_drift(example):
    contact = example.LineContact(100)
    assert abs(example.drift(contact, 0.5, 30)) < 1e-3
    assert example.drift(contact, 0.5, 100) == pytest.approx(0.71, abs=0.02)

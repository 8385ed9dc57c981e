"""Creep of contacts with oil: the closed form against boundary elements on some of the random contacts."""

import pytest


@pytest.fixture
def example(load_example, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    return load_example("film_rolling")


@pytest.mark.parametrize(("layers", "seed"), [(False, 11), (True, 12)])
def test_the_closed_form_is_that_of_strips(example, layers, seed):
    """Of 600 of each 96 % are within 7 %, with a root mean square of 3 %, and none is off by more than a quarter."""
    found = example.summary(example.compared(600, layers=layers, seed=seed, strips=80, every=15))
    assert found["root mean square"] < 0.04
    assert found["share within 7 %"] > 0.95
    assert found["smallest ratio"] > 0.85
    assert found["largest ratio"] < 1.25


def test_the_picture_is_drawn(example, tmp_path, capsys):
    rows = example.compared(8, layers=True, seed=1, strips=40)
    example.print_regimes(rows)
    assert "elastic_factor" in capsys.readouterr().out
    with example.rc_context(example.STYLE):
        figure = example.Figure()
        panels = figure.subplots(1, 2)
        example.draw_curves(panels[0], strips=40)
        example.draw_ratios(panels[1], {"a": rows, "b": rows})
        figure.savefig(tmp_path / "picture.png")
    assert (tmp_path / "picture.png").stat().st_size > 10_000

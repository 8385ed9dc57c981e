"""The tornado of the paper's joint."""

import pytest


def test_capacity_is_proportional_to_the_planets(load_example, monkeypatch, tmp_path, saved_figures):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    assert load_example("sensitivity_tornado").main(tmp_path / "t.png") == pytest.approx(1.0, abs=1e-9)
    (figure,) = saved_figures
    assembled, published, capacity = figure.axes
    for panel, name, value in (  # the levels that the README prints
        (assembled, "assembly stiffness output", 3.06e4),
        (published, "published stiffness output", 4.34e6),
    ):
        title, number = panel.get_title().split("\n")
        assert title == name
        assert float(number.split()[0]) == pytest.approx(value, rel=5e-3)
    # 13.2 N·m: the capacity of the paper's joint by bisection (asperity windup)
    assert capacity.get_title().startswith("torque capacity\n13.1")
    assert {panel.get_xlabel() for panel in figure.axes} == {"% of result per % of input [-]"}
    bars = dict(zip((t.get_text() for t in capacity.get_yticklabels()), capacity.patches, strict=True))
    (planets,) = (bar for name, bar in bars.items() if "planets" in name and "radius" not in name)
    assert planets.get_width() == pytest.approx(1.0, abs=1e-9)
    for panel in figure.axes:  # the most influential at the top
        widths = [abs(bar.get_width()) for bar in panel.patches]
        assert widths in (sorted(widths), sorted(widths, reverse=True))

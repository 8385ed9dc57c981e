"""The wind-up of the paper's joint."""

import math

import pytest


def test_windup_lies_between_the_springs_at_both_ends(load_example, monkeypatch, tmp_path, saved_figures):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    curve = load_example("windup_loop").main(str(tmp_path / "loop.png"))
    softest, stiffest = float(curve.stiffness[-1]), float(curve.stiffness[curve.stiffness.size // 2])
    assert 12.0 / stiffest < float(curve.angle[-1]) < 12.0 / softest
    # 8.986 N·m/arcmin at rest by benchmarks/baseline_assembly.py; the speed of 6000 rpm changes it by 2e-4
    assert stiffest * math.pi / 10800.0 == pytest.approx(8.986, rel=2e-3)
    loop, stiffness, *_ = saved_figures[0].axes
    assert (loop.get_xlabel(), loop.get_ylabel()) == (
        "angle at the output [arcmin]",
        "torque at the output [N·m]",
    )
    lines = {line.get_label(): line for line in loop.lines}
    assert [text.get_text() for text in loop.get_legend().get_texts()] == list(lines)[:3]
    first = lines["first loading, either direction"]
    arcmin = math.pi / 10800.0
    assert first.get_xdata()[-1] * arcmin == pytest.approx(float(curve.angle[-1]), rel=1e-12)
    assert first.get_ydata()[-1] == pytest.approx(12.0, rel=1e-12)
    # the loop is closed at both ends
    for branch in ("unloading", "reloading"):
        assert sorted(lines[branch].get_ydata()[[0, -1]]) == pytest.approx([-12.0, 12.0])
    assert stiffness.get_ylabel() == "stiffness at the output [N·m/arcmin]"
    drawn = stiffness.lines[0].get_ydata()
    assert drawn.max() == pytest.approx(stiffest * arcmin, rel=1e-9)

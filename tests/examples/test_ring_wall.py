"""The stiffness over the wall of the ring."""

import numpy as np
import pytest


@pytest.mark.slow
def test_a_housing_lies_between_free_and_held(load_example, tmp_path, monkeypatch, saved_figures):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    springs, held, housing, free = load_example("ring_wall").main(tmp_path / "wall.png").values()
    assert np.all(housing < held)
    assert np.all(free[:30] < housing[:30])
    assert np.all(
        np.abs(springs / held - 1.0) < 0.025
    )  # today's springs are those of a ring in a rigid housing
    (panel,) = saved_figures[0].axes
    assert panel.get_ylabel() == "stiffness at the output [kN·m/rad]"
    assert "wall of the ring [mm]" in panel.get_xlabel()
    names = ("springs", "held", "housing", "free")
    for line, name, values in zip(panel.lines, names, (springs, held, housing, free), strict=True):
        assert name in line.get_label()
        np.testing.assert_allclose(line.get_ydata(), 1e-3 * values)

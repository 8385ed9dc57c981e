"""The batches take every number to its place."""

import numpy as np
import pytest

from asperity.zou2025.curves import OUTPUT_TORQUES, Curves


def test_ranges_are_those_of_table_1(curves: Curves) -> None:
    ends = {case: tuple(curve.values[[0, -1]]) for case, curve in curves.pairs.items()}
    assert ends["a"] == (0.0, 1000.0)
    assert ends["c"] == pytest.approx((1.3, 1.95))
    assert ends["d"] == pytest.approx((1e-13, 1e-11), rel=1e-9, abs=0.0)
    assert ends["e"] == pytest.approx((10e-3, 50e-3))
    assert ends["f"] == pytest.approx((5e-3, 30e-3))
    assert ends["b"][0] == 0.0
    assert ends["b"][1] > 120.0


def test_all_cases_meet_at_the_common_point(curves: Curves) -> None:
    for case, value in {"a": 1000.0, "b": 0.0, "c": 1.4, "d": 1e-11, "e": 20e-3, "f": 5e-3}.items():
        curve = curves.pairs[case]
        at_common = np.interp(value, curve.values, curve.tangential_stiffness) * 1e-3
        assert at_common == pytest.approx(3.904e6, rel=2e-4)  # N/mm, model reference


def test_all_sweeps_meet_at_the_common_joint_for_every_torque(curves: Curves) -> None:
    common = {
        "dimension": 1.4,
        "roughness": 1e-11,
        "length": 5e-3,
        "friction": 0.12,
        "radius": 1.0,
    }
    expected = np.interp(OUTPUT_TORQUES, curves.loads.output_torque, curves.loads.output_stiffness[:, 0])
    for name, value in common.items():
        sweep = getattr(curves, name)
        at = int(np.argmin(np.abs(sweep.values - value)))
        assert sweep.values[at] == pytest.approx(value, rel=1e-12, abs=0.0)
        np.testing.assert_allclose(sweep.output_stiffness[:, at], expected, rtol=1e-9, err_msg=name)


def test_roughness_scales_out_of_the_stiffness_as_of_one_pair(curves: Curves) -> None:
    # at fixed D all contacts see the same G: the joint falls with it by the same factor as a pair does, nearly
    pair = curves.pairs["d"].tangential_stiffness
    joint = curves.roughness.output_stiffness[-1]
    assert joint[0] / joint[-1] == pytest.approx(pair[0] / pair[-1], rel=0.01)


def test_planet_moment_balances_everywhere(curves: Curves) -> None:
    force = curves.dimension.tangential_force  # (2): T_pwr + T_pwl = T_sp
    np.testing.assert_allclose(force[1] + force[2], force[0], atol=1e-9)

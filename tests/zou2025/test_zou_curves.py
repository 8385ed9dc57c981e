"""The batches take every number to its place."""

import numpy as np
import pytest

from asperity.joint import solve
from asperity.zou2025 import preset
from asperity.zou2025.curves import Curves
from asperity.zou2025.roller_pair import pair_contact


def test_ranges_are_those_of_table_1(curves: Curves) -> None:
    ends = {case: tuple(curve.values[[0, -1]]) for case, curve in curves.pairs.items()}
    assert ends["a"] == (0.0, 1000.0)
    assert ends["c"] == pytest.approx((1.3, 1.95))
    assert ends["d"] == pytest.approx((1e-13, 1e-11))
    assert ends["e"] == pytest.approx((10e-3, 50e-3))
    assert ends["f"] == pytest.approx((5e-3, 30e-3))
    assert ends["b"][0] == 0.0
    assert ends["b"][1] > 120.0


def test_all_cases_meet_at_the_common_point(curves: Curves) -> None:
    common = float(pair_contact(preset.table_1_pair()).tangential_stiffness)
    for case, value in {"a": 1000.0, "b": 0.0, "c": 1.4, "d": 1e-11, "e": 20e-3, "f": 5e-3}.items():
        curve = curves.pairs[case]
        assert np.interp(value, curve.values, curve.tangential_stiffness) == pytest.approx(common, rel=1e-9)


@pytest.mark.parametrize(
    ("name", "value", "at"),
    [
        ("friction", 0.2, "friction_coefficient"),
        ("length", 15e-3, "contact_length"),
        ("radius", 1.5, "radius_scale"),
    ],
)
def test_a_sweep_agrees_with_the_same_joint_solved_alone(
    curves: Curves, name: str, value: float, at: str
) -> None:
    sweep = getattr(curves, name)
    i, j = 3, int(np.argmin(np.abs(sweep.values - value)))
    alone = solve(
        preset.table_2_joint(
            preset.operating_grid(output_torque=sweep.output_torque[[i]], **{at: sweep.values[[j]]})
        )
    )
    assert sweep.output_stiffness[i, j] == pytest.approx(float(alone.published.output[0, 0]), rel=1e-12)
    np.testing.assert_allclose(
        sweep.normal_force[:, i, j], np.asarray(alone.forces.normal)[:, 0, 0], rtol=1e-12
    )


def test_planet_moment_balances_everywhere(curves: Curves) -> None:
    force = curves.dimension.tangential_force  # (2): T_pwr + T_pwl = T_sp
    np.testing.assert_allclose(force[1] + force[2], force[0], atol=1e-9)

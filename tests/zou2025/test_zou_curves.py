"""The batches take every number to its place."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint import solve
from asperity.zou2025 import preset
from asperity.zou2025.curves import Curves, JointCurves


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
    for case, value in {"a": 1000.0, "b": 0.0, "c": 1.4, "d": 1e-11, "e": 20e-3, "f": 5e-3}.items():
        curve = curves.pairs[case]
        at_common = np.interp(value, curve.values, curve.tangential_stiffness) * 1e-3
        assert at_common == pytest.approx(3.904e6, rel=2e-4)  # N/mm, model reference


def test_sweeps_agree_with_the_same_joints_solved_apart(curves: Curves) -> None:
    fields = {"friction": "friction_coefficient", "length": "contact_length", "radius": "radius_scale"}
    sweeps = {name: getattr(curves, name) for name in fields}
    i, j = 3, 10
    points = tuple(
        preset.operating_grid(
            output_torque=sweeps[name].output_torque[[i]], **{field: sweeps[name].values[[j]]}
        )
        for name, field in fields.items()
    )
    size = sum(c.output_stiffness.size for c in vars(curves).values() if isinstance(c, JointCurves))
    same_size = jax.tree.map(
        lambda leaf: jnp.resize(leaf, size), preset.joined(points)
    )  # no second compilation
    apart = solve(preset.table_2_joint(same_size))
    for k, sweep in enumerate(sweeps.values()):
        assert sweep.output_stiffness[i, j] == pytest.approx(float(apart.published.output[k]), rel=1e-12)
        np.testing.assert_allclose(
            sweep.normal_force[:, i, j], np.asarray(apart.forces.normal)[:, k], rtol=1e-12
        )


def test_planet_moment_balances_everywhere(curves: Curves) -> None:
    force = curves.dimension.tangential_force  # (2): T_pwr + T_pwl = T_sp
    np.testing.assert_allclose(force[1] + force[2], force[0], atol=1e-9)

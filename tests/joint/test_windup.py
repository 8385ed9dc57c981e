"""Wind-up: closed forms for a Mindlin spring, an independent quadrature for the joint, and refusals."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.windup import windup, windup_of
from asperity.show.windup_figure import windup_figure
from asperity.zou2025.preset import operating_grid, table_2_joint

STAGES = (1.0 / 3.0, 2.0 / 3.0)
K0, LIMIT, LARGEST = 2.0e4, 10.0, 8.0


def mindlin_stiffness(torque):
    return K0 * (1.0 - torque / LIMIT) ** (1.0 / 3.0)


def mindlin_angle(torque):
    """The integral of 1/K in closed form."""
    return 1.5 * LIMIT / K0 * (1.0 - (1.0 - torque / LIMIT) ** (2.0 / 3.0))


@pytest.fixture(scope="module")
def mindlin():
    return windup_of(mindlin_stiffness, largest_torque=LARGEST, stage_shares=STAGES)


def test_loading_curve_of_a_mindlin_spring(mindlin):
    np.testing.assert_allclose(
        mindlin.angle, mindlin_angle(np.asarray(mindlin.torque)), rtol=1e-10, atol=1e-18
    )


def test_unloading_follows_masing(mindlin):
    torque = np.asarray(mindlin.loop_torque)
    expected = mindlin_angle(LARGEST) - 2.0 * mindlin_angle((LARGEST - torque) / 2.0)
    np.testing.assert_allclose(mindlin.unloading_angle, expected, rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(mindlin.reloading_angle, -expected[::-1], rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(torque, -torque[::-1], atol=1e-9)


def test_figures_of_the_loop_of_a_mindlin_spring(mindlin):
    def unloading(torque):
        return mindlin_angle(LARGEST) - 2.0 * mindlin_angle((LARGEST - torque) / 2.0)

    assert float(mindlin.hysteresis) == pytest.approx(2.0 * unloading(0.0), rel=1e-9)
    lost = unloading(0.03 * LARGEST) - unloading(-0.03 * LARGEST)
    assert float(mindlin.lost_motion) == pytest.approx(lost, rel=1e-9)
    loop = np.linspace(-LARGEST, LARGEST, 20001)
    area = np.trapezoid(unloading(loop) + unloading(-loop), loop)
    assert float(mindlin.dissipated_energy) == pytest.approx(area, rel=1e-6)


def test_stages_are_secants_of_the_loading_curve(mindlin):
    bounds = np.array([0.0, *STAGES, 1.0]) * LARGEST
    expected = np.diff(bounds) / np.diff(mindlin_angle(bounds))
    np.testing.assert_allclose(mindlin.stage_stiffness, expected, rtol=1e-9)
    np.testing.assert_allclose(mindlin.stage_torque, bounds, rtol=1e-12)


def test_a_linear_spring_loses_nothing():
    curve = windup_of(lambda t: jnp.full_like(t, K0), largest_torque=5.0, stage_shares=STAGES)
    assert abs(float(curve.hysteresis)) < 1e-15
    assert abs(float(curve.dissipated_energy)) < 1e-14
    assert float(curve.lost_motion) == pytest.approx(2.0 * 0.03 * 5.0 / K0, rel=1e-9)


@pytest.fixture(scope="module")
def joint_curve():
    return windup(table_2_joint(operating_grid()), largest_torque=12.0, level="assembly", stage_shares=STAGES)


def test_the_joint_agrees_with_a_trapezoidal_integration_of_its_own_stiffness(joint_curve):
    """A second quadrature rule on the tabulated stiffness; its error is the trapezoid's."""
    torque, stiffness = np.asarray(joint_curve.torque), np.asarray(joint_curve.stiffness)
    coarse = np.trapezoid(1.0 / stiffness, torque)
    assert float(joint_curve.angle[-1]) == pytest.approx(coarse, rel=1e-4)
    assert np.all(np.diff(stiffness) < 0.0)
    assert float(joint_curve.hysteresis) > 0.0


def test_past_the_capacity_is_refused_with_the_torque():
    with pytest.raises(InputError, match=r"14 N·m is past the capacity: a contact slips at 1[34]\.?\d* N·m"):
        windup(table_2_joint(operating_grid()), largest_torque=14.0, level="published", stage_shares=STAGES)


@pytest.mark.parametrize("stages", [(0.5, 0.4), (0.0, 0.5), (0.5, 1.0)])
def test_stages_out_of_order_are_refused(stages):
    with pytest.raises(InputError, match="out of order"):
        windup_of(mindlin_stiffness, largest_torque=LARGEST, stage_shares=stages)


@pytest.mark.parametrize("torque", [0.0, -1.0, float("nan"), float("inf")])
def test_a_torque_that_is_no_torque_is_refused(torque):
    with pytest.raises(InputError, match="must be positive and finite"):
        windup_of(mindlin_stiffness, largest_torque=torque, stage_shares=STAGES)


def test_figure_names_its_axes_with_units(mindlin):
    loop, stiffness = windup_figure(mindlin, title="spring").axes
    assert "arcmin" in loop.get_xlabel()
    assert "N·m" in loop.get_ylabel()
    assert "N·m/arcmin" in stiffness.get_ylabel()

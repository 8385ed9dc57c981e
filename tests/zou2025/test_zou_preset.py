"""The preset holds what the tables print."""

import math

import numpy as np
import pytest

from asperity.joint import solve
from asperity.zou2025 import preset


@pytest.fixture(scope="module")
def solved():  # type: ignore[no-untyped-def]
    """The joint at (nearly) no torque and at 5 N·m."""
    return solve(preset.table_2_joint(preset.operating_grid(output_torque=np.array([1e-6, 5.0]))))


def test_sun_tangential_force_at_full_torque(solved) -> None:  # type: ignore[no-untyped-def]
    # without losses T_out = 9 T_in and T_in = 3 T_sp R_s
    assert float(solved.forces.tangential[0, 1]) == pytest.approx(5.0 / 9.0 / 3.0 / 4e-3, rel=1e-12)
    assert round(float(solved.forces.tangential[0, 1]), 2) == 46.30


def test_output_stiffness_at_small_and_full_torque(solved) -> None:  # type: ignore[no-untyped-def]
    small, full = np.asarray(solved.published.output)
    assert small == pytest.approx(5.0e6, rel=0.01)  # the model reference states two digits
    assert full == pytest.approx(4.3e6, rel=0.01)


def test_stiffness_at_the_output_is_81_times_that_at_the_sun(solved) -> None:  # type: ignore[no-untyped-def]
    np.testing.assert_allclose(solved.published.output, 81.0 * np.asarray(solved.published.sun), rtol=1e-12)


def test_guide_values_of_the_forces_at_full_torque(solved) -> None:  # type: ignore[no-untyped-def]
    np.testing.assert_allclose(solved.forces.normal[:, 1], [1000.0, 657.0, 465.0, 646.0, 449.0], rtol=0.01)
    np.testing.assert_allclose(solved.forces.tangential[1:3, 1], [27.1, 19.2], rtol=0.01)


def test_geometry_of_table_2(solved) -> None:  # type: ignore[no-untyped-def]
    assert math.degrees(float(np.ravel(solved.angles.wedge)[0])) == pytest.approx(13.1582, abs=1e-4)


def test_hardness_is_tabors() -> None:
    assert float(preset.steel().hardness) == pytest.approx(1260e6)


def test_grid_has_the_order_of_its_arguments() -> None:
    point = preset.operating_grid(
        output_torque=np.array([1.0, 2.0, 3.0]), contact_length=np.array([5e-3, 6e-3])
    )
    assert point.output_torque.shape == (3, 2)
    np.testing.assert_array_equal(point.output_torque[:, 0], [1.0, 2.0, 3.0])
    np.testing.assert_array_equal(point.contact_length[0], [5e-3, 6e-3])
    np.testing.assert_array_equal(np.asarray(point.fractal_dimension), np.full((3, 2), 1.4))


def test_joined_keeps_every_point_in_order() -> None:
    one = preset.operating_grid(output_torque=np.array([1.0, 2.0]), fractal_dimension=np.array([1.3, 1.4]))
    other = preset.operating_grid(output_torque=np.array([5.0]))
    flat = preset.joined((one, other))
    np.testing.assert_array_equal(flat.output_torque, [1.0, 1.0, 2.0, 2.0, 5.0])
    np.testing.assert_array_equal(flat.fractal_dimension, [1.3, 1.4, 1.3, 1.4, 1.4])


def test_a_column_that_table_1_does_not_have_is_refused() -> None:
    with pytest.raises(TypeError, match=r"no column \['viscosity'\]"):
        preset.table_1_pair(viscosity=1.0)

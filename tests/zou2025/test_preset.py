"""The preset: what the tables print, and Table 1 case c by independent quadrature (model reference, four digits)."""

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

from asperity.contact.interface import RoughContact
from asperity.drive.layout.wedge_geometry import triangle
from asperity.engine import trees
from asperity.engine.control import at_once
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.zou2025 import preset
from asperity.zou2025.curves import Curves
from asperity.zou2025.published import published_joint

# K_t in N/mm: R1/R2 = 10/20 mm, B = 5 mm, F_n = 1000 N, T = 0, G = 1e-8 mm, printed contact factor
REFERENCE = {
    1.3: 1.017e5,
    1.4: 3.904e6,
    1.5: 5.584e7,
    1.6: 4.135e8,
    1.7: 1.379e9,
    1.8: 2.537e9,
    1.85: 2.825e9,
    1.9: 2.650e9,
    1.95: 1.786e9,
}


SLIP = 120.0  # N, mu F_n = 0.12 times 1000 N
SHARES = (0.5, 0.992)
# (D, F_n, T): the reference's points, no load, gross slip, the common point and two tangential loads on it
POINTS = [
    *((d, 1000.0, 0.0) for d in REFERENCE),
    (1.4, 0.0, 0.0),
    (1.4, 1000.0, SLIP),
    (1.4, 1000.0, 0.0),
    *((1.4, 1000.0, SLIP * share) for share in SHARES),
]
NO_LOAD, SLIPPING, FREE = (len(REFERENCE) + i for i in range(3))


@pytest.fixture(scope="module")
def contact() -> RoughContact:
    def solved(dimension: np.ndarray, normal: np.ndarray, tangential: np.ndarray) -> RoughContact:
        return preset.table_1_contact(
            fractal_dimension=dimension, normal_force=normal, tangential_force=tangential
        )

    return at_once(solved, *np.array(POINTS).T)


def test_case_c_agrees_with_the_reference(contact: RoughContact) -> None:
    stiffness = np.asarray(contact.tangential_stiffness)[: len(REFERENCE)] * 1e-3
    np.testing.assert_allclose(stiffness, list(REFERENCE.values()), rtol=6e-4)


def test_highest_of_the_reference_points_is_at_1_85(contact: RoughContact) -> None:
    top = int(np.argmax(np.asarray(contact.tangential_stiffness)[: len(REFERENCE)]))
    assert list(REFERENCE)[top] == 1.85


def test_no_load_means_no_contact(contact: RoughContact) -> None:
    assert float(contact.tangential_stiffness[NO_LOAD]) == 0.0
    assert float(contact.real_contact_area[NO_LOAD]) == 0.0


def test_gross_slip_means_no_stiffness_but_contact(contact: RoughContact) -> None:
    assert float(contact.tangential_stiffness[SLIPPING]) == 0.0
    assert float(contact.largest_area[SLIPPING]) > 0.0


def test_tangential_force_enters_as_the_cube_root_of_what_friction_has_left(contact: RoughContact) -> None:
    stiffness = np.asarray(contact.tangential_stiffness)[FREE:]
    np.testing.assert_allclose(stiffness[1:], stiffness[0] * np.cbrt(1.0 - np.array(SHARES)), rtol=1e-12)


def test_sun_tangential_force_at_full_torque(curves: Curves) -> None:
    # without losses T_out = 9 T_in and T_in = 3 T_sp R_s
    force = curves.loads.tangential_force[0, -1, 0]
    assert force == pytest.approx(5.0 / 9.0 / 3.0 / 4e-3, rel=1e-12)
    assert round(float(force), 2) == 46.30


def test_output_stiffness_without_and_at_full_torque(curves: Curves) -> None:
    stiffness = curves.loads.output_stiffness[:, 0]
    assert stiffness[0] == pytest.approx(5.0e6, rel=0.01)  # the model reference states two digits
    assert stiffness[-1] == pytest.approx(4.3e6, rel=0.01)


def test_stiffness_at_the_output_is_81_times_that_at_the_sun(curves: Curves) -> None:
    np.testing.assert_allclose(curves.loads.output_stiffness, 81.0 * curves.loads.sun_stiffness, rtol=1e-12)


def test_guide_values_of_the_forces_at_full_torque(curves: Curves) -> None:
    np.testing.assert_allclose(
        curves.loads.normal_force[:, -1, 0], [1000.0, 657.0, 465.0, 646.0, 449.0], rtol=0.01
    )
    np.testing.assert_allclose(curves.loads.tangential_force[1:3, -1, 0], [27.1, 19.2], rtol=0.01)


def test_geometry_of_table_2() -> None:
    geometry = preset.table_2_joint(preset.operating_grid()).geometry
    wedge = math.asin(float(triangle(geometry).sin_wedge))
    assert math.degrees(wedge) == pytest.approx(13.1582, abs=1e-4)


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


def test_a_column_that_table_1_does_not_have_is_refused() -> None:
    with pytest.raises(TypeError, match=r"no column \['viscosity'\]"):
        preset.table_1_contact(viscosity=1.0)


def test_one_number_may_be_the_batch() -> None:
    joint = preset.table_2_joint(preset.operating_grid())
    joint = trees.map(float, joint)
    torques = np.array([1.0, 5.0])
    many = at_once(published_joint, dataclasses.replace(joint, output_torque=torques))
    alone = at_once(published_joint, joint)
    np.testing.assert_allclose(many.forces.normal[:, 1], alone.forces.normal, rtol=1e-12)
    assert float(many.stiffness.output[1]) == pytest.approx(float(alone.stiffness.output), rel=1e-12)


@pytest.mark.slow
def test_the_published_model_is_a_level_of_the_example_files_joint() -> None:
    """Equations (1)-(30) by the paper's own reduction, and by the balance of every body in the general chain."""
    example = Path(__file__).parents[2] / "examples" / "zou2025.toml"
    chain = solve_joint(joint_from_case(read_case(example))).result
    published = at_once(published_joint, preset.table_2_joint(preset.operating_grid()))
    assert bool(published.solved)
    for name in ("normal", "tangential"):
        np.testing.assert_allclose(getattr(published.forces, name), getattr(chain.forces, name), rtol=1e-9)
    np.testing.assert_allclose(
        published.contact_torsional_stiffness, chain.contact_torsional_stiffness, rtol=1e-9
    )
    for end in ("input", "output"):
        one, other = (float(getattr(level, end)) for level in (published.stiffness, chain.published))
        assert one == pytest.approx(other, rel=1e-9)

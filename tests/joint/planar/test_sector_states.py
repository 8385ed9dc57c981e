"""Sectors by themselves have crowns and skew like those of the joint with equal sectors."""

from types import SimpleNamespace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.planar.branches import BranchedPlanarJoint
from asperity.joint.planar.sector_states import _on_centre, _output_moments, _working_interference
from asperity.joint.planar.solve import solve_planar
from asperity.joint.planar.unfolding import SectorSizes, unfolded_joint
from asperity.joint_file.planar_build import deviations_of, planar_joint_from_case
from asperity.joint_file.si_tables import si_values


@pytest.mark.long
def test_equal_sectors_with_crowned_and_skewed_rollers_are_the_joint(planar_case):
    case = planar_case(
        "planetary",
        replaced={
            'bodies = "exact"': 'bodies = "springs"',
            'ring_support = "free" ': 'ring_support = "rigid_housing" ',
            "[load]": 'planet_crown_radius = "4 m"\n\n[load]',
            "[model]": '[rolling]\nskew = { sp = "0.1 mrad", pr = "0.2 mrad" }\n\n[model]',
        },
    )
    joint = planar_joint_from_case(case)
    solution = solve_planar(joint)
    found = BranchedPlanarJoint(joint, solution).branches(deviations_of(si_values(case)))
    result = solution.result
    np.testing.assert_allclose(found.preload, float(result.preload), rtol=1e-10)
    assert found.stiffness == pytest.approx(float(result.assembly.stiffness.output), rel=1e-9)
    np.testing.assert_allclose(found.rolling.slip_ratio, np.max(result.rolling.slip_ratio), rtol=1e-9)
    life = float(result.rolling.life_hours.drive)
    np.testing.assert_allclose(found.rolling.limits["life_hours"], life, rtol=1e-9)
    assert found.capacity.first_slip == pytest.approx(float(solution.first_slip.output_torque), rel=1e-8)
    assert found.rolling_capacity.first_slip == pytest.approx(
        float(solution.rolling_capacity.output_torque), rel=1e-6
    )


#: Directions of the planets of three sectors, the first above the sun, counter-clockwise.
TOWARDS = np.array(
    [[np.cos(angle), np.sin(angle)] for angle in np.pi / 2.0 + 2.0 * np.pi / 3.0 * np.arange(3)]
)
ACROSS = TOWARDS @ np.array([[0.0, 1.0], [-1.0, 0.0]])  # each turned counter-clockwise by a right angle


@pytest.fixture(scope="module")
def planetary_of_three(planar_joint):
    """The example, and the same with a floating sun and every sector by itself."""

    def of(replaced=None):
        joint = jax.tree.map(np.asarray, planar_joint("planetary", replaced or {}))
        sizes = SectorSizes(np.zeros((3, 2)), np.ones((3, 2)), 5e7, np.ones((2, 2)))
        return joint, unfolded_joint(joint, sizes, sectors=3, floating=("sun",))

    return of


def test_sectors_pass_what_they_carry_to_the_output(planetary_of_three):
    """Pins of 14, 28 and 0 N at 30 mm, or forces of 7, 14 and -7 N at the ring of 50 mm."""
    _, whole = planetary_of_three()
    state = SimpleNamespace(pin_force=jnp.array([14.0, 28.0, 0.0]), tangential=jnp.ones(6))
    moments = np.asarray(_output_moments(whole, state, 3))
    np.testing.assert_allclose(np.abs(moments), [0.42, 0.84, 0.0], atol=1e-12)
    assert moments[0] * moments[1] > 0.0
    _, whole = planetary_of_three({'output = "carrier"': 'output = "ring"'})
    state = SimpleNamespace(tangential=jnp.array([1.0, 7.0, 2.0, 14.0, 3.0, -7.0]), pin_force=jnp.ones(3))
    moments = np.asarray(_output_moments(whole, state, 3))
    np.testing.assert_allclose(np.sign(moments[0]) * moments, [0.35, 0.7, -0.35], atol=1e-12)


def test_a_floating_sun_takes_interference_from_the_planets_it_moves_to(planetary_of_three):
    _, whole = planetary_of_three()
    moved = np.array([1e-6, -3e-6])
    rest = SimpleNamespace(
        interference=jnp.full(6, 30e-6),
        displacement=jnp.array([moved, [5e-6, 1e-6], [2e-6, 2e-6], [1e-6, 4e-6]]),  # of the planets, too
    )
    found = np.asarray(_working_interference(whole, ("sun",), rest)).reshape(3, 2)
    np.testing.assert_allclose(found[:, 0], 30e-6 + TOWARDS @ moved, rtol=1e-12)
    np.testing.assert_allclose(found[:, 1], 30e-6, rtol=1e-12)
    held = np.asarray(_working_interference(whole, (), rest))
    np.testing.assert_allclose(held, 30e-6, rtol=1e-12)


def test_forces_on_the_members_in_the_middle_by_hand(planetary_of_three):
    """Planets press the sun inwards and the ring outwards; tangential forces act along the circles of both."""
    joint, whole = planetary_of_three()
    normal = np.array([[100.0, 110.0], [200.0, 190.0], [150.0, 130.0]])
    state = SimpleNamespace(
        normal=jnp.asarray(normal.ravel()), tangential=jnp.zeros(6), pin_force=jnp.array([10.0, -4.0, 7.0])
    )
    sun, ring, carrier = np.asarray(_on_centre(joint, whole, state))
    np.testing.assert_allclose(sun, -normal[:, 0] @ TOWARDS, rtol=1e-12)
    np.testing.assert_allclose(ring, normal[:, 1] @ TOWARDS, rtol=1e-12)
    pins = np.array([10.0, -4.0, 7.0]) @ ACROSS
    np.testing.assert_allclose(np.sign(carrier[0] * pins[0]) * carrier, pins, rtol=1e-12)
    drag = SimpleNamespace(
        normal=jnp.zeros(6), tangential=jnp.array([5.0, 0.0, 2.0, 0.0, -1.0, 0.0]), pin_force=jnp.zeros(3)
    )
    sun = np.asarray(_on_centre(joint, whole, drag))[0]
    along = np.array([5.0, 2.0, -1.0]) @ ACROSS
    np.testing.assert_allclose(np.sign(sun[0] * along[0]) * sun, along, rtol=1e-12)

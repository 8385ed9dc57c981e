"""What each of unequal branches carries: shares, and sums of the forces of contacts and pins by hand."""

from types import SimpleNamespace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.branches.results import (
    BranchState,
    _forces_on_axis,
    _output_moments,
    _state,
    _Sums,
    _working_interference,
)
from asperity.drive.state.state import Resistance
from asperity.joint.unfolding import SectorSizes, unfolded_joint


def state(torque):
    return BranchState(np.array(torque), "sun", np.zeros(2), np.zeros(2), {}, {}, 1.0)


@pytest.mark.parametrize(
    ("torque", "share"), [([3.0, 2.0, 0.0], [0.6, 0.4, 0.0]), ([-1.0, -1.0, -2.0], [0.25, 0.25, 0.5])]
)
def test_shares_are_of_the_whole_torque_in_either_sense(torque, share):
    np.testing.assert_allclose(state(torque).share, share, rtol=1e-15)


def test_without_a_torque_there_are_no_shares():
    with np.errstate(all="raise"):
        assert np.isnan(state([0.0, 0.0, 0.0]).share).all()


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
        sizes = SectorSizes(np.zeros((3, 2)), np.ones((3, 2)), 5e7)
        return joint, unfolded_joint(joint, sizes, sectors=3, floating=("sun",))

    return of


def of_oil(drag):
    """What only the oil resists."""
    return Resistance(drag, jnp.zeros(6), jnp.zeros(6))


def test_sectors_pass_what_they_carry_to_the_output(planetary_of_three):
    """Pins of 14, 28 and 0 N at 30 mm, or forces of 7, 14 and -7 N at the ring of 50 mm."""
    _, unfolded = planetary_of_three()
    loaded = SimpleNamespace(
        pin_force=jnp.array([14.0, 28.0, 0.0]), tangential=jnp.ones(6), resistance=of_oil(jnp.ones(6))
    )
    moments = np.asarray(_output_moments(unfolded, loaded, 3))
    np.testing.assert_allclose(np.abs(moments), [0.42, 0.84, 0.0], atol=1e-12)
    assert moments[0] * moments[1] > 0.0
    _, unfolded = planetary_of_three({'output = "carrier"': 'output = "ring"'})
    loaded = SimpleNamespace(
        tangential=jnp.array([1.0, 7.0, 2.0, 14.0, 3.0, -7.0]),
        pin_force=jnp.ones(3),
        resistance=of_oil(jnp.array([9.0, 2.0, 9.0, 0.0, 9.0, -1.0])),  # against the planets
    )
    moments = np.asarray(_output_moments(unfolded, loaded, 3))
    np.testing.assert_allclose(np.sign(moments[0]) * moments, [0.25, 0.7, -0.3], atol=1e-12)


def test_a_floating_sun_takes_interference_from_the_planets_it_moves_to(planetary_of_three):
    _, unfolded = planetary_of_three()
    moved = np.array([1e-6, -3e-6])
    rest = SimpleNamespace(
        interference=jnp.full(6, 30e-6),
        displacement=jnp.array([moved, [5e-6, 1e-6], [2e-6, 2e-6], [1e-6, 4e-6]]),  # of the planets, too
    )
    interference = np.asarray(_working_interference(unfolded, ("sun",), rest)).reshape(3, 2)
    np.testing.assert_allclose(interference[:, 0], 30e-6 + TOWARDS @ moved, rtol=1e-12)
    np.testing.assert_allclose(interference[:, 1], 30e-6, rtol=1e-12)
    held = np.asarray(_working_interference(unfolded, (), rest))
    np.testing.assert_allclose(held, 30e-6, rtol=1e-12)


def test_forces_on_the_members_in_the_middle_by_hand(planetary_of_three):
    """Planets press the sun inwards and the ring outwards; tangential forces act along the circles of both."""
    joint, unfolded = planetary_of_three()
    normal = np.array([[100.0, 110.0], [200.0, 190.0], [150.0, 130.0]])
    pressed = SimpleNamespace(
        normal=jnp.asarray(normal.ravel()),
        tangential=jnp.zeros(6),
        pin_force=jnp.array([10.0, -4.0, 7.0]),
        drag=jnp.zeros(6),
    )
    sun, ring, carrier = np.asarray(_forces_on_axis(joint, unfolded, pressed))
    np.testing.assert_allclose(sun, -normal[:, 0] @ TOWARDS, rtol=1e-12)
    np.testing.assert_allclose(ring, normal[:, 1] @ TOWARDS, rtol=1e-12)
    pins = np.array([10.0, -4.0, 7.0]) @ ACROSS
    np.testing.assert_allclose(np.sign(carrier[0] * pins[0]) * carrier, pins, rtol=1e-12)
    pushed = SimpleNamespace(
        normal=jnp.zeros(6),
        tangential=jnp.array([7.0, 0.0, 2.0, 0.0, -1.0, 0.0]),
        pin_force=jnp.zeros(3),
        drag=jnp.array(
            [6.0, 0.0, 0.0, 0.0, 0.0, 0.0]
        ),  # shear of 6 N, pressure of 2 x 6 x 20/30 N against it
    )
    sun = np.asarray(_forces_on_axis(joint, unfolded, pushed))[0]
    along = np.array([5.0, 2.0, -1.0]) @ ACROSS
    np.testing.assert_allclose(np.sign(sun[0] * along[0]) * sun, along, rtol=1e-12)


def test_a_state_by_hand_in_axes_to_the_first_planet(planetary_of_three):
    """It is above the sun: x to the right and y up become -y and x there."""
    joint, _ = planetary_of_three()
    branches = SimpleNamespace(equal=joint, sectors=3, floating=("sun",))
    moments = np.array([[-2.0, -10.0, 12.0]]) * np.array([[0.0], [1.0], [1.05]])
    output = np.array([[0.0, 0.0, 0.0], [33.0, 30.0, 27.0], [27.0, 30.0, 33.0]])
    sums = _Sums(np.arange(18.0).reshape(3, 3, 2), moments, output, np.zeros((3, 2)))
    solved = SimpleNamespace(displacement=np.array([[1e-6, 2e-6]]), input_torque=np.asarray(2.0))
    rest, standing, rolling = (_state(branches, sums, kind, solved, 6.0) for kind in range(3))
    np.testing.assert_array_equal(rest.torque, 0.0)
    np.testing.assert_allclose(standing.torque, [2.2, 2.0, 1.8], rtol=1e-12)
    np.testing.assert_allclose(rolling.torque, [1.8, 2.0, 2.2], rtol=1e-12)
    np.testing.assert_allclose(standing.central_displacement, [2e-6, -1e-6], atol=1e-18)
    np.testing.assert_allclose(standing.central_force, [7.0, -6.0], atol=1e-12)
    np.testing.assert_allclose(standing.centre_forces["ring"], [9.0, -8.0], atol=1e-12)
    assert (standing.central, standing.input_torque) == ("sun", 2.0)
    sense = float(joint.drive.sense)
    assert standing.torques == pytest.approx(
        {"sun": -2.0 * sense, "ring": -10.0 * sense, "carrier": 12.0 * sense}
    )
    held = SimpleNamespace(equal=joint, sectors=3, floating=())
    np.testing.assert_array_equal(_state(held, sums, 1, solved, 6.0).central_displacement, 0.0)
    np.testing.assert_array_equal(_state(held, sums, 1, solved, 0.0).torque, 0.0)

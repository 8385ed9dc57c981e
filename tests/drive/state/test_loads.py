"""Loads of the structure against the states that they belong to, and by hand."""

import dataclasses

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.state.loads import member_loads, pin_components


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "torque"),
    [
        pytest.param("wedge", 5.0, marks=pytest.mark.slow),
        ("planetary", 8.0),
        pytest.param("multiroller", 20.0, marks=pytest.mark.slow),
        pytest.param("stepped", 6.0, marks=pytest.mark.slow),
    ],
)
def test_every_body_and_the_whole_drive_are_in_balance(drives, solved, name, torque):
    drive = drives[name]
    _, state = solved(name, torque)
    found = member_loads(
        drive=drive,
        normal=state.normal,
        tangential=state.tangential,
        body_force=jnp.zeros((len(drive.floating), 2)),
    )
    np.testing.assert_allclose(found.pin, state.pin_force, atol=1e-7)
    np.testing.assert_allclose(found.unbalanced, 0.0, atol=1e-7)
    moments = dict(zip(drive.members, np.asarray(found.moments), strict=True))
    # input, output and grounded member hold each other about the axis; nothing else carries a torque
    assert sum(moments.values()) == pytest.approx(0.0, abs=1e-9)
    ends = (drive.input, drive.output, drive.grounded)
    assert abs(moments[drive.output]) == pytest.approx(torque, rel=1e-9)
    assert -drive.sense * moments[drive.input] == pytest.approx(float(state.input_torque), rel=1e-9)
    for member, moment in moments.items():
        if member not in ends:
            assert moment == pytest.approx(0.0, abs=1e-9)


def test_a_planet_of_a_planetary_by_hand(drives):
    """7 N at sun and ring push the pin with 14 N; 5 N outward press the ring, and leave the pin alone.

    The planet turns against the sun.
    """
    drive = drives["planetary"]
    found = member_loads(
        drive=drive,
        normal=jnp.array([100.0, 105.0]),
        tangential=jnp.array([7.0, -7.0]),
        body_force=5.0 * drive.centres[1:2] / jnp.linalg.norm(drive.centres[1]),
    )
    np.testing.assert_allclose(np.abs(found.pin), [14.0], rtol=1e-12)
    np.testing.assert_allclose(found.unbalanced, 0.0, atol=1e-9)
    np.testing.assert_allclose(np.abs(found.moments), 3.0 * np.array([0.07, 0.0, 0.35, 0.42]), atol=1e-12)


@pytest.mark.parametrize("name", ["wedge", "planetary", "stepped"])
@pytest.mark.parametrize("sense", [1, -1])
def test_tangential_forces_turn_the_carrier_and_count_in_the_sense_of_the_input(drives, name, sense):
    """Whatever the contacts do: force times distance from the axis, by any push angle."""
    drive = drives[name]
    drive = dataclasses.replace(drive, sense=sense, push_angles=drive.push_angles + 0.3)
    normal = jnp.linspace(90.0, 110.0, len(drive.contacts))
    found = member_loads(
        drive=drive,
        normal=normal,
        tangential=0.1 * normal[::-1],
        body_force=jnp.zeros((len(drive.floating), 2)),
    )
    radial, tangential = pin_components(drive=drive, force=found.pin)
    np.testing.assert_allclose(np.hypot(radial, tangential), np.abs(found.pin), rtol=1e-12)
    arms = np.linalg.norm(np.asarray(drive.centres)[list(drive.pinned)], axis=1)
    carrier = drive.members.index("carrier")
    moment = sense * float(drive.sectors) * np.sum(np.asarray(tangential) * arms)
    assert moment == pytest.approx(float(found.moments[carrier]), rel=1e-9, abs=1e-9)

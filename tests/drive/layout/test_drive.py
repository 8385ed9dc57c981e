"""Kinematics of every drive beyond its ratio, which is one of the checks of the installation."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.drive import contact_angles, gaps, incidence, speeds
from asperity.drive.layout.existence import refuse_impossible


@pytest.mark.parametrize("name", ["wedge", "planetary", "multiroller", "stepped"])
def test_no_contact_slips_and_all_touch(drives, name):
    drive = drives[name]
    np.testing.assert_allclose(incidence(drive).turning @ speeds(drive), 0.0, atol=1e-15)
    np.testing.assert_allclose(gaps(drive), 0.0, atol=1e-15)
    refuse_impossible(drive)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["wedge", "planetary", "multiroller", "stepped"])
def test_approaches_are_what_the_gaps_lose(drives, name):
    """By automatic differentiation of the distances; sliding is a quarter turn counter-clockwise from it."""
    drive = drives[name]
    slopes = jax.jacfwd(lambda centres: gaps(dataclasses.replace(drive, centres=centres)))(drive.centres)
    matrices = incidence(drive)
    floating = np.asarray(slopes)[:, list(drive.floating)].reshape(len(drive.contacts), -1)
    np.testing.assert_allclose(matrices.approach, -floating, atol=1e-12)
    for first in (k for k, contact in enumerate(drive.contacts) if contact.sector == 0):
        approach, sliding = (
            np.asarray(m)[first].reshape(-1, 2) for m in (matrices.approach, matrices.sliding)
        )
        np.testing.assert_allclose(sliding, approach[:, ::-1] * [-1.0, 1.0], atol=1e-12)


def test_pins_push_along_the_clockwise_tangent(drives):
    """Of the planet above the axis: to the right, and counter-clockwise by the push angle; lever of 30 mm at 0."""
    drive = drives["planetary"]
    for angle, push in ((0.0, [1.0, 0.0]), (0.3, [np.cos(0.3), np.sin(0.3)])):
        matrices = incidence(dataclasses.replace(drive, push_angles=jnp.array([angle])))
        np.testing.assert_allclose(matrices.pins, [push], atol=1e-15)
        np.testing.assert_allclose(matrices.levers, [-30e-3 * np.cos(angle)], rtol=1e-12)


def test_where_contacts_lie_on_their_bodies(drives):
    """The planet above the sun: 90 degrees on the sun, -90 on the planet; at the ring 90 on both."""
    first, second = contact_angles(drives["planetary"])
    np.testing.assert_allclose(first, [np.pi / 2.0, np.pi / 2.0], rtol=1e-12)
    np.testing.assert_allclose(second, [-np.pi / 2.0, np.pi / 2.0], rtol=1e-12)
    # each second-row roller of the multiroller is touched symmetrically by two of the first row
    second = np.asarray(contact_angles(drives["multiroller"])[1])
    np.testing.assert_allclose(np.cos(second[1] - 0.75 * np.pi), np.cos(second[2] - 0.75 * np.pi), rtol=1e-9)

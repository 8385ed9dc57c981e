"""Pins across their push and bearings of planets, against a dense independent assembly and the published series."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.state.supports import carrier_supports
from asperity.drive.stiffness.network import network_stiffness
from asperity.drive.types.wedge import wedge_drive
from asperity.zou2025.kinematics import CONTACT_NAMES
from asperity.zou2025.series_stiffness import series_torsional_stiffness

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
TILTED = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.2, -0.1)
PLANET = (1,)


def stiffness(geometry, normal, tangential, *, pin=math.inf, across=None, planet=None):
    @jax.jit
    def found(geometry, normal, tangential, pin):
        drive = wedge_drive(geometry, planet_count=3)
        return network_stiffness(
            drive=drive,
            normal_compliance=1.0 / normal,
            tangential_compliance=1.0 / tangential,
            pin_compliance=1.0 / pin,
            supports=carrier_supports(
                drive=drive,
                pin_transverse_stiffness=across,
                planet_support_stiffness=planet,
                planets=PLANET,
            ),
        )

    return found(geometry, jnp.asarray(normal), jnp.asarray(tangential), jnp.asarray(pin))


def shares(found):
    parts = (found.tangential_share, found.normal_share, found.pin_share, found.support_share)
    return sum(float(jnp.sum(part)) for part in parts)


@pytest.mark.parametrize(
    ("pin", "across", "geometry"),
    [(math.inf, None, PAPER), (3e7, 2e7, PAPER), (5e7, 1e7, TILTED), (math.inf, 3e8, TILTED)],
)
def test_pins_agree_with_the_dense_assembly_of_all_branches(dense_assembly, pin, across, geometry):
    rng = np.random.default_rng(7)
    normal, tangential = rng.uniform(5e7, 5e8, 5), rng.uniform(5e7, 5e9, 5)
    names = {
        "sun_radius": 4e-3,
        "planet_radius": 13.5e-3,
        "loading_roller_radius": 5e-3,
        "ring_radius": 40e-3,
        "planets": 3,
        "push_angle_left": float(geometry.left_push_angle),
        "push_angle_right": float(geometry.right_push_angle),
    }
    expected = dense_assembly(
        names,
        dict(zip(CONTACT_NAMES, normal, strict=True)),
        dict(zip(CONTACT_NAMES, tangential, strict=True)),
        pin=pin,
        pin_across=0.0 if across is None else across,
    )
    found = stiffness(geometry, normal, tangential, pin=pin, across=across)
    assert float(found.output) == pytest.approx(81.0 * expected, rel=1e-9)
    assert shares(found) == pytest.approx(1.0, abs=1e-9)


def test_held_centres_are_the_published_series():
    """Rigid in every direction, the normal springs do not matter; the limit is reached from soft bearings upwards."""
    normal, tangential = np.full(5, 1e8), np.full(5, 2e8)
    series = series_torsional_stiffness(geometry=PAPER, tangential_stiffness=jnp.asarray(tangential))
    found = [
        float(stiffness(PAPER, normal, tangential, across=each, planet=each).output)
        for each in (1e3, 1e7, 1e9, 1e13, math.inf)
    ]
    assert found == sorted(found)
    assert found[0] == pytest.approx(float(stiffness(PAPER, normal, tangential).output), rel=1e-3)
    assert found[-1] == pytest.approx(float(series.output), rel=1e-9)
    assert found[-2] == pytest.approx(found[-1], rel=1e-4)


def test_a_bearing_of_the_planet_takes_its_share():
    """By virtual work: the share is the slope of the logarithm of the compliance over that of the bearing's."""
    normal, tangential, planet, step = np.full(5, 1e8), np.full(5, 2e8), 4e7, 1e-5
    found = stiffness(TILTED, normal, tangential, planet=planet, pin=6e7)
    assert shares(found) == pytest.approx(1.0, abs=1e-9)
    softer, stiffer = (
        -math.log(float(stiffness(TILTED, normal, tangential, planet=planet * factor, pin=6e7).output))
        for factor in (1.0 - step, 1.0 + step)
    )
    assert float(jnp.sum(found.support_share)) == pytest.approx((softer - stiffer) / (2.0 * step), rel=1e-6)
    assert float(jnp.sum(found.support_share)) > 0.05

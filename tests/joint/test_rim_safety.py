"""Strength of ring and hollow rollers in a joint: documented stresses, and all contacts as vectors."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hoop_stress import hoop_stress

from asperity.body.rim_range import RimLoads
from asperity.body.shapes import Annulus
from asperity.engine.control import at_once
from asperity.joint.bodies import exact_bodies
from asperity.joint.rim_safety import _centring_pressure
from asperity.joint.rims import joint_rims

by_sum = jax.jit(hoop_stress, static_argnames="mode_count")


@pytest.fixture(scope="module")
def result(solved_example):
    """Forces of the paper's joint; those of another wall are the same, because the closure has springs."""
    return solved_example.solution.result


@pytest.fixture(scope="module")
def joint(paper_joint):
    """With a ring of 10 mm that carries itself and hollow rollers; planet and ring of a steel that endures 300 MPa."""
    made = paper_joint(
        ring_support="free", drive__planet_bore_diameter=12e-3, drive__loading_roller_bore_diameter=5e-3
    )
    tires = dataclasses.replace(made.materials[1], fatigue_strength=np.float64(300e6))
    materials = (made.materials[0], tires, *made.materials[2:4], tires)
    return dataclasses.replace(made, materials=materials)


@pytest.fixture(scope="module")
def found(joint, result):
    return at_once(joint_rims, joint, result)


@pytest.mark.long
def test_ring_at_rest_as_by_finite_elements(found):
    """614.45 Pa per N/m midway between the planets, the largest of the inner rim (body/test_rim_stress.py)."""
    roller = 1000.0 / (2.0 * math.cos(math.radians(27.0831))) * math.cos(math.radians(13.1582))
    assert float(found.stress_at_rest[0, 4]) == pytest.approx(614.45 * roller / 5e-3, rel=2e-3)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "member"), [("ring", 4), ("planet", 1)])
def test_stress_by_another_sum(joint, result, found, name, member):
    """Signs of the forces from vectors: pushes along the line of centres, drags that drive each body."""
    body = exact_bodies(joint)[member]
    normal, tangential = np.asarray(result.rolling.normal), np.asarray(result.rolling.tangential)
    contacts = list(body.contacts)
    if name == "ring":  # the rollers push it outward and drag it clockwise, with the sun
        angles = np.add.outer(2.0 * np.pi / 3.0 * np.arange(3), np.asarray(body.contact_angles)).ravel()
        radial, drag = np.tile(normal[contacts], 3), np.tile(-tangential[contacts], 3)
    else:  # the sun drives it counter-clockwise, the rollers hold it back
        angles, radial = np.asarray(body.contact_angles), -normal[contacts]
        drag = tangential[contacts] * np.array([1.0, -1.0, -1.0])
    grid = np.linspace(0.0, 2.0 * np.pi, 721)
    stress = by_sum(
        body=body.body,
        contact_angles=jnp.asarray(angles),
        radial_forces=jnp.asarray(radial),
        tangential_forces=jnp.asarray(drag),
        angle=jnp.asarray(grid),
        mode_count=300,
    )
    other = np.asarray(stress.other_rim)
    rim = 1 if name == "ring" else 0
    ours = jax.tree.map(lambda leaf: leaf[..., member], found)
    assert float(ours.stress[rim]) == pytest.approx(other.max(), rel=2e-3)
    assert float(ours.amplitude[rim]) == pytest.approx(0.5 * np.ptp(other), rel=2e-3)
    assert float(ours.mean[rim]) == pytest.approx(0.5 * (other.max() + other.min()), abs=2e-3 * other.max())


@pytest.mark.slow
def test_safeties(found, joint):
    ring = jax.tree.map(lambda leaf: leaf[..., 4], found)
    mises = math.sqrt(1.0 - 0.3 + 0.09) * float(jnp.max(jnp.maximum(ring.stress, ring.stress_at_rest)))
    assert float(ring.yield_safety) == pytest.approx(450e6 / mises, rel=1e-9)  # compression is smaller here
    use = np.asarray(ring.amplitude) / 300e6 + np.maximum(np.asarray(ring.mean), 0.0) / 450e6
    assert float(ring.fatigue_safety) == pytest.approx(1.0 / use.max(), rel=1e-9)
    assert math.isnan(float(found.fatigue_safety[2]))  # its steel has no fatigue strength
    assert float(found.yield_safety[2]) > 0.0


@pytest.mark.slow
def test_a_solid_sun_has_no_rims(found):
    for value in vars(found).values():
        assert np.all(np.isnan(np.asarray(value)[..., 0]))


def test_a_housing_centres_a_ring_that_is_pressed_to_one_side():
    """300 N outwards and 500 N along the rim at one place, 100 N inwards a quarter turn on: 500 N, by a cosine."""
    ring = Annulus(50e-3, 58e-3, 10e-3, 206e9, 0.3, math.inf, math.inf, "inner", "plane_strain")
    loads = RimLoads(
        angles=jnp.array([0.0, 0.5 * math.pi]),
        radial=jnp.array([300.0, -100.0]),
        tangential=jnp.array([500.0, 0.0]),
        half_widths=jnp.full(2, 1e-4),
        sectors=None,
    )
    found = float(_centring_pressure(ring, loads))
    around = np.linspace(0.0, 2.0 * math.pi, 360, endpoint=False)
    carried = np.mean(found * np.cos(around) ** 2) * 2.0 * math.pi * 58e-3 * 10e-3
    assert carried == pytest.approx(500.0, rel=1e-9)

"""Strength of ring and hollow rollers in a joint: documented stresses, all contacts as vectors, and what is absent."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from asperity.joint.working_loads import working_forces

from asperity.body.rim_stress import hoop_stress
from asperity.drive.geometry import triangle
from asperity.joint.description import with_one_rank
from asperity.joint.elastic_bodies import machine_bodies
from asperity.joint.planar.solve import solve_planar
from asperity.joint.results import RESULTS
from asperity.joint.rim_safety import branch_joint_rims, joint_rims
from asperity.joint_file.planar_build import planar_joint_from_case

rims = jax.jit(joint_rims)
unlike = jax.jit(branch_joint_rims)
by_sum = jax.jit(hoop_stress, static_argnames="mode_count")


@pytest.fixture(scope="module")
def plain(case):
    return jax.tree.map(np.float64, planar_joint_from_case(case))


@pytest.fixture(scope="module")
def result(plain):
    """Forces of the paper's joint; those of another wall are the same, because the closure has springs."""
    return solve_planar(plain).result


@pytest.fixture(scope="module")
def joint(plain):
    """With a ring of 10 mm that carries itself and hollow rollers of a steel that endures 300 MPa."""
    steel = dataclasses.replace(plain.bodies.ring, fatigue_strength=300e6)
    bodies = dataclasses.replace(plain.bodies, ring=steel, planet=steel)
    return dataclasses.replace(
        plain,
        bodies=bodies,
        ring_wall_thickness=np.float64(10e-3),
        ring_support="free",
        planet_bore=np.float64(12e-3),
        loading_roller_bore=np.float64(5e-3),
    )


@pytest.fixture(scope="module")
def found(joint, result):
    return rims(joint, result)


@pytest.mark.slow
def test_ring_at_rest_as_by_finite_elements(found):
    """614.45 Pa per N/m midway between the planets, the largest of the inner rim (body/test_rim_stress.py)."""
    roller = 1000.0 / (2.0 * math.cos(math.radians(27.0831))) * math.cos(math.radians(13.1582))
    assert float(found.ring.stress_at_rest[0]) == pytest.approx(614.45 * roller / 5e-3, rel=2e-3)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "member"), [("ring", 4), ("planet", 1)])
def test_stress_by_another_sum(joint, result, found, name, member):
    """Signs of the forces from vectors: pushes along the line of centres, drags that drive each body."""
    bodies = machine_bodies(with_one_rank(joint), triangle(joint.geometry))
    body = bodies[member]
    normal, tangential = (np.asarray(each) for each in working_forces(joint, result))
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
    ours = getattr(found, name)
    assert float(ours.stress[rim]) == pytest.approx(other.max(), rel=2e-3)
    assert float(ours.amplitude[rim]) == pytest.approx(0.5 * np.ptp(other), rel=2e-3)
    assert float(ours.mean[rim]) == pytest.approx(0.5 * (other.max() + other.min()), abs=2e-3 * other.max())


@pytest.mark.slow
def test_safeties(found, joint):
    ring = found.ring
    mises = math.sqrt(1.0 - 0.3 + 0.09) * float(jnp.max(jnp.maximum(ring.stress, ring.stress_at_rest)))
    assert float(ring.yield_safety) == pytest.approx(450e6 / mises, rel=1e-9)  # compression is smaller here
    use = np.asarray(ring.amplitude) / 300e6 + np.maximum(np.asarray(ring.mean), 0.0) / 450e6
    assert float(ring.fatigue_safety) == pytest.approx(1.0 / use.max(), rel=1e-9)
    assert math.isnan(float(found.loading_roller.fatigue_safety))  # its steel has no fatigue strength
    assert float(found.loading_roller.yield_safety) > 0.0


@pytest.mark.slow
def test_a_held_ring_is_stressed_less_and_solid_rollers_not_at_all(plain, result, found):
    held = rims(dataclasses.replace(plain, ring_wall_thickness=np.float64(10e-3)), result)
    assert float(held.ring.stress[0]) < 0.2 * float(found.ring.stress[0])
    for value in vars(held.planet).values():
        assert np.all(np.isnan(np.asarray(value)))


def test_only_bodies_that_bend_are_judged(joint, plain):
    from asperity.joint.results import SolvedJoint

    bending, stiff = SolvedJoint(joint, None), SolvedJoint(plain, None)
    for body, tires in (("ring", True), ("planet", True), ("loading_roller", False)):
        assert RESULTS[f"{body}_yield_safety"].present(bending) == (True,)
        assert RESULTS[f"{body}_fatigue_safety"].present(bending) == (tires,)
        assert RESULTS[f"{body}_yield_safety"].present(stiff) == (False,)


@pytest.mark.long
def test_branches_that_differ_bend_a_free_ring_by_all_their_forces(joint, result, found):
    """Three branches with 1.4, 1.0 and 0.6 times the forces: the sum of all six contacts without symmetry."""
    forces = np.array([np.asarray(each) for each in working_forces(joint, result)])
    rest = np.array([forces[0], np.zeros(5)])
    share = np.array([1.4, 1.0, 0.6])
    each = unlike(joint, forces[..., None] * share, rest[..., None] * np.ones(3))
    ring = machine_bodies(with_one_rank(joint), triangle(joint.geometry))[4]
    radial, drag = (
        np.outer(share, sign * force[[3, 4]]).ravel() for sign, force in zip((1, -1), forces, strict=True)
    )
    stress = by_sum(
        body=ring.body,
        contact_angles=jnp.asarray(
            np.add.outer(2.0 * np.pi / 3.0 * np.arange(3), np.asarray(ring.contact_angles)).ravel()
        ),
        radial_forces=jnp.asarray(radial),
        tangential_forces=jnp.asarray(drag),
        angle=jnp.asarray(np.linspace(0.0, 2.0 * np.pi, 721)),
        mode_count=300,
    )
    other = np.asarray(stress.other_rim)
    assert float(each.ring.stress[1]) == pytest.approx(other.max(), rel=5e-3)
    assert float(each.ring.amplitude[1]) == pytest.approx(0.5 * np.ptp(other), rel=5e-3)
    # hollow rollers bend by the forces of their own branch, in proportion to them
    assert np.asarray(each.planet.stress) == pytest.approx(1.4 * np.asarray(found.planet.stress), rel=1e-2)
    alike = unlike(joint, forces[..., None] * np.ones(3), rest[..., None] * np.ones(3))
    for body in ("ring", "planet", "loading_roller"):
        own, expected = (getattr(one, body).amplitude for one in (alike, found))
        np.testing.assert_allclose(own, expected, rtol=1e-3)
        # of the rings in a housing and of rollers nothing else is known than of each branch alone
    held = dataclasses.replace(joint, ring_support="rigid_housing")
    worst = unlike(held, forces[..., None] * share, rest[..., None] * np.ones(3)).ring.stress
    one = unlike(held, forces[..., None] * share[:1] * np.ones(3), rest[..., None] * np.ones(3)).ring.stress
    np.testing.assert_allclose(worst, one, rtol=1e-12)

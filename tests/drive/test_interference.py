"""Interference and preload against an independent computation of the paper's joint, and against each other."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from asperity.drive.interference import (
    CrownsAtRest,
    RestCompliance,
    crown_interference,
    incremental_interference,
    interference,
    interference_of_sizes,
    preload_of_interference,
    rest_compliance,
)
from asperity.joint.evaluation import evaluate

from asperity.contact.crowned_line import CrownedLines, crown_compression
from asperity.drive.geometry import triangle
from asperity.drive.mechanism import rest_state
from asperity.joint.contacts import joint_contacts
from asperity.joint.description import with_one_rank
from asperity.joint.elastic_bodies import AssemblySprings
from asperity.joint.interference import joint_rest_compliance


@pytest.fixture(scope="module")
def smooth(paper_joint):
    """Rest state and compliance of the paper's joint with springs: Johnson, and Weber and Banaschek for 60 mm."""
    joint = with_one_rank(
        dataclasses.replace(paper_joint(ring_wall_thickness=60e-3), body_model="springs", ring_support=None)
    )
    rest = rest_state(geometry=joint.geometry, sides=triangle(joint.geometry), preload=joint.preload)
    compliance = joint_rest_compliance(
        joint=joint,
        contacts=joint_contacts(joint),
        rest=rest,
        springs=AssemblySprings(jnp.ones(5), jnp.ones(5), None),
    )
    return rest, compliance


def test_a_thousand_newtons_are_thirteen_micrometres(smooth):
    """12.904 um, computed independently."""
    _, compliance = smooth
    assert float(interference(compliance=compliance, preload=1000.0)) == pytest.approx(12.904e-6, abs=5e-10)


def test_planets_too_large_or_too_small(smooth):
    """5 um on every planet radius make 218 or 1854 N, 2 um 676 or 1335 N; a planet counts 1.9413 times."""
    rest, compliance = smooth
    even = {"sun": 0.0, "right_roller": 0.0, "left_roller": 0.0, "ring": 0.0}
    one = float(interference_of_sizes(rest=rest, planet=1.0, **even))
    assert one == pytest.approx(1.9413, abs=5e-5)
    for size, force in ((-5e-6, 218.0), (5e-6, 1854.0), (-2e-6, 676.0), (2e-6, 1335.0)):
        found = preload_of_interference(compliance=compliance, interference=12.904e-6 + one * size)
        assert float(found) == pytest.approx(force, abs=0.6)


def test_every_size_by_virtual_work(smooth):
    """A smaller ring counts once; all rollers larger by one factor are the ring smaller by it."""
    rest, _ = smooth
    assert (
        float(interference_of_sizes(rest=rest, sun=0, planet=0, right_roller=0, left_roller=0, ring=-1.0))
        == 1.0
    )
    scaled = interference_of_sizes(
        rest=rest, sun=4e-3, planet=13.5e-3, right_roller=5e-3, left_roller=5e-3, ring=40e-3
    )
    # a drive of another scale touches as well, and the pins, which hold the rollers' angle, do no work
    assert abs(float(scaled)) < 1e-15


@pytest.mark.slow
def test_both_ways_and_derivatives(smooth):
    _, compliance = smooth
    forces = jnp.geomspace(0.1, 2e4, 40)
    lengths = interference(compliance=compliance, preload=forces)
    back = preload_of_interference(compliance=compliance, interference=lengths)
    assert np.asarray(back) == pytest.approx(np.asarray(forces), rel=1e-12)
    slope = jax.vmap(jax.grad(lambda x: preload_of_interference(compliance=compliance, interference=x)))(
        lengths
    )
    direct = jax.vmap(jax.grad(lambda n: interference(compliance=compliance, preload=n)))(forces)
    assert np.asarray(slope * direct) == pytest.approx(np.ones(40), rel=1e-10)

    def of(secant):
        changed = RestCompliance(secant, compliance.logarithmic, compliance.reference)
        return preload_of_interference(compliance=changed, interference=10e-6)

    s = compliance.secant
    step = 1e-5 * s
    assert float(jax.grad(of)(s)) == pytest.approx(
        float((of(s + step) - of(s - step)) / (2 * step)), rel=1e-6
    )


def test_without_interference_there_is_no_preload_and_too_much_is_no_number(smooth):
    _, compliance = smooth
    found = preload_of_interference(compliance=compliance, interference=jnp.array([-1e-6, 0.0, 1.0]))
    assert np.asarray(found[:2]).tolist() == [0.0, 0.0]
    assert np.isnan(found[2])


def test_springs_of_ring_and_pins_add_their_compression(smooth):
    rest, _ = smooth
    stiff = rest_compliance(
        rest=rest,
        preload=1000.0,
        secant_work=0.0,
        logarithmic_compliance=jnp.zeros(5),
        ring_compliance=1e-8,
        pin_compliance=0.0,
    )
    normal = float(rest.normal_force[3])
    assert float(interference(compliance=stiff, preload=1000.0)) == pytest.approx(1e-8 * normal, rel=1e-12)


@pytest.mark.slow
def test_exact_bodies_and_a_ring_that_carries_itself(paper_joint):
    """All six radial loads on a ring of 10 mm: 2.43827e-8 m/N free, 2.71043e-9 held, computed independently."""
    found = jax.jit(lambda joint: evaluate(joint).interference)
    joint = paper_joint(ring_wall_thickness=10e-3)
    held, free, springs = (
        float(found(dataclasses.replace(joint, **changes)))
        for changes in ({}, {"ring_support": "free"}, {"body_model": "springs"})
    )
    assert held == pytest.approx(springs, rel=0.03)
    force = 1000.0 / (2 * np.cos(np.radians(27.0831))) * np.cos(np.radians(13.1582))
    assert free - held == pytest.approx(force * (2.43827e-8 - 2.71043e-9), rel=0.01)


def test_the_torque_does_not_change_the_interference(paper_joint, evaluated_together):
    """It is that of the joint at rest, although the matrix of the bodies is found under load."""
    values = evaluated_together(paper_joint(output_torque=np.array([1e-6, 5.0, 12.0]))).interference
    assert values == pytest.approx(np.full(3, values[0]), rel=2e-5)


@pytest.fixture(scope="module")
def crowned(smooth):
    """The same drive with crowns of 1 m on its planets."""
    rest, compliance = smooth
    lines = CrownedLines(
        crown_curvature=jnp.array([1.0, 1.0, 1.0, 0.0, 0.0]),
        contact_length=jnp.full(5, 5e-3),
        effective_radius=jnp.array([3.1e-3, 3.6e-3, 3.6e-3, 5.7e-3, 5.7e-3]),
        contact_modulus=jnp.full(5, 113e9),
    )
    return compliance._replace(crowns=CrownsAtRest(lines, rest.normal_force / 1000.0))


@pytest.mark.slow
def test_crowns_add_the_work_of_their_approach(smooth, crowned):
    rest, compliance = smooth
    force = 0.6 * rest.normal_force
    work = jnp.sum(force * crown_compression(normal_force=force, **vars(crowned.crowns.lines)))
    added, _ = crown_interference(crowns=crowned.crowns, preload=600.0)
    assert float(added) == pytest.approx(float(work / (force[3] + force[4])), rel=1e-12)
    both = [float(interference(compliance=each, preload=600.0)) for each in (crowned, compliance)]
    assert both[0] - both[1] == pytest.approx(float(added), rel=1e-9)


@pytest.mark.slow
def test_derivative_of_the_interference(smooth, crowned):
    for compliance in (smooth[1], crowned):
        found = incremental_interference(compliance=compliance, preload=700.0)
        ends = [float(interference(compliance=compliance, preload=force)) for force in (699.0, 701.0)]
        assert float(found) == pytest.approx((ends[1] - ends[0]) / 2.0, rel=1e-6)


def test_preload_of_crowned_rollers_in_a_few_steps(crowned):
    length = interference(compliance=crowned, preload=400.0)
    found = jnp.asarray(1000.0)
    for _ in range(4):
        moved = crowned._replace(  # the same law from another reference
            secant=crowned.secant - crowned.logarithmic * jnp.log(found / 1000.0), reference=found
        )
        found = preload_of_interference(compliance=moved, interference=length)
    assert float(found) == pytest.approx(400.0, rel=1e-9)

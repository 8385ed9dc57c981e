"""The coupled matrix of a machine: the paper's joint over the wall of its ring, and signs against the assembly's."""

import math

import jax
import numpy as np
import pytest

from asperity.body.compliance import compliance_matrix
from asperity.body.coupling import coupled_compliance, machine_kernel
from asperity.drive.layout.drive import incidence

WALLS = np.array([60e-3, 30e-3, 20e-3, 15e-3, 10e-3, 6e-3, 4e-3])


@pytest.fixture(scope="module")
def joint(load_example):
    return load_example("ring_wall")


@pytest.fixture(scope="module")
def free(joint):
    """Matrices of the paper's joint at rest for every wall, free rim."""
    widths = joint.half_widths(joint.rest_forces(1000.0))
    return joint.compliance(joint.bodies(WALLS, 0.0), widths)


def test_bodies_add_up_where_they_share_contacts(joint):
    members = joint.bodies(None)[1:3]
    widths, sticks = np.array([7e-5, 8e-5, 9e-5, 6e-5, 5e-5]), np.array([6e-5, 5e-5, 4e-5, 3e-5, 2e-5])
    coupled = jax.jit(coupled_compliance)
    one = jax.jit(compliance_matrix, static_argnames=("copies", "mode_count"))
    total = coupled(
        bodies=members,
        contact_lengths=np.full((5, 1), joint.LENGTH),
        half_widths=widths[:, None],
        stick_half_widths=sticks[:, None],
    )
    expected = np.zeros((10, 10))
    for member in members:
        pick = np.array(member.contacts)
        own = one(
            body=member.body,
            contact_angles=member.contact_angles[:, 0],
            half_widths=widths[pick],
            stick_half_widths=sticks[pick],
            copies=1,
            mode_count=1,
        )
        both = np.concatenate([pick, pick + 5])
        expected[np.ix_(both, both)] += own
    assert np.asarray(total)[..., 0] == pytest.approx(expected, rel=1e-12, abs=1e-22)


def test_a_ring_alone_is_the_ring_of_all_sectors(joint):
    """One sector with its sums in closed form; contact by contact all around, where the modes are summed."""
    widths, sticks = np.array([7e-5, 8e-5, 9e-5, 6e-5, 5e-5]), np.array([6e-5, 5e-5, 4e-5, 3e-5, 2e-5])
    ring = joint.bodies(np.array([10e-3]), 3e13)[4]
    total = jax.jit(coupled_compliance)(
        bodies=[ring],
        contact_lengths=np.full((5, 1), joint.LENGTH),
        half_widths=widths[:, None],
        stick_half_widths=sticks[:, None],
    )
    pick = np.array(ring.contacts)
    own = jax.jit(compliance_matrix, static_argnames=("copies", "mode_count"))(
        body=jax.tree.map(lambda number: np.asarray(number).reshape(()), ring.body),
        contact_angles=ring.contact_angles[:, 0],
        half_widths=widths[pick],
        stick_half_widths=sticks[pick],
        copies=joint.PLANETS,
        mode_count=60,
    )
    both = np.concatenate([pick, pick + 5])
    scale = float(np.max(np.abs(own)))
    assert np.asarray(total)[np.ix_(both, both)][..., 0] == pytest.approx(
        np.asarray(own), rel=0.0, abs=1e-9 * scale
    )


def radial_only(matrix, tangential):
    """Bodies coupled radially, tangential springs local."""
    changed = matrix.copy()
    changed[5:], changed[:, 5:] = 0.0, 0.0
    changed[range(5, 10), range(5, 10)] = tangential
    return changed


#: Exact discs and a ring of free rim, radial coupling, tangential springs local; computed independently [N·m/rad].
RADIAL = np.array([32397.0, 30594.0, 27395.0, 23302.0, 15142.0, 5823.0, 2129.0])


@pytest.mark.slow
def test_stiffness_over_the_wall_with_radial_coupling(joint, free):
    widths = joint.half_widths(joint.rest_forces(1000.0))
    springs = np.stack([joint.springs(widths, wall) for wall in WALLS], axis=-1)
    assert joint.assembled_stiffness(radial_only(free, springs)) == pytest.approx(RADIAL, rel=0.02)


@pytest.mark.slow
def test_full_coupling_is_softer_the_thinner_the_ring(joint, free):
    """Tangential forces bend a ring, too: a free ring of 4 mm is 17 % softer than with radial coupling alone."""
    found = joint.assembled_stiffness(free) / RADIAL
    assert np.all(np.diff(found[:-1]) < 0.0)
    assert found[0] == pytest.approx(1.0, abs=0.02)
    assert found[-1] == pytest.approx(0.83, abs=0.01)


def test_held_by_a_rigid_housing_a_thin_ring_is_slightly_stiffer(joint):
    matrices = joint.compliance(joint.bodies(WALLS, math.inf), joint.half_widths(joint.rest_forces(1000.0)))
    held = joint.assembled_stiffness(matrices)
    assert np.all(np.diff(held) > 0.0)
    assert held[-1] < 1.15 * held[0]


@pytest.mark.parametrize(
    ("state", "change", "tolerance"), [("plane_strain", 0.027, 0.02), ("plane_stress", -0.044, 0.02)]
)
def test_exact_discs_against_springs_with_a_solid_ring(joint, state, change, tolerance):
    """+2.7 % and -4.4 % were found against springs whose tangential ones have Mindlin's ratio 0.824."""
    widths = joint.half_widths(joint.rest_forces(1000.0))
    springs = joint.springs(widths, 60e-3)
    today = joint.assembled_stiffness(np.diag(np.concatenate([springs, springs / (1.4 / 1.7)]))[..., None])
    matrix = joint.compliance(joint.bodies(None, state=state), widths)
    ring = np.array([0.0, 0.0, 0.0, 1.0, 1.0]) * (springs[3] - solid_roller(joint, widths[3]))
    exact = matrix + np.diag(np.tile(ring, 2))[..., None]
    assert float(joint.assembled_stiffness(exact)[0] / today[0]) - 1.0 == pytest.approx(change, abs=tolerance)


def solid_roller(joint, width):
    """Johnson's incremental compliance of a loading roller at its ring contact."""
    scale = (1 - joint.POISSON**2) / (math.pi * joint.YOUNG * joint.LENGTH)
    return scale * (2 * math.log(4 * joint.GEOMETRY.loading_roller_radius / width) - 2)


def test_rigid_motion_left_out_does_not_matter(joint):
    """Any rigid motion of a floating body, added to the matrix, leaves the joint as it is: all signs agree with B."""
    widths = joint.half_widths(joint.rest_forces(1000.0))
    matrix = joint.compliance(joint.bodies(np.array([10e-3])), widths)[..., 0]
    expected = joint.assembled_stiffness(matrix[..., None])
    rng = np.random.default_rng(3)
    for number in (1, 2, 3):  # planet, turning of the rollers
        member = joint.bodies(None)[number]
        angle = member.contact_angles[:, 0]
        motion = np.zeros((10, 3))
        pick = np.array(member.contacts)
        motion[pick, 0], motion[pick, 1] = np.cos(angle), np.sin(angle)
        motion[pick + 5, 0], motion[pick + 5, 1], motion[pick + 5, 2] = -np.sin(angle), np.cos(angle), 1.0
        motion = motion if number == 1 else motion[:, 2:]  # the pins hold the rollers' centres
        share = motion @ rng.normal(size=(motion.shape[1], 10)) * 1e-10
        changed = matrix + share + share.T
        assert joint.assembled_stiffness(changed[..., None]) == pytest.approx(expected, rel=1e-8)


def test_elongations_of_the_assembly_are_those_of_the_bodies(joint):
    """A disc approaches where it moves towards the contact: outward and counter-clockwise are positive in B as well."""
    matrices = incidence(joint.DRIVE)
    radii = (joint.GEOMETRY.planet_radius, *[joint.GEOMETRY.loading_roller_radius] * 2)
    # the sun, the first member, only turns
    for number, (member, radius) in enumerate(zip(joint.bodies(None)[1:], radii, strict=True)):
        angle, pick = member.contact_angles[:, 0], np.array(member.contacts)
        moved = slice(2 * number, 2 * number + 2)
        assert matrices.approach[pick, moved] == pytest.approx(
            np.stack([np.cos(angle), np.sin(angle)], 1), abs=1e-12
        )
        assert matrices.sliding[pick, moved] == pytest.approx(
            np.stack([-np.sin(angle), np.cos(angle)], 1), abs=1e-12
        )
        assert matrices.turning[pick, 1 + number] == pytest.approx(np.full(pick.size, radius), rel=1e-12)


def test_one_kernel_serves_every_load(joint):
    members = [
        jax.tree.map(lambda number: np.asarray(number).reshape(np.shape(number)[:-1]), member)
        for member in joint.bodies(np.array([10e-3]))
    ]
    kernel = jax.jit(machine_kernel)(members)
    coupled = jax.jit(coupled_compliance)
    for width in (5e-5, 2e-4):
        widths = np.full(5, width)
        given = {
            "bodies": members,
            "contact_lengths": np.full(5, joint.LENGTH),
            "half_widths": widths,
            "stick_half_widths": 0.5 * widths,
        }
        np.testing.assert_allclose(coupled(**given, kernel=kernel), coupled(**given), rtol=1e-12)

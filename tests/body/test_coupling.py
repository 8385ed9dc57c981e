"""The coupled matrix of a machine: the paper's joint over the wall of its ring, and signs against the assembly's."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.body.compliance import compliance_matrix
from asperity.body.coupling import coupled_compliance, motion_matrix
from asperity.drive.assembly import RIGID_SUPPORTS, _elongations, assembly_stiffness
from asperity.drive.geometry import triangle

WALLS = np.array([60e-3, 30e-3, 20e-3, 15e-3, 10e-3, 6e-3, 4e-3])


@pytest.fixture(scope="module")
def joint(load_example):
    return load_example("ring_wall")


@pytest.fixture(scope="module")
def free(joint):
    """Matrices of the paper's joint at rest for every wall, free rim."""
    widths = joint.half_widths(joint.rest_forces(1000.0))
    return np.moveaxis(joint.compliance(joint.bodies(WALLS, 0.0), widths, 4e-3), -1, 0)


def test_motions_are_the_elongations_of_the_assembly(joint):
    """Rigid motions move the springs as in the assembly: the signs of forces and displacements are one."""
    geometry = joint.GEOMETRY
    expected = np.asarray(jax.jacfwd(lambda q: _elongations(q, triangle(geometry), geometry))(jnp.zeros(10)))[
        :10
    ]
    columns = [np.asarray(motion_matrix(member=m, contact_count=5))[..., 0] for m in joint.bodies(None)]
    assert np.concatenate(columns, axis=1)[:, 2:] == pytest.approx(expected, abs=1e-12)


def test_a_ring_recedes_where_a_disc_approaches(joint):
    ring = joint.bodies(np.array([10e-3]))[-1]
    motion = np.asarray(motion_matrix(member=ring, contact_count=5))[..., 0]
    side = triangle(joint.GEOMETRY)
    assert motion[3] == pytest.approx([-float(side.sin_polar), -float(side.cos_polar), 0.0])
    assert motion[8] == pytest.approx([float(side.cos_polar), -float(side.sin_polar), -1.0])
    assert np.all(motion[[0, 1, 2, 5, 6, 7]] == 0.0)


def test_bodies_add_up_where_they_share_contacts(joint):
    members = joint.bodies(None)[1:3]
    widths, sticks = np.array([7e-5, 8e-5, 9e-5, 6e-5, 5e-5]), np.array([6e-5, 5e-5, 4e-5, 3e-5, 2e-5])
    coupled = jax.jit(coupled_compliance, static_argnames="mode_count")
    one = jax.jit(compliance_matrix, static_argnames=("copies", "mode_count"))
    total = coupled(
        bodies=members, half_widths=widths[:, None], stick_half_widths=sticks[:, None], mode_count=1
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


def radial_only(matrix, tangential):
    """Bodies coupled radially, tangential springs local."""
    changed = matrix.copy()
    changed[5:], changed[:, 5:] = 0.0, 0.0
    changed[range(5, 10), range(5, 10)] = tangential
    return changed


#: Exact discs and a ring of free rim, radial coupling, tangential springs local; computed independently [N·m/rad].
RADIAL = [32397.0, 30594.0, 27395.0, 23302.0, 15142.0, 5823.0, 2129.0]


def test_stiffness_over_the_wall_with_radial_coupling(joint, free):
    widths = joint.half_widths(joint.rest_forces(1000.0))
    for matrix, wall, expected in zip(free, WALLS, RADIAL, strict=True):
        local = radial_only(matrix, joint.springs(widths, wall))
        assert joint.assembled_stiffness(local) == pytest.approx(expected, rel=0.02)


def test_springs_of_contacts_are_the_assembly_of_today(joint):
    widths = joint.half_widths(joint.rest_forces(1000.0))
    springs = joint.springs(widths, 60e-3)
    expected = assembly_stiffness(
        geometry=joint.GEOMETRY,
        normal_stiffness=1.0 / jnp.asarray(springs),
        tangential_stiffness=1.0 / jnp.asarray(springs),
        supports=RIGID_SUPPORTS,
    ).stiffness.output
    assert joint.assembled_stiffness(np.diag(np.tile(springs, 2))) == pytest.approx(float(expected), rel=1e-9)


def test_full_coupling_is_softer_the_thinner_the_ring(joint, free):
    """Tangential forces bend a ring, too: a free ring of 4 mm is 17 % softer than with radial coupling alone."""
    found = np.array([joint.assembled_stiffness(matrix) for matrix in free]) / RADIAL
    assert np.all(np.diff(found[:-1]) < 0.0)
    assert found[0] == pytest.approx(1.0, abs=0.02)
    assert found[-1] == pytest.approx(0.83, abs=0.01)


def test_held_by_a_rigid_housing_a_thin_ring_is_slightly_stiffer(joint):
    matrices = joint.compliance(
        joint.bodies(WALLS, math.inf), joint.half_widths(joint.rest_forces(1000.0)), 4e-3
    )
    held = [joint.assembled_stiffness(matrix) for matrix in np.moveaxis(matrices, -1, 0)]
    assert np.all(np.diff(held) > 0.0)
    assert held[-1] < 1.15 * held[0]


@pytest.mark.parametrize(
    ("state", "change", "tolerance"), [("plane_strain", 0.027, 0.02), ("plane_stress", -0.044, 0.02)]
)
def test_exact_discs_against_springs_with_a_solid_ring(joint, state, change, tolerance):
    """+2.7 % and -4.4 % were found against springs whose tangential ones have Mindlin's ratio 0.824."""
    widths = joint.half_widths(joint.rest_forces(1000.0))
    springs = joint.springs(widths, 60e-3)
    today = joint.assembled_stiffness(np.diag(np.concatenate([springs, springs / (1.4 / 1.7)])))
    matrix = joint.compliance(joint.bodies(None, state=state), widths, 4e-3)[..., 0]
    ring = np.array([0.0, 0.0, 0.0, 1.0, 1.0]) * (springs[3] - solid_roller(joint, widths[3]))
    exact = matrix + np.diag(np.tile(ring, 2))
    assert joint.assembled_stiffness(exact) / today - 1.0 == pytest.approx(change, abs=tolerance)


def solid_roller(joint, width):
    """Johnson's incremental compliance of a loading roller at its ring contact."""
    scale = (1 - joint.POISSON**2) / (math.pi * joint.YOUNG * joint.LENGTH)
    return scale * (2 * math.log(4 * joint.GEOMETRY.loading_roller_radius / width) - 2)


def test_motion_of_balanced_loads_does_not_matter(joint):
    """What is left out as rigid motion has no effect: any share of it added to the matrix gives the same joint."""
    widths = joint.half_widths(joint.rest_forces(1000.0))
    matrix = joint.compliance(joint.bodies(None), widths, 4e-3)[..., 0]
    planet = np.asarray(motion_matrix(member=joint.bodies(None)[1], contact_count=5))[..., 0]
    rng = np.random.default_rng(3)
    share = planet @ rng.normal(size=(3, 10)) * 1e-9
    changed = matrix + share + share.T
    assert joint.assembled_stiffness(changed) == pytest.approx(joint.assembled_stiffness(matrix), rel=1e-9)

"""Planar assemblies: exact rational arithmetic, displaced circles, bodies that deform as a whole."""

from fractions import Fraction

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.assembly import branch_assembly
from asperity.drive.geometry import DriveGeometry, triangle
from asperity.drive.planar_assembly import GROUND, PlanarAssembly, elongation_matrix, spring_forces

GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.05, -0.1)
LOAD = np.eye(10)[0]
INF = np.inf


@pytest.fixture(scope="module")
def branch():
    return branch_assembly(geometry=GEOMETRY, sides=triangle(GEOMETRY))


@pytest.fixture(scope="module")
def forces(branch):
    return jax.jit(lambda c: spring_forces(assembly=branch, compliance=c, coupling=None, load=LOAD))


def exact_compliance(matrix, compliance):
    """B q = C f, B^T f = g in rational numbers; what is free without a load stays where it is."""
    present = [spring for spring, value in enumerate(compliance) if value < INF]
    springs, coordinates = len(present), matrix.shape[1]
    size = springs + coordinates
    rows = [[Fraction(0)] * (size + 1) for _ in range(size)]
    for row, spring in enumerate(present):
        rows[row][row] = -Fraction(float(compliance[spring]))
        for k in range(coordinates):
            rows[row][springs + k] = rows[springs + k][row] = Fraction(float(matrix[spring, k]))
    rows[springs][size] = Fraction(1)
    done, pivots = 0, []
    for column in range(size):
        pivot = next((row for row in range(done, size) if rows[row][column] != 0), None)
        if pivot is None:
            continue
        rows[done], rows[pivot] = rows[pivot], rows[done]
        for row in range(size):
            factor = rows[row][column] / rows[done][column] if row != done else 0
            if factor:
                rows[row] = [a - factor * b if b else a for a, b in zip(rows[row], rows[done], strict=True)]
        pivots.append(column)
        done += 1
    found = [Fraction(0)] * size
    for row, column in enumerate(pivots):
        found[column] = rows[row][size] / rows[row][column]
    return float(sum(Fraction(float(compliance[s])) * found[row] ** 2 for row, s in enumerate(present)))


def compliances():
    """Contacts alike, contacts of any softness, open contacts, slipping ones; supports from rigid to absent."""
    rng = np.random.default_rng(5)
    for low, high, open_ones in (
        (-9.5, -8.0, ()),
        (-18.0, 2.0, ()),
        (-18.0, 2.0, ()),
        (-9.5, -8.0, (2, 4, 7, 9)),  # the left side lifted
        (-9.5, -8.0, (2, 7)),  # pressed to the ring by its own mass alone
        (-12.0, -6.0, (7, 9)),  # the left side slips
        (-12.0, -6.0, (3, 8)),
    ):
        contacts = 10.0 ** rng.uniform(low, high, 10)
        contacts[list(open_ones)] = INF
        supports = 10.0 ** rng.uniform(-18.0, 0.0, 6)
        kind = rng.integers(0, 4, 6)
        supports[kind == 0], supports[kind == 1] = 0.0, INF
        supports[[0, 2]] = np.where(np.isinf(supports[[0, 2]]), 1e-9, supports[[0, 2]])
        yield np.concatenate([contacts, supports])


@pytest.mark.slow
@pytest.mark.parametrize("compliance", list(compliances()))
def test_springs_of_any_stiffness_side_by_side_to_rounding(branch, forces, compliance):
    solved = forces(jnp.asarray(compliance))
    work = np.where(np.isinf(compliance), 0.0, compliance) * np.asarray(solved.force) ** 2
    expected = exact_compliance(np.asarray(elongation_matrix(branch)), compliance)
    assert bool(solved.carried)
    assert work.sum() == pytest.approx(expected, rel=1e-13)
    assert (np.asarray(solved.force)[np.isinf(compliance)] == 0.0).all()


def test_rigid_contacts_that_share_a_force_in_any_way(branch, forces):
    compliance = np.concatenate(
        [np.zeros(5), 10.0 ** np.linspace(-9.0, -8.0, 5), [0.0, INF, 0.0, INF, INF, INF]]
    )
    work = (
        np.where(np.isinf(compliance), 0.0, compliance)
        * np.asarray(forces(jnp.asarray(compliance)).force) ** 2
    )
    assert work.sum() == pytest.approx(
        exact_compliance(np.asarray(elongation_matrix(branch)), compliance), rel=1e-12
    )


def test_a_drive_whose_sides_are_open_carries_nothing(branch, forces):
    compliance = np.full(16, 1e-8)
    compliance[[1, 2, 6, 7]] = INF  # planet touches the sun alone
    compliance[14:] = INF
    solved = forces(jnp.asarray(compliance))
    assert not bool(solved.carried)
    assert bool(jnp.all(jnp.isfinite(solved.force)))


def test_elongations_by_displacing_circles():
    """Two rollers in a ring: gaps and travelled arcs under a small displacement of each body."""
    centres = np.array([[0.0, 0.0], [0.012, 0.02]])
    inner, outer = 0.01, np.hypot(*centres[1]) - 0.01
    ring_contact = centres[1] / np.hypot(*centres[1])
    assembly = PlanarAssembly(
        free=((True, True, True), (True, True, True)),
        contacts=((0, 1, 1), (1, GROUND, -1)),
        supports=(0, 0, 1, 1),
        contact_direction=jnp.asarray([ring_contact, ring_contact]),
        support_direction=jnp.asarray([[1.0, 0.0], [0.0, 1.0]] * 2),
    )
    found = np.asarray(elongation_matrix(assembly))
    step = 1e-7
    ring = np.hypot(*centres[1]) + outer
    expected = np.zeros((8, 6))
    for k in range(6):
        body, axis = divmod(k, 3)
        moved = centres.copy()
        turns = np.zeros(2)
        if axis < 2:
            moved[body, axis] += step
        else:
            turns[body] = step  # arc length
        axis_of_pair = moved[1] - moved[0]
        expected[0, k] = (inner + outer - np.hypot(*axis_of_pair)) / step
        expected[1, k] = (np.hypot(*moved[1]) + outer - ring) / step
        left = np.array([-ring_contact[1], ring_contact[0]])
        # travel of the material at the contact along the left-hand direction, first body minus second
        travel = [(moved[j] - centres[j]) @ left for j in (0, 1)]
        expected[2, k] = (travel[0] + turns[0] - (travel[1] - turns[1])) / step
        expected[3, k] = (travel[1] + turns[1]) / step
        expected[4:, k] = (moved - centres).ravel() / step
    np.testing.assert_allclose(found, expected, atol=1e-5)


@pytest.mark.slow
def test_bodies_that_deform_as_a_whole_by_a_dense_solution(branch):
    """B q − C f = 0, B^T f = g with a full matrix C, solved as it stands."""
    rng = np.random.default_rng(2)
    half = rng.normal(size=(10, 10))
    full = np.zeros((16, 16))
    full[:10, :10] = 1e-9 * (half @ half.T + 10.0 * np.eye(10))
    own = np.concatenate([np.diag(full)[:10], [0.0, INF, 3e-9, INF, INF, INF]])
    coupling = full - np.diag(np.diag(full))
    solved = spring_forces(
        assembly=branch, compliance=jnp.asarray(own), coupling=jnp.asarray(coupling), load=LOAD
    )
    present = np.isfinite(own)
    matrix = np.asarray(elongation_matrix(branch))[present]
    compliance = (coupling + np.diag(np.where(present, own, 0.0)))[np.ix_(present, present)]
    system = np.block([[-compliance, matrix], [matrix.T, np.zeros((10, 10))]])
    expected = np.linalg.solve(system, np.concatenate([np.zeros(present.sum()), LOAD]))[: present.sum()]
    np.testing.assert_allclose(np.asarray(solved.force)[present], expected, rtol=1e-9, atol=1e-9)


@pytest.mark.slow
def test_gradients_by_compliance_and_direction_are_those_of_the_work(branch):
    """The work of a unit load changes by f_j^2 with compliance j (Castigliano), also for one of compliance 0."""
    own = jnp.concatenate([jnp.linspace(1e-9, 8e-9, 10), jnp.array([0.0, 5e-8, 1e-9, INF, INF, 2e-8])])
    finite = jnp.where(jnp.isinf(own), 0.0, own)

    def work(change, direction):
        moved = PlanarAssembly(
            branch.free, branch.contacts, branch.supports, direction, branch.support_direction
        )
        force = spring_forces(assembly=moved, compliance=own + change, coupling=None, load=LOAD).force
        return jnp.sum((finite + change) * force**2), force

    (_, force), slopes = jax.jit(jax.value_and_grad(work, argnums=(0, 1), has_aux=True))(
        jnp.zeros(16), branch.contact_direction
    )
    present = np.isfinite(np.asarray(own))
    np.testing.assert_allclose(np.asarray(slopes[0])[present], np.asarray(force)[present] ** 2, rtol=1e-9)
    step = 1e-6 * np.random.default_rng(0).normal(size=branch.contact_direction.shape)
    change = [work(jnp.zeros(16), branch.contact_direction + sign * step)[0] for sign in (1.0, -1.0)]
    assert float(jnp.sum(slopes[1] * step)) == pytest.approx(
        0.5 * float(change[0] - change[1]), rel=1e-5, abs=0.0
    )


@pytest.mark.slow
def test_an_assembly_that_hangs_in_the_air_is_refused():
    loose = PlanarAssembly(
        free=((False, False, True), (False, False, True)),
        contacts=((0, 1, 1),),
        supports=(),
        contact_direction=jnp.asarray([[0.0, 1.0]]),
        support_direction=jnp.zeros((0, 2)),
    )
    with pytest.raises(ValueError, match="by any chain of contacts"):
        spring_forces(assembly=loose, compliance=jnp.ones(2), coupling=None, load=np.array([1.0, 0.0]))

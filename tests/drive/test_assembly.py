"""The assembled stiffness (A8) against a dense independent assembly of all branches, and against (A7)."""

import math
import sys
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from asperity.contact.interface import series_stiffness
from asperity.drive.assembly import IDEAL_STRUCTURE, StructureSprings, assembly_stiffness
from asperity.drive.geometry import CONTACT_NAMES, DriveGeometry, speed_ratio, triangle
from asperity.drive.torsional_stiffness import series_torsional_stiffness

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
#: printed by benchmarks/baseline_assembly.py, an assembly written independently in NumPy (0 N·m, 0 rpm)
TILTED = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.2, -0.1)

solve = jax.jit(
    lambda geometry, normal, tangential, structure: assembly_stiffness(
        geometry=geometry,
        sides=triangle(geometry),
        normal_stiffness=normal,
        tangential_stiffness=tangential,
        structure=structure,
    )
)


@pytest.fixture(scope="module")
def dense_assembly():
    """The dense baseline: all planets, the sun free to move sideways, rigid springs as constraints."""
    folder = str(Path(__file__).parents[2] / "benchmarks")
    sys.path.insert(0, folder)
    try:
        from baseline_assembly import torsional_stiffness_of_assembly
    finally:
        sys.path.remove(folder)
    return torsional_stiffness_of_assembly


def shares(assembly):
    parts = (
        assembly.tangential_share,
        assembly.normal_share,
        assembly.ring_bending_share,
        assembly.pin_share,
        assembly.planet_support_share,
        assembly.input_shaft_share,
        assembly.output_shaft_share,
    )
    return sum(float(jnp.sum(part)) for part in parts)


@pytest.mark.parametrize(
    ("pin", "across", "geometry"),
    [
        (math.inf, 0.0, PAPER),
        (1e8, 0.0, PAPER),
        (3e7, 2e7, PAPER),
        (5e7, 1e7, TILTED),
        (math.inf, 0.0, TILTED),
    ],
)
def test_agrees_with_the_dense_assembly_of_all_branches(dense_assembly, pin, across, geometry):
    rng = np.random.default_rng(7)
    normal, tangential = rng.uniform(5e7, 5e8, 5), rng.uniform(5e7, 5e9, 5)
    names = {
        "sun_radius": 4e-3, "planet_radius": 13.5e-3, "loading_roller_radius": 5e-3, "ring_radius": 40e-3, "planets": 3,
        "push_angle_left": float(geometry.left_push_angle), "push_angle_right": float(geometry.right_push_angle),
    }  # fmt: skip
    expected = dense_assembly(
        names,
        dict(zip(CONTACT_NAMES, normal, strict=True)),
        dict(zip(CONTACT_NAMES, tangential, strict=True)),
        pin=pin,
        pin_across=across,
    )
    structure = StructureSprings(pin, across, 0.0, math.inf, math.inf, math.inf)
    ours = solve(geometry, jnp.asarray(normal), jnp.asarray(tangential), structure)
    assert float(ours.stiffness.sun) == pytest.approx(expected, rel=1e-9)
    assert float(ours.stiffness.output) == pytest.approx(81.0 * expected, rel=1e-9)
    assert shares(ours) == pytest.approx(1.0, abs=1e-12)


def test_rigid_normal_springs_and_pins_give_the_published_series_exactly():
    rigid = jnp.full(5, jnp.inf)
    tangential = jnp.array([1e8, 2e8, 2e8, 3e8, 3e8])  # both sides alike, as in (A7)
    ours = solve(PAPER, rigid, tangential, IDEAL_STRUCTURE)
    series = series_torsional_stiffness(geometry=PAPER, tangential_stiffness=tangential)
    assert float(ours.stiffness.sun) == pytest.approx(float(series.sun), rel=1e-9)


def test_rigid_normal_springs_put_each_side_in_series_first():
    """With unlike sides the machine is not (28), (29): a roller cannot pass one side's force to the other."""
    rigid = jnp.full(5, jnp.inf)
    sp, pwr, pwl, wro, wlo = tangential = jnp.array([1e8, 2e8, 1e8, 3e8, 0.5e8])
    sides = 1.0 / (1.0 / pwr + 1.0 / wro) + 1.0 / (1.0 / pwl + 1.0 / wlo)
    expected = 3.0 * 4e-3**2 / (1.0 / sp + 1.0 / sides)
    ours = solve(PAPER, rigid, tangential, IDEAL_STRUCTURE)
    assert float(ours.stiffness.sun) == pytest.approx(float(expected), rel=1e-9)


def test_shafts_are_in_series_on_their_own_side():
    normal, tangential = jnp.full(5, 1e8), jnp.full(5, 2e8)
    bare = solve(PAPER, normal, tangential, IDEAL_STRUCTURE)
    shafts = StructureSprings(math.inf, 0.0, 0.0, math.inf, 300.0, 2e4)
    ours = solve(PAPER, normal, tangential, shafts)
    ratio = float(speed_ratio(PAPER)) ** 2
    expected = 1.0 / (1.0 / float(bare.stiffness.output) + 1.0 / (300.0 * ratio) + 1.0 / 2e4)
    assert float(ours.stiffness.output) == pytest.approx(expected, rel=1e-10)
    assert float(ours.output_shaft_share) == pytest.approx(expected / 2e4, rel=1e-10)
    assert shares(ours) == pytest.approx(1.0, abs=1e-12)


def test_ring_bending_acts_as_a_spring_in_series_with_the_ring_contacts():
    normal, tangential = jnp.array([1e8, 1e8, 1e8, 2e8, 2e8]), jnp.full(5, 2e8)
    ring = StructureSprings(math.inf, 0.0, 0.0, 3e8, math.inf, math.inf)
    softer = normal.at[3:].set(1.0 / (1.0 / 2e8 + 1.0 / 3e8))
    ours = solve(PAPER, normal, tangential, ring)
    expected = solve(PAPER, softer, tangential, IDEAL_STRUCTURE)
    assert float(ours.stiffness.sun) == pytest.approx(float(expected.stiffness.sun), rel=1e-10)
    assert shares(ours) == pytest.approx(1.0, abs=1e-12)


def test_a_held_planet_does_not_float():
    normal, tangential = jnp.full(5, 1e8), jnp.full(5, 2e8)
    held = StructureSprings(math.inf, math.inf, math.inf, math.inf, math.inf, math.inf)
    ours = solve(PAPER, normal, tangential, held)
    series = series_torsional_stiffness(geometry=PAPER, tangential_stiffness=tangential)
    assert float(ours.stiffness.sun) == pytest.approx(float(series.sun), rel=1e-9)
    floating = solve(PAPER, normal, tangential, IDEAL_STRUCTURE)
    assert float(floating.stiffness.sun) < 0.5 * float(ours.stiffness.sun)


def test_a_lifted_side_leaves_the_other_one_carrying():
    normal, tangential = jnp.full(5, 1e8), jnp.full(5, 2e8)
    gone = jnp.array([1.0, 1.0, 0.0, 1.0, 0.0])
    one_sided = solve(PAPER, normal * gone, tangential * gone, IDEAL_STRUCTURE)
    both = solve(PAPER, normal, tangential, IDEAL_STRUCTURE)
    assert 0.0 < float(one_sided.stiffness.sun) < float(both.stiffness.sun)
    nothing = solve(PAPER, normal, tangential * jnp.array([0.0, 1.0, 1.0, 1.0, 1.0]), IDEAL_STRUCTURE)
    assert float(nothing.stiffness.sun) == 0.0


def test_gradient_matches_finite_differences():
    normal, tangential = jnp.full(5, 1e8), jnp.linspace(1e8, 3e8, 5)

    def stiffness(k):
        return assembly_stiffness(
            geometry=PAPER,
            sides=triangle(PAPER),
            normal_stiffness=k,
            tangential_stiffness=tangential,
            structure=IDEAL_STRUCTURE,
        ).stiffness.sun

    stiffness = jax.jit(stiffness)
    slope = jax.jit(jax.grad(stiffness))(normal)
    step = 1e3
    for i in (1, 3):
        move = jnp.zeros(5).at[i].set(step)
        difference = (stiffness(normal + move) - stiffness(normal - move)) / (2.0 * step)
        assert float(slope[i]) == pytest.approx(float(difference), rel=1e-5)


exponents = st.floats(-3.0, 18.0)
springs = st.one_of(st.just(0.0), st.just(math.inf), exponents.map(lambda e: 10.0**e))


@pytest.fixture(scope="module")
def three_levels():
    """Published, series and assembled stiffness of a drive from the springs of its contacts."""

    @jax.jit
    def levels(rough_normal, rough, bulk, geometry, structure):
        both = series_stiffness(rough, bulk)
        return (
            series_torsional_stiffness(geometry=geometry, tangential_stiffness=rough).output,
            series_torsional_stiffness(geometry=geometry, tangential_stiffness=both).output,
            assembly_stiffness(
                geometry=geometry,
                sides=triangle(geometry),
                normal_stiffness=series_stiffness(rough_normal, bulk),
                tangential_stiffness=both,
                structure=structure,
            ).stiffness.output,
        )

    return levels


@pytest.mark.slow
@settings(max_examples=150, deadline=None)
@given(
    contacts=st.lists(exponents.map(lambda e: 10.0**e), min_size=15, max_size=15),
    held=st.lists(springs, min_size=6, max_size=6),
    push=st.floats(-0.5, 0.5),
    ring=st.floats(39e-3, 40.5e-3),
)
def test_each_level_adds_compliance_whatever_the_springs(three_levels, contacts, held, push, ring):
    """A bound of mechanics: a constraint more never softens, a spring more never stiffens."""
    rough_normal, rough, bulk = np.array(contacts).reshape(3, 5)
    geometry = DriveGeometry(4e-3, 13.5e-3, 5e-3, ring, 3.0, push, -push)
    published, series, assembled = map(
        float, three_levels(rough_normal, rough, bulk, geometry, StructureSprings(*map(np.float64, held)))
    )
    assert published >= series * (1.0 - 1e-12)
    assert series >= assembled * (1.0 - 1e-12)
    assert assembled >= 0.0


def test_very_stiff_springs_are_as_good_as_rigid_ones():
    """Pins of 1e15 N/mm made the assembly 3.9 % stiffer than rigid ones when rigid meant a share of the stiffest."""
    normal, tangential = jnp.full(5, 1e8), jnp.full(5, 2e8)
    rigid = solve(PAPER, normal, tangential, IDEAL_STRUCTURE)
    stiff = solve(PAPER, normal, tangential, StructureSprings(1e18, 0.0, 0.0, math.inf, math.inf, math.inf))
    assert float(stiff.stiffness.sun) == pytest.approx(float(rigid.stiffness.sun), rel=1e-9)
    assert float(stiff.stiffness.sun) <= float(rigid.stiffness.sun) * (1.0 + 1e-14)
    assert float(stiff.pin_share) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.slow
def test_coupled_contacts_have_a_share_each():
    normal, tangential = jnp.full(5, 1e8), jnp.full(5, 2e8)
    plain = solve(PAPER, normal, tangential, IDEAL_STRUCTURE)
    coupling = jnp.zeros((10, 10)).at[1, 6].set(1e-10).at[6, 1].set(1e-10)
    coupled = assembly_stiffness(
        geometry=PAPER,
        sides=triangle(PAPER),
        normal_stiffness=normal,
        tangential_stiffness=tangential,
        structure=IDEAL_STRUCTURE,
        coupling=coupling,
    )
    assert shares(coupled) == pytest.approx(1.0, abs=1e-12)
    assert float(coupled.stiffness.sun) != pytest.approx(float(plain.stiffness.sun), rel=1e-4)

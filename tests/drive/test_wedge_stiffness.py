"""The stiffness (A8) of the paper's drive against a dense independent assembly of all branches, and against (A7)."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from asperity.contact.interface import series_stiffness
from asperity.drive.layout.drive import Closure
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.stiffness.network import network_stiffness
from asperity.drive.types.wedge import EQUAL_COEFFICIENTS, wedge_drive
from asperity.zou2025.kinematics import CONTACT_NAMES
from asperity.zou2025.series_stiffness import series_torsional_stiffness

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
#: Seven rigid springs hold the three centres of a branch in six ways: nearly rigid ones have forces of their own.
RIGID = np.full(5, 1e18)
TILTED = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.2, -0.1)


@jax.jit
def _solved(geometry, normal, tangential, pin):
    return network_stiffness(
        drive=wedge_drive(geometry, planet_count=3),
        normal_compliance=1.0 / normal,
        tangential_compliance=1.0 / tangential,
        pin_compliance=pin,
    )


def solve(geometry, normal, tangential, pin=0.0):
    return _solved(geometry, np.asarray(normal), np.asarray(tangential), np.asarray(pin))


def shares(found):
    parts = (found.tangential_share, found.normal_share, found.pin_share)
    return sum(float(jnp.sum(part)) for part in parts)


@pytest.mark.parametrize(
    ("pin", "geometry"), [(np.inf, PAPER), (1e8, PAPER), (5e7, TILTED), (np.inf, TILTED)]
)
def test_agrees_with_the_dense_assembly_of_all_branches(dense_assembly, pin, geometry):
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
        pin_across=0.0,
    )
    ours = solve(geometry, normal, tangential, 1.0 / pin)
    assert float(ours.output) == pytest.approx(81.0 * expected, rel=1e-8)
    assert shares(ours) == pytest.approx(1.0, abs=1e-9)


def test_rigid_normal_springs_and_pins_give_the_published_series():
    tangential = np.array([1e8, 2e8, 2e8, 3e8, 3e8])  # both sides alike, as in (A7)
    ours = solve(PAPER, RIGID, tangential)
    series = series_torsional_stiffness(geometry=PAPER, tangential_stiffness=tangential)
    assert float(ours.output) == pytest.approx(float(series.output), rel=1e-8)


def test_rigid_normal_springs_put_each_side_in_series_first():
    """With unlike sides the machine is not (28), (29): a roller cannot pass one side's force to the other."""
    sp, pwr, pwl, wro, wlo = tangential = np.array([1e8, 2e8, 1e8, 3e8, 0.5e8])
    sides = 1.0 / (1.0 / pwr + 1.0 / wro) + 1.0 / (1.0 / pwl + 1.0 / wlo)
    expected = 81.0 * 3.0 * 4e-3**2 / (1.0 / sp + 1.0 / sides)
    ours = solve(PAPER, RIGID, tangential)
    assert float(ours.output) == pytest.approx(float(expected), rel=1e-8)


@pytest.mark.parametrize("closure", [Closure(), Closure(equal_coefficients=EQUAL_COEFFICIENTS)])
def test_with_held_centres_rollers_turn_alike_only_by_the_papers_closure(closure):
    """Each side in series first, as above; (28) and (29) add both contacts of a planet, and both of the ring, first."""
    sp, pwr, pwl, wro, wlo = tangential = np.array([1e8, 2e8, 1e8, 3e8, 0.5e8])
    one_by_one = 1.0 / (1.0 / pwr + 1.0 / wro) + 1.0 / (1.0 / pwl + 1.0 / wlo)
    alike = 1.0 / (1.0 / (pwr + pwl) + 1.0 / (wro + wlo))
    sides = alike if closure.equal_coefficients else one_by_one
    found = network_stiffness(
        drive=wedge_drive(PAPER, planet_count=3, closure=closure),
        normal_compliance=None,
        tangential_compliance=1.0 / tangential,
    )
    expected = 81.0 * 3.0 * 4e-3**2 / (1.0 / sp + 1.0 / sides)
    assert float(found.output) == pytest.approx(float(expected), rel=1e-8)


def test_very_stiff_springs_are_as_good_as_rigid_ones():
    """Pins of 1e15 N/mm made the assembly 3.9 % stiffer than rigid ones when rigid meant a share of the stiffest."""
    normal, tangential = np.full(5, 1e8), np.full(5, 2e8)
    rigid, stiff = (float(solve(PAPER, normal, tangential, pin).output) for pin in (0.0, 1e-18))
    assert stiff == pytest.approx(rigid, rel=1e-8)


@pytest.mark.slow
def test_coupled_contacts_have_a_share_each():
    normal, tangential = np.full(5, 1e8), np.full(5, 2e8)
    coupling = np.zeros((10, 10))
    coupling[1, 6] = coupling[6, 1] = 1e-10
    plain = solve(PAPER, normal, tangential)
    coupled = network_stiffness(
        drive=wedge_drive(PAPER, planet_count=3),
        normal_compliance=1.0 / normal,
        tangential_compliance=1.0 / tangential,
        coupling=coupling,
    )
    assert shares(coupled) == pytest.approx(1.0, abs=1e-9)
    assert float(coupled.output) != pytest.approx(float(plain.output), rel=1e-4)


exponents = st.floats(-3.0, 18.0)


@pytest.fixture(scope="module")
def three_levels():
    """Published, series and assembled stiffness of a drive from the springs of its contacts."""

    @jax.jit
    def levels(rough_normal, rough, bulk, geometry, pin):
        both = series_stiffness(rough, bulk)
        held = {"drive": wedge_drive(geometry, planet_count=3), "tangential_compliance": 1.0 / both}
        normal = 1.0 / series_stiffness(rough_normal, bulk)
        return (
            series_torsional_stiffness(geometry=geometry, tangential_stiffness=rough).output,
            series_torsional_stiffness(geometry=geometry, tangential_stiffness=both).output,
            network_stiffness(normal_compliance=normal, pin_compliance=pin, **held).output,
        )

    return levels


@pytest.mark.slow
@settings(max_examples=150, deadline=None)
@given(
    contacts=st.lists(exponents.map(lambda e: 10.0**e), min_size=15, max_size=15),
    pin=st.one_of(st.just(0.0), exponents.map(lambda e: 10.0**-e)),
    push=st.floats(-0.5, 0.5),
    ring=st.floats(39e-3, 40.5e-3),
)
def test_each_level_adds_compliance_whatever_the_springs(three_levels, contacts, pin, push, ring):
    """A bound of mechanics: a constraint more never softens, a spring more never stiffens."""
    rough_normal, rough, bulk = np.array(contacts).reshape(3, 5)
    geometry = DriveGeometry(4e-3, 13.5e-3, 5e-3, ring, 3.0, push, -push)
    published, series, assembled = map(float, three_levels(rough_normal, rough, bulk, geometry, pin))
    assert published >= series * (1.0 - 1e-9)
    assert series >= assembled * (1.0 - 1e-9)
    assert assembled >= 0.0

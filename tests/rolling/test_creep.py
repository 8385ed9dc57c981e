"""Creep of the contacts: Carter's limit, the layer's compliance by hand, and skew."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import brentq

from asperity.contact import carter
from asperity.contact.creep_layer import layer_creepage_factor
from asperity.contact.skew import skewed_slip_ratios
from asperity.drive.state.creep import drift_per_turn
from asperity.joint.contacts import rough_joint_contacts
from asperity.joint.crowned_contacts import rough_slices
from asperity.joint.description import joint_contacts
from asperity.rolling.creep import capacity_loss, contact_creep, lateral_slip_ratio

NORMAL = np.array([1000.0, 600.0, 500.0, 600.0, 500.0])
RADIUS = np.array([4.0 * 13.5 / 17.5, *[13.5 * 5.0 / 18.5] * 2, *[5.0 * 40.0 / 35.0] * 2]) * 1e-3
LENGTH, MODULUS, FRICTION = 5e-3, 206e9 / (2.0 * 0.91), 0.12
WIDTH = np.sqrt(4.0 * NORMAL * RADIUS / (math.pi * LENGTH * MODULUS))
KAPPA = 2.0 * 0.7 / 1.7  # tangential over normal stiffness of the asperities (Mindlin)
CARTER = FRICTION * WIDTH / RADIUS  # creepage at gross slip


@pytest.fixture
def creep(paper_joint, monkeypatch):
    """The law on asperities of a given stiffness; None for that of the contact law."""

    def of(stiffness, skew=None, slip_ratio=0.4, crown=None):
        crowned = {} if crown is None else {"drive__planet_crown_radius": 1.0 / crown}
        given = SimpleNamespace(layer_stiffness=None if stiffness is None else np.full(5, stiffness))
        with monkeypatch.context() as patch:
            if stiffness is not None:
                patch.setattr("asperity.rolling.creep.rough_joint_contacts", lambda **forces: given)
            return contact_creep(
                contacts=joint_contacts(paper_joint(**crowned)),
                skew=skew,
                normal_force=np.asarray(NORMAL),
                tangential_force=np.asarray(slip_ratio * FRICTION * NORMAL),
            )

    return of


def test_stiff_asperities_leave_carters_creep(creep):
    found = creep(1e20)
    np.testing.assert_allclose(found.layer_factor, 1.0, rtol=1e-6)
    np.testing.assert_allclose(found.law.gross_slip_scale * np.sqrt(NORMAL), CARTER, rtol=1e-6)
    np.testing.assert_array_equal(found.skew_factor, 1.0)
    assert found.parallel
    assert found.crown_factor is None


def test_ratio_of_the_layer(creep):
    """u_0 R/a^2 with u_0 = N/K_n and Hertz's half-width."""
    stiffness = 3e9
    found = creep(stiffness)
    np.testing.assert_allclose(found.layer_ratio, NORMAL / stiffness * RADIUS / WIDTH**2, rtol=1e-12)
    factor = layer_creepage_factor(layer_ratio=found.layer_ratio, slip_ratio=0.4, stiffness_ratio=KAPPA)
    np.testing.assert_allclose(found.layer_factor, factor, rtol=1e-12)
    # a soft layer makes the strip creep more
    assert np.all(np.asarray(creep(3e8).layer_factor) > np.asarray(found.layer_factor))


@pytest.mark.parametrize("skew", [None, (5e-4,)])
def test_the_law_is_finite_at_rest_and_beyond_friction(creep, skew):
    """Where a search for a state may pass by."""
    for q in (0.0, 1.5):
        assert np.all(np.isfinite(creep(1e9, skew=skew, slip_ratio=q).law.gross_slip_scale))


def test_stiffness_of_the_contact_law_where_none_is_given(creep, paper_joint):
    rough = rough_joint_contacts(
        contacts=joint_contacts(paper_joint()),
        normal_force=np.asarray(NORMAL),
        tangential_force=np.zeros(5),
    )
    found = creep(None)
    np.testing.assert_allclose(
        found.layer_ratio, math.pi * MODULUS * LENGTH / (4.0 * rough.normal_stiffness), rtol=1e-12
    )


def test_contacts_without_an_elastic_spot_have_no_creep(creep):
    assert np.all(np.isnan(np.asarray(creep(0.0).law.gross_slip_scale)))


def test_skew_adds_creep_and_takes_friction(creep):
    """Small angles: friction acts along the creepage's direction, so that the axial force grows in proportion."""
    stiff = {"friction_coefficient": FRICTION, "width_over_radius": WIDTH / RADIUS}
    parallel = creep(1e20)
    along = 0.4 * np.asarray(CARTER)
    np.testing.assert_array_equal(lateral_slip_ratio(creep=parallel, creepage=along, **stiff), 0.0)
    np.testing.assert_array_equal(capacity_loss(creep=parallel, **stiff), 0.0)
    little, twice = (creep(1e20, skew=(angle,)) for angle in (1e-6, 2e-6))
    assert not little.parallel
    first, second = (lateral_slip_ratio(creep=skewed, creepage=along, **stiff) for skewed in (little, twice))
    lost = capacity_loss(creep=little, **stiff)
    np.testing.assert_allclose(np.asarray(second) / np.asarray(first), 2.0, rtol=1e-3)
    assert np.all(np.asarray(lost) >= 0.0)
    assert np.all(np.asarray(lost) < 1e-3)
    strong = creep(1e20, skew=(5e-3,))
    assert np.all(np.asarray(strong.skew_factor) > 1.0)


@pytest.mark.slow
def test_skewed_contacts_on_a_soft_layer_carry_their_force(creep):
    """The zone that slips is that of both forces together, and so is the layer's factor: a fixed point by hand."""
    q, skew, elastic = 0.4, 1e-3, 1.0 / 0.7
    found = creep(3e9, skew=(skew,))
    for contact, width in enumerate(CARTER):
        combined = q
        for _ in range(40):
            layer, softer = (
                float(
                    layer_creepage_factor(
                        layer_ratio=found.layer_ratio[contact], slip_ratio=combined, stiffness_ratio=stiffness
                    )
                )
                for stiffness in (KAPPA, KAPPA * elastic)
            )
            limits = {
                "gross_slip_creepage": width * layer,
                "lateral_gross_slip_creepage": width * softer * elastic,
            }

            def forces(along, limits=limits):
                return skewed_slip_ratios(longitudinal_creepage=along, lateral_creepage=skew, **limits)

            along = brentq(lambda creepage: float(forces(creepage)[0]) - q, 0.0, 10.0 * width, xtol=1e-15)
            combined = math.hypot(*map(float, forces(along)))
        assert combined > 1.03 * q
        assert float(found.layer_factor[contact]) == pytest.approx(layer, rel=1e-4)
        assert float(found.lateral_ratio[contact]) == pytest.approx(elastic * softer / layer, rel=1e-4)
        scale = float(found.law.gross_slip_scale[contact]) * math.sqrt(NORMAL[contact])
        assert float(carter.creepage(slip_ratio=q, gross_slip_creepage=scale)) == pytest.approx(
            along, rel=1e-4
        )


def test_across_alone_the_layer_is_that_of_the_axial_force(creep):
    """Without a force along, skew is Carter's problem turned by a quarter: same law, softer bodies."""
    skew, elastic = 2e-3, 1.0 / 0.7
    found = creep(3e9, skew=(skew,), slip_ratio=0.0)
    for contact, width in enumerate(CARTER):

        def too_much(axial, contact=contact, width=width):
            factor = layer_creepage_factor(
                layer_ratio=found.layer_ratio[contact], slip_ratio=axial, stiffness_ratio=KAPPA * elastic
            )
            return float(width * elastic * factor * (1.0 - math.sqrt(1.0 - axial))) - skew

        axial = brentq(too_much, 1e-3, 0.999)
        limits = {"friction_coefficient": FRICTION, "width_over_radius": width / FRICTION}
        got = lateral_slip_ratio(creep=found, creepage=np.zeros(5), **limits)[contact]
        assert axial > 0.3
        assert float(got) == pytest.approx(axial, abs=5e-4)  # the law repeats its factors three times


@pytest.mark.parametrize("crown", [None, 2.0])
def test_what_skew_takes_by_its_own_formulas(creep, crown):
    """z = gamma/xi_y,max leaves sqrt((1 - z^2)/(1 - z^2 + rho z^2)) at gross slip, with rho = xi_y,max/xi_x,max."""
    skew = 1e-3
    found = creep(3e9, skew=(skew,), crown=crown)
    limit = CARTER * np.asarray(found.layer_factor)
    limit = limit if crown is None else limit * np.asarray(found.crown_factor)
    ratio = np.asarray(found.lateral_ratio)
    zeta = skew / (limit * ratio)
    given = {"friction_coefficient": FRICTION, "width_over_radius": WIDTH / RADIUS}
    left = np.sqrt((1.0 - zeta**2) / (1.0 - zeta**2 + ratio * zeta**2))
    np.testing.assert_allclose(capacity_loss(creep=found, **given), 1.0 - left, rtol=1e-9)
    assert np.all(left < 0.99)
    along = 0.3 * limit
    length = np.hypot(0.3, zeta)
    turned = zeta * ratio ** (length / (4.0 - 2.0 * length))
    expected = (1.0 - (1.0 - length) ** 2) * turned / np.hypot(0.3, turned)
    lateral = lateral_slip_ratio(creep=found, creepage=np.asarray(along), **given)
    np.testing.assert_allclose(lateral, expected, rtol=1e-9)


def test_crowned_contacts_creep_as_their_slices(creep, paper_joint):
    """Smooth: where Carter's slices carry 0.4 of friction, by bisection. Rough: the even contacts as before."""
    q, crown = 0.4, 2.0
    found = creep(1.0, crown=crown)  # the asperities of every slice are those of its load
    joint = paper_joint(drive__planet_crown_radius=1.0 / crown)
    contacts = joint_contacts(joint)
    lines = contacts.loads_along(np.asarray(NORMAL))
    load = np.asarray(lines.line_load * lines.length_share) * LENGTH
    limit = FRICTION * np.asarray(lines.half_width) / RADIUS
    for place in range(5):
        share, at_slip = load[:, place] / NORMAL[place], limit[:, place]

        def missing(xi, share=share, at_slip=at_slip):
            return np.sum(share * (1.0 - np.maximum(1.0 - xi / at_slip, 0.0) ** 2)) - q

        even = CARTER[place] * (1.0 - math.sqrt(1.0 - q))
        expected = brentq(missing, 0.0, at_slip.max(), rtol=1e-13) / even
        assert float(found.crown_factor[place]) == pytest.approx(expected, rel=1e-8)
    assert float(found.crown_factor[0]) > 1.01  # narrower on average
    rough = rough_slices(
        pairs=contacts.pairs,
        model=contacts.contact_factor_model,
        lines=lines,
        normal_force=np.asarray(NORMAL),
        tangential_force=np.zeros(5),
    ).layer_stiffness[0]
    for place in (3, 4):
        even = creep(float(rough[place])).layer_factor[place]
        assert even > 1.01
        assert float(found.layer_factor[place]) == pytest.approx(float(even), rel=1e-9)
    scale = CARTER * np.asarray(found.crown_factor * found.layer_factor)
    np.testing.assert_allclose(found.law.gross_slip_scale * np.sqrt(NORMAL), scale, rtol=1e-9)


def test_drift_of_a_turn_of_the_output():
    """A share of a fifth lost: the input has to turn a quarter more."""
    np.testing.assert_allclose(
        drift_per_turn(np.array([0.2, 0.0, -0.25])), 2 * np.pi * np.array([0.25, 0.0, -0.2])
    )

"""Steady rolling against Carter, CONTACT, a brush, and symmetries of friction."""

import numpy as np
import pytest

from asperity.bem import (
    ElasticPair,
    FreeHalfSpace,
    elastic_pair,
    normal_contact,
    steady_rolling,
)
from asperity.errors import InputError, NoSolutionError


def line_contact(cells=200, poisson_ratio=0.3):
    """Half-width 1, contact modulus 2, largest traction 1: gross slip begins at creepage 1."""
    pixel = 2.0 / cells
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=1.0 - poisson_ratio, dundurs_constant=0.0)
    strip = FreeHalfSpace(pair, shape=(cells,), pixel_size=(pixel,), reference_distance=10.0)
    edge = np.linspace(-1.0, 1.0, cells + 1)
    integral = 0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))
    return strip, np.diff(integral) / pixel


def solved(contact, **given):
    strip, pressure = contact
    arguments = {"friction_coefficient": 1.0, "layer_compliance": 0.0} | given
    if not {"lateral_creepage", "lateral_force"} & given.keys():
        arguments["lateral_creepage"] = 0.0
    return steady_rolling(strip, pressure, **arguments)


def load(contact):
    return contact[1].sum() * float(contact[0].pixel_size[0])


def carter(q):
    """Creepage over mu a/R; Johnson 1985, section 8.3."""
    return 1.0 - np.sqrt(1.0 - q)


@pytest.fixture(scope="module")
def contact():
    return line_contact()


@pytest.mark.slow
@pytest.mark.parametrize("q", [0.1, 0.25, 0.5, 0.8, 0.95])
def test_carters_creepage_and_its_convergence(q):
    errors = []
    for cells in (100, 200, 400):
        contact = line_contact(cells)
        found = solved(contact, longitudinal_force=q * load(contact))
        errors.append(1.0 - float(found.creepage[0]) / carter(q))
    assert 0.0 < errors[1] < 5e-3
    np.testing.assert_allclose(np.array(errors[:-1]) / errors[1:], 2.0, rtol=0.05)


def test_carters_traction(contact):
    """mu p less a similar ellipse over the stick zone, which begins at the leading edge; Johnson 1985, (8.29)."""
    found = solved(contact, longitudinal_force=0.75 * load(contact))
    x = -1.0 + 0.01 * (np.arange(200) + 0.5)
    stick = np.maximum(1.0 - ((x - 0.5) / 0.5) ** 2, 0.0)
    closed = np.sqrt(1.0 - x**2) - 0.5 * np.sqrt(stick)
    assert np.abs(np.asarray(found.traction[0]) - closed)[1:-1].max() < 0.03
    assert np.abs(np.asarray(found.traction[0]) - closed).mean() < 0.003
    assert float(found.stick_fraction) == pytest.approx(0.5, abs=0.011)


@pytest.mark.slow
def test_the_line_deck_of_contact():
    """Deck carter2d: steel on steel, R 500 mm, 178.9 N/mm, mu 0.3, creepage 2.4e-4; in closed form q = 0.639995."""
    young = 2.0 * 82e9 * 1.28
    pair = elastic_pair(
        youngs_modulus_1=young, youngs_modulus_2=young, poisson_ratio_1=0.28, poisson_ratio_2=0.28
    )
    pixel = 1e-5
    x = (np.arange(220) - 109.5) * pixel
    strip = FreeHalfSpace(pair, shape=(220,), pixel_size=(pixel,), reference_distance=1.0)
    contact = normal_contact(strip, -(x**2) / (2.0 * 0.5), normal_force=178.9e3)
    assert float(contact.pressure.max()) == pytest.approx(113.9e6, rel=1e-3)
    found = solved((strip, contact.pressure), friction_coefficient=0.3, longitudinal_creepage=2.4e-4)
    assert float(found.tangential_force[0]) / (0.3 * 178.9e3) == pytest.approx(0.639995, rel=5e-3)
    assert float(found.stick_fraction) == pytest.approx(0.6, abs=0.011)


#: Layer: compliance ratio, slip ratio, creepage over Carter's for a uniform layer by an independent solver of 400
# cells, and for one with compliance inversely proportional to the pressure.
LAYER = [
    (0.01, (1.019, 1.017, 1.018, 1.022), None),
    (0.1, (1.162, 1.155, 1.159, 1.187), None),
    (0.2, (1.314, 1.302, 1.307, 1.360), (1.361, 1.308, 1.286, 1.349)),
    (1.0, (2.52, 2.48, 2.50, 2.72), None),
    (10.0, (16.3, 16.0, 16.0, 18.0), None),
]


@pytest.mark.slow
@pytest.mark.parametrize(("ratio", "uniform", "by_pressure"), LAYER)
def test_a_layer_adds_to_the_creepage(contact, ratio, uniform, by_pressure):
    layers = [(uniform, ratio), (by_pressure, ratio * 0.25 * np.pi / contact[1])]
    for expected, layer in layers:
        if expected is not None:
            for q, factor in zip((0.1, 0.25, 0.5, 0.8), expected, strict=True):
                found = solved(contact, layer_compliance=layer, longitudinal_force=q * load(contact))
                assert float(found.creepage[0]) / carter(q) == pytest.approx(factor, rel=5e-3)


def test_a_very_soft_layer_is_a_brush(contact):
    """Traction k (1 - x) from the leading edge up to sqrt(1 - x^2), which it meets at 1 - x = 2/(1 + k^2)."""
    k, chi = 3.0, 1e4
    found = solved(contact, layer_compliance=chi, longitudinal_creepage=k * chi)
    x = -1.0 + 0.01 * (np.arange(200) + 0.5)
    closed = np.minimum(k * (1.0 - x), np.sqrt(1.0 - x**2))
    assert float(found.tangential_force[0]) == pytest.approx(closed.sum() * 0.01, rel=5e-3)
    assert float(found.stick_fraction) == pytest.approx(1.0 / (1.0 + k**2), abs=0.011)


@pytest.mark.slow
def test_skew_alone_is_carter_in_anti_plane_shear(contact):
    """Johnson 1985, section 8.3, with 1/G for 2/E: like bodies creep 1/(1 - nu) times as much."""
    found = solved(contact, longitudinal_creepage=0.0, lateral_force=0.5 * load(contact))
    assert float(found.creepage[1]) == pytest.approx(carter(0.5) / 0.7, rel=3e-3)
    assert abs(float(found.tangential_force[0])) < 1e-10


@pytest.mark.slow
def test_without_lateral_contraction_friction_knows_no_direction():
    """nu = 0: the surface is as stiff both ways, so Carter holds along any creepage."""
    contact = line_contact(100, poisson_ratio=0.0)
    angle = 0.6
    direction = np.array([np.cos(angle), np.sin(angle)])
    found = solved(contact, longitudinal_creepage=0.4 * direction[0], lateral_creepage=0.4 * direction[1])
    alone = solved(contact, longitudinal_creepage=0.4)
    np.testing.assert_allclose(
        found.tangential_force, float(alone.tangential_force[0]) * direction, rtol=1e-8
    )
    forced = solved(
        contact, longitudinal_force=found.tangential_force[0], lateral_creepage=0.4 * direction[1]
    )
    assert float(forced.creepage[0]) == pytest.approx(0.4 * direction[0], rel=1e-8)


def test_both_creepages_at_once_obey_coulomb(contact):
    found = solved(contact, longitudinal_creepage=0.5, lateral_creepage=0.6)
    traction, slip = np.asarray(found.traction), np.asarray(found.slip)
    size = np.hypot(*traction)
    assert np.all(size <= contact[1] * (1.0 + 1e-9))
    slides = np.hypot(*slip) > 1e-9
    np.testing.assert_allclose(size[slides], contact[1][slides], rtol=1e-9)
    along = -np.sum(traction * slip, axis=0)[slides] / (size * np.hypot(*slip))[slides]
    np.testing.assert_allclose(along, 1.0, rtol=1e-9)
    assert 0.0 < float(found.stick_fraction) < 1.0
    assert np.mean(slides) + float(found.stick_fraction) == pytest.approx(1.0, abs=1e-12)


#: Largest distance between the force and the rule of Vermeulen and Johnson, over mu N, for |zeta| up to this value.
COMBINATION = [(0.5, 0.023), (1.0, 0.09)]


@pytest.mark.slow
@pytest.mark.parametrize(("reach", "error"), COMBINATION)
def test_the_rule_that_combines_both_creepages(reach, error):
    """1 - (1 - |zeta|)^2 of mu N along zeta: the size is right, the direction off by 5 degrees at most (nu = 0.3)."""
    contact = line_contact(100)
    worst = 0.0
    for degrees in (0.0, 22.5, 45.0, 67.5, 90.0):
        zeta = reach * np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
        found = solved(contact, longitudinal_creepage=zeta[0], lateral_creepage=zeta[1] / 0.7)
        force = np.asarray(found.tangential_force) / load(contact)
        assert np.hypot(*force) == pytest.approx(1.0 - (1.0 - reach) ** 2, abs=5e-3)
        turned = np.degrees(np.arctan2(force[1], force[0])) - degrees
        assert -1e-6 < turned < 5.2
        worst = max(worst, np.hypot(*(force - (1.0 - (1.0 - reach) ** 2) * zeta / reach)))
    assert 0.9 * error < worst < error


def test_far_beyond_gross_slip_the_force_points_along_the_creepage(contact):
    found = solved(contact, longitudinal_creepage=30.0, lateral_creepage=40.0)
    np.testing.assert_allclose(found.tangential_force / load(contact), [0.6, 0.8], atol=1e-3)
    assert float(found.stick_fraction) == 0.0


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"longitudinal_force": 1.6}, "force of 1.6 N/m: the bodies slide at 1.57"),
        ({"longitudinal_force": 1.3, "lateral_force": 1.3}, "force of 1.83"),
        ({}, "longitudinal_creepage = None and longitudinal_force = None"),
        ({"longitudinal_force": 1.0, "longitudinal_creepage": 1.0}, "give one of them"),
        ({"longitudinal_creepage": float("nan")}, "a finite number"),
        ({"longitudinal_creepage": 0.1, "friction_coefficient": 0.0}, "friction_coefficient = 0"),
        ({"longitudinal_creepage": 0.1, "layer_compliance": -1.0}, "layer_compliance has values below zero"),
    ],
)
def test_bad_input_is_named(contact, change, named):
    with pytest.raises(InputError, match=named):
        solved(contact, **change)


def test_pressure_that_pulls_and_a_grid_of_two_axes_are_refused(contact):
    with pytest.raises(InputError, match="must not be negative"):
        solved((contact[0], contact[1] - 0.5), longitudinal_creepage=0.1)
    square = FreeHalfSpace(contact[0].pair, shape=(4, 4), pixel_size=(1.0, 1.0))
    with pytest.raises(InputError, match=r"a strip \(one axis\)"):
        solved((square, np.ones((4, 4))), longitudinal_creepage=0.1)


def test_what_does_not_converge_is_an_error(contact):
    with pytest.raises(NoSolutionError, match="steady rolling: not converged"):
        solved(contact, longitudinal_force=0.8, max_iterations=0)

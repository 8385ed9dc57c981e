"""Rolling with film and asperities by strips: Carter, closed forms of linear films, rigid bodies, another solver."""

import math

import numpy as np
import pytest

from asperity.bem import ElasticPair, FreeHalfSpace, steady_rolling
from asperity.bem.film_rolling import film_rolling
from asperity.errors import InputError, NoSolutionError

#: Half-width 1, contact modulus 2: with a peak of 1 and friction 1 gross slip begins at creepage 1.
BODIES = {"half_width": 1.0, "contact_modulus": 2.0}


def ellipse(position):
    return np.sqrt(1.0 - position**2)


def coulomb(position, slip):
    return ellipse(position), np.zeros_like(slip)


def linear(viscous):
    """A film whose stress is in proportion to the slip."""
    return lambda position, slip: (viscous(position) * slip, np.ones_like(slip))


def extrapolated(strips, **given):
    forces = [film_rolling(strips=count, **given).tangential_force for count in (strips // 2, strips)]
    return 2.0 * forces[1] - forces[0]


@pytest.mark.parametrize("creepage", [0.1, 0.3, 0.6, 0.9, 1.5])
def test_a_dry_contact_is_carters(creepage):
    given = {"creepage": creepage, "stress": coulomb, "layer_compliance": 0.0, **BODIES}
    expected = 0.5 * math.pi * (1.0 - (1.0 - min(creepage, 1.0)) ** 2)
    assert film_rolling(strips=200, **given).tangential_force == pytest.approx(expected, rel=2e-3)
    assert extrapolated(200, **given) == pytest.approx(expected, rel=2e-4)


def test_tractions_of_a_dry_contact():
    """Less a similar ellipse that begins at the leading edge; Johnson 1985, (8.29). Slip behind it alone."""
    found = film_rolling(strips=200, creepage=0.4, stress=coulomb, layer_compliance=0.0, **BODIES)
    inside = (found.position - 0.4) / 0.6  # from 1 back over 1.2 half-widths
    expected = ellipse(found.position) - 0.6 * np.sqrt(np.maximum(1.0 - inside**2, 0.0))
    assert np.abs(found.traction - expected).max() < 0.02
    assert np.all(found.slip[found.position > -0.19] == 0.0)
    assert np.all(found.slip[found.position < -0.21] > 0.0)


@pytest.mark.parametrize("ratio", [0.1, 1.0, 10.0])
def test_even_linear_film(ratio):
    """tau = eta V s/h everywhere: T = a E* xi arctan(b), b = 2 eta V/(h E*)."""
    film = linear(lambda position: ratio + 0.0 * position)
    force = extrapolated(200, creepage=1e-3, stress=film, layer_compliance=0.0, **BODIES)
    assert force == pytest.approx(2e-3 * math.atan(ratio), rel=2e-3)


@pytest.mark.parametrize("ratio", [0.1, 1.0, 10.0])
def test_linear_film_of_a_viscosity_that_varies(ratio):
    """T = E* xi/2 times the integral of arctan b(x), whatever b(x) is; not symmetric here."""

    def varying(position):
        return ratio * np.exp(3.0 * (ellipse(position) - 1.0)) * (1.0 + 0.5 * position)

    places, weights = np.polynomial.legendre.leggauss(400)
    expected = 1e-3 * float(weights @ np.arctan(varying(places)))
    given = {"creepage": 1e-3, "stress": linear(varying), "layer_compliance": 0.0, **BODIES}
    assert extrapolated(200, **given) == pytest.approx(expected, rel=1e-3)


def test_rigid_bodies_slip_alike():
    """Stress by a thinning film on bodies a million times as stiff: the traction of an even slip."""

    def thinning(position, slip):
        ratio = 30.0 * ellipse(position) * slip
        return 0.01 * np.arcsinh(ratio), ratio / np.sqrt(1.0 + ratio**2) / np.arcsinh(ratio)

    found = film_rolling(
        half_width=1.0,
        contact_modulus=1e6,
        creepage=0.3,
        stress=thinning,
        layer_compliance=0.0,
        strips=100,
    )
    assert found.slip == pytest.approx(np.full(100, 0.3), rel=1e-5)
    even = thinning(found.position, 0.3)[0]
    assert found.tangential_force == pytest.approx(0.02 * even.sum(), rel=1e-5)


def test_layers_against_the_solver_with_coulombs_friction():
    """With friction alone and a layer it is the state of steady_rolling, whose tractions are found in another way."""
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)
    half_space = FreeHalfSpace(pair, shape=(100,), pixel_size=(0.02,), reference_distance=1.0)
    position = 0.02 * np.arange(100) - 0.99
    layer = 0.1 / ellipse(position)
    other = steady_rolling(
        half_space,
        ellipse(position),
        friction_coefficient=1.0,
        layer_compliance=layer,
        longitudinal_creepage=0.5,
        lateral_creepage=0.0,
    )
    found = film_rolling(strips=100, creepage=0.5, stress=coulomb, layer_compliance=layer, **BODIES)
    assert found.position == pytest.approx(position, abs=1e-12)
    assert found.traction == pytest.approx(np.asarray(other.traction[0]), abs=1e-9)
    assert found.slip == pytest.approx(-np.asarray(other.slip[0]), abs=1e-9)


def test_without_slip_an_even_layer_has_the_stiffness_of_a_strip_alone():
    """Bodies so stiff that the layer alone yields: a traction that grows from the leading edge, q = xi (a - x)/c."""
    found = film_rolling(
        half_width=2.0,
        contact_modulus=1e9,
        creepage=1e-3,
        stress=lambda position, slip: (1e3 + 0.0 * slip, 0.0 * slip),
        layer_compliance=0.25,
        strips=80,
    )
    leading = 2.0 * (1.0 - found.position) + 0.025  # with half of a strip
    assert found.traction == pytest.approx(1e-3 * leading / 0.25, rel=1e-5)
    assert np.all(found.slip == 0.0)


def test_a_film_that_hardly_slips_and_then_reaches_its_limit():
    """A stiff film up to a limit in proportion to the pressure carries as friction does, slipping by 1e-12 in front."""

    def film(position, slip):
        viscous, limit = 1e12 * slip, ellipse(position)
        stress = (viscous**-8.0 + limit**-8.0) ** -0.125
        return stress, (stress / viscous) ** 8.0

    found = film_rolling(strips=100, creepage=0.5, stress=film, layer_compliance=0.0, **BODIES)
    dry = film_rolling(strips=100, creepage=0.5, stress=coulomb, layer_compliance=0.0, **BODIES)
    # between both the corner of the smooth minimum
    assert found.traction == pytest.approx(dry.traction, abs=2e-3)
    assert 0.0 < found.slip[-1] < 1e-11


def test_friction_and_film_side_by_side():
    """What a place bears is the sum of both where it slips, and less than friction alone where it sticks."""

    def both(position, slip):
        viscous = 0.3 * slip
        return 0.2 * ellipse(position) + viscous, viscous / (0.2 * ellipse(position) + viscous)

    found = film_rolling(strips=100, creepage=0.2, stress=both, layer_compliance=0.0, **BODIES)
    slips = found.slip > 0.0
    assert 10 < np.count_nonzero(slips) < 100
    assert found.traction[slips] == pytest.approx(both(found.position, found.slip)[0][slips], rel=1e-9)
    assert np.all(found.traction[~slips] <= 0.2 * ellipse(found.position)[~slips])


@pytest.mark.parametrize("name", ["half_width", "contact_modulus", "creepage"])
def test_what_must_be_positive(name):
    given = {"creepage": 1e-3, **BODIES, name: 0.0}
    with pytest.raises(InputError, match=rf"{name} = 0\.0: must be above 0"):
        film_rolling(stress=coulomb, layer_compliance=0.0, strips=20, **given)


def test_no_convergence_is_an_error(monkeypatch):
    monkeypatch.setattr("asperity.bem.film_rolling._STEPS", 1)
    with pytest.raises(NoSolutionError, match=r"creepage of 0\.5: not converged after 1 steps"):
        film_rolling(stress=coulomb, layer_compliance=0.0, strips=20, creepage=0.5, **BODIES)

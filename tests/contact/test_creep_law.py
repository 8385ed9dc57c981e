"""Creep of lubricated contacts: a table of an independent computation, exact limits, bounds, slopes by differences."""

import dataclasses
import math

import numpy as np
import pytest
from scipy.optimize import minimize_scalar
from traction_contacts import (
    HALF_WIDTH,
    LENGTH,
    LOAD,
    MODULUS,
    OILS,
    RADIUS,
    dry_contact,
    oiled_contact,
    same_layer,
)

from asperity.contact import carter, skew
from asperity.contact.creep_capacity import traction_capacity
from asperity.contact.creep_inverse import creepage_at_traction
from asperity.contact.creep_law import Capacity, traction_at_creepage
from asperity.contact.film_traction import BoundaryFriction, even_slip
from asperity.contact.fluid import DataSheetTraction, Fluid, LimitingTraction, RheologicalTraction, film_slope
from asperity.contact.viscosity import ExponentialViscosity, RationalPressureRise, Viscosity
from asperity.engine.derivatives import value_and_slope
from asperity.engine.module import Partial
from asperity.validation.oiled_rollers import CREEPAGES, known_contacts


def layers_of(*, contact, layer_factor):
    """Factor of film and asperities as elastic layers, which does not hang on the creepage."""
    some = np.full(np.shape(contact.film_thickness), 1e-3)
    return traction_at_creepage(contact=contact, creepage=some, layer_factor=layer_factor).elastic_factor


def traction(oiled, creepage):
    """T/N at creepages [-]."""
    found = traction_at_creepage(
        contact=oiled.contact, creepage=np.atleast_1d(creepage), layer_factor=oiled.layer_factor
    )
    return found.traction / LOAD


def capacity(oiled):
    return traction_capacity(contact=oiled.contact, layer_factor=oiled.layer_factor)


@pytest.mark.parametrize(
    "known", known_contacts(), ids=lambda known: f"{known.oil} {known.celsius:g} {known.speed:g}"
)
def test_table_of_a_prototype(known):
    """The numbers to the last digit that the table has."""
    oiled = known.contact()
    contact = oiled.contact
    assert oiled.full_film == pytest.approx(known.full_film, abs=1.1e-10)
    assert contact.asperity_share == pytest.approx(known.asperity_share, abs=1.1e-5)
    assert contact.film_thickness == pytest.approx(known.film_thickness, abs=1.1e-10)
    assert layers_of(contact=contact, layer_factor=oiled.layer_factor) == pytest.approx(
        known.elastic_factor, abs=1.1e-4
    )
    assert [float(traction(oiled, xi)[0]) for xi in CREEPAGES] == pytest.approx(known.tractions, abs=1.1e-5)
    assert capacity(oiled).traction / LOAD == pytest.approx(known.capacity, abs=1.1e-5)


def test_dry_contact_is_carters():
    oiled = dry_contact()
    gross = carter.gross_slip_creepage(
        friction_coefficient=0.12, half_width=HALF_WIDTH, effective_radius=RADIUS
    )
    creepages = np.array([1e-5, 1e-3, 0.5, 0.9]) * gross * oiled.layer_factor
    expected = carter.slip_ratio_at_creepage(
        creepage=creepages, gross_slip_creepage=gross * oiled.layer_factor
    )
    assert [float(traction(oiled, xi)[0]) for xi in creepages] == pytest.approx(0.12 * expected, rel=2e-15)
    assert traction(oiled, 2.0 * gross * oiled.layer_factor) == pytest.approx(0.12, rel=1e-14)


def film_of(law, thickness, *, base=1.0, limit=1.0, modulus=1e30):
    """A contact that a film of constant viscosity carries alone, without heat."""
    oiled = oiled_contact("M100", 60.0, 1.0, 1e-7, rough=False)
    oil = Viscosity(ExponentialViscosity(base, 0.0, 0.0), RationalPressureRise(1e30, 0.0, 0.0, 0.0))
    fluid = Fluid(oil, RheologicalTraction(LimitingTraction(limit), modulus, law), 1e30)
    return oiled._replace(
        contact=dataclasses.replace(
            oiled.contact, fluid=fluid, film_thickness=np.array([thickness]), effusivity=np.inf
        )
    )


@pytest.mark.parametrize("ratio", [0.1, 1.0, 10.0])
def test_even_linear_film_has_the_closed_form(ratio):
    """tau = eta V s/h everywhere: T = a E* B xi arctan(b), b = 2 eta V/(h E*)."""
    oiled = film_of("limit", 1e-7, base=0.5 * ratio * 1e-7 * MODULUS, limit=1e9)
    expected = HALF_WIDTH * MODULUS * LENGTH * 1e-3 * math.atan(ratio)
    assert LOAD * float(traction(oiled, 1e-3)[0]) == pytest.approx(expected, rel=1e-9)


def test_elastic_plastic_film_is_carter_with_its_limit():
    """A film that is stiff up to Lambda p: Carter with Lambda in place of mu, stretched by f = 1 + pi E* h/(4 a G)."""
    oiled = film_of("limit", 1e-7, base=1e12, limit=0.09, modulus=0.5e9)
    stretched = 1.0 + 0.25 * math.pi * MODULUS * 1e-7 / (HALF_WIDTH * 0.5e9)
    gross = stretched * 0.09 * HALF_WIDTH / RADIUS
    for share in (0.2, 0.6, 0.95):
        expected = 0.09 * (1.0 - (1.0 - share) ** 2)
        assert float(traction(oiled, share * gross)[0]) == pytest.approx(expected, rel=1e-9)


def test_data_sheet_of_a_traction_fluid():
    """Slope 55 at 1.5 GPa: 203 of the film; Lambda 0.09 gives f 1.5363, and the creepages of an independent route."""
    slope = film_slope(slope=55.0, rig_modulus=MODULUS, rig_peak_pressure=1.5e9)
    assert slope == pytest.approx(203.0, abs=0.2)
    slope = 203.0  # as the other route rounded it
    oiled = oiled_contact("S50", 40.0, 1.0, 1e-7, rough=False)
    fluid = Fluid(OILS["S50"].viscosity, DataSheetTraction(0.09, slope), 0.104)
    contact = dataclasses.replace(oiled.contact, fluid=fluid)
    most = traction_capacity(contact=contact, layer_factor=oiled.layer_factor)
    assert most.traction / LOAD == pytest.approx(0.09, rel=1e-12)
    assert layers_of(contact=contact, layer_factor=oiled.layer_factor) == pytest.approx(1.5363, abs=1e-4)
    for share, creepage in ((0.0225, 3.403e-4), (0.045, 7.440e-4), (0.0855, 1.972e-3)):
        found = creepage_at_traction(
            contact=contact,
            traction=np.array([share * LOAD]),
            layer=same_layer(oiled.layer_factor),
            capacity=most,
        )
        assert found == pytest.approx(creepage, rel=4e-4)


def test_rigid_bodies_carry_the_even_slip_traction():
    oiled = oiled_contact("PAO100", 60.0, 1.0, 1e-9, load=1e-3)
    slides = even_slip(contact=oiled.contact, creepage=np.array([1e-2]))
    found = traction_at_creepage(
        contact=oiled.contact, creepage=np.array([1e-2]), layer_factor=oiled.layer_factor
    )
    assert found.traction == pytest.approx(slides.force, rel=1e-3)


def test_at_the_lowest_speed_it_is_the_dry_contact():
    slow, dry = oiled_contact("M100", 60.0, 1e-9, 1e-7), dry_contact()
    for creepage in (1e-4, 1e-3, 5e-3):
        assert traction(slow, creepage) == pytest.approx(traction(dry, creepage), rel=3e-7)


def test_dry_skewed_contact_is_that_of_skew():
    """Both forces over friction by the law of dry skewed contacts."""
    oiled, ratio = dry_contact(), 1.3
    gross = 0.12 * HALF_WIDTH / RADIUS * oiled.layer_factor
    for along, across in ((0.2, 0.3), (0.6, 0.5), (1.5, 0.4), (0.3, 2.0)):
        contact = dataclasses.replace(
            oiled.contact, lateral_creepage=across * gross, lateral_ratio=np.array([ratio])
        )
        found = traction_at_creepage(contact=contact, creepage=along * gross, layer_factor=oiled.layer_factor)
        expected = skew.skewed_slip_ratios(
            longitudinal_creepage=along * gross,
            lateral_creepage=across * gross * ratio,
            gross_slip_creepage=gross,
            lateral_gross_slip_creepage=gross * ratio,
        )
        assert found.traction / LOAD == pytest.approx(0.12 * expected[0], rel=1e-12)
        assert found.lateral / LOAD == pytest.approx(0.12 * expected[1], rel=1e-12)


def test_slices_of_one_contact_are_the_contact():
    """A third and two thirds of the length, of the same width, carry its traction under the same creepage."""
    oiled = oiled_contact("M100", 60.0, 0.3, 1e-7)
    shares = np.array([[1.0 / 3.0], [2.0 / 3.0]])
    like = {
        name: value + 0.0 * shares
        for name, value in vars(oiled.contact).items()
        if isinstance(value, np.ndarray)
    }
    sliced = dataclasses.replace(
        oiled.contact,
        **like,
        friction=BoundaryFriction(0.12 + 0.0 * shares),
        contact_length=shares * LENGTH,
        sliced=True,
    )
    whole, both = capacity(oiled), traction_capacity(contact=sliced, layer_factor=oiled.layer_factor)
    assert both.traction == pytest.approx(whole.traction, rel=1e-9)
    layer = same_layer(oiled.layer_factor)
    found = [
        creepage_at_traction(contact=each, traction=0.7 * whole.traction, layer=layer, capacity=whole)
        for each in (oiled.contact, sliced)
    ]
    assert found[1] == pytest.approx(found[0], rel=1e-9)


def test_little_creepage_is_carters_stick_over_the_layers():
    """xi → 0 with asperities: T = pi a E* B xi/(2 f)."""
    oiled = oiled_contact("S50", 40.0, 0.05, 2e-7)
    factor = layers_of(contact=oiled.contact, layer_factor=oiled.layer_factor)
    stick = 0.5 * math.pi * HALF_WIDTH * MODULUS * LENGTH * 1e-9 / factor / LOAD
    assert traction(oiled, 1e-9) == pytest.approx(stick, rel=2e-5, abs=0.0)


def test_orderings():
    at = {oil: traction(oiled_contact(oil, 60.0, 1.0, 1e-7), 1e-3)[0] for oil in OILS}
    assert at["S50"] > at["N100"] > at["M100"] > at["PAO100"]
    loads = [
        math.pi * (pressure * 1e9) ** 2 * LENGTH * RADIUS / MODULUS for pressure in (0.4, 0.8, 1.2, 1.6, 2.0)
    ]
    found = [
        float(
            traction_at_creepage(
                contact=oiled.contact, creepage=np.array([1e-3]), layer_factor=oiled.layer_factor
            ).traction[0]
            / load
        )
        for load in loads
        for oiled in [oiled_contact("M100", 60.0, 1.0, 1e-7, load=load)]
    ]
    assert found == pytest.approx([0.0013, 0.0058, 0.0207, 0.0297, 0.0319], abs=6e-5)


def random_contacts(count, seed=5):
    """Contacts of all oils at random loads, speeds, temperatures, roughness and friction, one oil after the other.

    With them a random creepage each.
    """
    random = np.random.default_rng(seed)
    size = count // len(OILS)
    for oil in OILS:
        pressure, speed, height, creepage = (
            np.exp(random.uniform(np.log(low), np.log(high), size))
            for low, high in ((1e8, 2.5e9), (1e-4, 20.0), (5e-9, 2e-6), (1e-7, 2e-2))
        )
        celsius, friction = random.uniform(20.0, 110.0, size), random.uniform(0.03, 0.2, size)
        load = math.pi * pressure**2 * LENGTH * RADIUS / MODULUS
        yield oiled_contact(oil, celsius, speed, height, friction=friction, load=load), creepage


def without_heat(contact):
    fluid = dataclasses.replace(contact.fluid, conductivity=np.inf)
    return dataclasses.replace(contact, fluid=fluid, effusivity=np.inf)


def loads(contact):
    return 0.5 * math.pi * contact.half_width * contact.peak_pressure * LENGTH


def most_traction(contact, warming):
    """What friction and limiting stress allow, the latter as under the peak where it is no share of the pressure."""
    limit, load = contact.fluid.traction.limiting_traction, loads(contact)
    friction = contact.friction.coefficient * contact.asperity_share * load
    if limit.stress == 0.0:
        return friction + limit.share * contact.film_share * load
    under_peak = limit.at(contact.film_share * contact.peak_pressure, contact.oil_temperature + warming)
    return friction + under_peak * 2.0 * contact.half_width * LENGTH


@pytest.mark.parametrize("count", [4000, pytest.param(100_000, marks=pytest.mark.long)])
def test_random_states(count):
    """Not above the stick line, rigid bodies, or what friction and limit allow; without heat it rises; and back."""
    for oiled, creepage in random_contacts(count):
        for contact in (oiled.contact, without_heat(oiled.contact)):
            found = traction_at_creepage(contact=contact, creepage=creepage, layer_factor=oiled.layer_factor)
            stick = 0.5 * math.pi * contact.half_width * MODULUS * LENGTH * creepage / found.elastic_factor
            assert np.all(found.traction > 0.0)
            assert np.all(found.traction <= stick * (1.0 + 1e-12))
            assert np.all(found.traction <= found.even * (1.0 + 1e-12))
            assert np.all(found.traction <= most_traction(contact, found.warming) * (1.0 + 1e-12))
        more, most = (
            traction_at_creepage(contact=contact, creepage=xi, layer_factor=oiled.layer_factor).traction
            for xi in (1.01 * creepage, np.full(creepage.shape, 2e-2))
        )
        assert np.all(more >= found.traction * (1.0 - 1e-14))
        back = creepage_at_traction(
            contact=contact,
            traction=found.traction,
            layer=same_layer(oiled.layer_factor),
            capacity=Capacity(most, np.full(creepage.shape, 2e-2), 2e-2),
        )
        below = found.traction < 0.998 * most
        assert np.all(np.isfinite(back))
        assert back[below] == pytest.approx(creepage[below], rel=1e-7, abs=0.0)


@pytest.mark.parametrize("count", [400, pytest.param(8000, marks=pytest.mark.long)])
def test_capacity_in_random_states(count):
    """No traction that is looked for is above it, it is one up to 2 %, and below it is the way back."""
    for oiled, creepage in random_contacts(count, seed=6):
        contact, dry = oiled.contact, oiled.layer_factor
        largest = capacity(oiled)
        assert np.all(largest.creepage <= 2e-2 * (1.0 + 1e-12))
        at_it = traction_at_creepage(contact=contact, creepage=largest.creepage, layer_factor=dry)
        assert largest.traction == pytest.approx(at_it.traction, rel=1e-12)
        for tried in (creepage, *np.geomspace(1e-5, 2e-2, 40)):
            found = traction_at_creepage(
                contact=contact, creepage=np.broadcast_to(tried, creepage.shape), layer_factor=dry
            )
            missing = found.traction / largest.traction - 1.0
            # two maxima: an oil whose limiting stress falls with the heat in the middle and rises at the edges
            assert np.count_nonzero(missing > 1e-6) <= creepage.size // 1000
            assert np.all(missing < 5e-3)
        found = traction_at_creepage(contact=contact, creepage=creepage, layer_factor=dry)
        below = (creepage < largest.creepage) & (found.traction < 0.998 * largest.traction)
        back = creepage_at_traction(
            contact=contact, traction=found.traction, layer=same_layer(dry), capacity=largest
        )
        assert np.all(np.isfinite(back))
        assert back[below] == pytest.approx(creepage[below], rel=1e-7, abs=0.0)


def test_slopes_by_load_and_traction_in_random_states():
    """Of the creepage, load sharing and film going along, against differences."""
    random, size = np.random.default_rng(7), 60
    for oil in OILS:
        load, speed, height = (
            np.exp(random.uniform(np.log(low), np.log(high), size))
            for low, high in ((100.0, 6000.0), (1e-3, 20.0), (2e-8, 8e-7))
        )
        celsius, share = random.uniform(25.0, 100.0, size), random.uniform(0.05, 0.95, size)
        most = capacity(oiled_contact(oil, celsius, speed, height, load=load))

        def creepage(traction, load, oil=oil, celsius=celsius, speed=speed, height=height, most=most):
            oiled = oiled_contact(oil, celsius, speed, height, load=load)
            return creepage_at_traction(
                contact=oiled.contact, traction=traction, layer=same_layer(oiled.layer_factor), capacity=most
            )

        force = share * most.traction
        for along, across in ((force, 0.0 * load), (0.0 * force, load)):
            at, slope = value_and_slope(creepage, (force, load), (along, across))
            step = 1e-5
            ends = [creepage(force + sign * step * along, load + sign * step * across) for sign in (1, -1)]
            assert np.all(np.isfinite(slope))
            assert slope / at == pytest.approx((ends[0] - ends[1]) / (2.0 * step) / at, rel=2e-5, abs=2e-6)


def test_slopes_are_those_of_differences():
    oiled = oiled_contact("M100", 60.0, 0.3, 1e-7)
    most = capacity(oiled)
    force = 0.5 * most.traction

    def creepage(traction, width):
        contact = dataclasses.replace(oiled.contact, half_width=width)
        return creepage_at_traction(
            contact=contact, traction=traction, layer=same_layer(oiled.layer_factor), capacity=most
        )

    width = oiled.contact.half_width
    for along, step in ((np.array([1.0]), 0.0), (np.array([0.0]), 1.0)):
        _, slope = value_and_slope(creepage, (force, width), (along * force, step * width))
        ends = [
            creepage(force * (1.0 + sign * 1e-5 * along), width * (1.0 + sign * 1e-5 * step))
            for sign in (1, -1)
        ]
        assert slope == pytest.approx((ends[0] - ends[1]) / 2e-5, rel=1e-6)


def test_creepage_is_odd_and_goes_on_beyond_the_capacity():
    oiled = oiled_contact("M100", 60.0, 0.3, 1e-7)
    most = capacity(oiled)

    def creepage(share):
        return float(
            creepage_at_traction(
                contact=oiled.contact,
                traction=share * most.traction,
                layer=same_layer(oiled.layer_factor),
                capacity=most,
            )[0]
        )

    assert creepage(-0.4) == -creepage(0.4)
    assert creepage(0.0) == 0.0
    assert creepage(1e-12) == pytest.approx(1e-3 * creepage(1e-9), rel=1e-6, abs=0.0)
    assert creepage(0.998) < creepage(0.999) < creepage(1.1) < creepage(2.0)


def test_smooth_bodies_on_a_film_ask_for_no_asperities():
    """Without asperities, f = 1 + pi E* h/(4 a G), whether a layer of asperities would yield or not; a rough one has
    none where either yields nothing."""
    smooth = oiled_contact("M100", 60.0, 1.0, 1e-7, rough=False).contact
    film = 0.25 * math.pi * MODULUS * smooth.film_thickness / (HALF_WIDTH * 0.5e9)
    for layer in (1.0, 1.02):
        found = layers_of(contact=smooth, layer_factor=np.array([layer]))
        assert found == pytest.approx(1.0 + film, rel=1e-14)
    rough = oiled_contact("M100", 60.0, 0.1, 1e-7).contact
    assert layers_of(contact=rough, layer_factor=np.array([1.0])) == 1.0


def test_a_limit_of_creep_is_kept():
    """A film whose traction still rises there has its capacity at the limit."""
    oiled = oiled_contact("PAO100", 40.0, 1.0, 1e-7)
    for limit in (0.001, 0.01):
        most = traction_capacity(contact=oiled.contact, layer_factor=oiled.layer_factor, creep_limit=limit)
        assert most.creepage == pytest.approx(limit, rel=1e-12)
        assert most.traction / LOAD == pytest.approx(traction(oiled, limit), rel=1e-12)


def test_a_largest_traction_before_the_limit():
    """Heat thins the film: the traction is largest where another search finds it, too."""
    oiled = oiled_contact("N100", 30.0, 20.0, 1e-7)
    most = capacity(oiled)
    found = minimize_scalar(
        lambda logarithm: -float(traction(oiled, math.exp(logarithm))[0]),
        bounds=(math.log(2e-3), math.log(2e-2)),
        method="bounded",
        options={"xatol": 1e-8},
    )
    assert 3e-3 < math.exp(found.x) < 1.5e-2
    assert most.traction / LOAD == pytest.approx(-found.fun, rel=1e-8)
    assert most.creepage == pytest.approx(math.exp(found.x), rel=5e-3)


def test_beyond_the_capacity_the_tangent_goes_on():
    """From 99.9 % of the capacity on a straight line with the slope that the creepage has there."""
    oiled = oiled_contact("M100", 60.0, 0.3, 1e-7)
    most = capacity(oiled)

    def creepage(share):
        return creepage_at_traction(
            contact=oiled.contact,
            traction=share * most.traction,
            layer=same_layer(oiled.layer_factor),
            capacity=most,
        )

    at = creepage(0.999)
    slope = (at - creepage(0.999 - 1e-7)) / 1e-7
    assert creepage(1.1) == pytest.approx(at + 0.101 * slope, rel=1e-4)
    assert creepage(1.3) - creepage(1.2) == pytest.approx(creepage(1.2) - creepage(1.1), rel=1e-10)


def test_layers_that_depend_on_the_traction():
    """The factor of the asperities is that of the traction over the one of rigid bodies at the same creepage."""
    oiled = oiled_contact("S50", 40.0, 0.05, 2e-7)
    contact, most = oiled.contact, capacity(oiled)
    layer = Partial(_growing, (oiled.layer_factor,))
    force = 0.6 * most.traction
    creepage = creepage_at_traction(contact=contact, traction=force, layer=layer, capacity=most)
    used = force / even_slip(contact=contact, creepage=creepage).force
    back = traction_at_creepage(
        contact=contact, creepage=creepage, layer_factor=_growing(oiled.layer_factor, used)
    )
    assert back.traction == pytest.approx(force, rel=1e-9)


def _growing(factor, used):
    return 1.0 + (factor - 1.0) * (1.0 + used)

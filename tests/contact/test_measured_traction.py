"""Measured traction: discs taken off, curves between their points, and values over conditions."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from traction_contacts import LENGTH, LOAD, MODULUS, OILS, oiled_contact

from asperity.contact.creep_capacity import traction_capacity
from asperity.contact.creep_law import traction_at_creepage
from asperity.contact.film_traction import MixedContact
from asperity.contact.fluid import DataSheetTraction, Fluid
from asperity.contact.measured_traction import (
    MeasuredTraction,
    TractionConditions,
    TractionTable,
    even_slip_coefficients,
    traction_curve,
)

CREEPAGE = np.geomspace(1e-4, 3e-2, 12)
RIG = {"rig_modulus": 113.19e9, "rig_peak_pressure": 1.0e9}
STICK = 113.19 * CREEPAGE


def full_film(traction, *, celsius=40.0, speed=1.0):
    """Rollers whose oil carries all and has this traction; what slips stays cold."""
    contact = oiled_contact("M100", celsius, speed, 0.1e-6, rough=False).contact
    fluid = Fluid(OILS["M100"].viscosity, traction, 0.14)
    return MixedContact(**vars(contact) | {"fluid": fluid, "effusivity": math.inf})


def measured(creepage, coefficient):
    return MeasuredTraction(
        TractionConditions(), (traction_curve(creepage=creepage, coefficient=coefficient),)
    )


def test_discs_of_a_film_of_constant_stress_are_carters():
    """mu = mu_0 q (2 - q) with q = s/(2 mu_0) of elastic discs, Carter's law in stick; beyond it mu_0."""
    limit = 0.08
    used = np.minimum(STICK / (2.0 * limit), 1.0)
    found = even_slip_coefficients(creepage=CREEPAGE, coefficient=limit * used * (2.0 - used), **RIG)
    assert found == pytest.approx(np.full(12, limit), rel=1e-6)


@pytest.mark.parametrize("share", [0.1, 1.0, 10.0])
def test_discs_of_a_film_in_proportion_to_slip_are_taken_off_exactly(share):
    """The arctan of an ellipse integrates to pi (sqrt(1 + b^2) - 1)/b, b = 2 mu_0/s."""
    even = share * STICK
    angle = 2.0 * share
    coefficient = STICK * (math.sqrt(1.0 + angle**2) - 1.0) / angle
    found = even_slip_coefficients(creepage=CREEPAGE, coefficient=coefficient, **RIG)
    assert found == pytest.approx(even, rel=3e-4)  # 16 points over the width


def test_discs_that_are_stiff_take_nothing_off():
    rises = 0.06 * CREEPAGE / (CREEPAGE + 2e-3)
    found = even_slip_coefficients(
        creepage=CREEPAGE, coefficient=rises, rig_modulus=113.19e14, rig_peak_pressure=1e9
    )
    assert found == pytest.approx(rises, rel=1e-4)


def test_the_creep_law_at_the_rig_gives_the_measured_curve_back():
    """Inverse and law of creep, on the contact of the rig itself: an oil that thins and heats."""
    rises = 0.05 * CREEPAGE / (CREEPAGE + 1.5e-3) * (1.0 - 3.0 * CREEPAGE)
    contact = full_film(None)
    peak = float(contact.peak_pressure[0])
    even = even_slip_coefficients(
        creepage=CREEPAGE, coefficient=rises, rig_modulus=MODULUS, rig_peak_pressure=peak
    )
    assert np.all(even >= rises * (1.0 - 1e-12))  # slip needs more than discs that yield
    contact = full_film(measured(CREEPAGE, even))
    creeping = [
        traction_at_creepage(contact=contact, creepage=np.array([each]), layer_factor=np.array([1.1]))
        for each in CREEPAGE
    ]
    assert [float(each.traction[0]) / LOAD for each in creeping] == pytest.approx(list(rises), rel=1e-6)
    assert [float(each.even[0]) / LOAD for each in creeping] == pytest.approx(list(even), rel=1e-9)
    assert contact.contact_length == LENGTH


def test_a_curve_goes_through_its_points_and_has_their_slope():
    rises = 0.05 * CREEPAGE / (CREEPAGE + 1.5e-3)
    curve = traction_curve(creepage=CREEPAGE, coefficient=rises)
    height, _ = curve.at(np.log(CREEPAGE))
    assert np.exp(height) == pytest.approx(rises, rel=1e-12)
    between = np.log(np.geomspace(2e-5, 0.2, 301))
    height, slope = curve.at(between)
    assert np.all(np.diff(height) >= 0.0)
    step = 1e-6
    ahead, behind = curve.at(between + step)[0], curve.at(between - step)[0]
    assert slope == pytest.approx((ahead - behind) / (2.0 * step), abs=1e-4)
    by_jax = jax.grad(lambda x: curve.at(x)[0].sum())(jnp.asarray(between))
    assert np.asarray(by_jax) == pytest.approx(slope, abs=1e-9)


def test_a_curve_is_held_beyond_its_points():
    """Below, with the slope of its start, as a film in proportion to slip; above, as it ends."""
    curve = traction_curve(creepage=CREEPAGE, coefficient=2.0 * CREEPAGE)
    height, slope = curve.at(np.log(np.array([1e-6, 0.5])))
    assert np.exp(height) == pytest.approx([2e-6, 2.0 * CREEPAGE[-1]])
    assert slope == pytest.approx([1.0, 0.0])


def test_a_capacity_is_the_largest_of_the_curve():
    even = 0.06 * CREEPAGE / (CREEPAGE + 1e-3)
    contact = full_film(measured(CREEPAGE, even))
    found = traction_capacity(contact=contact, layer_factor=np.array([1.1]), creep_limit=0.02)
    assert float(found.traction[0]) / LOAD == pytest.approx(0.06 * 0.02 / 0.021, rel=3e-3)


CONDITIONS = TractionConditions((1e9, 2e9), (313.15, 353.15), (1.0, 4.0))
VALUES = (0.08, 0.07, 0.06, 0.05, 0.1, 0.09, 0.08, 0.07)


@pytest.mark.parametrize(
    ("at", "value"),
    [
        ((1e9, 313.15, 1.0), 0.08),
        ((2e9, 353.15, 4.0), 0.07),
        ((1.5e9, 313.15, 1.0), 0.09),
        ((1e9, 333.15, 1.0), 0.07),
        ((1e9, 313.15, 2.0), 0.075),  # in the middle of the logarithms
        ((1.5e9, 333.15, 2.0), sum(VALUES) / 8.0),
        ((0.5e9, 273.15, 0.1), 0.08),  # held
        ((5e9, 400.0, 40.0), 0.07),
    ],
)
def test_a_table_is_linear_between_its_conditions(at, value):
    assert float(TractionTable(CONDITIONS, VALUES).at(*at)) == pytest.approx(value, rel=1e-12)


def test_a_data_sheet_over_temperature_is_that_of_its_temperature():
    """Maximum and slope of both temperatures at once against those of one each."""
    conditions = TractionConditions(temperatures=(313.15, 353.15))
    table = DataSheetTraction(
        TractionTable(conditions, (0.1, 0.08)), TractionTable(conditions, (200.0, 100.0))
    )
    for celsius, sheet in ((40.0, DataSheetTraction(0.1, 200.0)), (80.0, DataSheetTraction(0.08, 100.0))):
        tractions = [
            traction_at_creepage(
                contact=full_film(each, celsius=celsius),
                creepage=np.array([1e-3]),
                layer_factor=np.array([1.1]),
            ).traction
            for each in (table, sheet)
        ]
        assert float(tractions[0][0]) == pytest.approx(float(tractions[1][0]), rel=1e-12)


def test_curves_of_two_speeds_are_mixed_by_the_logarithm_of_the_speed():
    low, high = 0.05 * CREEPAGE / (CREEPAGE + 1e-3), 0.03 * CREEPAGE / (CREEPAGE + 1e-3)
    curves = tuple(traction_curve(creepage=CREEPAGE, coefficient=each) for each in (low, high))
    both = MeasuredTraction(TractionConditions(speeds=(1.0, 4.0)), curves)
    ones = [
        float(
            traction_at_creepage(
                contact=full_film(both, speed=speed), creepage=CREEPAGE[5:6], layer_factor=np.array([1.1])
            ).even[0]
        )
        / LOAD
        for speed in (1.0, 2.0, 4.0)
    ]
    assert ones == pytest.approx([low[5], 0.5 * (low[5] + high[5]), high[5]], rel=1e-9)

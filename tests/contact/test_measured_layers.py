"""Asperities beside a film by measured curves: dry where they carry all, and by strips whose asperities yield alone."""

import dataclasses
import math

import numpy as np
import pytest
from traction_contacts import HALF_WIDTH, LENGTH, LOAD, MODULUS, OILS, PEAK, oiled_contact

from asperity.contact.creep_capacity import traction_capacity
from asperity.contact.creep_inverse import creepage_at_traction
from asperity.contact.creep_law import traction_at_creepage
from asperity.contact.fluid import Fluid
from asperity.contact.measured_traction import MeasuredTraction, TractionConditions, traction_curve
from asperity.engine.derivatives import value_and_slope
from asperity.engine.module import Partial

FRICTION = 0.12


def coefficient(slip, slope, limit):
    """Traction coefficient of a film that rises with a slope up to a limit."""
    return limit * -np.expm1(-slope * slip / limit)


def beside_a_curve(*, share, slope, limit=0.08):
    """Rollers whose asperities carry a share of the load beside a film by a measured curve; what slips stays cold."""
    creepage = np.geomspace(1e-6, 0.1, 60)
    curve = traction_curve(creepage=creepage, coefficient=coefficient(creepage, slope, limit))
    traction = MeasuredTraction(TractionConditions(), (curve,))
    contact = oiled_contact("M100", 40.0, 1.0, 1e-7).contact
    changes = {"asperity_share": np.array([share]), "film_share": np.array([1.0 - share])}
    fluid = Fluid(OILS["M100"].viscosity, traction, 0.14)
    return dataclasses.replace(contact, fluid=fluid, effusivity=math.inf, **changes)


def strips(*, share, slope, limit, layer_factor, creepage, count):
    """T/N of strips of half-planes between which film and asperities lie side by side; these yield and slip.

    Slip s of the film, and of the asperities s less the strain of their layer; Newton's method.
    """
    width = 2.0 * HALF_WIDTH / count
    near = np.subtract.outer(np.arange(count), np.arange(count)) * width

    def moved(distance):
        """Displacement by a strip of unit traction, -2/(pi E*) times the integral of ln|x|."""
        ends = distance + 0.5 * width, distance - 0.5 * width
        return (
            -2.0
            / (math.pi * MODULUS)
            * (ends[0] * np.log(np.abs(ends[0])) - ends[1] * np.log(np.abs(ends[1])))
        )

    bodies = (moved(near) - moved(near + width)) / width
    compliance = 4.0 * HALF_WIDTH * (layer_factor - 1.0) / (math.pi * MODULUS) / share
    layer = compliance / width * (np.eye(count) - np.eye(count, k=1))
    place = (2.0 * np.arange(count) + 1.0) / count - 1.0
    pressure = PEAK * np.sqrt(1.0 - place**2)
    held = FRICTION * share * pressure
    stiffness = float(np.max(np.diag(bodies + layer)))
    slip = np.full(count, 0.5 * creepage)
    sums = stiffness * np.linalg.solve(bodies + layer, np.full(count, creepage))

    def misfit(slip, sums):
        film = (1.0 - share) * pressure * np.sign(slip) * coefficient(np.abs(slip), slope, limit)
        borne = np.clip(sums / stiffness, -held, held)
        left = slip + bodies @ (film + borne) - creepage, sums - stiffness * borne + layer @ borne - slip
        return np.concatenate(left), film + borne

    left, traction = misfit(slip, sums)
    for _ in range(300):
        if np.max(np.abs(left)) < 1e-10 * creepage:
            return float(traction.sum()) * width * LENGTH / LOAD
        rises = (1.0 - share) * pressure * slope * np.exp(-slope * np.abs(slip) / limit)
        sticks = (np.abs(sums / stiffness) < held) / stiffness
        matrix = np.block(
            [
                [np.eye(count) + bodies * rises, bodies * sticks],
                [-np.eye(count), np.diag(1.0 - stiffness * sticks) + layer * sticks],
            ]
        )
        step, size, part = np.linalg.solve(matrix, -left), np.linalg.norm(left), 1.0
        for _ in range(30):
            trial = misfit(slip + part * step[:count], sums + part * step[count:])
            if np.linalg.norm(trial[0]) < size:
                break
            part *= 0.5
        slip, sums, (left, traction) = slip + part * step[:count], sums + part * step[count:], trial
    raise AssertionError("the strips do not balance")


def law(contact, creepage, layer_factor):
    found = traction_at_creepage(
        contact=contact, creepage=np.array([creepage]), layer_factor=np.array([layer_factor])
    )
    return float(found.traction[0]) / LOAD, float(found.elastic_factor[0])


def test_strips_without_film_are_carters():
    """T/(mu N) = 1 - (1 - q)^2, q = E* xi/(2 mu p_0)/f of an even layer, exact without one."""
    given = {"share": 1.0, "slope": 1.0, "limit": 0.1, "layer_factor": 1.0 + 1e-12}
    creepage = 1e-3
    fine, coarse = (strips(**given, creepage=creepage, count=count) for count in (200, 100))
    q = MODULUS * creepage / (2.0 * FRICTION * PEAK)
    assert 2.0 * fine - coarse == pytest.approx(FRICTION * q * (2.0 - q), rel=2e-3)


@pytest.mark.parametrize("creepage", [1e-5, 1e-4, 1e-3, 1e-2])
def test_asperities_that_carry_nearly_all_are_dry(creepage):
    """The factor of the asperities alone, whatever the film would bear: it was 1 however little film there was."""
    found, factor = law(beside_a_curve(share=1.0 - 1e-9, slope=60.0), creepage, 1.3)
    dry, _ = law(beside_a_curve(share=1.0, slope=60.0), creepage, 1.3)
    assert factor == pytest.approx(1.3, rel=1e-6)
    assert found == pytest.approx(dry, rel=1e-6)
    used = min(MODULUS * creepage / 1.3 / (2.0 * FRICTION * PEAK), 1.0)
    assert dry == pytest.approx(FRICTION * used * (2.0 - used), rel=1e-12)


def test_a_film_that_carries_all_has_its_yield_in_its_curve():
    assert law(beside_a_curve(share=0.0, slope=60.0), 1e-4, 1.3)[1] == 1.0
    assert law(beside_a_curve(share=1e-9, slope=60.0), 1e-4, 1.3)[1] == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("layer_factor", [1.02, 1.5])
@pytest.mark.parametrize("share", [0.01, 0.1, 0.3, 0.7, 0.95])
def test_strips_whose_asperities_yield_beside_the_film(share, layer_factor):
    """Within 14 % on a grid on which a factor of 1 is off by up to 3 times."""
    for slope in (10.0, 60.0, 300.0):
        contact = beside_a_curve(share=share, slope=slope)
        for creepage in (2e-5, 2e-4, 2e-3):
            given = {"share": share, "slope": slope, "limit": 0.08, "layer_factor": layer_factor}
            fine, coarse = (strips(**given, creepage=creepage, count=count) for count in (120, 60))
            found, _ = law(contact, creepage, layer_factor)
            assert found == pytest.approx(2.0 * fine - coarse, rel=0.14), (slope, creepage)


def test_traction_rises_with_creepage_and_back():
    """One branch up to the capacity, of which the inverse finds the creepage."""
    for share in (0.001, 0.05, 0.4, 0.9):
        contact = beside_a_curve(share=share, slope=60.0)
        creepages = np.geomspace(1e-6, 0.02, 60)
        tractions = [law(contact, one, 1.4)[0] for one in creepages]
        assert np.all(np.diff(tractions) > 0.0)
        most = traction_capacity(contact=contact, layer_factor=np.array([1.4]))
        layer = Partial(lambda used: 1.4 + 0.0 * used, ())
        for at in (10, 30, 50):
            back = creepage_at_traction(
                contact=contact, traction=np.array([tractions[at] * LOAD]), layer=layer, capacity=most
            )
            assert back == pytest.approx(creepages[at], rel=1e-8)


def test_slope_of_the_traction():
    """Against central differences, the factor's own slope included."""
    contact, layer, xi, step = beside_a_curve(share=0.3, slope=60.0), np.array([1.4]), np.array([3e-4]), 1e-9

    def traction(creepage):
        return traction_at_creepage(contact=contact, creepage=creepage, layer_factor=layer).traction

    _, slope = value_and_slope(traction, (xi,), (np.ones(1),))
    ends = traction(xi + step), traction(xi - step)
    assert slope == pytest.approx((ends[0] - ends[1]) / (2.0 * step), rel=1e-6)

"""Pins as beams: by summing the load over the beam, and by the second moment of area of a circle."""

import math

import numpy as np
import pytest

from asperity.drive.structure.pin_beam import (
    pin_beam_compliance,
    pin_bending_moment,
    pin_bending_stress,
)


def test_pin_as_a_beam():
    """The moment by summing the load over the beam; a load over the whole span makes F l/8, a point load F l/4."""
    force, length, roller, diameter = 120.0, 9e-3, 5e-3, 4e-3
    at = (np.arange(10000) + 0.5) / 10000 * roller + 0.5 * (length - roller)
    share = force / at.size
    middle = 0.5 * length
    both = 0.5 * force * middle - np.sum(share * (middle - at)[at < middle])
    beam = {"force": force, "free_length": length, "roller_length": roller}
    assert float(pin_bending_moment(**beam, support="both_ends")) == pytest.approx(both, rel=1e-6)
    assert float(pin_bending_moment(**beam, support="one_end")) == pytest.approx(np.sum(share * at), rel=1e-9)
    whole = {"force": 8.0, "free_length": 1.0, "support": "both_ends"}
    assert float(pin_bending_moment(roller_length=1.0, **whole)) == pytest.approx(1.0)
    assert float(pin_bending_moment(roller_length=0.0, **whole)) == pytest.approx(2.0)
    stress = both / (math.pi * (0.5 * diameter) ** 4 / 4.0) * 0.5 * diameter
    assert float(pin_bending_stress(moment=both, diameter=diameter)) == pytest.approx(stress, rel=1e-12)
    assert math.isnan(float(pin_bending_stress(moment=both, diameter=0.0)))


@pytest.mark.parametrize("support", ["both_ends", "one_end"])
@pytest.mark.parametrize("roller", [1e-9, 5e-3, 9e-3])
def test_a_pin_gives_way_by_the_energy_of_its_moments_and_shear_forces(support, roller):
    """Work of a newton is twice the energy of M^2/EI + V^2/kGA along the pin, summed over short pieces."""
    length, diameter, modulus, poisson = 9e-3, 4e-3, 206e9, 0.3
    count = 400_000
    at = (np.arange(count) + 0.5) / count * length
    start, step = 0.5 * (length - roller), length / count
    passed = np.clip((at - start) / roller, 0.0, 1.0)  # share of the load to the left
    shear = 0.5 - passed if support == "both_ends" else 1.0 - passed
    moment = np.cumsum(shear) * step
    if support == "one_end":
        moment = moment - moment[-1]
    inertia, area = math.pi * diameter**4 / 64.0, math.pi * diameter**2 / 4.0
    factor = 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson)
    sheared = np.sum(shear**2) * step / (factor * modulus / (2.0 * (1.0 + poisson)) * area)
    expected = np.sum(moment**2) * step / (modulus * inertia) + sheared
    found = pin_beam_compliance(
        free_length=length,
        roller_length=roller,
        diameter=diameter,
        youngs_modulus=modulus,
        poisson_ratio=poisson,
        support=support,
    )
    assert float(found) == pytest.approx(expected, rel=1e-4)


def test_slender_pins_are_those_of_handbooks():
    """A force in the middle l^3/48EI; mean deflection of an even load l^3/120EI; half way on a cantilever l^3/24EI."""
    beam = {
        "free_length": 1.0,
        "diameter": 1e-3,
        "youngs_modulus": 64.0 / math.pi * 1e12,
        "poisson_ratio": 0.3,
    }
    for support, roller, expected in (
        ("both_ends", 0.0, 1.0 / 48.0),
        ("both_ends", 1.0, 1.0 / 120.0),
        ("one_end", 0.0, 1.0 / 24.0),
    ):
        found = pin_beam_compliance(roller_length=roller, support=support, **beam)
        assert float(found) == pytest.approx(expected, rel=1e-5)

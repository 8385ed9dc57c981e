"""Pins as beams: by summing the load over the beam, and by the second moment of area of a circle."""

import math

import numpy as np
import pytest

from asperity.drive.structure.pin_beam import pin_bending_moment, pin_bending_stress


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

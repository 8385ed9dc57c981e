"""The stiffness of one contact at a roller, and of a joint in users' units."""

import math

import pytest

from asperity.drive.stiffness.torsional_stiffness import (
    ARCMINUTE,
    TorsionalStiffness,
    contact_torsional_stiffness,
)


def test_a_contact_at_the_surface_of_its_roller():
    """A moment of 1 N·m at a radius of 13.5 mm: its force moves the spring, and the roller turns by that arc."""
    displacement = 1.0 / 13.5e-3 / 2e8
    stiffness = contact_torsional_stiffness(tangential_stiffness=2e8, radius=13.5e-3)
    assert stiffness == pytest.approx(1.0 / (displacement / 13.5e-3), rel=1e-14)


def test_stiffness_over_an_arcminute():
    assert pytest.approx(math.radians(1 / 60), rel=1e-15) == ARCMINUTE
    assert TorsionalStiffness(1.0, 500.0).output_per_arcminute == pytest.approx(
        500.0 * math.pi / 180 / 60, rel=1e-14
    )

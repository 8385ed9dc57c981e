"""Masses of the rollers of the paper's drive."""

import dataclasses

import numpy as np
import pytest

from asperity.joint.masses import loading_roller_mass, planet_mass, roller_mass


def test_solid_and_hollow_rollers():
    solid = roller_mass(density=7850.0, radius=13.5e-3, length=5e-3, bore=0.0)
    assert solid == pytest.approx(np.pi * 7850.0 * 13.5e-3**2 * 5e-3, rel=1e-12)
    # a bore of half the diameter takes a quarter
    assert roller_mass(density=7850.0, radius=13.5e-3, length=5e-3, bore=13.5e-3) == pytest.approx(
        0.75 * solid, rel=1e-12
    )


def test_each_roller_by_its_own_numbers(paper_joint):
    """Steel of 7850 kg/m^3: 22.47 g and 3.083 g for 5 mm of length; bores of a third take a ninth."""
    joint = paper_joint()
    assert float(planet_mass(joint)) == pytest.approx(22.473e-3, rel=1e-4)
    assert float(loading_roller_mass(joint)) == pytest.approx(3.0827e-3, rel=1e-4)
    hollow = dataclasses.replace(joint, planet_bore=9e-3, loading_roller_bore=10e-3 / 3.0)
    assert float(planet_mass(hollow) / planet_mass(joint)) == pytest.approx(8.0 / 9.0, rel=1e-12)
    assert float(loading_roller_mass(hollow) / loading_roller_mass(joint)) == pytest.approx(
        8.0 / 9.0, rel=1e-12
    )

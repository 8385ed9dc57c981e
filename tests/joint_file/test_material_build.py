"""Materials and surfaces from tables in SI units."""

import math

import pytest

from asperity.joint_file.section_build import material_of, surface_of
from asperity.surface.roughness_average import roughness_average

STEEL = {"youngs_modulus": 206e9, "poisson_ratio": 0.3, "density": 7850.0, "yield_strength": 450e6}


def test_hardness_is_the_factor_times_the_yield_strength_unless_stated():
    assert material_of(STEEL | {"hardness_factor": 2.8}).hardness == 2.8 * 450e6
    assert material_of(STEEL | {"hardness": 7e9}).hardness == 7e9


def test_what_a_material_may_leave_out():
    plain = material_of(STEEL | {"hardness": 7e9})
    assert (plain.youngs_modulus, plain.poisson_ratio, plain.density, plain.yield_strength) == (
        206e9,
        0.3,
        7850.0,
        450e6,
    )
    names = ("thermal_conductivity", "specific_heat_capacity", "thermal_expansion", "fatigue_strength")
    assert [getattr(plain, name) for name in (*names, "tensile_strength")] == [None] * 5
    given = dict(zip((*names, "tensile_strength"), (46.0, 460.0, 12e-6, 300e6, 900e6), strict=True))
    full = material_of(STEEL | {"hardness": 7e9} | given)
    assert {name: getattr(full, name) for name in given} == given


def test_a_surface_by_its_g():
    entry = {"fractal_dimension": 1.4, "fractal_roughness": 1e-11, "frequency_ratio": 1.5}
    surface = surface_of(entry, asperity_base="circular_spot", contact_law="zou_2025")
    assert (surface.fractal_dimension, surface.fractal_roughness, surface.frequency_ratio) == (
        1.4,
        1e-11,
        1.5,
    )
    assert surface.asperity_base == "circular_spot"


@pytest.mark.parametrize(
    ("given", "average", "cut_off"),
    [
        ({}, math.sqrt(2.0) * 0.4e-6, 0.8e-3),  # ISO 4288: 0.8 mm for 0.1 to 2 um
        ({"partner_roughness_average": 0.3e-6}, 0.5e-6, 0.8e-3),  # 3, 4, 5
        ({"cut_off": 0.25e-3}, math.sqrt(2.0) * 0.4e-6, 0.25e-3),
    ],
)
def test_a_surface_by_the_ra_of_its_bodies(given, average, cut_off):
    """The equivalent surface has the root of the sum of squares of both Ra."""
    entry = {"fractal_dimension": 1.4, "roughness_average": 0.4e-6, "frequency_ratio": 1.5} | given
    surface = surface_of(entry, asperity_base="majumdar_bhushan_1991", contact_law="zou_2025")
    found = roughness_average(
        fractal_dimension=1.4, fractal_roughness=surface.fractal_roughness, cut_off=cut_off
    )
    assert float(found) == pytest.approx(average, rel=1e-9)

"""A measured surface in the place of a joint file's."""

import tomllib

import jax.numpy as jnp
import pytest

from asperity.errors import InputError
from asperity.joint_file.drawn_surface import with_measured_surface
from asperity.joint_file.edited_text import joint_file_text
from asperity.surface.measurement import SurfaceMeasurement

NUMBERS = {"fractal_dimension": 1.25, "fractal_roughness": 3e-13, "frequency_ratio": 1.5}


def measured(**numbers):
    return SurfaceMeasurement(
        **{name: jnp.asarray(value) for name, value in (NUMBERS | numbers).items()},
        covariance=jnp.eye(2) * 1e-4,
        shortest_wavelength=jnp.asarray(1e-6),
        longest_wavelength=jnp.asarray(1e-3),
        estimator="test",
        profiles=1,
        source="test",
    )


def test_it_holds_for_every_contact_without_losing_a_digit(example_case):
    surface = with_measured_surface(example_case, measured()).surface
    assert {name: getattr(surface, name).value for name in NUMBERS} == pytest.approx(
        NUMBERS, rel=1e-15, abs=0.0
    )
    assert surface.roughness_average is None


def test_it_is_written_instead_of_the_files(example_case):
    case = with_measured_surface(example_case, measured())
    found = tomllib.loads(joint_file_text(case, {"load.preload": 900.0}, comment=""))
    assert found["surface"]["fractal_dimension"] == 1.25
    number, unit = found["surface"]["fractal_roughness"].split()
    assert float(number) * {"m": 1.0, "mm": 1e-3}[unit] == pytest.approx(3e-13, rel=1e-12, abs=0.0)
    assert found["load"]["preload"] == "900 N"


def test_what_no_joint_file_may_have_is_refused(example_case):
    with pytest.raises((InputError, ValueError), match="fractal_dimension"):
        with_measured_surface(example_case, measured(fractal_dimension=2.1))


def test_it_takes_the_place_of_those_of_other_drives(planar_case):
    case = with_measured_surface(planar_case("planetary"), measured())
    assert {name: getattr(case.surface, name).value for name in NUMBERS} == pytest.approx(
        NUMBERS, rel=1e-15, abs=0.0
    )
    assert case.type == "planetary"

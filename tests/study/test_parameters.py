"""Axes are read with units, and refused with a reason."""

import dataclasses
import json

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.parameters import (
    Axis,
    ListedAxis,
    axis_from_dict,
    check_axes,
    check_axis,
    long_name,
    parse_axis,
)


def test_units_are_converted_and_ends_are_exact():
    axis = parse_axis("drive.contact_length = 5 mm : 3 cm : 6")
    np.testing.assert_allclose(axis.values, [0.005, 0.010, 0.015, 0.020, 0.025, 0.030], rtol=1e-15)
    assert axis.values[0] == 0.005
    assert axis.values[-1] == 0.03


def test_logarithmic_steps_have_a_constant_ratio():
    values = parse_axis("surface.fractal_roughness=1e-10 mm:1e-8 mm:5:log").values
    np.testing.assert_allclose(values[1:] / values[:-1], 10.0**0.5, rtol=1e-12)
    assert values[0] == 1e-13


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("load.output_torque", "write KEY="),
        ("load.output_torque=0 N*m:5 N*m", "write KEY="),
        ("load.torque=0 N*m:5 N*m:3", "did you mean"),
        ("load.output_torque=0 N:5 N:3", "expected a torque"),
        ("load.output_torque=0:5:3", "expected a torque"),
        ("load.output_torque=0 N*m:5 N*m:0", "at least 1"),
        ("load.output_torque=0 N*m:5 N*m:x", "whole number"),
        ("load.output_torque=0 N*m:5 N*m:1", "above 1"),
        ("load.output_torque=0 N*m:5 N*m:1000000000000", "at most 10000000, got 1000000000000"),
        ("load.output_torque=0 N*m:5 N*m:99999999999999999999999:log", "above 0|at most 10000000"),
        ("load.output_torque=5 N*m:5 N*m:3", "must differ"),
        ("load.output_torque=0 N*m:5 N*m:3:log", "above 0"),
        ("load.output_torque=0 N*m:5 N*m:3:cubic", "'log'"),
        ("surface.fractal_dimension=1.1:2.5:3", "below 2"),
        ("drive.planets=2:5:3", "whole number"),
        ("model.closure=1:2:3", "no number"),
    ],
)
def test_nonsense_is_refused_with_a_reason(text, told):
    with pytest.raises(InputError, match=told):
        parse_axis(text)


@pytest.mark.parametrize(
    "paths",
    [
        ("load.preload", "load.preload"),
        ("surface.fractal_dimension", "surface.sp.fractal_dimension"),
        ("load.friction_coefficient.pwr", "load.friction_coefficient"),
        ("materials.steel.hardness", "materials.steel.hardness_factor"),
        ("load.preload", "load.interference"),
        ("load.output_speed", "load.sun_speed"),
    ],
)
def test_two_axes_for_one_number_are_refused(case, paths):
    with pytest.raises(InputError, match="vary it once"):
        check_axes(
            case, [Axis(path, 1.5, 1.6, 2, "linear") if "fractal" in path else _axis(path) for path in paths]
        )


def _axis(path):
    ends = {
        "load.preload": (900.0, 1000.0),
        "materials.steel.hardness": (1e9, 2e9),
        "materials.steel.hardness_factor": (2.0, 3.0),
    }
    return Axis(path, *ends.get(path, (0.1, 0.2)), 2, "linear")


def test_a_material_that_the_file_does_not_have_is_refused(case):
    with pytest.raises(InputError, match="did you mean 'steel'"):
        check_axes(case, [parse_axis("materials.stel.density=7000 kg/m^3:8000 kg/m^3:2")])


def test_different_contacts_are_different_numbers(case):
    check_axes(
        case,
        [parse_axis(f"surface.{contact}.fractal_dimension=1.3:1.5:2") for contact in ("sp", "pwr")],
    )


def test_names_in_words():
    assert long_name("surface.sp.fractal_dimension") == "fractal dimension, sp"
    assert long_name("materials.steel.poisson_ratio") == "Poisson's ratio, steel"
    assert long_name("compliance.pin_stiffness") == "pin stiffness (compliance)"


def test_listed_values_keep_their_order_and_are_named_once():
    axis = ListedAxis("load.preload", (800.0, 2000.0, 1000.0))
    assert (axis.count, axis.values.tolist()) == (3, [800.0, 2000.0, 1000.0])
    plain = json.loads(json.dumps(dataclasses.asdict(axis)))
    assert axis_from_dict(plain).values.tolist() == axis.values.tolist()
    with pytest.raises(InputError, match="the value 800 N is listed twice; list it once"):
        check_axis(ListedAxis("load.preload", (800.0, 800.0)))
    with pytest.raises(InputError, match=r"load\.preload: -1 N is not allowed"):
        check_axis(ListedAxis("load.preload", (800.0, -1.0)))

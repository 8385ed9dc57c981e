"""Transmission error and life under wear in studies: as one joint has them, with exact derivatives."""

import math

import numpy as np
import pytest
from tests.support.form_errors import check_joint
from tests.support.worn import EXAMPLES

from asperity.engine.control import at_once
from asperity.errors import InputError
from asperity.joint_file.accuracy import joint_accuracy, turn_errors_of
from asperity.joint_file.own_branches import joint_with_branches
from asperity.joint_file.part_names import with_structure
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import numeric_keys, replace_values, si_values
from asperity.joint_file.solved_document import solved_case
from asperity.results.wear_rows import worn_life
from asperity.rolling.wear_life import wear_life
from asperity.study.batch import derivatives_at, evaluate_points

FORM = """
[[form]]
part = "ring"
runout = "4 um"
harmonics = { 3 = "1 um" }

[[form]]
part = "planet"
harmonics = { 3 = "0.3 um" }
"""
ERRORS = ("transmission_error", "transmission_error_rms", "turn_slip_ratio")
LIVES = ("life_wear", "preload_after_life")


def of_turn(values):
    with np.errstate(all="ignore"):
        return np.array([float(each) for each in turn_errors_of(with_structure(values))])


def of_wear(values):
    def found():
        joint = joint_with_branches(values)
        largest = joint.wear_coefficients[0]
        life = wear_life(joint, np.ones(5), largest * values["rolling"]["required_life"])
        return life.time / largest, life.preload

    return np.array(at_once(found), dtype=float)


def differences(function, values, path, number):
    """Central differences of results by one number of a file."""
    step = 1e-4 * abs(number)
    ends = [function(replace_values(values, {path: number + sign * step})) for sign in (-1.0, 1.0)]
    return (ends[1] - ends[0]) / (2.0 * step)


@pytest.mark.parametrize(
    ("case", "results", "function", "paths"),
    [
        pytest.param(
            lambda: parse_case(check_joint() + FORM, source="joint"),
            ERRORS,
            of_turn,
            ("form.1.harmonics.3", "load.output_torque", "load.interference"),
            marks=pytest.mark.slow,
            id="turn",
        ),
        pytest.param(
            lambda: read_case(EXAMPLES / "wear.toml"),
            LIVES,
            of_wear,
            ("wear.coefficient", "load.output_torque", "load.interference"),
            marks=pytest.mark.long,
            id="wear",
        ),
    ],
)
def test_derivatives(case, results, function, paths):
    """Against central differences of the same functions by the other engine."""
    case = case()
    values, keys = si_values(case), numeric_keys(case)
    changes = {path: np.array([keys[path].value]) for path in paths}
    status, found, slopes = derivatives_at(values, changes, results, paths)
    assert status.tolist() == [0]
    here = function(values)
    np.testing.assert_allclose([found[name][0, 0] for name in results], here, rtol=1e-8)
    for number, path in enumerate(paths):
        expected = differences(function, values, path, keys[path].value)
        scale = 1e-9 * here / abs(keys[path].value)
        for k, name in enumerate(results):
            assert slopes[name][0, 0, number] == pytest.approx(expected[k], rel=2e-5, abs=scale[k])


@pytest.mark.slow
def test_sweeps():
    """Points of a sweep have what one joint has that is solved alone, by the whole course of its wear."""
    case = read_case(EXAMPLES / "wear.toml")
    torques = np.array([4.0, 6.0])
    status, found = evaluate_points(si_values(case), {"load.output_torque": torques}, LIVES)
    assert status.tolist() == [0, 0]
    for k, torque in enumerate(torques):
        text = case.text.replace('output_torque = "5 N*m"', f'output_torque = "{torque} N*m"')
        alone = worn_life(solved_case(parse_case(text, source="wear.toml")))
        assert found["life_wear"][k] == pytest.approx(alone.time, rel=1e-6)
        if math.isnan(alone.preload):
            assert np.isnan(found["preload_after_life"][k])
        else:
            assert found["preload_after_life"][k] == pytest.approx(alone.preload, rel=1e-6)


@pytest.mark.slow
def test_transmission_error_over_a_runout():
    case = parse_case(check_joint() + FORM, source="joint")
    sizes = np.array([0.5e-6, 1e-6])
    _, found = evaluate_points(si_values(case), {"form.1.harmonics.3": sizes}, ERRORS)
    alone = joint_accuracy(case).forward.transmission_error
    assert found["transmission_error"][1] == pytest.approx(float(alone.worst), rel=1e-7)
    assert found["transmission_error_rms"][1] == pytest.approx(float(alone.rms), rel=1e-7)
    assert found["transmission_error"][0] < found["transmission_error"][1]


def test_the_number_of_sectors_does_not_vary_with_form_errors():
    values = si_values(parse_case(check_joint() + FORM, source="joint"))
    with pytest.raises(InputError, match=r"drive.planets cannot vary with transmission_error"):
        evaluate_points(values, {"drive.planets": np.array([3.0, 4.0])}, ERRORS)

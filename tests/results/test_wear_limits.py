"""Life and preload under wear, judged where a coefficient and a required life are stated."""

import math

import pytest
from tests.support.worn import COEFFICIENT, check_case

from asperity.joint_file.solved_document import solved_case
from asperity.results.all_limits import further_checks
from asperity.results.margins import margins
from asperity.results.wear_limits import wear_checks

STATED = 'interference = "12.9043 um"'


def solved(hours, changes=None, more=COEFFICIENT):
    life = "" if hours is None else f'\n[rolling]\nrequired_life = "{hours} h"\n'
    return solved_case(check_case(changes, more + life))


def by_name(joint):
    return {check.result.name: check for check in wear_checks(joint)}


def test_nothing_is_judged_without_a_life_or_a_coefficient():
    assert wear_checks(solved(None)) == ()
    assert wear_checks(solved(2000, more="")) == ()


def test_a_life_that_wear_leaves():
    """An independent program has 5430.5 h to the first slide, and 737.9 N after half of 5593.8 h."""
    joint = solved(0.5 * 5593.8)
    found = by_name(joint)
    assert all(check.ok for check in found.values())
    assert found["life_wear"].value / 3600.0 == pytest.approx(5430.5, rel=5e-3)
    assert found["life_wear"].limit == pytest.approx(0.5 * 5593.8 * 3600.0)
    assert found["preload_after_life"].value == pytest.approx(737.9, rel=2e-3)
    assert {"life_wear", "preload_after_life"} <= {check.result.name for check in further_checks(joint)}
    assert {"life_wear", "preload_after_life"} <= {margin.result.name for margin in margins(joint)}


def test_a_life_that_wear_does_not_leave():
    found = by_name(solved(20000))
    assert not found["life_wear"].ok
    assert found["life_wear"].known
    assert "slide before rolling.required_life" in found["life_wear"].meaning
    assert math.isnan(found["preload_after_life"].value)
    assert "does not carry its load so long" in found["preload_after_life"].meaning


def test_a_preload_force_leaves_it_unknown():
    found = by_name(solved(2000, {STATED: 'preload = "1000 N"'}))
    for check in found.values():
        assert not check.known
        assert "state load.interference" in check.meaning


def test_a_cam_lasts():
    found = by_name(solved(2000, {STATED: 'preload = "200 N"\ncam_force_per_torque = "160 N/Nm"'}))
    assert found["life_wear"].value == math.inf
    assert found["life_wear"].ok
    assert found["preload_after_life"].value == pytest.approx(1000.0, rel=1e-6)


def test_a_joint_that_does_not_roll_is_not_judged():
    found = by_name(solved(2000, {'output_torque = "5 N*m"': 'output_torque = "12.5 N*m"'}))
    assert "no life under wear: " in found["life_wear"].meaning
    assert "does not roll at the start" in found["life_wear"].meaning

"""Rows of the loads of pins and ring, of rolling bearings, and of rings and hollow rollers, by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.drive.layout.drive import Body, Contact, Drive
from asperity.joint.body_shape import SOLID, BodyShape, on_pin
from asperity.results import RESULTS
from asperity.results.load_rows import ROWS
from asperity.results.solved import SolvedJoint

FREE, HELD = BodyShape("ring", 5e-3, "free"), BodyShape("ring", 5e-3, "rigid_housing")
STRESSES = [row for row in ROWS if row.group == "stresses"]
HOLLOW = BodyShape("hollow", 10e-3)


def test_torques_of_the_papers_joint(value):
    """5 N·m at the carrier; the sun's 5/9 N·m turns the other way, so that the ring holds both."""
    assert abs(value("grounded_torque")) == pytest.approx(5.0 * (1.0 + 1.0 / 9.0), rel=1e-3)
    assert value("pin_load").shape == (2,)
    # both pins of a branch turn the carrier, at 35 mm from the axis: (F_right - F_left) cos(push angle 0)
    assert 3.0 * 35e-3 * abs(np.diff(value("pin_load"))[0]) == pytest.approx(5.0, rel=0.02)


def test_a_joint_without_ratings_has_no_lives(paper_joint):
    solved = SolvedJoint(paper_joint(), SimpleNamespace(solved=np.array([True, True])), None)
    assert RESULTS["bearing_life"].of(solved).shape == (4, 2)
    assert np.all(np.isnan(np.asarray(RESULTS["bearing_static_safety"].of(solved))))


def test_limits_of_bearings():
    """ISO 76: at least as strong as the load; ISO 281: valid up to half the dynamic rating."""
    safety, ratio = RESULTS["bearing_static_safety"].limit, RESULTS["bearing_load_ratio"].limit
    assert [safety.is_kept(value) for value in (0.99, 1.0, 5.0)] == [False, True, True]
    assert [ratio.is_kept(value) for value in (0.1, 0.5, 0.51)] == [True, True, False]


class Solved(SimpleNamespace):
    def row_names(self, axis):
        assert axis == "body"
        return ("sun", "planet", "ring")


def solved(*shapes, strengths=(3e8, 3e8, 3e8)):
    """A planetary drive; stresses of the inner and of the outer rim of sun, planet and ring [MPa], all different."""
    drive = Drive(
        bodies=(Body("sun", "axis"), Body("planet", "pin"), Body("ring", "axis")),
        contacts=(Contact("sp", "sun", "planet"), Contact("pr", "planet", "ring", internal=True)),
        centres=np.array([[0.0, 0.0], [0.0, 30e-3], [0.0, 0.0]]),
        first_radius=np.array([10e-3, 20e-3]),
        second_radius=np.array([20e-3, 50e-3]),
        push_angles=np.zeros(1),
        sectors=3.0,
        input="sun",
        output="carrier",
        grounded="ring",
    )
    both = 1e6 * np.array([[1.0, 50.0, -80.0], [2.0, -60.0, 30.0]])
    safety = np.array([9.0, 2.0, 0.5])
    return Solved(
        joint=SimpleNamespace(
            drive=drive,
            shapes=shapes,
            materials=tuple(SimpleNamespace(fatigue_strength=strength) for strength in strengths),
            contact_lengths=(10e-3,),
            housing=None,
        ),
        rims=SimpleNamespace(
            stress=both,
            stress_at_rest=0.5 * both,
            amplitude=abs(both),
            yield_safety=safety,
            fatigue_safety=safety + 1.0,
        ),
    )


def table(joint):
    return {row.name: {name: float(value) for name, value in row.rows_of(joint).items()} for row in STRESSES}


def test_the_larger_rim_of_every_body_that_bends():
    found = table(solved(SOLID, HOLLOW, FREE))
    assert found["rim_stress"] == {"planet": 50e6, "ring": 30e6}
    assert found["rim_stress_at_rest"] == {"planet": 25e6, "ring": 15e6}
    assert found["rim_stress_amplitude"] == {"planet": 60e6, "ring": 80e6}
    assert found["rim_yield_safety"] == {"planet": 2.0, "ring": 0.5}
    assert found["rim_fatigue_safety"] == {"planet": 3.0, "ring": 1.5}


@pytest.mark.parametrize(
    ("shapes", "bent"), [((SOLID, SOLID, HELD), set()), ((SOLID, SOLID, FREE), {"ring"})]
)
def test_a_ring_in_a_housing_and_solid_rollers_do_not_bend(shapes, bent):
    assert {name for rows in table(solved(*shapes)).values() for name in rows} == bent


def test_the_bore_of_a_roller_on_a_pin():
    assert table(solved(SOLID, HOLLOW, FREE))["bore_stress"] == {}
    assert table(solved(SOLID, on_pin(HOLLOW, 8e-3, 20e-3), FREE))["bore_stress"] == {"planet": 50e6}


def test_fatigue_is_judged_where_its_strength_is_known():
    found = table(solved(SOLID, HOLLOW, FREE, strengths=(3e8, None, 3e8)))
    assert list(found["rim_fatigue_safety"]) == ["ring"]
    assert list(found["rim_yield_safety"]) == ["planet", "ring"]


def test_a_safety_below_one_is_a_warning():
    limits = {row.name: row.limit for row in STRESSES if row.limit is not None}
    pressure = limits.pop("seat_pressure")  # of a ring on its housing, which a pull of the rollers lifts off
    assert [pressure.is_kept(value) for value in (-1.0, 0.0, 1.0, float("nan"))] == [
        False,
        False,
        True,
        False,
    ]
    assert set(limits) == {"rim_yield_safety", "rim_fatigue_safety"}
    assert all(limit.is_kept(1.01) and not limit.is_kept(0.99) for limit in limits.values())

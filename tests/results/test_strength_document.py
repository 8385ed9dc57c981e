"""Entries of bearings and bending bodies, from results made by hand."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.drive.structure.bearing_life import RatedBearing
from asperity.joint.bearing_lives import BearingLives
from asperity.joint.rim_safety import BodyRims
from asperity.results.strength_document import bearing_entries, rim_entry


def bearing(*, life, duty_life, load=10.0, duty=("a load",)):
    def filled(value):
        return np.full(2, value)

    joint = SimpleNamespace(
        bearing_names=("pin", "sun"),
        rated_bearings=(None, RatedBearing(1000.0, 900.0, 1.0, load, "ball")),
        rolling=SimpleNamespace(duty=duty),
    )
    lives = BearingLives(filled(load), filled(life), filled(duty_life), filled(90.0), filled(0.01))
    (entry,) = bearing_entries(SimpleNamespace(joint=joint, bearings=lives))
    return entry


def test_lives_are_in_hours():
    entry = bearing(life=3600e3, duty_life=7200e3)
    assert (entry["bearing"], entry["type"]) == ("sun", "ball")
    assert (entry["life_hours"], entry["duty_life_hours"]) == (1e3, 2e3)
    assert entry["absent_because"] == []


@pytest.mark.parametrize(
    ("numbers", "said"),
    [
        ({"life": math.nan, "duty_life": 1.0}, ["it stands"]),
        ({"life": math.inf, "duty_life": math.inf}, ["no load"]),
        ({"life": 1.0, "duty_life": math.nan}, ["under the duty"]),
        ({"life": 1.0, "duty_life": math.inf}, ["turns it"]),
        ({"life": math.nan, "duty_life": 1.0, "load": math.nan}, ["not known"]),
        ({"life": 1.0, "duty_life": math.nan, "duty": ()}, []),
    ],
)
def test_what_is_absent_has_a_reason(numbers, said):
    entry = bearing(**numbers)
    assert len(entry["absent_because"]) == len(said)
    assert all(words in text for words, text in zip(said, entry["absent_because"], strict=True))


def test_both_rims_of_a_body_that_bends():
    rims = BodyRims(
        *(np.array([1.0, 2.0]) * factor for factor in (1, 2, 3, 4)), np.float64(5.0), np.float64(np.nan)
    )
    assert rim_entry(rims) == {
        "stress_Pa": {"inner": 1.0, "outer": 2.0},
        "stress_at_rest_Pa": {"inner": 2.0, "outer": 4.0},
        "mean_Pa": {"inner": 3.0, "outer": 6.0},
        "amplitude_Pa": {"inner": 4.0, "outer": 8.0},
        "yield_safety": 5.0,
        "fatigue_safety": None,
    }

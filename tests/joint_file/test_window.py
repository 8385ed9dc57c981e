"""The axis of a window: what it extends over, from where to where, and what is refused."""

from pathlib import Path

import pytest
import windows

import asperity
from asperity.errors import InputError
from asperity.joint_file.si_tables import si_values
from asperity.joint_file.window import joint_window, temperature_matters, window_key
from asperity.results.limit_torques import LIMITS

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def wheels():
    return asperity.load(EXAMPLES / "wheel_pair.toml")


@pytest.fixture(scope="module")
def housed(wheels):
    return wheels.edited(windows.housed())


def test_temperature_is_the_axis_where_something_depends_on_it(wheels, housed):
    assert window_key(si_values(housed.case), None) == "temperature.working"
    assert window_key(si_values(housed.case), "preload") == "load.interference"
    assert window_key(si_values(wheels.case), None) == "load.preload"
    assert temperature_matters(si_values(housed.case))
    assert not temperature_matters(si_values(wheels.case))


@pytest.mark.slow
def test_temperatures_lie_around_those_of_the_file(housed):
    """20 degC at the assembly and 40 degC at work, at least 20 K beyond both."""
    axis = joint_window(housed.case, points=3).axis
    assert (axis.over, axis.unit, axis.working) == ("temperature", "degC", 40.0)
    assert axis.places == pytest.approx([0.0, 30.0, 60.0])


def test_preloads_reach_from_a_quarter_to_twice_that_of_the_file(wheels):
    axis = joint_window(wheels.case, points=2).axis
    assert (axis.label, axis.unit) == ("preload", "N")
    assert axis.places == pytest.approx([250.0, 2000.0])


@pytest.mark.slow
def test_preloads_reach_farther_where_the_file_has_too_much_or_little():
    """The paper's soft steel yields at its preload; the multiroller breaks by fatigue only far beyond its own."""
    soft = joint_window(asperity.load(EXAMPLES / "zou2025.toml").case, points=2)
    assert soft.axis.places == pytest.approx([1000.0 / 16.0, 2000.0])
    assert soft.regions[0].capacity.torque[0] > 0.0
    strong = joint_window(asperity.load(EXAMPLES / "multiroller.toml").case, points=2)
    assert strong.axis.places == pytest.approx([10e-6, 320e-6])
    assert "slip" not in LIMITS[strong.regions[0].capacity.limit[-1]]


def test_ends_that_are_asked_for(wheels):
    window = joint_window(wheels.case, start=400.0, stop=800.0, points=3)
    assert window.axis.places == pytest.approx([400.0, 600.0, 800.0])
    assert window.at[window.working] == 1000.0  # also outside of the axis


@pytest.mark.parametrize(
    ("given", "said", "options"),
    [
        ({"points": 1}, "the number of points must be from 2 to 500, got 1", ("points",)),
        ({"points": 501}, "from 2 to 500, got 501", ("points",)),
        (
            {"start": 900.0, "stop": 200.0},
            "from 900 N to 200 N it does not; choose a start below",
            ("from", "to"),
        ),
        ({"start": 500.0, "stop": 500.0}, "from 500 N to 500 N it does not", ("from", "to")),
        ({"start": 0.0}, "load.preload: 0 N is not allowed; it must be at least 0.001 N", ("from",)),
        ({"stop": 1e12}, "load.preload: 1e12 N is not allowed", ("to",)),
        ({"over": "temperature"}, r"no section \[temperature\].*choose the window over preload", ("over",)),
    ],
)
def test_what_is_refused(wheels, given, said, options):
    with pytest.raises(InputError, match=said) as refused:
        joint_window(wheels.case, **given)
    assert tuple(refused.value.options) == options


def test_a_temperature_that_is_impossible_is_refused(housed):
    with pytest.raises(InputError, match=r"temperature\.working: -300 degC is not allowed") as refused:
        joint_window(housed.case, start=-300.0)
    assert tuple(refused.value.options) == ("from",)


def test_temperature_of_a_preload_that_a_spring_keeps_changes_nothing(wheels):
    text = (EXAMPLES / "wheel_pair.toml").read_text()
    warm = wheels.edited(text + '\n[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n')
    assert window_key(si_values(warm.case), None) == "load.preload"
    with pytest.raises(InputError, match="temperature changes neither the preload"):
        joint_window(warm.case, over="temperature")


@pytest.mark.slow
def test_progress_is_reported(wheels):
    told = []
    joint_window(
        wheels.case, start=500.0, stop=1000.0, points=2, report=lambda done, total: told.append((done, total))
    )
    assert told
    assert all(0 < done <= total for done, total in told)

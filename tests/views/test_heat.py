"""What is read about the temperatures of a joint: that it settles, and that it runs away."""

import copy

import pytest

from asperity.views.heat import at_temperature, heat, temperature_figure

STEADY = {
    "ambient_degC": 25.0,
    "resistance_K_per_W": 3.0,
    "roller_resistance_K_per_W": 0.5,
    "oil_limit_degC": 120.0,
    "steady": True,
    "unsteady_because": None,
    "roller_temperature_degC": 42.5,
    "housing_temperature_degC": 40.0,
    "loss_W": 5.0,
    "gain": -0.5,
    "ambient_reserve_K": 20.0,
    "time_constant_s": 1200.0,
    "steady_torque_Nm": None,
    "other_states": [{"roller_temperature_degC": 88.0, "stable": False}],
    "duty": {
        "mean_degC": 35.0,
        "peak_degC": None,
        "peak_beyond_oil_limit": True,
        "alone_degC": {"1": None, "2": 33.0},
    },
    "cold_start": {
        "rolling_torque_capacity_Nm": 20.0,
        "standing_torque_capacity_Nm": 28.0,
        "input_torque_Nm": 2.0,
        "efficiency": 0.8,
    },
}


@pytest.fixture
def runaway():
    """A joint that has no steady temperature, without duty and cold start."""
    found = copy.deepcopy(STEADY)
    found |= {
        "steady": False,
        "unsteady_because": "thermal runaway",
        "roller_temperature_degC": None,
        "housing_temperature_degC": None,
        "loss_W": None,
    }
    found |= {"gain": None, "ambient_reserve_K": -3.0, "time_constant_s": None, "steady_torque_Nm": 4.0}
    return found | {"other_states": [], "duty": None, "cold_start": {}}


def rows(document):
    """The rows of the table by their first words."""
    table, *_ = heat(document)
    return {name: (value, words) for name, value, words in table.rows}


def test_nothing_where_the_temperature_is_stated():
    assert list(heat({})) == temperature_figure({}) == []
    assert at_temperature({}) == ""


def test_a_drive_that_settles():
    film = {"rolling": {"contacts": {"sp": {"film_thickness_m": 2e-7}}}}
    found = rows({"heat": STEADY} | film)
    assert found["rollers and oil"] == ("42.5 degC", "0.5 K/W to the housing")
    assert found["housing and rings"] == ("40 degC", "3 K/W to 25 degC")
    assert found["time constant"][0] == "20 min"
    assert found["cold start, input"][1].endswith("efficiency 80 %")
    assert found["duty, peak"][1] == "beyond the limit of the oil"
    assert found["duty, load 1 alone"] == ("–", "none if it lasts: the drive runs away, or slips")
    (figure,) = temperature_figure({"heat": STEADY} | film)
    assert (figure.shown, figure.unit) == ("42.5", "°C")
    assert figure.detail.startswith("rollers and oil, steady; 25 degC")
    assert at_temperature({"heat": STEADY}) == " at 42.5 °C"


def test_words_where_there_is_no_number():
    """A duty without a mean temperature, a joint that does not turn cold, losses that no temperature changes."""
    none = copy.deepcopy(STEADY)
    none["duty"] |= {"mean_degC": None, "peak_beyond_oil_limit": False}
    none["cold_start"] |= {"input_torque_Nm": None, "efficiency": None}
    none["gain"] = -8.4e-15
    found = rows({"heat": none})
    assert found["duty, mean"] == ("–", "none is steady: the drive runs away, or slips")
    assert found["cold start, input"] == ("–", "none: the input stands, or the drive does not roll there")
    assert found["thermal gain"][0] == "0"


def test_a_dry_drive_has_no_oil():
    dry = {"heat": STEADY, "rolling": {"contacts": {"sp": {"film_thickness_m": None}}}}
    assert rows(dry)["rollers"][0] == "42.5 degC"
    assert "rollers and oil" not in rows(dry)
    (figure,) = temperature_figure(dry)
    assert figure.detail.startswith("rollers, steady; 25 degC")


def test_an_unstable_state_is_said():
    _, bullets = heat({"heat": STEADY})
    assert bullets.items == [
        "another unstable steady temperature at 88 degC: a drive warmer than that runs away"
    ]


def test_thermal_runaway_says_which_torque_settles(runaway):
    assert rows({"heat": runaway})["temperature"] == (
        "none is steady",
        "thermal runaway; up to 4 N·m there is a steady temperature",
    )
    (figure,) = temperature_figure({"heat": runaway})
    assert figure.shown == "–"
    assert at_temperature({"heat": runaway}) == ", thermal runaway"


def test_a_drive_that_is_only_too_hot(runaway):
    runaway["unsteady_because"] = "too hot: it would settle above 120 degC"
    assert rows({"heat": runaway})["temperature"][1].startswith("too hot: it would settle above 120 degC")


def test_thermal_runaway_without_any_torque(runaway):
    runaway["steady_torque_Nm"] = None
    assert rows({"heat": runaway})["temperature"][1].endswith("no torque has a steady temperature")

"""The tables of the joint that turns say what the document says, in the units of their heads."""

import copy
import io
import math

import pytest

from asperity.cli.roll_table import show_rolling
from asperity.cli.terminal import WIDEST

LOSSES = {"creep": 2.0, "skew": 0.0, "hysteresis": None, "oil": None, "total": 2.0}
CONTACT = {
    "creepage": 5.4e-4,
    "layer_creepage_factor": 1.174,
    "hertz_pressure_Pa": 750e6,
    "rough_peak_pressure_Pa": 666e6,
    "traction_coefficient": 0.05,
    "capacity_loss": 0.0,
    "shakedown_ratio": 0.5,
    "axial_force_N": 0.0,
    "flash_temperature_K": None,
    "film_thickness_m": None,
    "film_ratio": None,
    "losses_W": LOSSES,
}
DOCUMENT = {
    "of_own_branches": False,
    "verdict": {"title": "Works", "words": "All met.", "nearest": None},
    "mass_kg": 0.5,
    "envelope_diameter_m": 0.116,
    "drift_rad_per_output_turn": None,
    "life_hours": None,
    "input": {
        "drive": {"planets": 3.0},
        "load": {"friction_coefficient": 0.12, "output_torque": 5.0},
    },
    "input_speed_rad_per_s": 600.0,
    "assumptions": [],
    "geometry": {
        "speed_ratio": 6.0,
        "input": "sun",
        "output": "carrier",
        "grounded": "ring",
        "sectors": 3,
        "wedge_angle_rad": 0.1,
        "alpha_rad": 0.1,
        "theta_rad": 0.2,
        "clearances": [],
    },
    "preload": {
        "force_N": 1000.0,
        "interference_m": 1e-5,
        "at_assembly": None,
        "temperature_limits": [],
        "loading_cam": None,
    },
    "standing": {"forces": {"output_torque_Nm": 5.0}},
    "torque_capacity": {
        "output_torque_Nm": 11.5,
        "meaning": "contact sp slips, in rolling",
        "reverse": {"output_torque_Nm": None, "meaning": "no limit is reached at any torque"},
    },
    "standing_torque_capacity": {
        "output_torque_Nm": 12.5,
        "limit": "gross_slip",
        "reverse": {"output_torque_Nm": None, "limit": "none"},
    },
    "stiffness_bound": None,
    "torsional_stiffness": {
        "assembly": {"output_Nm_per_rad": 5.0 / math.radians(0.1), "output_Nm_per_arcmin": 0.8333}
    },
    "efficiency": 0.97,
    "rolling": {
        "contacts": {"sp": CONTACT},
        "drift_rad_per_output_turn": math.radians(0.5),
        "speed_loss": 0.002,
        "torque_capacity_Nm": 11.5,
        "losses_W": {**LOSSES, "bearings": 1.0, "total": 3.0},
        "efficiency": 0.97,
        "input_power_W": 100.0,
        "output_power_W": 97.0,
        "unknown_because": ["no oil"],
        "axial_thrust_N": {"sun": 0.0},
        "reliability": 0.9,
        "no_life_because": None,
        "life_hours": 1234.0,
        "life_output_turns": 5.6e7,
        "body_life_hours": {"sun": 2000.0, "loading_roller": None},
        "body_life_output_turns": {"sun": 9e7, "loading_roller": None},
        "duty_life_hours": None,
        "duty_life_output_turns": None,
        "duty": {},
    },
    "diagnostics": [
        {
            "name": "friction_coefficient",
            "label": "friction coefficient",
            "contact": "sp",
            "value": 0.12,
            "limit": 0.3,
            "ok": True,
            "severity": "accuracy",
            "meaning": "usual",
            "remedy": None,
        },
        {
            "name": "pressure_over_first_yield",
            "label": "pressure",
            "contact": "sp",
            "value": 0.9,
            "limit": 1.0,
            "ok": True,
            "severity": "damage",
            "meaning": "elastic",
            "remedy": None,
        },
    ],
}


@pytest.fixture
def document():
    return copy.deepcopy(DOCUMENT)


def lines(document):
    from rich.console import Console

    target = Console(file=io.StringIO(), width=WIDEST)
    show_rolling(target, document, source="mine.toml", in_full=True)
    return [" ".join(line.split()) for line in target.file.getvalue().splitlines()]


def row(shown, start):
    (found,) = [line for line in shown if line.startswith(start)]
    return found[len(start) :].split()


def test_position_of_the_output(document):
    """Half a degree of drift is 30 arcmin, a tenth of a degree of twist 6 arcmin."""
    shown = lines(document)
    assert row(shown, "drift per output turn")[:2] == ["30", "arcmin"]
    assert row(shown, "speed loss")[:2] == ["0.2", "%"]
    assert row(shown, "torque over stiffness")[:2] == ["6", "arcmin"]
    assert row(shown, "torque capacity, rolling")[:2] == ["11.5", "N·m"]
    assert any("standing: 12.5 N·m" in line for line in shown)
    assert row(shown, "sp 0.54 ") == ["1.174", "0.05", "0.12", "750", "0.9", "0.5", "666"]


def test_losses_and_lives(document):
    shown = lines(document)
    assert "Efficiency 97 %: 100 W in, 97 W out" in shown
    assert row(shown, "bearings and pins") == ["1"]
    assert row(shown, "all ")[0] == "2"
    assert row(shown, "the drive ")[0] == "1234"
    assert row(shown, "one loading roller") == ["-", "-"]
    assert "Rating life L10" in shown
    assert "Axial thrust: none, the axes are parallel" in shown
    assert not any(line.startswith("Surfaces in rolling") for line in shown)


def test_what_skew_takes_from_the_friction(document):
    contact = document["rolling"]["contacts"]["sp"]
    contact |= {"capacity_loss": 0.75, "axial_force_N": 40.0, "film_thickness_m": 0.25e-6, "film_ratio": 1.2}
    document["rolling"]["axial_thrust_N"] = {"sun": -120.0}
    document["rolling"]["no_life_because"] = "no rating life: at sp it flows"
    shown = lines(document)
    # 0.12 (1 - 0.75) = 0.03 is less than the traction
    assert row(shown, "sp 0.54 ")[1:3] == ["0.05", "0.03"]
    assert any(line.startswith("sp: slips as a whole, because skew") for line in shown)
    assert row(shown, "sp - 0.25")[:1] == ["1.2"]
    assert "no rating life: at sp it flows" in shown
    assert any(line == "-120" for line in shown)


def test_a_duty_and_the_reverse_direction(document):
    document["input"]["duty"] = {"1": {"output_torque": -5.0, "sun_speed": 100.0 * math.pi, "share": 0.25}}
    document["rolling"]["duty"] = {"1": {"damage_share": 1.0, "life_hours": 500.0}}
    document["rolling"] |= {"duty_life_hours": 2000.0, "duty_life_output_turns": 8e7}
    document["standing"]["forces"]["output_torque_Nm"] = -5.0
    shown = lines(document)
    assert row(shown, "1 -5 N·m") == ["3000", "rpm", "25", "%", "100", "%", "500"]
    assert row(shown, "the drive under the duty")[0] == "2000"
    assert "standing: not limited by friction" in " ".join(shown)


def test_a_sun_that_stands_has_no_losses(document):
    document["rolling"]["losses_W"]["total"] = None
    shown = lines(document)
    assert "Efficiency and losses" in shown
    assert "no oil" in shown


def test_what_a_life_has_to_reach_is_compared_below_the_table(document):
    words = {"limit_shown": "20000 h", "meaning": "it lives", "remedy": None, "severity": "damage"}
    document["diagnostics"] += [
        words | {"name": f"required_{name}", "label": name, "contact": contact, "infinite": False} | found
        for name, contact, found in (
            ("drive_life", None, {"value": 7.2e7, "shown": "20000 h", "ok": True, "known": True}),
            (
                "bearing_life",
                "planet_pin",
                {"value": 3.6e6, "shown": "1000 h", "ok": False, "known": True},
            ),
            ("duty_life", None, {"value": None, "shown": "not known", "ok": False, "known": False}),
        )
    ]
    said = [line for line in lines(document) if "required" in line]
    assert said == [
        "drive_life 20000 h, required 20000 h: met",
        "bearing_life, planet pin 1000 h, required 20000 h: NOT met",
        "duty_life not known, required 20000 h; it lives",
    ]

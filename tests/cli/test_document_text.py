"""Numbers, sentences and warnings as the commands print them."""

import functools
import io
import math

import pytest
from rich.console import Console

from asperity.cli.document_text import (
    OF_EVERY_JOINT,
    count,
    in_unit,
    number,
    scaled,
    show_assumptions,
    show_branches,
    show_heading,
    show_law_range,
    show_verdict,
    show_warnings,
)
from asperity.joint_file.assumptions import assumptions


def shown(print_it, *arguments, width=80):
    target = Console(file=io.StringIO(), width=width, no_color=True)
    print_it(target, *arguments)
    return target.file.getvalue()


def entry(name, value, severity, contact=None, ok=False):
    return {
        "name": name,
        "label": name.replace("_", " "),
        "contact": contact,
        "value": value,
        "limit": 1.0,
        "ok": ok,
        "known": True,
        "severity": severity,
        "meaning": f"meaning of {name}",
        "remedy": f"remedy of {name}",
        "shown": "-" if value is None else f"{value:g}",
        "limit_shown": "1",
    }


def test_numbers_have_four_digits_and_what_is_absent_is_a_dash():
    assert [number(30665.4), number(0.0123456), number(None)] == ["30665", "0.01235", "-"]
    assert (scaled(2.5e-6, 1e6), scaled(None, 1e6)) == ("2.5", "-")
    assert (in_unit(0.004, "mm"), in_unit(None, "mm")) == ("4 mm", "-")
    assert [count(1, "planet"), count(3, "planet")] == ["1 planet", "3 planets"]


def test_the_heading_states_the_load_in_its_units():
    document = {
        "input": {"drive": {"planets": 3}, "load": {"output_torque": 5.0}},
        "input_speed_rad_per_s": 628.3185307179587,
        "geometry": {"input": "driving_ring"},
        "preload": {
            "force_N": 1000.0,
            "interference_m": 1.25e-6,
            "at_assembly": None,
            "temperature_limits": [],
            "loading_cam": None,
        },
    }
    assert shown(show_heading, document, "joint.toml", width=200).splitlines()[:2] == [
        "joint.toml",
        "3 planets, driving ring at 6000 rpm, preload 1000 N (interference 1.25 um), output torque 5 N·m",
    ]
    document["preload"]["at_assembly"] = {
        "force_N": 1500.0,
        "interference_m": 2e-6,
        "temperature_degC": 20.0,
        "working_temperature_degC": 40.0,
        "thermal_change_m": -0.75e-6,
        "loose_temperature_degC": 73.33,
    }
    limits = [
        {"lost": "seat_between_rollers", "part": "held_ring", "temperature_degC": 70.0, "side": "above"},
        {"lost": "interference", "part": None, "temperature_degC": -90.0, "side": "below"},
        {"lost": "seat", "part": "held_ring", "temperature_degC": 80.0, "side": "above"},
    ]
    document["preload"]["temperature_limits"] = limits
    assert shown(show_heading, document, "joint.toml", width=300).splitlines()[2] == (
        "at 40 degC; assembled at 20 degC with 1500 N (2 um), no pressure of held ring on its housing between the "
        "rollers above 70 degC, loose below -90 degC"
    )
    document["preload"]["at_assembly"] = None
    assert shown(show_heading, document, "joint.toml", width=300).splitlines()[2:4] == [
        "no pressure of held ring on its housing between the rollers above 70 degC",
        "loose below -90 degC",
    ]


def test_what_is_assumed_in_short_and_in_full(planar_case):
    """In short what a file leaves out has its name only, and what is so in every joint is left out."""
    told = assumptions(planar_case("planetary"))
    assert all(any(sentence.startswith(start) for sentence in told) for start in OF_EVERY_JOINT)
    document = {"assumptions": [*told, "model.closure_springs = 'bulk': as in the paper's closure"]}
    full = functools.partial(show_assumptions, in_full=True)
    lines = [line.strip() for line in shown(full, document, width=2000).splitlines() if line]
    assert lines == ["Assumptions", *document["assumptions"]]
    short = functools.partial(show_assumptions, in_full=False)
    heading, names, *others = [
        line.strip() for line in shown(short, document, width=2000).splitlines() if line
    ]
    assert heading == "Assumptions (all in full with --all)"
    assert names.startswith(
        "not in the file: section [bearings], bearings.pin_diameter, compliance.pin_stiffness, section [play], "
    )
    assert "the bearings have no friction" not in names
    law, fatigue, closure = others
    assert law.startswith("contact law zou_2025, since the file does not state model.contact_law: ")
    assert fatigue.startswith("fatigue_strength of material 52100: 588 MPa of specimens")
    assert closure == document["assumptions"][-1]


def test_kept_limits_give_no_warning():
    text = shown(show_warnings, {"diagnostics": [entry("slip_ratio", 0.5, "function", "sp", ok=True)]})
    assert text.strip() == "No warnings: all limits are met"


def test_an_infinite_value_is_no_dash():
    infinite = {"infinite": True, "shown": "infinite"}
    diagnostics = [
        entry("slip_ratio_with_skew", None, "function", "sp") | infinite,
        entry("largest_spot", 27.2, "model", "sp"),
        entry("largest_spot", None, "model", "pwr") | infinite,
    ]
    text = shown(show_warnings, {"diagnostics": diagnostics}, width=200)
    assert "Slip ratio with skew infinite at sp (limit 1)" in text
    assert "largest spot infinite" in shown(show_law_range, {"diagnostics": diagnostics}, width=200)


def test_contacts_of_one_limit_share_a_warning_and_the_range_of_the_law_has_a_line():
    diagnostics = [
        entry("slip_ratio", 1.2, "function", "sp"),
        entry("slip_ratio", 1.1, "function", "right_pair"),
        entry("slip_ratio", 0.9, "function", "pwl", ok=True),
        *(entry("pressure", 2.0, "damage", contact) for contact in ("sp", "pwr", "pwl", "wro", "wlo")),
        entry("real_area", 6.54, "model", "sp"),
        entry("largest_spot", None, "model", "sp"),
        entry("largest_spot", 27.2, "model", "pwr"),
    ]
    text = shown(show_warnings, {"diagnostics": diagnostics}, width=200)
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    assert lines == [
        "Warnings, most serious first",
        "Slip ratio 1.2 at sp, 1.1 at right pair (limit 1)",
        "meaning of slip_ratio",
        "What to do: remedy of slip_ratio",
        "Pressure 2 at every contact (limit 1)",
        "meaning of pressure",
        "What to do: remedy of pressure",
    ]
    text = shown(show_law_range, {"diagnostics": diagnostics}, width=200)
    assert text.strip() == (
        "asperities alone: outside the range of this law, real area up to 6.54, largest spot up to 27.2; "
        "remedy of real_area"
    )
    assert shown(show_law_range, {"diagnostics": diagnostics[:3]}) == ""


def text(found):
    target = Console(file=io.StringIO(), width=160)
    show_branches(target, found)
    return target.file.getvalue()


def test_the_table_says_shares_and_forces_on_the_axis(document_of_branches):
    said = text(document_of_branches())
    assert "60, -" in said
    cells = [line.split() for line in said.splitlines() if line[:2] in (" 1", " 3")]
    assert [row[:3] for row in cells] == [["1", "1", "14"], ["3", "-7", "-1"]]
    assert "0.5, -" in said
    assert "5 um off centre, bearing force 250 N (standing)" in said
    assert "bearing force 250 N (standing), held by its bearings" in text(document_of_branches(math.inf))
    assert "planet 1 is pressed 1.1 times as hard as equal ones." in " ".join(said.split())


def test_without_a_state_under_the_torque_the_force_is_that_without_torque(document_of_branches):
    assert "5 um off centre, bearing force 250 N (without torque)" in text(
        document_of_branches(standing=None)
    )


def test_a_force_of_rounding_is_none(document_of_branches):
    found = document_of_branches()
    found["standing"]["sun"]["force_N"] = [3e-12, -4e-12]
    assert "bearing force 0 N (standing)" in text(found)
    found["standing"]["sun"]["force_N"] = [3e-6, -4e-6]
    assert "bearing force 5e-6 N (standing)" in text(found)


@pytest.mark.parametrize(
    ("torque", "limit", "stands", "said"),
    [
        (8.0, "gross_slip", 8.0, "8 N·m (sp slips)"),
        (0.0, "gross_slip", 13.16, "0 N·m (sp slips); gross slip standing at 13.16 N·m"),
        (7.0, "lift_off", 9.0, "7 N·m (sp slips); lift-off standing at 9 N·m"),
        (7.0, "none", None, "7 N·m (sp slips); standing, no contact slips at any torque"),
        (7.0, "contact_too_wide", 900.0, "7 N·m (sp slips)"),
        (None, "none", None, "sp slips; standing, no contact slips at any torque"),
    ],
)
def test_the_verdict_stands_before_the_numbers_of_use(torque, limit, stands, said):
    nearest = {"label": "slip", "words": "slip at sp 3, 85 % of its limit"}
    document = {
        "verdict": {"title": "Works", "words": "All met.", "nearest": nearest},
        "torque_capacity": {"reverse": {"output_torque_Nm": torque, "meaning": "sp slips"}},
        "standing_torque_capacity": {"reverse": {"output_torque_Nm": stands, "limit": limit}},
        "standing": {"forces": {"output_torque_Nm": -5.0}},
        "stiffness_bound": None,
        "torsional_stiffness": {"assembly": {"output_Nm_per_rad": 10800.0 / math.pi}},
        "drift_rad_per_output_turn": None,
        "efficiency": 0.9,
        "life_hours": None,
        "geometry": {"speed_ratio": -6.0},
        "mass_kg": 0.5,
        "envelope_diameter_m": 0.116,
    }
    target = Console(file=io.StringIO(), width=160)
    show_verdict(target, document)
    assert target.file.getvalue().splitlines() == [
        "Works: All met. Tightest margin: slip at sp 3, 85 % of its limit.",
        "stiffness 1 N·m/arcmin, drift per output turn -, efficiency 90 %, life -",
        f"torque capacity {said}",
        "ratio 6, mass of the rolling parts 0.5 kg, outside diameter 116 mm",
        "",
    ]

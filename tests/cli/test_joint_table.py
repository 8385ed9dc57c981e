"""The tables say what the document says, in the units of their heads; warnings are gathered by limit."""

import io
import math
import re

import numpy as np
import pytest

from asperity.cli.joint_table import show_joint
from asperity.cli.terminal import console

CONTACTS = ("sp", "pwr", "pwl", "wro", "wlo")


def each(*values):
    return dict(zip(CONTACTS, values, strict=True))


@pytest.fixture
def document():
    """A joint by hand in SI units; the left roller has lifted off the ring."""
    contact = {
        "hertz_half_width_m": 25e-6,
        "hertz_pressure_Pa": 750e6,
        "real_contact_area_m2": 0.2e-6,
        "asperity_tangential_stiffness_N_per_m": 123e6,
        "bulk_tangential_stiffness_N_per_m": 456e6,
        "asperity_normal_stiffness_N_per_m": 789e6,
        "bulk_normal_stiffness_N_per_m": 321e6,
        "contact_torsional_stiffness_Nm_per_rad": 6543.0,
    }
    stiffness = {"input_Nm_per_rad": 100.0, "output_Nm_per_rad": 8100.0, "output_Nm_per_arcmin": 2.356}
    slips = [
        {
            "name": "slip_ratio",
            "label": "slip ratio",
            "contact": name,
            "value": value,
            "limit": 1.0,
            "ok": ok,
            "severity": "function",
            "meaning": "it slips",
            "remedy": "press harder",
            "shown": "-" if value is None else f"{value:g}",
            "limit_shown": "1",
        }
        for name, value, ok in zip(
            CONTACTS, (0.4, 1.25, 0.5, 1.5, None), (True, False, True, False, False), strict=True
        )
    ]
    return {
        "verdict": {"title": "Works", "words": "All met.", "nearest": None},
        "mass_kg": 0.5,
        "envelope_diameter_m": 0.116,
        "efficiency": None,
        "life_hours": None,
        "input": {
            "drive": {"planets": 3.0},
            "load": {"preload": 1000.0, "output_torque": 5.0},
        },
        "input_speed_rad_per_s": 100.0 * np.pi,
        "preload": {
            "force_N": 1000.0,
            "interference_m": 12.5e-6,
            "at_assembly": None,
            "temperature_limits": [],
            "loading_cam": None,
        },
        "assumptions": ["no section [bearings]: the bearings have no friction"],
        "geometry": {
            "alpha_rad": np.pi / 12.0,
            "theta_rad": np.pi / 6.0,
            "wedge_angle_rad": np.pi / 12.0,
            "speed_ratio": -9.0,
            "input": "sun",
            "output": "carrier",
            "grounded": "ring",
            "clearances": [{"name": "far", "gap_m": 3e-3}, {"name": "planet_to_planet", "gap_m": 0.5e-3}],
        },
        "torque_capacity": {
            "output_torque_Nm": 7.5,
            "meaning": "ring yields at a rim, in rolling",
            "reverse": {"output_torque_Nm": 0.0, "meaning": "sp yields without torque"},
        },
        "standing_torque_capacity": {
            "output_torque_Nm": 12.5,
            "limit": "gross_slip",
            "meaning": "contact sp slips",
            "reverse": {
                "output_torque_Nm": None,
                "limit": "none",
                "meaning": "no limit is reached at any torque",
            },
        },
        "standing": {
            "forces": {
                "normal_N": each(1001.0, 650.0, 460.0, 640.0, 0.0),
                "tangential_N": each(46.3, 27.1, 19.2, 27.1, 19.2),
                "pin_N": {
                    "left": {"radial": 0.0, "tangential": -111.0},
                    "right": {"radial": 3.0, "tangential": 222.0},
                },
                "input_torque_Nm": 0.5556,
                "output_torque_Nm": 5.0,
                "body_mass_kg": {"planet": 0.02247, "loading_roller": 0.003083},
                "output_speed_rad_per_s": -np.pi,
            },
            "contacts": {name: dict(contact) for name in CONTACTS},
        },
        "stiffness_unknown_because": None,
        "drift_rad_per_output_turn": math.radians(0.5),
        "rolling": {
            "torque_capacity_Nm": 11.5,
            "input_torque_Nm": 0.5678,
            "contacts": {"sp": {"capacity_loss": 0.0}},
        },
        "speed_loss": 2e-3,
        "bearings": [],
        "rims": {},
        "surfaces": [
            {
                "contacts": list(CONTACTS),
                "fractal_dimension": 1.4,
                "fractal_roughness_m": 1e-11,
                "roughness_average_m": 0.1e-6,
                "roughness_average_low_m": 0.08e-6,
                "roughness_average_high_m": 0.12e-6,
                "cut_off_m": 0.25e-3,
            }
        ],
        "stiffness_bound": None,
        "torsional_stiffness": dict.fromkeys(("assembly", "series_with_bulk", "published"), stiffness),
        "stiffness_budget": {"pins_share": 0.25, "contacts_share": each(0.5, 0.25, 0.0, 0.0, 0.0)},
        "diagnostics": slips,
    }


@pytest.fixture
def shown(monkeypatch):
    def show(document):
        stream = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
        monkeypatch.setattr("sys.stdout", stream)
        show_joint(console(), document, source="joint.toml", in_full=True)
        stream.flush()
        return stream.buffer.getvalue().decode("utf-8").splitlines()

    return show


def test_numbers_are_converted_to_the_units_of_the_heads(document, shown):
    lines = shown(document)
    rows = [line.split() for line in lines]
    assert ["sp", "1001", "46.3", "0.4", "0.05", "750", "0.2"] in rows  # 2b in mm, MPa, mm²
    assert ["sp", "123", "456", "789", "321", "6543"] in rows  # N/µm
    assert ["wlo", "0", "19.2", "-", "0.05", "750", "0.2"] in rows  # None is a dash
    for text in (
        "3 planets, sun at 3000 rpm, preload 1000 N (interference 12.5 um), output torque 5 N·m",
        "  30 arcmin per output turn (0.2 % of the speed): creep accumulates with every turn; the stiffness",
        "  angles     alpha 15 deg, theta 30 deg, wedge beta 15 deg",
        "  members    sun in, carrier out, ring grounded",
        "  speed      ratio -9, output -30 rpm",
        "  torque     output 5 N·m; input 0.5556 N·m without rolling losses, 0.5678 N·m with all losses",
        "torque capacity 7.5 N·m (ring yields at a rim, in rolling); gross slip standing at 12.5 N·m",
        "  capacity   7.5 N·m: ring yields at a rim, in rolling; reverse 0 N·m: sp yields without torque",
        "  standing   12.5 N·m: contact sp slips; reverse no limit is reached at any torque",
        "  rolling    up to 11.5 N·m without gross slip",
        "  pin force  standing, left radial 0 N, tangential -111 N, right radial 3 N, tangential 222 N",
        "  mass       planet 22.47 g, loading roller 3.083 g",
        "  clearance  smallest 0.5 mm, planet to planet",
        "  contacts 75.0 % (sp 50.0 %, pwr 25.0 %)",
        "  pins 25.0 %",
        "  no section [bearings]: the bearings have no friction",
    ):
        assert text in lines, text


def test_a_share_below_nothing_is_shown_and_explained(document, shown):
    """It was left out, although the others then made more than the whole."""
    document["stiffness_budget"] = {"normal_share": {"sp": 1.25, "wro": -0.125}, "pins_share": -0.125}
    said = " ".join(" ".join(shown(document)).split())
    assert "normal 112.5 % (sp 125.0 %, wro -12.5 %)" in said
    assert "pins -12.5 %" in said
    assert "a negative share: the other forces on its bodies deflect this spring" in said
    document["stiffness_budget"] = {"normal_share": {"sp": 0.75}, "pins_share": 0.25}
    assert "negative share" not in " ".join(" ".join(shown(document)).split())


def test_a_held_cam_has_its_own_stiffness(document, shown):
    """At the sun by the square of the ratio of 9; an arcminute is pi/10800."""
    document["preload"]["loading_cam"] = {
        "least_preload_N": 500.0,
        "force_per_torque_N_per_Nm": 100.0,
        "angle_rad": math.radians(0.1),
        "held_stiffness_output_Nm_per_rad": 8100.0,
    }
    (row,) = [line.split() for line in shown(document) if "cam held by its friction" in line]
    assert row[-3:] == ["100", "8100", f"{8100.0 * math.pi / 10800.0:.4g}"]


def test_crowned_contacts_have_a_table_of_their_own(document, shown):
    for contact in document["standing"]["contacts"].values():
        contact |= {"loaded_length_share": 0.75, "peak_line_load_ratio": 1.4, "end_line_load_ratio": 0.0}
    rows = [line.split() for line in shown(document)]
    assert ["sp", "75", "1.4", "0"] in rows


def test_warnings_are_gathered_by_limit(document, shown):
    lines = shown(document)
    place = lines.index("  Slip ratio 1.25 at pwr, 1.5 at wro, - at wlo (limit 1)")
    assert lines[place + 1 : place + 3] == ["    it slips", "    What to do: press harder"]
    for entry in document["diagnostics"]:
        entry["ok"] = True
    assert "No warnings: all limits are met" in shown(document)


def limit(name, value, severity, contact=None):
    words = {
        "label": name.replace("_", " "),
        "meaning": f"{name} is crossed",
        "remedy": f"mend the {severity}",
    }
    return {
        "name": name,
        "contact": contact,
        "value": value,
        "limit": 1.0,
        "ok": False,
        "severity": severity,
        "shown": f"{value:g}",
        "limit_shown": "1",
        **words,
    }


def test_the_range_of_the_law_stands_beside_the_published_level(document, shown):
    kept = [{**entry, "ok": True} for entry in document["diagnostics"]]
    document["diagnostics"] = [
        *kept,
        *(limit("yield", 2.0, "damage", contact) for contact in CONTACTS),
        limit("area", 8.0, "model", "sp"),
        limit("area", 3.0, "model", "pwr"),
        limit("spot", 40.0, "model", "sp"),
    ]
    lines = shown(document)
    place = lines.index("Warnings, most serious first")
    assert lines[place + 1 : place + 4] == [
        "  Yield 2 at every contact (limit 1)",
        "    yield is crossed",
        "    What to do: mend the damage",
    ]
    assert not any("area" in line for line in lines[place:])
    level = "  asperities alone: outside the range of this law, area up to 8, spot up to 40; mend the model"
    assert lines.index(level) < place


def test_one_planet_is_no_plural(document, shown):
    document["input"]["drive"]["planets"] = 1.0
    assert shown(document)[1].startswith("1 planet, sun at")


def test_the_interval_of_a_measured_surface(document, shown):
    bounds = {"low_Nm_per_rad": 7000.0, "high_Nm_per_rad": 9000.0}
    document["stiffness_interval"] = {
        "title": "95 % interval from the measured surface, D = 1.400, G = 1e-8 mm",
        "words": "The interval leaves out the error of the contact law.",
        **dict.fromkeys(("assembly", "series_with_bulk", "published"), bounds),
        "drift": {"low_rad_per_output_turn": math.pi / 1e4, "high_rad_per_output_turn": math.pi / 5e3},
    }
    text = " ".join(" ".join(shown(document)).split())  # titles and sentences are wrapped
    assert "95 % interval from the measured surface, D = 1.400, G = 1e-8 mm" in text
    assert text.count("7000") == text.count("9000") == 3
    assert "drift from 1.08 arcmin to 2.16 arcmin per output turn" in text
    assert text.index("drift from") < text.index("The interval leaves out the error of the contact law.")


def test_a_bound_stands_beside_every_stiffness_of_the_assembly(document, shown):
    """In the line of the verdict, and in the row of the assembled level; not at the levels with held centres."""
    assert "pins rigid" not in " ".join(shown(document))
    document["stiffness_bound"] = "upper bound: pins rigid"
    text = " ".join(" ".join(shown(document)).split())
    assert text.count("(upper bound: pins rigid)") == 2
    assert re.search(r"stiffness [\d.]+ N·m/arcmin \(upper bound: pins rigid\), drift", text)


def test_what_an_unstated_clearance_leaves_open_is_told_below_the_stiffness(document, shown):
    document["pin_clearance_interval"] = {"words": "bearings.pin_radial_clearance is not stated, and so on"}
    lines = shown(document)
    place = lines.index("  bearings.pin_radial_clearance is not stated, and so on")
    assert any("Torsional stiffness" in line for line in lines[:place])
    assert place < lines.index("Drift in rolling")


def test_laws_side_by_side_have_a_line_each(document, shown):
    assert "side by side" not in " ".join(shown(document))
    document["contact_laws"] = [
        {
            "law": "zou_2025",
            "used": False,
            "assembly_Nm_per_rad": None,
            "drift_rad_per_output_turn": None,
            "over_boundary_elements": [0.045, 0.5],
        },
        {
            "law": "exponential",
            "used": True,
            "assembly_Nm_per_rad": 7000.0,
            "drift_rad_per_output_turn": math.pi / 5400.0,
            "over_boundary_elements": [0.39, 1.24],
        },
    ]
    lines = [line.split() for line in shown(document)]
    assert ["zou_2025", "-", "-", "0.045", "to", "0.5"] in lines
    assert ["exponential", "7000", "2", "0.39", "to", "1.24", "used", "here"] in lines


def test_bearings_and_bodies_that_bend_have_a_row_each(shown, document):
    assert not any(line.startswith(("  bearings", "  rims")) for line in shown(document))
    document["bearings"] = [
        {"bearing": "right_pin", "life_hours": None},
        {"bearing": "left_pin", "life_hours": 75690.7},
    ]
    document["rims"] = {
        "ring": {"yield_safety": 7.467, "fatigue_safety": None},
        "loading_roller": {"yield_safety": 3.0, "fatigue_safety": 2.5},
    }
    text = " ".join(" ".join(shown(document)).split())
    assert "bearings life L10: left pin 75691 h; details: 'asperity loads'" in text
    assert "rims ring: yield safety 7.467; loading roller: yield safety 3, fatigue safety 2.5" in text


def test_the_interval_over_what_ra_leaves_open(document, shown):
    bounds = {"low_Nm_per_rad": 7000.0, "high_Nm_per_rad": 9000.0}
    document["stiffness_interval"] = {
        **dict.fromkeys(("assembly", "series_with_bulk", "published"), bounds),
        "drift": {"low_rad_per_output_turn": None, "high_rad_per_output_turn": None},
        "surfaces": {},
        "title": "Interval over what the Ra of the surfaces leaves open",
        "words": "surface (ground): D from 1.15 to 1.5.",
    }
    bare = " ".join(" ".join(shown(document)).split())
    assert "law alone" not in bare
    ends = {"both": [1.5e8, 6.25e8], "contact_law": [2e8, 5.5e8], "rms_height": [2.5e8, 3.5e9]}
    directions = ("asperity_normal_stiffness_N_per_m", "asperity_tangential_stiffness_N_per_m")
    document["stiffness_interval"]["contacts"] = {"sp": dict.fromkeys(directions, ends)}
    text = " ".join(" ".join(shown(document)).split())
    assert "Interval over what the Ra of the surfaces leaves open" in text
    assert "surface (ground): D from 1.15 to 1.5." in text
    assert "sp 150 to 625 200 to 550 250 to 3500 150 to 625" in text
    assert "D 1.4, G 1e-8 mm correspond to Ra 0.1 um on each of two like bodies" in text

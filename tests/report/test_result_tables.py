"""Tables of a joint at rest, from documents whose numbers are written out here."""

import math

from asperity.report.content import Paragraph, Table
from asperity.report.result_tables import (
    averages,
    contacts,
    drive,
    interval,
    stiffness,
    windup,
)
from asperity.results.windup_document import stages_title

ARCMINUTE = math.pi / 180.0 / 60.0
LEVELS = ("assembly", "series_with_bulk", "published")
INTERVAL = {
    **{level: {"low_Nm_per_rad": 7000.0, "high_Nm_per_rad": None} for level in LEVELS},
    "drift": {"low_rad_per_output_turn": 0.0029088820866572, "high_rad_per_output_turn": None},
    "title": "Interval over what the Ra of the surfaces leaves open",
    "words": "D from 1.15 to 1.5.",
}


def rows_of(blocks):
    return {block.title: [tuple(row) for row in block.rows] for block in blocks if isinstance(block, Table)}


def test_windup_has_angles_in_arcminutes_and_both_directions():
    stage = {
        "name": "K1",
        "from_Nm": 0.0,
        "to_Nm": 5.0,
        "stiffness_Nm_per_rad": 2e4,
        "reverse_stiffness_Nm_per_rad": 1e4,
    }
    found = rows_of(
        windup(
            {
                "largest_torque_Nm": 5.0,
                "windup_rad": 2.0 * ARCMINUTE,
                "reverse_windup_rad": 3.0 * ARCMINUTE,
                "hysteresis_rad": 0.5 * ARCMINUTE,
                "lost_motion_rad": 0.25 * ARCMINUTE,
                "dissipated_energy_J": 0.002,
                "stiffness_bound": None,
                "stages": [stage],
            }
        )
    )
    assert [value for _, value in found["Wind-up"]] == [
        "5 N·m", "2 arcmin", "-3 arcmin", "0.5 arcmin", "0.25 arcmin", "0.002 J",
    ]  # fmt: skip
    assert found["Stages of the loading curve (secant stiffness)"] == [("K1", "0", "5", "20000", "10000")]


def test_shares_of_the_compliance_are_sorted_and_named():
    levels = {
        level: {"input_Nm_per_rad": 10.0, "output_Nm_per_rad": 810.0, "output_Nm_per_arcmin": 0.25}
        for level in ("assembly", "series_with_bulk", "published")
    }
    budget = {"bodies_share": 0.25, "asperity_share": {"sp": 0.5, "wro": 0.0}, "pins_share": 0.125}
    document = {
        "stiffness_bound": None,
        "torsional_stiffness": levels, "stiffness_unknown_because": "it slips", "stiffness_budget": budget,
        "input": {}, "diagnostics": [{
            "ok": False, "severity": "model", "name": "spot", "label": "largest spot", "value": 2.0, "shown": "2",
            "remedy": "choose another law",
        }],
        "geometry": {"speed_ratio": -9.0, "input": "driving_ring"},
        "preload": {"loading_cam": {"held_stiffness_output_Nm_per_rad": 10800.0 * 0.81}},
    }  # fmt: skip
    blocks = list(stiffness(document))
    found = rows_of(blocks)
    assert found["Torsional stiffness"][0][1:] == ("10", "810", "0.25")
    held = found["Torsional stiffness"][3]
    assert held[0] == "assembled, loading cam held by its friction"
    assert held[1:] == ("108", "8748", "2.545")  # over 9²; times pi/10 800
    unknown, law, whole = (b.text for b in blocks if isinstance(b, Paragraph))
    assert unknown == "No value: it slips."
    assert law == "Asperities alone: outside the range of this law, largest spot up to 2; choose another law."
    assert whole.endswith("such as the bending of a free ring.")
    assert found["Stiffness budget: shares of the compliance of the assembled joint"] == [
        ("sp asperity", "50"), ("bodies", "25"), ("pins", "12.5"),
    ]  # fmt: skip
    document["input"]["model"] = {"bodies": "springs"}
    said = [block.text for block in stiffness(document) if isinstance(block, Paragraph)]
    assert not any("a free ring's bending" in text for text in said)


def test_a_bound_stands_beside_the_assembled_stiffness_and_the_stages():
    level = {"input_Nm_per_rad": 10.0, "output_Nm_per_rad": 810.0, "output_Nm_per_arcmin": 0.25}
    document = {
        "stiffness_bound": "upper bound: pins rigid",
        "torsional_stiffness": dict.fromkeys(("assembly", "series_with_bulk", "published"), level),
        "stiffness_unknown_because": None,
        "stiffness_budget": {},
        "input": {},
        "diagnostics": [],
        "geometry": {"speed_ratio": -9.0, "input": "sun"},
        "preload": {"loading_cam": {"held_stiffness_output_Nm_per_rad": 8748.0}},
        "pin_clearance_interval": {"words": "bearings.pin_radial_clearance is not stated, and so on"},
    }
    blocks = list(stiffness(document))
    heads = [row[0] for row in rows_of(blocks)["Torsional stiffness"]]
    assert [head.endswith(" (upper bound: pins rigid)") for head in heads] == [True, False, False, True]
    said = [block.text for block in blocks if isinstance(block, Paragraph)]
    assert "bearings.pin_radial_clearance is not stated, and so on." in said
    assert stages_title(document) == "Stages of the loading curve (secant stiffness; upper bound: pins rigid)"


def test_a_joint_without_stiffness_has_no_table_of_its_compliance():
    nothing = {"input_Nm_per_rad": None, "output_Nm_per_rad": None, "output_Nm_per_arcmin": None}
    document = {
        "stiffness_bound": None,
        "torsional_stiffness": dict.fromkeys(("assembly", "series_with_bulk", "published"), nothing),
        "stiffness_unknown_because": "every spot of sp is plastic",
        "diagnostics": [],
        "stiffness_budget": {"bodies_share": None, "asperity_share": {"sp": None}},
        "input": {},
        "geometry": {"speed_ratio": -9.0, "input": "sun"},
        "preload": {"loading_cam": None},
    }
    assert list(rows_of(stiffness(document))) == ["Torsional stiffness"]


def test_contacts_are_in_the_units_of_their_heads():
    """Half-width of 25 um: a strip of 0.05 mm; 750 MPa, 0.2 mm2, N/um."""
    contact = {
        "hertz_half_width_m": 25e-6,
        "hertz_pressure_Pa": 750e6,
        "real_contact_area_m2": 0.2e-6,
        "asperity_tangential_stiffness_N_per_m": 123e6,
        "bulk_tangential_stiffness_N_per_m": 456e6,
        "asperity_normal_stiffness_N_per_m": None,
        "bulk_normal_stiffness_N_per_m": 321e6,
    }
    document = {
        "standing": {
            "forces": {"normal_N": {"sp": 1000.0}, "tangential_N": {"sp": 46.3}},
            "contacts": {"sp": contact},
        },
        "diagnostics": [
            {"name": "slip_ratio", "contact": "sp", "value": 0.386},
            {"name": "fractal_dimension", "contact": "sp", "value": 1.4},
        ],
    }
    found = rows_of(contacts(document))
    assert found["Contact forces at standstill, under the torque"] == [
        ("sp", "1000", "46.3", "0.386", "0.05", "750", "0.2")
    ]
    assert found["Contact stiffness, N/µm"] == [("sp", "123", "456", "–", "321")]
    assert "Crowned contacts" not in found
    contact |= {"loaded_length_share": 0.75, "peak_line_load_ratio": 1.5, "end_line_load_ratio": 0.0}
    assert rows_of(contacts(document))["Crowned contacts"] == [("sp", "75", "1.5", "0")]


def test_the_drive_in_degrees_grams_and_millimetres():
    document = {
        "rolling": {"input_torque_Nm": 0.55},
        "geometry": {
            "input": "sun", "output": "carrier", "grounded": "outer_ring",
            "alpha_rad": math.pi / 12.0,
            "theta_rad": math.pi / 6.0,
            "wedge_angle_rad": math.pi / 12.0,
            "speed_ratio": -9.0,
            "clearances": [{"name": "planet_to_planet", "gap_m": 3e-3}, {"name": "idler_to_idler", "gap_m": None}],
        },
        "standing": {
            "forces": {
                "input_torque_Nm": 0.5,
                "output_torque_Nm": 5.0,
                "output_speed_rad_per_s": -math.pi,
                "body_mass_kg": {"planet": 0.0225, "loading_roller": 0.003},
            },
        },
    }  # fmt: skip
    values = dict(rows_of(drive(document))["Drive"])
    assert list(values.values()) == [
        "sun", "carrier", "outer ring", "-9", "30 rpm", "0.5 N·m", "0.55 N·m", "5 N·m", "15 deg", "30 deg", "15 deg",
        "22.5 g", "3 g", "3 mm",
    ]  # fmt: skip
    assert values["torque at the input in rolling, all losses counted"] == "0.55 N·m"
    assert values["clearance, planet to planet"] == "3 mm"


def test_an_interval_over_ra_with_its_drift():
    table, drift, words = interval({"stiffness_interval": INTERVAL, "stiffness_bound": None})
    assert isinstance(table, Table)
    assert table.title == INTERVAL["title"]
    assert [row[1:] for row in table.rows] == [("7000", "–")] * 3
    assert drift == Paragraph("Drift from 10 arcmin to – per output turn.")
    assert words == Paragraph("D from 1.15 to 1.5.")
    assert list(interval({})) == []


def test_the_ra_of_every_surface():
    entry = {
        "contacts": ["sp", "pwr"],
        "fractal_dimension": 1.4,
        "fractal_roughness_m": 1e-11,
        "roughness_average_m": 0.2e-6,
        "roughness_average_low_m": 0.15e-6,
        "roughness_average_high_m": 0.25e-6,
        "cut_off_m": 0.8e-3,
    }
    (shown,) = averages({"surfaces": [entry], "standing": {"contacts": dict.fromkeys("abcde")}})
    (row,) = shown.rows
    assert row == ("sp, pwr", "1.4", "1e-8", "0.8", "0.2", "0.15 to 0.25")
    # a drive with two contacts has these on all
    (shown,) = averages({"surfaces": [entry], "standing": {"contacts": {"sp": 0, "pwr": 0}}})
    (row,) = shown.rows
    assert row[0] == "all"
    assert list(averages({"surfaces": []})) == []  # by their heights


def test_contact_laws_have_a_row_each():
    entry = {"law": "zou_2025", "used": False, "over_boundary_elements": [0.045, 0.5]}
    numbers = {"assembly_Nm_per_rad": 7000.0, "drift_rad_per_output_turn": 2.0 * ARCMINUTE}
    laws = [
        entry | dict.fromkeys(numbers),
        entry | numbers | {"law": "exponential", "used": True, "over_boundary_elements": [0.39, 1.24]},
    ]
    level = dict.fromkeys(("input_Nm_per_rad", "output_Nm_per_rad", "output_Nm_per_arcmin"), 1.0)
    document = {
        "stiffness_bound": None,
        "torsional_stiffness": dict.fromkeys(LEVELS, level),
        "preload": {"loading_cam": None},
        "geometry": {"input": "sun"},
        "stiffness_unknown_because": None,
        "diagnostics": [],
        "stiffness_budget": {},
    }
    title = "Contact laws side by side"
    assert title not in rows_of(stiffness(document))
    assert rows_of(stiffness(document | {"contact_laws": laws}))[title] == [
        ("zou_2025", "–", "–", "0.045 to 0.5", ""),
        ("exponential", "7000", "2", "0.39 to 1.24", "used here"),
    ]

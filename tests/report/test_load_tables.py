"""Tables of loads, bearings and bending bodies, from documents made by hand."""

from asperity.report.content import Bullets, Heading, Paragraph, Table
from asperity.report.load_tables import branch_tables, loads, rims

BEARING = {
    "bearing": "left_pin",
    "type": "roller",
    "dynamic_rating_N": 1500.0,
    "static_rating_N": 1200.0,
    "load_N": 72.6,
    "load_over_dynamic_rating": 0.0484,
    "life_hours": 75691.0,
    "duty_life_hours": None,
    "static_safety": 16.5,
    "absent_because": ["no life under the duty: it slips"],
}
DOCUMENT = {
    "cases": [
        {
            "name": "without torque",
            "output_torque_Nm": 0.0,
            "sun_speed_rad_per_s": 0.0,
            "unknown_because": None,
        },
        {"name": "duty 1", "output_torque_Nm": 9.0, "sun_speed_rad_per_s": 1.0, "unknown_because": "slips"},
    ],
    "loads": [
        {
            "part": "carrier pin",
            "position": "left roller",
            "quantity": "bending stress",
            "unit": "Pa",
            "values": [2e7, None],
        }
    ],
    "bearings": [BEARING],
    "notes": ["a note"],
}
SUN = {"displacement_m": [3e-6, 4e-6], "force_N": [0.0, 0.0]}


def test_units_reasons_and_dashes():
    table, bearings, notes = loads(DOCUMENT)
    assert table.head[:3] == ("part", "load", "without torque")
    assert table.rows == [("carrier pin, left roller", "bending stress", "20", "–", "MPa")]
    # the load is that of the working torque, P/C the largest of it and the duty
    assert bearings.head[4:6] == ("load\nN", "largest P/C")
    assert bearings.rows[0][:4] == ("left pin", "roller", "1500", "1200")
    assert bearings.rows[0][-2:] == ("–", "16.5")
    assert isinstance(notes, Bullets)
    assert list(notes.items) == [
        "duty 1: slips.",
        "left pin bearing: no life under the duty: it slips.",
        "a note",
    ]


def test_bodies_that_bend():
    stress = {"inner": 68e6, "outer": 64e6}
    ring = {f"{name}_Pa": stress for name in ("stress", "stress_at_rest", "mean", "amplitude")}
    table, said = rims({"rims": {"ring": ring | {"yield_safety": 7.47, "fatigue_safety": None}}})
    assert isinstance(table, Table)
    assert table.rows[0] == ("ring", "inner", "68", "68", "68", "68", "7.47", "–")
    assert "plane strain" in said.text
    assert [*rims({"rims": {}})] == []


def state(share):
    return {"share": share, "preload_N": [900.0, 1000.0], "slip_ratio": [0.4, None], "sun": SUN}


def test_shares_and_sun():
    found = {
        "branch_is": "planet",
        "note": "Of equal branches; planet 1 is pressed 1.1 times as hard.",
        "sun_support_stiffness_N_per_m": None,
        "branches": [
            {
                "planet_deviation_m": size,
                "right_roller_deviation_m": 0.0,
                "left_roller_deviation_m": 0.0,
                "interference_m": 10e-6 + size,
                "preload_N": 950.0,
            }
            for size in (1e-6, -1e-6)
        ],
        "without_torque": {"sun": SUN},
        "standing": state([0.45, 0.55]),
        "rolling": None,
    }
    blocks = list(branch_tables(found))
    assert blocks[0] == Heading("Branches by their own sizes")
    assert blocks[1] == Paragraph(found["note"])
    branches, sun = (block for block in blocks if isinstance(block, Table))
    assert branches.rows[0] == ("1", "1", "0", "0", "11", "950", "45", "–", "0.4", "–")
    assert branches.rows[1][-2:] == ("–", "–")
    turning = [
        block for block in branch_tables(found | {"rolling": state([0.5, 0.5])}) if isinstance(block, Table)
    ]
    assert turning[0].rows[0][-3:] == ("50", "0.4", "0.4")
    rows = dict(sun.rows)
    assert rows["displacement of the sun, standing"] == "5 µm"

"""Tables of unequal branches."""

from asperity.report.branch_tables import branch_tables, equal_branches
from asperity.report.content import Bullets, Heading, Paragraph, Table

CAPACITY = {
    "first_slip_Nm": 11.0,
    "first_branch": 2,
    "first_contact": "sp",
    "first_event": "slips",
    "all_slip_Nm": 12.5,
    "equal_branches_Nm": 13.0,
}
SUN = {"displacement_m": [3e-6, 4e-6], "force_N": [0.0, 0.0]}


def state(share):
    return {"share": share, "preload_N": [900.0, 1000.0], "slip_ratio": [0.4, None], "sun": SUN}


def test_shares_sun_and_capacity():
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
        "torque_capacity": CAPACITY,
        "rolling_torque_capacity": CAPACITY,
    }
    blocks = list(branch_tables(found))
    assert blocks[0] == Heading("Branches by their own sizes")
    assert blocks[1] == Paragraph(found["note"])
    assert list(equal_branches({"branches": found})) == [blocks[1]]
    assert list(equal_branches({})) == []
    branches, sun = (block for block in blocks if isinstance(block, Table))
    assert branches.rows[0] == ("1", "1", "0", "0", "11", "950", "45", "–", "0.4", "–")
    assert branches.rows[1][-2:] == ("–", "–")
    turning = [
        block for block in branch_tables(found | {"rolling": state([0.5, 0.5])}) if isinstance(block, Table)
    ]
    assert turning[0].rows[0][-3:] == ("50", "0.4", "0.4")
    rows = dict(sun.rows)
    assert rows["displacement of the sun, standing"] == "5 µm"
    assert rows["torque capacity: contact sp of planet 2 slips first"] == "11 N·m"


def test_what_a_slipping_branch_leaves_unknown_is_said():
    """Drift and losses are absent where a branch slips in rolling; the table has dashes and the reason is above it."""
    turning = {
        "unknown_because": ["drift and losses are not known: planet 2 slips"],
        "drift_rad_per_output_turn": None,
        "losses_W": {"total": None},
        "efficiency": None,
    }
    found = {
        "branch_is": "planet",
        "note": "Of equal branches.",
        "branches": [{"planet_deviation_m": 0.0, "interference_m": 1e-5, "preload_N": 950.0}],
        "without_torque": {"sun": SUN},
        "standing": None,
        "rolling": None,
        "torque_capacity": CAPACITY,
        "rolling_torque_capacity": CAPACITY,
        "turning": turning,
    }
    blocks = list(branch_tables(found))
    (said,) = (block for block in blocks if isinstance(block, Bullets))
    assert said.items == ["drift and losses are not known: planet 2 slips."]
    rows = dict(blocks[-1].rows)
    assert rows["losses of these branches"] == "–"
    known = found | {"turning": turning | {"unknown_because": []}}
    assert not any(isinstance(block, Bullets) for block in branch_tables(known))

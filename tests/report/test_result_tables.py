"""Tables of a joint at rest, from documents whose numbers are written out here."""

import math

from asperity.report.content import Paragraph, Table
from asperity.report.result_tables import stiffness, windup

ARCMINUTE = math.pi / 180.0 / 60.0


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
        level: {"sun_Nm_per_rad": 10.0, "output_Nm_per_rad": 810.0, "output_Nm_per_arcmin": 0.25}
        for level in ("assembly", "series_with_bulk", "published")
    }
    budget = {"bodies_share": 0.25, "asperity_share": {"sp": 0.5, "wro": 0.0}, "pins_share": 0.125}
    document = {
        "torsional_stiffness": levels, "stiffness_unknown_because": "it slips", "stiffness_budget": budget,
    }  # fmt: skip
    blocks = list(stiffness(document))
    found = rows_of(blocks)
    assert found["Torsional stiffness"][0][1:] == ("10", "810", "0.25")
    assert [b.text for b in blocks if isinstance(b, Paragraph)] == ["No value: it slips."]
    assert found["Stiffness budget: shares of the compliance of the assembled joint"] == [
        ("sp asperity", "50"), ("bodies", "25"), ("pins", "12.5"),
    ]  # fmt: skip

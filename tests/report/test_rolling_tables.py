"""Tables of a joint that turns, from a document whose numbers are written out here."""

import math

from asperity.report.content import Bullets, Paragraph, Table
from asperity.report.rolling_tables import rolling

TURN_AN_ARCMINUTE = math.pi / 180.0 / 60.0


def document(**changes):
    contact = {
        "creepage": 1.5e-3, "traction_coefficient": 0.046, "shakedown_ratio": 0.9, "life_output_turns": 2e6,
        "axial_force_N": 0.0, "losses_W": {"creep": 1.0, "skew": 0.0, "hysteresis": None, "oil": None, "total": 1.0},
        "capacity_loss": 0.0, "flash_temperature_K": None, "film_thickness_m": None, "film_ratio": None,
    }  # fmt: skip
    found = {
        "unknown_because": [], "contacts": {"sp": contact}, "axial_thrust_N": {"sun": 0.0, "planet": 0.0},
        "drift_rad_per_output_turn": 40.0 * TURN_AN_ARCMINUTE, "speed_loss": 1.85e-3, "efficiency": 0.98,
        "input_power_W": 50.0, "output_power_W": 49.0, "reliability": 0.9, "no_life_because": None,
        "losses_W": {"creep": 1.0, "skew": 0.0, "hysteresis": None, "oil": None, "bearings": 0.25, "total": 1.25},
        "torque_capacity_Nm": 12.5, "life_hours": 1e4, "life_output_turns": 4e6,
        "body_life_hours": {"loading_roller": 2e4},
        "body_life_output_turns": {"loading_roller": 8e6}, "duty_life_hours": 3e4, "duty_life_output_turns": 5e6,
    }  # fmt: skip
    found |= changes
    return {
        "rolling": found,
        "stiffness_bound": None,
        "torsional_stiffness": {"assembly": {"output_Nm_per_rad": 2.0 / TURN_AN_ARCMINUTE}},
        "standing": {"forces": {"output_torque_Nm": 5.0}},
        "input": {},
        "standing_torque_capacity": {"output_torque_Nm": 9.0, "reverse": {"output_torque_Nm": 9.0}},
    }


def tables(blocks):
    return {block.title: [tuple(row) for row in block.rows] for block in blocks if isinstance(block, Table)}


def test_drift_stands_beside_the_stiffness():
    """5 N·m on 2 N·m/arcmin are 2.5 arcmin that come back; 40 arcmin a turn do not."""
    rows = tables(rolling(document()))["Position of the output: drift beside stiffness"]
    assert [row[:2] for row in rows] == [
        ("drift per output turn", "40 arcmin"),
        ("speed loss", "0.185 %"),
        ("stiffness at standstill", "2 N·m/arcmin"),
        ("torque over stiffness", "2.5 arcmin"),
        ("torque capacity, rolling", "12.5 N·m"),
    ]


def test_film_and_flash_temperature_where_they_are_known():
    """Between half and three times the roughness both carry the load; nothing of it known is no table."""
    assert "Surfaces in rolling" not in tables(rolling(document()))
    of_contact = document()["rolling"]["contacts"]["sp"]
    known = of_contact | {"flash_temperature_K": 12.5, "film_thickness_m": 4e-7, "film_ratio": 1.6}
    found = tables(rolling(document(contacts={"sp": known, "pr": of_contact})))
    assert found["Surfaces in rolling"] == [
        ("sp", "12.5", "0.4", "1.6", "mixed"), ("pr", "–", "–", "–", "–"),
    ]  # fmt: skip


def test_losses_by_contact_and_in_all():
    found = tables(rolling(document()))
    (title,) = (each for each in found if each.startswith("Losses"))
    assert title == "Losses, W; efficiency 98 %, power in 50 W, out 49 W"
    assert found[title] == [
        ("sp", "1", "0", "–", "–", "1"),
        ("bearings and pins", "", "", "", "", "0.25"),
        ("all", "1", "0", "–", "–", "1.25"),
    ]
    assert found["Contacts in rolling"] == [("sp", "1.5", "0.046", "0.9", "2e6")]


def test_lives_of_drive_and_bodies_and_under_a_duty():
    found = document()
    title = "Rating life L10"
    rows = tables(rolling(found))[title]
    assert [row[0] for row in rows] == ["the drive", "loading roller"]
    found["input"]["duty"] = [{}]
    assert tables(rolling(found))[title][-1][0] == "the drive under the duty"
    assert not any(isinstance(block, Paragraph) and "rating life" in block.text for block in rolling(found))
    found["rolling"]["no_life_because"] = "no rating life: at sp it flows"
    (said,) = (b.text for b in rolling(found) if isinstance(b, Paragraph) and "rating life" in b.text)
    assert said == "No rating life: at sp it flows."


def test_thrust_only_where_axes_are_skewed_and_reasons_first():
    parallel = list(rolling(document()))
    assert any(
        isinstance(block, Paragraph) and block.text.startswith("Axial thrust: none") for block in parallel
    )
    skewed = document(unknown_because=["the sun stands"], axial_thrust_N={"sun": -30.0, "planet": 10.0})
    skewed["rolling"]["contacts"]["sp"]["axial_force_N"] = 10.0
    blocks = list(rolling(skewed))
    assert isinstance(blocks[0], Bullets)
    assert list(blocks[0].items) == ["the sun stands."]
    assert tables(blocks)["Axial thrust on each body, N"] == [("-30", "10")]

"""The verdict of solved joints: what fails heads it, whatever else is not known."""

import re

import pytest

from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solve_case

pytestmark = pytest.mark.slow  # whole joints, solved at several torques

SEAT = '\n[housing]\nouter_diameter = "150 mm"\ninterference = "2.5 um"\nfriction_coefficient = 0.12\n'
HOUSED = (
    ('ring_support = "free"', 'ring_support = "elastic_housing"'),
    ('ring = "52100"', 'ring = "440C"\nhousing = "6061-T6"'),
)
OIL = 'viscosity = "{}"\npressure_coefficient = "20 1/GPa"\nroughness = "{}"\n'
THIN, THICK = OIL.format("5 mPa*s", "0.3 um"), OIL.format("60 mPa*s", "0.1 um")


@pytest.fixture(scope="module")
def solved(zou_file):
    text = zou_file.with_name("planetary.toml").read_text(encoding="utf-8")

    def of(*replaced, more=""):
        changed = text
        for old, new in replaced:
            assert old in changed
            changed = changed.replace(old, new)
        return solve_case(parse_case(changed + more, source="mine.toml")).document

    return of


def life(hours):
    return f'\n[rolling]\nrequired_life = "{hours} h"\n'


def test_a_ring_that_turns_in_its_housing_fails_although_the_model_is_outside_its_range(solved):
    """A seat with 2.5 µm; the ring also lifts off between its rollers, and its steel has no fatigue strength."""
    verdict = solved(*HOUSED, ('"10 N*m"', '"11 N*m"'), more=SEAT)["verdict"]
    assert (verdict["title"], verdict["works"], verdict["holds"]) == ("Fails", False, None)
    failed = r"ring seat: holding torque / applied torque 0\.\d+ at ring, at least 1\. "
    assert re.match(failed, verdict["words"])
    outside = "Outside the model's range until these are resolved: smallest pressure on the housing"
    assert outside in verdict["words"]
    assert verdict["words"].endswith("Not checked: ring fatigue (enter fatigue_strength of material 440C).")


def test_a_torque_between_both_capacities_fails_in_rolling(solved):
    document = solved(('"10 N*m"', '"12 N*m"'))
    rolling = document["rolling"]["torque_capacity_Nm"]
    assert rolling < 12.0 < document["standing_torque_capacity"]["output_torque_Nm"]
    assert document["drift_rad_per_output_turn"] is None
    verdict = document["verdict"]
    assert verdict["title"] == "Fails"
    said = f"torque over rolling capacity {12.0 / rolling:.3g}, at most 1. Not checked: "
    assert verdict["words"].startswith(said)
    assert solved(('"10 N*m"', '"12 N*m"'), ('"1500 rpm"', '"0 rpm"'))["verdict"]["works"] is True


def test_a_steel_without_a_fatigue_strength_lacks_one_check(solved):
    verdict = solved(('ring = "52100"', 'ring = "17-4PH"'))["verdict"]
    assert (verdict["title"], verdict["works"], verdict["holds"]) == ("Works, one check missing", True, None)
    assert verdict["words"] == "ring fatigue (enter fatigue_strength of material 17-4PH)."
    known = solved()
    assert known["verdict"]["title"] == "Works"
    assert known["rims"]["ring"]["fatigue_safety"] > 1.0
    share = 100.0 * 10.0 / known["rolling"]["torque_capacity_Nm"]
    assert known["verdict"]["nearest"]["words"] == f"torque, {share:.2g} % of rolling capacity"


@pytest.mark.parametrize(
    ("oil", "hours", "title", "ok", "known"),
    [
        (THIN, 10_000, "Works, one check missing", False, False),
        (THIN, 100_000_000, "Fails", False, True),
        (THICK, 10_000, "Works", True, True),
        (THICK, 100_000_000, "Fails", False, True),
    ],
)
def test_a_life_in_a_thin_film_is_never_met(solved, oil, hours, title, ok, known):
    """The life is between both that are required; only the thick oil has a full film at every contact."""
    document = solved(('viscosity = "30 mPa*s"\n', oil), more=life(hours))
    (entry,) = (each for each in document["diagnostics"] if each["name"] == "required_drive_life")
    assert (entry["ok"], entry["known"]) == (ok, known)
    verdict = document["verdict"]
    assert verdict["title"] == title
    least = min(contact["film_ratio"] for contact in document["rolling"]["contacts"].values())
    assert (least < 3.0) is (oil == THIN)
    assert (f"(no film factor, λ {least:.2g})" in verdict["words"]) is (oil == THIN)

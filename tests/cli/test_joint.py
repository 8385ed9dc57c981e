"""``asperity joint``: the document, the tables, the refusals."""

import dataclasses
import json
import math
from pathlib import Path

import numpy as np
import pytest

CONTACTS = ["sp", "pwr", "pwl", "wro", "wlo"]

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def document(call, joint_file):
    outcome = call("joint", joint_file(), "--json")
    assert (outcome.code, outcome.err) == (0, "")
    return json.loads(outcome.out)


def test_the_document_has_every_key_in_si(document):
    assert set(document["geometry"]) >= {"alpha_rad", "theta_rad", "wedge_angle_rad", "speed_ratio"}
    forces = document["standing"]["forces"]
    assert (
        list(forces["normal_N"])
        == list(forces["tangential_N"])
        == list(document["standing"]["contacts"])
        == CONTACTS
    )
    assert set(forces["pin_N"]) == {"left_loading_roller", "right_loading_roller"}
    assert set(forces["body_mass_kg"]) == {"sun", "planet", *forces["pin_N"], "ring"}
    assert set(forces) >= {"input_torque_Nm", "output_speed_rad_per_s"}
    assert document["input_speed_rad_per_s"] == document["input"]["load"]["sun_speed"]
    for contact in document["standing"]["contacts"].values():
        assert set(contact) >= {
            "largest_area_m2",
            "critical_area_m2",
            "real_contact_area_m2",
            "contact_factor",
            "asperity_tangential_stiffness_N_per_m",
            "asperity_normal_stiffness_N_per_m",
            "contact_torsional_stiffness_Nm_per_rad",
        }
    for level in ("published", "series_with_bulk", "assembly"):
        stiffness = document["torsional_stiffness"][level]
        assert set(stiffness) == {"input_Nm_per_rad", "output_Nm_per_rad", "output_Nm_per_arcmin"}
    for entry in document["diagnostics"]:
        words = {"label", "severity", "state", "meaning", "remedy", "shown", "limit_shown"}
        assert set(entry) == {"name", "contact", "value", "limit", "ok", "known", "infinite", "unit"} | words
        assert (entry["remedy"] is None) == entry["ok"]
    assert document["input"]["load"]["preload"] == 1000.0
    assert any("[bearings]" in sentence for sentence in document["assumptions"])


def test_the_numbers_of_the_issue(document):
    """T_sp = 46.30 N, about 4.3e6 N·m/rad at 5 N·m; angles, ratio and masses by hand from the radii."""
    assert document["standing"]["forces"]["tangential_N"]["sp"] == pytest.approx(46.30, abs=0.005)
    published = document["torsional_stiffness"]["published"]
    assert published["output_Nm_per_rad"] == pytest.approx(4.3e6, rel=0.02)
    assert published["output_Nm_per_rad"] == pytest.approx(81.0 * published["input_Nm_per_rad"], rel=1e-12)
    assert published["output_Nm_per_arcmin"] == pytest.approx(
        published["output_Nm_per_rad"] * 2.908882087e-4, rel=1e-9
    )
    # triangle of sun, planet and loading roller: sides of 4 + 13.5, 13.5 + 5 and 40 - 5 mm, cosine rule; in degrees
    # 13.9248, 27.0831 and 13.1582
    inner, middle, outer = 17.5, 18.5, 35.0
    alpha = math.acos((inner**2 + outer**2 - middle**2) / (2.0 * inner * outer))
    beta = math.acos((middle**2 + outer**2 - inner**2) / (2.0 * middle * outer))
    assert (alpha, beta) == pytest.approx((0.243034, 0.229654), abs=1e-6)
    for key, angle in (("alpha_rad", alpha), ("wedge_angle_rad", beta), ("theta_rad", alpha + beta)):
        assert document["geometry"][key] == pytest.approx(angle, rel=1e-12)
    assert document["geometry"]["speed_ratio"] == pytest.approx(-9.0, rel=1e-15)
    assert document["standing"]["forces"]["output_speed_rad_per_s"] == pytest.approx(-69.81317, rel=1e-6)
    assert document["standing"]["forces"]["body_mass_kg"]["planet"] == pytest.approx(
        7850 * 3.14159265 * 13.5e-3**2 * 5e-3, rel=1e-8
    )
    assert document["standing"]["forces"]["input_torque_Nm"] == pytest.approx(5.0 / 9.0, rel=1e-12)
    shares = document["stiffness_budget"]
    total = sum(sum(share.values()) if isinstance(share, dict) else share for share in shares.values())
    assert total == pytest.approx(1.0, rel=1e-9)


def test_at_small_torque_the_published_stiffness_is_five_million(call, joint_file):
    outcome = call("joint", joint_file(('"5 N*m"', '"1e-6 N*m"')), "--json")
    assert json.loads(outcome.out)["torsional_stiffness"]["published"]["output_Nm_per_rad"] == pytest.approx(
        5.0e6, rel=0.02
    )


def test_the_capacity_is_told_with_the_contact_that_limits_it(call, joint_file, document):
    """T_sp = T_out/(9 n R_s) reaches mu N_sp; N_sp, 1000 N at rest, rises by a few per cent on the way."""
    capacity = document["standing_torque_capacity"]
    by_hand = 0.12 * 1000.0 * 9.0 * 3.0 * 4e-3
    assert by_hand < capacity["output_torque_Nm"] < 1.05 * by_hand
    assert (capacity["limiting_contact"], capacity["meaning"]) == ("sp", "contact sp slips")
    told = " ".join(call("joint", joint_file(), "--all").out.split())
    assert "torque capacity 0 N·m: contact sp beyond first yield without torque (both directions)" in told
    standing = f"{capacity['output_torque_Nm']:.4g} N·m"
    assert f"torque capacity, standing {standing}: contact sp slips (both directions)" in told


def test_a_wedge_that_tightens_is_limited_by_lift_off(call, joint_file):
    """With mu = 0.3 no contact slips before the left roller lifts off.

    There t = tan(theta/2) = 0.2408 at the planet and t/(cos beta - t sin beta) = 0.262 at the ring; theta = 27.083 deg.
    """
    steep = joint_file(("friction_coefficient = 0.12", "friction_coefficient = 0.3"))
    capacity = json.loads(call("joint", steep, "--json").out)["standing_torque_capacity"]
    assert (capacity["limit"], capacity["limiting_contact"]) == ("lift_off", "pwl")
    assert (capacity["reverse"]["limit"], capacity["reverse"]["limiting_contact"]) == ("lift_off", "pwr")


@pytest.mark.parametrize("options", [(), ("--all",)])
def test_the_tables_name_their_units_and_warn(call, joint_file, options):
    outcome = call("joint", joint_file(), *options)
    assert (outcome.code, outcome.err) == (0, "")
    further = (
        "angle alpha between planet and loading roller 13.92 deg",
        "direction theta from planet to loading roller 27.08 deg",
        "wedge angle beta 13.16 deg",
        "Contact stiffness",
        "Compliance of the assembled joint, by spring",
    )
    told = " ".join(outcome.out.split())
    for text in (
        "3 planets, sun at 6000 rpm, preload 1000 N (interference 12.72 µm), output torque 5 N·m",
        "N·m/rad",
        "N·m/arcmin",
        "46.3",
        "an upper bound",
        "Speed ratio -9",
        "Hertz pressure over first yield 2.035 at sp",
        "Asperities alone: outside the range of this law, real area over Hertz area",
        *(further if options else ["Assumptions (in full, with shares, springs and the drive, with --all)"]),
        "no section [bearings]" if options else "not in the file: section [bearings], ",
    ):
        assert text in told, text
    assert options or not any(text in told for text in further)
    assert "\x1b" not in outcome.out
    assert max(map(len, outcome.out.splitlines())) <= 100


@pytest.mark.slow
def test_a_planet_thrown_off_the_sun_is_refused_with_a_remedy(call, joint_file):
    """By its own centrifugal force: no contact, no torque, no stiffness."""
    fast = joint_file(
        ('"5 N*m"', '"0 N*m"'), ('"6000 rpm"', '"9e5 rpm"'), ('"elastic"', '"constant_pin_force"')
    )
    outcome = call("joint", fast, "--json")
    assert (outcome.code, outcome.out) == (2, "")
    assert "beyond the standing torque capacity 0 N·m, at which" in outcome.err
    assert "raise the preload (load.preload), or lower the speed" in outcome.err


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            '"1000 N"',
            "1000",
            "load.preload: expected a force with its unit as text (e.g. '1000 N'), got the bare number 1000",
        ),
        ('"40 mm" ', '"30 mm" ', "the rollers do not fit: planet and ring overlap by 1 mm"),
        ('"5 N*m"  ', '"50 N*m"  ', "the output torque 50 N·m is beyond the standing torque capacity"),
    ],
)
def test_bad_input_is_one_message_and_exit_code_2(call, joint_file, old, new, said):
    outcome = call("joint", joint_file((old, new)))
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err.startswith("asperity: error: ")
    assert said in outcome.err
    assert "Traceback" not in outcome.err


def test_a_file_that_is_not_there(call):
    outcome = call("joint", "nowhere.toml")
    assert outcome.code == 2
    assert (
        outcome.err
        == "asperity: error: nowhere.toml: there is no such file; 'asperity init' writes an example\n"
    )


def test_no_solution_is_exit_code_3(call, joint_file, monkeypatch):
    from asperity.joint import solve as solving

    real = solving.solution_of

    def unbalanced(joint):
        solution = real(joint)
        forces = dataclasses.replace(solution.result.forces, balance_residual=np.asarray(np.inf))
        result = dataclasses.replace(solution.result, solved=np.asarray(False), forces=forces)
        return dataclasses.replace(solution, result=result)

    monkeypatch.setattr(solving, "solution_of", unbalanced)
    outcome = call("joint", joint_file())
    assert outcome.code == 3
    assert outcome.out == ""
    assert "no balance under 5 N·m was found; lower the torque" in outcome.err  # no residual that is infinite


def test_picture_of_budget_levels_and_margins(call, joint_file, tmp_path):
    outcome = call("joint", joint_file(), "--plot", tmp_path / "j.svg")
    assert (outcome.code, outcome.err.strip()) == (0, f"wrote {tmp_path / 'j.svg'}")
    assert (tmp_path / "j.svg").read_text(encoding="utf-8").startswith("<?xml")
    refused = call("joint", joint_file(), "--plot", tmp_path / "j.xyz")
    assert (refused.code, refused.out) == (2, "")


@pytest.mark.parametrize(
    "name",
    [
        "planetary",
        "planetary_hollow",
        "multiroller",
        "stepped_planet",
        "planar",
        "wheel_pair",
        "tutorial_joint",
        "zou2025",
    ],
)
def test_what_is_asked_first_fits_on_a_screen_or_two(call, name):
    """The file with the most contacts and warnings, that of the paper, fills 60 lines."""
    printed = call("joint", EXAMPLES / f"{name}.toml").out.splitlines()
    assert len(printed) <= 60
    assert max(map(len, printed)) <= 100

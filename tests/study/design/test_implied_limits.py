"""Limits that a design keeps without stating them: their list, and designs that would break one of them."""

import json
import tomllib

import numpy as np
import pytest
from click.testing import CliRunner
from tests.support.worn import EXAMPLES, changed

from asperity.cli.commands import asperity
from asperity.errors import InputError
from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values
from asperity.joint_file.solved_document import solve_case
from asperity.joint_file.wear import wear_of_case
from asperity.results.accuracy_document import accuracy_document
from asperity.results.torque_capacity import JUDGED
from asperity.study.design.design import design
from asperity.study.design.design_file import design_from_tables
from asperity.study.design.implied_limits import LEAST_CLEARANCE

ARCSECOND = np.pi / 648000.0
LIFE = '# required_life = "20000 h"'
RATED = '[pin_bearing]\ntype = "roller"\ndynamic_rating = "8 kN"\nstatic_rating = "9 kN"\ncount = 1\n[lubrication]'
DUTY = '[[duty]]\noutput_torque = "8 N*m"\nsun_speed = "1500 rpm"\nshare = 1.0\n\n[lubrication]'


@pytest.fixture
def problem(zou_file):
    """Maker of a design problem of the planetary example, with replaced pieces of its text."""

    def make(text, replaced=None):
        joint = zou_file.with_name("planetary.toml").read_text()
        for old, new in (replaced or {}).items():
            assert old in joint, old
            joint = joint.replace(old, new)
        tables = tomllib.loads(f'joint = "planetary.toml"\n{text}\n[search]\nstarts = 1')
        return design_from_tables(tables, folder=zou_file.parent, case=parse_case(joint, source="test"))

    return make


THIN = '[variables]\n"drive.ring_wall_thickness" = { lower = "1 mm", upper = "9 mm" }\n[objective]\nminimise = "mass"'


def implied(problem):
    return {(c.name, c.at_most): (c.limit, c.rows) for c in problem.constraints if c.implied}


def test_every_limit_of_function_and_damage_is_implied(problem):
    found = implied(problem(THIN))
    assert found["pressure_over_first_yield", True] == (pytest.approx(1.0, rel=2e-6), (0, 1))
    assert found["shakedown_ratio", True][1] == (0, 1)
    assert found["rim_yield_safety", False] == (pytest.approx(1.0, rel=2e-6), (2,))
    assert found["clearance", False] == (LEAST_CLEARANCE, (0,))
    # inside the limits, at which they are crossed
    assert found["pressure_over_first_yield", True][0] < 1.0 < found["rim_yield_safety", False][0]
    assert not any(name in ("drive_life", "bearing_static_safety") for name, _ in found)


@pytest.mark.parametrize(
    ("duty", "names"), [("", ("drive_life", "bearing_life")), (DUTY, ("duty_life", "bearing_duty_life"))]
)
def test_the_required_life_is_one_of_them(problem, duty, names):
    replaced = {LIFE: 'required_life = "20000 h"', "# [rolling]": "[rolling]", "[lubrication]": RATED}
    found = implied(
        problem(THIN, replaced | ({"[lubrication]": RATED.replace("[lubrication]", DUTY)} if duty else {}))
    )
    for name in names:
        limit, rows = found[name, False]
        assert limit == pytest.approx(20000.0 * 3600.0, rel=2e-6)
        assert rows == (0,)
    assert found["bearing_static_safety", False][1] == (0,)


def test_a_stated_limit_takes_the_place_of_an_implied_one(problem):
    stated = THIN + (
        '\n[constraints]\nclearance = { at_least = "0.05 mm" }\n'
        'pressure_over_first_yield = { at_most = 1.5, contacts = ["pr"] }\nshakedown_ratio = { at_least = 0.1 }'
    )
    found = implied(problem(stated))
    assert ("clearance", False) not in found
    assert found["pressure_over_first_yield", True][1] == (0,)  # of the other contact
    assert found["shakedown_ratio", True][1] == (0, 1)  # the other way


@pytest.mark.slow
def test_the_lightest_ring_does_not_yield(problem):
    """Under 3 kN at each of three planets; a thin ring by hand, M = P R/2 (1/a - cot a) with a = 60 degrees."""
    steel = {'interference = "30 um"': 'preload = "3000 N"', 'ring = "52100"': 'ring = "17-4PH"'}
    found = design(problem(THIN, steel))
    assert found.feasible
    assert [limit.name for limit in found.limits if limit.active] == ["rim_yield_safety"]
    wall, angle = found.point["drive.ring_wall_thickness"], np.pi / 3.0
    radius = 50e-3 + 0.5 * wall
    stress = 3.0 * 3000.0 * radius * (1.0 / angle - 1.0 / np.tan(angle)) / (10e-3 * wall**2)
    stress = stress * (1.0 - wall / (3.0 * radius)) + 0.5 * 3000.0 / np.tan(angle) / (10e-3 * wall)
    mises = stress * np.sqrt(1.0 - 0.272 + 0.272**2)
    assert mises == pytest.approx(1276e6, rel=0.05)
    solved = solve_case(parse_case(found.joint_text, source="designed")).document
    crossed = [
        entry["name"] for entry in solved["diagnostics"] if not entry["ok"] and entry["severity"] in JUDGED
    ]
    assert crossed == []
    assert found.joint_text.splitlines()[1] == "# All limits are met."


@pytest.mark.slow
def test_a_required_life_that_cannot_be_had_is_no_design(problem):
    """The example lives 1.6e7 h at least as it is; ten times that needs longer contacts than the bound allows."""
    text = '[variables]\n"drive.contact_length" = { lower = "9 mm", upper = "10 mm" }\n[objective]\nminimise = "mass"'
    life = {LIFE: 'required_life = "3e8 h"', "# [rolling]": "[rolling]"}
    found = design(problem(text, life))
    assert not found.feasible
    (missed,) = (limit for limit in found.limits if not limit.met)
    assert (missed.name, missed.implied) == ("drive_life", True)
    assert set(found.at_bound) == {"drive.contact_length"}
    assert [limit.name for limit in found.missed_before] == ["drive_life"]


@pytest.mark.slow
def test_the_output_says_what_holds_it_and_what_the_file_missed(zou_file, tmp_path):
    """The planetary at 12 N·m, beyond its capacity of 11.9 N·m in rolling; numbers with few digits."""
    joint = zou_file.with_name("planetary.toml").read_text()
    assert '"10 N*m"' in joint
    (tmp_path / "planetary.toml").write_text(
        joint.replace('output_torque = "10 N*m"', 'output_torque = "11 N*m"')
    )
    (tmp_path / "d.toml").write_text(
        'joint = "planetary.toml"\n[variables]\nload.interference = { lower = "20 um", upper = "60 um" }\n'
        '[objective]\nminimise = "preload"\n[constraints]\nslip_ratio = { at_most = 0.8 }\n[search]\nstarts = 1\n'
    )
    done = CliRunner().invoke(
        asperity, ["design", str(tmp_path / "d.toml"), "--out", str(tmp_path / "o.toml")]
    )
    text = " ".join(done.output.split())
    assert done.exit_code == 0, done.output
    assert "All limits are met" in text
    assert "The joint of the file misses: slip ratio T/(mu N) at sp at most 0.8 (reached 0.906" in text
    assert "The design is held by: slip ratio T/(mu N) at sp at its largest, 0.8" in text
    written = tomllib.loads((tmp_path / "o.toml").read_text())["load"]["interference"]
    number, unit = written.split(" ")
    assert unit == "um"
    assert len(number.replace(".", "")) <= 4
    assert "30 um" not in (tmp_path / "o.toml").read_text()
    again = json.loads(CliRunner().invoke(asperity, ["joint", str(tmp_path / "o.toml"), "--json"]).stdout)
    slip = max(entry["value"] for entry in again["diagnostics"] if entry["name"] == "slip_ratio")
    assert 0.799 < slip <= 0.8


def test_lives_have_the_unit_of_their_results(problem):
    replaced = {LIFE: 'required_life = "20000 h"', "# [rolling]": "[rolling]"}
    made = problem(THIN, replaced)
    values = si_values(made.case)
    assert values["rolling"]["required_life"] == pytest.approx(7.2e7)
    assert made.table["drive_life"].si_unit == "s"
    assert np.isfinite(implied(made)["drive_life", False][0])


def joint_problem(example, replaced, variables, tmp_path):
    """A design of one variable of an example, with replaced pieces of its text."""
    text = changed((EXAMPLES / example).read_text(), replaced)
    tables = tomllib.loads(f'joint = "{example}"\n{variables}\n[search]\nstarts = 1')
    return design_from_tables(tables, folder=tmp_path, case=parse_case(text, source=example))


INTERFERENCE = (
    '[variables]\nload.interference = {{ lower = "{}", upper = "{}" }}\n[objective]\nminimise = "preload"'
)
REQUIRED = 'required_life = "10000 h"'


def test_grip_under_wear_and_an_even_turn_are_implied(tmp_path):
    found = implied(joint_problem("wear.toml", {}, INTERFERENCE.format("24 um", "40 um"), tmp_path))
    assert found["life_wear", False] == (pytest.approx(10000.0 * 3600.0, rel=2e-6), (0,))
    assert found["life_wear", False][0] > 10000.0 * 3600.0  # inside
    without = {f"[rolling]\n{REQUIRED}": ""}
    assert ("life_wear", False) not in implied(
        joint_problem("wear.toml", without, INTERFERENCE.format("24 um", "40 um"), tmp_path)
    )
    allowed = {"[model]": '[rolling]\nallowed_transmission_error = "48 arcsec"\n\n[model]'}
    found = implied(joint_problem("accuracy.toml", allowed, INTERFERENCE.format("12 um", "24 um"), tmp_path))
    limit, rows = found["transmission_error", True]
    assert (limit, rows) == (pytest.approx(48.0 * ARCSECOND, rel=2e-6), (0,))
    assert limit < 48.0 * ARCSECOND
    assert found["turn_slip_ratio", True][0] == pytest.approx(1.0, rel=2e-6)
    found = implied(joint_problem("accuracy.toml", {}, INTERFERENCE.format("12 um", "24 um"), tmp_path))
    assert ("transmission_error", True) not in found
    assert ("turn_slip_ratio", True) in found


def test_a_force_under_wear_cannot_keep_a_required_life(tmp_path):
    force = {'interference = "25 um"': 'preload = "1000 N"'}
    length = '[variables]\n"drive.contact_length" = { lower = "4 mm", upper = "9 mm" }\n[objective]\nminimise = "mass"'
    with pytest.raises(InputError) as refused:
        joint_problem("wear.toml", force, length, tmp_path)
    assert str(refused.value).startswith("load.preload: a force does not say what wear takes from it")
    assert "state load.interference, or leave [wear] out of the joint file" in str(refused.value)
    # a cam follows, and without a required life nothing is asked of it
    for other in (
        force | {'preload = "1000 N"': 'preload = "200 N"\ncam_force_per_torque = "160 N/Nm"'},
        force | {f"[rolling]\n{REQUIRED}": ""},
    ):
        assert ("life_wear", False) not in implied(joint_problem("wear.toml", other, length, tmp_path))


WORN = '\n[wear]\ncoefficient = "1e-17 1/Pa"\n'
UNROUND = (
    '[[form]]\npart = "ring"\nharmonics = { 3 = "1 um" }\n'
    '[[form]]\npart = "planet"\nharmonics = { 2 = "0.5 um" }\n'
)


@pytest.mark.long
def test_a_design_lasts_its_required_life_under_wear(problem):
    """The planetary example slides at 25 498 h with 30 um; one joint by itself says when the design does."""
    worn = {
        LIFE: 'required_life = "20000 h"',
        "# [rolling]": "[rolling]",
        "[lubrication]": WORN + "[lubrication]",
    }
    found = design(problem(INTERFERENCE.format("29 um", "60 um"), worn))
    assert found.feasible
    assert [limit.name for limit in found.limits if limit.active] == ["life_wear"]
    slide = wear_of_case(parse_case(found.joint_text, source="designed")).wear.first_slide
    hours = slide.coefficient_time / 1e-17 / 3600.0
    assert 20000.0 < hours < 20200.0  # four digits of the interference, which moves it steeply
    assert found.point["load.interference"] < 30e-6


@pytest.mark.long
def test_a_design_keeps_its_transmission_error(problem):
    """Planets held harder follow the ring's waves less: 2.46 arcsec at 40 um, 1.89 at 50 um."""
    uneven = {
        "# [rolling]": '[rolling]\nallowed_transmission_error = "2 arcsec"',
        "[lubrication]": UNROUND + "[lubrication]",
    }
    found = design(problem(INTERFERENCE.format("40 um", "60 um"), uneven))
    assert found.feasible
    assert [limit.name for limit in found.limits if limit.active] == ["transmission_error"]
    document = accuracy_document(joint_accuracy(parse_case(found.joint_text, source="designed")))["accuracy"]
    assert 1.99 * ARCSECOND < document["transmission_error_rad"]["worst"] <= 2.0 * ARCSECOND
    assert 45e-6 < found.point["load.interference"] < 50e-6

"""What the page is told of a joint beside its document: the file's values, and why there is no wind-up."""

import json
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.reader import parse_case, read_case
from asperity.page import answer
from asperity.page.answer import (
    _curves,
    _windup,
    drive_shapes,
    joint_answer,
    plain_numbers,
    stated_values,
)
from asperity.page.joint_request import JointRequest
from asperity.results import RESULTS
from asperity.standing.windup import windup

RESULTS_BY_LABEL = {row.label: name for name, row in RESULTS.items()}
NORMAL = np.array([1000.0, 600.0, 500.0, 590.0, 490.0])
TANGENTIAL = np.array([46.0, 26.0, 20.0, 26.0, 20.0])


def test_numbers_for_json():
    assert plain_numbers(np.array([1.5, np.nan, np.inf, -np.inf, 0.0])) == [1.5, None, None, None, 0.0]


def test_values_are_in_the_unit_of_display_and_in_si(joint_text):
    text = joint_text.replace('"13.5 mm"', '"0.0135 m +- 5 um, uniform"')
    numbers = stated_values(parse_case(text, source="x"), {})["numbers"]
    assert numbers["drive.planet_radius"] == {
        "value": 13.5,
        "si": pytest.approx(0.0135, rel=1e-15),
        "tolerance": pytest.approx(5e-6, rel=1e-12),
    }
    assert numbers["load.sun_speed"]["value"] == 6000.0
    assert numbers["load.sun_speed"]["si"] == pytest.approx(6000.0 * math.pi / 30.0, rel=1e-15)
    assert numbers["materials.steel.youngs_modulus"]["value"] == 206.0


def test_an_rz_and_the_shares_are_entered_and_no_numbers_of_charts(joint_text):
    changes = {
        "surface.mean_roughness_depth": "1.6 um",
        "duty": "0",
        "duty.1.output_torque": "1 N*m",
        "duty.1.sun_speed": "1 rpm",
        "duty.1.share": 1,
    }
    request = JointRequest("x", joint_text, changes)
    stated = stated_values(request.case(), request.file_tables)
    assert set(stated["entered"]) == {"surface.mean_roughness_depth", "duty.1.share"}
    assert not set(stated["entered"]) & set(stated["numbers"])
    depth = stated["entered"]["surface.mean_roughness_depth"]
    assert (depth["value"], depth["text"]) == (1.6, "1.6 um")
    assert stated["lists"]["duty"]["of_file"] == []


@pytest.mark.parametrize("more", [{}, {"wear.coefficient": "3e-17 1/Pa"}])
def test_a_wear_coefficient_is_entered_with_its_unit(zou_file, more):
    request = JointRequest("x", zou_file.with_name("wear.toml").read_text(encoding="utf-8"), more)
    stated = stated_values(request.case(), request.file_tables)["numbers"]["wear.coefficient"]
    value = pytest.approx(3e-17 if more else 1e-17, rel=1e-14, abs=0.0)
    text = "3e-17 1/Pa" if more else "1e-17 1/Pa"
    assert (stated["value"], stated["si"], stated["tolerance"]) == (value, value, 0.0)
    assert ("[wear]" in request.file_text(), text in request.file_text()) == (True, True)


def test_a_wear_coefficient_adds_its_section_and_takes_it_away(zou_file):
    without = zou_file.with_name("tutorial_joint.toml").read_text(encoding="utf-8")
    added = JointRequest("x", without, {"wear.coefficient": "3e-17 1/Pa"}).file_text()
    assert JointRequest("x", added).case().wear.coefficient.value == pytest.approx(3e-17, rel=1e-14, abs=0.0)
    assert "[wear]" not in JointRequest("x", added, {"wear.coefficient": ""}).file_text()


def test_a_choice_that_the_file_leaves_out_is_empty(case, joint_text):
    choices = stated_values(case, {})["choices"]
    assert choices["model.contact_factor"] == "printed" or choices["model.contact_factor"] == "unity"
    assert choices["model.bodies"] == "exact"
    lines = [line for line in joint_text.splitlines() if not line.startswith("bodies =")]
    assert stated_values(parse_case("\n".join(lines), source="x"), {})["choices"]["model.bodies"] == ""


def test_without_a_torque_there_is_no_windup(joint_text):
    case = parse_case(joint_text.replace('"5 N*m"', '"0 N*m"'), source="x")
    assert _windup(SimpleNamespace(joint=joint_from_case(case))) == {
        "unknown_because": "no torque, no wind-up: set an output torque"
    }


def test_the_curves_go_up_to_the_capacity_in_the_direction_of_the_torque(monkeypatch):
    solved = SimpleNamespace(joint=None, standing_capacity_of_direction=SimpleNamespace(output_torque=13.0))

    def curves(*, joint, torque_capacity):
        names = (
            "published",
            "series_with_bulk",
            "assembly",
            "drift_per_output_turn",
            "efficiency",
            "total_loss",
            "life_hours",
            "life_turns",
            "slip_ratio",
        )
        return SimpleNamespace(
            torque=np.array([0.0, torque_capacity]), **dict.fromkeys(names, np.array([1.0, np.nan]))
        )

    monkeypatch.setattr(answer, "torque_curves", curves)
    found = _curves(solved)
    assert found["torque_Nm"] == [0.0, 13.0]
    assert found["largest_slip_ratio"] == [1.0, None]


def test_the_windup_is_that_of_the_assembly_up_to_the_torque(monkeypatch, joint_text):
    asked = {}

    def windup(joint, **given):
        asked.update(given)
        return SimpleNamespace(hysteresis=1e-4, lost_motion=2e-4, dissipated_energy=3e-4)

    monkeypatch.setattr(answer, "windup", windup)
    monkeypatch.setattr(answer, "windup_columns", lambda curve: {"torque_Nm": np.array([0.0, 5.0])})
    case = parse_case(joint_text.replace('"5 N*m"', '"-5 N*m"'), source="x")
    solved = SimpleNamespace(joint=joint_from_case(case))
    assert _windup(solved) == {
        "unknown_because": None,
        "hysteresis_rad": 1e-4,
        "lost_motion_rad": 2e-4,
        "dissipated_energy_J": 3e-4,
        "torque_Nm": [0.0, 5.0],
    }
    assert (asked["largest_torque"], asked["level"]) == (5.0, "assembly")
    assert "stage_shares" not in asked  # those of every wind-up


@pytest.mark.long
def test_a_joint_with_another_drive(zou_file):
    text = zou_file.with_name("multiroller.toml").read_text(encoding="utf-8")
    found = joint_answer(JointRequest("m.toml", text, {"load.output_torque": "-8 N*m"}))
    json.dumps(found, allow_nan=False)
    assert found["document"]["standing"]["forces"]["output_torque_Nm"] == -8.0
    curves = found["curves"]
    assert curves["torque_Nm"][-1] == pytest.approx(
        -found["document"]["standing_torque_capacity"]["reverse"]["output_torque_Nm"]
    )
    # a torque that drives: the output runs ahead
    assert curves["drift_rad_per_output_turn"][10] < 0.0
    stiffness = found["document"]["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    here = np.interp(8.0, -np.array(curves["torque_Nm"][:-1]), curves["assembly_Nm_per_rad"][:-1])
    assert here == pytest.approx(stiffness, rel=1e-4)
    assert found["windup"]["hysteresis_rad"] > 0.0
    # losses and life pass through the joint; nothing is lost that does not enter
    between = [
        np.interp(8.0, -np.array(curves["torque_Nm"]), curves[name])
        for name in ("total_loss_W", "life_hours")
    ]
    own = [found["document"]["losses_W"]["total"], found["document"]["life_hours"]]
    assert between == pytest.approx(own, rel=1e-2)
    for name, curve in found["creep"].items():
        here = found["document"]["rolling"]["contacts"][name]
        expected = np.interp(abs(here["traction_coefficient"]), curve["traction"], curve["creepage"])
        assert abs(here["creepage"]) == pytest.approx(expected, rel=1e-2)
    # a safety must be above its limit, a ratio below it
    table = found["views"]["margins"][-1]
    margins = {
        RESULTS_BY_LABEL[row[0]]: (*row[3:5], share)
        for row, share in zip(table["rows"], table["shares"], strict=True)
        if row[0] in RESULTS_BY_LABEL
    }
    judged = {
        name: [each["value"] for each in found["document"]["diagnostics"] if each["name"] == name]
        for name in ("rim_yield_safety", "slip_ratio")
    }
    for name, required, share in (
        ("rim_yield_safety", "> 1", 1.0 / min(judged["rim_yield_safety"])),
        ("slip_ratio", "< 1", max(judged["slip_ratio"])),
        ("torque_safety", "> 1", 8.0 / -curves["torque_Nm"][-1]),
    ):
        assert (margins[name][0], margins[name][2]) == (required, pytest.approx(share, rel=1e-6)), name
    shares = {row[0]: share for row, share in zip(table["rows"], table["shares"], strict=True)}
    assert shares["torque over rolling capacity"] == pytest.approx(
        8.0 / found["document"]["rolling"]["torque_capacity_Nm"], rel=1e-6
    )
    # four rollers of 16 mm in the first row, on a circle of 26 mm
    gap = 2.0 * 26.0 * math.sin(math.pi / 4.0) - 2.0 * 16.0
    (clearance,) = (row for row in table["rows"] if RESULTS_BY_LABEL.get(row[0]) == "clearance")
    assert tuple(clearance[2:]) == ("first row to first row", "> 0 mm", f"{gap:.4g} mm", "pass")
    assert set(found["document"]["standing"]["contacts"]) == {
        each["contact"] for each in found["drawing"]["forces"]
    }


@pytest.mark.long
def test_under_a_torque_that_only_the_branches_of_the_file_carry(zou_file):
    text = zou_file.with_name("planetary.toml").read_text(encoding="utf-8")
    text += 3 * '\n[[branch]]\nplanet_deviation = "2 um"\n'
    found = joint_answer(JointRequest("p.toml", text, {"load.output_torque": "13 N*m"}))
    json.dumps(found, allow_nan=False)
    # equal branches with an interference of 34 um: a planet grows into the sun and into the ring
    alike = parse_case(text.partition("[[branch]]")[0].replace('"30 um"', '"34 um"'), source="p.toml")
    angle = windup(joint_from_case(alike), largest_torque=13.0, level="assembly").angle
    assert max(found["windup"]["loading_angle_rad"]) == pytest.approx(float(np.max(angle)), rel=1e-4)
    forces = {each["contact"]: np.hypot(*each["normal_N"]) for each in found["drawing"]["forces"]}
    assert set(forces) == {f"{name}_{sector}" for name in ("sp", "pr") for sector in (1, 2, 3)}
    for name in ("sp", "pr"):  # of planets that are all alike
        assert [forces[f"{name}_{sector}"] for sector in (2, 3)] == pytest.approx(
            2 * [forces[f"{name}_1"]], rel=1e-6
        )


@pytest.mark.long
def test_the_windup_is_that_of_the_branches_of_the_file(zou_file):
    """The same as that of `asperity windup`, in half as many steps; the joint's own loop is another."""
    text = zou_file.read_text(encoding="utf-8").replace('preload = "1000 N"', 'interference = "13 um"')
    unlike = "".join(f'\n[[branch]]\nplanet_deviation = "{size} um"\n' for size in (3, 0, -2))
    found, equal = (
        joint_answer(JointRequest("z.toml", each, {}))["windup"] for each in (text + unlike, text)
    )
    own = with_own_branches(parse_case(text + unlike, source="z.toml"))
    curve = windup(own, largest_torque=5.0, level="assembly")
    for name in ("hysteresis", "lost_motion"):
        assert found[f"{name}_rad"] == pytest.approx(float(getattr(curve, name)), rel=2e-3)
    assert found["hysteresis_rad"] > equal["hysteresis_rad"]  # the branch that is pressed least slips most


@pytest.fixture(scope="module")
def shapes(paper_joint):
    forces = SimpleNamespace(normal=NORMAL, tangential=TANGENTIAL, pins=np.ones(2))
    return drive_shapes(paper_joint(), SimpleNamespace(forces=forces))


def test_every_roller_in_its_place(shapes):
    rollers = shapes["rollers"]
    counts = {name: sum(each["body"] == name for each in rollers) for name in ("sun", "planet")}
    assert counts == {"sun": 1, "planet": 3}
    assert len(rollers) == 10
    orbit = {"sun": 0.0, "planet": 17.5e-3}
    for each in rollers:
        expected = orbit.get(each["body"], 35e-3)
        assert math.hypot(each["x_m"], each["y_m"]) == pytest.approx(expected, abs=1e-12)
    (ring,) = shapes["rings"]
    assert (ring["inner_radius_m"], ring["wall_m"]) == pytest.approx((40e-3, 10e-3))


def test_forces_act_where_the_bodies_touch(shapes):
    forces = {each["contact"]: each for each in shapes["forces"]}
    assert list(forces) == ["sp", "pwr", "pwl", "wro", "wlo"]
    assert (forces["sp"]["x_m"], forces["sp"]["y_m"]) == pytest.approx((0.0, 4e-3), abs=1e-12)
    for name in ("wro", "wlo"):  # on the ring
        assert math.hypot(forces[name]["x_m"], forces[name]["y_m"]) == pytest.approx(40e-3, rel=1e-9)
        assert forces[name]["on"].endswith("loading roller")
    # the planet presses the sun inwards; every normal and tangential force has its size
    np.testing.assert_allclose(forces["sp"]["normal_N"], [0.0, -1000.0], atol=1e-9)
    for name, normal, tangential in zip(forces, NORMAL, TANGENTIAL, strict=True):
        assert math.hypot(*forces[name]["normal_N"]) == pytest.approx(normal, rel=1e-12)
        assert math.hypot(*forces[name]["tangential_N"]) == pytest.approx(tangential, rel=1e-12)
        assert np.dot(forces[name]["normal_N"], forces[name]["tangential_N"]) == pytest.approx(0.0, abs=1e-6)
    # the ring presses the loading rollers inwards
    right = forces["wro"]
    assert np.dot(right["normal_N"], [right["x_m"], right["y_m"]]) < 0.0


def test_circles_and_forces_of_another_drive(zou_file):
    """A planetary: sun 10 mm, three planets of 20 mm, a ring of 50 mm with a wall of 8 mm."""
    joint = joint_from_case(read_case(zou_file.with_name("planetary.toml")))
    forces = SimpleNamespace(
        normal=np.array([1000.0, 1100.0]), tangential=np.array([50.0, 60.0]), pins=np.array([-110.0])
    )
    found = drive_shapes(joint, SimpleNamespace(forces=forces))
    ring = {"body": "ring", "inner_radius_m": pytest.approx(50e-3), "wall_m": 8e-3, "bore_change_m": 0.0}
    assert found["rings"] == [ring]
    rollers = [(each["body"], round(1e3 * each["radius_m"], 9)) for each in found["rollers"]]
    assert rollers == [("sun", 10.0)] + 3 * [("planet", 20.0)]
    for each in found["rollers"][1:]:
        assert math.hypot(each["x_m"], each["y_m"]) == pytest.approx(30e-3)
    sun, ring = found["forces"]
    assert (sun["on"], ring["on"]) == ("sun", "planet")
    planet = found["rollers"][1]
    outward = np.array([planet["x_m"], planet["y_m"]]) / 30e-3
    np.testing.assert_allclose([sun["x_m"], sun["y_m"]], 10e-3 * outward, atol=1e-12)
    np.testing.assert_allclose([ring["x_m"], ring["y_m"]], 50e-3 * outward, atol=1e-12)
    np.testing.assert_allclose(sun["normal_N"], -1000.0 * outward, atol=1e-9)
    np.testing.assert_allclose(ring["normal_N"], -1100.0 * outward, atol=1e-9)
    # the sun turns counter-clockwise: the planet holds it back; sun and ring push the planet the way the carrier goes
    clockwise = np.array([outward[1], -outward[0]])
    np.testing.assert_allclose(sun["tangential_N"], 50.0 * clockwise, atol=1e-9)
    np.testing.assert_allclose(ring["tangential_N"], -60.0 * clockwise, atol=1e-9)
    (free,) = found["bodies"]
    assert (free["body"], free["radii_m"]) == ("planet", [pytest.approx(20e-3)])
    kinds = [(each["name"], each["kind"]) for each in free["forces"]]
    assert kinds == [
        ("sp", "normal"),
        ("sp", "tangential"),
        ("pr", "normal"),
        ("pr", "tangential"),
        ("pin", "pin"),
    ]
    assert [each["radius_m"] for each in free["forces"][:4]] == pytest.approx([20e-3] * 4)
    # what the sun takes from the planet, the planet takes from the sun; the pin holds what the contacts push
    np.testing.assert_allclose(free["forces"][0]["force_N"], 1000.0 * outward, atol=1e-9)
    np.testing.assert_allclose(free["forces"][1]["force_N"], -50.0 * clockwise, atol=1e-9)
    np.testing.assert_allclose(free["forces"][4]["force_N"], 110.0 * clockwise, atol=1e-9)


def test_a_stepped_roller_has_a_radius_for_each_force(zou_file):
    joint = joint_from_case(read_case(zou_file.with_name("stepped_planet.toml")))
    one = np.ones(3)
    found = drive_shapes(joint, SimpleNamespace(forces=SimpleNamespace(normal=one, tangential=one, pins=one)))
    (free,) = found["bodies"]
    assert sorted(free["radii_m"]) == pytest.approx([18e-3, 20e-3])
    radii = {each["name"]: each["radius_m"] for each in free["forces"]}
    assert radii == pytest.approx({"sp": 20e-3, "pr1": 20e-3, "pr2": 18e-3, "pin": 0.0})


def test_a_hollow_roller_has_its_bore_in_both_pictures(zou_file):
    joint = joint_from_case(read_case(zou_file.with_name("planetary_hollow.toml")))
    one = np.ones(2)
    forces = SimpleNamespace(normal=one, tangential=one, pins=one[:1])
    found = drive_shapes(joint, SimpleNamespace(forces=forces))
    bore = 0.5 * next(float(shape.size) for shape in joint.shapes if shape.kind == "hollow")
    (free,) = found["bodies"]
    planets = [each["radius_m"] for each in found["rollers"] if each["body"] == "planet"]
    for radii in (free["radii_m"], planets):
        assert sorted(set(radii)) == pytest.approx([bore, 20e-3])


def test_form_errors_have_fields_and_their_limits_are_judged(joint_text):
    text = joint_text + '\n[[form]]\npart = "ring"\nharmonics = { 3 = "1 um" }\n'
    found = joint_answer(JointRequest("a.toml", text, {}))
    assert found["numbers"]["form.1.harmonics.3"]["value"] == pytest.approx(1.0, rel=1e-14)
    assert "slip ratio over a turn" in str(found)

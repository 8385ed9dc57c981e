import dataclasses
import json
import math

import numpy as np
import pytest
from asperity.joint.solved import SolvedPapersJoint

from asperity.joint.contact_notes import Note
from asperity.joint.document import diagnostic_documents, joint_document, plain_document
from asperity.joint.planar.solve import solve_planar
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values


@pytest.fixture(scope="module")
def text(request):
    return (request.config.rootpath / "examples" / "zou2025.toml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def solution(text):
    return solve_planar(planar_joint_from_case(parse_case(text, source="x")))


def document_of(text, solution, branches=None):
    case = parse_case(text, source="x")
    solved = SolvedPapersJoint(planar_joint_from_case(case), solution, branches)
    return joint_document(solved, inputs=si_values(case), assumptions=assumptions(case))


def dimensions(document):
    return {e["contact"]: e for e in document["diagnostics"] if e["name"] == "fractal_dimension"}


@pytest.mark.slow
def test_the_range_in_which_the_law_is_verified_is_a_diagnostic(text, solution):
    inside = document_of(text, solution)
    assert all(entry["ok"] for entry in dimensions(inside).values())
    low = text.replace("fractal_dimension = 1.4", "fractal_dimension = 1.01")
    entry = dimensions(document_of(low, solution))["sp"]
    assert (entry["value"], entry["limit"], entry["ok"]) == (1.01, 1.02, False)
    five = text[: text.index("[surface]")] + "".join(
        f'[surface.{c}]\nfractal_dimension = {d}\nfractal_roughness = "1e-8 mm"\nfrequency_ratio = 1.5\n'
        for c, d in zip(("sp", "pwr", "pwl", "wro", "wlo"), (1.4, 1.995, 1.5, 1.6, 1.7), strict=True)
    )
    told = dimensions(document_of(five, solution))
    assert [entry["ok"] for entry in told.values()] == [True, False, True, True, True]
    assert told["pwr"]["limit"] == 1.99


def test_what_json_cannot_say_is_null(text, solution):
    contacts = dataclasses.replace(solution.result.contacts, critical_area=np.full(5, np.inf))
    broken = dataclasses.replace(solution, result=dataclasses.replace(solution.result, contacts=contacts))
    document = document_of(text, broken)
    assert document["contacts"]["sp"]["critical_area_m2"] is None
    json.dumps(document, allow_nan=False)


def test_what_is_infinite_is_told_from_what_is_not_known():
    told = {"limit": 1.0, "ok": False, "severity": "function", "meaning": "it slips", "remedy": None}
    values = {"kept": 0.5, "unknown": math.nan, "endless": math.inf}
    notes = tuple(
        Note(name=name, label=name, contact=None, value=value, **told) for name, value in values.items()
    )
    found = plain_document({"diagnostics": diagnostic_documents((), notes)})["diagnostics"]
    assert [(each["value"], each["infinite"]) for each in found] == [
        (0.5, False),
        (None, False),
        (None, True),
    ]
    assert {(each["unit"], each["limit_shown"]) for each in found} == {("1", "1")}
    assert [each["shown"] for each in found] == ["0.5", "-", "infinite"]


def test_the_document_says_why_there_is_no_stiffness_and_what_a_ring_would_lose(text, load_example):
    plastic = text.replace("fractal_dimension = 1.4", "fractal_dimension = 1.2")
    thin = text.replace('ring_wall_thickness = "60 mm"', 'ring_wall_thickness = "10 mm"')
    thin = thin.replace("ring_support =", "# ring_support =")
    documents = [
        document_of(t, solve_planar(planar_joint_from_case(parse_case(t, source="x"))))
        for t in (plastic, thin)
    ]
    assert "every spot of sp, pwr, pwl, wro, wlo is plastic" in documents[0]["stiffness_unknown_because"]
    assert documents[0]["torsional_stiffness"]["published"]["output_Nm_per_rad"] is None
    assert documents[1]["stiffness_unknown_because"] is None
    (ring,) = (entry for entry in documents[1]["diagnostics"] if entry["name"] == "ring_bending_loss")
    # bodies alone in the machine of examples/ring_wall.py; the asperities add the same to both
    wall = load_example("ring_wall")
    free, held = (wall.stiffness_over_wall(np.array([10e-3]), support)[0] for support in (0.0, math.inf))
    joint = documents[1]["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    assert ring["value"] == pytest.approx(1.0 - 1.0 / (1.0 + joint / free - joint / held), abs=0.01)
    assert not ring["ok"]


def test_the_capacity_in_numbers_and_words(text, solution):
    """The capacity of each direction with its own limit."""
    forward = dataclasses.replace(
        solution.capacity, output_torque=np.asarray(13.0), limiting_contact=np.asarray(2)
    )
    reverse = dataclasses.replace(
        forward, output_torque=np.inf, limit=np.asarray(0), limiting_contact=np.asarray(5)
    )
    shown = dataclasses.replace(solution, capacity=forward, reverse_capacity=reverse)
    stated = document_of(text, shown)["torque_capacity"]
    assert stated == {
        "output_torque_Nm": 13.0,
        "limit": "gross_slip",
        "limiting_contact": "pwl",
        "meaning": "contact pwl slips",
        "is_lower_bound": False,
        "reverse": {
            "output_torque_Nm": None,
            "limit": "none",
            "limiting_contact": None,
            "meaning": "no limit is reached at any torque",
            "is_lower_bound": False,
        },
    }


def test_rolling_is_in_the_document(paper_joint):
    joint = paper_joint()
    found = joint_document(SolvedPapersJoint(joint, solve_planar(joint)), inputs={}, assumptions=())
    rolling = found["rolling"]
    assert found["drift_rad_per_output_turn"] == rolling["drift_rad_per_output_turn"] > 0.0103
    assert found["contacts"]["sp"]["creepage"] == rolling["contacts"]["sp"]["creepage"]
    assert found["contacts"]["sp"]["life_hours"] > found["life_hours"] > 0.0
    causes = ("creep", "skew", "bearings")
    assert found["losses_W"]["total"] == pytest.approx(sum(found["losses_W"][cause] for cause in causes))
    assert found["losses_W"]["oil"] is None
    assert rolling["unknown_because"] == []
    assert rolling["input_torque_Nm"] == pytest.approx(
        rolling["input_power_W"] / float(joint.input_speed), rel=1e-12
    )
    # without friction of the bearings, hysteresis and oil the losses are creep, which costs speed and no torque
    assert rolling["input_torque_Nm"] == pytest.approx(found["forces"]["input_torque_Nm"], rel=1e-9)


@pytest.mark.slow
def test_unequal_branches_are_judged_among_the_diagnostics(text, solution, unequal_branches):
    """The first of the warnings: one of the branches slips at 8 N·m, below the torque."""
    document = document_of(text, solution, unequal_branches(torque=10.0))
    json.dumps(document, allow_nan=False)
    crossed = [entry for entry in document["diagnostics"] if not entry["ok"]]
    assert (crossed[0]["name"], crossed[0]["severity"]) == ("branch_slip", "function")
    assert crossed[0]["value"] == pytest.approx(1.25)
    assert (
        type(document["branches"]["torque_capacity"]["first_branch"]) is int
    )  # a number of a planet, not 2.0
    assert "branches" not in document_of(text, solution)

"""What a document of a joint says, in numbers and in words."""

import dataclasses
import json
import math

import numpy as np
import pytest

from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import document_of, solve_case
from asperity.results.document import diagnostic_documents, plain_document
from asperity.results.notes import Note
from asperity.results.solved import solved_with_capacities


@pytest.fixture(scope="module")
def solution(solved_example):
    return solved_example.solution


@pytest.fixture(scope="module")
def document(case, solved_example):
    """Document of the example, with another solution or other branches."""

    def of(solution=None, branches=None, stated=case):
        joint = solved_example.joint
        return document_of(
            stated, solved_with_capacities(joint, solution or solved_example.solution, branches)
        )

    return of


def dimensions(document):
    return {e["contact"]: e for e in document["diagnostics"] if e["name"] == "fractal_dimension"}


@pytest.mark.long
def test_the_range_in_which_the_law_is_verified_is_a_diagnostic(joint_text, document):
    assert all(entry["ok"] for entry in dimensions(document()).values())
    text = joint_text
    five = text[: text.index("[surface]")] + "".join(
        f'[surface.{c}]\nfractal_dimension = {d}\nfractal_roughness = "1e-8 mm"\nfrequency_ratio = 1.5\n'
        for c, d in zip(("sp", "pwr", "pwl", "wro", "wlo"), (1.4, 1.995, 1.5, 1.6, 1.7), strict=True)
    )
    told = dimensions(solve_case(parse_case(five, source="x")).document)
    assert [entry["ok"] for entry in told.values()] == [True, False, True, True, True]
    assert told["pwr"]["limit"] == 1.99


def test_what_json_cannot_say_is_null(document, solution):
    contacts = dataclasses.replace(solution.result.contacts, critical_area=np.full(5, np.inf))
    broken = dataclasses.replace(solution, result=dataclasses.replace(solution.result, contacts=contacts))
    found = document(broken)
    assert found["standing"]["contacts"]["sp"]["critical_area_m2"] is None
    json.dumps(found, allow_nan=False)


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
    assert [each["shown"] for each in found] == ["0.5", "not known", "infinite"]
    assert [each["known"] for each in found] == [True, False, True]


def test_it_says_why_there_is_no_stiffness(joint_text):
    plastic = joint_text.replace("fractal_dimension = 1.4", "fractal_dimension = 1.2")
    found = solve_case(parse_case(plastic, source="x")).document
    assert "every spot of sp, pwr, pwl, wro, wlo is plastic" in found["stiffness_unknown_because"]
    assert found["torsional_stiffness"]["published"]["output_Nm_per_rad"] is None


def test_the_capacity_in_numbers_and_words(document, solution):
    """The capacity of each direction with its own limit."""
    forward = dataclasses.replace(
        solution.standing_capacity, output_torque=np.asarray(13.0), limiting_contact=np.asarray(2)
    )
    reverse = dataclasses.replace(
        forward, output_torque=np.asarray(np.inf), limit=np.asarray(0), limiting_contact=np.asarray(5)
    )
    shown = dataclasses.replace(solution, standing_capacity=forward, reverse_standing_capacity=reverse)
    stated = document(shown)["standing_torque_capacity"]
    for found, torque, limit, contact, meaning in (
        (stated, 13.0, "gross_slip", "pwl", "contact pwl slips"),
        (stated["reverse"], None, "none", None, "no limit is reached at any torque"),
    ):
        assert (found["output_torque_Nm"], found["limit"], found["limiting_contact"]) == (
            torque,
            limit,
            contact,
        )
        assert (found["meaning"], found["is_lower_bound"]) == (meaning, False)


def test_rolling_is_in_the_document(document):
    found = document()
    rolling = found["rolling"]
    assert found["drift_rad_per_output_turn"] == rolling["drift_rad_per_output_turn"] > 0.0103
    assert found["life_hours"] is rolling["contacts"]["sp"]["life_hours"] is None
    assert rolling["contacts"]["wro"]["life_hours"] > 0.0
    assert rolling["no_life_because"].startswith("no rating life: at sp, pwr the Hertz pressure exceeds")
    causes = ("creep", "skew", "bearings")
    assert found["losses_W"]["total"] == pytest.approx(sum(found["losses_W"][cause] for cause in causes))
    assert found["losses_W"]["oil"] is None
    assert rolling["unknown_because"] == []
    assert rolling["input_torque_Nm"] == pytest.approx(
        rolling["input_power_W"] / (6000.0 * math.pi / 30.0), rel=1e-12
    )
    # without friction of the bearings, hysteresis and oil the losses are creep, which costs speed and no torque
    assert rolling["input_torque_Nm"] == pytest.approx(
        found["standing"]["forces"]["input_torque_Nm"], rel=1e-9
    )

import dataclasses
import json

import numpy as np
import pytest

from asperity.joint.document import joint_document
from asperity.joint.examination import examine
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.values import si_values


@pytest.fixture(scope="module")
def text(request):
    return (request.config.rootpath / "examples" / "zou2025.toml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def examination(text):
    return examine(joint_from_case(parse_case(text, source="x")))


def document_of(text, examination):
    case = parse_case(text, source="x")
    return joint_document(
        joint=joint_from_case(case),
        examination=examination,
        inputs=si_values(case),
        assumptions=assumptions(case),
    )


def dimensions(document):
    return {e["contact"]: e for e in document["diagnostics"] if e["name"] == "fractal_dimension"}


def test_the_range_in_which_the_law_is_verified_is_a_diagnostic(text, examination):
    inside = document_of(text, examination)
    assert dimensions(inside)[None]["ok"]
    low = text.replace("fractal_dimension = 1.4", "fractal_dimension = 1.01")
    entry = dimensions(document_of(low, examination))[None]
    assert (entry["value"], entry["limit"], entry["ok"]) == (1.01, 1.02, False)
    five = text[: text.index("[surface]")] + "".join(
        f'[surface.{c}]\nfractal_dimension = {d}\nfractal_roughness = "1e-8 mm"\nfrequency_ratio = 1.5\n'
        for c, d in zip(("sp", "pwr", "pwl", "wro", "wlo"), (1.4, 1.995, 1.5, 1.6, 1.7), strict=True)
    )
    told = dimensions(document_of(five, examination))
    assert [entry["ok"] for entry in told.values()] == [True, False, True, True, True]
    assert told["pwr"]["limit"] == 1.99


def test_what_json_cannot_say_is_null(text, examination):
    contacts = dataclasses.replace(examination.result.contacts, critical_area=np.full(5, np.inf))
    broken = dataclasses.replace(
        examination, result=dataclasses.replace(examination.result, contacts=contacts)
    )
    document = document_of(text, broken)
    assert document["contacts"]["sp"]["critical_area_m2"] is None
    json.dumps(document, allow_nan=False)


def test_what_the_file_leaves_out_is_told(text):
    assert len(assumptions(parse_case(text, source="x"))) == 5
    partly = parse_case(text + '[compliance]\npin_stiffness = "100 N/um"\n', source="x")
    assert any("input_shaft_stiffness" in sentence for sentence in assumptions(partly))


def test_the_capacity_in_numbers_and_words(text, examination):
    """The capacity of each direction with its own limit."""
    forward = dataclasses.replace(
        examination.capacity, output_torque=np.asarray(13.0), limiting_contact=np.asarray(2)
    )
    reverse = dataclasses.replace(
        forward, output_torque=np.inf, limit=np.asarray(0), limiting_contact=np.asarray(-1)
    )
    shown = dataclasses.replace(examination, capacity=forward, reverse_capacity=reverse)
    stated = document_of(text, shown)["torque_capacity"]
    assert stated == {
        "output_torque_Nm": 13.0,
        "limit": "gross_slip",
        "limiting_contact": "pwl",
        "meaning": "contact pwl slips",
        "reverse": {
            "output_torque_Nm": None,
            "limit": "none",
            "limiting_contact": None,
            "meaning": "no limit is reached at any torque",
        },
    }

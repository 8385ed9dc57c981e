"""The description of the JSON interface is whole: every reference leads somewhere, every schema is one."""

import jsonschema
import pytest

from asperity.errors import InputError
from asperity.page import requests
from asperity.page.openapi import openapi


@pytest.fixture(scope="module")
def described():
    return openapi()


def references(node):
    if isinstance(node, dict):
        if "$ref" in node:
            yield node["$ref"]
        for value in node.values():
            yield from references(value)
    elif isinstance(node, list):
        for value in node:
            yield from references(value)


def test_every_reference_leads_to_a_schema_and_every_answer_is_used(described):
    known = {f"#/components/schemas/{name}" for name in described["components"]["schemas"]}
    assert set(references(described)) == known


def test_every_schema_is_one(described):
    for schema in described["components"]["schemas"].values():
        jsonschema.Draft202012Validator.check_schema(schema)


def test_a_request_has_a_file_or_its_tables(described):
    schema = whole(described, "Request")
    jsonschema.validate({"toml": "", "changes": {"load.preload": "900 N"}}, schema)
    for wrong in ({}, {"toml": "", "joint": {}}, {"toml": "", "chart": {}}, {"toml": 3}):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(wrong, schema)


def test_every_address_of_the_application_is_described(described, joint_text):
    pytest.importorskip("starlette")
    from asperity.page.application import application
    from asperity.page.computation import Computations
    from asperity.page.joint_request import JointRequest

    start, soon = JointRequest(name="x.toml", text=joint_text), Computations(longest=1.0)
    guarded = application(start, hosts=["x"], computations=soon, charts=soon)
    served = {
        (route.path.replace("{identity:str}", "{id}"), method.lower())
        for route in guarded._app.routes
        if route.path.startswith("/api")
        for method in route.methods - {"HEAD"}
    }
    assert served == {(path, method) for path, methods in described["paths"].items() for method in methods}


def whole(described, name):
    """The schema of a component, with those to which it refers."""
    return {"$ref": f"#/components/schemas/{name}", "components": described["components"]}


def test_states_of_a_job(described):
    schema = whole(described, "JobWithResult")
    job = {"id": "a", "kind": "design", "name": "a.toml", "state": "running", "done": 3, "total": 10}
    job |= {"seconds": 2.5, "message": "", "result": None}
    jsonschema.validate(job, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(job | {"state": "lost"}, schema)


@pytest.mark.parametrize(
    ("name", "entries", "kept"),
    [
        ("ChartRequest", {"chart": {"over": "a.b", "from": "1 N", "to": "2 N", "result": "mass"}}, True),
        ("ChartRequest", {"chart": {"over": "a.b", "from": "1 N", "result": "mass"}}, False),
        ("ChartRequest", {}, False),
        ("JobRequest", {"job": {"kind": "uncertainty", "samples": 100}}, True),
        ("JobRequest", {"job": {"kind": "uncertainty", "samples": 99}}, False),
        ("JobRequest", {"job": {"kind": "sensitivity", "samples": 100}}, False),
    ],
)
def test_the_schema_says_what_the_model_takes(described, name, entries, kept):
    body, model = {"toml": "x", **entries}, getattr(requests, name)
    problems = list(jsonschema.Draft202012Validator(whole(described, name)).iter_errors(body))
    assert (not problems) is kept
    if kept:
        assert requests.checked(model, body).toml == "x"
    else:
        with pytest.raises(InputError):
            requests.checked(model, body)


def test_limits_are_told(described):
    """Surfaces of 64 MiB measured within two minutes; other bodies of a megabyte."""
    opened = described["paths"]["/api/open"]["post"]
    assert "within 120 s" in opened["summary"]
    body = opened["requestBody"]["content"]["application/octet-stream"]["schema"]
    assert body["maxLength"] == 67_108_864
    refused = described["paths"]["/api/joint"]["post"]["responses"]["413"]["description"]
    assert refused == "The body is larger than 1000000 bytes."

"""The description of the JSON interface is whole: every reference leads somewhere, every schema is one."""

import jsonschema
import pytest

from asperity.page.openapi import _job_schema, openapi


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
    schema = described["components"]["schemas"]["Request"]
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


def test_states_of_a_job():
    schema = _job_schema()
    jsonschema.validate({"id": "a", "state": "running", "done": 3, "total": 10, "result": None}, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"state": "lost"}, schema)


def test_limits_are_told(described):
    """Surfaces of 64 MiB measured within two minutes; other bodies of a megabyte."""
    opened = described["paths"]["/api/open"]["post"]
    assert "within 120 s" in opened["summary"]
    body = opened["requestBody"]["content"]["application/octet-stream"]["schema"]
    assert body["maxLength"] == 67_108_864
    refused = described["paths"]["/api/joint"]["post"]["responses"]["413"]["description"]
    assert refused == "The body is larger than 1000000 bytes."

"""The JSON interface of the page in OpenAPI 3.1, from the models of its bodies and answers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pydantic import BaseModel
from pydantic.json_schema import GenerateJsonSchema, models_json_schema

import asperity
from asperity.page import answers, requests
from asperity.page.computation import MOST_KEPT
from asperity.page.guard import LARGEST_BODY
from asperity.page.upload import LARGEST_SURFACE, LONGEST_MEASUREMENT
from asperity.types import Document

Schema = Document
Model = type[BaseModel]

_TEXT: Schema = {"type": "string"}
_JSON, _FILE = "application/json", "application/octet-stream"
_WITHIN = f"within {LONGEST_MEASUREMENT:g} s"

#: What is wrong where a request cannot be fulfilled, by the status of the answer.
_PROBLEMS = {
    403: "The request comes from another web site.",
    408: "The body did not arrive in time.",
    413: f"The body is larger than {LARGEST_BODY} bytes.",
    415: "The body has another type.",
    422: "The joint is described wrongly, cannot exist or has no solution.",
    503: "Too many computations are waiting.",
}


class _Schemas(GenerateJsonSchema):
    """Schemas of models whose fields have no titles beside their names."""

    def field_title_should_be_set(self, schema: Any) -> bool:
        """Never."""
        return False


def openapi() -> Schema:
    """Addresses, bodies and answers of the JSON interface."""
    models: dict[Model, None] = {}
    paths = _with_references({**_joint_paths(), **_work_paths()}, models)
    _, schemas = models_json_schema(
        [(model, "validation") for model in models],
        ref_template="#/components/schemas/{model}",
        schema_generator=_Schemas,
    )
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "asperity serve",
            "version": asperity.__version__,
            "description": "A traction-drive joint in, its results out. Numbers are in SI units, with the unit at the "
            "end of each name; null stands for a number that does not exist. Requests of other web sites are refused.",
        },
        "paths": paths,
        "components": {"schemas": schemas["$defs"]},
    }


def _with_references(node: Any, models: dict[Model, None]) -> Any:
    """A tree with a reference in place of each model, which is added to ``models``."""
    if isinstance(node, dict):
        return {name: _with_references(value, models) for name, value in node.items()}
    if isinstance(node, list):
        return [_with_references(value, models) for value in node]
    if isinstance(node, type):
        models[node] = None
        return {"$ref": f"#/components/schemas/{node.__name__}"}
    return node


def _content(kind: str, schema: Schema | Model) -> Schema:
    return {"content": {kind: {"schema": schema}}}


def _answer(schema: Schema | Model, description: str) -> Schema:
    return {"description": description, **_content(_JSON, schema)}


def _problems(*statuses: int, **said: str) -> Schema:
    """Answers to requests that cannot be fulfilled; some in other words, ``_404`` for 404."""
    words = {str(status): _PROBLEMS[status] for status in statuses}
    words |= {status.removeprefix("_"): text for status, text in said.items()}
    return {status: _answer(answers.Error, text) for status, text in words.items()}


def _in_path(name: str, schema: Schema = _TEXT) -> Schema:
    return {"name": name, "in": "path", "required": True, "schema": schema}


def _in_query(name: str, schema: Schema, description: str) -> Schema:
    return {"name": name, "in": "query", "schema": schema, "description": description}


def _get(summary: str, responses: Schema | None = None, parameters: Sequence[Schema] = ()) -> Schema:
    answer = {"summary": summary, "responses": responses or {"200": _answer({"type": "object"}, summary)}}
    return {"get": {**answer, "parameters": list(parameters)} if parameters else answer}


def _post(
    summary: str,
    body: Schema | Model,
    answer: Schema | Model,
    *,
    kind: str = _JSON,
    status: int = 200,
    parameters: Sequence[Schema] = (),
) -> Schema:
    said = (
        (answer.__doc__ or summary) if isinstance(answer, type) else str(answer.get("description", summary))
    )
    post = {
        "summary": summary,
        "requestBody": {"required": True, **_content(kind, body)},
        "responses": {str(status): _answer(answer, said), **_problems(*_PROBLEMS)},
    }
    return {"post": {**post, "parameters": list(parameters)} if parameters else post}


def _joint_paths() -> Schema:
    """Addresses that answer about a joint."""
    kinds: Schema = {"content": {kind: {} for kind in answers.DOWNLOADS.values()}}
    return {
        "/api/description": _get("Parameters of a joint file: meaning, unit, range, default."),
        "/api/schema": _get("JSON schema of a joint file."),
        "/api/results": _post(
            "Results that charts of a joint can show: name, label, unit, group.",
            requests.Request,
            {"type": "array", "items": answers.ResultOfChart, "description": "One entry for each number."},
        ),
        "/api/joint": _post(
            "Solve one joint: the document of 'asperity joint --json', with drawing, wind-up and curves.",
            requests.Request,
            answers.Answer,
        ),
        "/api/figures": _post(
            "The key figures of one joint that need no torque capacity: an answer in a tenth of the time.",
            requests.Request,
            answers.Figures,
        ),
        "/api/chart": _post(
            "One number of the joint file against one result, by the evaluator of 'asperity sweep'.",
            requests.ChartRequest,
            answers.Chart,
        ),
        "/api/compare": _post(
            "Two joints side by side, as 'asperity compare' prints it, with its JSON document.",
            requests.CompareRequest,
            answers.Comparison,
        ),
        "/api/joint/{id}/joint.{kind}": _get(
            f"Joint file, JSON document or report of one of the latest {MOST_KEPT} joints.",
            {
                "200": {"description": "The file.", **kinds},
                **_problems(_404="This joint is no longer kept.", _422="A PDF needs the extra 'report'."),
            },
            [_in_path("id"), _in_path("kind", {"enum": list(answers.DOWNLOADS)})],
        ),
        "/api/file": _post(
            "Check a joint file and list what it states.",
            _TEXT,
            answers.File,
            kind="application/toml",
            parameters=[_in_query("name", _TEXT, "For messages.")],
        ),
    }


def _measuring(summary: str, answer: Model) -> Schema:
    """An address that takes a file of an instrument."""
    file = {"type": "string", "format": "binary", "maxLength": LARGEST_SURFACE}
    parameters = [_in_query("name", _TEXT, "For messages.")]
    for name, field in requests.MeasurementQuery.model_json_schema()["properties"].items():
        stated = next(iter(field.get("anyOf", [field])))  # without the null of what is not stated
        schema = {key: stated[key] for key in ("type", "enum", "maxLength") if key in stated}
        parameters.append(_in_query(name, schema, field["description"]))
    return _post(summary, file, answer, kind=_FILE, parameters=parameters)


def _work_paths() -> Schema:
    """Addresses for files and jobs."""

    def of_job(summary: str, description: str, content: Schema) -> Schema:
        found = {"200": {"description": description, **content}}
        return _get(summary, found | _problems(_410="This job is no longer kept."), [_in_path("id")])

    return {
        "/api/open": _measuring(
            f"Open a file, recognised by its content; a surface is measured {_WITHIN}.", answers.Opened
        ),
        "/api/measure": _measuring(
            f"Spectrum, D and G of a measured surface, or of a measurement document, {_WITHIN}.",
            answers.Measurement,
        ),
        "/api/jobs": _post("Begin a long job.", requests.JobRequest, answers.Job, status=202),
        "/api/jobs/{id}": of_job(
            "State of a job, and its result.", "The job.", _content(_JSON, answers.JobWithResult)
        ),
        "/api/jobs/{id}/events": of_job(
            "Each change of a job until its end, as server-sent events.",
            "Events.",
            {"content": {"text/event-stream": {}}},
        ),
        "/api/jobs/{id}/stop": _post(
            "End a job at once.", {"type": "object"}, answers.Job, parameters=[_in_path("id")]
        ),
        "/api/jobs/{id}/result.json": of_job(
            "The result of a job as a file.", "JSON.", {"content": {_JSON: {}}}
        ),
    }

"""The JSON interface of the page in OpenAPI 3.1."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import asperity
from asperity.page.chart import MOST_CURVES, MOST_POINTS
from asperity.page.computation import MOST_KEPT
from asperity.page.guard import LARGEST_BODY
from asperity.page.jobs import FEWEST_SAMPLES, KINDS, MOST_SAMPLES
from asperity.page.joint_request import MOST_CHANGES
from asperity.page.list_changes import ONE_PER_BRANCH
from asperity.page.upload import LARGEST_SURFACE, LONGEST_MEASUREMENT
from asperity.results import SEVERITIES
from asperity.surface.height_spectrum import LAYS

Schema = dict[str, Any]

_TEXT: Schema = {"type": "string"}
_TEXT_OR_NULL: Schema = {"type": ["string", "null"]}
_INTEGER: Schema = {"type": "integer"}
_FLAG: Schema = {"type": "boolean"}
_NUMBER: Schema = {"type": ["number", "null"]}
_OBJECT: Schema = {"type": "object"}


def _said(schema: Schema, description: str) -> Schema:
    return {**schema, "description": description}


def _list(items: Schema, **limits: Any) -> Schema:
    return {"type": "array", "items": items, **limits}


def _fields(properties: Schema, **more: Any) -> Schema:
    return {**_OBJECT, "properties": properties, **more}


def _by_name(values: Schema, **more: Any) -> Schema:
    return {**_OBJECT, "additionalProperties": values, **more}


def _ref(name: str) -> Schema:
    return {"$ref": f"#/components/schemas/{name}"}


def _content(kind: str, schema: Schema) -> Schema:
    return {"content": {kind: {"schema": schema}}}


def _json(schema: Schema, description: str) -> Schema:
    return _said(_content("application/json", schema), description)


def _parameter(name: str, description: str) -> Schema:
    return {"name": name, "in": "query", "schema": _TEXT, "description": description}


def _in_path(name: str, schema: Schema = _TEXT) -> Schema:
    return {"name": name, "in": "path", "required": True, "schema": schema}


def _get(summary: str, responses: Schema | None = None, parameters: Sequence[Schema] = ()) -> Schema:
    answer = {"summary": summary, "responses": responses or {"200": _json(_OBJECT, summary)}}
    return {"get": {**answer, "parameters": list(parameters)} if parameters else answer}


def _post(
    summary: str,
    body: Schema,
    response: Schema,
    *,
    kind: str = "application/json",
    status: str = "200",
    parameters: Sequence[Schema] = (),
) -> Schema:
    answer = {
        "summary": summary,
        "requestBody": {"required": True, **_content(kind, body)},
        "responses": {status: response, **_PROBLEMS},
    }
    return {"post": {**answer, "parameters": list(parameters)} if parameters else answer}


_PROBLEMS = {
    "403": _json(_ref("Error"), "The request comes from another web site."),
    "408": _json(_ref("Error"), "The body did not arrive in time."),
    "413": _json(_ref("Error"), f"The body is larger than {LARGEST_BODY} bytes."),
    "415": _json(_ref("Error"), "The body has another type."),
    "422": _json(_ref("Error"), "The joint is described wrongly, cannot exist or has no solution."),
    "503": _json(_ref("Error"), "Too many computations are waiting."),
}
_NUMBERS = _list(_NUMBER)
_VALUE: Schema = {
    "value": _said({"type": "number"}, "In the unit of the key's range."),
    "si": {"type": "number"},
    "tolerance": _said({"type": "number"}, "In SI; 0 where the file states none."),
}
_SECTIONS = {
    "meaning": _TEXT,
    "keys": _list(_TEXT, description="Of each section, in their order."),
    "one_for_each": _said(
        _TEXT_OR_NULL, "Dotted path of the number of sections that the list has to have; null for any number."
    ),
    "most": _said(_INTEGER, "Largest number of sections."),
    "of_file": _list(_by_name(_TEXT), description="What each section of the file says, without the changes."),
}
_STATED = {
    "numbers": _by_name(_fields(_VALUE), description="By dotted path."),
    "entered": _by_name(
        _fields({**_VALUE, "text": _said(_TEXT, "As the file has it.")}),
        description="By dotted path: numbers that no study varies, an Rz and the shares of a duty.",
    ),
    "lists": _by_name(_fields(_SECTIONS), description="By name: the sections [[duty]] and [[branch]]."),
    "choices": _by_name(_TEXT),
}


def openapi() -> Schema:
    """Addresses, bodies and answers of the JSON interface."""
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "asperity serve",
            "version": asperity.__version__,
            "description": "A traction-drive joint in, its results out. Numbers are in SI units, with the unit at the "
            "end of each name; null stands for a number that does not exist. Requests of other web sites are refused.",
        },
        "paths": {**_joint_paths(), **_work_paths()},
        "components": {
            "schemas": {
                "Error": _error_schema(),
                "Request": _request_schema(),
                "Answer": _answer_schema(),
                "Chart": _chart_answer_schema(),
                "Job": _job_schema(),
            }
        },
    }


def _joint_paths() -> Schema:
    """Addresses that answer about a joint."""
    parts = _list({"type": ["string", "object"]})
    kinds = {"enum": ["toml", "json", "html", "pdf"]}
    files = ("application/toml", "application/json", "text/html", "application/pdf")
    return {
        "/api/description": _get("Parameters of a joint file: meaning, unit, range, default."),
        "/api/schema": _get("JSON schema of a joint file."),
        "/api/results": _post(
            "Results that charts of a joint can show: name, label, unit, group.",
            _ref("Request"),
            _json({"type": "array"}, "One entry for each number."),
        ),
        "/api/joint": _post(
            "Solve one joint: the document of 'asperity joint --json', with drawing, wind-up and curves.",
            _ref("Request"),
            _json(_ref("Answer"), "The joint."),
        ),
        "/api/chart": _post(
            "One number of the joint file against one result, by the evaluator of 'asperity sweep'.",
            _request_schema(chart=_chart_schema()),
            _json(_ref("Chart"), "Curves; SI units, and those of displays."),
        ),
        "/api/compare": _post(
            "Two joints side by side, as 'asperity compare' prints it, with its JSON document.",
            _fields(dict.fromkeys(("one", "other"), _ref("Request")), required=["one", "other"]),
            _json(
                _fields(
                    {
                        "parts": parts,
                        "all_parts": _said(parts, "With every result that differs."),
                        "document": _OBJECT,
                    }
                ),
                "Texts, and tables with title, head and rows.",
            ),
        ),
        "/api/joint/{id}/joint.{kind}": _get(
            f"Joint file, JSON document or report of one of the latest {MOST_KEPT} joints.",
            {
                "200": {"description": "The file.", "content": {kind: {} for kind in files}},
                "404": _json(_ref("Error"), "This joint is no longer kept."),
                "422": _json(_ref("Error"), "A PDF needs the extra 'report'."),
            },
            [_in_path("id"), _in_path("kind", kinds)],
        ),
        "/api/file": _post(
            "Check a joint file and list what it states.",
            _TEXT,
            _json(_fields({"name": _TEXT, "toml": _TEXT, **_STATED}), "Its text and its values."),
            kind="application/toml",
            parameters=[_parameter("name", "For messages.")],
        ),
    }


def _work_paths() -> Schema:
    """Addresses for files and jobs."""

    def upload(summary: str, fields: Schema) -> Schema:
        file = {"type": "string", "format": "binary", "maxLength": LARGEST_SURFACE}
        units = ("position_unit", "height_unit", "spacing", "decimal", "column", "no_data")
        parameters = [_parameter(name, "Where the file does not say it.") for name in units]
        parameters += [
            _parameter(
                "lay", f"Grooves of a profile, which it crosses: {', '.join(LAYS)}; a joint needs it."
            ),
            _parameter("direction", "In which the contact rolls over a map: x or y; x if absent."),
            _parameter("missing", "What happens with missing points: refuse, longest or interpolate."),
            _parameter(
                "measurement_of",
                "Of what it is: body, as both bodies of a contact then are, or pair, of both together.",
            ),
        ]
        return _post(
            summary,
            file,
            _json(_fields(fields), summary),
            kind="application/octet-stream",
            parameters=[_parameter("name", "For messages."), *parameters],
        )

    def of_job(summary: str, description: str, content: Schema) -> Schema:
        gone = {"description": "This job is no longer kept."}
        return _get(summary, {"200": {"description": description, **content}, "410": gone}, [_in_path("id")])

    within = f"within {LONGEST_MEASUREMENT:g} s"
    begin, end = "Begin a long job.", "End a job at once."
    return {
        "/api/open": upload(
            f"Open a file, recognised by its content; a surface is measured {within}.",
            {"kind": {"enum": ["joint", "design", "measurement"]}},
        ),
        "/api/measure": upload(
            f"Spectrum, D and G of a measured surface, or of a measurement document, {within}.",
            {
                "document": _OBJECT,
                "surface": _said(
                    {"type": ["object", "null"]},
                    "For 'surfaces' of a request; null without spectrum and power law.",
                ),
            },
        ),
        "/api/jobs": _post(
            begin, _request_schema(job=_asked_job_schema()), _json(_ref("Job"), begin), status="202"
        ),
        "/api/jobs/{id}": of_job(
            "State of a job, and its result.", "The job.", _content("application/json", _ref("Job"))
        ),
        "/api/jobs/{id}/events": of_job(
            "Each change of a job until its end, as server-sent events.",
            "Events.",
            {"content": {"text/event-stream": {}}},
        ),
        "/api/jobs/{id}/stop": _post(end, _OBJECT, _json(_ref("Job"), end), parameters=[_in_path("id")]),
        "/api/jobs/{id}/result.json": of_job(
            "The result of a job as a file.", "JSON.", {"content": {"application/json": {}}}
        ),
    }


def _asked_job_schema() -> Schema:
    return _fields(
        {
            "kind": {"enum": list(KINDS)},
            "samples": {**_INTEGER, "minimum": FEWEST_SAMPLES, "maximum": MOST_SAMPLES},
            "seed": _INTEGER,
            "distribution": {**_TEXT, "examples": ["uniform", "normal 2 sigma"]},
            "design": _said(_TEXT, "Text of a design file; its joint is that of the request."),
            "file": _said(_TEXT, "Name of the design file, for messages."),
        },
        required=["kind"],
    )


def _job_schema() -> Schema:
    return _fields(
        {
            "id": _TEXT,
            "kind": {"enum": list(KINDS)},
            "name": _said(_TEXT, "Name of the joint."),
            "state": {"enum": ["waiting", "running", "done", "failed", "stopped"]},
            "done": _INTEGER,
            "total": _said(_INTEGER, "0 as long as it is not known."),
            "seconds": _said({"type": "number"}, "Since it began to run."),
            "message": _said(_TEXT, "Why it failed."),
            "result": _said({"type": ["object", "null"]}, "As the command of the same name prints it."),
        }
    )


def _chart_schema() -> Schema:
    return _fields(
        {
            "over": _said(_TEXT, "Dotted path of a number that the joint file states."),
            "from": _said(_TEXT, "With its unit."),
            "to": _TEXT,
            "points": {**_INTEGER, "minimum": 2, "maximum": MOST_POINTS},
            "scale": {"enum": ["linear", "log"]},
            "result": _said(_TEXT, "A name of /api/results."),
            "family": _fields(
                {"over": _TEXT, "values": _list(_TEXT, maxItems=MOST_CURVES)},
                description="Another number, a curve for each of its values.",
            ),
        },
        required=["over", "from", "to", "result"],
        additionalProperties=False,
        examples=[
            {"over": "load.preload", "from": "200 N", "to": "2 kN", "result": "assembly_stiffness_output"}
        ],
    )


def _chart_answer_schema() -> Schema:
    status = _said(_INTEGER, "0 is solved; 'reasons' says what the others mean.")
    curve = {
        "value": _NUMBER,
        "value_shown": _TEXT,
        **dict.fromkeys(("y", "y_shown"), _NUMBERS),
        "status": _list(status),
    }
    point = {**dict.fromkeys(("x", "x_shown", "y", "y_shown"), _NUMBER), "status": status}
    return _fields(
        {
            **dict.fromkeys(("over", "unit", "result", "result_label", "result_unit"), _TEXT),
            "family": _TEXT_OR_NULL,
            **dict.fromkeys(("x", "x_shown"), _NUMBERS),
            "curves": _list(_fields(curve)),
            "joint": {"type": ["object", "null"], "properties": point},
            "reasons": _by_name(_TEXT),
        }
    )


def _error_schema() -> Schema:
    return _fields(
        {
            "error": _said(_TEXT, "The message of the command line."),
            "kind": {"enum": ["input", "no_solution", "busy", "refused", "failed"]},
            "keys": _by_name(
                _TEXT, description="Dotted path of a key of the joint file → what is wrong with it."
            ),
        },
        required=["error", "kind", "keys"],
    )


def _request_schema(**asked: Schema) -> Schema:
    """Body of a request about a joint, with what else is asked for."""
    changes = {
        "additionalProperties": {"type": ["string", "number"]},
        "maxProperties": MOST_CHANGES,
        "description": "Dotted path → value with its unit, or one of the words of a choice; empty to leave a "
        "key out. Name of a list → its sections as their places in the file, '1 3 0' with 0 for a new one, "
        f"empty for none; for 'branch' also '{ONE_PER_BRANCH}', one for each branch of the drive: changes of sections "
        "beyond them wait. Sections are counted from 1 in the new arrangement.",
        "examples": [
            {"load.output_torque": "6000 N*mm", "model.closure": "constant_pin_force"},
            {"branch": ONE_PER_BRANCH, "branch.2.planet_deviation": "2 um", "duty": "2"},
        ],
    }
    return _fields(
        {
            "toml": _said(_TEXT, "The text of a joint file."),
            "joint": _said(_OBJECT, "The tables of a joint file; /api/schema is their schema."),
            "changes": {**_OBJECT, **changes},
            "surfaces": _list(
                _OBJECT,
                maxItems=2,
                description="Documents of 'asperity surface measure --json' in place of the surfaces of the file: "
                "one, that of both bodies alike or, by its measurement_of, of the pair; or one of each.",
            ),
            "name": _said(_TEXT, "What messages and downloads call the joint."),
            **asked,
        },
        additionalProperties=False,
        oneOf=[{"required": ["toml"]}, {"required": ["joint"]}],
        **({"required": list(asked)} if asked else {}),
    )


def _margin_schema() -> Schema:
    return _fields(
        {
            **dict.fromkeys(("name", "label", "place", "unit"), _TEXT),
            **dict.fromkeys(("actual", "lowest", "highest"), _NUMBER),
            "infinite": _said(_FLAG, "Whether the actual value is infinite; if so, it is null."),
            "inclusive": _said(_FLAG, "Whether the bounds 'lowest' and 'highest' themselves are allowed."),
            "used": _said(_NUMBER, "Share of the limit that is used."),
            "ok": _FLAG,
            "known": _said(_FLAG, "Whether it is known that the requirement is met or not."),
            "severity": {"enum": list(SEVERITIES)},
            "state": _said(_TEXT, "State of the joint where that is no failure."),
        }
    )


def _answer_schema() -> Schema:
    curves = (
        *("torque_Nm", "drift_rad_per_output_turn", "efficiency", "total_loss_W", "life_hours"),
        *(f"{name}_Nm_per_rad" for name in ("published", "series_with_bulk", "assembly")),
        *("life_output_turns", "largest_slip_ratio"),
    )
    angles = (f"{name}_angle_rad" for name in ("loading", "unloading", "reloading"))
    windup = ("torque_Nm", "incremental_stiffness_Nm_per_rad", *angles)
    sizes = ("hysteresis_rad", "lost_motion_rad", "dissipated_energy_J")
    return _fields(
        {
            "id": _said(_TEXT, "For downloads."),
            "name": _TEXT,
            **_STATED,
            "form": _said(
                {"type": ["object", "null"]},
                "Groups of numbers and choices of another drive than the paper's; null for the paper's.",
            ),
            "document": _said(_OBJECT, "As 'asperity joint FILE --json' prints it."),
            "drawing": _said(_OBJECT, "Circles and contact forces of the drive."),
            "margins": _list(
                _margin_schema(), description="What is required and reached, in the unit of each entry."
            ),
            "creep": _by_name(
                _fields(dict.fromkeys(("traction", "creepage"), _NUMBERS)),
                description="Contact → its creep curve: traction T/N over creepage, up to gross slip.",
            ),
            "curves": _fields(dict.fromkeys(curves, _NUMBERS)),
            "windup": _fields(
                {
                    "unknown_because": _TEXT_OR_NULL,
                    **{key: {"type": "number"} for key in sizes},
                    **dict.fromkeys(windup, _NUMBERS),
                }
            ),
        }
    )

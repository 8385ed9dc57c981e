"""The JSON interface of the page in OpenAPI 3.1."""

from __future__ import annotations

from typing import Any

import asperity
from asperity.page.chart import MOST_CURVES, MOST_POINTS
from asperity.page.computation import MOST_KEPT
from asperity.page.guard import LARGEST_BODY
from asperity.page.joint_request import MOST_CHANGES
from asperity.page.list_changes import EACH
from asperity.page.openapi_work import job_schema, work_paths
from asperity.results import SEVERITIES

Schema = dict[str, Any]

_NUMBERS: Schema = {"type": "array", "items": {"type": ["number", "null"]}}
_VALUE: Schema = {
    "type": "object",
    "properties": {
        "value": {"type": "number", "description": "In the unit of the key's range."},
        "si": {"type": "number"},
        "tolerance": {"type": "number", "description": "In SI; 0 where the file states none."},
    },
}
_LIST: Schema = {
    "meaning": {"type": "string"},
    "keys": {"type": "array", "items": {"type": "string"}, "description": "Of each section, in their order."},
    "one_for_each": {
        "type": ["string", "null"],
        "description": "Dotted path of the number of sections that the list has to have; null for any number.",
    },
    "most": {"type": "integer", "description": "Largest number of sections."},
    "of_file": {
        "type": "array",
        "items": {"type": "object", "additionalProperties": {"type": "string"}},
        "description": "What each section of the file says, without the changes.",
    },
}
_STATED: Schema = {
    "numbers": {"type": "object", "additionalProperties": _VALUE, "description": "By dotted path."},
    "entered": {
        "type": "object",
        "additionalProperties": {
            **_VALUE,
            "properties": {
                **_VALUE["properties"],
                "text": {"type": "string", "description": "As the file has it."},
            },
        },
        "description": "By dotted path: numbers that no study varies, an Rz and the shares of a duty.",
    },
    "lists": {
        "type": "object",
        "additionalProperties": {"type": "object", "properties": _LIST},
        "description": "By name: the sections [[duty]] and [[branch]].",
    },
    "choices": {"type": "object", "additionalProperties": {"type": "string"}},
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
        "paths": {
            "/api/description": {"get": _get("Parameters of a joint file: meaning, unit, range, default.")},
            "/api/schema": {"get": _get("JSON schema of a joint file.")},
            "/api/results": {"post": _results()},
            "/api/joint": {"post": _joint()},
            "/api/chart": {"post": _chart()},
            "/api/joint/{id}/joint.{kind}": {"get": _download()},
            "/api/file": {"post": _file()},
            **work_paths(_PROBLEMS, _request_schema()),
        },
        "components": {
            "schemas": {
                "Error": _error_schema(),
                "Request": _request_schema(),
                "Answer": _answer_schema(),
                "Chart": _chart_answer_schema(),
                "Job": job_schema(),
            }
        },
    }


def _json(schema: Schema, description: str) -> Schema:
    return {"description": description, "content": {"application/json": {"schema": schema}}}


def _ref(name: str) -> Schema:
    return {"$ref": f"#/components/schemas/{name}"}


def _get(summary: str, kind: str = "object") -> Schema:
    return {"summary": summary, "responses": {"200": _json({"type": kind}, summary)}}


_PROBLEMS = {
    "403": _json(_ref("Error"), "The request comes from another web site."),
    "408": _json(_ref("Error"), "The body did not arrive in time."),
    "413": _json(_ref("Error"), f"The body is larger than {LARGEST_BODY} bytes."),
    "415": _json(_ref("Error"), "The body has another type."),
    "422": _json(_ref("Error"), "The joint is described wrongly, cannot exist or has no solution."),
    "503": _json(_ref("Error"), "Too many computations are waiting."),
}


def _joint() -> Schema:
    return {
        "summary": "Solve one joint: the document of 'asperity joint --json', with drawing, wind-up and curves.",
        "requestBody": {"required": True, "content": {"application/json": {"schema": _ref("Request")}}},
        "responses": {"200": _json(_ref("Answer"), "The joint."), **_PROBLEMS},
    }


def _chart() -> Schema:
    request = _request_schema()
    request["properties"]["chart"] = _chart_schema()
    request["required"] = ["chart"]
    return {
        "summary": "One number of the joint file against one result, by the evaluator of 'asperity sweep'.",
        "requestBody": {"required": True, "content": {"application/json": {"schema": request}}},
        "responses": {"200": _json(_ref("Chart"), "Curves; SI units, and those of displays."), **_PROBLEMS},
    }


def _results() -> Schema:
    return {
        "summary": "Results that charts of a joint can show: name, label, unit, group.",
        "requestBody": {"required": True, "content": {"application/json": {"schema": _ref("Request")}}},
        "responses": {"200": _json({"type": "array"}, "One entry for each number."), **_PROBLEMS},
    }


def _chart_schema() -> Schema:
    text: Schema = {"type": "string"}
    family = {"over": text, "values": {"type": "array", "items": text, "maxItems": MOST_CURVES}}
    return {
        "type": "object",
        "required": ["over", "from", "to", "result"],
        "additionalProperties": False,
        "properties": {
            "over": {"type": "string", "description": "Dotted path of a number that the joint file states."},
            "from": {"type": "string", "description": "With its unit."},
            "to": text,
            "points": {"type": "integer", "minimum": 2, "maximum": MOST_POINTS},
            "scale": {"enum": ["linear", "log"]},
            "result": {"type": "string", "description": "A name of /api/results."},
            "family": {
                "type": "object",
                "properties": family,
                "description": "Another number, a curve for each of its values.",
            },
        },
        "examples": [
            {"over": "load.preload", "from": "200 N", "to": "2 kN", "result": "assembly_stiffness_output"}
        ],
    }


def _chart_answer_schema() -> Schema:
    number: Schema = {"type": ["number", "null"]}
    status: Schema = {"type": "integer", "description": "0 is solved; 'reasons' says what the others mean."}
    curve = {
        "value": number,
        "value_shown": {"type": "string"},
        "y": _NUMBERS,
        "y_shown": _NUMBERS,
        "status": {"type": "array", "items": status},
    }
    point = {"x": number, "x_shown": number, "y": number, "y_shown": number, "status": status}
    words = ("over", "unit", "result", "result_label", "result_unit")
    return {
        "type": "object",
        "properties": {
            **{name: {"type": "string"} for name in words},
            "family": {"type": ["string", "null"]},
            "x": _NUMBERS,
            "x_shown": _NUMBERS,
            "curves": {"type": "array", "items": {"type": "object", "properties": curve}},
            "joint": {"type": ["object", "null"], "properties": point},
            "reasons": {"type": "object", "additionalProperties": {"type": "string"}},
        },
    }


def _download() -> Schema:
    return {
        "summary": f"Joint file, JSON document or report of one of the latest {MOST_KEPT} joints.",
        "parameters": [
            {"name": "id", "in": "path", "required": True, "schema": {"type": "string"}},
            {
                "name": "kind",
                "in": "path",
                "required": True,
                "schema": {"enum": ["toml", "json", "html", "pdf"]},
            },
        ],
        "responses": {
            "200": {
                "description": "The file.",
                "content": {
                    "application/toml": {},
                    "application/json": {},
                    "text/html": {},
                    "application/pdf": {},
                },
            },
            "404": _json(_ref("Error"), "This joint is no longer kept."),
            "422": _json(_ref("Error"), "A PDF needs the extra 'report'."),
        },
    }


def _file() -> Schema:
    name = {"name": "name", "in": "query", "schema": {"type": "string"}, "description": "For messages."}
    return {
        "summary": "Check a joint file and list what it states.",
        "parameters": [name],
        "requestBody": {"required": True, "content": {"application/toml": {"schema": {"type": "string"}}}},
        "responses": {
            "200": _json(
                {
                    "type": "object",
                    "properties": {"name": {"type": "string"}, "toml": {"type": "string"}, **_STATED},
                },
                "Its text and its values.",
            ),
            **_PROBLEMS,
        },
    }


def _error_schema() -> Schema:
    return {
        "type": "object",
        "required": ["error", "kind", "keys"],
        "properties": {
            "error": {"type": "string", "description": "The message of the command line."},
            "kind": {"enum": ["input", "no_solution", "busy", "refused", "failed"]},
            "keys": {
                "type": "object",
                "additionalProperties": {"type": "string"},
                "description": "Dotted path of a key of the joint file → what is wrong with it.",
            },
        },
    }


def _request_schema() -> Schema:
    return {
        "type": "object",
        "additionalProperties": False,
        "oneOf": [{"required": ["toml"]}, {"required": ["joint"]}],
        "properties": {
            "toml": {"type": "string", "description": "The text of a joint file."},
            "joint": {
                "type": "object",
                "description": "The tables of a joint file; /api/schema is their schema.",
            },
            "changes": {
                "type": "object",
                "additionalProperties": {"type": ["string", "number"]},
                "maxProperties": MOST_CHANGES,
                "description": "Dotted path → value with its unit, or one of the words of a choice; empty to leave a "
                "key out. Name of a list → its sections as their places in the file, '1 3 0' with 0 for a new one, "
                f"empty for none; for 'branch' also '{EACH}', one for each branch of the drive: changes of sections "
                "beyond them wait. Sections are counted from 1 in the new arrangement.",
                "examples": [
                    {"load.output_torque": "6000 N*mm", "model.closure": "constant_pin_force"},
                    {"branch": EACH, "branch.2.planet_deviation": "2 um", "duty": "2"},
                ],
            },
            "name": {"type": "string", "description": "What messages and downloads call the joint."},
        },
    }


def _margin_schema() -> Schema:
    number: Schema = {"type": ["number", "null"]}
    text: Schema = {"type": "string"}
    return {
        "type": "object",
        "properties": {
            **dict.fromkeys(("name", "label", "place", "unit"), text),
            **dict.fromkeys(("actual", "lowest", "highest"), number),
            "infinite": {
                "type": "boolean",
                "description": "Whether the actual value is infinite; if so, it is null.",
            },
            "inclusive": {
                "type": "boolean",
                "description": "Whether the bounds 'lowest' and 'highest' themselves are allowed.",
            },
            "used": {"type": ["number", "null"], "description": "Share of the limit that is used."},
            "ok": {"type": "boolean"},
            "severity": {"enum": list(SEVERITIES)},
            "state": {"type": "string", "description": "State of the joint where that is no failure."},
        },
    }


def _answer_schema() -> Schema:
    names = ("published", "series_with_bulk", "assembly")
    curves = (
        "torque_Nm",
        *(f"{name}_Nm_per_rad" for name in names),
        "drift_rad_per_output_turn",
        "efficiency",
        "total_loss_W",
        "life_hours",
        "life_output_turns",
        "largest_slip_ratio",
    )
    windup = (
        "torque_Nm",
        "loading_angle_rad",
        "incremental_stiffness_Nm_per_rad",
        "unloading_angle_rad",
        "reloading_angle_rad",
    )
    return {
        "type": "object",
        "properties": {
            "id": {"type": "string", "description": "For downloads."},
            "name": {"type": "string"},
            **_STATED,
            "form": {
                "type": ["object", "null"],
                "description": "Groups of numbers and choices of another drive than the paper's; null for the paper's.",
            },
            "document": {"type": "object", "description": "As 'asperity joint FILE --json' prints it."},
            "drawing": {"type": "object", "description": "Circles and contact forces of the drive."},
            "margins": {
                "type": "array",
                "items": _margin_schema(),
                "description": "What is required and reached, in the unit of each entry.",
            },
            "creep": {
                "type": "object",
                "additionalProperties": {
                    "type": "object",
                    "properties": {"traction": _NUMBERS, "creepage": _NUMBERS},
                },
                "description": "Contact → its creep curve: traction T/N over creepage, up to gross slip.",
            },
            "curves": {"type": "object", "properties": dict.fromkeys(curves, _NUMBERS)},
            "windup": {
                "type": "object",
                "properties": {
                    "unknown_because": {"type": ["string", "null"]},
                    "hysteresis_rad": {"type": "number"},
                    "lost_motion_rad": {"type": "number"},
                    "dissipated_energy_J": {"type": "number"},
                    **dict.fromkeys(windup, _NUMBERS),
                },
            },
        },
    }

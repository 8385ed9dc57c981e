"""The part of the JSON interface that is about files and long jobs, in OpenAPI 3.1."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from asperity.page.jobs import FEWEST_SAMPLES, KINDS, MOST_SAMPLES
from asperity.page.upload import LARGEST_SURFACE, LONGEST_MEASUREMENT

Schema = dict[str, Any]

_TEXT: Schema = {"type": "string"}
_JOB: Schema = {"$ref": "#/components/schemas/Job"}
_IDENTITY = {"name": "id", "in": "path", "required": True, "schema": _TEXT}


def job_schema() -> Schema:
    """The state of a job."""
    return {
        "type": "object",
        "properties": {
            "id": _TEXT,
            "kind": {"enum": list(KINDS)},
            "name": {"type": "string", "description": "Name of the joint."},
            "state": {"enum": ["waiting", "running", "done", "failed", "stopped"]},
            "done": {"type": "integer"},
            "total": {"type": "integer", "description": "0 as long as it is not known."},
            "seconds": {"type": "number", "description": "Since it began to run."},
            "message": {"type": "string", "description": "Why it failed."},
            "result": {
                "type": ["object", "null"],
                "description": "As the command of the same name prints it.",
            },
        },
    }


def work_paths(problems: Mapping[str, Schema], request: Schema) -> Schema:
    """Addresses for files and jobs."""

    def answer(schema: Schema, description: str) -> Schema:
        return {"description": description, "content": {"application/json": {"schema": schema}}}

    def post(summary: str, kind: str, body: Schema, status: str, found: Schema) -> Schema:
        content = {"required": True, "content": {kind: {"schema": body}}}
        return {
            "summary": summary,
            "requestBody": content,
            "responses": {status: answer(found, summary), **problems},
        }

    units = [
        {"name": name, "in": "query", "schema": _TEXT, "description": "Where the file does not say it."}
        for name in ("position_unit", "height_unit", "spacing")
    ]
    named = {"name": "name", "in": "query", "schema": _TEXT, "description": "For messages."}
    file: Schema = {"type": "string", "format": "binary", "maxLength": LARGEST_SURFACE}
    gone = {"410": {"description": "This job is no longer kept."}}
    whole: Schema = {"type": "integer"}
    job = {
        "type": "object",
        "required": ["kind"],
        "properties": {
            "kind": {"enum": list(KINDS)},
            "samples": {**whole, "minimum": FEWEST_SAMPLES, "maximum": MOST_SAMPLES},
            "seed": whole,
            "distribution": {"type": "string", "examples": ["uniform", "normal 2 sigma"]},
            "design": {
                "type": "string",
                "description": "Text of a design file; its joint is that of the request.",
            },
            "file": {"type": "string", "description": "Name of the design file, for messages."},
        },
    }
    asked = {**request, "required": ["job"], "properties": {**request["properties"], "job": job}}
    within = f"within {LONGEST_MEASUREMENT:g} s"
    return {
        "/api/open": {
            "post": {
                **post(
                    f"Open a file, recognised by its content; a surface is measured {within}.",
                    "application/octet-stream",
                    file,
                    "200",
                    {"type": "object", "properties": {"kind": {"enum": ["joint", "design", "measurement"]}}},
                ),
                "parameters": [named, *units],
            }
        },
        "/api/measure": {
            "post": {
                **post(
                    f"D and G of a measured surface, or of a measurement document, {within}.",
                    "application/octet-stream",
                    file,
                    "200",
                    {
                        "type": "object",
                        "properties": {"document": {"type": "object"}, "changes": {"type": "object"}},
                    },
                ),
                "parameters": [named, *units],
            }
        },
        "/api/jobs": {"post": post("Begin a long job.", "application/json", asked, "202", _JOB)},
        "/api/jobs/{id}": {
            "get": {
                "summary": "State of a job, and its result.",
                "parameters": [_IDENTITY],
                "responses": {"200": answer(_JOB, "The job."), **gone},
            }
        },
        "/api/jobs/{id}/events": {
            "get": {
                "summary": "Each change of a job until its end, as server-sent events.",
                "parameters": [_IDENTITY],
                "responses": {
                    "200": {"description": "Events.", "content": {"text/event-stream": {}}},
                    **gone,
                },
            }
        },
        "/api/jobs/{id}/stop": {
            "post": {
                **post("End a job at once.", "application/json", {"type": "object"}, "200", _JOB),
                "parameters": [_IDENTITY],
            }
        },
        "/api/jobs/{id}/result.json": {
            "get": {
                "summary": "The result of a job as a file.",
                "parameters": [_IDENTITY],
                "responses": {"200": {"description": "JSON.", "content": {"application/json": {}}}, **gone},
            }
        },
    }

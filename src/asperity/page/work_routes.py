"""Addresses for files and long jobs: open, measure, begin, watch, stop."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import JSONResponse, Response, StreamingResponse
from starlette.routing import Route

from asperity.errors import AsperityError
from asperity.page.computation import Computations
from asperity.page.guard import parsed, problem, require_type
from asperity.page.jobs import ENDED, Job, Jobs, job_request
from asperity.page.joint_request import attachment, shown_name
from asperity.page.requests import MeasurementQuery
from asperity.page.upload import Measurements, opened_design, opened_joint, recognised
from asperity.types import Document

#: Pause between two looks at a job that is watched [s], and the longest silence towards the browser [s].
LOOK, SILENCE = 0.1, 10.0


def work_routes(jobs: Jobs, measurements: Measurements, readers: Computations) -> list[Route]:
    """The addresses."""

    async def measured(request: Request, content: bytes, name: str) -> Response:
        units = {key: request.query_params.get(key, "") for key in MeasurementQuery.model_fields}
        measurement = await measurements.run(content, name, units)
        return JSONResponse({"kind": "measurement", **measurement})

    async def open_file(request: Request) -> Response:
        require_type(request, "application/octet-stream", "application/toml")
        name = request.query_params.get("name", "joint.toml")
        content = await request.body()
        kind = await readers.run(recognised, content, name)
        reading = {"joint": opened_joint, "design": opened_design}
        try:
            if kind in reading:
                return JSONResponse({"kind": kind, **await readers.run(reading[kind], content, name)})
            return await measured(request, content, name)
        except AsperityError as error:
            return problem(error, source=shown_name(name))

    async def file(request: Request) -> Response:
        require_type(request, "application/octet-stream", "application/toml")
        name = request.query_params.get("name", "joint.toml")
        try:
            return JSONResponse(await readers.run(opened_joint, await request.body(), name))
        except AsperityError as error:
            return problem(error, source=shown_name(name))

    async def measure(request: Request) -> Response:
        require_type(request, "application/octet-stream")
        return await measured(request, await request.body(), request.query_params.get("name", "surface"))

    return [
        Route("/api/open", open_file, methods=["POST"]),
        Route("/api/file", file, methods=["POST"]),
        Route("/api/measure", measure, methods=["POST"]),
        *_job_routes(jobs, readers),
    ]


def _job_routes(jobs: Jobs, readers: Computations) -> list[Route]:
    """The addresses of long jobs."""

    async def begin(request: Request) -> Response:
        require_type(request, "application/json")
        kind, joint, files, options = await readers.run(job_request, parsed(await request.body()))
        job = jobs.begin(kind, joint.name, files, options)
        return JSONResponse(job.told(), status_code=202)

    def asked(request: Request) -> Job:
        job = jobs.get(request.path_params["identity"])
        if job is None:
            raise HTTPException(410, "this job is no longer kept; begin it again")
        return job

    async def state(request: Request) -> Response:
        job = asked(request)
        return JSONResponse({**job.told(), "result": job.result})

    async def stop(request: Request) -> Response:
        require_type(request, "application/json")
        jobs.stop(asked(request))
        return JSONResponse(asked(request).told())

    async def events(request: Request) -> Response:
        return StreamingResponse(_watched(asked(request)), media_type="text/event-stream")

    async def download(request: Request) -> Response:
        job = asked(request)
        if job.result is None:
            raise HTTPException(410, "this job has no result")
        headers = {"content-disposition": attachment(job.name, f"-{job.kind}.json")}
        text = json.dumps(job.result, indent=2, allow_nan=False) + "\n"
        return Response(text, media_type="application/json", headers=headers)

    return [
        Route("/api/jobs", begin, methods=["POST"]),
        Route("/api/jobs/{identity:str}", state, methods=["GET"]),
        Route("/api/jobs/{identity:str}/stop", stop, methods=["POST"]),
        Route("/api/jobs/{identity:str}/events", events, methods=["GET"]),
        Route("/api/jobs/{identity:str}/result.json", download, methods=["GET"]),
    ]


async def _watched(job: Job) -> AsyncIterator[str]:
    """Each change of a job as a server-sent event, until its end."""
    seen, silent = -1, 0.0
    while True:
        told: Document = job.told()
        if job.version != seen or told["state"] in ENDED:
            seen, silent = job.version, 0.0
            yield f"data: {json.dumps(told)}\n\n"
        if told["state"] in ENDED:
            return
        await asyncio.sleep(LOOK)
        silent += LOOK
        if silent >= SILENCE:  # a line that browsers ignore, by which a lost one is noticed
            silent = 0.0
            yield ": running\n\n"

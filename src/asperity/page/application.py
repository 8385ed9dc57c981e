"""The addresses of the page: its assets from a fixed table, and the JSON interface."""

from __future__ import annotations

import contextlib
import functools
import json
from collections.abc import AsyncIterator, Callable, Iterable
from importlib.resources import files
from typing import Any

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from asperity.errors import AsperityError
from asperity.joint_file.schema import joint_schema
from asperity.page.answer import joint_answer, stated_values
from asperity.page.answers import DOWNLOADS
from asperity.page.chart import chart_answer, chart_request, chart_results
from asperity.page.comparison import comparison_answer, comparison_request
from asperity.page.computation import MOST_WAITING, Computations, KeptAnswers
from asperity.page.description import description
from asperity.page.first_figures import first_figures
from asperity.page.guard import App, Guard, parsed, problem, refusal, require_type
from asperity.page.jobs import Jobs
from asperity.page.joint_request import JointRequest, attachment, joint_request
from asperity.page.openapi import openapi
from asperity.page.upload import LARGEST_SURFACE, Measurements
from asperity.page.work_routes import work_routes
from asperity.report.joint_report import ReportSource, joint_report
from asperity.report.pdf import report_pdf, require_typst
from asperity.types import Document
from asperity.views.html import report_html

#: Address → file of the package and its type. Nothing else can be read, whatever a request says.
ASSETS: dict[str, tuple[str, str]] = {
    "/": ("page.html", "text/html; charset=utf-8"),
    **{f"/{name}.css": (f"{name}.css", "text/css; charset=utf-8") for name in ("page", "headline", "panels")},
    **{
        f"/{name}.js": (f"{name}.js", "text/javascript; charset=utf-8")
        for name in (
            *(
                "main",
                "state",
                "controls",
                "choices",
                "lists",
                "heights",
                "units",
                "help",
                "headline",
                "messages",
                "panels",
                "preferences",
                "results",
                "blocks",
            ),
            *("curves", "courses", "plots", "chart", "upload", "jobs", "compose", "compare", "drawing"),
            "numbers",
        )
    },
    "/icon.svg": ("icon.svg", "image/svg+xml"),
}

#: Time that a request waits for its computation [s]; the first one of an installation compiles.
LONGEST_ANSWER = 300.0


def application(
    start: JointRequest,
    *,
    hosts: Iterable[str],
    computations: Computations,
    charts: Computations,
    longest_body: float | None = None,
) -> App:
    """The page as an ASGI application."""
    jobs, measurements = Jobs(), Measurements()
    # each file in a thread: the largest ones take seconds, which others do not wait for
    readers = Computations(longest=LONGEST_ANSWER, threads=MOST_WAITING)
    first = Computations(longest=LONGEST_ANSWER)  # which do not wait for whole answers
    joints = _JointAddresses(computations, charts, readers, first)
    stated = stated_values(start.case(), start.file_tables)
    described = {
        **description(),
        "start": {"name": start.name, "toml": start.text, "surfaces": start.surfaces, **stated},
    }

    constant: dict[str, Callable[[], Response]] = {
        **{path: functools.partial(_asset, *asset) for path, asset in ASSETS.items()},
        "/openapi.json": lambda: JSONResponse(openapi()),
        "/api/description": lambda: JSONResponse(described),
        "/api/schema": lambda: JSONResponse(joint_schema()),
    }

    @functools.cache
    def made(path: str) -> Response:
        return constant[path]()

    async def always_the_same(request: Request) -> Response:
        # made once: whoever asks again and again would keep others waiting
        return made(request.url.path)

    @contextlib.asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        warm = computations.submit(joints.answered, start)
        # the page asks for it again
        warm.add_done_callback(lambda done: done.cancelled() or done.exception())
        yield
        computations.close()
        charts.close()
        readers.close()
        first.close()
        measurements.close()
        jobs.close()

    routes = [
        *(Route(path, always_the_same, methods=["GET"]) for path in constant),
        *joints.routes(),
        *work_routes(jobs, measurements, readers),
    ]
    handlers: dict[Any, Any] = {AsperityError: _wrong, HTTPException: _not_here, Exception: _failed}
    app = Starlette(routes=routes, exception_handlers=handlers, lifespan=life)
    limits = {} if longest_body is None else {"longest_body": longest_body}
    large = {"/api/measure": LARGEST_SURFACE, "/api/open": LARGEST_SURFACE}
    return Guard(app, hosts=hosts, larger_bodies=large, **limits)  # type: ignore[arg-type]


class _JointAddresses:
    """The addresses that compute a joint, and those that give what was computed as a file."""

    def __init__(
        self, computations: Computations, charts: Computations, readers: Computations, first: Computations
    ) -> None:
        self._computations, self._charts, self._readers, self._first = computations, charts, readers, first
        self._kept = KeptAnswers()

    def routes(self) -> list[Route]:
        """The addresses."""
        return [
            Route("/api/results", self._results, methods=["POST"]),
            Route("/api/joint", self._joint, methods=["POST"]),
            Route("/api/figures", self._figures, methods=["POST"]),
            Route("/api/chart", self._chart, methods=["POST"]),
            Route("/api/compare", self._comparison, methods=["POST"]),
            Route("/api/joint/{identity:str}/joint.{kind}", self._download, methods=["GET"]),
        ]

    def answered(self, request: JointRequest) -> Document:
        """What the page is told about a joint; computed once while it is kept."""
        answer = self._kept.get(request.identity)
        if answer is None:
            answer = request, joint_answer(request)
            self._kept.keep(request.identity, answer)
        return answer[1]

    async def _computed(
        self, joints: list[JointRequest], worker: Computations, compute: Callable[..., Any], *asked: Any
    ) -> Response:
        """The answer of a worker, once the files of all joints have been read."""
        try:
            for one in joints:
                await self._readers.run(one.case)
            return JSONResponse(await worker.run(compute, *asked))
        except AsperityError as error:
            return problem(error, source=joints[-1].name)

    async def _results(self, request: Request) -> Response:
        asked = joint_request(await _body(request))
        return await self._computed([asked], self._readers, chart_results, asked)

    async def _joint(self, request: Request) -> Response:
        asked = joint_request(await _body(request))
        return await self._computed([asked], self._computations, self.answered, asked)

    async def _figures(self, request: Request) -> Response:
        asked = joint_request(await _body(request))
        return await self._computed([asked], self._first, first_figures, asked)

    async def _chart(self, request: Request) -> Response:
        asked = chart_request(await _body(request))
        return await self._computed([asked.joint], self._charts, chart_answer, asked)

    async def _comparison(self, request: Request) -> Response:
        joints = comparison_request(await _body(request))
        return await self._computed(joints, self._charts, comparison_answer, *joints)

    async def _download(self, request: Request) -> Response:
        end = request.path_params["kind"]
        kept_answer = self._kept.get(request.path_params["identity"])
        if end not in DOWNLOADS:
            raise HTTPException(404)
        if kept_answer is None:
            return refusal(404, "this joint is no longer kept; change a value and download again", "refused")
        asked, answer = kept_answer
        worker = self._readers if end == "toml" else self._computations
        content = await worker.run(_downloaded, end, asked, answer["document"])
        headers = {"content-disposition": attachment(asked.name, f".{end}")}
        return Response(content, media_type=DOWNLOADS[end], headers=headers)


def _asset(name: str, kind: str) -> Response:
    """A file of the page."""
    return Response(files("asperity.page").joinpath("static", name).read_bytes(), media_type=kind)


async def _body(request: Request) -> Any:
    """What the JSON document of a request says."""
    require_type(request, "application/json")
    return parsed(await request.body())


# handlers that are no coroutines would run in threads of their own
async def _wrong(request: Request, error: AsperityError) -> Response:
    return problem(error, source="")


async def _not_here(request: Request, error: HTTPException) -> Response:
    absent = "there is nothing at this address; /openapi.json lists all addresses"
    return refusal(error.status_code, absent if error.status_code == 404 else str(error.detail), "refused")


async def _failed(request: Request, error: Exception) -> Response:
    return refusal(500, "the server failed; its terminal says why", "failed")


def _downloaded(kind: str, asked: JointRequest, document: Document) -> bytes:
    if kind == "json":
        return (json.dumps(document, indent=2, allow_nan=False) + "\n").encode()
    if kind == "toml":
        return asked.file_text().encode()
    if kind == "pdf":
        require_typst()  # before the work
    measurements = tuple(json.dumps(surface, indent=2) + "\n" for surface in asked.surfaces)
    source = ReportSource(asked.name, asked.stated_text(), asked.solved_case(), measurements)
    report = joint_report(source)
    return report_pdf(report) if kind == "pdf" else report_html(report).encode()

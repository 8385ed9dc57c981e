"""Addresses for files and jobs, as a script uses them."""

import json
import threading
import time

import pytest

pytest.importorskip("starlette")
pytest.importorskip("httpx2")

from starlette.applications import Starlette
from starlette.testclient import TestClient

from asperity.errors import AsperityError
from asperity.page import jobs as jobs_module
from asperity.page import work_routes as work_routes_module
from asperity.page.computation import Computations
from asperity.page.guard import problem
from asperity.page.jobs import Jobs
from asperity.page.upload import Measurements, recognised
from asperity.page.work_routes import work_routes

KIND = {"content-type": "application/octet-stream"}


class Done:
    """A child that has its result at once."""

    def __init__(self, kind, files, options):
        self.files, self.options = files, options

    def run(self, report):
        report(3, 4)
        return {"samples": self.options["samples"]}

    def stop(self):
        pass


@pytest.fixture
def client(monkeypatch):
    monkeypatch.setattr(jobs_module, "Child", Done)
    jobs, measurements, readers = Jobs(), Measurements(), Computations(longest=60.0)

    async def wrong(request, error):
        return problem(error, source="")

    app = Starlette(
        routes=work_routes(jobs, measurements, readers), exception_handlers={AsperityError: wrong}
    )
    with TestClient(app) as found:
        yield found
    jobs.close()
    measurements.close()
    readers.close()


def test_a_job_is_begun_watched_and_downloaded(client, joint_text):
    job = {"kind": "uncertainty", "samples": 200}
    changes = {"load.preload": "1 kN +- 50 N, uniform"}
    body = {"toml": joint_text, "name": "my joint.toml", "changes": changes, "job": job}
    begun = client.post("/api/jobs", json=body)
    assert begun.status_code == 202
    identity = begun.json()["id"]
    with client.stream("GET", f"/api/jobs/{identity}/events") as stream:
        assert stream.headers["content-type"].startswith("text/event-stream")
        told = [
            json.loads(line.removeprefix("data: "))
            for line in stream.iter_lines()
            if line.startswith("data: ")
        ]
    assert told[-1]["state"] == "done"
    assert (told[-1]["done"], told[-1]["total"]) == (3, 4)
    assert client.get(f"/api/jobs/{identity}").json()["result"] == {"samples": 200}
    file = client.get(f"/api/jobs/{identity}/result.json")
    assert file.json() == {"samples": 200}
    assert file.headers["content-disposition"] == 'attachment; filename="my_joint-uncertainty.json"'
    assert client.post(f"/api/jobs/{identity}/stop", json={}).json()["state"] == "done"


@pytest.mark.parametrize("name", ["opened_joint", "opened_design", "job_request"])
def test_files_are_read_beside_the_loop_of_events(client, monkeypatch, name):
    """The text of a file may take seconds, and the page must answer others meanwhile."""
    began, answered = threading.Event(), threading.Event()

    def slow(*arguments):
        began.set()
        assert answered.wait(20.0), "nothing was answered while a file was read"
        raise AsperityError("read")

    monkeypatch.setattr(work_routes_module, name, slow)
    content = b"[variables.x]\n" if name == "opened_design" else b"{}"
    path = "/api/jobs" if name == "job_request" else "/api/open?name=x.toml"
    kind = {"content-type": "application/json"} if name == "job_request" else KIND
    asking = threading.Thread(target=client.post, args=(path,), kwargs={"content": content, "headers": kind})
    asking.start()
    assert began.wait(20.0)
    assert client.get("/api/jobs/0123").status_code == 410
    answered.set()
    asking.join()


def test_empty_lines_are_recognised_in_no_time():
    start = time.perf_counter()
    assert recognised(b"\n" * 900_000, "x.toml") == "joint"
    assert recognised(b"x = 1\n\n  [variables.y]\n", "x.toml") == "design"
    assert time.perf_counter() - start < 2.0


def test_a_job_that_is_not_there(client):
    for path in ("/api/jobs/0123", "/api/jobs/0123/events", "/api/jobs/0123/result.json"):
        assert client.get(path).status_code == 410
    assert client.post("/api/jobs/0123/stop", json={}).status_code == 410


def test_files_are_opened_by_what_they_are(client, joint_text):
    joint = client.post("/api/open?name=a.txt", content=joint_text.encode(), headers=KIND).json()
    assert (joint["kind"], joint["toml"]) == ("joint", joint_text)
    design = client.post("/api/open?name=d", content=b"joint = 'x'\n[variables]\n", headers=KIND).json()
    assert design["kind"] == "design"
    wrong = client.post("/api/open?name=a.toml", content=b"[drive", headers=KIND)
    assert wrong.status_code == 422
    assert wrong.json()["error"].startswith("a.toml: not valid TOML")


def test_forms_of_other_sites_have_the_wrong_type(client):
    for path in ("/api/open", "/api/measure", "/api/jobs", "/api/jobs/0123/stop"):
        response = client.post(path, content=b"x", headers={"content-type": "text/plain"})
        assert response.status_code in (410, 415)

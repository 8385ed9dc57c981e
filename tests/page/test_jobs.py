"""One job after the other, a bounded queue, and a stop that stops."""

import threading
import time

import pytest

from asperity.errors import InputError
from asperity.page import jobs as module
from asperity.page.child import StoppedError
from asperity.page.computation import BusyError
from asperity.page.jobs import MOST_JOBS, MOST_KEPT_JOBS, Jobs, job_request


class Slow:
    """A child that waits until it may go on."""

    running = 0

    def __init__(self, kind, files, options):
        self.kind, self.go, self.stopped = kind, threading.Event(), False

    def run(self, report):
        type(self).running += 1
        assert type(self).running == 1  # one at a time
        report(1, 4)
        self.go.wait(30)
        type(self).running -= 1
        if self.stopped:
            raise StoppedError("stopped")
        if self.kind == "wrong":
            raise InputError("the file states no tolerances")
        return {"found": self.kind}

    def stop(self):
        self.stopped = True
        self.go.set()


@pytest.fixture
def jobs(monkeypatch):
    # a class of its own: the last job of another test may still be ending
    monkeypatch.setattr(module, "Child", type("Slow", (Slow,), {}))
    found = Jobs()
    yield found
    found.close()


def until(job, state):
    end = time.monotonic() + 30
    while job.state != state and time.monotonic() < end:
        time.sleep(0.005)
    assert job.state == state


def begin(jobs, kind="study"):
    return jobs.begin(kind, "a.toml", {"a.toml": b""}, {})


def test_jobs_run_one_after_the_other(jobs):
    one, two = begin(jobs), begin(jobs)
    until(one, "running")
    assert two.state == "waiting"
    version = one.version
    one.child.go.set()
    until(two, "running")
    assert (one.state, one.result, one.done, one.total) == ("done", {"found": "study"}, 1, 4)
    assert one.version > version
    two.child.go.set()
    until(two, "done")
    assert begin(jobs).state in ("waiting", "running")  # the worker comes back


def test_a_running_and_a_waiting_job_can_be_stopped(jobs):
    one, two, three = (begin(jobs) for _ in range(3))
    until(one, "running")
    jobs.stop(two)
    assert two.state == "stopped"
    jobs.stop(one)
    until(one, "stopped")
    until(three, "running")  # the stopped one never ran
    assert one.result is None


def test_a_job_that_fails_says_why(jobs):
    job = begin(jobs, "wrong")
    until(job, "running")
    job.child.go.set()
    until(job, "failed")
    assert job.told()["message"] == "the file states no tolerances"


def test_the_queue_and_the_memory_are_bounded(jobs):
    started = [begin(jobs) for _ in range(MOST_JOBS)]
    with pytest.raises(BusyError, match="jobs are waiting"):
        begin(jobs)
    for job in started:
        jobs.stop(job)
        until(job, "stopped")
    later = []
    for _ in range(MOST_KEPT_JOBS + 2):
        later.append(begin(jobs))
        jobs.stop(later[-1])
        until(later[-1], "stopped")
    assert jobs.get(started[0].identity) is None
    assert [job for job in later if jobs.get(job.identity) is job] == later[-MOST_KEPT_JOBS:]


def test_the_end_of_the_server_ends_all(jobs):
    one, two = begin(jobs), begin(jobs)
    until(one, "running")
    jobs.close()
    until(one, "stopped")
    assert two.state == "stopped"
    with pytest.raises(BusyError):
        begin(jobs)


def test_seconds_count_from_the_start_to_the_end(monkeypatch, described_as):
    job = module.Job("a", "design", "a.toml", Slow("design", {}, {}))
    assert described_as("Job", job.told()) == set()
    assert job.told()["seconds"] == 0.0
    job.started = 100.0
    monkeypatch.setattr(module.time, "monotonic", lambda: 102.54)
    assert job.told()["seconds"] == 2.5
    job.ended = 101.0
    assert job.told()["seconds"] == 1.0


def test_requests_become_files_and_options(joint_text):
    kind, joint, files, options = job_request(
        {
            "toml": joint_text,
            "changes": {"load.preload": "1.2 kN +- 50 N, uniform"},
            "job": {"kind": "uncertainty", "samples": 500},
        }
    )
    assert (kind, joint.name) == ("uncertainty", "joint.toml")
    assert options == {"samples": 500, "seed": 0, "distribution": ""}
    assert b"1.2 kN" in files["joint.toml"]


def test_a_design_takes_the_joint_of_the_page(joint_text):
    design = 'joint = "/etc/passwd"\n[variables]\n"load.preload" = {lower = "1 N", upper = "2 N"}\n'
    design += '[objective]\nmaximise = "stiffness"\n'
    job = {"kind": "design", "design": design, "file": "../d.toml"}
    _, _, files, _ = job_request({"toml": joint_text, "job": job})
    (name, text), (own, joint) = files.items()
    assert name == "d.toml"
    assert f'joint = "{own}"'.encode() in text
    assert b"/etc/passwd" not in text
    assert joint.decode() == joint_text


@pytest.mark.parametrize(
    ("job", "said"),
    [
        (None, "job: a JSON object with 'kind' is needed, got None"),
        (
            {"kind": "mine"},
            "job.kind: 'mine' is not one of accuracy, design, film, sensitivity, uncertainty, wear, window",
        ),
        ({"kind": "sensitivity", "samples": 3}, "job: unknown entry 'samples'; known are kind"),
        ({"kind": "uncertainty", "samples": 3}, "from 100 to 1000000"),
        ({"kind": "uncertainty", "samples": True}, "job.samples"),
        ({"kind": "uncertainty", "seed": -1}, "job.seed"),
        ({"kind": "uncertainty", "seed": 2147483649}, "from 0 to 2147483648"),
        ({"kind": "uncertainty", "distribution": 3}, "job.distribution"),
        ({"kind": "uncertainty"}, "states no tolerances"),
        ({"kind": "uncertainty", "distribution": "flat"}, "flat"),
        ({"kind": "design"}, "job.design"),
        ({"kind": "design", "design": "["}, "design.toml: not valid TOML"),
    ],
)
def test_requests_that_are_refused(joint_text, job, said):
    with pytest.raises(InputError, match=said):
        job_request({"toml": joint_text, "job": job})


def test_a_wrong_joint_is_refused_at_once(joint_text):
    body = {"toml": joint_text, "changes": {"load.preload": "1 mm"}, "job": {"kind": "sensitivity"}}
    with pytest.raises(InputError, match="expected a force"):
        job_request(body)


def test_a_job_has_cleared_up_when_all_are_ended(monkeypatch):
    """Its folder is removed after its process has ended."""
    cleared = []

    class Untidy(Slow):
        running = 0

        def run(self, report):
            try:
                return super().run(report)
            finally:
                time.sleep(0.2)
                cleared.append(self.kind)

    monkeypatch.setattr(module, "Child", Untidy)
    jobs = Jobs()
    until(begin(jobs), "running")
    jobs.close()
    assert cleared == ["study"]

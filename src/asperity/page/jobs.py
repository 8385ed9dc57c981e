"""Long jobs of the page: a queue with one worker, progress, and a way to stop each of them."""

from __future__ import annotations

import secrets
import threading
import time
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from asperity.errors import AsperityError, InputError
from asperity.joint_file.model import Case
from asperity.joint_file.quantity_key import parse_distribution
from asperity.page.child import LONGEST_END, Child, StoppedError, file_name
from asperity.page.computation import BusyError
from asperity.page.joint_request import JointRequest, asked_joint
from asperity.page.requests import DesignJob, JobRequest, UncertaintyJob, checked
from asperity.reading import parse_toml
from asperity.study.tolerances.uncertainty import toleranced_inputs
from asperity.types import Document

#: Jobs that may wait or run at the same time.
MOST_JOBS = 6
#: Jobs whose results are kept.
MOST_KEPT_JOBS = 24
#: States in which nothing more happens.
ENDED = ("done", "failed", "stopped")


@dataclass
class Job:
    """One job: its name for requests, what it does, the joint it is about, and the process that does it."""

    identity: str
    kind: str
    name: str
    child: Child
    state: str = "waiting"
    done: int = 0
    total: int = 0
    message: str = ""
    result: Document | None = None
    version: int = 0
    started: float | None = None
    ended: float | None = None

    def told(self) -> Document:
        """Its state for the page, without the result."""
        now = self.ended if self.ended is not None else time.monotonic()
        seconds = round(now - self.started, 1) if self.started is not None else 0.0
        told = ("kind", "name", "state", "done", "total", "message")
        return {"id": self.identity, "seconds": seconds} | {name: getattr(self, name) for name in told}

    def progressed(self, done: int, total: int) -> None:
        """What is done, of all that is to be done."""
        self.change(done=done, total=total)

    def change(self, **values: Any) -> None:
        """New values, and a new version for those who watch."""
        for name, value in values.items():
            setattr(self, name, value)
        self.version += 1


class Jobs:
    """The queue, with one worker that lives as long as there is something to do."""

    def __init__(self) -> None:
        self._jobs: OrderedDict[str, Job] = OrderedDict()
        self._lock = threading.Lock()
        self._working = False
        self._worker: threading.Thread | None = None
        self._closed = False

    def begin(self, kind: str, name: str, files: Mapping[str, bytes], options: Mapping[str, Any]) -> Job:
        """A job put at the end of the queue, by what it does and the name of the joint.

        :class:`BusyError` if it is full.
        """
        with self._lock:
            if self._closed or sum(job.state not in ENDED for job in self._jobs.values()) >= MOST_JOBS:
                raise BusyError(f"{MOST_JOBS} jobs are waiting already; stop one, or wait for its end")
            job = Job(secrets.token_hex(8), kind, name, Child(kind, files, options))
            self._jobs[job.identity] = job
            for old in [job for job in self._jobs.values() if job.state in ENDED][
                : max(len(self._jobs) - MOST_KEPT_JOBS, 0)
            ]:
                del self._jobs[old.identity]
            if not self._working:
                self._working = True
                self._worker = threading.Thread(target=self._work, name="asperity-jobs", daemon=True)
                self._worker.start()
        return job

    def get(self, identity: str) -> Job | None:
        """A job; None if there is none of this name."""
        return self._jobs.get(identity)

    def stop(self, job: Job) -> None:
        """End a job at once, whether it waits or runs."""
        with self._lock:
            if job.state == "waiting":
                job.change(state="stopped", message="stopped before it began")
        job.child.stop()

    def close(self) -> None:
        """End all jobs, whose folders are gone then."""
        with self._lock:
            self._closed = True
            jobs, worker = list(self._jobs.values()), self._worker
        for job in jobs:
            if job.state not in ENDED:
                self.stop(job)
        if worker is not None:
            worker.join(LONGEST_END)

    def _next(self) -> Job | None:
        with self._lock:
            for job in self._jobs.values():
                if job.state == "waiting":
                    job.change(state="running", started=time.monotonic())
                    return job
            self._working = False
            return None

    def _work(self) -> None:
        while (job := self._next()) is not None:
            try:
                result = job.child.run(report=job.progressed)
                job.change(state="done", result=result, ended=time.monotonic())
            except StoppedError:
                job.change(state="stopped", message="stopped", ended=time.monotonic())
            except AsperityError as error:
                job.change(state="failed", message=str(error), ended=time.monotonic())
            except Exception:
                job.change(
                    state="failed", message="the job failed; the terminal says why", ended=time.monotonic()
                )
                raise


def job_request(body: object) -> tuple[str, JointRequest, dict[str, bytes], Document]:
    """What a job does, its joint, its files and options, by the JSON body of a request.

    An ``InputError`` where the body is none of its model, or the joint or the job is wrong.
    """
    request = checked(JobRequest, body)
    joint, job = asked_joint(request), request.job
    case = joint.solved_case()  # says at once what is wrong
    text, measured = joint.file_text().encode(), joint.measurement_file()
    if isinstance(job, DesignJob):
        return job.kind, joint, _design_files(job, text, case) | measured, {}
    if isinstance(job, UncertaintyJob):
        # refuses at once what the job would refuse once it runs
        toleranced_inputs(case, otherwise=parse_distribution(job.distribution) if job.distribution else None)
    files = {file_name(joint.name, otherwise="joint.toml"): text} | measured
    return job.kind, joint, files, job.model_dump(exclude={"kind"})


def _design_files(job: DesignJob, joint_text: bytes, case: Case) -> dict[str, bytes]:
    """The design file, checked, whose joint is replaced by that of the page, and the joint file."""
    import tomlkit

    from asperity.study.design.design_file import design_from_tables

    name = file_name(job.file, otherwise="design.toml")
    parse_toml(job.design, source=name)
    document = tomlkit.parse(job.design)
    joint_file = "page-joint.toml" if name != "page-joint.toml" else "joint.toml"
    document["joint"] = joint_file
    try:
        design_from_tables(document.unwrap(), case=case)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None
    return {name: tomlkit.dumps(document).encode(), joint_file: joint_text}

"""A process that runs one job in a private folder, and can be ended at any time."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from asperity.errors import AsperityError, InputError, NoSolutionError
from asperity.types import Document

LONGEST_FILE_NAME = 80
#: Largest answer of a process [byte].
LARGEST_ANSWER = 20_000_000
#: Time that a stopped one has to remove its folder before the server ends [s].
LONGEST_END = 5.0
_PROGRAM = "from asperity.page.job_process import main; main()"


class StoppedError(AsperityError):
    """The job was stopped before its end."""


def file_name(name: str, *, otherwise: str) -> str:
    """A harmless name of a file: no folder, no hidden file, no option, only plain letters.

    ``otherwise`` if nothing is left. At most :data:`LONGEST_FILE_NAME` characters; the ending stays.

    >>> file_name("../../etc/my file;.csv", otherwise="surface")
    'my_file_.csv'
    """
    last = re.split(r"[/\\]", name)[-1]
    plain = re.sub(r"[^A-Za-z0-9._-]", "_", last).lstrip(".-")
    return plain[-LONGEST_FILE_NAME:].lstrip(".-") or otherwise


class Child:
    """One job in a process of its own, :func:`asperity.page.job_process.run_job`.

    ``files``: name → content of the files in its folder; the first one is the file of the job.
    """

    def __init__(self, kind: str, files: Mapping[str, bytes], options: Mapping[str, Any]) -> None:
        self._kind, self._files, self._options = kind, dict(files), dict(options)
        self._process: subprocess.Popen[bytes] | None = None
        self._stopped = self._expired = False
        self._lock = threading.Lock()

    def run(
        self, *, report: Callable[[int, int], Any] | None = None, longest: float | None = None
    ) -> Document:
        """Run it and wait for its document.

        ``report`` is called with what is done and with all that is to be done; after ``longest`` [s] it is ended.
        Raises as the command of the same name; :class:`StoppedError` if it was stopped.
        """
        # private to the user, and gone afterwards
        with tempfile.TemporaryDirectory(prefix="asperity-page-", ignore_cleanup_errors=True) as folder:
            for name, content in self._files.items():
                Path(folder, name).write_bytes(content)
            process = self._start(folder)
            timer = threading.Timer(longest or 0.0, self._expire)
            if longest is not None:
                timer.start()
            try:
                return self._answer(process, report)
            finally:
                timer.cancel()
                self.stop(asked=False)
                process.wait()
                for stream in (process.stdin, process.stdout):
                    assert stream is not None
                    stream.close()
                if self._expired and not self._stopped:
                    raise InputError(f"this took longer than {longest:g} s and was ended")

    def _start(self, folder: str) -> subprocess.Popen[bytes]:
        request = {
            "kind": self._kind,
            "folder": folder,
            "file": next(iter(self._files)),
            "options": self._options,
        }
        with self._lock:
            if self._stopped:
                raise StoppedError("stopped")
            # -P: nothing is imported from the folder in which it runs
            self._process = subprocess.Popen(
                [sys.executable, "-P", "-c", _PROGRAM],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                # what a reader says of a file that somebody sent does not belong on the terminal
                stderr=subprocess.DEVNULL if self._kind == "measure" else None,
                start_new_session=True,  # the keyboard's interruption is for the page, with which it ends
            )
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(json.dumps(request).encode() + b"\n")
            self._process.stdin.flush()  # and stays open: the process ends when it closes
        except BrokenPipeError:  # stopped already
            pass
        return self._process

    def _answer(self, process: subprocess.Popen[bytes], report: Callable[[int, int], Any] | None) -> Document:
        assert process.stdout is not None
        while line := process.stdout.readline(LARGEST_ANSWER):
            answer = json.loads(line)
            if "error" in answer:
                raise (NoSolutionError if answer["kind"] == "no_solution" else InputError)(answer["error"])
            if "result" in answer:
                return answer["result"]
            if report is not None:
                report(answer["done"], answer["total"])
        if self._stopped:
            raise StoppedError("stopped")
        raise InputError("the computation ended without a result; it may have needed too much memory")

    def _expire(self) -> None:
        self._expired = True
        self.stop(asked=False)

    def stop(self, *, asked: bool = True) -> None:
        """End it at once; ``asked`` where that is before its end, on somebody's wish."""
        with self._lock:
            self._stopped |= asked
            if self._process is not None and self._process.poll() is None:
                self._process.kill()

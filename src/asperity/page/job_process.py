"""What runs in the process of a job: one study or one measurement, its progress and its result as lines of JSON.

The request arrives as the first line of the standard input, which then stays open: when it closes, because the page
stopped the job or the server ended in whatever way, the process ends at once.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import sys
import threading
import traceback
from collections.abc import Callable

from asperity.errors import AsperityError, NoSolutionError, printable
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.types import Document

#: Called with what is done and with all that is to be done.
Report = Callable[[int, int], None]
#: Kind of a job → the module that has the function of that name; it is imported only when such a job runs.
_MODULES = {
    "film": "film_job",
    "wear": "wear_job",
    "accuracy": "accuracy_job",
    "window": "window_job",
    "sensitivity": "study_jobs",
    "uncertainty": "study_jobs",
    "design": "study_jobs",
    "measure": "measurement_job",
}


def main() -> None:
    """Run the job of the standard input."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # whatever a package prints must not mix with the answers
    # nothing is imported from the job's folder
    sys.path[:] = [os.path.abspath(path) for path in sys.path if path]
    request = json.loads(sys.stdin.readline())
    threading.Thread(target=_end_with_the_page, daemon=True).start()
    with contextlib.suppress(OSError, AttributeError):
        os.nice(5)  # the sliders come first
    os.chdir(request["folder"])

    def tell(answer: Document) -> None:
        print(json.dumps(answer, allow_nan=False), file=answers, flush=True)

    try:
        result = run_job(request, lambda done, total: tell({"done": done, "total": total}))
        tell({"result": result})
    except AsperityError as error:
        kind = "no_solution" if isinstance(error, NoSolutionError) else "input"
        tell({"error": str(error), "kind": kind})
    except MemoryError:
        tell({"error": "this needs more memory than is allowed here", "kind": "input"})
    except Exception as error:  # a mistake of ours or of a reader: say so rather than nothing
        traceback.print_exc()
        said = printable(f"{type(error).__name__}: {error}")[:300]
        tell({"error": f"the computation failed unexpectedly: {said}", "kind": "input"})
    answers.flush()
    os._exit(0)


def _end_with_the_page() -> None:
    sys.stdin.read()
    os._exit(1)


def run_job(request: Document, report: Report) -> Document:
    """Run one job."""
    use_double_precision()
    use_compilation_cache()
    kind = request["kind"]
    jobs = importlib.import_module(f"asperity.page.{_MODULES[kind]}")
    return getattr(jobs, kind)(request["file"], request["options"], report)

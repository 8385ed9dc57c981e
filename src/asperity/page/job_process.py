"""What runs in the process of a job: one study or one measurement, its progress and its result as lines of JSON.

The request arrives as the first line of the standard input, which then stays open: when it closes, because the page
stopped the job or the server ended in whatever way, the process ends at once.
"""

from __future__ import annotations

import contextlib
import json
import os
import sys
import threading
import traceback
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    pass

#: Called with what is done and with all that is to be done.
Report = Callable[[int, int], Any]
#: Address space of a measurement [byte]: a file that unpacks into more ends with an error.
MOST_MEMORY = 8 * 1024**3
#: Samples after which an uncertainty reports its progress.
BLOCK = 256


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

    def tell(answer: dict[str, Any]) -> None:
        print(json.dumps(answer, allow_nan=False), file=answers, flush=True)

    from asperity.errors import AsperityError, NoSolutionError, printable

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


def run_job(request: dict[str, Any], report: Report) -> dict[str, Any]:
    """Run one job."""
    from asperity.precision import use_compilation_cache, use_double_precision

    use_double_precision()
    use_compilation_cache()
    jobs = {"sensitivity": _sensitivity, "uncertainty": _uncertainty, "design": _design, "measure": _measure}
    return jobs[request["kind"]](request["file"], request["options"], report)


def _sensitivity(file: str, options: dict[str, Any], report: Report) -> dict[str, Any]:
    from asperity.joint_file.reader import read_case
    from asperity.study.tolerances.documents import sensitivity_document
    from asperity.study.tolerances.sensitivity import sensitivity
    from asperity.views.blocks import block_documents
    from asperity.views.tolerances import elasticities

    dataset = sensitivity(read_case(file))
    views = {
        name: block_documents(elasticities(dataset, (name,))) for name in dataset["result"].values.tolist()
    }
    return sensitivity_document(dataset) | {"views": views}


def _uncertainty(file: str, options: dict[str, Any], report: Report) -> dict[str, Any]:
    from asperity.joint_file.quantity_key import parse_distribution
    from asperity.joint_file.reader import read_case
    from asperity.study.tolerances.documents import uncertainty_document
    from asperity.study.tolerances.uncertainty import uncertainty
    from asperity.views.blocks import block_documents
    from asperity.views.tolerances import intervals, variance_shares

    stated = options.get("distribution")
    dataset = uncertainty(
        read_case(file),
        distribution=parse_distribution(stated) if stated else None,
        samples=options["samples"],
        seed=options["seed"],
        block=BLOCK,
        report=report,
    )
    first = dataset["result"].values.tolist()[:1]
    return uncertainty_document(dataset) | {
        "views": block_documents([*intervals(dataset), *variance_shares(dataset, first)])
    }


def _design(file: str, options: dict[str, Any], report: Report) -> dict[str, Any]:
    from asperity.errors import InputError
    from asperity.joint_file.edited_text import with_measurement
    from asperity.page.joint_request import MEASUREMENT_FILE
    from asperity.study.design.design import design
    from asperity.study.design.design_file import read_design
    from asperity.study.design.design_result import design_document, shortcoming
    from asperity.views.blocks import block_documents
    from asperity.views.design import design as designed
    from asperity.views.design import design_warnings

    problem = read_design(file)
    if len(problem.objectives) > 1:
        raise InputError(
            f"{file}: the page designs for one objective; 'asperity design' makes a front of several"
        )
    result = design(problem, progress=report)
    text = result.joint_text
    if problem.case.measured is not None:  # in a folder that is gone when the page shows it
        text = with_measurement(text, MEASUREMENT_FILE)
    document = {**design_document(result), "conflict": shortcoming(result) or None, "joint_text": text}
    return document | {"views": block_documents([*designed(result), *design_warnings(result)])}


def _measure(file: str, options: dict[str, Any], report: Report) -> dict[str, Any]:
    from asperity.surface.height_spectrum import with_lay
    from asperity.surface.measure_files import files_document, measured_files
    from asperity.surface.measured_roughness import measurement_of, read_roughness, roughness_document

    lay, of = options.get("lay"), options.get("measurement_of")
    if options.get("document"):
        roughness = measurement_of(read_roughness(path=file), of)
        spectra = (one if one.is_map or one.lay else with_lay(one, lay) for one in roughness.spectra)
        return roughness_document(replace(roughness, spectra=tuple(spectra)))
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    left_out = ("start", "stop", "form", "degree", "outlier_threshold", "short_cutoff", "long_cutoff")
    measured = measured_files(
        [file],
        position_unit=options.get("position_unit"),
        height_unit=options.get("height_unit"),
        spacing=options.get("spacing"),
        decimal=options.get("decimal") or "auto",
        column=options.get("column"),
        no_data=options.get("no_data"),
        any_size=False,
        missing=options.get("missing", "refuse"),
        direction=options.get("direction", "x"),
        lay=lay,
        estimator="automatic",
        frequency_ratio=1.5,
        shortest_wavelength=None,
        longest_wavelength=None,
        **dict.fromkeys(left_out),
    )
    return files_document(measured) | {"measurement_of": measurement_of(measured.roughness, of).of}

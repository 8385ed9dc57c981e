"""The studies that the page runs as jobs: each takes the joint or design file of its folder, and gives its document."""

from __future__ import annotations

from asperity.errors import InputError
from asperity.joint_file.edited_text import with_measurement
from asperity.joint_file.quantity_key import parse_distribution
from asperity.joint_file.reader import read_case
from asperity.page.job_process import Report
from asperity.page.joint_request import MEASUREMENT_FILE
from asperity.study.design.design import design as search
from asperity.study.design.design_file import read_design
from asperity.study.design.design_result import design_document, shortcoming
from asperity.study.tolerances.documents import sensitivity_document, uncertainty_document
from asperity.study.tolerances.sensitivity import sensitivity as differentiate
from asperity.study.tolerances.uncertainty import uncertainty as propagate
from asperity.types import Document
from asperity.views.blocks import block_documents
from asperity.views.design import design as designed
from asperity.views.design import design_warnings
from asperity.views.tolerances import elasticities, intervals, variance_shares

#: Samples after which an uncertainty reports its progress.
BLOCK = 256


def sensitivity(file: str, options: Document, report: Report) -> Document:
    """Elasticities of every result by every number of a joint file, and a view of each."""
    dataset = differentiate(read_case(file))
    views = {
        name: block_documents(elasticities(dataset, (name,))) for name in dataset["result"].values.tolist()
    }
    return sensitivity_document(dataset) | {"views": views}


def uncertainty(file: str, options: Document, report: Report) -> Document:
    """Intervals of the results from the tolerances of a joint file, and the share of each tolerance in the first."""
    stated = options.get("distribution")
    dataset = propagate(
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


def design(file: str, options: Document, report: Report) -> Document:
    """The design that a design file asks for, of one objective."""
    problem = read_design(file)
    if len(problem.objectives) > 1:
        raise InputError(
            f"{file}: the page designs for one objective; 'asperity design' makes a front of several"
        )
    result = search(problem, progress=report)
    text = result.joint_text
    if problem.case.measured is not None:  # in a folder that is gone when the page shows it
        text = with_measurement(text, MEASUREMENT_FILE)
    document = {**design_document(result), "conflict": shortcoming(result) or None, "joint_text": text}
    return document | {"views": block_documents([*designed(result), *design_warnings(result)])}

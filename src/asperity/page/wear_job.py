"""Wear of a joint over the years as a job of the page: its document, of which the page draws the curves, and a view."""

from __future__ import annotations

from asperity.joint_file.reader import read_case
from asperity.joint_file.wear import wear_of_case
from asperity.page.job_process import Report
from asperity.results.wear_document import wear_document
from asperity.types import Document
from asperity.views.blocks import block_documents
from asperity.views.wear import wear as wear_shown


def wear(file: str, options: Document, report: Report) -> Document:
    """Wear under the torque or the duty of a joint, over the required life of its file."""
    document = wear_document(wear_of_case(read_case(file)))
    return document | {"views": block_documents(list(wear_shown(document)))}

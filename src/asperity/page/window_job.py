"""The window of a joint as a job of the page: its document, and a view with the picture."""

from __future__ import annotations

from asperity.joint_file.reader import read_case
from asperity.joint_file.window import joint_window
from asperity.page.job_process import Report
from asperity.report.figures import figure_svg
from asperity.results.window_document import window_document
from asperity.show.window_figure import window_figure
from asperity.types import Document
from asperity.views.blocks import Picture, block_documents
from asperity.views.window import window as window_shown


def window(file: str, options: Document, report: Report) -> Document:
    """The torques that a joint may pass, with the picture as the first block of its view."""
    found = joint_window(read_case(file), over=options.get("over"), report=report)
    document = window_document(found)
    verdict, *further = window_shown(document)
    picture = Picture("Torques that the joint may pass", figure_svg(window_figure(found, title="")))
    return document | {"views": block_documents([verdict, picture, *further])}

"""The oil in the contacts of a joint as a job of the page: its document, and a view with the picture."""

from __future__ import annotations

from asperity.joint_file.film import joint_film
from asperity.joint_file.reader import read_case
from asperity.page.job_process import Report
from asperity.report.figures import figure_svg
from asperity.results.film_document import film_document
from asperity.show.film_figure import film_figure
from asperity.types import Document
from asperity.views.blocks import Picture, block_documents
from asperity.views.film import film as film_shown


def film(file: str, options: Document, report: Report) -> Document:
    """Film, asperities and traction over speed, with the picture as the first block of its view."""
    found = joint_film(read_case(file), report=report)
    document = film_document(found)
    picture = Picture("Traction and asperities over speed", figure_svg(film_figure(found, title="")))
    return document | {"views": block_documents([picture, *film_shown(document)])}

"""Sections of a report on what years and turns do to a joint: wear, and accuracy, where its file has them."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.errors import AsperityError
from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.si_tables import AnyCase
from asperity.joint_file.wear import wear_of_case
from asperity.report.figures import figure_svg
from asperity.results.accuracy_document import accuracy_document
from asperity.results.wear_document import wear_document
from asperity.show.accuracy_figure import accuracy_figure
from asperity.show.wear_figure import wear_figure
from asperity.views.accuracy import accuracy
from asperity.views.blocks import Block, Heading, Paragraph, Picture
from asperity.views.wear import wear

_WIDTH = 9.0  # of a picture, which a page shows smaller [in]


def wear_section(case: AnyCase) -> Iterator[Block]:
    """Wear over the required life, of a file with a section ``[wear]``."""
    if case.wear is None:
        return
    yield Heading("Wear over the years")
    try:
        found = wear_of_case(case)
    except AsperityError as error:
        yield Paragraph(f"Not known: {error}.")
        return
    first, *others = wear(wear_document(found))
    yield first
    if found.wear.course is not None:
        yield Picture(
            "Preload, torque of the first slide and drift over time",
            figure_svg(wear_figure(found, title="", width=_WIDTH)),
        )
    yield from others


def accuracy_section(case: AnyCase) -> Iterator[Block]:
    """Transmission error, forces and input torque over a turn, of a file with sections ``[[form]]``."""
    if case.form is None:
        return
    yield Heading("Accuracy over a turn")
    try:
        found = joint_accuracy(case)
    except AsperityError as error:
        yield Paragraph(f"Not known: {error}.")
        return
    first, *others = accuracy(accuracy_document(found))
    yield first
    yield Picture(
        "Orders of the transmission error, and one turn of the output",
        figure_svg(accuracy_figure(found, title="", width=_WIDTH)),
    )
    yield from others

"""Tables and sentences of what is shown, and cells as numbers."""

import math

import pytest

from asperity.views.blocks import Bullets, Paragraph, Table
from asperity.views.solved_view import SolvedView

ARCMINUTE = math.pi / 10800.0
#: Three branches of a planetary drive of their own sizes, for the end of its file.
UNLIKE = "".join(f'\n[[branch]]\nplanet_deviation = "{size} um"\n' for size in (3, 0, -2))


def with_document(view, **changes):
    """The same joint with changed entries of its document."""
    return SolvedView(view.solved, view.document | changes)


def tables(blocks):
    """Tables by their titles."""
    return {block.title: block for block in blocks if isinstance(block, Table)}


def cells(table):
    """Rows of a table by their first cell."""
    found = {row[0]: row[1:] for row in table.rows}
    assert len(found) == len(table.rows)
    return found


def sentences(blocks):
    """All paragraphs and bullets."""
    return [
        text
        for block in blocks
        if isinstance(block, Paragraph | Bullets)
        for text in ([block.text] if isinstance(block, Paragraph) else block.items)
    ]


def amount(cell):
    """The number with which a cell begins."""
    return float(cell.split()[0])


def four(number):
    """A number as four digits show it."""
    return pytest.approx(number, rel=6e-4)

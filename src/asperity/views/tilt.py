"""What tilted axes do to contacts: their angles, the loads along their lines, and what pushes sideways."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.types import Document
from asperity.views.blocks import Block, Bullets, Paragraph, Table
from asperity.views.numbers import number, quantity, words

_STATES = {"as_stated": "as stated", "in_any_direction": "in the worst direction for each number"}
_HEAD = (
    "contact",
    "slope\nmrad",
    "skew\nmrad",
    "peak load\nover mean",
    "load at end\nover mean",
    "peak pressure\nMPa",
    "sideways\nover friction",
)


def tilt(document: Document) -> Iterator[Block]:
    """The contacts of the entry ``tilt`` of a document of loads, and what they leave out."""
    axes = ", ".join(
        f"{words(name)} {quantity(slopes['out_rad'], 'mrad')} out and {quantity(slopes['across_rad'], 'mrad')} across"
        for name, slopes in document["axes"].items()
    )
    if document["unknown_because"]:
        yield Paragraph(f"Tilted axes ({axes}): {document['unknown_because']}.")
        return
    for state, title in _STATES.items():
        rows = [(words(name), *_row(contact[state])) for name, contact in document["contacts"].items()]
        yield Table(f"Tilted axes, {title}: {axes}", _HEAD, rows)
    yield Bullets(document["notes"])


def _row(line: Document) -> Iterator[str]:
    """The cells of a contact behind its name."""
    yield number(line["slope_rad"], 1e3)
    yield number(line["skew_rad"], 1e3)
    yield number(line["peak_over_mean"])
    yield number(line["end_over_mean"])
    yield "edge" if line["edge"] else number(line["peak_pressure_Pa"], 1e-6)
    yield number(line["sideways_over_friction"])

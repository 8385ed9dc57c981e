"""The drawing of a drive: its view to scale, its sizes and clearances, and the forces on request."""

from __future__ import annotations

from collections.abc import Callable

import asperity
from asperity.errors import printable
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointForces
from asperity.show.sheet import (
    TITLE_HEIGHT,
    Item,
    Line,
    Point,
    Text,
    scale_text,
)
from asperity.units import format_quantity

#: From the edge of the paper to the frame of a drawing [mm].
MARGIN = 10.0
_LONGEST_TITLE = 42
#: Size of the paper, room of the view, and left edge of the column beside it, all in mm: A4 and A3.
PLAIN, WITH_FORCES = (297.0, 210.0, 150.0, 195.0), (420.0, 297.0, 220.0, 270.0)


def frame(on_paper: Callable[[float, float], Point], width: float, height: float) -> Item:
    """The frame of a sheet of paper."""
    right, top = width - MARGIN, height - MARGIN
    corners = ((MARGIN, MARGIN), (right, MARGIN), (right, top), (MARGIN, top), (MARGIN, MARGIN))
    return Line(tuple(on_paper(*corner) for corner in corners), "frame")


def title_block(
    on_paper: Callable[[float, float], Point],
    column: float,
    width: float,
    name: str,
    scale: float,
    *,
    kind: str = "Planetary traction drive",
) -> list[Item]:
    """What a drawing is called, its scale and unit, in the lower right corner."""
    title = printable(name).replace("\n", " ")
    shown = title if len(title) <= _LONGEST_TITLE else f"…{title[1 - _LONGEST_TITLE :]}"
    top, left = MARGIN + 22.0, column - 3.0
    edge = (on_paper(left, MARGIN), on_paper(left, top), on_paper(width - MARGIN, top))
    return [
        Line(edge, "frame"),
        Text(on_paper(column, top - 6.5), kind, height=TITLE_HEIGHT),
        Text(on_paper(column, top - 12.5), shown),
        Text(
            on_paper(column, top - 18.5),
            f"Scale {scale_text(scale)}   dimensions in mm   asperity {asperity.__version__}",
        ),
    ]


def load_lines(joint: Joint, forces: JointForces, *, part: str) -> list[str]:
    """What stands beside bodies that are drawn apart."""
    entry, out = (name.replace("_", " ") for name in joint.ends)
    return [
        f"Forces on the bodies of one {part}, drawn apart, without centrifugal forces.",
        "Arrows show directions, not sizes.",
        f"Torque at the {entry} {format_quantity(float(forces.input_torque), 'N*m')}, "
        f"at the {out} {format_quantity(float(forces.output_torque), 'N*m')}.",
    ]

"""A drawing as a DXF file: true sizes in mm, on layers that CAD programs can switch."""

from __future__ import annotations

import io
import math
import re
from collections.abc import Container, Iterable
from typing import TYPE_CHECKING, Any

from asperity.extras import optional_module
from asperity.made_files import MARK
from asperity.show.sheet import ARROW_LENGTH, LINE_WIDTHS, Circle, Dimension, Item, Line, Sheet, Style, Text
from asperity.show.sheet_figure import arrowheads

if TYPE_CHECKING:
    import types

#: Kind of line → layer.
LAYERS: dict[Style, str] = {
    "outline": "OUTLINE",
    "thin": "DIMENSIONS",
    "axis": "AXES",
    "break": "BREAK",
    "force": "FORCES",
    "frame": "FRAME",
}
_TEXT_LAYER = "TEXT"
_ALIGNED, _DIAMETER = 1, 3  # kinds of DIMENSION entities
_VIEW = 1.05  # size of what a CAD program shows first, over that of the sheet
_WINDOW = 4.0 / 3.0  # width of the window of that program over its height; most are wider
_BLACK = 7  # black on white, white on black
_CODES = {"⌀": "%%c", "°": "%%d", "±": "%%p"}


def require_ezdxf() -> types.ModuleType:
    """The package ezdxf."""
    return optional_module("ezdxf", extra="report", needs="a DXF file needs")


def sheet_dxf(sheet: Sheet) -> str:
    """Write a sheet as DXF, the same text for the same sheet."""
    ezdxf = require_ezdxf()
    fixed, ezdxf.options.write_fixed_meta_data_for_testing = (
        ezdxf.options.write_fixed_meta_data_for_testing,
        True,  # no date and no random identifiers
    )
    try:
        document = ezdxf.new("R2010", units=ezdxf.units.MM)
        document.linetypes.add("CENTER", pattern=[4.0, 2.5, -0.5, 0.5, -0.5], description="Center")
        for style, layer in LAYERS.items():
            document.layers.add(
                layer,
                color=_BLACK,
                lineweight=round(100.0 * LINE_WIDTHS[style]),
                linetype="CENTER" if style == "axis" else "CONTINUOUS",
            )
        document.layers.add(_TEXT_LAYER, color=_BLACK, lineweight=18)
        document.header.custom_vars.append("Generator", MARK)
        document.header["$LTSCALE"] = 4.0 / sheet.scale
        _show_paper(document, sheet)
        space = document.modelspace()
        _draw(space, sheet.items, sheet.scale, {item for of in sheet.dimensions for item in of.items})
        for dimension in sheet.dimensions:
            _dimension(document, dimension, sheet.scale)
        target = io.StringIO()
        document.write(target)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = fixed
    return target.getvalue()


def _show_paper(document: Any, sheet: Sheet) -> None:
    """State the extents of the drawing, those of its paper, and open it with the whole sheet in view."""
    left, right, low, high = sheet.window
    document.header["$EXTMIN"], document.header["$EXTMAX"] = (left, low, 0.0), (right, high, 0.0)
    document.header["$LIMMIN"], document.header["$LIMMAX"] = (left, low), (right, high)
    document.modelspace().reset_extents((left, low, 0.0), (right, high, 0.0))
    document.modelspace().reset_limits((left, low), (right, high))
    view = document.set_modelspace_vport(
        height=_VIEW * max(high - low, (right - left) / _WINDOW),
        center=(0.5 * (left + right), 0.5 * (low + high)),
    )
    view.dxf.aspect_ratio = _WINDOW


def _dimension(document: Any, dimension: Dimension, scale: float) -> None:
    """A DIMENSION between its ends, whose block looks as the sheet does in other formats."""
    block = document.blocks.new_anonymous_block(type_char="D")
    _draw(block, dimension.items, scale, frozenset())
    (x, y), (u, v) = dimension.ends
    text = dimension.items[-1]
    assert isinstance(text, Text)
    across = next(
        item for item in dimension.items if isinstance(item, Line) and (item.arrows or item.style == "break")
    )
    places = (
        {"defpoint": (u, v), "defpoint4": (x, y)}
        if dimension.diameter
        else {"defpoint": across.points[-1], "defpoint2": (x, y), "defpoint3": (u, v)}
    )
    document.modelspace().new_entity(
        "DIMENSION",
        dxfattribs={
            "layer": LAYERS["thin"],
            "geometry": block.name,
            "dimstyle": "Standard",
            "dimtype": 32 + (_DIAMETER if dimension.diameter else _ALIGNED),
            "text": dxf_text(text.text),
            "text_midpoint": text.at,
            "actual_measurement": math.dist(*dimension.ends),
            **places,
        },
    )


def _draw(space: Any, items: Iterable[Item], scale: float, elsewhere: Container[Item]) -> None:
    """Items that do not stand elsewhere."""
    from ezdxf.enums import TextEntityAlignment

    for item in items:
        if item in elsewhere:
            continue
        if isinstance(item, Text):
            aligned = TextEntityAlignment[item.align.upper()]
            entity = space.add_text(
                dxf_text(item.text), height=item.height / scale, dxfattribs={"layer": _TEXT_LAYER}
            )
            entity.set_placement(item.at, align=aligned)
            continue
        layer = {"layer": LAYERS[item.style]}
        if isinstance(item, Circle):
            space.add_circle(item.centre, item.radius, dxfattribs=layer)
            continue
        space.add_lwpolyline(item.points, dxfattribs=layer)
        for tip, one, other in arrowheads(item, length=ARROW_LENGTH / scale):
            space.add_solid([tip, one, other, other], dxfattribs=layer)


def dxf_text(text: str) -> str:
    """A text as DXF writes it: codes for the diameter, degrees and plus-minus; codes of the text itself undone."""
    plain = re.sub("%(?=%)", "% ", text).replace("^", "^ ")
    for character, code in _CODES.items():
        plain = plain.replace(character, code)
    return plain

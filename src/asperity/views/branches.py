"""What unequal branches do to a joint."""

from __future__ import annotations

import math
from collections.abc import Iterator

from asperity.results.branch_document import deviations, force_size
from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import number, quantity, words


def branches(unequal: Document) -> Iterator[Block]:
    """Sizes, preloads and shares of the branches, and the forces on the axis, from the document of unequal branches."""
    states, names = (unequal["standing"], unequal["rolling"]), deviations(unequal)

    def of(state: Document | None, name: str, index: int, factor: float = 1.0) -> str:
        return number(None if state is None else state[name][index], factor)

    yield Table(
        "Branches by their own sizes",
        (
            unequal["branch_is"],
            *(f"{name}\ndeviation µm" for name in names.values()),
            "interference\nµm",
            "preload\nN",
            "share\nstanding %",
            "share\nrolling %",
            "slip\nstanding -",
            "slip\nrolling -",
        ),
        [
            (
                str(index + 1),
                *(number(entry[key], 1e6) for key in names),
                number(entry["interference_m"], 1e6),
                number(entry["preload_N"]),
                *(of(state, "share", index, 100.0) for state in states),
                *(of(state, "slip_ratio", index) for state in states),
            )
            for index, entry in enumerate(unequal["branches"])
        ],
    )
    yield Paragraph(unequal["note"])
    yield _axis(unequal)


def _axis(unequal: Document) -> Table:
    """Forces on the members on the axis, and where the sun is."""
    state = unequal["standing"] or unequal["without_torque"]
    when = "standing" if unequal["standing"] else "without torque"
    sun = state["sun"]
    rows = [(f"force on the bearings of the sun, {when}", quantity(force_size(unequal, sun["force_N"]), "N"))]
    if unequal["sun_support_stiffness_N_per_m"] is not None:
        rows.append((f"displacement of the sun, {when}", quantity(math.hypot(*sun["displacement_m"]), "um")))
    rows += [
        (f"force on the {words(name)}, {when}", quantity(force_size(unequal, force), "N"))
        for name, force in state.get("central_forces_N", {}).items()
    ]
    return Table("Forces on the axis with unequal branches", ("quantity", "value"), rows)

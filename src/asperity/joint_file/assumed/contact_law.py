"""What the contact law takes of the surfaces."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.contact.laws.registry import LAWS
from asperity.joint_file.assumed.described import Described
from asperity.joint_file.drawn_surface import surfaces_by_average


def open_dimension(file: Described) -> Iterator[str]:
    """The D that Ra leaves open, where the law takes it."""
    case, _ = file
    if "fractal_dimension" not in LAWS[case.contact_law()].needs:
        return
    ranged = {
        entry.fractal_dimension.tolerance > 0.0
        for entry in surfaces_by_average(case).values()
        if entry.fractal_dimension
    }
    for which, some in (
        ("middle of its range", True),
        ("value in the file, which Ra does not confirm", False),
    ):
        if some in ranged:
            yield (
                f"roughness_average: Ra leaves D open, and all results are those of the {which}; 'asperity joint' "
                "gives the interval of stiffness and drift"
            )


def law(file: Described) -> Iterator[str]:
    """Which law it is, and what it says."""
    case, _ = file
    stated = LAWS[case.contact_law()]
    if case.model.contact_law is None:
        yield f"contact law {stated.name}, since the file does not state model.contact_law: {stated.meaning}"
    yield from stated.assumes
    if stated.assumes_of_average and surfaces_by_average(case):
        yield stated.assumes_of_average


def in_rolling(file: Described) -> str:
    """What the law adds to the sentence of the model of rolling; empty where it has nothing to add."""
    return LAWS[file.case.contact_law()].in_rolling

"""What the contact law takes of the surfaces."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint_file.assumed.described import Described
from asperity.joint_file.drawn_surface import surfaces_by_average
from asperity.joint_file.material_entries import BY_DECAY_LENGTH

_LAWS = {
    "zou_2025": "the published law, from the D and G of the surfaces",
    "exponential": "the law of randomly rough elastic surfaces, from the rms of their heights",
    "measured": "that of randomly rough elastic surfaces, from their decay_length",
    "persson_2007": "that of randomly rough elastic surfaces, from their spectrum",
}


def open_dimension(file: Described) -> Iterator[str]:
    """The D that Ra leaves open, where the law takes it."""
    case, _ = file
    if case.contact_law() != "zou_2025":
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
    name = case.contact_law()
    if case.model.contact_law is None:
        yield f"contact law {name}, since the file does not state model.contact_law: {_LAWS[name]}"
    if name in BY_DECAY_LENGTH:
        yield (
            f"contact law {name}: K_n = f N/u with the decay_length u of each contact at every force, f from 1 to 2 "
            "because contacts widen under load, K_t proportional to 1 - T/(mu N)"
        )
    if name == "exponential":
        yield (
            "contact law exponential: randomly rough elastic surfaces, K_n = f N/(0.48 h), f from 1 to 2 because "
            "contacts widen under load, K_t proportional to 1 - T/(mu N), h the rms height of both bodies together; h "
            "counts waves shorter than the contact is wide, and along the axes up to the roll-off: longer ones make "
            "the joint look softer"
        )
        if surfaces_by_average(case):
            yield (
                "contact law exponential with roughness_average: normally distributed heights, h = 1.2533 Ra of both "
                "bodies together; D has no influence, and waves longer than the cut-off of Ra are not included"
            )


def in_rolling(file: Described) -> str:
    """What the model of rolling takes of the law, behind its sentence; empty where the law states it."""
    return (
        ": the local form of the contact law is not published"
        if file.case.contact_law() == "zou_2025"
        else ""
    )

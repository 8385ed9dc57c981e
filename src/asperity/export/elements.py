"""Parallel elasto-plastic elements for programs that have them, and how well they stand for the wind-up."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from asperity.errors import InputError
from asperity.export.content import ExportContent
from asperity.standing.parallel_elements import ParallelElements, fit_error, parallel_elements
from asperity.standing.series_law import SeriesLaw
from asperity.units import format_quantity

#: What the loop is worth, for every model that has one.
MASING = (
    "The loop itself is an estimate by Masing's rule, which has an error of its own: for the joint of "
    "Zou et al. 2025 1 to 15 % of the loop's width, up to half of it with a constant pin force."
)
#: Elasto-plastic elements in an exported model.
ELEMENTS = 8


@dataclass(frozen=True)
class FittedElements:
    """A reversible spring and elasto-plastic elements of a joint's wind-up, and how well they follow it, in sentences.

    ``linear_stiffness`` is that of the straight line between both ends of the wind-up [N·m/rad].
    """

    elements: ParallelElements
    linear_stiffness: float
    sentences: tuple[str, ...]


def fitted_elements(content: ExportContent, *, program: str) -> FittedElements:
    """Fit elements to what is exported."""
    if float(content.play.angle) > 0.0:
        raise InputError(
            f"the joint has a play of {format_quantity(float(content.play.angle), 'arcmin')}, in series with its "
            f"springs; the parallel springs of {program} cannot carry it. Remove [play] from the joint file and add "
            "the play in the model, or export to an FMU or a table"
        )
    law = SeriesLaw(content.windup, content.play)
    elements = parallel_elements(law, elements=ELEMENTS)
    error = fit_error(law, elements)
    windup = float(np.max(np.abs(np.asarray(content.windup.angle))))
    width = float(content.windup.hysteresis)
    sentence = (
        f"{elements.stiffness.size} elasto-plastic elements and a spring follow the wind-up within "
        f"{format_quantity(error.angle, 'arcsec', 2)}, {100.0 * error.angle / windup:.2g} % of the wind-up"
    )
    if elements.stiffness.size:
        sentence += (
            f" and {_share(error.angle / width)} the width of its loop at zero torque; the width itself is "
            f"off by up to {100.0 * error.loop_width / width:.2g} %"
        )
    said = [sentence + " (first loading both ways, loops of the largest torque and of half of it).", MASING]
    if error.angle > width > 0.0:
        said.insert(1, "These springs miss the curve by more than its loop is wide; an FMU follows both.")
    ends = np.asarray(content.windup.angle)[[0, -1]]
    return FittedElements(elements, 2.0 * content.largest_torque / float(np.ptp(ends)), tuple(said))


def _share(ratio: float) -> str:
    return f"{100.0 * ratio:.2g} % of" if ratio < 1.0 else f"{ratio:.2g} times"

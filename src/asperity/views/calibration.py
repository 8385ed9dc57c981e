"""What a calibration found: estimates with their intervals, how well the data determine them, and the posterior."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from asperity.study.calibration.calibrate import (
    Calibration,
    bound_words,
    count_words,
    estimate_note,
    identifiability_words,
    model_error_words,
)
from asperity.study.calibration.fitted_curve import residual_sentences
from asperity.study.calibration.posterior import Posterior
from asperity.study.calibration.unknowns import unit_of
from asperity.units import format_quantity
from asperity.views.blocks import Block, Bullets, Paragraph, Table
from asperity.views.numbers import NONE


def calibration(found: Calibration) -> Iterator[Block]:
    """Estimates, residuals, and which combinations of the unknowns the data leave open."""
    rows = []
    for estimate in found.estimates:
        unit = unit_of(estimate.path)
        digits = interval_digits(estimate.scatter_lower, estimate.scatter_upper)
        ends = [
            format_quantity(value, unit, digits) if estimate.determined else NONE
            for value in (estimate.lower, estimate.upper, estimate.scatter_lower, estimate.scatter_upper)
        ]
        value = NONE if estimate.at_bound else format_quantity(estimate.value, unit, max(digits, 5))
        rows.append((estimate.path, value, *ends, estimate_note(estimate)))
    head = ("unknown", "estimate", "95 % from", "to", "by scatter", "to", "")
    yield Table(count_words(found), head, rows, words=(0, 6))
    for sentence in (*bound_words(found).values(), *residual_sentences(found.curves)):
        yield Paragraph(sentence)
    yield Paragraph(model_error_words(found.model_error))
    for heading, sentences in identifiability_words(found).items():
        yield Paragraph(heading)
        yield Bullets(sentences)


def posterior(drawn: Posterior, found: Calibration) -> Iterator[Block]:
    """Quantiles of the draws from the posterior of the unknowns."""
    title = f"Posterior, {len(drawn.scaled_values)} draws, {drawn.divergences} divergent, R-hat {drawn.r_hat.max():.3f}"
    rows = []
    for i, unknown in enumerate(found.unknowns):
        values = quantiles(unknown.from_unit(drawn.scaled_values[:, i])).values()
        shown = [format_quantity(value, unit_of(unknown.path)) for value in values]
        rows.append((unknown.path, *shown, f"{drawn.effective_draws[i]:.0f}"))
    unit = found.curves[0].measurement.quantity.fine_unit
    shown = [format_quantity(value, unit) for value in quantiles(drawn.standard_deviation).values()]
    rows.append(("size of errors", *shown, f"{drawn.effective_draws[-1]:.0f}"))
    yield Table(title, ("unknown", "2.5 %", "median", "97.5 %", "effective draws"), rows)
    for i, unknown in enumerate(found.unknowns):
        if note := drawn.note(i):
            yield Paragraph(f"{unknown.path}: {note}, so that the bounds determine the interval.")
    yield Paragraph(
        f"The joint itself accepted {100.0 * drawn.acceptance:.3g} % of the proposals; the draws of the scatter follow "
        "the exact posterior; a low share only makes fewer of them independent."
    )


def quantiles(values: np.ndarray) -> Mapping[str, float]:
    """Quantiles of draws at 2.5 %, 50 % and 97.5 %, by their shares as text."""
    return {str(q): float(np.quantile(values, q)) for q in (0.025, 0.5, 0.975)}


def interval_digits(lower: float, upper: float) -> int:
    """Significant digits with which both ends of an interval show its width to two digits; four at least."""
    width, size = upper - lower, max(abs(lower), abs(upper))
    if not (math.isfinite(width) and width > 0.0):
        return 4
    return min(max(4, 2 + math.ceil(math.log10(size / width))), 15)

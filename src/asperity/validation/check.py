"""One comparison of a computed number with a reference."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from asperity.types import Document


@dataclass(frozen=True, slots=True)
class Check:
    """A computed quantity, its reference, and whether they agree.

    ``model``: what is checked; ``reference``: where the expected value comes from. Of several ``values``, ``expected``
    and ``computed`` [unit] are the pair that differs most; the unit is "-" for a ratio. ``deviation``: relative
    difference [-], or the difference itself where the tolerance is absolute [unit]; nan if nothing was found, and
    ``note`` says why.
    """

    model: str
    reference: str
    quantity: str
    unit: str
    expected: float
    computed: float
    deviation: float
    tolerance: float
    absolute: bool
    values: int
    note: str = ""

    @property
    def passed(self) -> bool:
        """Whether the deviation is within the tolerance; nan is not."""
        return self.deviation <= self.tolerance

    def as_dict(self) -> Document:
        """The fields for JSON, ``computed`` as "found", and ``passed``; numbers that are not finite are None."""
        fields = {"found" if name == "computed" else name: getattr(self, name) for name in self.__slots__}
        for name in ("expected", "found", "deviation"):
            if not math.isfinite(fields[name]):
                fields[name] = None
        return fields | {"passed": self.passed}


def compared(
    *,
    model: str,
    reference: str,
    quantity: str,
    unit: str,
    expected: ArrayLike,
    computed: ArrayLike,
    tolerance: float,
    absolute: bool = False,
) -> Check:
    """Compare computed values with a reference, of one shape [unit]; of several values the worst pair is kept.

    An expected zero is met, relatively, by an exact zero only. A ``ValueError`` is raised if the shapes differ.
    """
    expected_values, computed_values = (
        np.atleast_1d(np.asarray(values, dtype=float)).ravel() for values in (expected, computed)
    )
    if expected_values.shape != computed_values.shape:
        raise ValueError(f"{computed_values.size} values instead of {expected_values.size}")
    difference = np.abs(computed_values - expected_values)
    if not absolute:
        size = np.abs(expected_values)
        zero = np.where(difference == 0.0, 0.0, np.inf)
        difference = np.where(size > 0.0, difference / np.where(size > 0.0, size, 1.0), zero)
    missing = np.isnan(difference)
    worst = int(np.argmax(missing)) if missing.any() else int(np.argmax(difference))
    return Check(
        model=model,
        reference=reference,
        quantity=quantity,
        unit=unit,
        expected=float(expected_values[worst]),
        computed=float(computed_values[worst]),
        deviation=float(difference[worst]),
        tolerance=tolerance,
        absolute=absolute,
        values=expected_values.size,
        note="the computed value is not a number" if missing.any() else "",
    )


def failed(model: str, error: Exception) -> Check:
    """A group of checks that ended in an error."""
    note = f"{type(error).__name__}: {error}".splitlines()[0]
    return Check(model, "", "the computation", "-", math.nan, math.nan, math.nan, 0.0, False, 0, note)

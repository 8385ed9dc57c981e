"""What boundary elements tell of a measured map: decay lengths of the pressure on patches of it, as numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
import scipy.interpolate
import scipy.special
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.types import Document

_CONFIDENCE = 0.95


@dataclass(frozen=True)
class PressedMap:
    """A map pressed on an elastic half-space, patch by patch, under rising nominal pressures.

    Lengths over the rms of the heights and pressures over the contact modulus hold for bodies of any modulus:
    ``pressure``, load over nominal area, rising, shape (loads,); ``hardness``, largest pressure of the capped states
    [-]; ``rms_height`` of each patch, a plane removed, shape (patches,) [m]; ``size`` of a patch along x and along y
    [m].

    Of shape (2, patches, loads), elastic and with no pressure above the hardness, nan where a patch is pressed flat or
    the capped pressure cannot carry the load: ``decay_ratios``, decay length p/k_n over the rms of the heights, and
    ``contact_fractions``, real over nominal area of contact [-]. ``tangential_ratios``, shape (patches, loads):
    tangential stiffness in the rolling direction over the normal one, elastic [-].
    """

    pressure: NDArray[np.float64]
    hardness: float
    rms_height: NDArray[np.float64]
    decay_ratios: NDArray[np.float64]
    contact_fractions: NDArray[np.float64]
    tangential_ratios: NDArray[np.float64]
    size: NDArray[np.float64]

    def decay_ratio(self, *, pressure: float, capped: bool) -> tuple[float, float]:
        """Decay length over the rms of the heights at a nominal pressure [-], and how well it is known.

        The pressure is over the contact modulus [-]. Geometric mean over the patches, between loads by monotone cubics,
        outside :meth:`range` the ratio of its end, as in the exponential law; ``capped``: with no pressure above the
        hardness. The second number is the half-width, of the logarithm, of the interval that holds one more patch with
        95 %, by Student's law: a contact is such a place.
        """
        known = self._known(capped)
        loads, logs = self.pressure[known], np.log(self.decay_ratios[int(capped)][:, known])
        if loads.size > 1:
            at = math.log(min(max(pressure, loads[0]), loads[-1]))
            logs = scipy.interpolate.pchip_interpolate(np.log(loads), logs, at, axis=1)
        logs = logs.ravel()
        quantile = scipy.special.stdtrit(len(logs) - 1, 0.5 * (1.0 + _CONFIDENCE))
        return math.exp(np.mean(logs)), float(
            quantile * np.std(logs, ddof=1) * math.sqrt(1.0 + 1.0 / len(logs))
        )

    def range(self, *, capped: bool) -> tuple[float, float]:
        """Smallest and largest pressure with a stiffness of every patch, over the contact modulus [-]."""
        known = self.pressure[self._known(capped)]
        return float(known[0]), float(known[-1])

    def _known(self, capped: bool) -> NDArray[np.bool_]:
        return np.asarray(np.isfinite(self.decay_ratios[int(capped)]).all(axis=0))

    def document(self) -> Document:
        """The numbers for JSON, null for those that there are not."""
        return {field.name: plain_numbers(getattr(self, field.name)) for field in fields(self)}


def plain_numbers(number: Any) -> Any:
    """Numbers for JSON, to seven digits; None for those that there are not."""
    if np.ndim(number):
        return [plain_numbers(part) for part in number]
    return float(f"{number:.7g}") if math.isfinite(number) else None


def pressed_map_from_document(entry: Any) -> PressedMap:
    """The numbers of :meth:`PressedMap.document`; an ``InputError`` if it is not such a document."""
    try:
        numbers: Document = {
            field.name: np.asarray(entry[field.name], dtype=np.float64) for field in fields(PressedMap)
        }
        made = PressedMap(**(numbers | {"hardness": float(entry["hardness"])}))
        shape = (made.rms_height.size, made.pressure.size)
        tables = (made.decay_ratios, made.contact_fractions, made.tangential_ratios)
        valid = (
            [table.shape for table in tables] == [(2, *shape), (2, *shape), shape]
            and not any((table <= 0.0).any() for table in tables)
            and made.pressure.ndim == made.rms_height.ndim == 1
            and made.size.shape == (2,)
            and shape[0] > 1
            and bool((np.diff(made.pressure, prepend=0.0) > 0.0).all())
            and made.hardness > 0.0
            and all((positive > 0.0).all() for positive in (made.rms_height, made.size))
            and bool(np.isfinite(made.decay_ratios).all(axis=1).any(axis=-1).all())
            and not any(np.isinf(number).any() for number in numbers.values())
        )
    except (KeyError, TypeError, ValueError, OverflowError):
        valid = False
    if not valid:
        raise InputError("the boundary elements of the measurement are damaged: measure again")
    return made

r"""The waves of a measured surface in bins of frequency, and the mean square of those that a contact feels.

A contact of the width 2b rolls across its lines and is long in the direction of the rollers' axis. Waves longer than
the contact in both directions move it as a whole, or press its ends unevenly; the others are its roughness:

.. math::
    h_{rms}^2 = \sum_{ij} V_{ij} \bigl[1 - s_i(1/2b)\, s_j(1/\lambda)\bigr]

with the mean square :math:`V_{ij}` of the waves of the bins i along the rolling direction and j along the axis, and the
share :math:`s(f)` of a bin that lies below the frequency f.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.pressed_map import PressedMap, pressed_map_from_document
from asperity.surface.roughness_average import RMS_OVER_RA, STANDARD_CUT_OFFS
from asperity.surface.spectrum import bin_edges, power_spectral_densities, raised_cosine
from asperity.surface.topography import Topography
from asperity.types import Document

#: Direction of the grooves of a profile, which is measured across them: those of the rolling direction, those of the
#: rollers' axis, or none.
Lay = Literal["rolling", "axis", "isotropic"]
LAYS = get_args(Lay)
#: Fewest points of a profile, or of a map in each direction, for a spectrum.
FEWEST_POINTS = 16
_BINS_PER_DECADE = {"profile": 20, "map": 10}
#: A Hann window lets neighbouring ordinates vary together: fewer of them are independent, by this factor a direction.
_HANN_LOSS = 35.0 / 18.0


@dataclass(frozen=True)
class HeightSpectrum:
    """Mean square heights of one surface in bins of frequency.

    ``rolling_edges`` and ``axial_edges``, shapes (rolling + 1,) and (axial + 1,): limits of the bins along the rolling
    direction and along the rollers' axis, rising [1/m]; both 0 in the direction in which a profile tells nothing.
    Arrays of shape (rolling, axial): ``mean_square`` of the heights of the waves of each bin [m^2], and
    ``independent``, the number of independent ordinates behind it. ``lay`` of a profile, if stated: "rolling", "axis"
    or "isotropic"; the bins of a profile whose lay is not stated lie along the axis. ``is_map``: whether the surface is
    a map; ``source``: where the heights come from; ``pressed``: the map pressed by boundary elements, or None.
    ``bodies``: how many bodies that meet have this surface, 1 or 2, whose mean squares add. What one measurement tells
    of both scatters together, and so does not average out.
    """

    rolling_edges: NDArray[np.float64]
    axial_edges: NDArray[np.float64]
    mean_square: NDArray[np.float64]
    independent: NDArray[np.float64]
    lay: Lay | None
    is_map: bool
    source: str
    pressed: PressedMap | None = None
    bodies: int = 1

    @property
    def longest_wave(self) -> float:
        """Longest wave along the rollers' axis, or along the profile, that counts: two thirds of the size [m]."""
        edges = self.rolling_edges if self.axial_edges[-1] == 0.0 else self.axial_edges
        return 1.0 / lowest_frequency(edges)

    @property
    def rolling_length(self) -> float:
        """Length of a map in the rolling direction [m]."""
        return 1.5 / lowest_frequency(self.rolling_edges)

    def felt(self, *, rolling: float, axial: float) -> tuple[float, float]:
        """Mean square [m^2] of all waves but those below both frequencies [1/m], and its standard deviation.

        Waves longer than two thirds of the surface are below in any case: the window does not tell them from the form.
        The deviation is that of a normally distributed surface with this spectrum.
        """
        part = self._squares_of_all - self._left_out(rolling, axial)
        return float(part.sum()), float(np.sqrt(np.sum(part**2 / self.independent)))

    def squares(self, *, rolling: NDArray[np.float64], axial: NDArray[np.float64]) -> NDArray[np.float64]:
        """The mean squares of :meth:`felt` [m^2] for many pairs of frequencies [1/m], in their shape."""
        below, beside = self._shares_below(rolling, axial)
        all_bodies = self._squares_of_all
        square = (1.0 - below) @ all_bodies.sum(axis=1)
        return np.asarray(square + np.sum((below @ all_bodies) * (1.0 - beside), axis=-1))

    def running(self, *, rolling: NDArray[np.float64], axial: NDArray[np.float64]) -> NDArray[np.float64]:
        """As :meth:`squares` of a map, each wave by the share in which it runs in the rolling direction [m^2].

        Waves are spread evenly over a bin, and over the part of it that is left out.
        """
        density = self._squares_of_all / np.outer(np.diff(self.rolling_edges), np.diff(self.axial_edges))
        ends = [
            np.minimum(edges, np.maximum(frequencies, lowest_frequency(edges))[..., None])
            for edges, frequencies in ((self.rolling_edges, rolling), (self.axial_edges, axial))
        ]
        everything = np.sum(density * _running_over(self.rolling_edges, self.axial_edges))
        return np.asarray(everything - np.sum(density * _running_over(*ends), axis=(-2, -1)))

    @property
    def _squares_of_all(self) -> NDArray[np.float64]:
        """Mean square of the waves of each bin, of all bodies with this surface, shape (rolling, axial) [m^2]."""
        return self.bodies * self.mean_square

    def _shares_below(self, rolling: Any, axial: Any) -> list[NDArray[np.float64]]:
        """Shares of the bins in each direction that are longer than the waves of :meth:`felt`, the bins last."""
        return [
            _below(edges, np.maximum(frequencies, lowest_frequency(edges)))
            for edges, frequencies in ((self.rolling_edges, rolling), (self.axial_edges, axial))
        ]

    def _left_out(self, rolling: float, axial: float) -> NDArray[np.float64]:
        """Mean square of the waves of each bin that :meth:`felt` leaves out, shape (rolling, axial) [m^2]."""
        return np.asarray(np.outer(*self._shares_below(rolling, axial)) * self._squares_of_all)

    def waves(self, *, rolling: float, axial: float) -> NDArray[np.float64]:
        """The waves that :meth:`felt` counts, one a bin: wavenumber [rad/m] and mean square [m^2], shape (2, waves).

        The wavenumber is the rms of those in the bin. The waves of a surface without grooves are sqrt(2) times as steep
        as its profiles show.
        """
        steeper = 2.0 if self.lay == "isotropic" else 1.0
        squares = np.add.outer(_mean_squares(self.rolling_edges), _mean_squares(self.axial_edges))
        part = self._squares_of_all - self._left_out(rolling, axial)
        return np.stack([2.0 * math.pi * np.sqrt(steeper * squares).ravel(), part.ravel()])

    def form(self, *, rolling: float, axial: float) -> NDArray[np.float64]:
        """The waves along the axis that :meth:`felt` leaves out, as :meth:`waves`, shape (2, bins).

        Of a profile only those up to two thirds of its length: what is longer is the crown or a chamfer.
        """
        square = self._left_out(rolling, axial).sum(axis=0)
        if not self.is_map:
            square = square * (1.0 - _below(self.axial_edges, lowest_frequency(self.axial_edges)))
        return np.stack([2.0 * math.pi * np.sqrt(_mean_squares(self.axial_edges)), square])

    def cut_off(self) -> float:
        """Cut-off [m] that ISO 4288 takes for the Ra of one body along the axis; longer waves are no roughness.

        The smallest of :data:`asperity.surface.roughness_average.STANDARD_CUT_OFFS` that agrees with the Ra behind it,
        of normally distributed heights.
        """
        for largest, cut_off in STANDARD_CUT_OFFS:
            square, _ = self.felt(rolling=math.inf, axial=1.0 / cut_off)
            if math.sqrt(square / self.bodies) / RMS_OVER_RA <= largest:
                break
        return cut_off

    def document(self) -> Document:
        """The spectrum as plain numbers for JSON."""
        return {
            "source": self.source,
            "is_map": self.is_map,
            "lay": self.lay,
            "rolling_frequency_edges_per_m": _plain(self.rolling_edges),
            "axial_frequency_edges_per_m": _plain(self.axial_edges),
            "mean_square_height_m2": [_plain(row) for row in self.mean_square],
            "independent_ordinates": [_plain(row) for row in self.independent],
            **({} if self.pressed is None else {"boundary_elements": self.pressed.document()}),
        }


def _below(edges: NDArray[np.float64], frequency: Any) -> NDArray[np.float64]:
    """Share of each bin below a frequency, the bins last; all of a bin without a width."""
    width = np.diff(edges)
    above = np.subtract.outer(frequency, edges[:-1])
    return np.where(width > 0.0, np.clip(above / np.where(width > 0.0, width, 1.0), 0.0, 1.0), 1.0)


def _running_over(rolling: NDArray[np.float64], axial: NDArray[np.float64]) -> NDArray[np.float64]:
    r"""Integrals of :math:`x^2/(x^2 + y^2)` over the rectangles between edges x, the first axis, and edges y."""
    x, y = rolling[..., :, None], axial[..., None, :]
    turned = np.arctan2(y, x)
    from_zero = 0.5 * (x**2 * turned + x * y - y**2 * (0.5 * np.pi - turned))
    return np.asarray(np.diff(np.diff(from_zero, axis=-2), axis=-1))


def _mean_squares(edges: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean square of the frequencies of each bin [1/m^2]."""
    return np.asarray((edges[:-1] ** 2 + edges[:-1] * edges[1:] + edges[1:] ** 2) / 3.0)


def lowest_frequency(edges: NDArray[np.float64]) -> float:
    """Lowest frequency that the window tells from the form: that of one and a half periods; 0 without bins."""
    positive = edges[edges > 0.0]
    return 3.0 * float(positive[0]) if positive.size else 0.0


def _plain(numbers: NDArray[np.float64]) -> list[float]:
    return [float(f"{number:.7g}") for number in numbers]


def spectrum_from_document(entry: Any) -> HeightSpectrum:
    """The spectrum of :meth:`HeightSpectrum.document`; an ``InputError`` if it is not such a document."""
    try:
        first, second, square, independent = (
            np.asarray(entry[key], dtype=np.float64)
            for key in (
                "rolling_frequency_edges_per_m",
                "axial_frequency_edges_per_m",
                "mean_square_height_m2",
                "independent_ordinates",
            )
        )
        lay, is_map, source = entry["lay"], entry["is_map"], entry["source"]
        valid = (
            square.shape == independent.shape == (first.size - 1, second.size - 1)
            and all(
                np.isfinite(numbers).all() and (numbers >= 0.0).all()
                for numbers in (first, second, square, independent)
            )
            and (np.diff(first) >= 0.0).all()
            and (np.diff(second) >= 0.0).all()
            and (not is_map or min(np.diff(first).min(), np.diff(second).min()) > 0.0)
            and max(first[-1], second[-1]) > 0.0
            and (independent >= 0.99 / _HANN_LOSS**2).all()  # as _independent makes them
            and (square <= 1.0).all()
            and (lay is None or lay in LAYS)
            and isinstance(is_map, bool)
            and isinstance(source, str)
        )
    except (KeyError, TypeError, ValueError, IndexError):
        valid = False
    if not valid:
        raise InputError("the spectrum of the measurement is damaged: measure again")
    pressed = entry.get("boundary_elements")
    elements = None if pressed is None else pressed_map_from_document(pressed)
    return HeightSpectrum(first, second, square, independent, lay, is_map, source, elements)


def with_lay(spectrum: HeightSpectrum, lay: Lay | None) -> HeightSpectrum:
    """The spectrum of a profile with a stated lay: its waves run along the axis, or in the rolling direction."""
    if lay != "axis":
        return replace(spectrum, lay=lay)
    return replace(
        spectrum,
        lay=lay,
        rolling_edges=spectrum.axial_edges,
        axial_edges=spectrum.rolling_edges,
        mean_square=spectrum.mean_square.T,
        independent=spectrum.independent.T,
    )


def spectrum_of_profiles(
    *, profiles: NDArray[np.float64], spacing: float, lay: Lay | None, source: str
) -> HeightSpectrum:
    """Spectrum of profiles of one surface, a straight line removed from each, Hann window.

    Heights [m], shape (profiles, points), no missing points, at a spacing [m]. ``lay`` is the direction of the grooves,
    which the profiles cross: "rolling", "axis" or "isotropic", None if it is not known; ``source`` says where the
    heights come from.
    """
    _, density = power_spectral_densities(profiles=profiles, spacing=spacing)
    rows, points = profiles.shape
    length = points * spacing
    edges, sums = _bins(np.arange(1, density.shape[1] + 1), _BINS_PER_DECADE["profile"])
    power = density / length
    total, square = sums @ power.sum(axis=0), sums @ np.sum(power**2, axis=0)
    along = HeightSpectrum(
        rolling_edges=np.zeros(2),
        axial_edges=edges / length,
        mean_square=total[None, :] / rows,
        independent=_independent(total, square, rows * sums.sum(axis=1))[None, :] / _HANN_LOSS,
        lay=None,
        is_map=False,
        source=source,
    )
    return with_lay(along, lay)


def spectrum_of_map(*, topography: Topography, rolling: str) -> HeightSpectrum:
    """Spectrum of a levelled map without missing points, Hann window in both directions.

    ``rolling``, "x" or "y", is the direction of the map in which the contact rolls; the rollers' axis is the other one.
    """
    assert topography.spacing_across is not None
    along_x = rolling == "x"
    heights = topography.heights
    down, across = (raised_cosine(count, 1.0) for count in heights.shape)
    spectrum = scipy.fft.rfft2(heights * down[:, None] * across, workers=2)
    power = spectrum.real**2 + spectrum.imag**2
    power /= heights.size * np.sum(down**2) * np.sum(across**2)
    first = np.abs(np.rint(scipy.fft.fftfreq(heights.shape[0], 1.0 / heights.shape[0]))).astype(int)
    (y_edges, rows), (x_edges, columns) = (
        _bins(ordinates, _BINS_PER_DECADE["map"]) for ordinates in (first, np.arange(power.shape[1]))
    )
    twice = np.full(power.shape[1], 2.0)  # of a real map the other half of the plane is the same
    twice[0] = 1.0
    if heights.shape[1] % 2 == 0:
        twice[-1] = 1.0
    columns *= twice
    mean_square, square = rows @ power @ columns.T, rows @ power**2 @ columns.T
    count = np.outer(rows.sum(axis=1), 0.5 * columns.sum(axis=1))
    # every ordinate is there twice
    independent = _independent(mean_square, 2.0 * square, count) / _HANN_LOSS**2
    x_edges, y_edges = x_edges / topography.size[0], y_edges / topography.size[1]
    return HeightSpectrum(
        rolling_edges=x_edges if along_x else y_edges,
        axial_edges=y_edges if along_x else x_edges,
        mean_square=mean_square.T if along_x else mean_square,
        independent=independent.T if along_x else independent,
        lay=None,
        is_map=True,
        source=topography.source,
    )


def _bins(ordinates: NDArray[np.int64], per_decade: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Edges of logarithmic bins of ordinates, in ordinates, and the matrix (bins, ordinates) that sums over each."""
    starts = bin_edges(int(ordinates.max()) + 1, per_decade)
    if ordinates.min() == 0:
        starts = np.concatenate([[0], starts])
    inside = (ordinates >= starts[:-1, None]) & (ordinates < starts[1:, None])
    return np.maximum(starts - 0.5, 0.0), inside.astype(np.float64)


def _independent(
    total: NDArray[np.float64], square: NDArray[np.float64], count: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Number of ordinates with the scatter of bins, from the sums of the ordinates and of their squares; 1 to count.

    Ordinates of a normally distributed surface scatter by their mean: alike on average, all of them count.
    """
    alike = 2.0 * total**2 / np.where(square > 0.0, square, 1.0)
    return np.clip(alike, 1.0, np.maximum(count, 1.0))

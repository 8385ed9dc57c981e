"""From surfaces in memory to a measurement: conditioning, profiles, fit, directions."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError, NoSolutionError
from asperity.surface.fractal_fit import FractalFit, fractal_fit
from asperity.surface.height_parameters import HeightParameters, height_parameters
from asperity.surface.levelling import filtered, levelled, without_outliers
from asperity.surface.structure_function import height_step
from asperity.surface.topography import Topography, without_missing


@dataclass(frozen=True)
class Conditioning:
    """Treatment of a surface before its evaluation; every step is a choice of the user.

    ``form`` to remove, see :func:`asperity.surface.levelling.levelled`, with the degree of a polynomial one;
    ``missing``: what happens with missing points, see :func:`asperity.surface.topography.without_missing`;
    ``outlier_threshold``: robust standard deviations beyond which a point counts as missing, None keeps all. The
    cut-offs lambda_s and lambda_c of the Gaussian filter [m] are for the height parameters only: the filter would bend
    the spectrum that D and G come from.
    """

    form: str
    degree: int | None
    missing: str
    outlier_threshold: float | None
    short_cutoff: float | None
    long_cutoff: float | None


@dataclass(frozen=True)
class MeasuredSurface:
    """One conditioned surface, its height parameters, and the step of its heights before levelling [m]."""

    topography: Topography
    heights: HeightParameters
    height_step: float | None


def conditioned(*, topography: Topography, conditioning: Conditioning) -> MeasuredSurface:
    """Outliers, missing points and form removed; then height parameters of the filtered heights.

    Raises
    ------
    InputError
        If a step is impossible, or points are missing and the choice is to refuse.
    """
    surface = topography
    if conditioning.outlier_threshold is not None:
        surface = without_outliers(topography=surface, threshold=conditioning.outlier_threshold, window=9)
    complete = without_missing(topography=surface, choice=conditioning.missing)
    flat = levelled(topography=complete, form=conditioning.form, degree=conditioning.degree)
    rough = filtered(
        topography=flat, short_cutoff=conditioning.short_cutoff, long_cutoff=conditioning.long_cutoff
    )
    step = height_step(profiles=complete.profiles(direction="x")[0])
    return MeasuredSurface(flat, height_parameters(topography=rough), step)


def pooled_profiles(*, surfaces: list[Topography], direction: str) -> tuple[NDArray[np.float64], float, bool]:
    """Profiles of several surfaces of one spacing, cut to a common length; their spacing; whether rows of one map."""
    sets = [surface.profiles(direction=direction) for surface in surfaces]
    spacing = sets[0][1]
    for surface, (_, other) in zip(surfaces, sets, strict=True):
        if abs(other - spacing) > 1e-3 * spacing:
            raise InputError(
                f"{surface.source} has the spacing {other:.6g} m, {surfaces[0].source} "
                f"{spacing:.6g} m; measure files "
                "of different spacing one by one"
            )
    points = min(profiles.shape[1] for profiles, _ in sets)
    if len(sets) == 1:
        return sets[0][0], spacing, surfaces[0].is_map
    if any(surface.is_map for surface in surfaces):
        raise InputError("only profiles can be averaged over several files; measure maps one by one")
    return np.concatenate([profiles[:, :points] for profiles, _ in sets]), spacing, False


@dataclass(frozen=True)
class DirectionalFits:
    """Fits along x and, of a map, along y; where there is none, the reason as text."""

    along_x: FractalFit | str
    along_y: FractalFit | str | None

    @property
    def anisotropy_ratio(self) -> float | None:
        """Amplitude along x over that along y at the middle of the common band [-], 1 if isotropic."""
        x, y = self.along_x, self.along_y
        if not isinstance(x, FractalFit) or not isinstance(y, FractalFit):
            return None
        short = max(x.shortest_wavelength, y.shortest_wavelength)
        long = min(x.longest_wavelength, y.longest_wavelength)
        log_f = -0.5 * math.log(short * long)
        log_x, log_y = (
            2.0 * (f.fractal_dimension - 1.0) * f.log_roughness - (5.0 - 2.0 * f.fractal_dimension) * log_f
            for f in (x, y)
        )
        return math.exp(0.5 * (log_x - log_y))


def directional_fits(
    *,
    surfaces: list[MeasuredSurface],
    estimator: str,
    frequency_ratio: float,
    shortest_wavelength: float | None,
    longest_wavelength: float | None,
) -> DirectionalFits:
    """D and G along x and, if there is a map, along y; a missing power law is returned as its reason."""
    steps = [surface.height_step for surface in surfaces if surface.height_step is not None]

    def attempt(direction: str) -> FractalFit | str:
        profiles, spacing, rows_of_a_map = pooled_profiles(
            surfaces=[surface.topography for surface in surfaces], direction=direction
        )
        try:
            return fractal_fit(
                profiles=profiles,
                spacing=spacing,
                estimator=estimator,
                frequency_ratio=frequency_ratio,
                rows_of_a_map=rows_of_a_map,
                shortest_wavelength=shortest_wavelength,
                longest_wavelength=longest_wavelength,
                known_height_step=max(steps, default=None),
            )
        except NoSolutionError as refusal:
            return str(refusal)

    return DirectionalFits(attempt("x"), attempt("y") if surfaces[0].topography.is_map else None)

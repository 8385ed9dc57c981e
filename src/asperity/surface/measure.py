"""From surfaces in memory to a measurement: conditioning, profiles, fit, directions."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError, NoSolutionError
from asperity.surface.crown import Crown, LogarithmicProfile, crown, logarithmic_profile
from asperity.surface.fractal_fit import FractalFit, fractal_fit
from asperity.surface.height_parameters import HeightParameters, height_parameters
from asperity.surface.levelling import filtered, levelled, without_outliers
from asperity.surface.roughness import Roughness, roughness
from asperity.surface.structure_function import height_step
from asperity.surface.topography import Topography, without_missing


@dataclass(frozen=True)
class Conditioning:
    """Treatment of a surface before its evaluation; every step is a choice of the user.

    ``form`` to remove, see :func:`asperity.surface.levelling.levelled`, with the degree of a polynomial one;
    ``missing``: what happens with missing points, see :func:`asperity.surface.topography.without_missing`;
    ``outlier_threshold``: robust standard deviations beyond which a point counts as missing, None keeps all. The
    cut-offs [m] are, of a profile, lambda_s and lambda_c of the R parameters, None for those of the standard; of a map,
    the nesting indices of the S-filter and the L-filter, None for none. They are for these parameters only: a filter
    would bend the spectrum that D and G come from.
    """

    form: str
    degree: int | None
    missing: str
    outlier_threshold: float | None
    short_cutoff: float | None
    long_cutoff: float | None


@dataclass(frozen=True)
class MeasuredSurface:
    """One conditioned surface, without form and missing points, and its parameters.

    ``heights``: of a profile, without a filter, the P parameters; of a map, behind the chosen filters, the S
    parameters. ``height_step`` of the heights before levelling [m], or None. ``roughness``: R parameters of a profile,
    or why there are none; None of a map. ``crown``: circle along a profile before levelling; None of a map and of fewer
    than sixteen points. ``logarithmic``: logarithmic profile along a profile before levelling, where one that is high
    in the middle fits. ``filters``: nesting indices of the S-filter and the L-filter [m] of the S parameters of a map;
    None for no such filter.
    """

    topography: Topography
    heights: HeightParameters
    height_step: float | None
    roughness: Roughness | str | None = None
    crown: Crown | None = None
    logarithmic: LogarithmicProfile | None = None
    filters: tuple[float | None, float | None] = (None, None)

    @property
    def scale_limited(self) -> str:
        """The surface that the S parameters are of, by its name in ISO 25178-2."""
        return "S-F surface" if self.filters[1] is None else "S-L surface"


def conditioned(*, topography: Topography, conditioning: Conditioning) -> MeasuredSurface:
    """Outliers, missing points and form removed; then the parameters.

    An ``InputError`` if a step is impossible, a cut-off does not suit the surface, or points are missing and the choice
    is to refuse.
    """
    surface = topography
    if conditioning.outlier_threshold is not None:
        surface = without_outliers(topography=surface, threshold=conditioning.outlier_threshold, window=9)
    complete = without_missing(topography=surface, choice=conditioning.missing)
    flat = levelled(topography=complete, form=conditioning.form, degree=conditioning.degree)
    step = height_step(profiles=complete.profiles(direction="x")[0])
    if flat.is_map:
        filters = conditioning.short_cutoff, conditioning.long_cutoff
        rough = filtered(topography=flat, short_cutoff=filters[0], long_cutoff=filters[1])
        return MeasuredSurface(flat, height_parameters(topography=rough), step, filters=filters)
    return MeasuredSurface(
        flat,
        height_parameters(topography=flat),
        step,
        _roughness(flat, conditioning, gaps=surface.missing_points > 0),
        crown(topography=complete),
        logarithmic_profile(topography=complete),
    )


def _roughness(profile: Topography, conditioning: Conditioning, gaps: bool) -> Roughness | str:
    """R parameters of a conditioned profile, unless gaps in it were filled."""
    short, long = conditioning.short_cutoff, conditioning.long_cutoff
    if gaps and conditioning.missing == "interpolate":
        reason = "gaps are filled by straight lines, which are no roughness; keep the longest complete piece"
        if long is None and short is None:
            return reason
        raise InputError(f"{profile.source}: no filter, because {reason}", options=["missing"])
    return roughness(topography=profile, cut_off=long, short_cut_off=short)


def pooled_profiles(*, surfaces: list[Topography], direction: str) -> tuple[NDArray[np.float64], float, bool]:
    """Profiles of several surfaces of one spacing, cut to a common length; their spacing; whether rows of one map."""
    sets = [surface.profiles(direction=direction) for surface in surfaces]
    spacing = sets[0][1]
    for surface, (_, other) in zip(surfaces, sets, strict=True):
        if abs(other - spacing) > 1e-3 * spacing:
            raise InputError(
                f"{surface.source} has the spacing {other:.6g} m, {surfaces[0].source} {spacing:.6g} m; measure files "
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

    with ThreadPoolExecutor(2) as pool:
        along = list(pool.map(attempt, "xy" if surfaces[0].topography.is_map else "x"))
    return DirectionalFits(along[0], along[1] if len(along) > 1 else None)

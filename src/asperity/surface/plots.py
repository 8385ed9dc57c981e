"""Figures of a measurement: profile or map, spectrum and structure function with the fitted band."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from asperity.errors import one_line
from asperity.surface import conventions
from asperity.surface.fractal_fit import FractalFit
from asperity.surface.measure import pooled_profiles
from asperity.surface.spectrum import binned_spectrum
from asperity.surface.structure_function import logarithmic_lags, structure_functions
from asperity.surface.topography import Topography


def measurement_figure(*, surfaces: list[Topography], fit: FractalFit | str, direction: str) -> Figure:
    """Figure of heights, spectrum and structure function with the fitted power law, or the reason why there is none."""
    profiles, spacing, rows_of_a_map = pooled_profiles(surfaces=surfaces, direction=direction)
    figure = Figure(figsize=(9.0, 8.0), layout="constrained")
    axes: Any = figure.subplot_mosaic([["heights", "heights"], ["spectrum", "structure"]])
    _heights(axes["heights"], figure, surfaces[0], profiles, spacing)
    spectrum = binned_spectrum(
        profiles=profiles, spacing=spacing, differenced=True, bins_per_decade=20, rows_of_a_map=rows_of_a_map
    )
    positive = spectrum.density > 0.0
    measured: Any = {"color": "0.35", "markersize": 4, "label": "measured"}
    axes["spectrum"].loglog(spectrum.frequency[positive], spectrum.density[positive], ".", **measured)
    axes["spectrum"].set(xlabel="spatial frequency f [1/m]", ylabel="one-sided power spectral density P [m³]")
    axes["spectrum"].set_title("Spectrum")
    lags = logarithmic_lags(points=profiles.shape[1], per_decade=15, longest_fraction=0.5)
    S = structure_functions(profiles=profiles, lags=lags).mean(axis=0)
    axes["structure"].loglog(lags * spacing, S, ".", **measured)
    axes["structure"].set(xlabel="lag τ [m]", ylabel="structure function S [m²]")
    axes["structure"].set_title("Structure function")
    if isinstance(fit, str):
        figure.suptitle("no D and G, reason below; a joint uses the spectrum", fontsize=10, color="tab:red")
        import textwrap

        figure.supxlabel(textwrap.fill(fit, 120), fontsize=8, color="tab:red")
    else:
        _power_laws(axes, fit, spacing)
        low, high = fit.roughness_interval(confidence=0.95)
        d_low, d_high = fit.dimension_interval(confidence=0.95)
        figure.suptitle(
            f"D = {fit.fractal_dimension:.4f} ({d_low:.4f} … {d_high:.4f}),  G = {fit.fractal_roughness:.3g} m "
            f"({low:.3g} … {high:.3g} m),  95 % intervals,  {fit.estimator}, {fit.profiles} profile(s) along "
            f"{direction}",
            fontsize=9,
        )
    for name in ("spectrum", "structure"):
        axes[name].grid(True, which="major", alpha=0.3)
        axes[name].legend(fontsize=8)
    return figure


def _heights(axes: Any, figure: Figure, surface: Topography, profiles: np.ndarray, spacing: float) -> None:
    if surface.is_map:
        width, height = surface.size
        stride = max(1, max(surface.heights.shape) // 1500)
        image = axes.imshow(
            1e6 * surface.heights[::stride, ::stride],
            extent=(0.0, 1e6 * width, 0.0, 1e6 * height),
            origin="lower",
            aspect="auto",
            cmap="viridis",
        )
        figure.colorbar(image, ax=axes, label="height z [µm]")
        axes.set(xlabel="x [µm]", ylabel="y [µm]")
    else:
        z = profiles[0]
        stride = max(1, z.size // 20000)
        axes.plot(1e6 * spacing * np.arange(z.size)[::stride], 1e6 * z[::stride], linewidth=0.6)
        axes.set(xlabel="x [µm]", ylabel="height z [µm]")
    axes.set_title(one_line(surface.source).replace("$", r"\$"), fontsize=9)  # no formula of matplotlib


def _power_laws(axes: Any, fit: FractalFit, spacing: float) -> None:
    D, G = fit.fractal_dimension, fit.fractal_roughness
    f = np.geomspace(1.0 / fit.longest_wavelength, 1.0 / fit.shortest_wavelength, 50)
    P = conventions.power_spectral_density(frequency=f, fractal_dimension=D, fractal_roughness=G)
    axes["spectrum"].loglog(f, P, color="tab:red", linewidth=1.5, label="fitted power law")
    axes["spectrum"].axvspan(f[0], f[-1], color="tab:red", alpha=0.07, label="fitted band")
    if fit.noise_density > 0.0:
        axes["spectrum"].axhline(fit.noise_density, color="tab:blue", linestyle=":", label="white noise")
    tau = np.geomspace(max(0.5 * fit.shortest_wavelength, spacing), 0.5 * fit.longest_wavelength, 50)
    S = conventions.structure_function(lag=tau, fractal_dimension=D, fractal_roughness=G)
    axes["structure"].loglog(tau, S, color="tab:red", linewidth=1.5, label="power law of this D and G")
    axes["structure"].axvspan(
        tau[0], tau[-1], color="tab:red", alpha=0.07, label="half wavelengths of the band"
    )

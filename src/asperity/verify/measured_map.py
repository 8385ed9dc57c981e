"""The closed-form laws and boundary elements on a user's own measured map over the nominal pressure; their figure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray

from asperity.bem import ElasticPair
from asperity.bem.pressed_map import map_patches, mirrored, pressed_map
from asperity.contact.exponential import decay_length
from asperity.contact.fractal import Surface
from asperity.contact.persson_2007 import persson_decay_length, wave_spectrum
from asperity.surface.measure_files import MeasuredFiles
from asperity.surface.pressed_map import PressedMap, plain_numbers
from asperity.types import Document
from asperity.verify.comparison import flat_fractal_contact

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.figure import Figure

#: Nominal pressures that the verdict speaks of [Pa], and the largest share of the area in contact.
JUDGED = (29e6, 1010e6)
LARGEST_AREA = 0.5
#: Law → its name.
LAWS = {
    "exponential": "the exponential law",
    "persson": "Persson's theory",
    "published": "the published law of D and G",
}


@dataclass(frozen=True)
class MapComparison:
    """Stiffness of the interface on patches of a pressed map, per nominal area [Pa/m].

    ``pressure``: nominal, shape (loads,) [Pa]; ``hardness`` of the capped states [Pa]. Of shape (patches, loads):
    ``elastic`` and ``capped`` by boundary elements, nan where a patch is pressed flat or cannot carry the load;
    ``laws`` by the closed-form ones, keys of :data:`LAWS`; the published one where the surface has D and G, else
    ``no_power_law`` says why it has none.
    """

    pressed: PressedMap
    pressure: NDArray[np.float64]
    hardness: float
    elastic: NDArray[np.float64]
    capped: NDArray[np.float64]
    laws: dict[str, NDArray[np.float64]]
    no_power_law: str

    def ratio(self, law: str) -> NDArray[np.float64]:
        """A law over the boundary elements, elastic: geometric mean over the patches, shape (loads,) [-]."""
        with np.errstate(divide="ignore"):
            return np.asarray(np.exp(np.mean(np.log(self.laws[law] / self.elastic), axis=0)))

    @property
    def judged(self) -> NDArray[np.bool_]:
        """Which loads the verdict speaks of: with a stiffness, and less than half of the area in contact."""
        inside = (self.pressure > JUDGED[0]) & (self.pressure < JUDGED[1])
        return np.asarray(inside & (self.pressed.contact_fractions[0].mean(axis=0) < LARGEST_AREA))

    def verdict(self) -> str:
        """What the comparison says, in one sentence."""
        if not self.judged.any():
            return (
                "More than half of the area touches at every pressure from 30 to 1000 MPa: the laws of partial contact "
                "do not apply to this surface, and its interface hardly counts."
            )
        loads = _range(1e-6 * self.pressure[self.judged], ".4g")
        told = [f"{LAWS[law]} {_range(self.ratio(law)[self.judged], '.2f')}" for law in self.laws]
        judged = self.capped[:, self.judged] / self.elastic[:, self.judged]
        capped = judged[:, np.isfinite(judged).all(axis=0)].mean(axis=0)
        stiffer = ""
        if capped.size:
            stiffer = f"; a hardness of {1e-9 * self.hardness:.3g} GPa makes it {_range(capped, '.2f')} times as stiff"
        return f"On this surface, at {loads} MPa, the laws over elastic boundary elements: {', '.join(told)}{stiffer}."


def _range(values: NDArray[np.float64], digits: str) -> str:
    """Smallest and largest of some values in words."""
    if not values.max() > 0.0:
        return "0 (all spots are plastic)"
    ends = [f"{values.min():{digits}}", f"{values.max():{digits}}"]
    return " to ".join(dict.fromkeys(ends))


def compare_map(
    measured: MeasuredFiles,
    *,
    pair: ElasticPair,
    hardness: float,
    points: int,
    solved: Callable[[], None] = lambda: None,
) -> MapComparison:
    """Press patches of a measured map by boundary elements, and evaluate the laws on them.

    The heights are those of both bodies, the hardness that of the softer one [Pa]; the map has at most ``points`` along
    each side, more are averaged. ``solved`` is called after each state; errors are those of
    :func:`asperity.bem.pressed_map.pressed_map`.
    """
    modulus = float(pair.contact_modulus)
    topography = measured.topographies[0]
    pressed = pressed_map(
        topography, rolling=measured.direction, hardness=hardness / modulus, points=points // 2, solved=solved
    )
    patches, cell = map_patches(topography, points=points // 2)
    pressure = pressed.pressure * modulus
    height = pressed.rms_height[:, None]
    theory = [
        pressure
        / persson_decay_length(
            spectrum=wave_spectrum(full, sides=(full.shape[0] * cell[0], full.shape[1] * cell[1])),
            mean_pressure=jnp.asarray(pressure),
            contact_modulus=modulus,
        )
        for full in map(mirrored, patches)
    ]
    laws = {
        "exponential": pressure / np.asarray(decay_length(rms_height=jnp.asarray(height))),
        "persson": np.stack([np.asarray(stiffness) for stiffness in theory]),
    }
    fractal = measured.roughness.fractal
    if fractal is not None:
        area = float(np.prod(pressed.size))
        law = flat_fractal_contact(
            Surface(
                fractal_dimension=fractal.fractal_dimension,
                fractal_roughness=fractal.fractal_roughness,
                frequency_ratio=fractal.frequency_ratio,
                asperity_base="majumdar_bhushan_1991",
            ),
            pair=pair,
            normal_force=jnp.asarray(pressure * area),
            hardness=hardness,
        )
        laws["published"] = np.tile(np.asarray(law.normal_stiffness) / area, (len(patches), 1))
    return MapComparison(
        pressed=pressed,
        pressure=pressure,
        hardness=hardness,
        elastic=pressure / (pressed.decay_ratios[0] * height),
        capped=pressure / (pressed.decay_ratios[1] * height),
        laws=laws,
        no_power_law=measured.roughness.no_power_law,
    )


def map_document(comparison: MapComparison, *, source: str) -> Document:
    """All numbers of a comparison for JSON, SI units in the names; null where there is no stiffness."""
    pressed = comparison.pressed
    elements = {
        "normal_stiffness_Pa_per_m": comparison.elastic,
        "capped_normal_stiffness_Pa_per_m": comparison.capped,
        "tangential_over_normal_stiffness": pressed.tangential_ratios,
        "contact_fraction": pressed.contact_fractions[0],
        "capped_contact_fraction": pressed.contact_fractions[1],
    }
    return {
        "source": source,
        "verdict": comparison.verdict(),
        "patch_size_m": plain_numbers(pressed.size),
        "patch_rms_height_m": plain_numbers(pressed.rms_height),
        "nominal_pressure_Pa": plain_numbers(comparison.pressure),
        "hardness_Pa": comparison.hardness,
        "no_power_law": comparison.no_power_law,
        "boundary_elements": {name: plain_numbers(values) for name, values in elements.items()},
        "laws": {
            law: {
                "normal_stiffness_Pa_per_m": plain_numbers(values),
                "over_boundary_elements": plain_numbers(comparison.ratio(law)),
            }
            for law, values in comparison.laws.items()
        },
    }


def map_figure(comparison: MapComparison, measured: MeasuredFiles) -> Figure:
    """The map, the stiffness by every method over the pressure, and the laws over the elements."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11.0, 5.5), layout="constrained")
    grid = figure.add_gridspec(2, 2, height_ratios=[1.6, 1.0])
    left, above = figure.add_subplot(grid[:, 0]), figure.add_subplot(grid[0, 1])
    below = figure.add_subplot(grid[1, 1], sharex=above)
    topography = measured.topographies[0]
    width, height = (1e6 * size for size in topography.size)
    limits = 1e6 * np.percentile(topography.heights, [0.5, 99.5])
    image = left.imshow(
        1e6 * topography.heights,
        extent=(0.0, width, height, 0.0),
        cmap="viridis",
        vmin=limits[0],
        vmax=limits[1],
    )
    left.set(xlabel="x [µm]", ylabel="y [µm]", title="levelled map")
    figure.colorbar(image, ax=left, label="height [µm]", shrink=0.7)
    pressure = 1e-6 * comparison.pressure
    for values, marker, label in (
        (comparison.elastic, "o", "boundary elements, elastic"),
        (comparison.capped, "^", f"boundary elements, hardness {1e-9 * comparison.hardness:.3g} GPa"),
    ):
        shown = 1e-12 * np.exp(np.mean(np.log(values), axis=0))
        spread = np.abs(1e-12 * np.array([values.min(axis=0), values.max(axis=0)]) - shown)
        colour = "black" if marker == "o" else "tab:red"
        above.errorbar(pressure, shown, spread, fmt=marker, markersize=4, color=colour, label=label)
    for (law, values), style in zip(comparison.laws.items(), ("-", ":", "--"), strict=False):
        shown = np.where(values > 0.0, values, np.nan).mean(axis=0)
        above.plot(pressure, 1e-12 * shown, style, label=LAWS[law])
        below.plot(pressure, comparison.ratio(law), style)
    above.set(xscale="log", yscale="log", ylabel="normal stiffness [MPa/µm]")
    above.legend(fontsize=8)
    below.axhline(1.0, color="black", linewidth=0.8)
    below.set(yscale="log", xlabel="nominal pressure [MPa]", ylabel="law over elastic\nboundary elements [-]")
    return figure

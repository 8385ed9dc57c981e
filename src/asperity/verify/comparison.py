"""The fractal law, Persson's theory and boundary elements on the same surfaces at the same loads, and their figure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray

from asperity.bem import ElasticPair, PeriodicHalfSpace
from asperity.bem.pressed_map import loaded_state
from asperity.contact.fractal import Surface, fractal_contact
from asperity.contact.interface import RoughContact
from asperity.contact.persson_2007 import contact_fraction, persson_decay_length, wave_spectrum
from asperity.engine.module import Module
from asperity.errors import InputError
from asperity.surface.weierstrass import periodic_weierstrass_surface
from asperity.types import Array

if TYPE_CHECKING:
    from matplotlib.figure import Figure


#: Attribute, axis label.
QUANTITIES = {
    "normal_stiffness": "normal stiffness $K_n$ [N/m]",
    "tangential_stiffness": "tangential stiffness $K_t$ [N/m]",
    "real_contact_area": "real contact area $A_r$ [m²]",
}


class Sample(Module):
    """What is compared: one fractal surface on one square of two like bodies; SI units.

    D [-], G [m] and gamma [-] of the profiles; side of the nominally flat, periodic square [m] with grid points along
    it; ``waves_per_side``, side over the longest wavelength [-]; ``pixels_per_wave``, shortest wavelength over the
    pixel [-]; E [Pa], nu [-] and hardness [Pa] of both bodies.
    """

    fractal_dimension: float
    fractal_roughness: float
    frequency_ratio: float
    side: float
    points: int
    waves_per_side: float
    pixels_per_wave: float
    youngs_modulus: float
    poisson_ratio: float
    hardness: float

    @property
    def pair(self) -> ElasticPair:
        """The two like bodies."""
        E, nu = self.youngs_modulus, self.poisson_ratio
        return ElasticPair(
            contact_modulus=E / (2.0 * (1.0 - nu**2)),
            antiplane_modulus=E / (4.0 * (1.0 + nu)),
            dundurs_constant=0.0,
        )


class Comparison(Module):
    """Area [m^2] and stiffness [N/m] by three methods over the load [N]; SI units.

    By boundary elements and, with the prefix ``persson``, by Persson's theory from each surface's spectrum, shape
    (seeds, loads); with the prefix ``law``, by the closed-form law with contact factor 1, shape (loads,). The
    tangential stiffness is the mean over both directions by boundary elements, and by Persson's theory that with
    Mindlin's ratio. ``relative_pressure`` is load over nominal area and ``pressure_scale``, the smaller of the hardness
    and contact modulus times rms slope, at which contact is nearly complete [Pa]; ``rms_height`` [m] and ``rms_slope``
    are means over the seeds; ``capped_fraction``, shape (seeds, loads), is the share of the contact area at the
    hardness.
    """

    normal_force: Array
    relative_pressure: Array
    pressure_scale: Array
    rms_height: Array
    rms_slope: Array
    real_contact_area: Array
    normal_stiffness: Array
    tangential_stiffness: Array
    law_real_contact_area: Array
    law_normal_stiffness: Array
    law_tangential_stiffness: Array
    persson_real_contact_area: Array
    persson_normal_stiffness: Array
    persson_tangential_stiffness: Array
    capped_fraction: Array


def sample_heights(sample: Sample, seed: int) -> np.ndarray:
    """One surface of the sample, shape (points, points) [m]."""
    return periodic_weierstrass_surface(
        points=sample.points,
        side=sample.side,
        longest_wavelength=sample.side / sample.waves_per_side,
        shortest_wavelength=sample.pixels_per_wave * sample.side / sample.points,
        fractal_dimension=sample.fractal_dimension,
        fractal_roughness=sample.fractal_roughness,
        frequency_ratio=sample.frequency_ratio,
        random=np.random.default_rng(seed),
    )


def flat_fractal_contact(
    surface: Surface, *, pair: ElasticPair, normal_force: Array, hardness: float
) -> RoughContact:
    """The published law of a nominally flat contact without tangential force."""
    return fractal_contact(
        surface=surface,
        normal_force=normal_force,
        tangential_force=0.0,
        friction_coefficient=1.0,
        contact_factor=1.0,
        contact_modulus=pair.contact_modulus,
        tangential_contact_modulus=pair.tangential_contact_modulus,
        hardness=hardness,
    )


def compare(
    sample: Sample,
    *,
    seeds: int,
    relative_pressures: Sequence[float],
    elastic: bool = False,
    solved: Callable[[], None] = lambda: None,
) -> Comparison:
    """Solve the sample's surfaces under each load by boundary elements, and evaluate the law and Persson's theory."""
    pressures = _rising(relative_pressures, seeds)
    pair = sample.pair
    surfaces = [sample_heights(sample, seed) for seed in range(seeds)]
    spectra = [wave_spectrum(heights, sides=(sample.side, sample.side)) for heights in surfaces]
    E = pair.contact_modulus
    rms_slope = jnp.mean(jnp.stack([s.rms_slope for s in spectra]))
    scale = jnp.minimum(E * rms_slope, sample.hardness)
    mean_pressure = jnp.asarray(pressures) * scale
    force = mean_pressure * sample.side**2
    area, normal, tangential, capped_fraction = _by_boundary_elements(
        sample, surfaces, force, elastic, solved
    )
    law = flat_fractal_contact(
        Surface(
            fractal_dimension=sample.fractal_dimension,
            fractal_roughness=sample.fractal_roughness,
            frequency_ratio=sample.frequency_ratio,
            asperity_base="majumdar_bhushan_1991",
        ),
        pair=pair,
        normal_force=force,
        hardness=sample.hardness,
    )
    nominal = sample.side**2
    theory_area = nominal * jnp.stack(
        [
            contact_fraction(mean_pressure=mean_pressure, contact_modulus=E, rms_slope=s.rms_slope)
            for s in spectra
        ]
    )
    theory_normal = nominal * jnp.stack(
        [
            mean_pressure / persson_decay_length(spectrum=s, mean_pressure=mean_pressure, contact_modulus=E)
            for s in spectra
        ]
    )
    return Comparison(
        normal_force=force,
        relative_pressure=jnp.asarray(pressures),
        pressure_scale=scale,
        rms_height=jnp.mean(jnp.stack([s.rms_height for s in spectra])),
        rms_slope=rms_slope,
        real_contact_area=area,
        normal_stiffness=normal,
        tangential_stiffness=tangential,
        law_real_contact_area=law.real_contact_area,
        law_normal_stiffness=law.normal_stiffness,
        law_tangential_stiffness=law.tangential_stiffness,
        persson_real_contact_area=theory_area,
        persson_normal_stiffness=theory_normal,
        persson_tangential_stiffness=theory_normal * (4.0 * pair.tangential_contact_modulus / E),
        capped_fraction=capped_fraction,
    )


def _rising(relative_pressures: Sequence[float], seeds: int) -> NDArray[np.float64]:
    """The pressures over the pressure scale, shape (loads,), or an ``InputError``."""
    pressures = np.asarray(relative_pressures, dtype=np.float64)
    rising = pressures.size > 0 and np.all(np.diff(pressures, prepend=0.0) > 0.0)
    if seeds < 1 or not rising or not pressures[-1] < 1.0:
        raise InputError(
            f"seeds = {seeds}, relative pressures {list(relative_pressures)}: at least one seed is needed, and "
            "pressures that increase, above 0 and below 1"
        )
    return pressures


def _by_boundary_elements(
    sample: Sample, surfaces: Sequence[np.ndarray], force: Array, elastic: bool, solved: Callable[[], None]
) -> Array:
    """Area [m^2], both stiffnesses [N/m], share of the area at the hardness [-], shape (4, surfaces, loads)."""
    pixel = sample.side / sample.points
    half_space = PeriodicHalfSpace(
        sample.pair, shape=(sample.points, sample.points), pixel_size=(pixel, pixel)
    )
    hardness = None if elastic else sample.hardness
    rows = []
    for heights in surfaces:
        row, contact = [], None
        for load in np.asarray(force):
            contact, state = loaded_state(
                half_space, heights, normal_force=load, hardness=hardness, axes=(0, 1), start=contact
            )
            capped = (
                jnp.mean(contact.pressure >= sample.hardness, dtype=jnp.float64) / contact.contact_fraction
            )
            row.append(jnp.append(state, capped))
            solved()
        rows.append(jnp.stack(row, axis=1))
    return jnp.stack(rows, axis=1)


def comparison_figure(samples: Sequence[Sample], comparisons: Sequence[Comparison]) -> Figure:
    """Three quantities over the load by three methods, one colour per fractal dimension, ratios below."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11.0, 6.0), layout="constrained")
    axes = figure.subplots(2, 3, sharex=True, height_ratios=[1.5, 1.0])
    colours = ("tab:blue", "tab:orange", "tab:green", "tab:red", "tab:purple", "tab:brown", "tab:pink", "0.4")
    for column, (name, label) in enumerate(QUANTITIES.items()):
        above, below = axes[:, column]
        for index, (sample, comparison) in enumerate(zip(samples, comparisons, strict=True)):
            colour = colours[index % len(colours)]
            force = np.asarray(comparison.normal_force)
            solved = np.asarray(getattr(comparison, name))
            law = np.asarray(getattr(comparison, f"law_{name}"))
            theory = np.asarray(getattr(comparison, f"persson_{name}")).mean(axis=0)
            mean = solved.mean(axis=0)
            title = f"D = {sample.fractal_dimension:g}"
            above.errorbar(force, mean, solved.std(axis=0), fmt="o", markersize=4, color=colour, label=title)
            above.plot(force, _positive(law), "-", color=colour)
            above.plot(force, theory, ":", color=colour)
            below.plot(force, _positive(law / mean), "-", color=colour)
            below.plot(force, theory / mean, ":", color=colour)
            scatter = solved.std(axis=0) / mean
            below.fill_between(
                force, 1.0 / (1.0 + scatter), 1.0 + scatter, color=colour, alpha=0.15, linewidth=0
            )
        above.set(xscale="log", yscale="log", ylabel=label)
        below.set(
            xscale="log",
            yscale="log",
            ylabel="ratio to boundary elements [-]",
            xlabel="normal force $F_n$ [N]",
        )
        below.axhline(1.0, color="black", linewidth=0.8)
    axes[0, 0].legend(fontsize=8)
    axes[0, 1].set_title("dots: boundary elements; line: fractal law, λ = 1; dotted: Persson", fontsize=10)
    return figure


def _positive(values: np.ndarray) -> np.ndarray:
    """Mask zeros (no elastic spot, no stiffness), which a logarithmic axis cannot show."""
    return np.where(values > 0.0, values, np.nan)

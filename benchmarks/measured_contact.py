"""The laws of randomly rough surfaces over boundary elements on measured surfaces, as flat patches.

    python benchmarks/measured_contact.py PROFILE_OR_MAP... [--position-unit mm] [--height-unit um] [--hardness 5.6]

The units are those of text files. Cuts each surface into patches, removes a parabola, mirrors them so that they are
periodic, and presses them on steel with 30 to 1000 MPa; with a hardness [GPa] no pressure exceeds it. Prints
p/(0.48 h_rms) and Persson's theory over the incremental stiffness of the boundary elements per area, with the largest
contact fraction, and the ranges that hold nine patches in ten, each surface with the same weight. Patches in contact
with more than half of their area, to which the laws do not apply, and states that do not converge are left out, and
counted.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from asperity.precision import use_double_precision

PRESSURES = (30e6, 100e6, 300e6, 1000e6)
POINTS = {1: 1024, 2: 128}  # of a patch along each side
MOST_PATCHES = 6
LARGEST_FRACTION = 0.5


def patches(heights: np.ndarray) -> list[np.ndarray]:
    """Pieces of a profile or map, a parabola or a plane removed, and mirrored."""
    side = POINTS[heights.ndim]
    if heights.ndim == 1:
        start, stop = int(0.3 * heights.size), int(0.7 * heights.size)  # without the ends of rollers
        pieces = [heights[k : k + side] for k in range(start, stop - side + 1, side)]
        x = np.linspace(-1.0, 1.0, side)
        level = [piece - np.polynomial.polynomial.Polynomial.fit(x, piece, 2)(x) for piece in pieces]
        return [np.concatenate([piece, piece[::-1]]) for piece in level]
    found = []
    y, x = (each.ravel() for each in np.mgrid[-1.0 : 1.0 : side * 1j, -1.0 : 1.0 : side * 1j])
    base = np.column_stack([np.ones_like(x), x, y, x * x, x * y, y * y])
    for i in range(0, heights.shape[0] - side + 1, side):
        for j in range(0, heights.shape[1] - side + 1, side):
            piece = heights[i : i + side, j : j + side]
            if np.all(np.isfinite(piece)):
                flat = piece.ravel() - base @ np.linalg.lstsq(base, piece.ravel(), rcond=None)[0]
                piece = flat.reshape(side, side)
                found.append(np.block([[piece, piece[:, ::-1]], [piece[::-1], piece[::-1, ::-1]]]))
    return found


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--position-unit")
    parser.add_argument("--height-unit")
    parser.add_argument("--hardness", type=float)
    asked = parser.parse_args()
    hardness = None if asked.hardness is None else 1e9 * asked.hardness
    use_double_precision()
    from asperity.bem import PeriodicHalfSpace, elastic_pair, normal_contact, normal_stiffness
    from asperity.contact.exponential import decay_length
    from asperity.contact.persson_2007 import persson_decay_length, wave_spectrum
    from asperity.errors import InputError, NoSolutionError
    from asperity.surface.measure_files import read_surface

    steel = elastic_pair(
        youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )
    every: list[tuple[float, float]] = []  # by the exponential law and by Persson's theory
    weights: list[float] = []
    left_out = 0
    for file in asked.files:
        own = {"position_unit": asked.position_unit} if file.suffix == ".txt" else {}
        surface = read_surface(path=file, height_unit=asked.height_unit if own else None, **own)
        pixel = (surface.spacing_across, surface.spacing)[-surface.heights.ndim :]
        cut = patches(np.asarray(surface.heights))
        cut = (
            [cut[k] for k in np.unique(np.linspace(0, len(cut) - 1, MOST_PATCHES).astype(int))] if cut else []
        )
        print(f"{file.name}: {len(cut)} patches, rms {[f'{1e6 * each.std():.3g}' for each in cut]} um")
        known = len(every)
        for pressure in PRESSURES:
            ratios, fractions = [], []
            for heights in cut:
                half_space = PeriodicHalfSpace(steel, shape=heights.shape, pixel_size=pixel)
                area = float(half_space.nominal_area)
                try:
                    contact = normal_contact(
                        half_space, heights, normal_force=pressure * area, hardness=hardness
                    )
                    stiffness = float(normal_stiffness(half_space, contact.pressure > 0.0).stiffness) / area
                except (InputError, NoSolutionError):  # in complete contact an interface has no stiffness
                    left_out += 1
                    continue
                if float(contact.contact_fraction) > LARGEST_FRACTION:
                    left_out += 1
                    continue
                sides = tuple(count * size for count, size in zip(heights.shape, pixel, strict=True))
                theory = pressure / persson_decay_length(
                    spectrum=wave_spectrum(heights, sides=sides),
                    mean_pressure=pressure,
                    contact_modulus=steel.contact_modulus,
                )
                law = pressure / float(decay_length(rms_height=heights.std()))
                ratios.append((law / stiffness, float(theory) / stiffness))
                fractions.append(float(contact.contact_fraction))
            if ratios:
                told = ", ".join(f"{min(law):.2f} to {max(law):.2f}" for law in zip(*ratios, strict=True))
                print(
                    f"  {pressure / 1e6:5.0f} MPa  exponential, Persson over boundary elements {told}, "
                    f"contact {max(fractions):.2f}",
                    flush=True,
                )
            every += ratios
        count = len(every) - known
        weights += [1.0 / count] * count if count else []
    print(f"{len(every)} states, {left_out} left out; nine in ten, surfaces alike:")
    for law, values in zip(("exponential", "Persson"), zip(*every, strict=True), strict=True):
        low, high = np.quantile(values, [0.05, 0.95], weights=weights, method="inverted_cdf")
        print(f"  {law} between {low:.2f} and {high:.2f}")


if __name__ == "__main__":
    main()

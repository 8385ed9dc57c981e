"""The law of randomly rough surfaces over boundary elements of a roller on a measured map.

    python benchmarks/measured_rollers.py FOLDER [--form plane] [--hardness 5.6]

FOLDER has the measured files of the tests (``ASPERITY_SHARED_DATA``). Presses a steel roller on each map, in both
directions, a polynomial of second degree removed, or a plane, with line loads whose Hertzian width the map holds two
and a half times and more; with a hardness [GPa] no pressure exceeds it. The interface has the compliance of the rough
contact less that of the smooth one on the same grid. Prints K_n of 0.48 h over its stiffness, with the h that a joint
takes of the map at this width, and how many lie in the interval of a joint: the error of the law with the scatter of
the spectrum, its soft end with the form along the axis that the line load does not close; then the same by Persson's
theory of the same waves, model.contact_law = "persson_2007". Below, with the decay length of flat patches of the map by
boundary elements, model.contact_law = "measured", whose interval reaches from elastic patches to those with a hardness
(5.6 GPa, or the given one).
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from asperity.precision import use_double_precision

#: File → radius of the roller [m], line loads [N/m], coarser by.
MAPS: dict[str, tuple[float, tuple[float, ...], int]] = {
    "csafe_bullet_land_x3p/sample-land.x3p": (10e-3, (30e3, 100e3, 170e3), 2),
    "surfacetopography_examples/x3p-2.x3p": (3e-3, (2e3, 5e3), 3),
    "surfacetopography_examples/al3d-1.al3d": (3e-3, (2e3, 5e3), 1),
    "surfacetopography_examples/metropro-1.dat": (10e-3, (10e3, 80e3), 2),
    "surfacetopography_examples/sur-2.sur": (10e-3, (30e3, 300e3), 2),
    "surfacetopography_examples/tmd-1.tmd": (0.5e-3, (0.5e3, 2e3), 1),
}

#: Smaller changes of the compliance by the roughness are not resolved by the grid.
SMALLEST_SHARE = 0.02


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("--form", choices=("polynomial", "plane"), default="polynomial")
    parser.add_argument("--hardness", type=float)
    asked = parser.parse_args()
    use_double_precision()
    from asperity.bem import FreeHalfSpace, elastic_pair, normal_contact, normal_stiffness
    from asperity.bem.pressed_map import pressed_map
    from asperity.contact.creep_layer import layer_ratio
    from asperity.contact.exponential import OVER_BOUNDARY_ELEMENTS, decay_length, line_contact_factor
    from asperity.contact.persson_2007 import (
        PERSSON_OVER_BOUNDARY_ELEMENTS,
        persson_decay_length,
        sorted_waves,
        waves_along_line,
    )
    from asperity.errors import AsperityError
    from asperity.surface.height_spectrum import spectrum_of_map
    from asperity.surface.levelling import levelled
    from asperity.surface.measure_files import read_surface
    from asperity.surface.topography import Topography, without_missing

    pair = elastic_pair(
        youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )
    modulus = 206e9 / (2.0 * 0.91)
    hardness = None if asked.hardness is None else 1e9 * asked.hardness
    inside: list[bool] = []
    by_theory: list[bool] = []
    by_patches: list[bool] = []
    for name, (radius, loads, coarser) in MAPS.items():
        unit = {"height_unit": "um"} if name.endswith("tmd") else {}
        surface = without_missing(read_surface(path=asked.folder / name, **unit), choice="interpolate")
        rows, columns = (count // coarser for count in surface.heights.shape)
        mean = surface.heights[: rows * coarser, : columns * coarser].reshape(rows, coarser, columns, coarser)
        assert surface.spacing_across is not None
        flat = levelled(
            topography=Topography(
                mean.mean(axis=(1, 3)),
                surface.spacing * coarser,
                surface.spacing_across * coarser,
                source=surface.source,
            ),
            form=asked.form,
            **({"degree": 2} if asked.form == "polynomial" else {}),
        )
        assert flat.spacing_across is not None
        for rolling in ("x", "y"):
            spectrum = spectrum_of_map(topography=flat, rolling=rolling)
            pixel = (flat.spacing_across, flat.spacing)
            across, length = (flat.size[0], flat.size[1]) if rolling == "x" else (flat.size[1], flat.size[0])
            axis = 1 if rolling == "x" else 0
            place = (np.arange(flat.heights.shape[axis]) - 0.5 * (flat.heights.shape[axis] - 1)) * pixel[axis]
            gap = place**2 if rolling == "x" else place[:, None] ** 2
            try:
                pressed = pressed_map(flat, rolling=rolling, hardness=(hardness or 5.6e9) / modulus)
            except AsperityError as error:
                print(f"{flat.source} {rolling}: {error}")
                pressed = None
            half_space = FreeHalfSpace(pair, shape=flat.heights.shape, pixel_size=pixel)
            for load in loads:
                width = 2.0 * math.sqrt(4.0 * load * radius / (math.pi * modulus))
                if 2.5 * width > across:
                    continue
                compliance: list[Any] = []
                try:
                    for heights in (flat.heights, 0.0 * flat.heights):
                        contact = normal_contact(
                            half_space,
                            heights - gap / (2.0 * radius),
                            normal_force=load * length,
                            hardness=hardness,
                        )
                        compliance.append(
                            1.0 / float(normal_stiffness(half_space, contact.pressure > 0.0).stiffness)
                        )
                except AsperityError as error:
                    print(f"{flat.source} {rolling} {load:g} N/m: {error}")
                    continue
                limit = min(length, spectrum.cut_off())
                square, deviation = spectrum.felt(rolling=1.0 / width, axial=1.0 / limit)
                interface = compliance[0] - compliance[1]

                def yielding(decay: float, load: float = load, length: float = length) -> float:
                    """Compliance of the asperities between elastic rollers by their decay length."""
                    rigid = load * length / decay
                    ratio = layer_ratio(
                        contact_modulus=modulus, contact_length=length, normal_stiffness=rigid
                    )
                    return 1.0 / (float(line_contact_factor(layer_ratio=ratio)) * rigid)

                waves, squares = spectrum.form(rolling=1.0 / width, axial=1.0 / limit)
                form = float(
                    persson_decay_length(
                        spectrum=waves_along_line(waves, squares, half_width=0.5 * width),
                        mean_pressure=load,
                        contact_modulus=modulus,
                    )
                )
                by_heights = float(decay_length(rms_height=math.sqrt(square)))
                ratio = interface / yielding(by_heights)
                scatter, share = math.exp(0.98 * deviation / square), compliance[0] / compliance[1]
                told = (
                    f"{flat.source:16} {rolling} {1e-3 * load:6.1f} N/mm 2b {1e6 * width:6.1f} um  "
                    f"h {1e6 * math.sqrt(square):.4f} um (times {scatter:.2f})  form {1e6 * form:.4f} um  "
                    f"rough over smooth {share:.3f}"
                )
                if abs(share - 1.0) < SMALLEST_SHARE:
                    print(f"{told}  not resolved")
                    continue

                def holds(
                    decay: float,
                    low: float,
                    high: float,
                    scatter: float = scatter,
                    form: float = form,
                    interface: float = interface,
                    yielding: Callable[[float], float] = yielding,
                ) -> bool:
                    """Whether the boundary elements lie between the ends of a decay length with its error."""
                    soft = yielding(decay * high * scatter + form)
                    return yielding(decay * low / scatter) <= interface <= soft

                inside.append(holds(by_heights, *OVER_BOUNDARY_ELEMENTS))
                print(
                    f"{told}  law over elements {ratio:5.2f}{'' if inside[-1] else '  outside'}", flush=True
                )
                pressure = load / width / modulus
                length_of_theory = persson_decay_length(
                    spectrum=sorted_waves(*spectrum.waves(rolling=1.0 / width, axial=1.0 / limit)),
                    mean_pressure=pressure,
                    contact_modulus=1.0,
                )
                theory = interface / yielding(float(length_of_theory))
                by_theory.append(holds(float(length_of_theory), *PERSSON_OVER_BOUNDARY_ELEMENTS))
                print(
                    f"{'':16} Persson over elements {theory:5.2f}{'' if by_theory[-1] else '  outside'}",
                    flush=True,
                )
                if pressed is None:
                    continue
                (elastic, wide), (capped, deep) = (
                    pressed.decay_ratio(pressure=pressure, capped=each) for each in (False, True)
                )
                by_map = elastic * math.sqrt(square)
                ratio = interface / yielding(by_map)
                by_patches.append(holds(by_map, capped / elastic * math.exp(-deep), math.exp(wide)))
                print(
                    f"{'':16} patches {elastic:.3f} to {capped:.3f} of h (times {math.exp(wide):.2f})  "
                    f"over elements {ratio:5.2f}{'' if by_patches[-1] else '  outside'}",
                    flush=True,
                )
    print(f"{sum(inside)} of {len(inside)} in the interval")
    print(f"{sum(by_theory)} of {len(by_theory)} in that of Persson's theory")
    print(f"{sum(by_patches)} of {len(by_patches)} in that of the patches")


if __name__ == "__main__":
    main()

"""``asperity surface``: measure files, make surfaces, combine two measurements."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import click

from asperity.cli.options import json_option, read_option
from asperity.cli.run_by_name import run_by_name
from asperity.unit_table import Dimension

_ESTIMATORS = ("automatic", "likelihood", "lines", "structure_function", "power_spectrum")
_FORMS = ("none", "mean", "line", "plane", "polynomial", "cylinder_x", "cylinder_y")


@click.group("surface")
def surface() -> None:
    """Measure D and G of rough surfaces, make such surfaces, combine two bodies."""


def _quantity(dimension: Dimension) -> Callable[[click.Context, click.Parameter, str | None], float | None]:
    """The callback of an option whose text has a unit: its SI value."""

    def read(_: click.Context, parameter: click.Parameter, value: str | None) -> float | None:
        name = parameter.opts[0].removeprefix("--")
        return None if value is None else read_option(name, value, dimension)

    return read


_length, _hardness = _quantity(Dimension.LENGTH), _quantity(Dimension.HARDNESS)


@surface.command("measure")
@click.argument("files", nargs=-1, required=True, type=click.Path(path_type=Path), metavar="FILE...")
@json_option("Print the measurement document (SI units) instead of text.")
@click.option(
    "--plot", type=click.Path(path_type=Path, dir_okay=False), help="Write a figure (PNG, PDF or SVG)."
)
@click.option("--position-unit", help="Unit of the positions, if a text file does not name it.")
@click.option(
    "--height-unit",
    help="Unit of the heights, or height of one count such as '1.5 nm', if the file does not name it.",
)
@click.option(
    "--spacing", callback=_length, help="Distance of the points, such as '0.5 um', if the file has none."
)
@click.option(
    "--decimal",
    type=click.Choice(["auto", "point", "comma"]),
    default="auto",
    show_default=True,
    help="Decimal sign of text files.",
)
@click.option("--column", help="Column of the heights in a text file, by its heading or its number from 1.")
@click.option(
    "--no-data",
    help="Number that marks missing points in the file, such as -9999, several with commas between them, or 'none' if "
    "every number is a height.",
)
@click.option(
    "--any-size",
    is_flag=True,
    help="Accept surfaces shorter than 1 um or longer than 1 m, and heights larger than the surface.",
)
@click.option(
    "--missing",
    type=click.Choice(["refuse", "longest", "interpolate"]),
    default="refuse",
    show_default=True,
    help="Missing points: refuse, keep the longest complete piece, or interpolate gaps along x.",
)
@click.option(
    "--form",
    type=click.Choice(_FORMS),
    help="Form removed before the evaluation.  [default: line; plane for maps]",
)
@click.option("--degree", type=int, help="Degree of a polynomial form, 0 to 12.")
@click.option(
    "--outliers",
    type=float,
    help="Treat points farther than so many robust standard deviations from the local median as missing.",
)
@click.option(
    "--from", "start", callback=_length, help="Start of the section of a profile, such as '468 um'."
)
@click.option("--to", "stop", callback=_length, help="End of the section of a profile.")
@click.option(
    "--cut-off",
    callback=_length,
    help="Cut-off lambda_c of the roughness parameters of a profile, such as '0.8 mm', or nesting index of the "
    "L-filter of a map.  [default: the class of ISO 21920-3 by Ra; none for maps]",
)
@click.option(
    "--short-cut-off",
    callback=_length,
    help="Cut-off lambda_s, or nesting index of the S-filter of a map.  [default: that of ISO 3274; none for maps]",
)
@click.option(
    "--direction",
    type=click.Choice(["x", "y"]),
    default="x",
    show_default=True,
    help="Direction in a map in which D and G are evaluated as the result, and in which the contact rolls.",
)
@click.option(
    "--lay",
    type=click.Choice(["rolling", "axis", "isotropic"]),
    help="Direction of the grooves of a profile, which is measured across them: the rolling direction, the rollers' "
    "axis, or none. A joint needs it of profiles.",
)
@click.option(
    "--estimator",
    type=click.Choice(_ESTIMATORS),
    default="automatic",
    show_default=True,
    help="How D and G are estimated; automatic is lines if that applies, otherwise likelihood.",
)
@click.option("--shortest", callback=_length, help="Shortest wavelength of the band.  [default: automatic]")
@click.option("--longest", callback=_length, help="Longest wavelength of the band.  [default: automatic]")
@click.option(
    "--gamma", type=float, default=1.5, show_default=True, help="Frequency ratio of the model, above 1."
)
@click.option(
    "--hardness",
    callback=_hardness,
    help='Press a map by boundary elements, elastic and with no pressure above this hardness, such as "7 GPa", of the '
    'softer body on steel: what a joint with model.contact_law = "measured" takes.',
)
@run_by_name
def measure() -> None:
    """Spectrum of profile or map files, and fractal dimension D and roughness G with 95 % intervals.

    Spectra of several profile files of one surface are averaged. Without a power law over at least one decade of
    wavelength there are no D and G; 'asperity joint --surface' takes the spectrum. Exit code 3: not that either.
    """


@surface.command("formats")
@run_by_name
def formats() -> None:
    """List the formats of surface files: what writes them, and what has to be stated.

    Formats with a * need the optional package SurfaceTopography.
    """


@surface.command("synthesize")
@click.argument("output", type=click.Path(path_type=Path, dir_okay=False))
@click.option(
    "--kind",
    type=click.Choice(["weierstrass", "self_affine", "spectral", "map"]),
    required=True,
    help="Weierstrass-Mandelbrot profile (6); exact self-affine noise; band-limited noise; map of it.",
)
@click.option("--fractal-dimension", "-D", type=float, required=True, help="D of a profile, 1 to 2.")
@click.option(
    "--fractal-roughness", "-G", callback=_length, required=True, help="G with its unit, such as '1e-9 m'."
)
@click.option(
    "--points", type=click.IntRange(16, 100_000_000), required=True, help="Points (along each side of a map)."
)
@click.option("--spacing", callback=_length, required=True, help="Distance of the points, such as '0.1 um'.")
@click.option("--seed", type=int, required=True, help="Seed of the random phases.")
@click.option("--periodic", is_flag=True, help="One period (spectral and map only).")
@click.option(
    "--gamma", type=float, default=1.5, show_default=True, help="Frequency ratio (weierstrass only)."
)
@run_by_name
def synthesize() -> None:
    """Write a surface of known D and G: .npy (heights in m) or .csv (x and z in m) of a profile."""


@surface.command("combine")
@click.argument("first", type=click.Path(path_type=Path))
@click.argument("second", type=click.Path(path_type=Path))
@json_option("Print the measurement document (SI units) instead of text.")
@run_by_name
def combine() -> None:
    """One equivalent surface of two measured bodies (two documents of ``measure --json``)."""

"""``asperity surface``: measure files, make surfaces, combine two measurements."""

from __future__ import annotations

import functools
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import in_unicode, json_option, read_option, save_image, show_blocks
from asperity.made_files import refuse_existing
from asperity.views.blocks import Bullets, Heading, Table
from asperity.writing import check_file, check_image, replacing

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from asperity.surface.height_spectrum import HeightSpectrum
    from asperity.surface.measure import MeasuredSurface
    from asperity.surface.measure_files import MeasuredFiles

_ESTIMATORS = ("automatic", "likelihood", "lines", "structure_function", "power_spectrum")
#: Options whose arguments are called otherwise.
ARGUMENTS = {
    "outliers": "outlier_threshold",
    "short_cut_off": "short_cutoff",
    "cut_off": "long_cutoff",
    "gamma": "frequency_ratio",
    "shortest": "shortest_wavelength",
    "longest": "longest_wavelength",
}
#: Points of a profile that are computed at once: in less than a second.
_AT_ONCE = 1_000_000
_FORMS = ("none", "mean", "line", "plane", "polynomial", "cylinder_x", "cylinder_y")


@click.group("surface")
def surface() -> None:
    """Measure D and G of rough surfaces, make such surfaces, combine two bodies."""


def _quantity(dimension: str) -> Callable[..., float | None]:
    def read(_: click.Context, parameter: click.Parameter, value: str | None) -> float | None:
        from asperity.units import Dimension

        name = parameter.opts[0].removeprefix("--")
        return None if value is None else read_option(name, value, Dimension[dimension])

    return read


_length, _hardness = _quantity("LENGTH"), _quantity("HARDNESS")


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
def measure(
    files: tuple[Path, ...], as_json: bool, plot: Path | None, hardness: float | None, **options: Any
) -> int:
    """Spectrum of profile or map files, and fractal dimension D and roughness G with 95 % intervals.

    Spectra of several profile files of one surface are averaged. Without a power law over at least one decade of
    wavelength there are no D and G; 'asperity joint --surface' takes the spectrum. Exit code 3: not that either.
    """
    from asperity.precision import use_double_precision
    from asperity.surface.measure_files import files_document, measured_files

    check_image(plot, *files)
    use_double_precision()
    measured = measured_files(files, **{ARGUMENTS.get(name, name): value for name, value in options.items()})
    if hardness is not None:
        from asperity.bem.pressed_map import with_pressed_map
        from asperity.precision import use_compilation_cache

        use_compilation_cache()
        measured = with_pressed_map(measured, hardness=hardness)
    if plot is not None:
        from asperity.surface.plots import measurement_figure

        shown, direction = measured.topographies, measured.direction
        save_image(measurement_figure(surfaces=shown, fit=measured.fit, direction=direction), plot)
    if as_json:
        click.echo(json.dumps(in_unicode(files_document(measured)), indent=2))
    else:
        _print(measured)
    if measured.spectrum is None and isinstance(measured.fit, str):
        if not as_json:
            click.echo(f"refused: {measured.fit}", err=True)
        click.get_current_context().exit(3)
    return 0


def _waves(spectrum: HeightSpectrum) -> str:
    """The rms of the heights by the longest wave along the rollers' axis, or along a profile."""
    from asperity.surface.roughness_average import STANDARD_CUT_OFFS

    words = []
    for _, cut_off in STANDARD_CUT_OFFS:
        if cut_off > spectrum.longest_wave:
            break
        square, _ = spectrum.felt(rolling=1.0 / cut_off, axial=1.0 / cut_off)
        words.append(f"{1e3 * cut_off:g} mm {1e6 * square**0.5:.3g} um")
    square, _ = spectrum.felt(rolling=0.0, axial=0.0)
    return ", ".join([*words, f"all {1e6 * square**0.5:.3g} um"])


def _parameters(s: MeasuredSurface, axial: bool) -> Iterator[str]:
    """Lines of the parameters of one surface; whether a profile may run along the axis of a roller."""
    h, letter, total = s.heights, *(("S", "Sz") if s.topography.is_map else ("P", "Pt"))
    heights = (
        f"{letter}a {1e6 * h.arithmetic_mean:.6g} um, {letter}q {1e6 * h.root_mean_square:.6g} um, "
        f"{letter}sk {h.skewness:.4g}, {letter}ku {h.kurtosis:.4g}, {total} {1e6 * h.total_height:.6g} um"
    )
    if s.topography.is_map:
        filters = [
            f"no {name}-filter" if index is None else f"{name}-filter {1e6 * index:.6g} um"
            for name, index in zip("SL", s.filters, strict=True)
        ]
        yield f"{s.scale_limited} ({', '.join(filters)}): {heights}"
        if h.developed_area_ratio:
            length, aspect = h.correlation_length, h.aspect_ratio
            yield (
                f"  Sdr {100 * h.developed_area_ratio:.4g} %, "
                + ("no Sal" if length is None else f"Sal {1e6 * length:.4g} um, ")
                + ("" if length is None else "no Str" if aspect is None else f"Str {aspect:.3f}")
                + (": correlated over half of the map" if aspect is None else "")
            )
        return
    width = "" if h.mean_element_width is None else f", PSm {1e6 * h.mean_element_width:.6g} um"
    yield f"without a filter: {heights}{width}"
    rough = s.roughness
    if isinstance(rough, str):
        yield f"no roughness parameters: {rough}"
    elif rough is not None:
        none = "no lambda_s, the points lie too far apart"
        short = none if rough.short_cut_off is None else f"lambda_s {1e6 * rough.short_cut_off:.4g} um"
        yield (
            f"behind the cut-off {1e3 * rough.cut_off:.6g} mm ({rough.choice}; {short}), "
            f"{rough.sections} section(s){'' if rough.sections == 5 else ' instead of five, the profile is too short'}:"
        )
        words = [f"{symbol} {1e6 * value:.4g} um" for symbol, value in rough.lengths.items()]
        for symbol, value in rough.numbers.items():
            words.append(f"{symbol} {100 * value:.3g} %" if "mr" in symbol else f"{symbol} {value:.4g}")
        yield f"  {', '.join(words)}"
    crown, log = s.crown, s.logarithmic
    if crown is None:
        return
    if log is not None and log.stands_out(crown):
        yield (
            f"logarithmic profile (Lundberg): A {1e6 * log.coefficient:.3g} um, length {1e3 * log.length:.4g} mm, "
            f"misfit {1e6 * log.misfit:.3g} um rms; joint files know circular crowns only"
        )
    shape = (
        f"radius {abs(crown.radius):.4g} m ({abs(crown.middle_radius):.4g} m of the middle half), "
        f"{1e6 * abs(crown.drop):.4g} um from middle to end, misfit {1e6 * crown.misfit:.3g} um rms"
    )
    if not crown.stands_out:
        yield f"no circular crown: {shape}; --from and --to leave chamfers and reliefs out"
        return
    yield f"{'crown' if crown.drop > 0.0 else 'hollow'}: {shape}" + (
        f'; in [drive] of a joint file, along the axis: ..._crown_radius = "{crown.radius:.4g} m"'
        if axial and crown.drop > 0.0
        else ""
    )


def _print(measured: MeasuredFiles) -> None:
    fits, direction = measured.fits, measured.direction
    lay = None if measured.spectrum is None else measured.spectrum.lay
    for s in measured.surfaces:
        size = " x ".join(f"{1e6 * length:.6g} um" for length in s.topography.size)
        click.echo(f"{s.topography.source}: {s.heights.points} points, {size}")
        for note in s.topography.notes:
            click.echo(f"  {note}")
        for line in _parameters(s, axial=lay != "axis"):
            click.echo(f"  {line}")
    for name, fit in (("x", fits.along_x), ("y", fits.along_y)):
        if fit is None:
            continue
        mark = "" if fits.along_y is None else f" along {name}{' (the result)' if name == direction else ''}"
        if isinstance(fit, str):
            end = "; the joint uses the measured spectrum" if name == direction and measured.spectrum else ""
            click.echo(f"{mark.strip()}{': ' if mark else ''}{fit}{end}")
            continue
        d_low, d_high = fit.dimension_interval(confidence=0.95)
        g_low, g_high = fit.roughness_interval(confidence=0.95)
        click.echo(
            f"fractal dimension D{mark}: {fit.fractal_dimension:.4f}  (95 %: {d_low:.4f} .. {d_high:.4f})"
        )
        click.echo(
            f"fractal roughness G{mark}: {fit.fractal_roughness:.4g} m  (95 %: {g_low:.4g} .. {g_high:.4g} m), "
            f"gamma {fit.frequency_ratio:g}"
        )
        rolls = fit.roll_off_wavelength
        click.echo(
            f"  band {1e6 * fit.shortest_wavelength:.4g} .. {1e6 * fit.longest_wavelength:.4g} um, estimator "
            f"{fit.estimator}, {fit.profiles} profile(s)"
            + ("" if rolls is None else f", roll-off at {1e6 * rolls:.3g} um")
        )
        if fit.reduced_chi_square is None:
            click.echo(f"  scatter of the amplitudes about the model {100 * fit.misfit:.1f} %")
        else:
            click.echo(
                f"  chi-square per degree of freedom {fit.reduced_chi_square:.2f}, misfit beyond sampling "
                f"scatter {100 * fit.misfit:.1f} % rms"
            )
    if fits.anisotropy_ratio is not None:
        click.echo(f"amplitude along x over along y: {fits.anisotropy_ratio:.3f}")
    if measured.spectrum is not None:
        click.echo(f"rms height of the waves shorter than: {_waves(measured.spectrum)}")
        pressed = measured.spectrum.pressed
        if pressed is not None:
            from asperity.bem.pressed_map import PRESSURES_ON_STEEL

            words = [
                f"{1e-6 * load:g} MPa {pressed.decay_ratio(pressure=relative, capped=False)[0]:.3g}"
                for load, relative in zip(PRESSURES_ON_STEEL, pressed.pressure, strict=True)
            ]
            click.echo(f"boundary elements, decay length over rms height at {', '.join(words)}")
        if not measured.spectrum.is_map and measured.spectrum.lay is None:
            click.echo("a joint needs the lay of a profile: --lay rolling, axis or isotropic")


@surface.command("formats")
def formats() -> None:
    """List the formats of surface files: what writes them, and what has to be stated.

    Formats with a * need the optional package SurfaceTopography.
    """
    from asperity.surface.file_formats import FORMATS

    rows = [
        (
            f"{known.name}{' *' if known.reader == 'package' else ''}",
            known.file_names,
            known.instruments,
            known.stated,
        )
        for known in FORMATS
        if known.reader
    ]
    head = ("format", "files", "from", "to be stated")
    show_blocks(
        Table("Formats that are read", head, rows, words=(0, 1, 2, 3)),
        Heading("Not read"),
        Bullets([f"{known.title}: {known.export}" for known in FORMATS if not known.reader]),
    )


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
def synthesize(output: Path, kind: str, **options: Any) -> None:
    """Write a surface of known D and G: .npy (heights in m) or .csv (x and z in m) of a profile."""
    import numpy as np

    from asperity.errors import InputError
    from asperity.precision import use_double_precision
    from asperity.surface import synthesis
    from asperity.surface.conventions import validated_fractal

    if output.suffix not in ((".npy",) if kind == "map" else (".npy", ".csv")):
        raise InputError(f"{output}: write a .npy file, or a .csv file of a profile")
    check_file(output)
    refuse_existing(output)
    use_double_precision()
    D, G = validated_fractal(
        fractal_dimension=options["fractal_dimension"], fractal_roughness=options["fractal_roughness"]
    )
    points, spacing, random = options["points"], options["spacing"], np.random.default_rng(options["seed"])
    common = {"spacing": spacing, "fractal_dimension": D, "random": random}
    if options["periodic"] and kind in ("weierstrass", "self_affine"):
        raise InputError(f"a surface of the kind '{kind}' is not periodic; leave --periodic out")
    if kind == "map":
        if points > 16384:
            raise InputError(f"a map of {points} by {points} points is too large; 16384 a side is the limit")
        heights = synthesis.spectral_surface(
            rows=points, columns=points, areal_fractal_roughness=G, periodic=options["periodic"], **common
        )
    elif kind == "spectral":
        heights = synthesis.spectral_profile(
            points=points, fractal_roughness=G, periodic=options["periodic"], **common
        )
    elif kind == "self_affine":
        heights = synthesis.self_affine_profile(points=points, fractal_roughness=G, **common)
    else:
        from asperity.surface.weierstrass import weierstrass_mandelbrot_profile

        gamma = options["gamma"]
        if not gamma > 1.0:
            raise InputError(f"gamma is {gamma}; it must be above 1")
        terms = int(np.floor(np.log(points / 2) / np.log(gamma))) + 1
        profile = functools.partial(
            weierstrass_mandelbrot_profile,
            profile_length=points * spacing,
            fractal_dimension=D,
            fractal_roughness=G,
            frequency_ratio=gamma,
            phases=random.uniform(0.0, 2.0 * np.pi, terms),
            lowest_index=0,
        )
        parts = np.array_split(np.arange(points) * spacing, 1 + points // _AT_ONCE)
        heights = np.concatenate([profile(position=part) for part in parts])
    with replacing(output) as part:
        if output.suffix == ".npy":
            np.save(part, heights)
        else:
            table = np.stack([np.arange(points) * spacing, heights], axis=1)
            np.savetxt(part, table, delimiter=",", header="x [m],z [m]", comments="", fmt="%.17g")
    click.echo(
        f"wrote {output}: {heights.shape} heights in m, spacing {spacing:.6g} m, rms {heights.std():.6g} m"
    )


@surface.command("combine")
@click.argument("first", type=click.Path(path_type=Path))
@click.argument("second", type=click.Path(path_type=Path))
@json_option("Print the measurement document (SI units) instead of text.")
def combine(first: Path, second: Path, as_json: bool) -> None:
    """One equivalent surface of two measured bodies (two documents of ``measure --json``)."""
    from asperity.precision import use_double_precision

    use_double_precision()
    from asperity.surface.measured_roughness import read_roughness, roughness_document, two_bodies

    both = two_bodies(read_roughness(path=first), read_roughness(path=second))
    if as_json:
        click.echo(json.dumps(in_unicode(roughness_document(both)), indent=2))
        return
    click.echo(f"{both.source}")
    if both.fractal is None:
        click.echo(f"{both.no_power_law}; the joint uses the measured spectra")
        return
    interval = both.fractal.interval(confidence=0.95)
    (d_low, d_high), (g_low, g_high) = interval["fractal_dimension"], interval["fractal_roughness"]
    click.echo(
        f"fractal dimension D: {float(both.fractal.fractal_dimension):.4f}  (95 %: {d_low:.4f} .. {d_high:.4f})"
    )
    click.echo(
        f"fractal roughness G: {float(both.fractal.fractal_roughness):.4g} m  (95 %: {g_low:.4g} .. {g_high:.4g} m)"
    )

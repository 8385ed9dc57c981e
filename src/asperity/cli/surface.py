"""``asperity surface``: measure files, make surfaces, combine two measurements."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import say_written
from asperity.writing import check_file, check_image, replacing, write_image

if TYPE_CHECKING:
    from asperity.surface.fractal_fit import FractalFit
    from asperity.surface.measure import DirectionalFits, MeasuredSurface

_ESTIMATORS = ("automatic", "likelihood", "lines", "structure_function", "power_spectrum")
_FORMS = ("none", "mean", "line", "plane", "polynomial", "cylinder_x", "cylinder_y")


@click.group("surface")
def surface() -> None:
    """Measure D and G of rough surfaces, make such surfaces, combine two bodies."""


def _length(context: click.Context, parameter: click.Parameter, value: str | None) -> float | None:
    if value is None:
        return None
    from asperity.units import Dimension, parse_quantity

    return parse_quantity(value, Dimension.LENGTH)


@surface.command("measure")
@click.argument("files", nargs=-1, required=True, type=click.Path(path_type=Path), metavar="FILE...")
@click.option(
    "--json", "as_json", is_flag=True, help="Print the measurement document (SI units) instead of text."
)
@click.option(
    "--plot", type=click.Path(path_type=Path, dir_okay=False), help="Write a figure (PNG, PDF or SVG)."
)
@click.option("--position-unit", help="Unit of the positions, if a text file does not name it.")
@click.option("--height-unit", help="Unit of the heights, if the file does not name it.")
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
    "--lambda-s", callback=_length, help="Short cutoff of the Gaussian filter, for height parameters only."
)
@click.option(
    "--lambda-c", callback=_length, help="Long cutoff of the Gaussian filter, for height parameters only."
)
@click.option(
    "--direction",
    type=click.Choice(["x", "y"]),
    default="x",
    show_default=True,
    help="Direction in a map in which D and G are evaluated as the result.",
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
def measure(files: tuple[Path, ...], as_json: bool, plot: Path | None, **options: Any) -> int:
    """Fractal dimension D and roughness G of profile or map files, with 95 % intervals.

    Spectra of several profile files of one surface are averaged. Exit code 3: no power law over at least one
    decade of wavelength.
    """
    from asperity.errors import InputError
    from asperity.precision import use_double_precision
    from asperity.surface.levelling import default_form
    from asperity.surface.measure import Conditioning, conditioned, directional_fits
    from asperity.surface.read import read_surface

    check_image(plot)
    use_double_precision()
    surfaces = []
    for file in files:
        topography = read_surface(
            path=file,
            position_unit=options["position_unit"],
            height_unit=options["height_unit"],
            spacing=options["spacing"],
            decimal=options["decimal"],
            any_size=options["any_size"],
        )
        if options["start"] is not None or options["stop"] is not None:
            start = options["start"] if options["start"] is not None else 0.0
            stop = options["stop"] if options["stop"] is not None else topography.size[0]
            topography = topography.cut(start=start, stop=stop)
        conditioning = Conditioning(
            form=options["form"] or default_form(topography),
            degree=options["degree"],
            missing=options["missing"],
            outlier_threshold=options["outliers"],
            short_cutoff=options["lambda_s"],
            long_cutoff=options["lambda_c"],
        )
        surfaces.append(conditioned(topography=topography, conditioning=conditioning))
    if options["direction"] == "y" and not surfaces[0].topography.is_map:
        raise InputError("a profile has no direction y; leave --direction out")
    topographies = [s.topography for s in surfaces]
    fits = directional_fits(
        surfaces=surfaces,
        estimator=options["estimator"],
        frequency_ratio=options["gamma"],
        shortest_wavelength=options["shortest"],
        longest_wavelength=options["longest"],
    )
    chosen = fits.along_y if options["direction"] == "y" else fits.along_x
    assert chosen is not None
    source = " + ".join(s.topography.source for s in surfaces)
    if plot is not None:
        _write_figure(plot, topographies, chosen, options["direction"])
    if as_json:
        click.echo(json.dumps(_document(surfaces, fits, chosen, source, options["direction"]), indent=2))
    else:
        _print(surfaces, fits, options["direction"])
    if isinstance(chosen, str):
        if not as_json:
            click.echo(f"refused: {chosen}", err=True)
        click.get_current_context().exit(3)
    return 0


def _write_figure(plot: Path, topographies: list, fit: FractalFit | str, direction: str) -> None:
    from asperity.surface.plots import measurement_figure

    write_image(measurement_figure(surfaces=topographies, fit=fit, direction=direction), plot)
    say_written(plot)


def _document(
    surfaces: list[MeasuredSurface],
    fits: DirectionalFits,
    chosen: FractalFit | str,
    source: str,
    direction: str,
) -> dict[str, Any]:
    from asperity.surface.measurement import SCHEMA, SCHEMA_VERSION, measurement_document, surface_measurement

    document: dict[str, Any]
    if isinstance(chosen, str):
        document = {"schema": SCHEMA, "schema_version": SCHEMA_VERSION, "source": source, "refused": chosen}
    else:
        document = measurement_document(measurement=surface_measurement(fit=chosen, source=source))
        document["noise_density_m3"] = chosen.noise_density
        document["height_step_m"] = chosen.height_step
        document["misfit"] = chosen.misfit
        document["reduced_chi_square"] = chosen.reduced_chi_square
        document["roll_off_wavelength_m"] = chosen.roll_off_wavelength
    document["direction"] = direction
    document["anisotropy_ratio"] = fits.anisotropy_ratio
    document["files"] = [
        {
            "name": s.topography.source,
            "size_m": list(s.topography.size),
            "points": s.heights.points,
            "notes": list(s.topography.notes),
            ("Sa_m" if s.topography.is_map else "Ra_m"): s.heights.arithmetic_mean,
            ("Sq_m" if s.topography.is_map else "Rq_m"): s.heights.root_mean_square,
            ("Ssk" if s.topography.is_map else "Rsk"): _finite(s.heights.skewness),
            ("Sku" if s.topography.is_map else "Rku"): _finite(s.heights.kurtosis),
            ("Sz_m" if s.topography.is_map else "Rt_m"): s.heights.total_height,
            "RSm_m": s.heights.mean_element_width,
        }
        for s in surfaces
    ]
    return document


def _finite(value: float) -> float | None:
    return value if value == value else None


def _print(surfaces: list[MeasuredSurface], fits: DirectionalFits, direction: str) -> None:
    for s in surfaces:
        letter = "S" if s.topography.is_map else "R"
        size = " x ".join(f"{1e6 * length:.6g} um" for length in s.topography.size)
        click.echo(f"{s.topography.source}: {s.heights.points} points, {size}")
        for note in s.topography.notes:
            click.echo(f"  {note}")
        h = s.heights
        total = "Sz" if s.topography.is_map else "Rt"
        click.echo(
            f"  {letter}a {1e6 * h.arithmetic_mean:.6g} um, {letter}q {1e6 * h.root_mean_square:.6g} um, "
            f"{letter}sk {h.skewness:.4g}, {letter}ku {h.kurtosis:.4g}, {total} {1e6 * h.total_height:.6g} um"
            + ("" if h.mean_element_width is None else f", RSm {1e6 * h.mean_element_width:.6g} um")
        )
    for name, fit in (("x", fits.along_x), ("y", fits.along_y)):
        if fit is None:
            continue
        mark = "" if fits.along_y is None else f" along {name}{' (the result)' if name == direction else ''}"
        if isinstance(fit, str):
            if name != direction:
                click.echo(f"{mark.strip()}: {fit}")
            continue
        d_low, d_high = fit.dimension_interval(confidence=0.95)
        g_low, g_high = fit.roughness_interval(confidence=0.95)
        click.echo(
            f"fractal dimension D{mark}: {fit.fractal_dimension:.4f}  (95 %: {d_low:.4f} .. {d_high:.4f})"
        )
        click.echo(
            f"fractal roughness G{mark}: {fit.fractal_roughness:.4g} m  (95 %: {g_low:.4g} .. "
            f"{g_high:.4g} m), "
            f"gamma {fit.frequency_ratio:g}"
        )
        click.echo(
            f"  band {1e6 * fit.shortest_wavelength:.4g} .. {1e6 * fit.longest_wavelength:.4g} um, "
            f"estimator {fit.estimator}, {fit.profiles} profile(s)"
            + (
                ""
                if fit.roll_off_wavelength is None
                else f", roll-off at {1e6 * fit.roll_off_wavelength:.3g} um"
            )
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
        heights = np.asarray(
            weierstrass_mandelbrot_profile(
                position=np.arange(points) * spacing,
                profile_length=points * spacing,
                fractal_dimension=D,
                fractal_roughness=G,
                frequency_ratio=gamma,
                phases=random.uniform(0.0, 2.0 * np.pi, terms),
                lowest_index=0,
            )
        )
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
@click.option(
    "--json", "as_json", is_flag=True, help="Print the measurement document (SI units) instead of text."
)
def combine(first: Path, second: Path, as_json: bool) -> None:
    """One equivalent D and G of two measured bodies (two documents of ``measure --json``)."""
    from asperity.precision import use_double_precision

    use_double_precision()
    from asperity.surface.equivalent import equivalent_surface
    from asperity.surface.measurement import measurement_document, read_measurement

    both = equivalent_surface(first=read_measurement(path=first), second=read_measurement(path=second))
    if as_json:
        click.echo(json.dumps(measurement_document(measurement=both), indent=2))
        return
    interval = both.interval(confidence=0.95)
    (d_low, d_high), (g_low, g_high) = interval["fractal_dimension"], interval["fractal_roughness"]
    click.echo(f"{both.source}")
    click.echo(
        f"fractal dimension D: {float(both.fractal_dimension):.4f}  (95 %: {d_low:.4f} .. {d_high:.4f})"
    )
    click.echo(
        f"fractal roughness G: {float(both.fractal_roughness):.4g} m  (95 %: {g_low:.4g} .. {g_high:.4g} m)"
    )

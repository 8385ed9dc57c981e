"""What the command of :mod:`asperity.cli.surface` does."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
import numpy as np

from asperity.cli.terminal import in_unicode, save_image, show_blocks
from asperity.errors import InputError
from asperity.made_files import refuse_existing
from asperity.surface import synthesis
from asperity.surface.conventions import validated_fractal
from asperity.surface.file_formats import FORMATS
from asperity.surface.height_spectrum import HeightSpectrum
from asperity.surface.measure import MeasuredSurface
from asperity.surface.measure_files import MeasuredFiles, files_document, measured_files
from asperity.surface.measured_roughness import read_roughness, roughness_document, two_bodies
from asperity.surface.roughness_average import STANDARD_CUT_OFFS
from asperity.surface.weierstrass import weierstrass_mandelbrot_profile
from asperity.views.blocks import Bullets, Heading, Table
from asperity.writing import check_file, check_image, replacing

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


def measure(
    files: tuple[Path, ...], as_json: bool, plot: Path | None, hardness: float | None, **options: Any
) -> int:
    """What ``asperity surface measure`` does; its options stand in :mod:`asperity.cli.surface`."""
    check_image(plot, *files)
    measured = measured_files(files, **{ARGUMENTS.get(name, name): value for name, value in options.items()})
    if hardness is not None:
        from asperity.bem.pressed_map import with_pressed_map  # which imports JAX

        measured = with_pressed_map(measured, hardness=hardness)
    if plot is not None:
        from asperity.surface.plots import measurement_figure  # which imports matplotlib

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
            from asperity.bem.pressed_map import PRESSURES_ON_STEEL  # which imports JAX

            words = [
                f"{1e-6 * load:g} MPa {pressed.decay_ratio(pressure=relative, capped=False)[0]:.3g}"
                for load, relative in zip(PRESSURES_ON_STEEL, pressed.pressure, strict=True)
            ]
            click.echo(f"boundary elements, decay length over rms height at {', '.join(words)}")
        if not measured.spectrum.is_map and measured.spectrum.lay is None:
            click.echo("a joint needs the lay of a profile: --lay rolling, axis or isotropic")


def formats() -> None:
    """What ``asperity surface formats`` does; its options stand in :mod:`asperity.cli.surface`."""
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


def synthesize(
    output: Path,
    kind: str,
    fractal_dimension: float,
    fractal_roughness: float,
    points: int,
    spacing: float,
    seed: int,
    periodic: bool,
    gamma: float,
) -> None:
    """What ``asperity surface synthesize`` does; its options stand in :mod:`asperity.cli.surface`."""
    if output.suffix not in ((".npy",) if kind == "map" else (".npy", ".csv")):
        raise InputError(f"{output}: write a .npy file, or a .csv file of a profile")
    check_file(output)
    refuse_existing(output)
    D, G = validated_fractal(fractal_dimension=fractal_dimension, fractal_roughness=fractal_roughness)
    if periodic and kind in ("weierstrass", "self_affine"):
        raise InputError(f"a surface of the kind '{kind}' is not periodic; leave --periodic out")
    random = np.random.default_rng(seed)
    if kind == "map":
        if points > 16384:
            raise InputError(f"a map of {points} by {points} points is too large; 16384 a side is the limit")
        heights = synthesis.spectral_surface(
            rows=points,
            columns=points,
            spacing=spacing,
            fractal_dimension=D,
            areal_fractal_roughness=G,
            periodic=periodic,
            random=random,
        )
    elif kind == "spectral":
        heights = synthesis.spectral_profile(
            points=points,
            spacing=spacing,
            fractal_dimension=D,
            fractal_roughness=G,
            periodic=periodic,
            random=random,
        )
    elif kind == "self_affine":
        heights = synthesis.self_affine_profile(
            points=points, spacing=spacing, fractal_dimension=D, fractal_roughness=G, random=random
        )
    else:
        heights = _weierstrass(points, spacing, D, G, gamma, random)
    with replacing(output) as part:
        if output.suffix == ".npy":
            np.save(part, heights)
        else:
            table = np.stack([np.arange(points) * spacing, heights], axis=1)
            np.savetxt(part, table, delimiter=",", header="x [m],z [m]", comments="", fmt="%.17g")
    click.echo(
        f"wrote {output}: {heights.shape} heights in m, spacing {spacing:.6g} m, rms {heights.std():.6g} m"
    )


def _weierstrass(
    points: int, spacing: float, D: float, G: float, gamma: float, random: np.random.Generator
) -> np.ndarray:
    """Heights [m] of a Weierstrass-Mandelbrot profile with random phases, down to waves of two points."""
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
    return np.concatenate([profile(position=part) for part in parts])


def combine(first: Path, second: Path, as_json: bool) -> None:
    """What ``asperity surface combine`` does; its options stand in :mod:`asperity.cli.surface`."""
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

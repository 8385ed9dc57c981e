"""What the command of :mod:`asperity.cli.verify_contact` does."""

from __future__ import annotations

import dataclasses
import json
import math
import sys
from typing import Any, TypeAlias

import click
import numpy as np
from rich.console import Console
from rich.progress import Progress

from asperity.bem import elastic_pair
from asperity.bem.pressed_map import STATES
from asperity.cli.options import read_option
from asperity.cli.progress import progress_bar
from asperity.cli.runs.surface import ARGUMENTS
from asperity.cli.surface import measure
from asperity.cli.terminal import prepare_output, print_json, save_image
from asperity.cli.verify_contact import OF_MAPS
from asperity.errors import InputError
from asperity.surface.measure_files import measured_files
from asperity.units import Dimension
from asperity.verify.comparison import Comparison, Sample, compare, comparison_figure
from asperity.verify.measured_map import MapComparison, compare_map, map_document, map_figure
from asperity.writing import check_image

#: A number, or lists of numbers in lists.
_Nested: TypeAlias = "float | list[_Nested]"

_OF_KNOWN = (
    *("dimensions", "roughness", "side", "pixels_per_wave", "seeds", "loads", "lowest", "highest"),
    *("gamma", "elastic"),
)
_NOT_READ = ("files", "as_json", "plot", "hardness")
_OPTIONS = {"dimensions": "dimension", "lowest": "from", "highest": "to"}


def verify_contact(
    dimensions: tuple[float, ...],
    roughness: str,
    side: str,
    points: int,
    pixels_per_wave: float,
    seeds: int,
    loads: int,
    lowest: float,
    highest: float,
    youngs_modulus: str,
    poisson_ratio: float,
    hardness: str,
    gamma: float,
    elastic: bool,
    surface_file: str | None,
    plot_file: str | None,
    as_json: bool,
    **reading: Any,
) -> None:
    """What ``asperity verify-contact`` does; its options stand in :mod:`asperity.cli.verify_contact`."""
    check_image(plot_file, *([surface_file] if surface_file else []))
    _refuse_options(_OF_KNOWN if surface_file else OF_MAPS, surface_file)
    if surface_file:
        _verify_map(
            surface_file,
            moduli=(read_option("youngs-modulus", youngs_modulus, Dimension.PRESSURE), poisson_ratio),
            hardness=read_option("hardness", hardness, Dimension.HARDNESS),
            points=points,
            plot_file=plot_file,
            as_json=as_json,
            **reading,
        )
        return
    known = {
        "fractal_roughness": read_option("roughness", roughness, Dimension.LENGTH),
        "side": read_option("side", side, Dimension.LENGTH),
        "youngs_modulus": read_option("youngs-modulus", youngs_modulus, Dimension.PRESSURE),
        "hardness": read_option("hardness", hardness, Dimension.HARDNESS),
        "poisson_ratio": poisson_ratio,
        "frequency_ratio": gamma,
        "pixels_per_wave": pixels_per_wave,
    }
    if loads < 1 or not 0.0 < lowest <= highest < 1.0:
        raise InputError(
            f"--loads {loads} --from {lowest:g} --to {highest:g}: at least one load is required, and 0 < from <= to < 1"
        )
    samples = [Sample(fractal_dimension=D, points=points, waves_per_side=2.0, **known) for D in dimensions]
    pressures = np.geomspace(lowest, highest, loads).tolist()
    comparisons = _compared(samples, seeds=seeds, pressures=pressures, elastic=elastic)
    if plot_file:
        save_image(comparison_figure(samples, comparisons), plot_file)
    if as_json:
        document = [_document(sample, result) for sample, result in zip(samples, comparisons, strict=True)]
        click.echo(json.dumps(document, indent=2))
        return
    _show(samples, comparisons)


def _compared(
    samples: list[Sample], *, seeds: int, pressures: list[float], elastic: bool
) -> list[Comparison]:
    """The comparison of each sample, of so many surfaces, at mean pressures over that of complete contact."""
    with Progress(console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty()) as progress:
        bar = progress.add_task("contacts", total=len(samples) * seeds * len(pressures))
        return [
            compare(
                sample,
                seeds=seeds,
                relative_pressures=pressures,
                elastic=elastic,
                solved=lambda: progress.advance(bar),
            )
            for sample in samples
        ]


def _refuse_options(names: tuple[str, ...], surface_file: str | None) -> None:
    """Refuse options that were given and have no effect."""
    context = click.get_current_context()
    given = [
        f"--{_OPTIONS.get(name, name).replace('_', '-')}"
        for name in names
        if context.get_parameter_source(name) is click.core.ParameterSource.COMMANDLINE
    ]
    if given:
        role = "describe known surfaces; leave them out with" if surface_file else "need"
        raise InputError(f"{', '.join(given)} {role} --surface")


def _verify_map(
    file: str,
    *,
    moduli: tuple[float, float],
    hardness: float,
    points: int,
    plot_file: str | None,
    as_json: bool,
    **reading: Any,
) -> None:
    """Compare the laws on a measured map."""
    pair = elastic_pair(
        youngs_modulus_1=moduli[0],
        youngs_modulus_2=moduli[0],
        poisson_ratio_1=moduli[1],
        poisson_ratio_2=moduli[1],
    )
    given = measure.make_context("measure", [file]).params | reading
    options = {ARGUMENTS.get(name, name): value for name, value in given.items() if name not in _NOT_READ}
    measured = measured_files([file], **options)
    with progress_bar("boundary elements") as done:
        states = iter(range(1, 1000))
        comparison = compare_map(
            measured, pair=pair, hardness=hardness, points=points, solved=lambda: done(next(states), STATES)
        )
    if plot_file:
        save_image(map_figure(comparison, measured), plot_file)
    if as_json:
        print_json(map_document(comparison, source=measured.source))
        return
    _show_map(comparison, measured.source)


def _show_map(comparison: MapComparison, source: str) -> None:
    """Print the verdict and one row for each pressure."""
    prepare_output()
    pressed = comparison.pressed
    size = " x ".join(f"{1e6 * side:.3g} µm" for side in pressed.size)
    heights = ", ".join(f"{1e6 * height:.3g}" for height in pressed.rms_height)
    click.secho(comparison.verdict(), bold=True)
    click.echo(f"{source}: four patches of {size}, a plane removed, rms heights {heights} µm")
    if comparison.no_power_law:
        click.echo(f"no published law: {comparison.no_power_law}")
    click.echo(
        f"\n{'p [MPa]':>8s} {'area %':>6s} {'k_n [MPa/µm]':>13s} {'±%':>4s} {'capped':>8s} {'k_t/k_n':>7s}  "
        + " ".join(f"{law:>11s}" for law in comparison.laws)
    )
    scatter = 100.0 * np.std(np.log(comparison.elastic), axis=0, ddof=1)
    for n, pressure in enumerate(comparison.pressure):
        columns = [
            (100.0 * pressed.contact_fractions[0][:, n].mean(), "6.1f"),
            (1e-12 * np.exp(np.log(comparison.elastic[:, n]).mean()), "13.4g"),
            (scatter[n], "4.0f"),
            (1e-12 * np.exp(np.log(comparison.capped[:, n]).mean()), "8.4g"),
            (pressed.tangential_ratios[:, n].mean(), "7.3f"),
        ]
        cells = [
            f"{value:{kind}}" if np.isfinite(value) else f"{'-':>{kind.split('.')[0]}s}"
            for value, kind in columns
        ]
        laws = []
        for law in comparison.laws:
            ratio = comparison.ratio(law)[n]
            text = f"{ratio:.2f}" if ratio < 100.0 else ">100"
            laws.append(f"{text if np.isfinite(ratio) else '-':>11s}")
        click.echo(f"{1e-6 * pressure:8.4g} {' '.join(cells)}  {' '.join(laws)}")
    click.echo(
        "\nk_n: boundary elements, elastic, geometric mean over the patches, ± its standard deviation; capped:\n"
        f"no pressure above {1e-9 * comparison.hardness:.3g} GPa; k_t/k_n: in the rolling direction, elastic,\n"
        "Poisson's ratio 0.3; then each law over the elastic boundary elements. Elastic is the soft\n"
        "bound. -: a patch is pressed flat, or cannot carry the load."
    )


_UNITS = {
    "normal_force": "N",
    "pressure_scale": "Pa",
    "rms_height": "m",
    "real_contact_area": "m2",
    "normal_stiffness": "N_per_m",
    "tangential_stiffness": "N_per_m",
}


def _document(sample: Sample, comparison: Comparison) -> dict[str, object]:
    """Everything computed for one sample; null where a stiffness is infinite (complete contact)."""

    def plain(value: _Nested) -> object:
        if isinstance(value, list):
            return [plain(entry) for entry in value]
        return value if math.isfinite(value) else None

    names = [field.name for field in dataclasses.fields(comparison)]
    results = {}
    for name in names:
        stem = name.removeprefix("law_").removeprefix("persson_")
        key = f"{name}_{_UNITS[stem]}" if stem in _UNITS else name
        results[key] = plain(np.asarray(getattr(comparison, name)).tolist())
    return {"sample": dataclasses.asdict(sample), **results}


_COLUMNS = {
    "real_contact_area": ("A_r/A_0 [-]", None),
    "normal_stiffness": ("K_n [N/µm]", 1e-6),
    "tangential_stiffness": ("K_t [N/µm]", 1e-6),
}


def _show(samples: list[Sample], comparisons: list[Comparison]) -> None:
    """Print one table per sample: boundary elements with their scatter, and both theories as ratios to them."""
    prepare_output()
    for sample, result in zip(samples, comparisons, strict=True):
        seeds = result.real_contact_area.shape[0]
        click.secho(
            f"D = {sample.fractal_dimension:g}: rms height {float(result.rms_height) * 1e6:.3g} µm, rms slope "
            f"{float(result.rms_slope):.3g}, {seeds} surfaces",
            bold=True,
        )
        head = [f"{label:>11s}  ±%   law     P" for label, _ in _COLUMNS.values()]
        click.echo(f"{'F [N]':>8s}  " + "  ".join(head) + "  cap %")
        for index, force in enumerate(np.asarray(result.normal_force)):
            cells = [f"{force:8.3g}"]
            for name, (_, scale) in _COLUMNS.items():
                solved = np.asarray(getattr(result, name))[:, index]
                mean = float(solved.mean())
                law = float(getattr(result, f"law_{name}")[index]) / mean
                theory = float(np.mean(np.asarray(getattr(result, f"persson_{name}"))[:, index])) / mean
                shown = mean * (sample.side**-2 if scale is None else scale)
                cells.append(f"{shown:11.4g} {100.0 * solved.std() / mean:3.0f} {law:5.3g} {theory:5.2f}")
            cells.append(f"{100.0 * float(np.mean(np.asarray(result.capped_fraction)[:, index])):5.0f}")
            click.echo("  ".join(cells))
        click.echo()
    click.echo(
        "Boundary elements: mean over the surfaces; ±%: standard deviation. law, P: fractal law (contact factor 1)\n"
        "and Persson's theory (elastic), each divided by the boundary elements. cap %: share of the contact area\n"
        "whose pressure is limited by the hardness."
    )

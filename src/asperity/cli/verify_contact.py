"""``asperity verify-contact``: contact laws compared with boundary elements, on known surfaces or on a measured map."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import click

from asperity.cli.surface import ARGUMENTS, measure
from asperity.cli.terminal import json_option, plot_option, prepare_computation, read_option, save_image
from asperity.errors import InputError
from asperity.writing import check_image

if TYPE_CHECKING:
    from asperity.verify.comparison import Comparison, Sample
    from asperity.verify.measured_map import MapComparison

_OF_KNOWN = (
    *("dimensions", "roughness", "side", "pixels_per_wave", "seeds", "loads", "lowest", "highest"),
    *("gamma", "elastic"),
)
#: Options of 'asperity surface measure' that say how a map is read.
_OF_MAPS = (
    *("position_unit", "height_unit", "spacing", "decimal", "column", "no_data", "any_size"),
    *("missing", "form", "degree", "outliers", "direction"),
)
_NOT_READ = ("files", "as_json", "plot", "hardness")
_OPTIONS = {"dimensions": "dimension", "lowest": "from", "highest": "to"}


@click.command("verify-contact")
@click.option(
    "--dimension",
    "dimensions",
    type=float,
    multiple=True,
    default=(1.2, 1.4, 1.6, 1.8),
    show_default=True,
    help="Fractal dimension D of the profiles; may be given several times.",
)
@click.option("--roughness", default="1e-8 mm", show_default=True, help="Fractal roughness G, with its unit.")
@click.option("--side", default="1 mm", show_default=True, help="Side of the periodic square, with its unit.")
@click.option("--points", type=int, default=256, show_default=True, help="Grid points along the side.")
@click.option(
    "--pixels-per-wave",
    type=float,
    default=8.0,
    show_default=True,
    help="Grid points per shortest wavelength.",
)
@click.option("--seeds", type=int, default=4, show_default=True, help="Number of random surfaces for each D.")
@click.option("--loads", type=int, default=6, show_default=True, help="Loads per surface.")
@click.option(
    "--from",
    "lowest",
    type=float,
    default=0.003,
    show_default=True,
    help="Smallest mean pressure, relative to the smaller of hardness and E* times rms slope.",
)
@click.option(
    "--to",
    "highest",
    type=float,
    default=0.3,
    show_default=True,
    help="Largest mean pressure, relative to the same.",
)
@click.option(
    "--youngs-modulus",
    default="206 GPa",
    show_default=True,
    help="Young's modulus of both bodies, with its unit.",
)
@click.option(
    "--poisson-ratio", type=float, default=0.3, show_default=True, help="Poisson's ratio of both bodies."
)
@click.option(
    "--hardness", default="1260 MPa", show_default=True, help="Hardness of both bodies, with its unit."
)
@click.option("--gamma", type=float, default=1.5, show_default=True, help="Frequency ratio of the surface.")
@click.option(
    "--elastic", is_flag=True, help="Do not limit the pressure of the boundary elements to the hardness."
)
@click.option(
    "--surface",
    "surface_file",
    type=click.Path(),
    metavar="FILE",
    help="Compare all laws on this measured map, of the roughness of both bodies, in place of known surfaces.",
)
@plot_option("Draw the comparison: PNG, SVG or PDF.")
@json_option()
@click.pass_context
def verify_contact(
    context: click.Context,
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
    """Compare contact laws with boundary elements and Persson's theory.

    With --surface: on four patches of half the width of a measured map, each with at most half of --points along its
    sides, under 10 to 3000 MPa (on steel), elastic and with no pressure above the hardness. The exponential law,
    Persson's theory and, where the map has D and G, the published law are compared with that. Options of known surfaces
    do not go with it.

    Without: generates Weierstrass-Mandelbrot surfaces of given D and G and computes their contact by boundary elements
    at a series of loads. Contact area, normal and tangential stiffness are compared with the closed-form law
    (contact factor 1, as for a nominally flat contact) and with Persson's theory.
    """
    from asperity.units import Dimension

    check_image(plot_file, *([surface_file] if surface_file else []))
    _refuse_options(context, _OF_KNOWN if surface_file else _OF_MAPS, surface_file)
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
    lengths = [
        read_option(name, text, Dimension.LENGTH) for name, text in (("roughness", roughness), ("side", side))
    ]
    stresses = [
        read_option("youngs-modulus", youngs_modulus, Dimension.PRESSURE),
        read_option("hardness", hardness, Dimension.HARDNESS),
    ]
    if loads < 1 or not 0.0 < lowest <= highest < 1.0:
        raise InputError(
            f"--loads {loads} --from {lowest:g} --to {highest:g}: at least one load is required, and 0 < from <= to < 1"
        )
    from rich.console import Console
    from rich.progress import Progress

    prepare_computation()
    import numpy as np

    from asperity.verify.comparison import Sample, compare

    samples = [
        Sample(
            fractal_dimension=D,
            fractal_roughness=lengths[0],
            frequency_ratio=gamma,
            side=lengths[1],
            points=points,
            waves_per_side=2.0,
            pixels_per_wave=pixels_per_wave,
            youngs_modulus=stresses[0],
            poisson_ratio=poisson_ratio,
            hardness=stresses[1],
        )
        for D in dimensions
    ]
    pressures = np.geomspace(lowest, highest, loads)
    console = Console(stderr=True)
    with Progress(console=console, transient=True, disable=not sys.stderr.isatty()) as progress:
        bar = progress.add_task("contacts", total=len(samples) * seeds * loads)
        comparisons = [
            compare(
                sample,
                seeds=seeds,
                relative_pressures=pressures.tolist(),
                elastic=elastic,
                solved=lambda: progress.advance(bar),
            )
            for sample in samples
        ]
    if plot_file:
        from asperity.verify.comparison import comparison_figure

        save_image(comparison_figure(samples, comparisons), plot_file)
    if as_json:
        import json

        document = [_document(sample, result) for sample, result in zip(samples, comparisons, strict=True)]
        click.echo(json.dumps(document, indent=2))
        return
    _show(samples, comparisons)


verify_contact.params += [option for option in measure.params if option.name in _OF_MAPS]


def _refuse_options(context: click.Context, names: tuple[str, ...], surface_file: str | None) -> None:
    """Refuse options that were given and have no effect."""
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
    from asperity.cli.terminal import print_json, progress_bar

    prepare_computation()
    from asperity.bem import elastic_pair
    from asperity.bem.pressed_map import STATES
    from asperity.surface.measure_files import measured_files
    from asperity.verify.measured_map import compare_map, map_document, map_figure

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
    import numpy as np

    from asperity.cli.terminal import prepare_output

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


def _document(sample: Sample, comparison: Comparison) -> dict[str, Any]:
    """Everything computed for one sample; null where a stiffness is infinite (complete contact)."""
    import dataclasses
    import math

    import numpy as np

    def plain(value: Any) -> Any:
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
    import numpy as np

    from asperity.cli.terminal import prepare_output

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

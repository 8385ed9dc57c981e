"""``asperity verify-contact``: contact laws compared with boundary elements, on known surfaces or on a measured map."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option
from asperity.cli.run_by_name import run_by_name
from asperity.cli.surface import measure

#: Options of 'asperity surface measure' that say how a map is read.
OF_MAPS = (
    *("position_unit", "height_unit", "spacing", "decimal", "column", "no_data", "any_size"),
    *("missing", "form", "degree", "outliers", "direction"),
)


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
@run_by_name
def verify_contact() -> None:
    """Compare contact laws with boundary elements and Persson's theory.

    With --surface: on four patches of half the width of a measured map, each with at most half of --points along its
    sides, under 10 to 3000 MPa (on steel), elastic and with no pressure above the hardness. The exponential law,
    Persson's theory and, where the map has D and G, the published law are compared with that. Options of known surfaces
    do not go with it.

    Without: generates Weierstrass-Mandelbrot surfaces of given D and G and computes their contact by boundary elements
    at a series of loads. Contact area, normal and tangential stiffness are compared with the closed-form law
    (contact factor 1, as for a nominally flat contact) and with Persson's theory.
    """


verify_contact.params += [option for option in measure.params if option.name in OF_MAPS]

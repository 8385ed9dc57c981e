"""Creep of contacts with oil: the closed form against boundary elements on random contacts.

Run it: ``python examples/film_rolling.py [picture.png] [contacts]``; 600 contacts take three minutes.
"""

import dataclasses
import itertools
import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from asperity.contact.creep_law import traction_at_creepage
from asperity.contact.film_traction import MixedContact, even_slip
from asperity.engine import trees
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.show.style import STYLE
from asperity.validation.oiled_rollers import (
    LENGTH,
    LOAD,
    MODULUS,
    OILS,
    RADIUS,
    OiledContact,
    oiled_contact,
    strip_force,
)

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "film_rolling.png"
#: Peak pressure [Pa], rolling speed [m/s], heights [m], creepage [-], drawn by their logarithms; temperature [°C] and
#: friction of the asperities [-], drawn evenly.
PRESSURES, SPEEDS, HEIGHTS, CREEPAGES = (0.3e9, 2e9), (0.01, 20.0), (0.02e-6, 0.8e-6), (1e-5, 2e-2)
TEMPERATURES, FRICTIONS = (25.0, 100.0), (0.06, 0.14)
#: Oil, °C, m/s, heights [m] of the curves.
CURVES = (
    ("S50", 40.0, 1.0, 0.1e-6),
    ("M100", 40.0, 1.0, 0.1e-6),
    ("M100", 60.0, 0.05, 0.1e-6),
    ("PAO100", 40.0, 1.0, 0.1e-6),
)
COLORS = ("#08306b", "#3182bd", "#74c476", "#fd8d3c")


class Compared(NamedTuple):
    """A random contact: slope of its even slip, share of the asperities, factor of layers, closed form over strips."""

    exponent: float
    asperity_share: float
    elastic_factor: float
    ratio: float


def without_layers(oiled: OiledContact) -> OiledContact:
    """The same contact whose film and asperities slip, but do not yield elastically."""
    fluid = oiled.contact.fluid
    stiff = dataclasses.replace(fluid, traction=dataclasses.replace(fluid.traction, shear_modulus=1e30))
    contact = dataclasses.replace(oiled.contact, fluid=stiff)
    return oiled._replace(contact=contact, layer_factor=1.0 + 0.0 * oiled.layer_factor)


def single(contact: MixedContact, number: int) -> MixedContact:
    """One of several contacts."""
    return trees.map(lambda leaf: leaf[number] if np.ndim(leaf) else leaf, contact)


def random_contacts(count: int, *, layers: bool, seed: int) -> Iterator[tuple[OiledContact, np.ndarray]]:
    """As many contacts of every oil as make up a number, with a creepage each."""
    random = np.random.default_rng(seed)
    for oil in OILS:
        size = count // len(OILS)
        pressure, speed, height, creepage = (
            np.exp(random.uniform(*np.log(ends), size)) for ends in (PRESSURES, SPEEDS, HEIGHTS, CREEPAGES)
        )
        oiled = oiled_contact(
            oil,
            random.uniform(*TEMPERATURES, size),
            speed,
            height,
            friction=random.uniform(*FRICTIONS, size),
            load=math.pi * pressure**2 * LENGTH * RADIUS / MODULUS,
        )
        yield (oiled if layers else without_layers(oiled)), creepage


def compared(count: int, *, layers: bool, seed: int, strips: int = 200, every: int = 1) -> list[Compared]:
    """The closed form against strips on random contacts, or on every second, third, ... of them."""
    rows = []
    for oiled, creepage in random_contacts(count, layers=layers, seed=seed):
        found = traction_at_creepage(
            contact=oiled.contact, creepage=creepage, layer_factor=oiled.layer_factor
        )
        exponent = even_slip(contact=oiled.contact, creepage=creepage).exponent
        for number in range(0, creepage.size, every):
            factor = float(found.elastic_factor[number])
            force = strip_force(
                contact=single(oiled.contact, number),
                creepage=float(creepage[number]),
                elastic_factor=factor,
                strips=strips,
            )
            share = float(oiled.contact.asperity_share[number])
            rows.append(
                Compared(float(exponent[number]), share, factor, float(found.traction[number]) / force)
            )
    return rows


def summary(rows: list[Compared]) -> dict[str, float]:
    """Root mean square of the deviation, what 95 % stay within, the share within 7 %, and both ends of the ratio."""
    ratio = np.array([row.ratio for row in rows])
    off = np.abs(ratio - 1.0)
    return {
        "root mean square": float(np.sqrt(np.mean(off**2))),
        "95 % within": float(np.quantile(off, 0.95)),
        "share within 7 %": float(np.mean(off < 0.07)),
        "smallest ratio": float(ratio.min()),
        "largest ratio": float(ratio.max()),
    }


def print_regimes(rows: list[Compared]) -> None:
    """Deviations by the slope of the even slip, the share of the asperities and the factor of the layers."""
    for name, edges in (
        ("exponent", (-np.inf, 0.02, 0.1, 0.3, 0.6, 0.9, np.inf)),
        ("asperity_share", (0.0, 0.01, 0.1, 0.3, 0.9, 1.0)),
        ("elastic_factor", (1.0, 1.1, 1.3, 2.0, 5.0, np.inf)),
    ):
        for low, high in itertools.pairwise(edges):
            inside = [row for row in rows if low <= getattr(row, name) < high]
            if inside:
                found = summary(inside)
                print(f"  {name:15}{low:6.2f} to {high:5.2f}{len(inside):5d} contacts: ", end="")
                print(", ".join(f"{key} {value:.3f}" for key, value in found.items()))


def draw_curves(axes: Axes, strips: int = 200) -> None:
    """Traction over creepage of four contacts, lines by the closed form, points by strips."""
    creepage, points = np.geomspace(2e-5, 2e-2, 120), np.geomspace(4e-5, 1.6e-2, 9)
    for color, (oil, celsius, speed, height) in zip(COLORS, CURVES, strict=True):
        oiled = oiled_contact(oil, celsius, speed, height)
        found = traction_at_creepage(
            contact=oiled.contact, creepage=creepage, layer_factor=oiled.layer_factor
        )
        axes.semilogx(
            creepage, found.traction / LOAD, color=color, label=f"{oil}, {celsius:g} °C, {speed:g} m/s"
        )
        contact, factor = single(oiled.contact, 0), float(found.elastic_factor[0])
        forces = [
            strip_force(contact=contact, creepage=float(xi), elastic_factor=factor, strips=strips)
            for xi in points
        ]
        axes.semilogx(points, np.array(forces) / LOAD, "o", color=color, markersize=4)
    axes.set_title("Four contacts (points: boundary elements)")
    axes.set_xlabel(r"creepage $\xi$")
    axes.set_ylabel("traction over load $T/N$")
    axes.legend()


def draw_ratios(axes: Axes, rows: dict[str, list[Compared]]) -> None:
    """Closed form over strips, over the slope of the even slip."""
    for color, (name, found) in zip(COLORS[1::2], rows.items(), strict=True):
        exponent, ratio = np.array([(row.exponent, row.ratio) for row in found]).T
        axes.plot(exponent, ratio, ".", color=color, markersize=4, label=name)
    axes.axhspan(0.93, 1.07, color="0.9", zorder=0)
    axes.set_title("Random contacts (grey: 7 %)")
    axes.set_xlabel(r"slope of the even slip $n = d \ln T_0/d \ln \xi$")
    axes.set_ylabel("closed form over boundary elements")
    axes.legend()


def main(picture: Path = PICTURE, count: int = 600) -> dict[str, dict[str, float]]:
    use_double_precision()
    use_compilation_cache()
    rows = {
        "film and bodies": compared(count, layers=False, seed=11),
        "and elastic layers": compared(count, layers=True, seed=12),
    }
    for name, found in rows.items():
        print(f"{name}: " + ", ".join(f"{key} {value:.3f}" for key, value in summary(found).items()))
        print_regimes(found)
    with rc_context(STYLE):
        figure = Figure(figsize=(11.0, 4.2), layout="constrained")
        panels = figure.subplots(1, 2)
        draw_curves(panels[0])
        draw_ratios(panels[1], rows)
        figure.savefig(picture, dpi=150)
    return {name: summary(found) for name, found in rows.items()}


if __name__ == "__main__":
    main(*(kind(argument) for kind, argument in zip((Path, int), sys.argv[1:3], strict=False)))

"""One picture of the reproduction: the joint of Table 2 drawn to scale beside its stiffness over D."""

from __future__ import annotations

import math

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyArrowPatch, Wedge

from asperity.drive.geometry import DriveGeometry, triangle
from asperity.zou2025 import preset
from asperity.zou2025.criteria import peak
from asperity.zou2025.curves import JointCurves
from asperity.zou2025.style import MARK, MUTED, STYLE, torque_colors

_SIZE = (11.0, 4.8)
_INK = "#22303c"
_BODIES = {"ring": "#e3e8ec", "planet": "#cfe3f1", "right": "#f6cfa6", "left": "#fbe7d2", "sun": "#22303c"}
_MARGIN = 1.0  # mm
_DRAWN_WALL = 10.0  # mm; the paper gives no wall


def _roller(axes: Axes, centre: tuple[float, float], radius: float, color: str) -> None:
    axes.add_patch(Circle(centre, radius, facecolor=color, edgecolor=_INK, lw=1.1, zorder=3))
    axes.plot(*centre, "+", color=_INK if color != _BODIES["sun"] else "white", ms=5, mew=0.9, zorder=4)


def _polar(radius: float, angle: float) -> tuple[float, float]:
    return radius * math.cos(angle), radius * math.sin(angle)


def draw_drive(axes: Axes, geometry: DriveGeometry) -> None:
    """Draw the rollers of a drive to scale, in mm.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    geometry : DriveGeometry
        The drive; numbers, not arrays.
    """
    sides = triangle(geometry)
    mm = {
        name: 1e3 * float(value)
        for name, value in {
            "sun": geometry.sun_radius,
            "planet": geometry.planet_radius,
            "roller": geometry.loading_roller_radius,
            "ring": geometry.ring_radius,
            "orbit": sides.planet_orbit,
            "roller_orbit": sides.roller_orbit,
        }.items()
    }
    outside = mm["ring"] + _DRAWN_WALL
    axes.add_patch(
        Wedge((0, 0), outside, 0, 360, width=_DRAWN_WALL, facecolor=_BODIES["ring"], edgecolor=_INK, lw=1.1)
    )
    polar = math.atan2(float(sides.sin_polar), float(sides.cos_polar))
    count = round(float(geometry.planet_count))
    for k in range(count):
        direction = math.pi / 2.0 + 2.0 * math.pi * k / count
        _roller(axes, _polar(mm["orbit"], direction), mm["planet"], _BODIES["planet"])
        _roller(axes, _polar(mm["roller_orbit"], direction - polar), mm["roller"], _BODIES["right"])
        _roller(axes, _polar(mm["roller_orbit"], direction + polar), mm["roller"], _BODIES["left"])
    _roller(axes, (0.0, 0.0), mm["sun"], _BODIES["sun"])
    axes.text(0.0, mm["orbit"] + 4.5, "planet", ha="center", va="center", fontsize=9, color=_INK, zorder=5)
    right = _polar(mm["roller_orbit"], math.pi / 2.0 - polar)
    axes.annotate(
        "right\nloading\nroller",
        right,
        xytext=(25.0, 18.0),
        ha="center",
        va="center",
        fontsize=8.5,
        color=_INK,
        arrowprops={"arrowstyle": "-", "color": _INK, "lw": 0.8, "shrinkB": 6},
        zorder=6,
    )
    axes.text(
        0.0, mm["ring"] + 0.5 * _DRAWN_WALL, "fixed ring", ha="center", va="center", fontsize=9, color=_INK
    )
    axes.annotate(
        "sun (input)",
        (0.0, -mm["sun"]),
        xytext=(0.0, -28.0),
        ha="center",
        fontsize=9,
        color=_INK,
        arrowprops={"arrowstyle": "-", "color": _INK, "lw": 0.8},
        zorder=6,
    )
    start, stop = _polar(7.6, math.radians(155)), _polar(7.6, math.radians(25))
    axes.add_patch(
        FancyArrowPatch(
            start,
            stop,
            connectionstyle="arc3,rad=-0.55",
            arrowstyle="-|>",
            mutation_scale=11,
            color=MARK,
            lw=1.4,
            zorder=6,
        )
    )
    axes.set_xlim(-outside - _MARGIN, outside + _MARGIN)
    axes.set_ylim(-outside - _MARGIN, outside + _MARGIN)
    axes.set_aspect("equal")
    axes.axis("off")


def draw_stiffness(axes: Axes, dimension: JointCurves) -> None:
    """Draw the joint's stiffness over D for several torques, peaks and the paper's design window marked.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    dimension : JointCurves
        The joint over D.
    """
    giga = dimension.output_stiffness * 1e-9
    axes.axvspan(*preset.DESIGN_WINDOW, color="#eef4f8", lw=0, zorder=0)
    axes.text(
        float(np.mean(preset.DESIGN_WINDOW)),
        0.10,
        "window advised\nby the paper",
        ha="center",
        fontsize=8.5,
        color=MUTED,
    )
    for torque, curve, color in zip(dimension.output_torque, giga, torque_colors(len(giga)), strict=True):
        axes.plot(dimension.values, curve, color=color, label=f"{torque:g} N·m")
        place = peak(dimension.values, curve)
        axes.plot(place, np.max(curve), "o", ms=4.5, mfc="white", mec=MARK, mew=1.3, zorder=5)
    place = peak(dimension.values, giga[0])
    axes.annotate(
        f"peak at $D$ = {place:.2f}",
        (place, float(np.max(giga))),
        xytext=(0, 9),
        textcoords="offset points",
        ha="center",
        color=MARK,
    )
    axes.set_xlim(dimension.values[0], dimension.values[-1])
    axes.set_ylim(0.0, 1.14 * float(np.max(giga)))
    axes.set_xlabel("fractal dimension $D$ of the surface")
    axes.set_ylabel("torsional stiffness at the output (10$^9$ N·m/rad)")
    axes.legend(title="output torque", alignment="left", loc="upper left")


def overview_figure(dimension: JointCurves) -> Figure:
    """The drive to scale beside its published torsional stiffness over the fractal dimension.

    Parameters
    ----------
    dimension : JointCurves
        The joint over D, :attr:`asperity.zou2025.curves.Curves.dimension`.

    Returns
    -------
    Figure
        With an Agg canvas.
    """
    with rc_context(STYLE):
        figure = Figure(figsize=_SIZE)
        FigureCanvasAgg(figure)
        drive = figure.add_axes((0.015, 0.06, 0.39, 0.80))
        draw_drive(drive, preset.table_2_joint(preset.operating_grid()).geometry)
        stiffness = figure.add_axes((0.485, 0.125, 0.495, 0.735))
        draw_stiffness(stiffness, dimension)
        figure.text(
            0.02, 0.925, "Planetary traction drive, to scale", fontsize=12, fontweight="bold", color=_INK
        )
        figure.text(
            0.432,
            0.925,
            "Its stiffness from the roughness of its rollers",
            fontsize=12,
            fontweight="bold",
            color=_INK,
        )
        figure.text(
            0.432,
            0.882,
            "model of Zou et al. 2025 (asperities alone), $G$ = 10$^{-8}$ mm",
            fontsize=9,
            color=MUTED,
        )
        figure.text(
            0.02, 0.882, "radii: sun 4, planets 13.5, loading rollers 5, ring 40 mm", fontsize=9, color=MUTED
        )
    return figure

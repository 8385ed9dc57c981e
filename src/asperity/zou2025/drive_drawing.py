"""A planetary traction drive drawn to scale."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.errors import InputError
from asperity.show.style import INK, MARK
from asperity.types import Document, Real

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Body → colour.
BODY_COLORS = {
    "ring": "#e3e8ec",
    "planet": "#cfe3f1",
    "right loading roller": "#f6cfa6",
    "left loading roller": "#fbe7d2",
    "sun": INK,
}
_MARGIN = 1.02  # half-width of the view over the outer radius of the ring
_ARROW_RADIUS = 1.9  # over the radius of the sun
_ARROW_ENDS = math.radians(155.0), math.radians(25.0)


class Roller(NamedTuple):
    """One roller of a drive, a key of :data:`BODY_COLORS`, with its centre and radius [m].

    The origin lies at the sun, the first planet on the positive y axis.
    """

    body: str
    centre: tuple[float, float]
    radius: float


def _polar(radius: float, angle: float) -> tuple[float, float]:
    return radius * math.cos(angle), radius * math.sin(angle)


def rollers(geometry: DriveGeometry) -> list[Roller]:
    """All rollers of a drive in their places: the sun, then planet, right and left loading roller of each branch."""
    sides = triangle(geometry)
    polar = math.atan2(float(sides.sin_polar), float(sides.cos_polar))
    if not math.isfinite(polar):
        raise InputError(
            "the drive cannot be drawn: its loading rollers cannot touch planet and ring at the same time; "
            "change the radii"
        )
    planet, loading_roller = float(geometry.planet_radius), float(geometry.loading_roller_radius)
    count = round(float(geometry.planet_count))
    placed = [Roller("sun", (0.0, 0.0), float(geometry.sun_radius))]
    for branch in range(count):
        direction = math.pi / 2.0 + 2.0 * math.pi * branch / count
        orbit, roller_orbit = float(sides.planet_orbit), float(sides.roller_orbit)
        placed += [
            Roller("planet", _polar(orbit, direction), planet),
            Roller("right loading roller", _polar(roller_orbit, direction - polar), loading_roller),
            Roller("left loading roller", _polar(roller_orbit, direction + polar), loading_roller),
        ]
    return placed


def draw_drive(axes: Axes, geometry: DriveGeometry, *, ring_wall_thickness: Real) -> None:
    """Draw the rollers and the ring of a drive to scale, in mm, with a legend that gives the radii."""
    from matplotlib.patches import Circle, FancyArrowPatch, Patch, Wedge

    outline: Document = {"edgecolor": INK, "linewidth": 1.1}
    inside, wall = 1e3 * float(geometry.ring_radius), 1e3 * float(ring_wall_thickness)
    outside = inside + wall
    axes.add_patch(Wedge((0.0, 0.0), outside, 0, 360, width=wall, facecolor=BODY_COLORS["ring"], **outline))
    sizes = {}
    for body, centre, radius in rollers(geometry):
        x, y = (1e3 * c for c in centre)
        axes.add_patch(Circle((x, y), 1e3 * radius, facecolor=BODY_COLORS[body], zorder=3, **outline))
        axes.plot(x, y, "+", color="white" if body == "sun" else INK, ms=4, mew=0.8, zorder=4)
        name = f"{body} (input)" if body == "sun" else body
        sizes[body] = f"{name}, radius {1e3 * radius:.4g} mm"
    sizes["ring"] = f"ring, inner radius {inside:.4g} mm, wall {wall:.4g} mm"
    arrow = _ARROW_RADIUS * 1e3 * float(geometry.sun_radius)
    axes.add_patch(
        FancyArrowPatch(
            *(_polar(arrow, angle) for angle in _ARROW_ENDS),
            connectionstyle="arc3,rad=-0.55",
            arrowstyle="-|>",
            mutation_scale=8,
            shrinkA=0,
            shrinkB=0,
            color=MARK,
            lw=1.3,
            zorder=6,
        )
    )
    keys = [Patch(facecolor=BODY_COLORS[body], label=text, **outline) for body, text in sizes.items()]
    axes.legend(
        handles=keys, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=2, handlelength=1.0, fontsize=8
    )
    axes.set_xlim(-_MARGIN * outside, _MARGIN * outside)
    axes.set_ylim(-_MARGIN * outside, _MARGIN * outside)
    axes.set_aspect("equal")
    axes.axis("off")

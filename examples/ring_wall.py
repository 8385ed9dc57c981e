"""Assembled stiffness of the paper's joint over the wall of its ring, by exact elasticity of all bodies.

The rim of the ring is free, or shrunk into a housing. Bodies alone, without asperities, at rest with 1000 N of preload.

Run it: ``python examples/ring_wall.py [picture.png]``.
"""

import math
import sys
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
from matplotlib import rc_context
from matplotlib.figure import Figure

from asperity.body.coupling import BodyInMachine, coupled_compliance
from asperity.body.shapes import Annulus, Disc
from asperity.contact.hertz_line import (
    effective_radius,
    half_width,
    logarithmic_compliance,
    ring_secant_compliance,
    roller_secant_compliance,
)
from asperity.drive.layout.wedge import wedge_angles
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.stiffness.network import network_stiffness
from asperity.drive.types.wedge import wedge_drive
from asperity.materials import contact_modulus
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.show.style import ACCENT, MARK, MUTED, STYLE

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "ring_wall.png"
YOUNG, POISSON, LENGTH, PLANETS = 206e9, 0.3, 5e-3, 3
GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, float(PLANETS), 0.0, 0.0)
DRIVE = wedge_drive(GEOMETRY, planet_count=PLANETS)
#: Support of the rim by a housing, radial and tangential, per area: of the order of 20 mm of aluminium [N/m^3].
HOUSING = 5e11
#: Walls whose stiffness is printed [mm].
PRINTED = np.array([4.0, 6.0, 10.0, 15.0, 20.0, 30.0, 60.0])


def directions() -> tuple[float, float, float]:
    """Polar angle of a loading roller, direction from the planet to it, and their difference [rad]."""
    polar, direction, wedge = map(float, wedge_angles(DRIVE))
    return polar, direction, wedge


def rest_forces(preload: float) -> np.ndarray:
    """Normal forces of sp, pwr, pwl, wro, wlo at rest [N]."""
    _, direction, wedge = directions()
    planet = preload / (2.0 * math.cos(direction))
    ring = planet * math.cos(wedge)
    return np.array([preload, planet, planet, ring, ring])


def half_widths(forces: np.ndarray) -> np.ndarray:
    """Half-widths of the five contacts [m]."""
    s, p, w, o = (
        GEOMETRY.sun_radius,
        GEOMETRY.planet_radius,
        GEOMETRY.loading_roller_radius,
        GEOMETRY.ring_radius,
    )
    modulus = contact_modulus(
        youngs_modulus_1=YOUNG, youngs_modulus_2=YOUNG, poisson_ratio_1=POISSON, poisson_ratio_2=POISSON
    )
    radius = effective_radius(
        radius_1=np.array([s, p, p, w, w]),
        radius_2=np.array([p, w, w, o, o]),
        sign=np.array([1.0, 1.0, 1.0, -1.0, -1.0]),
    )
    width = half_width(
        normal_force=forces, contact_length=LENGTH, effective_radius=radius, contact_modulus=modulus
    )
    return np.asarray(width)


def bodies(wall: np.ndarray | None, support: float = 0.0, state: str = "plane_strain") -> list[BodyInMachine]:
    """Sun, planet, right and left roller, and the ring unless its wall is None; planet above the sun, y upwards."""
    polar, direction, _ = directions()
    up = 0.5 * math.pi

    def disc(radius: float) -> Disc:
        return Disc(radius, LENGTH, YOUNG, POISSON, state)

    def at(*places: float) -> np.ndarray:
        return np.array(places)[:, None]  # one column for all walls

    right, left = at(up - direction + math.pi, up - polar), at(up + direction + math.pi, up + polar)
    found = [
        BodyInMachine(disc(GEOMETRY.sun_radius), (0,), at(up), PLANETS),
        BodyInMachine(disc(GEOMETRY.planet_radius), (0, 1, 2), at(-up, up - direction, up + direction), None),
        BodyInMachine(disc(GEOMETRY.loading_roller_radius), (1, 3), right, None),
        BodyInMachine(disc(GEOMETRY.loading_roller_radius), (2, 4), left, None),
    ]
    if wall is not None:
        inner = GEOMETRY.ring_radius
        ring = Annulus(inner, inner + wall, LENGTH, YOUNG, POISSON, support, support, "inner", state)
        found.append(BodyInMachine(ring, (3, 4), at(up - polar, up + polar), PLANETS))
    return found


_coupled = jax.jit(coupled_compliance)


def compliance(members: list[BodyInMachine], widths: np.ndarray) -> np.ndarray:
    """Compliance matrix of the ten springs of a branch, one for each wall along the last axis [m/N]."""
    width = jnp.asarray(widths)[:, None]
    lengths = jnp.full_like(width, LENGTH)
    return np.asarray(
        _coupled(bodies=members, contact_lengths=lengths, half_widths=width, stick_half_widths=width)
    )


def springs(widths: np.ndarray, wall: float) -> np.ndarray:
    """Incremental compliances of the contacts by Johnson, and Weber and Banaschek for the ring [m/N]."""
    steel = {"contact_length": LENGTH, "youngs_modulus": YOUNG, "poisson_ratio": POISSON}
    scale = float(logarithmic_compliance(**steel))

    def roller(radius: float, width: float) -> float:
        return float(roller_secant_compliance(radius=radius, half_width=width, **steel)) - scale

    s, p, w = GEOMETRY.sun_radius, GEOMETRY.planet_radius, GEOMETRY.loading_roller_radius
    found = [
        roller(one, width) + roller(two, width) for one, two, width in ((s, p, widths[0]), (p, w, widths[1]))
    ]
    ring = float(ring_secant_compliance(wall_thickness=wall, half_width=widths[3], **steel)) - scale
    outside = roller(w, widths[3]) + ring
    return np.array([found[0], found[1], found[1], outside, outside])


@jax.jit
def _assembled(matrices: jax.Array) -> jax.Array:
    def output(matrix: jax.Array) -> jax.Array:
        diagonal = jnp.diag(matrix)
        return network_stiffness(
            drive=DRIVE,
            normal_compliance=diagonal[:5],
            tangential_compliance=diagonal[5:],
            coupling=matrix - jnp.diag(diagonal),
        ).output

    return jax.vmap(output, in_axes=-1)(matrices)


def assembled_stiffness(matrices: np.ndarray) -> np.ndarray:
    """Stiffness at the output of joints with these matrices, shape (10, 10, joints) [N·m/rad]."""
    return np.asarray(_assembled(jnp.asarray(matrices)))


def draw(walls: np.ndarray, curves: dict[str, np.ndarray]) -> Figure:
    with rc_context(STYLE):
        figure = Figure(figsize=(7.2, 4.4), layout="constrained")
        axes = figure.subplots()
        looks = ((MUTED, "--"), (ACCENT, "-"), ("#4a9bd1", "-"), (MARK, "-"))
        for (name, values), (color, dash) in zip(curves.items(), looks, strict=True):
            axes.semilogx(walls * 1e3, values / 1e3, color=color, linestyle=dash, label=name)
        axes.set_title("A thin ring decides the stiffness of the joint, unless a housing holds it")
        axes.set_xlabel("wall of the ring [mm], inner radius 40 mm")
        axes.set_ylabel("stiffness at the output [kN·m/rad]")
        ticks = [4, 6, 10, 15, 20, 30, 60]
        axes.set_xticks(ticks, [str(tick) for tick in ticks])
        axes.set_xticks([], minor=True)
        axes.set_xlim(walls[0] * 1e3, walls[-1] * 1e3)
        axes.set_ylim(0.0, None)
        axes.legend(loc="lower right")
    return figure


def stiffness_over_wall(walls: np.ndarray, support: float) -> np.ndarray:
    """Stiffness at the output for every wall [N·m/rad]."""
    widths = half_widths(rest_forces(1000.0))
    return assembled_stiffness(compliance(bodies(walls, support), widths))


def main(picture: Path = PICTURE) -> dict[str, np.ndarray]:
    use_double_precision()
    use_compilation_cache()
    walls = 1e-3 * np.unique(np.concatenate([np.geomspace(4.0, 60.0, 40), PRINTED]))
    widths = half_widths(rest_forces(1000.0))
    diagonal = np.stack([np.diag(np.tile(springs(widths, wall), 2)) for wall in walls], axis=-1)
    curves = {
        "springs (Johnson, Weber–Banaschek)": assembled_stiffness(diagonal),
        "ring held without displacement": stiffness_over_wall(walls, math.inf),
        "ring on a housing of 5·10¹¹ N/m³": stiffness_over_wall(walls, HOUSING),
        "ring with a free rim": stiffness_over_wall(walls, 0.0),
    }
    draw(walls, curves).savefig(picture, dpi=150)
    for wall in PRINTED:
        values = (
            f"{name} {curve[np.searchsorted(walls, 1e-3 * wall)]:.0f}" for name, curve in curves.items()
        )
        print(f"wall {wall:2.0f} mm, N·m/rad: {', '.join(values)}")
    return curves


if __name__ == "__main__":
    main(*(Path(argument) for argument in sys.argv[1:2]))

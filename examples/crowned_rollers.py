"""How two crowned steel rollers carry their load: along their line, and over the radius of the crown.

Rollers of 10 and 20 mm radius and 10 mm length under 2000 N.

Run it: ``python examples/crowned_rollers.py [picture.png]``.
"""

import sys
from pathlib import Path

import jax
import numpy as np
from matplotlib import rc_context
from matplotlib.figure import Figure
from scipy.interpolate import PchipInterpolator

from asperity.contact.crowned_line import CrownedLine, crowned_line
from asperity.contact.hertz_line import effective_radius, peak_pressure
from asperity.materials import contact_modulus
from asperity.precision import use_double_precision
from asperity.show.style import ACCENT, MARK, MUTED, STYLE

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "crowned_rollers.png"
LENGTH, FORCE = 10e-3, 2000.0
MODULUS = contact_modulus(
    youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
)
RADIUS = effective_radius(radius_1=10e-3, radius_2=20e-3, sign=1.0)
#: Crown radii of the curves along the line [m].
SHOWN = np.array([np.inf, 5.0, 2.0, 1.0, 0.3])


def loaded(crown_radius: np.ndarray) -> CrownedLine:
    """The pair with each of these crowns on one of its rollers."""
    found = jax.jit(crowned_line)(
        normal_force=FORCE,
        crown_curvature=1.0 / crown_radius,
        contact_length=LENGTH,
        effective_radius=RADIUS,
        contact_modulus=MODULUS,
    )
    return jax.tree.map(np.asarray, found)


def along(lines: CrownedLine, place: int) -> tuple[np.ndarray, np.ndarray]:
    """Distance from the middle [mm] and line load [N/mm] from one end of the rollers to the other."""
    half = 0.5e3 * LENGTH
    y, load = 1e3 * lines.position[:, place], 1e-3 * lines.line_load[:, place]
    last = 0.5e3 * lines.loaded_share[place] * LENGTH
    y, load = np.append(y, last), np.append(load, 1e-3 * lines.end_line_load[place])
    fine = np.linspace(0.0, last, 101)
    load = PchipInterpolator(y, load)(fine)
    if last < half:
        fine, load = np.append(fine, half), np.append(load, 0.0)
    return np.concatenate([-fine[::-1], fine]), np.concatenate([load[::-1], load])


def draw(shown: CrownedLine, radii: np.ndarray, lines: CrownedLine) -> Figure:
    with rc_context(STYLE):
        figure = Figure(figsize=(9.6, 4.0), layout="constrained")
        left, right = figure.subplots(1, 2)
        shades = np.linspace(0.25, 1.0, SHOWN.size)
        for place, (radius, shade) in enumerate(zip(SHOWN, shades, strict=True)):
            label = "cylinder" if np.isinf(radius) else f"{radius:g} m"
            color = MUTED if np.isinf(radius) else ACCENT
            left.plot(
                *along(shown, place), color=color, alpha=1.0 if np.isinf(radius) else shade, label=label
            )
        left.set_title("A crown moves the load to the middle")
        left.set_xlabel("place along the line [mm]")
        left.set_ylabel("line load [N/mm]")
        left.set_ylim(0.0, None)
        left.legend(title="crown radius")
        pressure = peak_pressure(
            normal_force=lines.line_load[0], contact_length=1.0, half_width=lines.half_width[0]
        )
        ends = 100.0 * lines.end_line_load * LENGTH / FORCE
        right.semilogx(radii, 1e-9 * pressure, color=MARK)
        right.set_title("Free ends cost pressure")
        right.set_xlabel("crown radius [m]")
        right.set_ylabel("peak pressure [GPa]", color=MARK)
        right.set_ylim(0.0, None)
        other = right.twinx()
        other.semilogx(radii, ends, color=ACCENT)
        other.set_ylabel("line load at the ends over the mean [%]", color=ACCENT)
        other.set_ylim(0.0, 105.0)
    return figure


def main(picture: Path = PICTURE) -> CrownedLine:
    use_double_precision()
    radii = np.geomspace(0.1, 100.0, 121)
    shown, lines = loaded(SHOWN), loaded(radii)
    draw(shown, radii, lines).savefig(picture, dpi=150)
    for radius, share, load, end in zip(
        SHOWN, shown.loaded_share, shown.line_load[0], shown.end_line_load, strict=True
    ):
        mean = FORCE / LENGTH
        print(
            f"crown {radius:g} m: {100 * share:.0f} % of the length loaded, {load / mean:.3f} of the mean line load in "
            f"the middle, {end / mean:.3f} at the ends"
        )
    return shown


if __name__ == "__main__":
    main(*(Path(argument) for argument in sys.argv[1:2]))

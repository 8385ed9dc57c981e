"""Rolling line contacts by boundary elements: onset of rolling, asperities, skew, rolling back and forth.

Run it: ``python examples/rolling_contact.py [picture.png]``. Lengths are over the half-width a, creepages over that of
gross slip, forces over friction.
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from asperity.bem import ElasticPair, FreeHalfSpace, steady_rolling, transient_rolling
from asperity.bem.rough_rolling import rough_pressure, rough_rolling
from asperity.contact.creep_layer import layer_creepage_factor
from asperity.contact.rolling_in import rolling_in_lag, rolling_in_length, rolling_in_shift
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.show.style import STYLE

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "rolling_contact.png"
POISSON_RATIO = 0.3
STIFFNESS_RATIO = 2.0 * (1.0 - POISSON_RATIO) / (2.0 - POISSON_RATIO)  # of asperities, tangential over normal
SLIP_RATIOS = (0.25, 0.5, 0.8)
COLORS = ("#9ecae1", "#3182bd", "#08306b")


class LineContact:
    """Half-width 1, contact modulus 2, largest friction 1: gross slip begins at creepage 1."""

    def __init__(self, cells: int) -> None:
        self.pixel = 2.0 / cells
        pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=1.0 - POISSON_RATIO, dundurs_constant=0.0)
        self.strip = FreeHalfSpace(
            pair, shape=(cells + 2,), pixel_size=(self.pixel,), reference_distance=10.0
        )
        edge = np.linspace(-1.0, 1.0, cells + 1)
        integral = 0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))
        self.pressure = np.pad(np.diff(integral) / self.pixel, 1)
        self.load = self.pressure.sum() * self.pixel

    def rolled(self, steps: np.ndarray, slip_ratio: float) -> tuple[np.ndarray, np.ndarray]:
        """Distance rolled and rigid shift under a constant force, from the standing contact on."""
        found = transient_rolling(
            self.strip,
            self.pressure,
            friction_coefficient=1.0,
            axis=0,
            rolled_pixels=np.r_[0, steps],
            layer_compliance=0.0,
            tangential_force=np.full(steps.size + 1, slip_ratio * self.load),
        )
        return np.asarray(found.rolled_distance), np.asarray(found.shear.displacement)

    def skewed(self, zeta: np.ndarray) -> np.ndarray:
        """Force over friction from both creepages over those of gross slip."""
        found = steady_rolling(
            self.strip,
            self.pressure,
            friction_coefficient=1.0,
            layer_compliance=0.0,
            longitudinal_creepage=zeta[0],
            lateral_creepage=zeta[1] / (1.0 - POISSON_RATIO),
        )
        return np.asarray(found.tangential_force) / self.load


def carter(slip_ratio: float) -> float:
    """Creepage over that of gross slip."""
    return 1.0 - np.sqrt(1.0 - slip_ratio)


def onset(contact: LineContact, distance: float = 3.5) -> dict[float, tuple[np.ndarray, np.ndarray]]:
    """Distance and shift since rolling began, the latter over the steady creepage."""
    steps = np.ones(round(distance / contact.pixel), dtype=int)
    histories = {}
    for q in SLIP_RATIOS:
        distances, shift = contact.rolled(steps, q)
        histories[q] = distances, (shift - shift[0]) / carter(q)
    return histories


def combined(contact: LineContact) -> list[tuple[float, float, float, float, float]]:
    """Size of zeta, its angle, size of the force, how far it is turned, and the error of the better direction."""
    rows = []
    for size in (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 4.0):
        for degrees in (15.0, 30.0, 45.0, 60.0, 75.0):
            zeta = size * np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
            force = contact.skewed(zeta)
            turned = np.degrees(np.arctan2(force[1], force[0])) - degrees
            weight = size / (2.0 * (2.0 - size)) if size < 1.0 else 1.0 - 0.5 / size**2
            along = zeta * np.array([1.0, (1.0 - POISSON_RATIO) ** -weight])
            rule = 1.0 - (1.0 - min(size, 1.0)) ** 2
            error = np.hypot(*(force - rule * along / np.hypot(*along)))
            rows.append((size, degrees, float(np.hypot(*force)), float(turned), float(error)))
    return rows


def drift(contact: LineContact, slip_ratio: float, stroke: int) -> float:
    """Creep per distance rolled over Carter's, in the last of many strokes back and forth."""
    cycles = max(1, 600 // stroke)
    steps = np.zeros(1200 if stroke <= 600 else 2 * stroke, dtype=int)
    back_and_forth = np.tile(np.r_[np.ones(stroke, dtype=int), -np.ones(stroke, dtype=int)], cycles)
    steps[: back_and_forth.size] = back_and_forth
    _, shift = contact.rolled(steps, slip_ratio)
    end = back_and_forth.size
    return float((shift[end] - shift[end - 2 * stroke]) / (2 * stroke * contact.pixel) / carter(slip_ratio))


def draw_onset(axes: Axes, histories: dict) -> None:
    for color, (q, (distance, shift)) in zip(COLORS, histories.items(), strict=True):
        axes.plot(
            0.5 * (distance[1:] + distance[:-1]),
            np.diff(shift) / np.diff(distance),
            color=color,
            label=f"$q$ = {q}",
        )
    axes.set_title("Onset of rolling under a constant force")
    axes.set_xlabel("rolled distance $s/a$")
    axes.set_ylabel(r"creepage $\xi/\xi_C$")
    axes.legend()


def draw_lag(axes: Axes, histories: dict) -> None:
    for color, (q, (distance, shift)) in zip(COLORS, histories.items(), strict=True):
        length = float(rolling_in_length(half_width=1.0, slip_ratio=q))
        lag = float(rolling_in_lag(half_width=1.0, slip_ratio=q))
        inside = distance <= 3.5 * length
        axes.plot((distance / length)[inside], ((distance - shift) / lag)[inside], color=color)
    model = rolling_in_shift(rolled_distance=distance, half_width=1.0, slip_ratio=0.0, creepage=1.0)
    axes.plot(distance, (distance - model) / 0.5, "k--", linewidth=1.0, label=r"table $\varphi$")
    axes.set_title("The same, as the creep that is missing")
    axes.set_xlabel("$s/s_0$, $s_0 = a(1-q)^{2/3}$")
    axes.set_ylabel("missing creep over $s_0/2$")
    axes.legend()


def rough_factors(layer_ratio: float, slip_ratios: tuple[float, ...]) -> list[float]:
    """Creepages of rough bodies over Carter's under growing forces."""
    contact, state, factors = rough_pressure(layer_ratio=layer_ratio, strips=200), None, []
    for q in slip_ratios:
        state = rough_rolling(contact, stiffness_ratio=STIFFNESS_RATIO, slip_ratio=q, start=state)
        factors.append(state.creepage / carter(q))
    return factors


def draw_layer(axes: Axes) -> None:
    q, points = np.linspace(0.02, 0.98, 200), (0.1, 0.3, 0.5, 0.7, 0.85, 0.95)
    for color, s in zip(COLORS, (0.05, 0.1, 0.2), strict=True):
        factor = layer_creepage_factor(layer_ratio=s, slip_ratio=q, stiffness_ratio=STIFFNESS_RATIO)
        axes.plot(q, np.asarray(factor), color=color, label=f"$s$ = {s}")
        axes.plot(points, rough_factors(s, points), "o", color=color, markersize=4)
    axes.set_ylim(1.0, 1.6)
    axes.set_title("Asperities (points: boundary elements)")
    axes.set_xlabel("slip ratio $q = Q/\\mu N$")
    axes.set_ylabel(r"creepage $\xi/\xi_C$")
    axes.legend()


def draw_strokes(axes: Axes, strokes: np.ndarray, drifts: dict[float, list[float]]) -> None:
    for color, (q, values) in zip(COLORS, drifts.items(), strict=True):
        axes.plot(strokes, values, "o-", color=color, markersize=3, label=f"$q$ = {q}")
    axes.set_title("Rolling back and forth under a constant force")
    axes.set_xlabel("length of the stroke over $a$")
    axes.set_ylabel("drift per distance rolled over Carter's")
    axes.legend()


def main(picture: Path = PICTURE) -> dict[str, float]:
    use_double_precision()
    use_compilation_cache()
    fine, coarse = LineContact(200), LineContact(100)
    histories = onset(fine)
    print("rolled distance at which the creepage is largest, its peak, lag over the half-width, by q")
    for q, (distance, shift) in histories.items():
        ratio = np.diff(shift) / np.diff(distance)
        print(f"{q:6.2f}{distance[ratio.argmax()]:8.2f}{ratio.max():8.2f}{distance[-1] - shift[-1]:8.3f}")
    rows = combined(coarse)
    print("both creepages: |zeta|, angle, force - rule, turned by [deg], error of the better direction")
    for size, degrees, force, turned, error in rows:
        print(
            f"{size:6.2f}{degrees:6.0f}{force - 1.0 + (1.0 - min(size, 1.0)) ** 2:10.4f}{turned:8.2f}{error:8.4f}"
        )
    strokes = np.array([5, 10, 15, 20, 30, 40, 50, 60, 70, 80, 100, 150, 200])
    drifts = {q: [drift(coarse, q, int(n)) for n in strokes] for q in SLIP_RATIOS}
    for q, values in drifts.items():
        print(f"drift in strokes of a/10 to 4a, q = {q}: " + " ".join(f"{value:.3f}" for value in values))
    with rc_context(STYLE):
        figure = Figure(figsize=(11.0, 7.6), layout="constrained")
        panels = figure.subplots(2, 2)
        draw_onset(panels[0, 0], histories)
        draw_lag(panels[0, 1], histories)
        draw_layer(panels[1, 0])
        draw_strokes(panels[1, 1], strokes * coarse.pixel, drifts)
        figure.savefig(picture, dpi=150)
    distance, shift = histories[0.5]
    return {
        "creepage at the start": float((shift[1] - shift[0]) / (distance[1] - distance[0])),
        "largest turn of the force up to gross slip": max(row[3] for row in rows if row[0] <= 1.0),
        "largest error of the better direction": max(row[4] for row in rows),
        "drift in short strokes": drifts[0.5][3],
        "drift in long strokes": drifts[0.5][-1],
    }


if __name__ == "__main__":
    main(*(Path(argument) for argument in sys.argv[1:2]))

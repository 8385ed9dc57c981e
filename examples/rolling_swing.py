"""Table of :mod:`asperity.contact.rolling_in`: drift of a line contact that rolls to and fro under a constant force.

Run it: ``python examples/rolling_swing.py`` (about two minutes). Lengths are over the half-width, forces over friction.
The drift is that of the last of many swings, per distance rolled, over Carter's.
"""

import numpy as np

from asperity.bem import ElasticPair, FreeHalfSpace, transient_rolling
from asperity.contact.rolling_in import SLIP_RATIOS, STROKES
from asperity.precision import use_compilation_cache, use_double_precision

CELLS, STEPS = 200, 2000
PIXEL = 2.0 / CELLS


def drift_share(slip_ratio: float, stroke: int) -> float:
    """Share of Carter's drift that is left in a swing of so many pixels to and as many fro."""
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)
    strip = FreeHalfSpace(pair, shape=(CELLS + 2,), pixel_size=(PIXEL,), reference_distance=10.0)
    edge = np.linspace(-1.0, 1.0, CELLS + 1)
    pressure = np.pad(np.diff(0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))) / PIXEL, 1)
    swings = STEPS // (2 * stroke)
    steps = np.zeros(STEPS, dtype=int)
    steps[: 2 * stroke * swings] = np.tile(
        np.r_[np.ones(stroke, dtype=int), -np.ones(stroke, dtype=int)], swings
    )
    found = transient_rolling(
        strip,
        pressure,
        friction_coefficient=1.0,
        axis=0,
        rolled_pixels=np.r_[0, steps],
        layer_compliance=0.0,
        tangential_force=np.full(STEPS + 1, slip_ratio * pressure.sum() * PIXEL),
    )
    shift = np.asarray(found.shear.displacement)
    end = 2 * stroke * swings
    return float((shift[end] - shift[end - 2 * stroke]) / (end / swings * PIXEL)) / carter(slip_ratio)


def carter(slip_ratio: float) -> float:
    """Steady creepage over that of gross slip."""
    return float(1.0 - np.sqrt(1.0 - slip_ratio))


def main() -> np.ndarray:
    use_double_precision()
    use_compilation_cache()
    table = []
    for q in SLIP_RATIOS:
        pixels = np.unique(np.rint(STROKES * (1.0 - q) / PIXEL).astype(int))
        shares = [drift_share(q, int(n)) for n in pixels]
        table.append(np.interp(STROKES, pixels * PIXEL / (1.0 - q), shares))
        print(f"q = {q}: " + ", ".join(f"{share:.3f}" for share in table[-1]), flush=True)
    return np.array(table)


if __name__ == "__main__":
    main()

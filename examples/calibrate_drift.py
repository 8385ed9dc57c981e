"""Preload and friction from a drift curve: write one with known values, or count how often the intervals hold.

``python calibrate_drift.py drift.csv`` writes the synthetic measurement of the paper's joint with a preload of 900 N
and mu = 0.14 at torques from -10 to 10 N·m: the angle lost per output turn, with errors of 0.2 arcmin and a zero of
0.5 arcmin. ``python calibrate_drift.py 200`` fits so many of them, each with new errors.
"""

import math
import sys
from pathlib import Path

import numpy as np

from asperity.joint_file.reader import read_case
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.study.calibration.calibrate import calibrate
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns

ARCMIN = math.pi / 180.0 / 60.0
TRUTH = {
    "load.preload=300 N:3000 N": 900.0,
    "load.friction_coefficient=0.09:0.4": 0.14,
    "offset=-5 arcmin:5 arcmin": 0.5 * ARCMIN,
}
SCATTER = 0.2 * ARCMIN
TORQUE = np.repeat(np.setdiff1d(np.linspace(-10.0, 10.0, 21), [0.0]), 2)

CASE = Path(__file__).parent / "zou2025.toml"


def exact() -> np.ndarray:
    """Drift of the true joint per output turn [rad]."""
    case, blank = read_case(CASE), measured(np.zeros(TORQUE.size))
    unknowns = read_unknowns(TRUTH, case=case, measurements=(blank,))
    model = CurveModel(case=case, measurement=blank, unknowns=unknowns, level="assembly", history="virgin")
    return model(np.array([u.to_unit(v) for u, v in zip(unknowns, TRUTH.values(), strict=True)]))[0]


def measured(drift: np.ndarray) -> Measurement:
    """A measurement at the torques of this example."""
    return Measurement(TORQUE, None, None, None, np.zeros(TORQUE.size), "synthetic", drift)


def coverage(count: int) -> dict[str, tuple[int, float, float]]:
    """Unknown → how many intervals hold it, mean half-width, and standard deviation of the estimates [SI]."""
    case, drift, rng = read_case(CASE), exact(), np.random.default_rng(2025)
    rows = []
    for _ in range(count):
        data = measured(drift + SCATTER * rng.standard_normal(TORQUE.size))
        found = calibrate(
            case=case,
            measurements=(data,),
            unknowns=read_unknowns(TRUTH, case=case, measurements=(data,)),
            level="assembly",
            history="virgin",
            starts=1,
            seed=0,
        )
        rows.append([(each.lower, each.value, each.upper) for each in found.estimates])
    table = np.array(rows)  # (curves, unknowns, ends)
    values = np.array(list(TRUTH.values()))
    held = np.sum((table[..., 0] < values) & (values < table[..., 2]), axis=0)
    width = 0.5 * np.mean(table[..., 2] - table[..., 0], axis=0)
    spread = np.std(table[..., 1], axis=0)
    return {
        path.partition("=")[0]: (int(held[i]), float(width[i]), float(spread[i]))
        for i, path in enumerate(TRUTH)
    }


def main(argument: str) -> None:
    use_double_precision()
    use_compilation_cache()
    if argument.isdigit():
        count = int(argument)
        print(
            f"95 % intervals over {count} drift curves (counting error {100 * (0.0475 / count) ** 0.5:.1f} %)"
        )
        for (path, (held, width, spread)), true in zip(coverage(count).items(), TRUTH.values(), strict=True):
            shares = 100.0 * held / count, 100.0 * width / true, 100.0 * spread / true
            print(
                "  {:26s} {:5.1f} %   half-width {:.3g} %, scatter of the estimates {:.3g} %".format(
                    path, *shares
                )
            )
        return
    errors = SCATTER * np.random.default_rng(1).standard_normal(TORQUE.size)
    lines = ["# synthetic: see calibrate_drift.py", "torque [N*m],drift [arcmin/turn]"]
    lines += [
        f"{torque:g},{drift / ARCMIN:.4f}" for torque, drift in zip(TORQUE, exact() + errors, strict=True)
    ]
    Path(argument).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])

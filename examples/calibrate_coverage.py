"""Do the intervals of a calibration hold what they promise? Many synthetic curves with known unknowns.

Each curve has both directions of torque, hysteresis, play, an offset and a drift, and normal errors of the angle.
Counted is how often the 95 % interval of each unknown contains its true value. Run: python calibrate_coverage.py 200
"""

import sys
from pathlib import Path

import numpy as np

from asperity.case.reader import read_case
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.study.calibrate import calibrate
from asperity.study.curve_model import CurveModel
from asperity.study.measurement import Measurement
from asperity.study.unknowns import read_unknowns

TRUTH = {
    "load.preload=300 N:3000 N": 900.0,
    "load.friction_coefficient=0.09:0.4": 0.14,
    "play=0 arcmin:1 arcmin": 3e-5,
    "offset=-1 arcmin:1 arcmin": 1e-5,
    "drift=-1e-6 rad/s:1e-6 rad/s": 2e-8,
}
SCATTER = 1e-6  # rad, 0.2 arcsec


def coverage(count: int) -> dict[str, tuple[int, float]]:
    """How often each interval holds the truth, and its mean relative half-width."""
    use_double_precision()
    use_compilation_cache()
    case = read_case(Path(__file__).parent / "zou2025.toml")
    loop = np.linspace(10.0, -10.0, 31)[1:]
    torque = np.concatenate([np.linspace(0.3, 10.0, 15), loop, -loop])
    data = Measurement(torque, np.zeros(75), None, np.arange(75.0), np.zeros(75), "synthetic")
    unknowns = read_unknowns(TRUTH, case=case, measurement=data)
    model = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
    true = np.array([u.to_unit(v) for u, v in zip(unknowns, TRUTH.values(), strict=True)])
    exact, _ = model(true)
    rng = np.random.default_rng(2025)
    held = {u.path: 0 for u in unknowns}
    width = {u.path: 0.0 for u in unknowns}
    for _ in range(count):
        noisy = Measurement(
            torque, exact + SCATTER * rng.standard_normal(75), None, data.time, data.repetition, "synthetic"
        )
        found = calibrate(
            case=case,
            measurement=noisy,
            unknowns=unknowns,
            level="assembly",
            history="virgin",
            starts=1,
            seed=0,
        )
        for each, value in zip(found.estimates, TRUTH.values(), strict=True):
            held[each.path] += each.lower < value < each.upper
            width[each.path] += 0.5 * (each.upper - each.lower) / value / count
    return {path: (held[path], width[path]) for path in held}


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    error = 100.0 * (0.95 * 0.05 / count) ** 0.5
    print(f"95 % intervals over {count} synthetic curves (counting error {error:.1f} %)")
    for path, (held, width) in coverage(count).items():
        print(
            f"  {path:28s} {100.0 * held / count:5.1f} %   mean half-width {100.0 * width:.3g} % of the value"
        )


if __name__ == "__main__":
    main()

"""Do the intervals of a calibration hold what they promise? Many synthetic curves with known unknowns.

Each curve has both directions of torque, hysteresis, play, an offset and a drift, and normal errors of the angle.
Counted is how often the 95 % interval of each unknown contains its true value. Run: python calibrate_coverage.py 200

With a second number the posterior, of so many draws a chain, is counted beside it: python calibrate_coverage.py 40 100
"""

import sys
from pathlib import Path

import numpy as np

from asperity.errors import NoSolutionError
from asperity.joint_file.reader import read_case
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.study.calibration.calibrate import Calibration, calibrate
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns

TRUTH = {
    "load.preload=300 N:3000 N": 900.0,
    "load.friction_coefficient=0.09:0.4": 0.14,
    "play.angle=0 arcmin:1 arcmin": 3e-5,
    "offset=-1 arcmin:1 arcmin": 1e-5,
    "drift=-1e-6 rad/s:1e-6 rad/s": 2e-8,
}
SCATTER = 1e-6  # rad, 0.2 arcsec

#: Unknown → how many intervals hold the truth, and their mean relative half-width.
Coverage = dict[str, tuple[int, float]]


def coverage(count: int, draws: int) -> tuple[int, Coverage, Coverage]:
    """Number of curves that counted, and what least squares and (where draws are asked for) the posterior reach."""
    use_double_precision()
    use_compilation_cache()
    case = read_case(Path(__file__).parent / "zou2025.toml")
    loop = np.linspace(10.0, -10.0, 31)[1:]
    torque = np.concatenate([np.linspace(0.3, 10.0, 15), loop, -loop])
    data = Measurement(torque, np.zeros(75), None, np.arange(75.0), np.zeros(75), "synthetic")
    unknowns = read_unknowns(TRUTH, case=case, measurements=(data,))
    model = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
    values = list(TRUTH.values())
    true = np.array([u.to_unit(v) for u, v in zip(unknowns, values, strict=True)])
    exact, _ = model(true)
    rng = np.random.default_rng(2025)
    ends: list[np.ndarray] = []
    for curve in range(count):
        noisy = Measurement(
            torque, exact + SCATTER * rng.standard_normal(75), None, data.time, data.repetition, "synthetic"
        )
        found = calibrate(
            case=case,
            measurements=(noisy,),
            unknowns=unknowns,
            level="assembly",
            history="virgin",
            starts=1,
            seed=0,
        )
        try:
            drawn = posterior_ends(found, draws, seed=curve) if draws else np.zeros((len(unknowns), 2))
        except NoSolutionError as error:
            print(f"  not counted: {error}")
            continue
        ends.append(np.stack([np.array([(e.lower, e.upper) for e in found.estimates]), drawn]))
    table = np.array(ends)  # (curves, ways, unknowns, ends)
    inside = (table[..., 0] < np.array(values)) & (np.array(values) < table[..., 1])
    width = 0.5 * np.nanmean(table[..., 1] - table[..., 0], axis=0) / np.array(values)
    by_way = [
        {u.path: (int(inside[:, way, i].sum()), float(width[way, i])) for i, u in enumerate(unknowns)}
        for way in (0, 1)
    ]
    return len(ends), by_way[0], by_way[1]


def posterior_ends(found: Calibration, draws: int, seed: int) -> np.ndarray:
    """Ends of the middle 95 % of the posterior, shape (unknowns, 2) [SI]."""
    from asperity.study.calibration.posterior import posterior

    scaled_values = np.quantile(
        posterior(found, draws=draws, seed=seed).scaled_values, (0.025, 0.975), axis=0
    )
    return np.array([u.from_unit(scaled_values[:, i]) for i, u in enumerate(found.unknowns)])


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    draws = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    counted, by_squares, by_posterior = coverage(count, draws)
    error = 100.0 * (0.95 * 0.05 / counted) ** 0.5
    print(f"95 % intervals over {counted} synthetic curves (counting error {error:.1f} %)")
    ways = {"least squares": by_squares, **({"posterior": by_posterior} if draws else {})}
    for name, table in ways.items():
        print(name)
        for path, (held, width) in table.items():
            share = 100.0 * held / counted
            print(f"  {path:28s} {share:5.1f} %   mean half-width {100.0 * width:.3g} % of the value")


if __name__ == "__main__":
    main()

"""Write a synthetic measurement with known values, to try a calibration on: python calibrate_synthetic.py curve.csv

The joint of the paper with a preload of 900 N and mu = 0.14, two repetitions of a full loop of ±10 N·m, each with its
own zero; a play of 0.1 arcmin that 0.2 N·m take up, a drift of 0.3 arcmin an hour, errors of 0.2 arcsec.
"""

import math
import sys
from pathlib import Path

import numpy as np

from asperity.joint_file.reader import read_case
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns

ARCMIN = math.pi / 180.0 / 60.0
TRUTH = {
    "load.preload=300 N:3000 N": 900.0,
    "load.friction_coefficient=0.09:0.4": 0.14,
    "play.angle=0 arcmin:1 arcmin": 0.1 * ARCMIN,
    "play.take_up_torque=0.01 N*m:5 N*m": 0.2,
    "drift=-1 arcmin/min:1 arcmin/min": 0.3 * ARCMIN / 3600.0,
}
OFFSETS = (0.03 * ARCMIN, -0.05 * ARCMIN)


def synthetic(seed: int) -> Measurement:
    """The measurement in SI units."""
    loop = np.linspace(10.0, -10.0, 41)[1:]
    once = np.concatenate([np.linspace(0.0, 10.0, 21), loop, -loop])
    torque = np.concatenate([once, once[:0:-1][:20], once])  # back to zero between the repetitions
    repetition = np.concatenate([np.ones(once.size), np.ones(20), np.full(once.size, 2.0)])
    blank = Measurement(
        torque, np.zeros(torque.size), None, 4.0 * np.arange(torque.size), repetition, "synthetic"
    )
    case = read_case(Path(__file__).parent / "zou2025.toml")
    unknowns = read_unknowns(TRUTH, case=case, measurements=(blank,))
    model = CurveModel(case=case, measurement=blank, unknowns=unknowns, level="assembly", history="virgin")
    angle, _ = model(np.array([u.to_unit(v) for u, v in zip(unknowns, TRUTH.values(), strict=True)]))
    noise = 0.2 / 60.0 * ARCMIN * np.random.default_rng(seed).standard_normal(torque.size)
    angle = angle + np.where(repetition == 1.0, *OFFSETS) + noise
    return Measurement(torque, angle, None, blank.time, repetition, "synthetic")


def main() -> None:
    use_double_precision()
    use_compilation_cache()
    data = synthetic(seed=1)
    assert data.angle is not None
    assert data.time is not None
    lines = ["# synthetic: see calibrate_synthetic.py", "time [s],repetition,torque [N*m],angle [arcmin]"]
    for time, repetition, torque, angle in zip(
        data.time, data.repetition, data.torque, data.angle, strict=True
    ):
        lines.append(f"{time:g},{repetition:g},{torque:.4f},{angle / ARCMIN:.5f}")
    Path(sys.argv[1]).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()

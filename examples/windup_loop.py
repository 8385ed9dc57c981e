"""Torque–angle loop of the paper's joint up to 12 N·m, its lost motion and catalogue stages.

Run it: ``python examples/windup_loop.py [picture.png]``.
"""

import sys
from pathlib import Path

import numpy as np

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.show.windup_figure import windup_figure
from asperity.standing.windup import Windup, windup

ARCMINUTES = 10800.0 / np.pi


def main(picture: str | None = None) -> Windup:
    use_double_precision()
    use_compilation_cache()
    joint = joint_from_case(read_case(Path(__file__).parent / "zou2025.toml"))
    curve = windup(joint, largest_torque=12.0, level="assembly", stage_shares=(1 / 3, 2 / 3))
    print(f"wind-up at 12 N·m: {float(curve.angle[-1]) * ARCMINUTES:.4f} arcmin")
    print(f"lost motion: {float(curve.lost_motion) * ARCMINUTES:.4f} arcmin")
    for name, stiffness in zip(("K1", "K2", "K3"), np.asarray(curve.stage_stiffness), strict=True):
        print(f"{name}: {stiffness / ARCMINUTES:.4f} N·m/arcmin")
    if picture:
        windup_figure(curve, title="Wind-up of the paper's joint").savefig(picture, dpi=150)
    return curve


if __name__ == "__main__":
    main(*sys.argv[1:2])

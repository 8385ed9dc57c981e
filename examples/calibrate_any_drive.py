"""Synthetic curves of a drive of any type with known numbers: ``python calibrate_any_drive.py planetary 10``.

Writes ``planetary_curve.csv``, a loop of torque and angle up to 10 N·m, and ``planetary_drift.csv``, the angle lost per
output turn. The joint has nine tenths of the preload or the interference of ``planetary.toml`` and 1.15 times its
friction; errors are 0.1 % of the largest angle and 0.5 % of the largest drift. Then::

    asperity calibrate planetary.toml planetary_curve.csv -u load.interference -u load.friction_coefficient -u offset
"""

import dataclasses
import sys
from pathlib import Path
from typing import Any

import numpy as np

import asperity

#: Known numbers over those of the joint file.
TRUTH = {"load.preload": 0.9, "load.interference": 0.9, "load.friction_coefficient": 1.15}
ERRORS = {"angle": 1e-3, "drift": 5e-3}
ROLLED = 20


def known_joint(name: str) -> Any:
    """The example with the known numbers."""
    joint = asperity.load(Path(__file__).with_name(f"{name}.toml"))
    stated = {path: joint[path] for path in TRUTH if path in joint.numbers}
    return joint.with_values(
        {path: dataclasses.replace(each, si=TRUTH[path] * each.si) for path, each in stated.items()}
    )


def loop(joint: Any, torque: float) -> tuple[np.ndarray, np.ndarray]:
    """First loading, unloading and reloading: torques [N·m] and angles [rad]."""
    curve = asperity.windup(joint, torque=f"{torque} N*m").curve
    torques = np.asarray(curve.torque)
    up = torques > 0.0
    angles = [np.asarray(curve.angle)[up], np.asarray(curve.unloading_angle)[::-1][1:]]
    angles.append(np.asarray(curve.reloading_angle)[1:])
    return np.concatenate([torques[up], torques[::-1][1:], torques[1:]]), np.concatenate(angles)


def rolled(joint: Any, torque: float) -> tuple[np.ndarray, np.ndarray]:
    """Torques of both signs [N·m] and the drift per output turn [rad]."""
    half = np.linspace(torque / ROLLED, torque, ROLLED)
    torques = np.concatenate([-half[::-1], half])
    found = [joint.with_values({"load.output_torque": f"{each} N*m"}).solve()["drift"].si for each in torques]
    return torques, np.array(found)


def write(name: str, largest: float, folder: Path) -> None:
    """Both curves with errors, as CSV files."""
    joint, random = known_joint(name), np.random.default_rng(2026)
    for file, column, (torque, value) in (
        ("curve", "angle", loop(joint, largest)),
        ("drift", "drift", rolled(joint, largest)),
    ):
        errors = ERRORS[column] * np.abs(value).max() * random.standard_normal(value.size)
        np.savetxt(
            folder / f"{name}_{file}.csv",
            np.column_stack([torque, 1e3 * (value + errors)]),
            fmt="%.9g",
            delimiter=",",
            header=f"torque [N*m],{column} [mrad]",
            comments="",
        )


if __name__ == "__main__":
    write(sys.argv[1], float(sys.argv[2]), Path())

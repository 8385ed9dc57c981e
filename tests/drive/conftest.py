"""Forces of batches of one size, so that each closure is compiled once for all files here."""

import equinox as eqx
import numpy as np
import pytest

from asperity.drive.force_balance import force_balance
from asperity.joint.evaluation import mechanism

SIZE = 256


@eqx.filter_jit
def _solved(joint):
    return force_balance(mechanism=mechanism(joint), output_torque=joint.output_torque)


def _numbers(forces):
    names = ("sp", "pwr", "pwl", "wro", "wlo")
    flat = {f"N_{name}": value for name, value in zip(names, np.asarray(forces.normal), strict=True)}
    flat |= {f"T_{name}": value for name, value in zip(names, np.asarray(forces.tangential), strict=True)}
    flat |= {"F_cl": forces.pin_left, "F_cr": forces.pin_right}
    flat |= {"T_in": forces.input_torque, "T_out": forces.output_torque}
    flat |= {"B_l": forces.left_bearing_torque, "B_r": forces.right_bearing_torque}
    return {key: np.asarray(value) for key, value in flat.items()}


@pytest.fixture(scope="session")
def solved_forces():
    """The compiled force balance of a batch of joints."""
    return _solved


@pytest.fixture(scope="session")
def forces_of(paper_joint):
    """Forces of a batch of the paper's joint with changes, as a dictionary of arrays of the length of the changes."""

    def solve(**changes):
        closure = changes.pop("closure", "elastic")
        rows = np.broadcast_arrays(*map(np.atleast_1d, changes.values()))
        count = rows[0].size
        padded = {key: np.resize(row, SIZE).astype(float) for key, row in zip(changes, rows, strict=True)}
        forces = _solved(paper_joint(closure=closure, **({"preload": np.full(SIZE, 1000.0)} | padded)))
        found = {key: value[:count] for key, value in _numbers(forces).items()}
        return found | {
            "balance": np.asarray(forces.balance_residual)[:count],
            "closure": np.asarray(forces.closure_residual)[:count],
        }

    return solve

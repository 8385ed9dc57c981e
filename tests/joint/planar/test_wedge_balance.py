"""The paper's drive, listed as bodies and contacts, satisfies the paper's equations (1) to (5) and their closure."""

import dataclasses

import jax
import numpy as np
import pytest

from asperity.compilation import compile_fast
from asperity.drive.branch import branch_forces, carrier_residual
from asperity.drive.force_balance import closure_misfit, loaded_branch
from asperity.joint.evaluation import mechanism
from asperity.joint.planar.evaluation import evaluate_planar
from asperity.joint_file.build import joint_from_case

pytestmark = pytest.mark.slow


def solved(joint):
    numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    return jax.tree.map(np.asarray, compile_fast(evaluate_planar, numbers)(numbers))


def balanced(joint, normal, tangential):
    """Forces by the published equations from two sums of a state and its split, and what they leave over [N]."""
    branch = loaded_branch(mechanism=mechanism(joint), output_torque=joint.output_torque)
    force = branch_forces(branch, normal[1] + normal[2], tangential[0], tangential[1])
    return force, float(closure_misfit(branch, force)), float(carrier_residual(branch, force))


@pytest.mark.parametrize("springs", ["bulk", "bulk_and_asperities"])
def test_forces_close_as_in_the_paper(case, as_planar, springs):
    """With exact bodies in the assembly: those of the closure are springs, around the same forces at rest."""
    joint = dataclasses.replace(joint_from_case(case), closure_springs=springs)
    found = solved(as_planar(joint))
    assert bool(found.solved)
    np.testing.assert_allclose(found.rest.normal[0], 1000.0, rtol=1e-12)
    for state in (found.forces, found.rolling):
        force, misfit, moment = balanced(joint, state.normal, state.tangential)
        np.testing.assert_allclose(state.normal, np.ravel(force.normal), rtol=1e-12)
        np.testing.assert_allclose(state.tangential, np.ravel(force.tangential), rtol=1e-12)
        assert abs(misfit) < 1e-8
        assert abs(moment) < 1e-10


def test_an_interference_makes_the_preload_that_makes_it(case, as_planar):
    joint = dataclasses.replace(as_planar(joint_from_case(case)), output_torque=3.0)
    stated = solved(joint)
    fitted = solved(dataclasses.replace(joint, preload=None, interference=float(stated.interference)))
    np.testing.assert_allclose(fitted.rest.normal, stated.rest.normal, rtol=1e-9)
    for state in ("forces", "rolling"):
        np.testing.assert_allclose(
            getattr(fitted, state).normal, getattr(stated, state).normal, rtol=1e-9, err_msg=state
        )
    assert float(fitted.assembly.stiffness.output) == pytest.approx(
        float(stated.assembly.stiffness.output), rel=1e-9
    )

"""A joint that stands under given torques, and the same joint without slip."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.compilation import call_compiled
from asperity.joint.planar.evaluation import evaluate_planar
from asperity.joint.standing import NO_SLIP_FRICTION, _at_torques, at_standstill, standing_at, without_slip


def test_bearings_resist_the_motion_that_each_torque_begins(paper_joint):
    joint = paper_joint(sun_speed=-100.0)
    batch = at_standstill(joint, jnp.array([-3.0, 0.0, 4.0]))
    np.testing.assert_array_equal(batch.output_torque, [-3.0, 0.0, 4.0])
    np.testing.assert_array_equal(batch.sun_speed, [-100.0, 100.0, 100.0])


def test_without_slip_only_friction_changes(paper_joint):
    joint = paper_joint()
    changed = without_slip(joint)
    assert {float(friction) for friction in changed.friction_coefficients} == {NO_SLIP_FRICTION}
    assert changed.geometry is joint.geometry
    # 1 - T/(mu N) is exactly 1: no slip at all
    assert 1.0 - 1e6 / (NO_SLIP_FRICTION * 1.0) == 1.0


@pytest.mark.slow
def test_own_and_without_slip_are_those_of_single_joints(paper_joint):
    joint = jax.tree.map(lambda leaf: np.asarray(leaf, float), paper_joint())
    torques = np.array([-3.0, 4.0])
    found = standing_at(joint, jnp.asarray(torques))
    for k, torque in enumerate(torques):
        one = at_standstill(joint, jnp.asarray(torque))
        for levels, alone in ((found.levels, one), (found.levels_without_slip, without_slip(one))):
            expected = call_compiled(evaluate, alone).assembly.stiffness.output
            np.testing.assert_allclose(levels["assembly"][k], expected, rtol=1e-12)
        assert found.levels["assembly"][k] < found.levels_without_slip["assembly"][k]
    assert found.solved.all()
    assert found.slip_ratio.shape == (5, 2)


@pytest.mark.slow
def test_only_one_assembly_is_solved_in_a_program(paper_joint):
    # as many calls of LAPACK side by side as the machine has cores wait for each other for ever (jaxlib 0.10)
    joint = jax.tree.map(lambda leaf: np.asarray(leaf, float), paper_joint())
    batch = at_standstill(joint, jnp.array([-3.0, 4.0]))
    programs = [
        jax.jit(function).lower(batch).as_text()
        for function in (_at_torques, lambda each: evaluate_planar(each).assembly)
    ]
    factorisations = [program.count("@lapack_dgetrf_ffi") for program in programs]
    assert factorisations[0] == factorisations[1] > 0

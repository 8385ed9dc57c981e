"""A joint with a loading cam against joints that have its preload by interference."""

import dataclasses

import jax
import numpy as np
import pytest

from asperity.joint.capacity import LIMIT_KINDS, torque_capacity
from asperity.joint.description import preload_at
from asperity.joint.planar.evaluation import evaluate_planar

CAM, LEAST = 60.0, 300.0


@pytest.fixture(scope="module")
def pressed(paper_joint):
    """The paper's joint with a cam, as springs, in both directions; and the same preloads by interference."""
    torque = np.array([-8.0, -1.0, 4.9, 5.0, 5.1])
    joint = dataclasses.replace(
        paper_joint(output_torque=torque, preload=np.full(5, LEAST)),
        body_model="springs",
        cam_force_per_torque=np.full(5, CAM),
    )
    held = dataclasses.replace(joint, preload=preload_at(joint, torque), cam_force_per_torque=None)
    program = jax.jit(evaluate_planar)
    return joint, program(joint), program(held)


@pytest.mark.slow
def test_forces_creep_and_life_are_those_of_the_preload_at_the_torque(pressed):
    _, with_cam, held = pressed
    assert np.asarray(with_cam.forces.normal) == pytest.approx(np.asarray(held.forces.normal), rel=1e-12)
    assert np.asarray(with_cam.interference) == pytest.approx(np.asarray(held.interference), rel=1e-12)
    assert np.asarray(with_cam.rolling.speed_loss) == pytest.approx(
        np.asarray(held.rolling.speed_loss), rel=1e-9
    )
    assert np.asarray(with_cam.published.output) == pytest.approx(
        np.asarray(held.published.output), rel=1e-12
    )
    assert np.all(np.asarray(held.cam_angle) == 0.0)
    assert np.all(np.asarray(held.assembly.loading_cam_share) == 0.0)


@pytest.mark.slow
def test_the_cam_adds_its_turning_to_the_compliance(pressed):
    """Its angle over the torque, by central differences, is what the stiffness loses."""
    _, with_cam, held = pressed
    added = 1.0 / np.asarray(with_cam.assembly.stiffness.output) - 1.0 / np.asarray(
        held.assembly.stiffness.output
    )
    turned = np.asarray(with_cam.cam_angle)
    assert added[3] == pytest.approx((turned[4] - turned[2]) / 0.2, rel=1e-4)
    assert np.all(added > 0.0)


@pytest.fixture(scope="module")
def capacity():
    return jax.jit(torque_capacity)


@pytest.mark.slow
@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_capacity_is_that_of_the_preload_which_it_makes(paper_joint, capacity, direction):
    plain = dataclasses.replace(paper_joint(preload=LEAST), body_model="springs")
    found = capacity(dataclasses.replace(plain, cam_force_per_torque=np.asarray(CAM)), direction=direction)
    assert LIMIT_KINDS[int(found.limit)] == "gross_slip"
    torque = float(found.output_torque)
    alike = capacity(
        dataclasses.replace(plain, preload=np.asarray(LEAST + CAM * torque)), direction=direction
    )
    assert float(alike.output_torque) == pytest.approx(torque, rel=1e-10)
    assert torque > 2.0 * float(capacity(plain, direction=direction).output_torque)


@pytest.mark.slow
def test_a_strong_cam_never_slips_and_ends_with_another_limit(paper_joint, capacity):
    plain = dataclasses.replace(paper_joint(preload=LEAST), body_model="springs")
    found = capacity(dataclasses.replace(plain, cam_force_per_torque=np.asarray(150.0)), direction=1.0)
    assert LIMIT_KINDS[int(found.limit)] == "contact_too_wide"
    assert 1e3 < float(found.output_torque) < 1e6

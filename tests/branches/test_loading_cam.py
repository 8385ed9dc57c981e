"""A loading cam that presses branches of unlike sizes."""

import dataclasses

import numpy as np
import pytest

from asperity.branches.branches import BranchedJoint
from asperity.branches.sizes import SectorDeviations
from asperity.drive.stiffness.loading_cam import LoadingCam
from asperity.joint.solve import solve_joint

CAM, TORQUE = 150.0, 10.0
AS_SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'ring_support = "free"': 'ring_support = "rigid_housing"',
}


def sizes_of(deviations):
    """Sizes of planets, each between a sun and a ring that are held: half of a deviation acts at either contact."""
    larger = np.asarray(deviations, dtype=float)
    return SectorDeviations({"planet": larger}, np.stack([larger, larger], axis=1), np.ones(2), np.inf)


@pytest.fixture(scope="module")
def branches(planar_joint):
    """The planetary example with planets of given sizes, with and without a cam; and its solution."""
    plain = planar_joint("planetary", AS_SPRINGS)

    def of(deviations, *, interference=plain.interference, cam=CAM, torque=TORQUE):
        joint = dataclasses.replace(
            plain,
            interference=interference,
            output_torque=torque,
            cam=None if cam is None else LoadingCam(cam, plain.pattern),
        )
        solution = solve_joint(joint)
        return BranchedJoint(joint, solution).branches(sizes_of(deviations)), solution.result

    return of


@pytest.mark.slow
@pytest.mark.parametrize("torque", [TORQUE, -TORQUE])
def test_equal_branches_are_those_without_sizes(branches, torque):
    found, equal = branches([0.0, 0.0, 0.0], torque=torque)
    np.testing.assert_allclose(found.preload, float(equal.rest.normal[0]), rtol=1e-8)
    normal, tangential = found.standing.contact_forces
    np.testing.assert_allclose(normal.T, np.tile(equal.forces.normal, (3, 1)), rtol=1e-7)
    np.testing.assert_allclose(
        np.abs(tangential.T), np.tile(np.abs(equal.forces.tangential), (3, 1)), rtol=1e-7
    )
    assert found.stiffness == pytest.approx(float(equal.assembly.stiffness.output), rel=1e-7)
    assert found.turning.drift_per_output_turn == pytest.approx(
        float(equal.rolling.drift_per_output_turn), rel=1e-7
    )


@pytest.mark.slow
def test_unlike_branches_are_pressed_as_by_a_larger_interference(branches):
    """Without a cam the same sizes have the same forces under the interference that makes the same mean preload.

    To 1e-4, because the laws of contacts under an interference are taken around the preload that its work makes.
    """
    deviations = [3e-6, 0.0, -2e-6]
    pressed, equal = branches(deviations)
    goal = pressed.preload.mean() + CAM * TORQUE

    def mean_and_branches(interference):
        found, _ = branches(deviations, interference=interference, cam=None)
        return found.preload.mean(), found

    ends = [float(equal.interference) * factor for factor in (0.99, 1.01)]
    means = [mean_and_branches(end)[0] for end in ends]
    for _ in range(3):  # by secants
        slope = (means[-1] - means[-2]) / (ends[-1] - ends[-2])
        ends.append(ends[-1] + (goal - means[-1]) / slope)
        mean, without_cam = mean_and_branches(ends[-1])
        means.append(mean)
    assert means[-1] == pytest.approx(goal, rel=1e-9)
    for name in ("standing", "rolling"):
        one, other = (getattr(each, name) for each in (pressed, without_cam))
        np.testing.assert_allclose(one.contact_forces, other.contact_forces, rtol=1e-4)
        np.testing.assert_allclose(one.torque, other.torque, rtol=1e-4)
    assert pressed.turning.drift_per_output_turn == pytest.approx(
        without_cam.turning.drift_per_output_turn, rel=1e-4
    )
    assert pressed.stiffness < 0.9 * without_cam.stiffness  # the cam turns

"""A loading cam that presses branches of unlike sizes."""

import dataclasses

import numpy as np
import pytest

from asperity.branches.branches import SectorDeviations, assembled_branches
from asperity.branches.results import unequal_branches
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
        assembled = assembled_branches(joint, sizes_of(deviations))
        solution = solve_joint(assembled.joint)
        return unequal_branches(assembled, solution.states), solution.result, joint

    return of


@pytest.mark.long
@pytest.mark.parametrize("torque", [TORQUE, -TORQUE])
def test_equal_branches_are_those_without_sizes(branches, torque):
    found, result, joint = branches([0.0, 0.0, 0.0], torque=torque)
    equal = solve_joint(joint).result
    np.testing.assert_allclose(found.preload, float(equal.rest.normal[0]), rtol=1e-8)
    for name in ("normal", "tangential"):
        np.testing.assert_allclose(
            getattr(result.forces, name), np.tile(getattr(equal.forces, name), 3), rtol=1e-7
        )
    for of in (
        lambda each: each.assembly.stiffness.output,
        lambda each: each.rolling.drift_per_output_turn,
        lambda each: each.preload,
    ):
        assert float(of(result)) == pytest.approx(float(of(equal)), rel=1e-7)


@pytest.mark.slow
def test_unlike_branches_are_pressed_as_by_a_larger_interference(branches):
    """Without a cam the same sizes have the same forces under the interference that makes the same mean preload.

    To 1e-4, because the laws of contacts under an interference are taken around the preload that its work makes.
    """
    deviations = [3e-6, 0.0, -2e-6]
    pressed, with_cam, _ = branches(deviations)
    goal = pressed.preload.mean() + CAM * TORQUE

    def mean_and_branches(interference):
        found, result, _ = branches(deviations, interference=interference, cam=None)
        return found.preload.mean(), found, result

    ends = [float(with_cam.interference) * factor for factor in (0.99, 1.01)]
    means = [mean_and_branches(end)[0] for end in ends]
    for _ in range(3):  # by secants
        slope = (means[-1] - means[-2]) / (ends[-1] - ends[-2])
        ends.append(ends[-1] + (goal - means[-1]) / slope)
        mean, without_cam, result = mean_and_branches(ends[-1])
        means.append(mean)
    assert means[-1] == pytest.approx(goal, rel=1e-9)
    for name in ("standing", "rolling"):
        one, other = (getattr(each, name) for each in (pressed, without_cam))
        np.testing.assert_allclose(one.torque, other.torque, rtol=1e-4)
    for of in (
        lambda each: each.forces.normal,
        lambda each: each.forces.tangential,
        lambda each: each.rolling.normal,
        lambda each: each.rolling.drift_per_output_turn,
    ):
        np.testing.assert_allclose(of(with_cam), of(result), rtol=1e-4)
    # the cam turns
    assert float(with_cam.assembly.stiffness.output) < 0.9 * float(result.assembly.stiffness.output)

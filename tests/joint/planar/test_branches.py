"""Sectors of their own sizes: equal ones are the joint, and the paper's drive by its own solver."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.branch_sizes import BranchSizes, SectorDeviations
from asperity.joint.branches import BranchedJoint
from asperity.joint.planar.branches import BranchedPlanarJoint
from asperity.joint.planar.solve import solve_planar
from asperity.joint_file.planar_build import deviations_of
from asperity.joint_file.si_tables import si_values

SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'ring_support = "free" ': 'ring_support = "rigid_housing" ',
}


def sized(name, per_size, errors, support=math.inf):
    errors = np.asarray(errors, dtype=float)
    return SectorDeviations({name: errors}, np.outer(errors, per_size), np.asarray(per_size), support)


def planets(errors, support=math.inf):
    return sized("planet", [1.0, 1.0], errors, support)


@pytest.fixture(scope="module")
def branched(planar_joint):
    joint = planar_joint("planetary", SPRINGS)
    return BranchedPlanarJoint(joint, solve_planar(joint))


@pytest.mark.slow
def test_equal_sectors_are_the_joint(branched):
    found = branched.branches(planets(np.zeros(3)))
    solution = branched.solution
    result = solution.result
    np.testing.assert_allclose(found.preload, float(result.preload), rtol=1e-12)
    assert found.stiffness == pytest.approx(float(result.assembly.stiffness.output), rel=1e-12)
    for state, slip in (
        (found.standing, result.diagnostics.slip_ratio),
        (found.rolling, result.rolling.slip_ratio),
    ):
        np.testing.assert_allclose(state.share, 1.0 / 3.0, rtol=1e-12)
        np.testing.assert_allclose(state.slip_ratio, np.max(slip), rtol=1e-12)
        for force in (state.sun_force, *state.centre_forces.values()):
            np.testing.assert_allclose(force, 0.0, atol=1e-9)
    np.testing.assert_allclose(
        found.rolling.limits["life_hours"], float(result.rolling.life_hours.drive), rtol=1e-12
    )
    pressure = np.asarray(result.diagnostics.pressure_over_first_yield)
    np.testing.assert_allclose(
        found.standing.limits["pressure_over_first_yield"], np.tile(pressure, (3, 1)).T, rtol=1e-12
    )
    # torques to the width of the last step of their searches
    assert found.capacity.first_slip == pytest.approx(float(solution.first_slip.output_torque), rel=1e-9)
    assert found.capacity.all_slip == pytest.approx(float(solution.capacity.output_torque), rel=1e-9)
    assert found.rolling_capacity.first_slip == pytest.approx(
        float(solution.rolling_capacity.output_torque), rel=1e-9
    )


@pytest.mark.slow
def test_what_unequal_planets_do(branched):
    found = branched.branches(planets([2e-6, 0.0, -2e-6]))
    # a planet grows into the sun and into the ring
    np.testing.assert_allclose(found.interference, 30e-6 + 2.0 * np.array([2e-6, 0.0, -2e-6]), rtol=1e-9)
    assert found.preload[0] > found.preload[1] > found.preload[2]
    assert (found.capacity.branch, found.capacity.contact_name) == (2, "sp")
    assert found.capacity.first_slip < found.capacity.all_slip
    assert math.isnan(found.rolling_capacity.all_slip)
    for state in (found.rest, found.standing, found.rolling):
        # nothing acts from outside: what the bearings of sun, ring and carrier bear adds up to nothing
        total = state.sun_force + sum(state.centre_forces.values())
        np.testing.assert_allclose(total, 0.0, atol=1e-8)
        assert np.hypot(*state.sun_force) > 10.0
    assert found.standing.torque.sum() == pytest.approx(10.0, rel=1e-12)
    # the sun is pushed away from the largest planet
    assert found.rest.sun_force[0] < 0.0
    backwards = branched.branches(planets([2e-6, 0.0, -2e-6]).with_first(-2e-6))
    np.testing.assert_allclose(backwards.interference, 30e-6 + 2.0 * np.array([0.0, 0.0, -2e-6]), rtol=1e-9)


@pytest.mark.slow
def test_sizes_that_cannot_be_compared_are_refused(branched, planar_joint):
    with pytest.raises(InputError, match="3 planets, got the sizes of 2"):
        branched.branches(planets([0.0, 0.0]))
    with pytest.raises(InputError, match=r"planet 3 is loose: its sizes leave an interference of -2 .m"):
        branched.branches(planets([0.0, 0.0, -16e-6]))
    with pytest.raises(InputError, match="the drive is loose"):
        branched.branches(planets([-16e-6, -16e-6, -16e-6]))
    by_force = planar_joint("planetary", {'interference = "30 um"  ': 'preload = "1000 N"  '})
    with pytest.raises(InputError, match=r"give load\.interference"):
        BranchedPlanarJoint(by_force, branched.solution)


@pytest.fixture(scope="module")
def papers(paper_joint, as_planar):
    """The paper's joint by its own solver of branches, and unfolded."""
    joint = dataclasses.replace(
        paper_joint(ring_wall_thickness=60e-3), body_model="springs", ring_support=None
    )
    general = dataclasses.replace(as_planar(joint), preload=None, interference=12.904e-6)
    return BranchedJoint(joint, 12.904e-6), BranchedPlanarJoint(general, solve_planar(general))


@pytest.mark.long
@pytest.mark.parametrize("support", [math.inf, 5e7])
def test_the_papers_drive_agrees_with_its_own_solver_of_branches(papers, support):
    """One planet 5 um too large and one too small: 1854, 1000 and 218 N with the sun held, computed independently."""
    own, general = papers
    errors = np.array([5e-6, 0.0, -5e-6])
    expected = own.branches(BranchSizes(errors, np.zeros(3), np.zeros(3), support))
    found = general.branches(sized("planet", [1.0, 1.0, 1.0, 0.0, 0.0], errors, support))
    if math.isinf(support):
        np.testing.assert_allclose(found.preload, [1854.0, 1000.0, 218.0], atol=1.0)
    np.testing.assert_allclose(found.interference, expected.interference, rtol=1e-5)
    np.testing.assert_allclose(found.preload, expected.preload, rtol=1e-4)
    for state, other in ((found.rest, expected.rest), (found.rolling, expected.rolling)):
        np.testing.assert_allclose(state.sun_force, other.sun_force, rtol=2e-4, atol=0.1)
        np.testing.assert_allclose(state.sun_displacement, other.sun_displacement, rtol=2e-4, atol=1e-11)
    np.testing.assert_allclose(found.rolling.share, expected.rolling.share, rtol=5e-4)
    np.testing.assert_allclose(found.rolling.slip_ratio, expected.rolling.slip_ratio, rtol=5e-4)
    # standing, the paper's closure shares the traction of a planet equally between its rollers, the springs do not
    np.testing.assert_allclose(found.standing.share, expected.standing.share, rtol=0.012)
    assert found.capacity.all_slip == pytest.approx(expected.capacity.all_slip, rel=1e-3)
    assert found.rolling_capacity.first_slip == pytest.approx(expected.rolling_capacity.first_slip, rel=0.01)


@pytest.mark.long
@pytest.mark.parametrize("name", ["multiroller", "stepped_planet"])
def test_equal_sectors_of_other_drives(planar_joint, planar_case, name):
    joint = planar_joint(name)
    solution = solve_planar(joint)
    found = BranchedPlanarJoint(joint, solution).branches(deviations_of(si_values(planar_case(name))))
    result = solution.result
    np.testing.assert_allclose(found.preload, float(result.preload), rtol=1e-12)
    assert found.stiffness == pytest.approx(float(result.assembly.stiffness.output), rel=1e-11)
    np.testing.assert_allclose(found.rolling.slip_ratio, np.max(result.rolling.slip_ratio), rtol=1e-11)
    np.testing.assert_allclose(
        found.rolling.limits["life_hours"], float(result.rolling.life_hours.drive), rtol=1e-11
    )
    assert found.capacity.all_slip == pytest.approx(float(solution.capacity.output_torque), rel=1e-9)

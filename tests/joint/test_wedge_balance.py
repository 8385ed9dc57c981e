"""The paper's drive, listed as bodies and contacts, satisfies the paper's equations (1) to (5) and their closure."""

import dataclasses

import numpy as np
import pytest

from asperity.drive.bearings import Bearings, leading_sense
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.joint.contacts import closure_springs
from asperity.joint.description import body_masses, joint_contacts
from asperity.joint.evaluation import evaluate
from asperity.joint.solve import solve_joint
from asperity.results.windup_document import examined_windup, windup_onsets
from asperity.zou2025.branch import branch_forces, carrier_residual
from asperity.zou2025.force_balance import closure_misfit, loaded_branch
from asperity.zou2025.kinematics import carrier_speed
from asperity.zou2025.mechanism import Mechanism, rest_state
from asperity.zou2025.published import NO_FRICTION

pytestmark = pytest.mark.slow

GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
BEARINGS = Bearings(
    input_torque=0.004,
    roller_torque=0.003,
    output_torque=0.02,
    pin_friction_coefficient=0.05,
    pin_friction_diameter=4e-3,
)


def solved(joint):
    numbers = as_numbers(joint)
    return at_once(evaluate, numbers)


def mechanism(joint):
    """The paper's statics of the joint; the friction of its bearings opposes the rotation."""
    sides = triangle(GEOMETRY)
    rest = rest_state(geometry=GEOMETRY, sides=sides, preload=joint.preload)
    own = NO_FRICTION if joint.bearings is None else joint.bearings
    against = leading_sense(rotation=joint.input_speed, output_torque=joint.output_torque)
    masses = dict(zip((body.name for body in joint.drive.bodies), body_masses(joint), strict=True))
    return Mechanism(
        geometry=GEOMETRY,
        sides=sides,
        rest=rest,
        bearings=Bearings(
            against * own.input_torque,
            against * own.roller_torque,
            against * own.output_torque,
            against * own.pin_friction_coefficient,
            own.pin_friction_diameter,
        ),
        springs=closure_springs(
            contacts=joint_contacts(joint), rest_force=rest.normal_force, model=joint.closure_springs
        ),
        preload=joint.preload,
        carrier_speed=carrier_speed(geometry=GEOMETRY, sun_speed=joint.input_speed),
        planet_mass=masses["planet"],
        loading_roller_mass=masses["left_loading_roller"],
        closure="elastic",
    )


@pytest.fixture(scope="module")
def listed(paper_joint):
    """The paper's joint, whose rollers share the traction by their springs."""
    return lambda **changes: paper_joint(ring_wall_thickness=60e-3, traction_split="springs", **changes)


def balanced(joint, normal, tangential):
    """Forces by the published equations from two sums of a state and its split, and what they leave over [N]."""
    branch = loaded_branch(mechanism=mechanism(joint), output_torque=joint.output_torque)
    force = branch_forces(branch, normal[1] + normal[2], tangential[0], tangential[1])
    return force, float(closure_misfit(branch, force)), float(carrier_residual(branch, force))


@pytest.mark.parametrize("springs", ["bulk", pytest.param("bulk_and_asperities", marks=pytest.mark.long)])
def test_forces_close_as_in_the_paper(listed, springs):
    """With exact bodies in the assembly: those of the closure are springs, around the same forces at rest."""
    joint = listed(closure_springs=springs)
    found = solved(joint)
    assert bool(found.solved)
    np.testing.assert_allclose(found.rest.normal[0], 1000.0, rtol=1e-12)
    for state in (found.forces, found.rolling):
        force, misfit, moment = balanced(joint, state.normal, state.tangential)
        np.testing.assert_allclose(state.normal, np.ravel(force.normal), rtol=1e-12)
        np.testing.assert_allclose(state.tangential, np.ravel(force.tangential), rtol=1e-12)
        assert abs(misfit) < 1e-8
        assert abs(moment) < 1e-10


@pytest.mark.long
@pytest.mark.parametrize(("torque", "speed"), [(5.0, 628.0), (-4.0, 628.0), (4.0, -300.0), (-3.0, 0.0)])
def test_bearings_brake_the_drive_that_stands(listed, torque, speed):
    """Constant friction, and that of pins in proportion to their force, against either sense of rotation."""
    joint = dataclasses.replace(
        listed(output_torque=torque, sun_speed=speed), bearings=BEARINGS, carrier_balance="printed"
    )
    found = solved(joint)
    assert bool(found.solved)
    forces = found.forces
    for state in (forces, found.rolling):
        force, misfit, moment = balanced(joint, state.normal, state.tangential)
        np.testing.assert_allclose(state.normal, np.ravel(force.normal), rtol=1e-11)
        np.testing.assert_allclose(state.tangential, np.ravel(force.tangential), rtol=1e-11)
        assert abs(misfit) < 1e-8
        assert abs(moment) < 1e-9
    sense = -1.0 if speed < 0.0 or (speed == 0.0 and torque < 0.0) else 1.0
    entered = 3 * 4e-3 * forces.tangential[0] + 2.0 * sense * 0.004  # equation (1)
    assert float(forces.input_torque) == pytest.approx(float(entered), rel=1e-12)


@pytest.mark.parametrize("torque", [5.0, -5.0])
def test_a_drive_that_turns_backwards_mirrors_its_speeds(listed, torque):
    """Under the same torque: a torque that resists one sense drives the other."""
    one, other = (solved(listed(output_torque=torque, sun_speed=speed)).rolling for speed in (300.0, -300.0))
    assert float(other.speed_loss) == pytest.approx(-float(one.speed_loss), rel=3e-3)  # creep shifts speeds
    np.testing.assert_allclose(other.tangential, one.tangential, rtol=1e-3)
    # what one puts in the other gets out, but for the losses of both
    assert float(np.sum(other.power.creep)) == pytest.approx(float(np.sum(one.power.creep)), rel=1e-2)
    one_in, other_in = (float(each.power.input - each.power.output) for each in (one, other))
    assert other_in == pytest.approx(one_in, rel=1e-2)
    assert one_in > 0.0


@pytest.mark.long
def test_an_interference_makes_the_preload_that_makes_it(listed):
    joint = listed(output_torque=3.0)
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


@pytest.mark.long
def test_a_torque_and_a_rotation_the_other_way_round_are_the_mirror_image(listed):
    """Of a drive whose two sides are alike, bearing friction included; the capacities too."""
    joint = dataclasses.replace(
        listed(), bearings=BEARINGS, pin_transverse_stiffness=3e7, closure_springs=None
    )
    one = solve_joint(joint)
    other = solve_joint(
        dataclasses.replace(joint, output_torque=-joint.output_torque, input_speed=-joint.input_speed)
    )
    swapped = np.array([0, 2, 1, 4, 3])
    for state in ("forces", "rolling"):
        mine, image = getattr(one.result, state), getattr(other.result, state)
        np.testing.assert_allclose(image.normal[swapped], mine.normal, rtol=1e-10)
        np.testing.assert_allclose(-image.tangential[swapped], mine.tangential, rtol=1e-10)
    assert float(other.result.forces.input_torque) == pytest.approx(-float(one.result.forces.input_torque))
    assert float(other.result.rolling.speed_loss) == pytest.approx(float(one.result.rolling.speed_loss))
    assert float(other.result.rolling.power.loss) == pytest.approx(float(one.result.rolling.power.loss))
    for name in ("standing_capacity", "rolling_capacity", "first_slip"):
        mine, image = getattr(one, name), getattr(other, f"reverse_{name}")
        assert float(image.output_torque) == pytest.approx(float(mine.output_torque), rel=1e-9)


@pytest.mark.long
def test_the_wind_up_of_a_drive_with_alike_sides_is_alike_both_ways(listed):
    joint = dataclasses.replace(listed(), bearings=BEARINGS)
    curve, solutions = examined_windup(joint, largest_torque=None, level="assembly")
    forward, reverse = windup_onsets(joint, curve, solutions, creep_share=0.05)
    assert float(reverse.static_angle) == pytest.approx(float(forward.static_angle), rel=1e-6)
    np.testing.assert_allclose(
        reverse.contacts.share[np.array([0, 2, 1, 4, 3])], forward.contacts.share, rtol=1e-6
    )

"""Joint files of every type of planar drive."""

import math

import pytest

from asperity.drive.planar.drives import wedge_drive
from asperity.joint.crowned_contacts import crown_curvatures
from asperity.joint.planar.body_shape import SOLID, BodyShape
from asperity.joint.planar.description import PlanarJoint
from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.solved_document import solve_case


@pytest.fixture(scope="session")
def planar_joint(planar_case):
    """Joint of an example, with replaced pieces of its text."""
    return lambda name, replaced=None: planar_joint_from_case(planar_case(name, replaced=replaced or {}))


@pytest.fixture(scope="session")
def planetary(planar_case):
    """The planetary example: joint, solution and document."""
    solved, document = solve_case(planar_case("planetary"))
    return solved.joint, solved.solution, document


@pytest.fixture(scope="session")
def skewed_planetary(planar_case):
    """The planetary example with springs as bodies and skewed axes: joint, solution and document."""
    replaced = {
        'bodies = "exact"': 'bodies = "springs"',
        'ring_support = "free"': 'ring_support = "rigid_housing"',
        "[lubrication]": '[rolling]\nskew = { sp = "0.5 mrad", pr = "-0.8 mrad" }\n\n[lubrication]',
    }
    solved, document = solve_case(planar_case("planetary", replaced=replaced))
    return solved.joint, solved.solution, document


@pytest.fixture(scope="session")
def as_planar():
    """The paper's joint as bodies, contacts and pins."""

    def described(joint):
        bodies = joint.bodies
        return PlanarJoint(
            type="zou2025",
            drive=wedge_drive(joint.geometry, planet_count=3),
            shapes=(
                SOLID,
                SOLID,
                SOLID,
                SOLID,
                BodyShape("ring", joint.ring_wall_thickness, "rigid_housing"),
            ),
            materials=(bodies.sun, bodies.planet, bodies.loading_roller, bodies.loading_roller, bodies.ring),
            surfaces=joint.surfaces,
            contact_lengths=joint.contact_lengths,
            friction_coefficients=joint.friction_coefficients,
            pattern=(0.0, 0.0, 0.0, 1.0, 1.0),
            preload=joint.preload,
            interference=None,
            output_torque=joint.output_torque,
            input_speed=joint.sun_speed,
            pin_stiffness=math.inf,
            input_shaft_stiffness=math.inf,
            output_shaft_stiffness=math.inf,
            contact_factor_model=joint.contact_factor_model,
            body_model=joint.body_model,
            plane_state=joint.plane_state,
            rolling=joint.rolling,
            crown_curvatures=None if joint.crowns is None else tuple(crown_curvatures(joint.crowns)),
            closure_springs=joint.closure_springs,
        )

    return described

"""The published model of the paper's joint, from its radii to its torsional stiffness, for a million joints at once.

Force balance (1)–(5) with the closure (A3), asperities (6)–(24), stiffness (25)–(30); nothing else: the bodies are
elastic in the closure only. The chain of :mod:`asperity.joint` contains this model as one of its levels, and reproduces
it where a file states ``model.traction_split = "equal_coefficients"``.
"""

from __future__ import annotations

import math

from asperity.contact.laws.zou_2025 import Zou2025
from asperity.contact.roller_pairs import roller_pairs
from asperity.drive.bearings import Bearings
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.drive.stiffness.torsional_stiffness import TorsionalStiffness, contact_torsional_stiffness
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.joint.contacts import JointContacts, bulk_springs, rough_joint_contacts
from asperity.materials import Material, pair
from asperity.types import Array, Real
from asperity.zou2025.force_balance import BALANCE_TOLERANCE, DriveForces, force_balance
from asperity.zou2025.kinematics import carrier_speed, contact_radii
from asperity.zou2025.mechanism import Mechanism, rest_state
from asperity.zou2025.series_stiffness import driven_radii, series_torsional_stiffness

NO_FRICTION = Bearings(
    input_torque=0.0,
    roller_torque=0.0,
    output_torque=0.0,
    pin_friction_coefficient=0.0,
    pin_friction_diameter=0.0,
)


class PublishedJoint(Module):
    """The numbers of the published model. SI units; they broadcast over trailing batch axes.

    One material of all bodies, one roughness, length B [m] and mu [-] of all contacts; the rollers are as long.
    ``ring_wall_thickness``: wall of the outer ring, which compresses with it in the closure [m]; ``preload``: normal
    force N_0 between sun and planet at rest [N]; torque at the carrier [N·m]; angular velocity of the sun [rad/s].
    """

    geometry: DriveGeometry
    material: Material
    surface: Zou2025
    contact_length: Real
    friction_coefficient: Real
    ring_wall_thickness: Real
    preload: Real
    output_torque: Real
    sun_speed: Real


class PublishedResult(Module):
    """What the published model says. SI units; contact axis first.

    Forces of one branch; K_t of each contact [N/m], and its K_T at its driven roller [N·m/rad], shape (5, ...);
    stiffness of the joint, equation (25); and whether balance and closure hold.
    """

    forces: DriveForces
    tangential_stiffness: Array
    contact_torsional_stiffness: Array
    stiffness: TorsionalStiffness
    solved: Array


def _with_one_rank(joint: PublishedJoint) -> PublishedJoint:
    """The same joint, every number with the rank of the batch: contact and batch axes never meet in broadcasting."""
    rank = max(xp.ndim(leaf) for leaf in trees.leaves(joint))
    return trees.map(lambda leaf: xp.reshape(leaf, (1,) * (rank - xp.ndim(leaf)) + xp.shape(leaf)), joint)


def published_joint(joint: PublishedJoint) -> PublishedResult:
    r"""Forces and torsional stiffness of the published model; pure."""
    joint = _with_one_rank(joint)
    geometry, material = joint.geometry, joint.material
    sides = triangle(geometry)
    radius_1, radius_2, sign = contact_radii(geometry)
    contacts = JointContacts(
        pairs=roller_pairs(
            radius_1=radius_1,
            radius_2=radius_2,
            sign=sign,
            contact_length=joint.contact_length,
            friction_coefficient=joint.friction_coefficient,
            moduli=pair(material, material),
            surface=joint.surface,
        ),
        driving=material,
        driven=material,
        ring_wall_thickness=joint.ring_wall_thickness,
        contact_factor_model="printed",
    )
    rest = rest_state(geometry=geometry, sides=sides, preload=joint.preload)
    planet, roller = (
        material.density * math.pi * radius**2 * joint.contact_length
        for radius in (geometry.planet_radius, geometry.loading_roller_radius)
    )
    drive = Mechanism(
        geometry=geometry,
        sides=sides,
        rest=rest,
        bearings=NO_FRICTION,
        springs=bulk_springs(contacts=contacts, half_width=contacts.pairs.half_width(rest.normal_force)),
        preload=joint.preload,
        carrier_speed=carrier_speed(geometry=geometry, sun_speed=joint.sun_speed),
        planet_mass=planet,
        loading_roller_mass=roller,
        closure="elastic",
    )
    forces = force_balance(mechanism=drive, output_torque=joint.output_torque)
    rough = rough_joint_contacts(
        contacts=contacts, normal_force=forces.normal, tangential_force=forces.tangential
    )
    holds = xp.all((rough.normal_stiffness > 0.0) | (forces.normal <= 0.0), axis=0)
    series = series_torsional_stiffness(geometry=geometry, tangential_stiffness=rough.tangential_stiffness)
    return PublishedResult(
        forces=forces,
        tangential_stiffness=rough.tangential_stiffness,
        contact_torsional_stiffness=xp.asarray(
            contact_torsional_stiffness(
                tangential_stiffness=rough.tangential_stiffness, radius=driven_radii(geometry)
            )
        ),
        stiffness=TorsionalStiffness(
            input=xp.where(holds, series.input, xp.nan), output=xp.where(holds, series.output, xp.nan)
        ),
        solved=(forces.balance_residual < BALANCE_TOLERANCE) & (forces.closure_residual < BALANCE_TOLERANCE),
    )

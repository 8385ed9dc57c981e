"""The whole chain in one readable function: a joint in, its forces, contacts and torsional stiffness out."""

from __future__ import annotations

import dataclasses

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.contact.fractal import FractalContact
from asperity.contact.interface import Interface
from asperity.drive.assembly import Assembly, assembly_stiffness
from asperity.drive.force_balance import BALANCE_TOLERANCE, DriveForces, force_balance
from asperity.drive.geometry import CONTACT_NAMES, DriveAngles, angles, carrier_speed, speed_ratio, triangle
from asperity.drive.interference import interference
from asperity.drive.mechanism import Mechanism, opposed, rest_state
from asperity.drive.rolling_speeds import WEDGE_DRIVE
from asperity.drive.torsional_stiffness import (
    TorsionalStiffness,
    contact_torsional_stiffness,
    driven_radii,
    series_torsional_stiffness,
)
from asperity.joint.contacts import (
    JointContacts,
    closure_springs,
    joint_contacts,
    loaded_contacts,
    rough_joint_contacts,
)
from asperity.joint.description import Bodies, Joint, preload_at, sense_of_rotation, with_one_rank
from asperity.joint.diagnostics import Diagnostics, diagnose, self_locking_ratio
from asperity.joint.duty import with_duty_life
from asperity.joint.elastic_bodies import assembly_springs, walls_hold
from asperity.joint.interference import joint_rest_compliance
from asperity.joint.loading_cam import followed_by_cam
from asperity.joint.masses import loading_roller_mass, planet_mass
from asperity.joint.rolling import RollingResult, rolling_result
from asperity.types import Real

__all__ = ["Bodies", "Joint", "JointResult", "evaluate", "mechanism"]


class StandingResult(eqx.Module):
    """What the chain says about a joint at rest. SI units; contact arrays have the contact axis first.

    Parameters
    ----------
    angles : DriveAngles
        alpha, theta and the wedge angle [rad].
    speed_ratio : Real
        Sun over carrier speed [-].
    output_speed : Real
        Angular velocity of the output, the carrier [rad/s].
    planet_mass, loading_roller_mass : Real
        Masses of one planet and of one loading roller [kg].
    forces : DriveForces
        Contact and pin forces, torques and the residuals of the balance.
    contacts : FractalContact
        Spots and stiffnesses of the five contacts, shape (5, ...).
    contact_torsional_stiffness : Array
        Each contact's own K_T at its driven roller, shape (5, ...) [N·m/rad].
    interfaces : Interface
        Stiffness of asperities and of bulk at the five contacts, shape (5, ...) [N/m].
    published : TorsionalStiffness
        Torsional stiffness as published: the asperities' tangential springs alone, an upper bound.
    series_with_bulk : TorsionalStiffness
        The same series (25) with asperities and bulk in every contact.
    assembly : Assembly
        The fullest model: asperities and bulk, floating planet, pins, ring and shafts, with its compliance budget.
    interference : Array
        Interference that makes the preload: by how much the ring is too small for its rollers [m].
    cam_angle : Array
        Angle at the output by which a loading cam has turned, without sign [rad]; 0 without one.
    diagnostics : Diagnostics
        Limits of the model and how close this joint is to each.
    contact_law_holds : Array
        Whether every loaded contact has an elastic spot. Where all are plastic the contact law has no stiffness, which
        is wrong: the three levels are then nan.
    walls_hold : Array
        Whether ring and hollow rollers have walls for which their exact compliance is known, and crowned contacts are
        long enough for the law of their slices.
    solved : Array
        True where the balance closed to :data:`BALANCE_TOLERANCE`.
    """

    angles: DriveAngles
    speed_ratio: Real
    output_speed: Real
    planet_mass: Real
    loading_roller_mass: Real
    forces: DriveForces
    contacts: FractalContact
    contact_torsional_stiffness: Real
    interfaces: Interface
    published: TorsionalStiffness
    series_with_bulk: TorsionalStiffness
    assembly: Assembly
    interference: Array
    cam_angle: Array
    diagnostics: Diagnostics
    contact_law_holds: Array
    walls_hold: Array
    solved: Array


class JointResult(StandingResult):
    """Everything the chain says about a joint.

    Parameters
    ----------
    rolling : RollingResult
        The joint that turns: creep, drift, axial forces, losses, life; its forces differ a little from those at rest.
    """

    rolling: RollingResult

    @property
    def contact_names(self) -> tuple[str, ...]:
        """Names of the contacts, in the order of their axis."""
        return CONTACT_NAMES

    @property
    def body_names(self) -> tuple[str, ...]:
        """Names of the bodies of a branch, in the order of their axis."""
        return WEDGE_DRIVE.names

    def contact(self, name: str) -> dict[str, Array]:
        """All quantities of one contact by name, for reading by eye.

        Parameters
        ----------
        name : {"sp", "pwr", "pwl", "wro", "wlo"}
            Which contact.

        Returns
        -------
        dict
            Name of the quantity → its value, SI.
        """
        index = CONTACT_NAMES.index(name)
        values = {key: value[index] for key, value in vars(self.contacts).items()}
        return {
            "normal_force": self.forces.normal[index],
            "tangential_force": self.forces.tangential[index],
            **values,
            "torsional_stiffness": jnp.asarray(self.contact_torsional_stiffness)[index],
        }


def mechanism(joint: Joint) -> Mechanism:
    """The joint's drive with its masses, springs and speed, ready for the force balance.

    Parameters
    ----------
    joint : Joint
        The joint.

    Returns
    -------
    Mechanism
        Input of :func:`asperity.drive.force_balance.force_balance`.
    """
    return _mechanism(joint, joint_contacts(joint))


def drive_under(joint: Joint, drive: Mechanism, output_torque: Real) -> Mechanism:
    """The drive of a joint under a torque.

    Parameters
    ----------
    joint : Joint
        The joint.
    drive : Mechanism
        Its drive under a torque of the same sign.
    output_torque : Real
        Torque at the carrier [N·m].

    Returns
    -------
    Mechanism
        The same drive, pressed as much as its loading cam presses it under this torque.
    """
    if joint.cam_force_per_torque is None:
        return drive
    return mechanism(dataclasses.replace(joint, output_torque=output_torque))


def _mechanism(joint: Joint, contacts: JointContacts) -> Mechanism:
    geometry = joint.geometry
    sides = triangle(geometry)
    preload = preload_at(joint, joint.output_torque)
    rest = rest_state(geometry=geometry, sides=sides, preload=preload)
    return Mechanism(
        geometry=geometry,
        sides=sides,
        rest=rest,
        bearings=opposed(bearings=joint.bearings, sense_of_rotation=sense_of_rotation(joint)),
        springs=closure_springs(contacts=contacts, rest_force=rest.normal_force, model=joint.closure_springs),
        preload=preload,
        carrier_speed=carrier_speed(geometry=geometry, sun_speed=joint.sun_speed),
        planet_mass=planet_mass(joint),
        loading_roller_mass=loading_roller_mass(joint),
        closure=joint.closure,
    )


def evaluate(joint: Joint) -> JointResult:
    """The chain itself: pure, for ``jit``, ``vmap`` and ``grad``; never raises.

    Geometry and contacts first, then forces, springs, stiffness and diagnostics, each derived once. Points without a
    solution carry ``solved = False`` and must be looked at by the caller; :func:`asperity.joint.solve.solve` does that.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.

    Returns
    -------
    JointResult
        Everything, in the broadcast shape.
    """
    standing, contacts, drive = standing_joint(joint)
    return JointResult(**vars(standing), rolling=rolling_joint(joint, standing, contacts, drive))


def standing_joint(joint: Joint) -> tuple[StandingResult, JointContacts, Mechanism]:
    """The first part of the chain: the joint at rest under its torque.

    Parameters
    ----------
    joint : Joint
        As of :func:`evaluate`.

    Returns
    -------
    StandingResult, JointContacts, Mechanism
        What it does at rest; its contacts and its drive for :func:`rolling_joint`.
    """
    joint = with_one_rank(joint)
    geometry = joint.geometry
    contacts = joint_contacts(joint)
    drive = _mechanism(joint, contacts)
    forces = force_balance(mechanism=drive, output_torque=joint.output_torque)
    loaded = loaded_contacts(
        contacts=contacts, normal_force=forces.normal, tangential_force=forces.tangential
    )
    rough, whole = loaded.rough.tangential_stiffness, jnp.asarray(loaded.interfaces.tangential)
    published = series_torsional_stiffness(geometry=geometry, tangential_stiffness=rough)
    series = series_torsional_stiffness(geometry=geometry, tangential_stiffness=whole)
    springs = assembly_springs(joint=joint, sides=drive.sides, contacts=contacts, loaded=loaded)
    assembly = assembly_stiffness(
        geometry=geometry,
        sides=drive.sides,
        normal_stiffness=springs.normal_stiffness,
        tangential_stiffness=springs.tangential_stiffness,
        structure=joint.structure,
        coupling=springs.coupling,
    )
    rest_compliance = joint_rest_compliance(
        joint=dataclasses.replace(joint, preload=drive.preload),
        contacts=contacts,
        rest=drive.rest,
        springs=springs,
    )
    turned, assembly = followed_by_cam(
        joint=joint, drive=drive, compliance=rest_compliance, assembly=assembly
    )
    law_holds = jnp.all((loaded.rough.normal_stiffness > 0.0) | (forces.normal <= 0.0), axis=0)
    walls = walls_hold(joint, loaded.half_width)
    if loaded.lines is not None:
        walls = walls & jnp.all(loaded.lines.solved | (forces.normal <= 0.0), axis=0)
    published, series = jax.tree.map(lambda value: jnp.where(law_holds, value, jnp.nan), (published, series))
    assembly = jax.tree.map(lambda value: jnp.where(law_holds & walls, value, jnp.nan), assembly)
    result = StandingResult(
        angles=angles(drive.sides),
        speed_ratio=speed_ratio(geometry),
        output_speed=drive.carrier_speed,
        planet_mass=drive.planet_mass,
        loading_roller_mass=drive.loading_roller_mass,
        forces=forces,
        contacts=loaded.rough,
        contact_torsional_stiffness=contact_torsional_stiffness(
            tangential_stiffness=rough, radius=driven_radii(geometry)
        ),
        interfaces=loaded.interfaces,
        published=published,
        series_with_bulk=series,
        assembly=assembly,
        interference=interference(compliance=rest_compliance, preload=drive.preload),
        cam_angle=turned,
        diagnostics=diagnose(
            pairs=contacts.pairs,
            normal_force=forces.normal,
            tangential_force=forces.tangential,
            loaded=loaded,
            rest_force=drive.rest.normal_force,
            self_locking_ratio=self_locking_ratio(
                sides=drive.sides, friction_coefficient=contacts.pairs.friction_coefficient
            ),
        ),
        contact_law_holds=law_holds,
        walls_hold=walls,
        solved=(forces.balance_residual < BALANCE_TOLERANCE) & (forces.closure_residual < BALANCE_TOLERANCE),
    )
    return result, contacts, drive


def rolling_joint(
    joint: Joint, standing: StandingResult, contacts: JointContacts, drive: Mechanism
) -> RollingResult:
    """The second part of the chain: the joint that turns, with its life under the duty if it has one.

    Parameters
    ----------
    joint : Joint
        As of :func:`evaluate`.
    standing, contacts, drive
        Of :func:`standing_joint`.

    Returns
    -------
    RollingResult
        Creep, drift, axial forces, losses and life.
    """
    joint = with_one_rank(joint)
    found = rolling_result(
        joint=joint,
        contacts=contacts,
        mechanism=drive,
        forces=standing.forces,
        asperity_normal_stiffness=standing.contacts.normal_stiffness,
    )

    def rolled(torque: Array, speed: Array) -> RollingResult:
        loaded = dataclasses.replace(joint, output_torque=torque, sun_speed=speed)
        turning = _mechanism(loaded, contacts)
        balanced = force_balance(mechanism=turning, output_torque=torque)
        rough = rough_joint_contacts(
            contacts=contacts,
            normal_force=balanced.normal,
            tangential_force=jnp.zeros_like(balanced.tangential),
        )
        return rolling_result(
            joint=loaded,
            contacts=contacts,
            mechanism=turning,
            forces=balanced,
            asperity_normal_stiffness=rough.normal_stiffness,
        )

    return with_duty_life(
        found,
        conditions=joint.rolling,
        bodies=WEDGE_DRIVE,
        planet_count=joint.geometry.planet_count,
        rolled=rolled,
    )

"""A joint: the input of its chain, as frozen modules. SI units."""

from __future__ import annotations

import dataclasses
from typing import Any, Literal

import numpy as np

from asperity.body.shapes import PlaneState
from asperity.contact.laws.law import ContactLaw
from asperity.contact.population import ContactFactorModel
from asperity.contact.roller_pairs import roller_pairs
from asperity.drive.bearings import Bearings
from asperity.drive.layout.drive import Drive, contact_angles, incidence, speeds
from asperity.drive.state.state import BodiesOfContacts
from asperity.drive.stiffness.loading_cam import LoadingCam
from asperity.drive.structure.axis_tilts import AxisTilts
from asperity.drive.structure.bearing_life import RatedBearing
from asperity.drive.structure.pin_beam import PinBeam
from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.joint.body_shape import BodyShape, Housing
from asperity.joint.contacts import JointContacts, elastic_material
from asperity.joint.fit import BodyModel, ClosureSprings, Fit, per_contact
from asperity.joint.play import NO_PLAY, Play
from asperity.materials import Material, pair
from asperity.rolling.conditions import RollingConditions
from asperity.rolling.heat import HeatBalance
from asperity.types import Array, Real


class WarmerRollers(Module):
    """Rollers that are warmer than rings and housing.

    ``rise`` above these [K]; interference of the rings that a kelvin of it adds [m/K], and of each contact, shape
    (contacts,) [m/K].
    """

    rise: Real
    change_per_kelvin: Real
    contact_change_per_kelvin: Array


class ContactFit(Fit):
    """How a drive was assembled, and what temperature does to each of its contacts.

    To :class:`asperity.joint.fit.Fit`, here with the interference of the rings that does the same work, come the
    interferences that a kelvin adds to each contact, shape (contacts,) [m/K], and what rollers add that are warmer;
    None where all bodies have one temperature.
    """

    contact_change_per_kelvin: Array
    warmer_rollers: WarmerRollers | None = None

    @property
    def thermal_change(self) -> Real:
        """What the working temperatures add to the interference [m]."""
        change, rollers = self.change_per_kelvin * self.temperature_rise, self.warmer_rollers
        return change if rollers is None else change + rollers.change_per_kelvin * rollers.rise

    @property
    def contact_thermal_change(self) -> Array:
        """What they add to that of each contact, shape (contacts,) [m]."""
        change, rollers = self.contact_change_per_kelvin * self.temperature_rise, self.warmer_rollers
        return change if rollers is None else change + rollers.contact_change_per_kelvin * rollers.rise


class UnlikeSectors(Module):
    """What differs between the sectors of an unfolded drive, and the bearings of its floating bodies.

    ``added``, interference that the sizes of its bodies add to each contact [m], and ``reference_force``, normal forces
    without torque around which the laws are taken [N], of shape (contacts,); ``support_stiffness``, radial, of the
    bearings of each floating body, shape (floating,) [N/m]. The contacts of the sectors are listed one sector after the
    other.
    """

    added: Array
    reference_force: Array
    support_stiffness: Array
    sectors: int = static()


class Joint(Module):
    """A joint. SI units; what differs between contacts is a tuple of one entry or one each.

    Parameters
    ----------
    type : str
        Type of the drive, as its joint file says.
    drive : Drive
        Bodies, contacts and pins.
    shapes : tuple of BodyShape
        What each body is, in the order of the drive's bodies.
    materials : tuple of Material
        Of each body.
    surfaces : tuple of ContactLaw
        The law of the asperities with the numbers of the equivalent surface.
    contact_lengths, friction_coefficients : tuple of Real
        Lengths B [m] and friction coefficients mu [-].
    pattern : tuple of Real
        Interference of each contact over that of the drive at the assembly [-].
    preload, interference : Real or None
        Normal force of the first contact without torque [N], or the interference of the drive [m]; one of them.
    output_torque : Real
        Torque at the output, of either sign [N·m]; positive where it resists the rotation.
    input_speed : Real
        Angular velocity of the input, of either sign [rad/s]; the friction of the bearings opposes it, in a drive
        without speed the sense of the torque.
    pin_stiffness : Real or None
        Of one pin along its push [N/m]; ``math.inf`` is rigid. None where nobody states one: pins of a known diameter
        and length bend as beams, others are rigid.
    input_shaft_stiffness, output_shaft_stiffness : Real
        Torsional stiffness of the shafts [N·m/rad].
    contact_factor_model : {"printed", "hertz_area", "unity"}
        Model of lambda.
    body_model : {"exact", "springs"}
        Bodies by plane elasticity, or one spring for each contact.
    plane_state : {"plane_strain", "plane_stress"}
        Of the exact bodies.
    rolling : RollingConditions
        Skew, losses, oil and reliability of the joint that turns.
    bearings : Bearings or None, optional
        Friction of the bearings, at input, rollers on pins and output; None for none.
    play : Play, optional
        Play at the output, part of every torque–angle curve; none by default.
    fit : ContactFit or None, optional
        What temperature adds to the interference; None where the preload does not depend on it.
    pin_bearing, input_bearing, output_bearing : RatedBearing or None, optional
        Rolling bearings of every roller on a pin, of input and of output; None where no life is asked for.
    crown_curvatures : tuple of Real or None, optional
        Curvature of the crowns of both tracks of each contact, the sum of :math:`1/R_c` [1/m]; None where no roller is
        crowned.
    logarithmic_crowns : tuple of bool or None, optional
        Which of these contacts have logarithmic profiles, with this curvature in their middle, in place of circles;
        None where none has.
    unlike : UnlikeSectors or None, optional
        What differs between the sectors of a drive that :mod:`asperity.joint.unfolding` has unfolded; None for
        equal sectors.
    cam : LoadingCam or None, optional
        Loading cam, which adds to the preload in proportion to the torque; None without.
    closure_springs : {"bulk", "bulk_and_asperities"} or None, optional
        Normal springs of the force balance under load, of one roller pair each, between rigid pins: the bodies alone,
        or with the asperities' stiffness at rest in series. None: the springs of the assembly.
    pin : PinBeam or None, optional
        The pins of the carrier as beams; None where their length is not known.
    pin_clearance : Real, optional
        Radial clearance of the pins in the bores of their rollers [m]; 0 where nobody states one.
    pin_clearance_stated : bool, optional
        Whether somebody does.
    pin_transverse_stiffness : Real or None, optional
        Of one pin across its push [N/m]; None where the roller is free to move there.
    planet_support_stiffness : Real or None, optional
        Of the bearing on the carrier of each roller without a pin, in both directions [N/m]; None for floating ones.
    ring_bending_stiffness : Real or None, optional
        Of a spring in series with each contact of a ring [N/m]; None for none.
    pressing_stiffness : Real or None, optional
        Of a spring that presses the contacts, in series with them [N/m]; None where their interference or a force does.
    housing : Housing or None, optional
        Into which the rings are pressed that are not free; None where only its stiffness is known, or nothing.
    heat : HeatBalance or None, optional
        Its steady temperatures, and how they came about; None where its temperature is stated.
    carrier_balance : {"complete", "printed"}, optional
        ``printed``: equation (5) of Zou et al. 2025, which leaves out the friction torques of the rollers' bearings on
        the carrier.
    wear_coefficients : tuple of Real or None, optional
        Of the tracks of each body [1/Pa]; None where nobody states one.
    tilts : AxisTilts or None, optional
        Tilts of its axes, which the loads along its contacts follow, but no force or creep; None for parallel axes.
    """

    type: str = static()
    drive: Drive
    shapes: tuple[BodyShape, ...]
    materials: tuple[Material, ...]
    surfaces: tuple[ContactLaw, ...]
    contact_lengths: tuple[Real, ...]
    friction_coefficients: tuple[Real, ...]
    pattern: tuple[Real, ...]
    preload: Real | None
    interference: Real | None
    output_torque: Real
    input_speed: Real
    pin_stiffness: Real | None
    input_shaft_stiffness: Real
    output_shaft_stiffness: Real
    contact_factor_model: ContactFactorModel = static()
    body_model: BodyModel = static()
    plane_state: PlaneState = static()
    rolling: RollingConditions
    bearings: Bearings | None = None
    play: Play = NO_PLAY
    fit: ContactFit | None = None
    pin_bearing: RatedBearing | None = None
    input_bearing: RatedBearing | None = None
    output_bearing: RatedBearing | None = None
    crown_curvatures: tuple[Real, ...] | None = None
    logarithmic_crowns: tuple[bool, ...] | None = static(default=None)
    unlike: UnlikeSectors | None = None
    cam: LoadingCam | None = None
    closure_springs: ClosureSprings | None = static(default=None)
    pin: PinBeam | None = None
    pin_clearance: Real = 0.0
    pin_clearance_stated: bool = static(default=False)
    pin_transverse_stiffness: Real | None = None
    planet_support_stiffness: Real | None = None
    ring_bending_stiffness: Real | None = None
    pressing_stiffness: Real | None = None
    housing: Housing | None = None
    heat: HeatBalance | None = None
    carrier_balance: Literal["complete", "printed"] = static(default="complete")
    wear_coefficients: tuple[Real, ...] | None = None
    tilts: AxisTilts | None = None

    @property
    def working_pattern(self) -> Array:
        """Interference of each contact at the working temperature over that of the drive at the assembly [-]."""
        pattern = xp.asarray(self.pattern)
        if self.unlike is not None:
            pattern = pattern + self.unlike.added / xp.asarray(self.interference)
        if self.fit is None:
            return pattern
        return pattern + self.fit.contact_thermal_change / xp.asarray(self.interference)

    @property
    def ends(self) -> tuple[str, str]:
        """Names of input and output, in words."""
        return self.drive.input.replace("_", " "), self.drive.output.replace("_", " ")

    @property
    def bearing_names(self) -> tuple[str, ...]:
        """Names of the rolling bearings, in the order of every bearing axis."""
        return bearing_names(self.drive)

    @property
    def rated_bearings(self) -> tuple[RatedBearing | None, ...]:
        """Ratings of these bearings; None where the file has none."""
        return (*(self.pin_bearing for _ in self.drive.pinned), self.input_bearing, self.output_bearing)

    @property
    def contact_names(self) -> tuple[str, ...]:
        """Names of the contacts."""
        return tuple(contact.name for contact in self.drive.contacts)


def bearing_names(drive: Drive) -> tuple[str, ...]:
    """Names of the rolling bearings of a drive."""
    return (*(f"{name}_pin" for name in pin_names(drive)), drive.input, drive.output)


def pin_names(drive: Drive) -> tuple[str, ...]:
    """Names of the rollers on pins, in the order of every pin axis."""
    return tuple(drive.bodies[body].name for body in drive.pinned)


def places(drive: Drive) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Numbers of the first and of the second body of each contact: their places in the drive's bodies."""
    layout = drive.layout
    return tuple(layout.first.tolist()), tuple(layout.second.tolist())


def bodies_of_contacts(joint: Joint) -> BodiesOfContacts:
    """Which bodies the contacts of one sector join, or of all sectors where they differ.

    Bodies on the axis are shared.
    """
    drive, unlike = joint.drive, joint.unlike
    first, second = places(drive)
    return BodiesOfContacts(
        names=tuple(body.name for body in drive.bodies),
        shared=tuple(body.on_axis for body in drive.bodies),
        driving=first,
        driven=second,
        sectors=1 if unlike is None else unlike.sectors,
    )


def contact_values(joint: Joint, values: tuple[Any, ...]) -> Any:
    """One entry for each contact from one for all or one each, stacked along a first axis."""
    count = len(joint.drive.contacts)
    return per_contact(values if len(values) == count else values * count)


def joint_contacts(joint: Joint) -> JointContacts:
    """The contacts of one sector of a joint, numbers of shape (contacts,)."""
    first, second = places(joint.drive)
    driving, driven = (
        per_contact(tuple(elastic_material(joint.materials[body]) for body in side))
        for side in (first, second)
    )
    inside = [contact.internal for contact in joint.drive.contacts]
    walls = [joint.shapes[body].size if inner else None for body, inner in zip(second, inside, strict=True)]
    return JointContacts(
        pairs=roller_pairs(
            radius_1=joint.drive.first_radius,
            radius_2=joint.drive.second_radius,
            sign=xp.where(np.array(inside), -1.0, 1.0),
            contact_length=contact_values(joint, joint.contact_lengths),
            friction_coefficient=contact_values(joint, joint.friction_coefficients),
            moduli=pair(driving, driven),
            surface=contact_values(joint, joint.surfaces),
        ),
        driving=driving,
        driven=driven,
        ring_wall_thickness=per_contact(tuple(1.0 if wall is None else wall for wall in walls)),
        contact_factor_model=joint.contact_factor_model,
        crown_curvature=None if joint.crown_curvatures is None else per_contact(joint.crown_curvatures),
        logarithmic=None
        if joint.logarithmic_crowns is None
        else per_contact(tuple(1.0 if profiled else 0.0 for profiled in joint.logarithmic_crowns)),
    )


def tracks_of(joint: Joint, body: int) -> list[tuple[Array, list[int]]]:
    """Tracks of a body: each radius [m], and the numbers of the contacts that roll on it.

    Contacts of one track are those that the drive lists with one radius.
    """
    radii = joint.drive.first_radius, joint.drive.second_radius
    return [
        (radii[track.side][track.contacts[0]], list(track.contacts))
        for track in joint.drive.layout.tracks[body]
    ]


def track_lengths(joint: Joint, body: int) -> list[Real]:
    """Lengths of the tracks of a body along the axis, which make its mass [m]."""
    lengths, tracks = contact_values(joint, joint.contact_lengths), tracks_of(joint, body)
    length = joint.shapes[body].length
    if length is not None:
        return [length / len(tracks)] * len(tracks)
    return [xp.max(lengths[np.array(contacts)]) for _, contacts in tracks]


def cylinders(joint: Joint, body: int) -> list[tuple[Real, Real, Real]]:
    """The cylinders that make a body, one for each of its tracks."""
    shape, material = joint.shapes[body], joint.materials[body]
    solids: list[tuple[Real, Real, Real]] = []
    for (radius, _), length in zip(tracks_of(joint, body), track_lengths(joint, body), strict=True):
        outer: Real = radius
        bore: Real = 0.0 if shape.size is None else shape.size
        if shape.kind == "ring" and shape.size is not None:
            outer, bore = radius + shape.size, 2.0 * radius
        solids.append((material.density * xp.pi * (outer**2 - 0.25 * bore**2) * length, outer, bore))
    return solids


def body_masses(joint: Joint) -> list[Real]:
    r"""Mass of each body, :math:`\rho \pi \sum (R^2 - d^2/4) L` over its tracks [kg]."""
    return [sum(mass for mass, _, _ in cylinders(joint, body)) for body in range(len(joint.shapes))]


def without_duty(joint: Joint) -> Joint:
    """The same joint without loads of a duty."""
    return dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, duty=()))


def in_motion(joint: Joint) -> Joint:
    """A joint whose drive knows its matrices, speeds and angles.

    Of NumPy's numbers they are found without a program.
    """
    drive = joint.drive
    return dataclasses.replace(
        joint,
        drive=dataclasses.replace(drive, motion=(incidence(drive), speeds(drive), contact_angles(drive))),
    )

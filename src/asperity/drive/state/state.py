"""Laws of the contacts of a drive, its loads, its state, and the speeds of its bodies in rolling. SI units."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

from asperity.body.rim_moments import RimKernel
from asperity.contact.crowned_shear import crown_slip
from asperity.drive.bearings import Bearings
from asperity.drive.layout.drive import Drive, driving_sense
from asperity.drive.normal_springs import NormalSprings, total_approach
from asperity.drive.state.bores import Bores
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.supports import Supports
from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.linear import product
from asperity.types import Array, Real

#: Largest relative residual of a state that is accepted as solved.
STATE_TOLERANCE = 1e-9

#: How far beyond its friction a contact is still said to hold, relative to it: in series with one that slides it bears
#: just its friction.
SLIP_TOLERANCE = 1e-11


class Creeping(NamedTuple):
    """How contacts creep under their forces.

    Parameters
    ----------
    creepage : Array
        Their creepages, shape (contacts,) [-].
    capacity : Array
        Largest tangential forces that they bear while they roll, shape (contacts,) [N].
    skew_drag : Array
        Size of the drag of skew on each surface, as in :class:`Resistance`, shape (contacts,) [N].
    """

    creepage: Array
    capacity: Array
    skew_drag: Array


class Resistance(NamedTuple):
    """What resists the rolling of contacts besides creep, as in :mod:`asperity.drive.state.loads`; signs or sizes.

    Parameters
    ----------
    drag : Array
        Of the oil on each surface, positive where the first one moves counter-clockwise around its body, shape
        (contacts,) [N].
    hysteresis_moment : Array
        Of the pressure, which elastic hysteresis shifts to the inlet, on both bodies, with the same sign, shape
        (contacts,) [N·m].
    skew_drag : Array
        Of the axial friction of skewed axes on each surface, with the same sign, shape (contacts,) [N].
    """

    drag: Array
    hysteresis_moment: Array
    skew_drag: Array


#: How contacts creep under normal and tangential forces; a module, as :class:`asperity.engine.module.Partial` is one.
CreepOf = Callable[[Array, Array], Creeping]

#: Sizes of the drag of the oil [N] and of the moment of hysteresis [N·m] under normal forces, a module of numbers too.
ResistanceOf = Callable[[Array], tuple[Array, Array]]

_NEAR_SLIP = 0.999  # the slip of a standing contact is continued as a line above this share of friction


class ContactLaws(Module):
    r"""Response of the contacts of a drive to approach, slip and creep. SI units, shape (contacts,).

    Parameters
    ----------
    springs : NormalSprings
        Secant and incremental compliance of the bodies at the reference forces [m/N].
    reference_force : Array
        Normal forces at which the springs are given [N].
    creep : CreepLaw
        Carter's creep.
    asperity_compliance : Array or None, optional
        Tangential compliance of the asperities without traction [m/N]; None for smooth bodies.
    slip_exponent : float, optional
        Exponent n of the asperities' stiffness, in proportion to :math:`(1 - q)^n`: 1/3 of the fractal law, 1 of the
        exponential one [-].
    coupling : Array or None, optional
        Approach of one contact under the normal force of another, shape (contacts, contacts) with 0 on the diagonal
        [m/N]; None where every contact deforms under its own force only.
    lateral_strain_compliance : Array or None, optional
        :math:`\sum \nu (1 + \nu)/E` of both bodies [1/Pa]; needed where the springs have crowns.
    rims : RimKernel or None, optional
        What the bodies have contributed to the springs at every load; None where it is not known.
    linear_compliance : Array or None, optional
        Approach in proportion to the normal force, besides that of the springs [m/N]; None for none.
    closure : ContactLaws or None, optional
        What takes the place of these laws under load, around the assembled state and with rigid pins; None where they
        hold there too.
    bores : Bores or None, optional
        What pins and contacts of rollers do to each other; None where pins are not known to press in bores. The
        bending of the pins is :attr:`DriveLoad.pin_compliance`.
    """

    springs: NormalSprings
    reference_force: Array
    creep: CreepLaw
    asperity_compliance: Array | None = None
    coupling: Array | None = None
    lateral_strain_compliance: Array | None = None
    rims: RimKernel | None = None
    linear_compliance: Array | None = None
    closure: ContactLaws | None = None
    bores: Bores | None = None
    slip_exponent: float = static(default=1.0 / 3.0)


class DriveLoad(Module):
    """What acts on a drive besides its preload, and the springs of its pins. SI units.

    Parameters
    ----------
    output_torque : Real
        Torque at the output against its rotation [N·m].
    body_force : Array or None, optional
        Forces on the floating bodies, shape (floating, 2) [N]; None for none.
    pin_compliance : Real, optional
        Of each pin along its push, its contact in the bore not counted, shape () or (pins,) [m/N].
    bearings : Bearings or None, optional
        Friction of the bearings, as in :mod:`asperity.drive.state.loads`; None for none.
    support_stiffness : Array or None, optional
        Radial stiffness of the bearings of each floating body, shape (floating,) [N/m]; None for none.
    rotation, standing_rotation : Real, optional
        Sense in which the drive rolls, and in which it turns before or after it stands: of any size, 0 for that of its
        torque [-].
    supports : Supports or None, optional
        Springs between floating centres and the carrier, relaxed in the assembled drive; None for none.
    friction_on_carrier : bool, optional
        Whether the friction of the rollers' bearings acts on the carrier too; equation (5) of Zou et al. 2025 leaves it
        out.
    resistance_of : callable or None, optional
        What oil and hysteresis do at the contacts of the rolling drive under their normal forces; None where nothing
        but creep resists rolling, and skew does not either.
    """

    output_torque: Real
    body_force: Array | None = None
    pin_compliance: Real = 0.0
    bearings: Bearings | None = None
    support_stiffness: Array | None = None
    rotation: Real = 1.0
    standing_rotation: Real = 1.0
    supports: Supports | None = None
    friction_on_carrier: bool = static(default=True)
    resistance_of: ResistanceOf | None = None


class DriveState(Module):
    """A balanced state of a drive. SI units.

    Parameters
    ----------
    normal, tangential : Array
        Forces of the contacts, shape (contacts,) [N]; a positive tangential force opposes a first surface that moves
        counter-clockwise around its body faster than the second.
    pin_force : Array
        Force of each roller on its pin along the push, shape (pins,) [N].
    displacement : Array
        Displacements of the floating centres from first contact, shape (floating, 2) [m].
    rotation : Array
        Rotations of the members that stand under a torque, input and grounded member locked, shape (members,) [rad].
    speed : Array
        Angular velocities of the members per angular velocity of the input, shape (members,) [-].
    creepage : Array
        Creepages, shape (contacts,) [-]; 0 where nothing rolls.
    drag, hysteresis_moment, skew_drag : Array
        What resists rolling besides creep, as in :class:`Resistance`, shape (contacts,) [N] and [N·m]; 0 where nothing
        rolls.
    interference : Array
        Interference of the contacts, shape (contacts,) [m].
    input_torque : Array
        Torque at the input, in the sense of its rotation [N·m].
    speed_loss : Array
        Share of the output speed lost by creep [-].
    worst : Array
        Largest relative residual of all equations [-].
    slides : Array
        Sign of the tangential force of contacts that slide as a whole while the drive stands and keep the force of
        their friction, 0 for those that hold, shape (contacts,) [-].
    carried : Array
        Whether every contact is loaded and none bears more than its friction; beyond, the law of a contact is
        continued as a line.
    """

    normal: Array
    tangential: Array
    pin_force: Array
    displacement: Array
    rotation: Array
    speed: Array
    creepage: Array
    drag: Array
    hysteresis_moment: Array
    skew_drag: Array
    interference: Array
    input_torque: Array
    speed_loss: Array
    worst: Array
    slides: Array
    carried: Array

    @property
    def resistance(self) -> Resistance:
        """What resists rolling besides creep."""
        return Resistance(self.drag, self.hysteresis_moment, self.skew_drag)

    @property
    def residual(self) -> Array:
        """Largest relative residual of all equations [-]; infinite where a contact has lifted off or friction fails."""
        return xp.where(self.carried, self.worst, xp.inf)


def in_driving_sense(state: DriveState, drive: Drive) -> DriveState:
    """A state whose tangential forces, creepages and resistances have the signs of ``driving_sense`` of its drive."""
    sense, signed = driving_sense(drive), ("tangential", "creepage", *Resistance._fields)
    return dataclasses.replace(state, **{name: sense * getattr(state, name) for name in signed})


def contact_approach(*, laws: ContactLaws, normal: Array) -> Array:
    r"""Approach of the bodies of each contact from first touch.

    .. math:: \delta_k = \delta_k(N_k) + \sum_j C_{kj} N_j + c_k N_k

    Parameters
    ----------
    laws : ContactLaws
        The contacts.
    normal : Array
        Normal forces, shape (contacts,) [N].

    Returns
    -------
    Array
        Approach, shape (contacts,) [m].

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    approach = xp.asarray(
        total_approach(springs=laws.springs, normal_force=normal, rest_force=laws.reference_force)
    )
    if laws.coupling is not None:
        approach = approach + product(laws.coupling, normal)
    return approach if laws.linear_compliance is None else approach + laws.linear_compliance * normal


def slip_at_rest(*, laws: ContactLaws, normal: Array, tangential: Array) -> Array:
    r"""Slip of contacts that stand, on first loading.

    .. math::
        s = \mu N\left[C_0 q + b\,\bigl((1-q)\ln(1-q) + q\bigr) + c_a \int_0^q \frac{dq}{(1-q)^n}\right],
        \qquad q = \frac{T}{\mu N}

    with the incremental compliance :math:`C_0` of the bodies, its logarithmic part b, and the asperities' :math:`c_a`;
    the integral is :math:`\tfrac32 \bigl(1 - (1-q)^{2/3}\bigr)` for n = 1/3, and :math:`-\ln(1-q)` for 1. Crowned
    contacts slip by :func:`asperity.contact.crowned_shear.crown_slip` more.

    Parameters
    ----------
    laws : ContactLaws
        The contacts.
    normal, tangential : Array
        Forces, shape (contacts,) [N].

    Returns
    -------
    Array
        Slip with the sign of the force [m]; above 99.9 % of friction the tangent is continued, that of the even contact
        where rollers are crowned.

    References
    ----------
    Integrals of the incremental compliances :func:`asperity.contact.interface.bulk_tangential_stiffness` and of
    equation (24) of Zou et al. 2025 or of (A10) of :doc:`/equations`.
    """
    limit = laws.creep.friction_coefficient * xp.where(normal > 0.0, normal, 1.0)
    # without a force too, where the slope is that of both sides
    sign = xp.where(tangential < 0.0, -1.0, 1.0)
    q = sign * tangential / limit
    held = xp.minimum(q, _NEAR_SLIP)
    left = 1.0 - held
    log = xp.log(left)
    bodies, bend = (
        laws.springs.incremental_compliance,
        laws.springs.secant_compliance - laws.springs.incremental_compliance,
    )
    slip = bodies * held + bend * (left * log + held)
    slope = bodies - bend * log
    if laws.asperity_compliance is not None:
        power = 1.0 - laws.slip_exponent
        yielded = -log if power == 0.0 else -xp.expm1(log * power) / power
        slip = slip + laws.asperity_compliance * yielded
        slope = slope + laws.asperity_compliance * xp.exp(-log * laws.slip_exponent)
    slip = limit * (slip + slope * (q - held))
    crowns = laws.springs.crowns
    if crowns is not None and laws.lateral_strain_compliance is not None:
        pressed = xp.where(normal > 0.0, normal, 1.0)
        slip = slip + crown_slip(
            normal_force=pressed,
            stick_force=left * pressed,
            friction_coefficient=laws.creep.friction_coefficient,
            lateral_strain_compliance=laws.lateral_strain_compliance,
            **vars(crowns.lines),
        )
    return sign * slip


def surface_speeds(*, drive: Drive, speed: Array) -> tuple[Array, Array]:
    """Speeds of both surfaces of each contact relative to the carrier, positive, shape (contacts,) [m/s].

    Of angular velocities of the members [rad/s]; radius times angular velocity relative to the carrier.
    """
    layout = drive.layout
    relative = speed - speed[layout.carrier]
    return (
        drive.first_radius * xp.abs(relative[layout.first]),
        drive.second_radius * xp.abs(relative[layout.second]),
    )


class BodiesOfContacts(NamedTuple):
    """Which bodies the contacts of one branch of a drive join.

    Parameters
    ----------
    names : tuple of str
        Names of the bodies, in the order of every body axis.
    shared : tuple of bool
        Whether a body is one for all branches.
    driving, driven : tuple of int
        Places of the two bodies of each contact in the names.
    sectors : int, optional
        How many branches the contacts are listed of, one branch after the other: those of one kind pass over the same
        track of a shared body.
    """

    names: tuple[str, ...]
    shared: tuple[bool, ...]
    driving: tuple[int, ...]
    driven: tuple[int, ...]
    sectors: int = 1


class RollingSpeeds(Module):
    """Speeds of a rolling drive relative to the carrier. SI units.

    Parameters
    ----------
    driving, driven : Array
        Speeds of the two surfaces of each contact, shape (contacts, ...) [m/s].
    body : Array
        Angular velocities of the bodies of one sector relative to the carrier, shape (bodies, ...) [rad/s]; positive.
    output : Array
        Angular velocity of the output relative to the ground, reduced by creep [rad/s]; positive.
    """

    driving: Array
    driven: Array
    body: Array
    output: Array

    @property
    def rolling(self) -> Array:
        """Rolling speed of each contact, the mean of both surfaces [m/s]."""
        return 0.5 * (self.driving + self.driven)

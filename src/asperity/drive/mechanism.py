"""A preloaded drive without torque: bearings, normal springs, and the state at rest."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

from asperity.contact.crowned_line import CrownedLines, crown_compliance, crown_compression
from asperity.drive.wedge.geometry import DriveGeometry, Triangle
from asperity.engine.arrays import xp
from asperity.engine.derivatives import with_rule
from asperity.engine.module import Module, static
from asperity.types import Array, Real

Closure = Literal["elastic", "constant_pin_force"]

_SMALL_LOAD = 1e-6


class Bearings(Module):
    r"""Friction torques of the bearings; a pin's is :math:`T_B + \tfrac14 \mu_b F_c d`.

    Each roller has two bearings, which share the force F_c of its pin.

    Parameters
    ----------
    sun_torque, loading_roller_torque, carrier_torque : Real
        Constant friction torque of one sun, loading roller and carrier bearing [N·m]; each body has two.
    pin_friction_coefficient : Real
        Friction coefficient mu_b of the loading rollers' pins [-]: friction force mu_b F_c at the diameter below.
    pin_friction_diameter : Real
        Diameter d at which that friction acts [m].
    """

    sun_torque: Real
    loading_roller_torque: Real
    carrier_torque: Real
    pin_friction_coefficient: Real
    pin_friction_diameter: Real


def bearing_torque(*, bearings: Bearings, pin_force: Array) -> Array:
    r"""Friction torque of one of a roller's two bearings on its pin, :math:`T_B + \tfrac14 \mu_b |F| d`.

    Parameters
    ----------
    bearings : Bearings
        Friction of the bearings.
    pin_force : Array
        Force of the roller on its pin [N].

    Returns
    -------
    Array
        Torque [N·m].

    References
    ----------
    Coulomb friction at the radius d/2 under half the pin force, for the T_B that equations (3) and (4) of Zou et al.
    2025 leave open.
    """
    pin = 0.25 * bearings.pin_friction_coefficient * bearings.pin_friction_diameter
    return xp.asarray(bearings.loading_roller_torque + pin * xp.abs(pin_force))


def leading_sense(*, rotation: Real, output_torque: Real) -> Array:
    r"""Sense that the friction of bearings opposes, :math:`\operatorname{sgn}\omega`, or that of the torque at rest.

    Parameters
    ----------
    rotation : Real
        Speed of the input, of either sign [any]; 0 where it stands.
    output_torque : Real
        Torque at the output, positive where it resists a positive rotation [N·m].

    Returns
    -------
    Array
        +1 or −1 [-]: that of the rotation; without one that of the torque, because a drive that begins to move follows
        it. A torque against the sense of rotation brakes.

    References
    ----------
    Coulomb friction opposes the motion.
    """
    speed = xp.asarray(rotation)
    leading = xp.where(speed == 0.0, xp.asarray(output_torque), speed)
    return xp.where(leading < 0.0, -1.0, 1.0)


class CrownedSprings(Module):
    """What crowns add to the normal springs of the contacts around their preload; arrays of one shape.

    Parameters
    ----------
    lines : CrownedLines
        The contacts.
    rest_compression : Array
        Approach that the crowns add at rest, shape (5, ...) [m].
    steepest_compliance : Array
        Compliance that they add to a contact about to lift off, shape (5, ...) [m/N].
    """

    lines: CrownedLines
    rest_compression: Array
    steepest_compliance: Array


def crowned_springs(*, lines: CrownedLines, rest_force: Array) -> CrownedSprings:
    """What crowns add to the normal springs of contacts.

    Parameters
    ----------
    lines : CrownedLines
        The contacts.
    rest_force : Array
        Normal forces at rest, shape (5, ...) [N].

    Returns
    -------
    CrownedSprings
        Around these forces.

    References
    ----------
    Equation (B12) of :doc:`/equations`.
    """
    return CrownedSprings(
        lines=lines,
        rest_compression=crown_compression(normal_force=rest_force, **vars(lines)),
        steepest_compliance=crown_compliance(normal_force=_SMALL_LOAD * rest_force, **vars(lines)),
    )


class NormalSprings(Module):
    r"""Compression of the five contacts around their preload, exact for every logarithmic line-contact law.

    .. math:: \delta(N) = N \left[s_0 - (s_0 - t_0) \ln (N/N_0)\right] + \Delta\delta(N)

    Parameters
    ----------
    secant_compliance, incremental_compliance : Array
        s_0 = delta/N and t_0 = d delta/dN of the even contacts at the preload N_0, shape (5, ...) [m/N].
    crowns : CrownedSprings or None
        Crowned contacts, whose rollers approach by :math:`\Delta\delta` more; None where none is crowned.
    """

    secant_compliance: Array
    incremental_compliance: Array
    crowns: CrownedSprings | None = None


def compression(*, springs: NormalSprings, normal_force: Real, rest_force: Real) -> Real:
    r"""Approach of the two bodies of each contact beyond their state at rest.

    .. math:: \delta(N) - \delta(N_0), \quad \delta(N) = N \left[s_0 - (s_0 - t_0) \ln (N/N_0)\right]

    Parameters
    ----------
    springs : NormalSprings
        Secant and incremental compliance at rest [m/N].
    normal_force, rest_force : Real
        Normal force N and its value N_0 at rest [N].

    Returns
    -------
    Real
        Approach [m]. Below a millionth of the rest force the tangent is continued; only intermediate
        iterates of the solver reach this range.

    References
    ----------
    The Johnson and the Weber–Banaschek compressions, :mod:`asperity.contact.hertz_line`, are both of this form.
    """
    secant = springs.secant_compliance
    even = rest_force * _compression_shape(
        normal_force * (1.0 / rest_force), secant, secant - springs.incremental_compliance
    )
    if springs.crowns is None:
        return even
    return even + _crown(springs.crowns, normal_force, rest_force)


def total_approach(*, springs: NormalSprings, normal_force: Real, rest_force: Real) -> Real:
    r"""Approach of the two bodies of each contact from first touch, :math:`\delta(N)`.

    Parameters
    ----------
    springs : NormalSprings
        Secant and incremental compliance at rest [m/N].
    normal_force, rest_force : Real
        Normal force N and its value N_0 at rest [N].

    Returns
    -------
    Real
        Approach [m], as far from that at rest as :func:`compression` says.

    References
    ----------
    As for :func:`compression`; equation (B12) of :doc:`/equations` for crowned contacts.
    """
    beyond = compression(springs=springs, normal_force=normal_force, rest_force=rest_force)
    even = beyond + springs.secant_compliance * rest_force
    return even if springs.crowns is None else even + springs.crowns.rest_compression


def _crown(crowns: CrownedSprings, normal_force: Real, rest_force: Real) -> Array:
    """Approach by the crowns beyond that at rest, with a tangent below the smallest load."""
    pressed = xp.maximum(normal_force, _SMALL_LOAD * rest_force)
    at_load = crown_compression(normal_force=pressed, **vars(crowns.lines))
    return at_load - crowns.rest_compression + (normal_force - pressed) * crowns.steepest_compliance


def steepest_compliance(springs: NormalSprings) -> Real:
    r"""Largest slope of :func:`compression`, that of a contact about to lift off.

    Parameters
    ----------
    springs : NormalSprings
        Secant and incremental compliance at rest [m/N].

    Returns
    -------
    Real
        :math:`t_0 - (s_0 - t_0) \ln 10^{-6}` [m/N], the tangent with which :func:`compression` is continued; plus
        that of the crowns.
    """
    bend = springs.secant_compliance - springs.incremental_compliance
    steepest = springs.incremental_compliance - bend * math.log(_SMALL_LOAD)
    if springs.crowns is None:
        return steepest
    return steepest + springs.crowns.steepest_compliance


@with_rule
def _compression_shape(ratio: Array, secant: Array, bend: Array) -> Array:
    """Compression over the rest force, in n = N/N_0: s_0 (n − 1) − (s_0 − t_0) n ln n."""
    safe = xp.maximum(ratio, _SMALL_LOAD)
    return secant * (ratio - 1.0) - bend * _bent(ratio, safe, xp.log(safe))


@_compression_shape.defjvp
def _compression_shape_jvp(
    primals: tuple[Array, Array, Array], tangents: tuple[Array, Array, Array]
) -> tuple[Array, Array]:
    """Without a division, which would cost the solver a pass over memory."""
    (ratio, secant, bend), (ratio_dot, secant_dot, bend_dot) = primals, tangents
    safe = xp.maximum(ratio, _SMALL_LOAD)
    log = xp.log(safe)
    bent = _bent(ratio, safe, log)
    slope = secant - bend * (1.0 + log)
    value = secant * (ratio - 1.0) - bend * bent
    return value, slope * ratio_dot + (ratio - 1.0) * secant_dot - bent * bend_dot


def _bent(ratio: Array, safe: Array, log: Array) -> Array:
    """The product n ln n, continued below the smallest load by its tangent."""
    return safe * log + (ratio - safe) * (1.0 + math.log(_SMALL_LOAD))


class RestState(NamedTuple):
    """Forces at rest without torque, from the preload."""

    normal_force: Array
    pin_force_left: Array
    pin_force_right: Array


class Mechanism(Module):
    """A preloaded drive: all data of its force balance except the torque. SI units.

    Parameters
    ----------
    geometry : DriveGeometry
        Radii and arrangement.
    sides : Triangle
        Its triangle of centres.
    rest : RestState
        Its forces at rest.
    bearings : Bearings
        Friction of its bearings.
    springs : NormalSprings
        Normal springs of the contacts; used by the ``elastic`` closure only.
    preload : Real
        Normal force N_0 between sun and planet at rest [N].
    carrier_speed : Real
        Angular velocity of the carrier [rad/s].
    planet_mass, loading_roller_mass : Real
        Masses [kg]; enter through the centrifugal forces m omega_c^2 r.
    closure : {"elastic", "constant_pin_force"}
        ``elastic``: the preload is an interference fixed at assembly, see :doc:`/equations` (A3);
        ``constant_pin_force``: the right pin force keeps its preload value.
    """

    geometry: DriveGeometry
    sides: Triangle
    rest: RestState
    bearings: Bearings
    springs: NormalSprings
    preload: Real
    carrier_speed: Real
    planet_mass: Real
    loading_roller_mass: Real
    closure: Closure = static()


def rest_state(*, geometry: DriveGeometry, sides: Triangle, preload: Real) -> RestState:
    """Preload at rest: N_sp = N_0, both sides equal; equations (2)–(4) without tangential forces.

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    sides : Triangle
        Its triangle of centres.
    preload : Real
        Normal force N_0 between sun and planet at rest [N].

    Returns
    -------
    RestState
        Normal forces, shape (5, ...), and the two pin forces [N].

    References
    ----------
    Equation (A3) of :doc:`/equations`.
    """
    planet_roller = preload / (2.0 * sides.cos_direction)
    pin_left = planet_roller * sides.sin_wedge / xp.cos(geometry.left_push_angle)
    pin_right = planet_roller * sides.sin_wedge / xp.cos(geometry.right_push_angle)
    left_ring = pin_left * xp.sin(geometry.left_push_angle) + planet_roller * sides.cos_wedge
    right_ring = pin_right * xp.sin(geometry.right_push_angle) + planet_roller * sides.cos_wedge
    normal = xp.stack(
        xp.broadcast_arrays(xp.asarray(preload), planet_roller, planet_roller, right_ring, left_ring)
    )
    return RestState(normal, pin_left, pin_right)

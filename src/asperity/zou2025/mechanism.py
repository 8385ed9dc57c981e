"""The paper's drive as data of its force balance: sizes, bearings, normal springs, and its forces at rest."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

from asperity.drive.bearings import Bearings
from asperity.drive.layout.wedge_geometry import DriveGeometry, Triangle
from asperity.drive.normal_springs import SMALL_LOAD, NormalSprings
from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.types import Array, Real

Closure = Literal["elastic", "constant_pin_force"]


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


def steepest_compliance(springs: NormalSprings) -> Real:
    r"""Largest slope of :func:`~asperity.drive.normal_springs.compression`, that of a contact about to lift off.

    Parameters
    ----------
    springs : NormalSprings
        Secant and incremental compliance at rest [m/N].

    Returns
    -------
    Real
        :math:`t_0 - (s_0 - t_0) \ln 10^{-6}` [m/N], the tangent with which the compression is continued; plus that of
        the crowns.
    """
    bend = springs.secant_compliance - springs.incremental_compliance
    steepest = springs.incremental_compliance - bend * math.log(SMALL_LOAD)
    if springs.crowns is None:
        return steepest
    return steepest + springs.crowns.steepest_compliance

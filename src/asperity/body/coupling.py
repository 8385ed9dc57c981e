r"""Springs of a machine with elastic bodies: one compliance matrix of all its contacts.

A contact acts with :math:`N` on both bodies and with :math:`T` in opposite directions. On every body the
outward and counter-clockwise components of these forces have the same sign, so that the matrices of the bodies
add up where contacts share a body:

.. math:: C_{ij} = \sum_{\text{bodies } b \ni i, j} C^{(b)}_{ij}

for normal and tangential components. With it the assembly is :math:`B q - C f = 0`, :math:`B^\mathsf{T} f = g`;
the assembly takes its diagonal as springs and the rest as their coupling.

All bodies are computed as one array: *places* are the contacts of all bodies on themselves, then the pairs of
different contacts of a body.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from asperity.body.annulus_modes import Wall
from asperity.body.compliance import loaded_radius, wall_of
from asperity.body.rigid_modes import uniform_compliance
from asperity.body.rim_kernel import self_sums
from asperity.body.rim_moments import (
    MOMENTS,
    WIDEST_CONTACT,
    RimKernel,
    closed_kernel,
    other_rim,
    weighted_mean,
)
from asperity.body.shapes import Annulus, Disc, kolosov_constant
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.derivatives import without_slopes
from asperity.engine.module import Module, static
from asperity.errors import InputError
from asperity.materials import shear_modulus
from asperity.types import Array, Real

#: The kernels in the order of a :class:`RimKernel`.
_RADIAL, _TANGENTIAL, _COUPLING = range(3)


class BodyInMachine(Module):
    """A body and the positions of its contacts.

    Parameters
    ----------
    body : Disc or Annulus
        The body.
    contacts : tuple of int
        Numbers of its contacts in the machine's list [-].
    contact_angles : Array
        Polar angles of these contacts about the body's centre, counter-clockwise in the plane of the machine,
        shape (n, ...) [rad].
    sectors : Real or None
        Number of equal sectors of the machine that this body belongs to, at least 2: that of the planets for sun and
        ring [-]; None for a body of one sector.
    """

    body: Disc | Annulus
    contacts: tuple[int, ...] = static()
    contact_angles: Array
    sectors: Real | None


class _Places(NamedTuple):
    """Static tables of the places: every body for a contact of it on itself, then all pairs of contacts of a body."""

    body: np.ndarray  # of each place
    contacts: np.ndarray  # of each pair, shape (2, pairs)
    angles: np.ndarray  # the same in the list of all bodies' contacts
    contact_body: np.ndarray  # of each contact of each body
    contact_number: np.ndarray


def _places(bodies: Sequence[BodyInMachine]) -> _Places:
    members = [(number, contact) for number, member in enumerate(bodies) for contact in member.contacts]
    contact_body, contact_number = np.array(members).T
    pairs = [
        pair
        for pair in itertools.combinations(range(len(members)), 2)
        if len({members[k][0] for k in pair}) == 1
    ]
    angles = np.array(pairs, dtype=int).reshape(-1, 2).T
    return _Places(
        body=np.concatenate([np.arange(len(bodies)), contact_body[angles[0]]]),
        contacts=contact_number[angles],
        angles=angles,
        contact_body=contact_body,
        contact_number=contact_number,
    )


def _column(values: Sequence[Any], rank: int) -> Array:
    """Numbers of several things along a first axis, in front of the batch axes."""
    if all(isinstance(value, float) for value in values):
        return xp.asarray(np.array(values).reshape((-1,) + (1,) * rank))
    arrays = [xp.asarray(value, dtype=float) for value in values]
    same = xp.broadcast_arrays(*(array.reshape((1,) * (rank - array.ndim) + array.shape) for array in arrays))
    return xp.stack(same)


def coupled_compliance(
    *,
    bodies: Sequence[BodyInMachine],
    contact_lengths: Real,
    half_widths: Array,
    stick_half_widths: Array,
    kernel: RimKernel | None = None,
) -> Array:
    r"""Compliance matrix of all contacts of one sector of a machine of elastic bodies.

    .. math:: C = \sum_b P_b^\mathsf{T} C^{(b)} P_b

    Parameters
    ----------
    bodies : sequence of BodyInMachine
        The bodies; :math:`P_b` picks their contacts.
    contact_lengths : Real
        Lengths of the m contacts of the sector, shape (m, ...) or (1, ...) [m]. A contact shorter than its
        body compresses its surroundings (the disc, or the hole in a plate, under its own force) over its own length.
    half_widths : Array
        Their half-widths, shape (m, ...) [m].
    stick_half_widths : Array
        Half-widths of their stick zones, shape (m, ...) [m].
    kernel : RimKernel or None, optional
        Of :func:`machine_kernel`, where it is known already.

    Returns
    -------
    Array
        Compliance, shape (2m, 2m, ...), first the normal, then the tangential springs [m/N]. Elongations are
        approach, and slip along the counter-clockwise tangent of either body where both touch from outside, of the
        inner one where a ring surrounds it. nan for an annulus whose wall is less than five half-widths, or so thin
        that its modes do not suffice.

    Notes
    -----
    All sectors are loaded equally, as under a torque. The elongations of the springs are the sum of this matrix times
    the forces and of the rigid motions of the bodies, the unknowns :math:`q` of the assembly. The sum over modes ends
    where the thinnest wall of the batch needs no more. The number of sectors is not differentiated.

    References
    ----------
    Equation (E3) of :doc:`/equations`.
    """
    rank, count = half_widths.ndim - 1, half_widths.shape[0]
    places, numbers = _places(bodies), _numbers(bodies, rank)
    if kernel is None:
        kernel = _kernel(bodies, places, numbers, rank)
    own, mutual = _own_entries(places, count), _mutual_entries(places, count)
    widths = xp.concatenate([half_widths, stick_half_widths])  # of each spring
    lengths = xp.broadcast_to(contact_lengths, (count, *xp.shape(contact_lengths)[1:]))
    around = _smooth(kernel, own.joined(mutual), numbers, widths)
    by_itself = around[: own.row.size] + _under_its_own_force(own, numbers, widths, lengths)
    compliance = _matrix(2 * count, (own, by_itself), (mutual, around[own.row.size :]))
    return xp.where(_too_wide(bodies, half_widths), xp.nan, compliance)


class _Entries(NamedTuple):
    """Where a body moves one spring (the row) under the force of another (the column), and by which kernel.

    The springs are numbered as the matrix: the normal ones of all contacts, then the tangential ones. The kernels are
    numbered as those of :class:`RimKernel`; an entry takes its kernel at its place, with its sign.
    """

    row: np.ndarray
    column: np.ndarray
    body: np.ndarray
    place: np.ndarray
    kernel: np.ndarray
    sign: np.ndarray

    def joined(self, others: _Entries) -> _Entries:
        """These entries, then others."""
        return _Entries(*(np.concatenate(both) for both in zip(self, others, strict=True)))


def _block(
    *, row: np.ndarray, column: np.ndarray, places: _Places, at: np.ndarray, kernel: int, sign: float = 1.0
) -> _Entries:
    """Entries by one kernel at the places ``at``."""
    return _Entries(row, column, places.body[at], at, np.full(at.size, kernel), np.full(at.size, sign))


def _own_entries(places: _Places, count: int) -> _Entries:
    """Of each contact of each body: its normal spring under its own force, then its tangential one."""
    normal = places.contact_number
    tangential = normal + count
    at = places.contact_body  # the first places are the bodies, for a contact on itself
    return _block(row=normal, column=normal, places=places, at=at, kernel=_RADIAL).joined(
        _block(row=tangential, column=tangential, places=places, at=at, kernel=_TANGENTIAL)
    )


def _mutual_entries(places: _Places, count: int) -> _Entries:
    """Of each pair of contacts of a body: both normal springs, both tangential ones, and one of each."""
    one, two = places.contacts
    at = np.arange(places.body.size - one.size, places.body.size)
    blocks = (
        _block(row=one, column=two, places=places, at=at, kernel=_RADIAL),
        _block(row=one + count, column=two + count, places=places, at=at, kernel=_TANGENTIAL),
        # odd in the angle from the second contact to the first one: the other sign where the first one moves
        _block(row=one, column=two + count, places=places, at=at, kernel=_COUPLING, sign=-1.0),
        _block(row=two, column=one + count, places=places, at=at, kernel=_COUPLING),
    )
    return functools.reduce(_Entries.joined, blocks)


def _smooth(kernel: RimKernel, entries: _Entries, numbers: _Numbers, widths: Array) -> Array:
    """Compliance of entries by their kernels, the pressures of both contacts spread, shape (entries, ...) [m/N]."""
    at_places = xp.concatenate(kernel, axis=1)[:, entries.kernel * kernel[0].shape[1] + entries.place]
    squares, per_radius = widths**2, numbers.inverse_square[entries.body]
    sign = entries.sign.reshape((-1,) + (1,) * (widths.ndim - 1))
    return (numbers.scale[entries.body] * sign) * weighted_mean(
        at_places, squares[entries.row] * per_radius, squares[entries.column] * per_radius
    )


def _under_its_own_force(own: _Entries, numbers: _Numbers, widths: Array, lengths: Array) -> Array:
    """What disc or hole add below a contact, which is as long as the contact, shape (entries, ...) [m/N]."""
    plus, minus = self_sums(widths[own.row] * xp.sqrt(numbers.inverse_square[own.body]))
    contact = own.row % lengths.shape[0]
    return (numbers.plus[own.body] * plus + numbers.minus[own.body] * minus) * (
        numbers.local_scale[own.body] / lengths[contact]
    )


def _matrix(size: int, own: tuple[_Entries, Array], mutual: tuple[_Entries, Array]) -> Array:
    """The symmetric matrix of entries and their values, shape (size, size, ...): both bodies of a contact add up."""
    (on_itself, by_itself), (between, by_others) = own, mutual
    diagonal = xp.tensordot(np.eye(size)[:, on_itself.row], by_itself, axes=1)
    shape = xp.broadcast_shapes(diagonal.shape[1:], by_others.shape[1:])
    parts = (diagonal, by_others, xp.zeros((1, *shape)))
    values = xp.concatenate([xp.broadcast_to(part, (part.shape[0], *shape)) for part in parts])
    number = np.full((size, size), values.shape[0] - 1)  # of each entry's value: no body, 0
    np.fill_diagonal(number, np.arange(size))
    at = size + np.arange(between.row.size)
    number[between.row, between.column] = number[between.column, between.row] = at
    return values[number]


class _Numbers(NamedTuple):
    """Numbers of the bodies, shape (bodies, ...)."""

    inverse_square: Array  # of the loaded radius [1/m^2]
    local_scale: Array  # 1/(4 pi G) [1/Pa]
    scale: Array  # 1/(4 pi G L) [m/N]
    kolosov: Array
    plus: Array  # weights of the closed sums over 1/(n+1) and 1/(n-1)
    minus: Array
    sectors: Array


def _numbers(bodies: Sequence[BodyInMachine], rank: int) -> _Numbers:
    young, poisson, length, radius = (
        _column(values, rank)
        for values in (
            [member.body.youngs_modulus for member in bodies],
            [member.body.poisson_ratio for member in bodies],
            [member.body.length for member in bodies],
            [loaded_radius(member.body) for member in bodies],
        )
    )
    states = {member.body.plane_state for member in bodies}
    if len(states) > 1:
        raise InputError("the bodies of a machine must all be in plane strain, or all in plane stress")
    kolosov = xp.asarray(kolosov_constant(poisson_ratio=poisson, plane_state=states.pop()))
    hole = np.array(
        [isinstance(member.body, Annulus) and member.body.loaded_rim == "inner" for member in bodies]
    )
    hole = hole.reshape((-1,) + (1,) * rank)
    local_scale = 1.0 / (4.0 * math.pi * shear_modulus(youngs_modulus=young, poisson_ratio=poisson))
    return _Numbers(
        inverse_square=1.0 / radius**2,
        local_scale=xp.asarray(local_scale),
        scale=local_scale / length,
        kolosov=kolosov,
        plus=xp.where(hole, 1.0, kolosov),
        minus=xp.where(hole, kolosov, 1.0),
        sectors=without_slopes(
            _column([1.0 if member.sectors is None else member.sectors for member in bodies], rank)
        ),
    )


def _too_wide(bodies: Sequence[BodyInMachine], half_widths: Array) -> Array:
    wide = xp.zeros(half_widths.shape[1:], dtype=bool)
    for member in bodies:
        if isinstance(member.body, Annulus):
            wall = member.body.outer_radius - member.body.inner_radius
            widest = xp.max(half_widths[np.array(member.contacts)], axis=0)
            wide = wide | (widest > WIDEST_CONTACT * wall)
    return wide


def machine_kernel(bodies: Sequence[BodyInMachine]) -> RimKernel:
    """What no load changes in the compliance of a machine of single numbers, for several loads.

    Parameters
    ----------
    bodies : sequence of BodyInMachine
        The bodies.

    Returns
    -------
    RimKernel
        For :func:`coupled_compliance`.

    References
    ----------
    Equations (E1)–(E3) of :doc:`/equations`.
    """
    return _kernel(bodies, _places(bodies), _numbers(bodies, 0), 0)


def _kernel(bodies: Sequence[BodyInMachine], places: _Places, numbers: _Numbers, rank: int) -> RimKernel:
    """What no load changes: the kernel at every place, without the disc or hole under a contact's own force."""
    body_count = len(bodies)
    polar = [xp.asarray(member.contact_angles) for member in bodies]
    shape = xp.broadcast_shapes(*(angles.shape[1:] for angles in polar), (1,) * rank)
    listed = xp.concatenate([xp.broadcast_to(angles, (angles.shape[0], *shape)) for angles in polar])
    pair_angle = listed[places.angles[0]] - listed[places.angles[1]]
    angle = xp.concatenate([xp.zeros((body_count, *shape)), pair_angle])
    closed = closed_kernel(
        angle=angle,
        plus=numbers.plus[places.body],
        minus=numbers.minus[places.body],
        sectors=numbers.sectors[places.body],
    )
    hollow = [number for number, member in enumerate(bodies) if isinstance(member.body, Annulus)]
    pressure = 0.5 * numbers.sectors * (numbers.kolosov - 1.0)
    if not hollow:
        return _with_uniform(closed, pressure[places.body], xp.zeros(()))
    walls = [wall_of(bodies[number].body) for number in hollow]  # type: ignore[arg-type]
    wall: Wall = trees.map(lambda *leaves: _column(leaves, rank), *walls)
    radial, twist = (0.5 * numbers.sectors[np.array(hollow)] * part for part in uniform_compliance(wall))
    into_bodies = np.eye(body_count)[:, hollow]
    solid = 1.0 - into_bodies.sum(axis=1).reshape((-1,) + (1,) * rank)
    pressure = solid * pressure + xp.tensordot(into_bodies, radial, axes=1)
    twist = xp.tensordot(into_bodies, twist, axes=1)
    closed = _with_uniform(closed, pressure[places.body], twist[places.body])

    at = np.flatnonzero(np.isin(places.body, hollow))
    of = np.searchsorted(hollow, places.body[at])
    wall = trees.map(lambda leaf: leaf[of] if len(hollow) > 1 else leaf, wall)
    alone = np.array([bodies[number].sectors is None for number in places.body[at]])
    far = other_rim(
        wall=wall,
        angle=angle[at],
        sectors=numbers.sectors[places.body[at]],
        one_sector=alone.reshape((-1,) + (1,) * rank),
    )
    into_places = np.eye(places.body.size)[:, at]

    def spread(part: Array) -> Array:
        return xp.moveaxis(xp.tensordot(into_places, part, axes=([1], [1])), 1, 0)

    return RimKernel(*(near + spread(part) for near, part in zip(closed, far, strict=True)))


def _with_uniform(kernel: RimKernel, pressure: Array, twist: Array) -> RimKernel:
    """A kernel with the mode n = 0, which is the same at every angle."""
    first = np.eye(MOMENTS)[0].reshape((-1,) + (1,) * (kernel.radial.ndim - 1))
    return kernel._replace(
        radial=kernel.radial + first * pressure, tangential=kernel.tangential + first * twist
    )

r"""Stresses along both rims of an annulus whose contacts go round: every point of a rim sees all of them.

The same fields as in :mod:`asperity.body.rim_stress`, for bodies of equal sectors and for arrays of joints. At points
that divide a sector evenly the Fourier series of the stress is a product with tables that never change.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.body.annulus_modes import Channels, Wall, mode_field
from asperity.body.compliance import loaded_radius, wall_of
from asperity.body.rigid_modes import translation_field, uniform_field
from asperity.body.shapes import Annulus, PlaneState
from asperity.engine.arrays import xp
from asperity.engine.derivatives import without_slopes
from asperity.engine.module import Module
from asperity.types import Array, Real

#: Points that divide a sector, and modes that are summed.
POINTS, MODES = 180, 192
#: Distance from a contact within which the loaded rim is left out, in half-widths.
CLEARANCE = 5.0
#: Largest share of the modes left out in the stress of the other rim; above it the result is nan.
_OMITTED = 1e-4


class RimLoads(NamedTuple):
    """Contact forces on the loaded rim of a body; all sectors alike.

    Parameters
    ----------
    angles : Array
        Polar angles of the contacts of one sector, shape (k, ...) [rad].
    radial, tangential : Array
        Forces on the body, outward and counter-clockwise, shape (k, ...) [N].
    half_widths : Array
        Half-widths of the contacts, shape (k, ...) [m].
    sectors : Real or None
        Number of equal sectors, at least 2 [-]; None for a body of one sector.
    """

    angles: Array
    radial: Array
    tangential: Array
    half_widths: Array
    sectors: Real | None


class RimStresses(Module):
    """Stresses along the rims of a body in one state, tension positive, shape (points, ...) [Pa].

    Parameters
    ----------
    loaded_hoop : Array
        Hoop stress of the loaded rim [Pa]; nan near the contacts.
    other_hoop, other_radial, other_shear : Array
        Stresses of the other rim [Pa]; the last two are those between ring and housing, 0 on a free rim.
    """

    loaded_hoop: Array
    other_hoop: Array
    other_radial: Array
    other_shear: Array


class _Modes(NamedTuple):
    """Stress amplitudes of each mode under unit forces, in units of 1/(pi R L)."""

    loaded: Array
    hoop: Array
    radial: Array
    shear: Array


def _modes(wall: Wall, mode: Array, plus: float, minus: float) -> _Modes:
    """Stresses of modes n >= 2 under tractions in the two channels; of the loaded rim without the closed part."""
    field = mode_field(mode=mode, decay=(wall.ratio**wall.side) ** mode, wall=wall)

    def through(channels: Channels, first: Real, second: Real) -> tuple[Real, Real]:
        return channels.pp * first + channels.pm * second, channels.mp * first + channels.mm * second

    x = through(field.motion, plus, minus)
    echo, passed, back = (through(part, *x) for part in (field.echo, field.passed, field.answer))
    (d1_p, d1_m), (d2_p, d2_m) = field.first, field.second
    up, down = d1_p * passed[0] + d2_p * back[0], d1_m * passed[1] + d2_m * back[1]
    radial = 0.5 * (up + down)
    return _Modes(
        loaded=xp.asarray(2.0 * (d2_p * echo[0] - d2_m * echo[1])),
        hoop=xp.asarray((2.0 * (d1_p * passed[0] + d2_m * back[1]) - radial) / wall.ratio),
        radial=xp.asarray(radial / wall.ratio),
        shear=xp.asarray(0.5 * wall.side * (up - down) / wall.ratio),
    )


def _first_mode(wall: Wall, plus: float, minus: float, closed: float) -> _Modes:
    """Stresses of the mode n = 1 of a body whose other rim is free."""
    b, e, c, _ = translation_field(wall=wall, plus=plus, minus=minus)
    loaded, other = (6.0 * b * r + 2.0 * e / r**3 - (wall.kolosov - 1.0) * c / r for r in (1.0, wall.ratio))
    nothing = xp.zeros_like(xp.asarray(other))
    return _Modes(xp.asarray(loaded) - closed, xp.asarray(other), nothing, nothing)


def _field(wall: Wall, mode: Array, alone: bool, plus: float, minus: float, closed: float) -> _Modes:
    """Stresses of all modes; of the loaded rim without the closed part, which is the same for every mode."""
    modes = _modes(wall, mode[1:] if alone else mode, plus, minus)
    if not alone:
        return modes
    first = _first_mode(wall, plus, minus, closed)
    shape = modes.hoop.shape[1:]
    return _Modes(
        *(
            xp.concatenate([xp.broadcast_to(one, (1, *shape)), rest])
            for one, rest in zip(first, modes, strict=True)
        )
    )


def rim_stresses(*, body: Annulus, loads: RimLoads, fineness: int = 1) -> RimStresses:
    r"""Stresses along both rims at points that divide one sector, at its contacts and midway between them.

    .. math::
        \sigma(\theta) = \frac{m}{\pi R L} \sum_j \left[ F^r_j \left(\tfrac12 h^r_0 + \sum_{n = m, 2m, \dots} h^r_n
        \cos n(\theta - \varphi_j)\right) - F^t_j \sum_{n = m, 2m, \dots} h^t_n \sin n(\theta - \varphi_j) \right]

    Parameters
    ----------
    body : Annulus
        The body, with m equal sectors; numbers may be arrays along trailing batch axes. Its other rim must be free if
        it has one sector only.
    loads : RimLoads
        Its contacts and their forces [N].
    fineness : int, optional
        Points and modes of a body of one sector over those of a sector: the number of its unlike sectors [-].

    Returns
    -------
    RimStresses
        At all points [Pa]. nan where the wall is too thin for the number of modes: below about 2 % of the radius for
        three sectors, 7 % for one.

    Notes
    -----
    The forces are those of points: on the loaded rim they hold :data:`CLEARANCE` half-widths away from the contacts,
    where the stress is that of the contact itself. Unbalanced forces as in
    :func:`~asperity.body.compliance.compliance_matrix`. The number of sectors is not differentiated.

    References
    ----------
    Equations (E2) and (E4) of :doc:`/equations`.
    """
    wall, alone = wall_of(body), loads.sectors is None
    side = wall.side
    sectors = without_slopes(xp.asarray(1.0 if loads.sectors is None else loads.sectors))
    rank = loads.radial.ndim - 1

    def along(numbers: np.ndarray) -> Array:
        return xp.asarray(numbers.reshape(numbers.shape + (1,) * rank))

    numbers = np.arange(1, fineness * MODES + 1, dtype=float)
    steps = np.arange(fineness * POINTS) / (fineness * POINTS)
    mode = sectors * along(numbers)
    push, drag = (_field(wall, mode, alone, *forces) for forces in ((1.0, 1.0, side), (side, -side, 2.0)))
    radial, tangential = loads.radial[:, None], loads.tangential[:, None]
    cosine, sine = xp.cos(mode * loads.angles[:, None]), xp.sin(mode * loads.angles[:, None])

    period = 2.0 * math.pi / sectors
    others = _others(loads)
    # its table as numbers would be most of the program
    turns = 2.0 * math.pi * xp.outer(xp.asarray(steps), xp.asarray(numbers))
    table = xp.cos(turns), xp.sin(turns)
    phase = mode * others[:, None]

    def series(even: Array, odd: Array) -> Array:
        """Sum of even cos + odd sin over the modes, at the points of the grid by tables and at the others."""
        grid = xp.tensordot(table[0], even, axes=1) + xp.tensordot(table[1], odd, axes=1)
        rest = xp.sum(xp.cos(phase) * even + xp.sin(phase) * odd, axis=1)
        return xp.concatenate([grid, xp.broadcast_to(rest, (rest.shape[0], *grid.shape[1:]))])

    def stress(along_push: Array, along_drag: Array) -> Array:
        """Of a component that is even in the angle from a radial force."""
        pushed, dragged = radial * along_push, tangential * along_drag
        return series(
            xp.sum(pushed * cosine + dragged * sine, axis=0),
            xp.sum(pushed * sine - dragged * cosine, axis=0),
        )

    def shear(along_push: Array, along_drag: Array) -> Array:
        """Of a component that is odd in it."""
        pushed, dragged = radial * along_push, tangential * along_drag
        return series(
            xp.sum(dragged * cosine - pushed * sine, axis=0),
            xp.sum(dragged * sine + pushed * cosine, axis=0),
        )

    places = places_of(loads, fineness)
    away = places[:, None] - loads.angles
    half = 0.5 * sectors * away
    touches = xp.abs(xp.sin(half)) < 1e-9
    cotangent = xp.where(touches, 0.0, xp.cos(half) / xp.where(touches, 1.0, xp.sin(half)))
    total = xp.sum(loads.radial, axis=0)
    even, odd = uniform_field(wall)
    closed = 0.5 * side * (even - odd - 1.0) * total - xp.sum(cotangent * loads.tangential, axis=1)
    distance = xp.abs(xp.mod(away + 0.5 * period, period) - 0.5 * period) * loaded_radius(body)
    beside = xp.all(distance > CLEARANCE * loads.half_widths, axis=1)
    twist = xp.where(wall.tangential[1] > 0.0, 0.5 * side / wall.ratio**2, 0.0) * xp.sum(
        loads.tangential, axis=0
    )
    scale = sectors / (math.pi * loaded_radius(body) * body.length)
    scale = xp.where(_resolved(wall, sectors, fineness), scale, xp.nan)
    return RimStresses(
        loaded_hoop=xp.where(beside, scale * (closed + stress(push.loaded, drag.loaded)), xp.nan),
        other_hoop=scale * (0.5 * side * (even - odd / wall.ratio**2) * total + stress(push.hoop, drag.hoop)),
        other_radial=scale
        * (0.5 * side * (even + odd / wall.ratio**2) * total + stress(push.radial, drag.radial)),
        other_shear=scale * (twist + shear(push.shear, drag.shear)),
    )


def _others(loads: RimLoads) -> Array:
    """Contacts of a sector, and the places midway between them."""
    sectors = without_slopes(xp.asarray(1.0 if loads.sectors is None else loads.sectors))
    middle = xp.mean(loads.angles, axis=0, keepdims=True)
    return xp.concatenate([loads.angles, middle, middle + math.pi / sectors])


def places_of(loads: RimLoads, fineness: int = 1) -> Array:
    """Polar angles of the points of :func:`rim_stresses`.

    Parameters
    ----------
    loads : RimLoads
        The contacts.
    fineness : int, optional
        As of :func:`rim_stresses` [-].

    Returns
    -------
    Array
        Angles, shape (points, ...) [rad].
    """
    sectors = without_slopes(xp.asarray(1.0 if loads.sectors is None else loads.sectors))
    others = _others(loads)
    steps = (np.arange(fineness * POINTS) / (fineness * POINTS)).reshape((-1,) + (1,) * (others.ndim - 1))
    grid = xp.asarray(steps) * (2.0 * math.pi / sectors)
    shape = xp.broadcast_shapes(grid.shape[1:], others.shape[1:])
    return xp.concatenate([xp.broadcast_to(part, (part.shape[0], *shape)) for part in (grid, others)])


def _resolved(wall: Wall, sectors: Array, fineness: int) -> Array:
    """Whether the modes left out are a small share of the stress of the other rim, which is as n^2 times the decay."""
    decay, last = wall.ratio**wall.side, fineness * MODES * sectors
    share = last**2 * decay**last * (1.0 - decay) ** 3 * sectors / (2.0 * (1.0 - decay**sectors))
    return share < _OMITTED


class RimRange(NamedTuple):
    """What a point of either rim goes through, inner rim first, shape (2, ...); and the worst of both.

    Parameters
    ----------
    largest, mean, amplitude : Array
        Largest hoop stress, tension positive, and mean and amplitude between the largest and the smallest [Pa].
    mises : Array
        Largest equivalent stress by von Mises on both rims, shape (...) [Pa].
    pull : Array
        Largest radial stress of the rim without contacts, tension positive, shape (...) [Pa].
    """

    largest: Array
    mean: Array
    amplitude: Array
    mises: Array
    pull: Array


def rim_range(*, body: Annulus, stresses: RimStresses) -> RimRange:
    r"""Range of the hoop stress along each rim, which every point of it goes through as the contacts pass.

    .. math::
        \sigma_m = \tfrac12(\sigma_{max} + \sigma_{min}), \qquad \sigma_a = \tfrac12(\sigma_{max} - \sigma_{min})

    Parameters
    ----------
    body : Annulus
        The body.
    stresses : RimStresses
        Its stresses [Pa].

    Returns
    -------
    RimRange
        Of both rims [Pa], the loaded one away from its contacts.

    References
    ----------
    Equation (L3) of :doc:`/equations`.
    """
    loaded, other = stresses.loaded_hoop, stresses.other_hoop
    hidden = xp.isnan(loaded) & ~xp.all(xp.isnan(loaded), axis=0)
    high = xp.max(xp.where(hidden, -xp.inf, loaded), axis=0), xp.max(other, axis=0)
    low = xp.min(xp.where(hidden, xp.inf, loaded), axis=0), xp.min(other, axis=0)
    worst = xp.maximum(
        xp.max(xp.where(hidden, 0.0, _mises(body, loaded, 0.0, 0.0)), axis=0),
        xp.max(_mises(body, other, stresses.other_radial, stresses.other_shear), axis=0),
    )
    order = slice(None) if body.loaded_rim == "inner" else slice(None, None, -1)
    highest, lowest = xp.stack(high[order]), xp.stack(low[order])
    return RimRange(
        highest,
        0.5 * (highest + lowest),
        0.5 * (highest - lowest),
        worst,
        xp.max(stresses.other_radial, axis=0),
    )


def _mises(body: Annulus, hoop: Array, radial: Real, shear: Real) -> Array:
    return mises_stress(
        first=hoop, second=radial, shear=shear, poisson_ratio=body.poisson_ratio, plane_state=body.plane_state
    )


def mises_stress(
    *, first: Real, second: Real, shear: Real, poisson_ratio: Real, plane_state: PlaneState
) -> Array:
    r"""Equivalent stress of a plane state of stress.

    .. math::
        \sigma_v^2 = \sigma_1^2 + \sigma_2^2 + \sigma_3^2 - \sigma_1\sigma_2 - \sigma_2\sigma_3 - \sigma_3\sigma_1
        + 3\tau^2, \qquad \sigma_3 = \nu(\sigma_1 + \sigma_2) \text{ or } 0

    Parameters
    ----------
    first, second, shear : Real
        Normal stresses and shear stress in the plane [Pa].
    poisson_ratio : Real
        Poisson's ratio [-].
    plane_state : {"plane_strain", "plane_stress"}
        Whether there is no strain or no stress along the axis.

    Returns
    -------
    Array
        Equivalent stress [Pa].

    References
    ----------
    R. von Mises, Nachr. Ges. Wiss. Göttingen, 1913, 582.
    """
    third = poisson_ratio * (first + second) if plane_state == "plane_strain" else 0.0
    square = (
        first**2 + second**2 + third**2 - first * second - second * third - third * first + 3.0 * shear**2
    )
    nothing = xp.asarray(square) <= 0.0  # rounding
    return xp.where(nothing, 0.0, xp.sqrt(xp.where(nothing, 1.0, square)))


def fatigue_safety(*, mean: Real, amplitude: Real, fatigue_strength: Real, strength: Real) -> Array:
    r"""Safety against fatigue by the straight line of Haigh's diagram.

    .. math:: \frac1S = \frac{\sigma_a}{\sigma_W} + \frac{\max(\sigma_m, 0)}{R}

    Parameters
    ----------
    mean, amplitude : Real
        Mean and amplitude of the stress [Pa].
    fatigue_strength : Real
        Amplitude :math:`\sigma_W` that the part endures at a mean stress of zero [Pa].
    strength : Real
        R: tensile strength (Goodman), or yield strength (Soderberg, on the safe side) [Pa].

    Returns
    -------
    Array
        Safety [-], for mean and amplitude that grow together. A compressive mean is not counted as a help.

    References
    ----------
    J. Goodman, Mechanics Applied to Engineering, 1899; C. R. Soderberg, Trans. ASME 52 (1930) APM-52-2; equation (L3)
    of :doc:`/equations`.

    Examples
    --------
    >>> float(fatigue_safety(mean=100e6, amplitude=100e6, fatigue_strength=400e6, strength=800e6))
    2.6666666666666665
    """
    return 1.0 / xp.asarray(amplitude / fatigue_strength + xp.maximum(mean, 0.0) / strength)

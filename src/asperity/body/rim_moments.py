r"""Kernels of a rim that depend on its geometry only, and the moments of the contacts that weight them.

The displacement of one contact under the load of another is the mean of a kernel :math:`f(\theta)` over both punch
pressures. Away from the loaded rim, and from other contacts, the kernel is smooth:

.. math::
    \overline{f(\theta + \xi)} = \sum_{k\ge0} \frac{\overline{\xi^{2k}}}{(2k)!}\, f^{(2k)}(\theta), \qquad
    \frac{\overline{\xi^{2k}}}{(2k)!} = \frac1{4^k} \sum_{j=0}^k \frac{\alpha^{2j}\beta^{2k-2j}}{j!^2\,(k-j)!^2} .

The load changes the moments only. The derivatives of the kernel, with all sums over modes and over equal sectors, are
those of the unloaded machine: in a batch of loads they are found once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from asperity.body.annulus_modes import Wall, added_compliance
from asperity.body.rigid_modes import translation_compliance
from asperity.body.rim_kernel import separated_derivatives
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import while_loop
from asperity.engine.derivatives import value_and_slopes, with_rule
from asperity.types import Array, Real

#: Moments that are used, from the zeroth on.
MOMENTS = 5
#: Half-width over wall thickness up to which they suffice, with an error of 1e-7 of a compliance.
WIDEST_CONTACT = 0.2
#: Largest number of equal sectors.
MOST_SECTORS = 100
#: Share of the first omitted mode, below which the sum ends.
_OMITTED = 1e-11
_CHUNK, _CHUNKS = 8, 128
#: Even derivatives of the closed sums that are used.
_CLOSED = 3


class RimKernel(NamedTuple):
    """Even derivatives of the displacements under unit forces, by the angle; shape (derivatives, places, ...).

    Parameters
    ----------
    radial, tangential : Array
        Along the force, in units of 1/(4 pi G L) [-].
    coupling : Array
        Radial under tangential; odd in the angle [-].
    """

    radial: Array
    tangential: Array
    coupling: Array


def weighted_mean(kernel: Array, square_1: Array, square_2: Array) -> Array:
    r"""Mean of a kernel over the pressures of two punches.

    .. math::
        \overline{f(\theta + \xi)} = \sum_{j,k} \frac{(\alpha/2)^{2j}}{j!^2} \frac{(\beta/2)^{2k}}{k!^2} f^{(2j+2k)}

    Parameters
    ----------
    kernel : Array
        Even derivatives, the first :data:`MOMENTS`, shape (derivatives, ...) [-].
    square_1, square_2 : Array
        Squares of the half-widths over the radius, shape (...) [-].

    Returns
    -------
    Array
        Mean, shape (...) [-].

    References
    ----------
    Moments of the arcsine distribution, :math:`\overline{x^{2j}} = \binom{2j}{j} (\alpha/2)^{2j}`.
    """
    first: list[Array] = []
    second: list[Array] = []
    for powers, square in ((first, 0.25 * square_1), (second, 0.25 * square_2)):
        powers.append(square)
        for order in range(2, MOMENTS):
            powers.append(powers[-1] * square * (1.0 / order**2))
    total = kernel[0]
    for order in range(1, MOMENTS):
        weight = first[order - 1] + second[order - 1]
        for j in range(1, order):
            weight = weight + first[j - 1] * second[order - j - 1]
        total = total + weight * kernel[order]
    return total


def closed_kernel(*, angle: Array, plus: Real, minus: Real, sectors: Array) -> RimKernel:
    """Kernel of discs, or of holes in infinite plates, summed over the equal sectors of a machine.

    Parameters
    ----------
    angle : Array
        Angles between the contacts of one sector, shape (places, ...) [rad]. 0 for a contact itself, whose own
        pressure is left out.
    plus, minus : Real
        Weights of the sums over 1/(n+1) and 1/(n-1): Kolosov's constant and 1 for a disc, 1 and Kolosov's constant for
        a hole, shape (places, ...) [-].
    sectors : Array
        Number of sectors, 1 for a body of one sector, shape (places, ...) [-].

    Returns
    -------
    RimKernel
        Without uniform pressure and without the far rim of an annulus.

    References
    ----------
    Equations (E1) and (E2) of :doc:`/equations`.
    """
    numbers = xp.broadcast_arrays(*(xp.asarray(number, float) for number in (angle, plus, minus, sectors)))

    def of_sector(
        index: Array, angle: Array, plus: Array, minus: Array, sectors: Array
    ) -> tuple[Array, Array]:
        separated = (index < sectors) & ((index > 0) | (angle != 0.0))
        turn = 2.0 * math.pi / sectors
        sums = separated_derivatives(xp.where(separated, angle + turn * index, math.pi))
        straight = plus * sums.cosine_plus + minus * sums.cosine_minus
        crossed = plus * sums.sine_plus - minus * sums.sine_minus
        return xp.where(separated, straight, 0.0), xp.where(separated, crossed, 0.0)

    def unfinished(index: Array, angle: Array, plus: Array, minus: Array, sectors: Array) -> Array:
        return (index < MOST_SECTORS) & (index < sectors)

    straight, crossed = _summed(of_sector, unfinished, (_CLOSED, _CLOSED), numbers)
    none = xp.zeros((MOMENTS - _CLOSED, *numbers[0].shape))
    straight, crossed = xp.concatenate([straight, none]), xp.concatenate([crossed, none])
    return RimKernel(straight, straight, crossed)


def _summed(
    term: Callable[..., tuple[Array, ...]],
    unfinished: Callable[..., Array],
    rows: tuple[int, ...],
    numbers: Sequence[Array],
    fixed: tuple[Array, ...] = (),
) -> tuple[Array, ...]:
    """Sums of terms 0, 1, ... while any is unfinished, of numbers of one shape, with derivatives in both modes.

    A term has parts of as many ``rows``. The sums at one place depend on the numbers at that place only; ``fixed``
    numbers follow these, without derivatives. The functions close over no array: derivatives call them later.
    """
    count = len(numbers)

    def total(*given: Array) -> tuple[Array, ...]:
        def going(state: tuple[Array, tuple[Array, ...]]) -> Array:
            return xp.any(unfinished(state[0], *given))

        def added(state: tuple[Array, tuple[Array, ...]]) -> tuple[Array, tuple[Array, ...]]:
            index, sums = state
            parts = term(index, *given)
            return index + 1.0, tuple(one + part for one, part in zip(sums, parts, strict=True))

        zero = tuple(xp.zeros((size, *given[0].shape)) for size in rows)
        return while_loop(going, added, (xp.zeros(()), zero))[1]

    of_numbers = with_rule(total)

    @of_numbers.defjvp
    def derivative(primals: tuple[Array, ...], tangents: tuple[Array, ...]) -> tuple[Any, Any]:
        moving, still = primals[:count], primals[count:]

        directions = [
            tuple(xp.ones_like(moved) if i == k else xp.zeros_like(moved) for i, moved in enumerate(moving))
            for k in range(count)
        ]
        sums, slopes = value_and_slopes(lambda *moved: total(*moved, *still), moving, directions)
        return sums, trees.map(lambda *by: sum(map(xp.multiply, by, tangents[:count])), *slopes)

    return of_numbers(*numbers, *fixed)


def walls_resolved(*, ratio: Real, sectors: Real, one_sector: bool) -> Array:
    """Whether the modes of :func:`other_rim` suffice for a wall.

    Parameters
    ----------
    ratio : Real
        Inner over outer radius [-].
    sectors : Real
        Number of equal sectors that load the annulus [-].
    one_sector : bool
        Whether it belongs to one sector only.

    Returns
    -------
    Array
        Truth values: walls from about 1 % of the radius on, from 2 % for a body of one sector.

    References
    ----------
    Equation (E2) of :doc:`/equations`.
    """
    first, step = (2.0, 1.0) if one_sector else (sectors, sectors)
    return xp.asarray(_omitted(first + step * (_CHUNK * _CHUNKS), ratio) <= _OMITTED)


def _omitted(mode: Real, rate: Real) -> Real:
    """Share of a mode in the compliance of an annulus."""
    return mode**2 * rate ** (2.0 * mode)


def other_rim(*, wall: Wall, angle: Array, sectors: Array, one_sector: np.ndarray) -> RimKernel:
    r"""Contribution of the far rim of annuli: the modes n >= 1, summed until the rest is negligible.

    .. math:: \sum_n (-n^2)^k\, H_n \cos n\Delta, \qquad n = m, 2m, \dots \text{ or } 2, 3, \dots

    Parameters
    ----------
    wall : Wall
        The annuli, shape (places, ...).
    angle : Array
        Angles between the contacts, 0 for a contact itself, shape (places, ...) [rad].
    sectors : Array
        Number m of equal sectors that load the annulus, 1 for one [-].
    one_sector : ndarray
        Whether an annulus belongs to one sector only, shape (places, 1, ...).

    Returns
    -------
    RimKernel
        For all sectors together; nan where the wall is so thin that the modes do not suffice.

    References
    ----------
    Equation (E2) of :doc:`/equations`.
    """
    shapes = [xp.shape(leaf) for leaf in (*trees.leaves(wall), sectors, one_sector)]
    shape = xp.broadcast_shapes(angle.shape, *shapes)
    given = (angle, sectors, wall.ratio, wall.kolosov, *wall.radial, *wall.tangential)
    numbers = [xp.broadcast_to(xp.asarray(number, float), shape) for number in given]

    def first_of(sectors: Array) -> Array:
        return xp.where(one_sector, 2.0, sectors)

    def left(chunk: Array, _: Array, sectors: Array, ratio: Array, *others: Array) -> Array:
        """Share of the first mode of a chunk."""
        return xp.asarray(_omitted(first_of(sectors) + sectors * (_CHUNK * chunk), ratio ** others[-1]))

    def unfinished(chunk: Array, *numbers: Array) -> Array:
        return (chunk < _CHUNKS) & (left(chunk, *numbers) > _OMITTED)

    def of_chunk(chunk: Array, angle: Array, sectors: Array, *of_wall: Array) -> tuple[Array, Array, Array]:
        ratio, kolosov, radial, radial_fixed, tangential, tangential_fixed, side = of_wall
        index = chunk * _CHUNK + np.arange(float(_CHUNK)).reshape((-1,) + (1,) * len(shape))
        mode = first_of(sectors) + sectors * index
        walls = Wall(side, ratio, kolosov, (radial, radial_fixed), (tangential, tangential_fixed))
        added = added_compliance(mode=mode, decay=ratio ** (side * mode), wall=walls)
        square = -(mode**2)
        power = xp.stack([square**order for order in range(MOMENTS)])
        cosine, sine = xp.cos(mode * angle), xp.sin(mode * angle)
        parts = (added.radial * cosine, added.tangential * cosine, added.coupling * sine)
        return xp.sum(power * parts[0], 1), xp.sum(power * parts[1], 1), xp.sum(power * parts[2], 1)

    side = xp.broadcast_to(xp.asarray(wall.side, float), shape)
    total = _summed(of_chunk, unfinished, (MOMENTS,) * 3, numbers, (side,))
    converged = left(xp.asarray(float(_CHUNKS)), *numbers, side) <= _OMITTED
    total = RimKernel(*(xp.where(converged, sectors * part, xp.nan) for part in total))
    if not one_sector.any():
        return total
    moved = translation_compliance(wall)
    sign = (one_sector * 1.0) * ((-1.0) ** np.arange(MOMENTS)).reshape((-1,) + (1,) * len(shape))
    turned = xp.cos(angle), xp.cos(angle), xp.sin(angle)
    return RimKernel(
        *(part + sign * (mode * turn) for part, mode, turn in zip(total, moved, turned, strict=True))
    )

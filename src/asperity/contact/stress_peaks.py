"""Largest stresses under a line contact in full slip, located in the exact field without interpolation; slow."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from asperity.contact.subsurface_stress import PlaneStress, pressure_stress, traction_stress
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import fori_loop, traced_once, vectorised
from asperity.engine.derivatives import jacobian
from asperity.engine.module import Module
from asperity.types import Array, Real

#: A squared stress over (place, friction, Poisson's ratio).
Square = Callable[[Array, Array, Array], Array]

#: Steps in friction from 0, Newton steps at each of them and at the last; residual of the gradient.
_FRICTION_STEPS, _NEWTON_STEPS, _LAST_STEPS, _RESIDUAL = 24, 3, 10, 1e-10

#: Friction coefficient up to which the peaks below the surface are tabulated. The peak of the orthogonal shear is
#: overtaken by the surface at 0.3669; that of Mises between 0 and 0.378, growing with Poisson's ratio.
SHEAR_FRICTION = 0.37
#: Poisson's ratios of the table of the Mises peak; below 0.194 first yield is at the surface for all friction.
POISSON_RANGE = (0.19, 0.5)


class StressPeak(Module):
    """A largest stress below the surface, over the peak pressure, and where it is, over the half-width.

    Parameters
    ----------
    stress : Array
        Stress over p_0 [-].
    position, depth : Array
        x/a, positive in the direction of the traction on the body, and z/a [-].
    solved : Array
        True where it is a maximum below the surface [-].
    """

    stress: Array
    position: Array
    depth: Array
    solved: Array


def full_slip_stress(*, position: Real, depth: Real, friction_coefficient: Real) -> PlaneStress:
    r"""Stresses under full slip, with the peak pressure and the half-width as units.

    Parameters
    ----------
    position, depth : Real
        x/a and z/a [-].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    PlaneStress
        Stresses over p_0.

    References
    ----------
    Equation (B5) of :doc:`/equations`.
    """
    pressed = pressure_stress(position=position, depth=depth, half_width=1.0, peak_pressure=1.0)
    pulled = traction_stress(
        position=position, depth=depth, centre=0.0, half_width=1.0, peak_traction=friction_coefficient
    )
    return trees.map(lambda a, b: a + b, pressed, pulled)


def mises_friction(poisson_ratio: Real) -> Real:
    r"""Friction coefficient up to which the Mises peak below the surface is tabulated, :math:`0.34 + 0.129(\nu-0.19)`.

    Parameters
    ----------
    poisson_ratio : Real
        nu [-].

    Returns
    -------
    Real
        Friction coefficient [-]; the surface has overtaken the peak before it.

    References
    ----------
    A choice; the test of :mod:`asperity.contact.shakedown` finds no peak above the surface's value beyond it.
    """
    return 0.34 + 0.129 * (poisson_ratio - 0.19)


@partial(traced_once, fixed=("square",))
def _peaks(square: Square, frictions: Array, poissons: Array, start: Array) -> StressPeak:
    """Follow a maximum of a squared stress from zero friction to each requested friction coefficient."""

    def one(friction: Array, poisson: Array) -> StressPeak:
        def shape(place: Array, level: Array) -> tuple[Array, Array, Array]:
            """Slope, second derivatives and their determinant."""
            slope = jacobian(lambda at: square(at, level, poisson), place)
            bend = jacobian(lambda at: jacobian(lambda near: square(near, level, poisson), at), place)
            return slope, bend, bend[0, 0] * bend[1, 1] - bend[0, 1] ** 2

        def newton(_: int, state: tuple[Array, Array]) -> tuple[Array, Array]:
            place, level = state
            slope, bend, determinant = shape(place, level)
            across = bend[1, 1] * slope[0] - bend[0, 1] * slope[1]
            down = bend[0, 0] * slope[1] - bend[0, 1] * slope[0]
            return place - xp.stack([across, down]) / determinant, level

        def follow(count: Array, place: Array) -> Array:
            level = friction * count / _FRICTION_STEPS
            return fori_loop(0, _NEWTON_STEPS, newton, (place, level))[0]

        place = fori_loop(0, _FRICTION_STEPS, follow, start)
        place, _ = fori_loop(0, _LAST_STEPS, newton, (place, friction))
        slope, bend, determinant = shape(place, friction)
        highest = (determinant > 0.0) & (bend[0, 0] < 0.0)
        return StressPeak(
            stress=xp.sqrt(square(place, friction, poisson)),
            position=place[0],
            depth=place[1],
            solved=(xp.max(xp.abs(slope)) < _RESIDUAL) & highest & (place[1] > 0.0),
        )

    return vectorised(one)(frictions, poissons)


def _peak(square: Square, friction: Real, poisson: Real, start: tuple[float, float]) -> StressPeak:
    frictions, poissons = xp.broadcast_arrays(xp.asarray(friction, float), xp.asarray(poisson, float))
    peaks = _peaks(square, frictions.ravel(), poissons.ravel(), xp.asarray(start))
    return trees.map(lambda leaf: leaf.reshape(frictions.shape), peaks)


def _shear_square(place: Array, friction: Array, _: Array) -> Array:
    return full_slip_stress(position=place[0], depth=place[1], friction_coefficient=friction).shear ** 2


def _mises_square(place: Array, friction: Array, poisson: Array) -> Array:
    stress = full_slip_stress(position=place[0], depth=place[1], friction_coefficient=friction)
    in_plane = 0.25 * (stress.longitudinal - stress.normal) ** 2 + stress.shear**2
    out_of_plane = (1.0 - 2.0 * poisson) * 0.5 * (stress.longitudinal + stress.normal)
    return in_plane + out_of_plane**2 / 3.0


def shear_peak(*, friction_coefficient: Real) -> StressPeak:
    r"""Largest orthogonal shear stress :math:`|\tau_{xz}|/p_0` below the surface under full slip.

    Parameters
    ----------
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    StressPeak
        0.25 at (0.866, 0.5) without friction.

    References
    ----------
    A maximum of equation (B5) of :doc:`/equations`.
    """
    return _peak(_shear_square, friction_coefficient, 0.0, (0.866, 0.5))


def mises_peak(*, friction_coefficient: Real, poisson_ratio: Real) -> StressPeak:
    r"""Largest :math:`\sqrt{J_2}/p_0` below the surface under full slip, which is Mises' stress over :math:`\sqrt3`.

    Parameters
    ----------
    friction_coefficient : Real
        mu [-].
    poisson_ratio : Real
        nu [-]; with 0.5 it is the largest shear stress in the plane.

    Returns
    -------
    StressPeak
        0.322 at (0, 0.704) without friction for nu = 0.3.

    References
    ----------
    A maximum of equation (B5) of :doc:`/equations`.
    """
    return _peak(_mises_square, friction_coefficient, poisson_ratio, (0.0, 0.7))


def fitted_coefficients(*, shear_terms: int, mises_terms: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    r"""Chebyshev coefficients of the limits that the peaks set, as :mod:`asperity.contact.shakedown_table` holds them.

    Parameters
    ----------
    shear_terms : int
        Number of coefficients of the first.
    mises_terms : tuple of int
        Rows and columns of the second.

    Returns
    -------
    tuple of ndarray
        Of :math:`p_0/|\tau_{xz}|` over friction, and of :math:`p_0/\sqrt{J_2}` over the square of friction (rows) and
        Poisson's ratio (columns) [-].

    Raises
    ------
    ArithmeticError
        Where a peak was not found.

    References
    ----------
    Interpolation at Chebyshev's nodes of equations (B6) of :doc:`/equations`.
    """

    def nodes(count: int) -> np.ndarray:
        return np.cos(np.pi * (np.arange(count) + 0.5) / count)

    def transform(values: np.ndarray) -> np.ndarray:
        count = values.shape[0]
        terms = np.cos(np.pi * np.outer(np.arange(count), np.arange(count) + 0.5) / count)
        return (2.0 - (np.arange(count) == 0))[:, None] / count * (terms @ values.reshape(count, -1))

    shear = shear_peak(friction_coefficient=xp.asarray(SHEAR_FRICTION * 0.5 * (nodes(shear_terms) + 1.0)))
    low, high = POISSON_RANGE
    poisson = xp.asarray(low + (high - low) * 0.5 * (nodes(mises_terms[1]) + 1.0))
    share = xp.asarray(np.sqrt(0.5 * (nodes(mises_terms[0]) + 1.0)))
    mises = mises_peak(friction_coefficient=share[:, None] * mises_friction(poisson), poisson_ratio=poisson)
    if not (bool(xp.all(shear.solved)) and bool(xp.all(mises.solved))):
        raise ArithmeticError("a largest stress was not found: the range of the table is too wide")
    first = transform(1.0 / np.asarray(shear.stress))[:, 0]
    return first, transform(transform(1.0 / np.asarray(mises.stress)).T).T

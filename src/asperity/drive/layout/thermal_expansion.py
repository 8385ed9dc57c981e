r"""Interference and temperature: the sizes of the bodies change, each by its own coefficient of expansion.

A uniform change of temperature strains every free body by :math:`\alpha \Delta T` in all directions. What that adds to
the interference follows from virtual work, as for any other change of the sizes
(:func:`asperity.drive.layout.expansion.interference_of_sizes`). A drive of one material throughout keeps its
interference.
"""

from __future__ import annotations

import math
from typing import Literal

import jax.numpy as jnp
from jax import Array

from asperity.types import Real


def ring_expansion(
    *,
    ring: Real,
    housing: Real,
    inner_radius: Real,
    wall_thickness: Real,
    youngs_modulus: Real,
    poisson_ratio: Real,
    housing_stiffness: Real,
    plane_state: Literal["plane_strain", "plane_stress"],
) -> Array:
    r"""Expansion coefficient of the inner radius of a ring that a housing of another material holds.

    .. math::
        \alpha = \alpha_r + (\alpha_h - \alpha_r)\, \frac{k c}{1 + k c}\, \frac{2}{1 - \nu + (1 + \nu)\,a^2/b^2},
        \qquad c = \frac{b}{E}\, \frac{(1 - \nu)\,b^2 + (1 + \nu)\,a^2}{b^2 - a^2}

    Parameters
    ----------
    ring, housing : Real
        Expansion coefficients of both [1/K].
    inner_radius, wall_thickness : Real
        Inner radius a and wall b − a of the ring [m].
    youngs_modulus, poisson_ratio : Real
        E [Pa] and nu [-] of the ring.
    housing_stiffness : Real
        Pressure over radial displacement k of the housing [N/m^3]: 0 for a ring that carries itself, ``math.inf`` for a
        rigid housing, which moves the outer rim as it expands itself.
    plane_state : {"plane_strain", "plane_stress"}
        Of the ring; in plane strain E/(1 − nu^2) and nu/(1 − nu) take the place of E and nu.

    Returns
    -------
    Array
        Change of the inner radius over radius and temperature [1/K].

    Notes
    -----
    The outer rim of the ring stays on the housing, which therefore must press or hold it at every temperature. A thick
    ring pulled by its housing widens by more than the housing does, as every hole in a stretched plate does.

    References
    ----------
    Equation (I2) of :doc:`/equations`; Lamé's solution with a free inner rim, S. P. Timoshenko and J. N. Goodier,
    Theory of Elasticity, 3rd ed. 1970, section 28.
    """
    outer = inner_radius + wall_thickness
    modulus, poisson = youngs_modulus, poisson_ratio
    if plane_state == "plane_strain":
        modulus, poisson = modulus / (1.0 - poisson**2), poisson / (1.0 - poisson)
    squared = (inner_radius / outer) ** 2
    narrowing = 1.0 - poisson + (1.0 + poisson) * squared
    compliance = outer / modulus * narrowing / (1.0 - squared)
    rigid = jnp.isinf(jnp.asarray(housing_stiffness))
    held = jnp.where(rigid, 0.0, housing_stiffness) * compliance
    share = jnp.where(rigid, 1.0, held / (1.0 + held))
    return jnp.asarray(ring + (housing - ring) * share * 2.0 / narrowing)


def loosening_rise(*, interference: Real, change_per_kelvin: Real) -> Array:
    r"""Rise of temperature at which a drive has no interference, :math:`-\delta/(\mathrm{d}\delta/\mathrm{d}T)` [K].

    From the interference at the assembly [m] and what a kelvin adds to it [m/K]; of either sign, infinite for a drive
    that temperature does not change. Equation (I2) of :doc:`/equations`, which is linear in the temperature.
    """
    moves = jnp.asarray(change_per_kelvin) != 0.0
    return jnp.where(moves, -interference / jnp.where(moves, change_per_kelvin, 1.0), math.inf)

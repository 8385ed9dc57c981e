"""Steady rolling of unlike bodies, whose pressure and traction are coupled."""

from __future__ import annotations

import jax.numpy as jnp
from jax.typing import ArrayLike

from asperity.bem.elastic_pair import positive
from asperity.bem.free_half_space import FreeHalfSpace
from asperity.bem.half_space import field_on_grid
from asperity.bem.normal_contact import NormalContact, normal_contact
from asperity.bem.steady_rolling import SteadyRolling, steady_rolling
from asperity.engine.module import Module, static
from asperity.errors import NoSolutionError


class CoupledSteadyRolling(Module):
    """Steady rolling with its pressure: both states, each under the other's, after so many alternating solutions."""

    rolling: SteadyRolling
    contact: NormalContact
    alternations: int = static()


def coupled_steady_rolling(
    half_space: FreeHalfSpace,
    heights: ArrayLike,
    *,
    normal_force: float,
    friction_coefficient: float,
    layer_compliance: ArrayLike,
    longitudinal_creepage: float | None = None,
    longitudinal_force: float | None = None,
    lateral_creepage: float | None = None,
    lateral_force: float | None = None,
    tolerance: float = 1e-8,
    max_alternations: int = 50,
) -> CoupledSteadyRolling:
    r"""Steady rolling of unlike bodies with coupled pressure and traction.

    .. math::
        u_z = \frac2E\left[K * p\right] + \frac{\beta}{E} \int \operatorname{sgn}(x - s)\,\tau_x\,\mathrm ds,
        \qquad
        u_x = \frac2E\left[K * \tau_x\right] - \frac{\beta}{E} \int \operatorname{sgn}(x - s)\,p\,\mathrm ds

    The normal and the tangential problem are solved alternately until the pressure converges (Panagiotopoulos).

    Parameters
    ----------
    half_space : FreeHalfSpace
        Elastic bodies and grid of one axis.
    heights : array, shape (points,)
        Height of one body towards the other, summits positive [m].
    normal_force : float
        Load [N/m], positive.
    friction_coefficient : float
        Coulomb's coefficient mu [-], positive.
    layer_compliance : array, scalar or shape (points,)
        Tangential displacement per traction of a thin layer between the bodies [m/Pa]; 0 for none.
    longitudinal_creepage, longitudinal_force, lateral_creepage, lateral_force : float, optional
        As for :func:`~asperity.bem.steady_rolling.steady_rolling`.
    tolerance : float
        Bound on the change of the pressure from one alternation to the next, relative to its peak [-].
    max_alternations : int
        Maximum number of alternations.

    Returns
    -------
    CoupledSteadyRolling
        Tangential and normal state.

    Raises
    ------
    InputError
        As for :func:`~asperity.bem.steady_rolling.steady_rolling` and
        :func:`~asperity.bem.normal_contact.normal_contact`.
    NoSolutionError
        If one of the problems or their alternation does not converge.

    Notes
    -----
    With the first body below its common surface, ``dundurs_constant`` positive and rolling towards the end of
    the grid, free rolling has a positive creepage.

    References
    ----------
    R. H. Bentall and K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389. P. D. Panagiotopoulos, Ing.-Arch. 44
    (1975) 421. K. L. Johnson, Contact Mechanics, 1985, sections 2.8 and 8.2.
    """
    h = jnp.asarray(field_on_grid("heights", heights, half_space.shape))
    positive("tolerance", tolerance, "(relative)")
    contact = normal_contact(half_space, h, normal_force=normal_force)
    for turn in range(1, max_alternations + 1):
        rolling = steady_rolling(
            half_space,
            contact.pressure,
            friction_coefficient=friction_coefficient,
            layer_compliance=layer_compliance,
            longitudinal_creepage=longitudinal_creepage,
            longitudinal_force=longitudinal_force,
            lateral_creepage=lateral_creepage,
            lateral_force=lateral_force,
        )
        lifted = h + half_space.coupled_displacement(rolling.traction[0])
        after = normal_contact(half_space, lifted, normal_force=normal_force, start=contact)
        change = float(jnp.max(jnp.abs(after.pressure - contact.pressure)) / jnp.max(after.pressure))
        contact = after
        if change <= tolerance:
            return CoupledSteadyRolling(rolling=rolling, contact=contact, alternations=turn)
    raise NoSolutionError(
        f"coupled rolling: the pressure still changes by {change:.3g} of its peak after {max_alternations} "
        f"alternations, tolerance {tolerance:g}; increase max_alternations"
    )

"""Crowned rollers in shear: what crowns add to the compliance and to the slip of a line contact that stands."""

from __future__ import annotations

import math

import numpy as np

from asperity.contact.crowned_line import compression_and_shortening, crown_compliance
from asperity.engine.arrays import xp
from asperity.types import Array, Real

# Gauss–Legendre over the cube root of the normal force, in which what ends of the line add is smooth down to no force
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)


def crown_shear_compliance(*, stick_force: Real, lateral_strain_compliance: Real, **line: Real) -> Array:
    r"""Incremental compliance that crowns add to a line contact in the rolling direction.

    .. math::
        \frac{\mathrm d\,\Delta\delta}{\mathrm dN}\bigg|_{N - T/\mu}
        + \frac2\pi \sum_{i=1,2} \frac{\nu_i (1+\nu_i)}{E_i} \left(\frac1\ell - \frac1B\right)

    Parameters
    ----------
    stick_force : Real
        :math:`N - T/\mu` [N], positive: the normal force whose contact area is the region of stick.
    lateral_strain_compliance : Real
        :math:`\sum \nu_i (1+\nu_i)/E_i` of both bodies [1/Pa].
    line : Real
        As for :func:`asperity.contact.crowned_line.crowned_line`, without the force.

    Returns
    -------
    Array
        Compliance [m/N]; 0 without crown.

    Notes
    -----
    By the theorem of Ciavarella and Jäger a tangential force T confines stick to the contact area under
    :math:`N - T/\mu`, on which further load acts as in full stick. The second term is by what shear along a line that
    ends is softer than compression; for a long ellipse it is Mindlin's.

    References
    ----------
    J. Jäger, Arch. Appl. Mech. 65 (1995) 478; M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349; K. L. Johnson,
    Contact Mechanics, 1985, section 7.2; equation (B12) of :doc:`/equations`.
    """
    _, shorter = compression_and_shortening(normal_force=stick_force, **line)
    ends = (2.0 / math.pi) * lateral_strain_compliance * shorter
    return crown_compliance(normal_force=stick_force, **line) + ends


def crown_slip(
    *,
    normal_force: Real,
    stick_force: Real,
    friction_coefficient: Real,
    lateral_strain_compliance: Real,
    **line: Real,
) -> Array:
    r"""Slip that crowns add to a line contact that stands, on first loading in the rolling direction.

    .. math::
        \Delta s = \mu \left[\Delta\delta(N) - \Delta\delta(P)
        + \frac2\pi \sum_{i=1,2} \frac{\nu_i (1+\nu_i)}{E_i}
        \int_P^N \left(\frac1\ell - \frac1B\right) \mathrm dN'\right], \qquad P = N - \frac T\mu

    Parameters
    ----------
    normal_force : Real
        Normal force N [N], positive.
    stick_force : Real
        P: the normal force whose contact area is the region of stick [N], positive.
    friction_coefficient : Real
        mu [-].
    lateral_strain_compliance : Real
        :math:`\sum \nu_i (1+\nu_i)/E_i` of both bodies [1/Pa].
    line : Real
        As for :func:`asperity.contact.crowned_line.crowned_line`, without the force.

    Returns
    -------
    Array
        Slip [m]; 0 without crown, and without a tangential force.

    Notes
    -----
    The integral of :func:`crown_shear_compliance` over the tangential force, within 0.3 % where the ends of the line
    come free on the way, else 1e-4.

    References
    ----------
    J. Jäger, Arch. Appl. Mech. 65 (1995) 478; M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349; equation (B12) of
    :doc:`/equations`.
    """
    normal, stick = xp.broadcast_arrays(
        xp.asarray(normal_force, dtype=float), xp.asarray(stick_force, dtype=float)
    )
    first, last = xp.cbrt(stick), xp.cbrt(normal)
    nodes, weights = (xp.asarray(rule).reshape(-1, *(1,) * normal.ndim) for rule in (_NODES, _WEIGHTS))
    root = 0.5 * ((last + first) + (last - first) * nodes)
    forces = xp.concatenate([normal[None], stick[None], root**3])
    added, shorter = compression_and_shortening(normal_force=forces, **line)
    ends = 0.5 * (last - first) * xp.sum(weights * 3.0 * root**2 * shorter[2:], axis=0)
    sideways = (2.0 / math.pi) * lateral_strain_compliance * ends
    return xp.asarray(friction_coefficient * (added[0] - added[1] + sideways))

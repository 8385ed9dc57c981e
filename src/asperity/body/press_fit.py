"""A ring pressed into a housing that is too small for it: two thick-walled cylinders in plane stress.

Nothing holds the faces of a ring, which is short: its axial stress is 0, as DIN 7190 has it too.
"""

from __future__ import annotations

from typing import NamedTuple

from asperity.engine.arrays import xp
from asperity.materials import Material
from asperity.types import Array, Real


def rim_compliance(*, rim: Real, other: Real, youngs_modulus: Real, poisson_ratio: Real) -> Real:
    r"""Radial displacement of one rim of an annulus over the uniform pressure on it; the other rim is free.

    .. math:: c = \frac{a}{E}\, \frac{(1 - \nu)\,a^2 + (1 + \nu)\,b^2}{\lvert b^2 - a^2\rvert}

    Parameters
    ----------
    rim, other : Real
        Radii a of the rim with the pressure and b of the other one, whichever is larger [m].
    youngs_modulus, poisson_ratio : Real
        E [Pa] and nu [-], in plane strain E/(1 − nu^2) and nu/(1 − nu).

    Returns
    -------
    Real
        Compliance, positive where the pressure widens the bore of a housing and where it narrows a ring [m/Pa].

    References
    ----------
    Lamé's solution; S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 3rd ed. 1970, section 28.
    """
    inside, outside = rim**2, other**2
    narrowing = (1.0 - poisson_ratio) * inside + (1.0 + poisson_ratio) * outside
    return rim / youngs_modulus * narrowing / xp.abs(outside - inside)


class PressFit(NamedTuple):
    """A ring in its housing, alone.

    ``pressure`` between both, 0 where a gap is left [Pa]; ``bore_change``, by how much it narrows the bore of the ring,
    on the diameter [m]; hoop stresses, tension positive, of the ring at its bore and at its seat (``ring_hoop``, a
    pair) and of the housing at its bore (``housing_hoop``) [Pa].
    """

    pressure: Array
    bore_change: Array
    ring_hoop: tuple[Array, Array]
    housing_hoop: Array


def press_fit(
    *,
    ring: Material,
    housing: Material,
    bore_radius: Real,
    seat_radius: Real,
    outer_radius: Real,
    interference: Real,
) -> PressFit:
    r"""Pressure and stresses of a ring with bore a, pressed at its outer radius b into a housing of outer radius c.

    .. math::
        p = \frac{\Delta d}{2\,(c_r + c_h)}, \qquad \Delta d_a = \frac{4\,p\,a\,b^2}{E_r\,(b^2 - a^2)}, \qquad
        \sigma_a = \frac{-2\,p\,b^2}{b^2 - a^2}, \quad \sigma_b = -p\,\frac{b^2 + a^2}{b^2 - a^2}, \quad
        \sigma_h = p\,\frac{c^2 + b^2}{c^2 - b^2}

    with the compliances of both rims at the seat by :func:`rim_compliance`.

    Parameters
    ----------
    ring, housing : Material
        Materials of both.
    bore_radius, seat_radius, outer_radius : Real
        Radii a, b and c [m].
    interference : Real
        By how much the outer diameter of the free ring exceeds the bore of the free housing, :math:`\Delta d` [m]; no
        pressure where it does not. nan where the housing lies inside the ring.

    Returns
    -------
    PressFit
        Pressure [Pa], change of the bore [m], hoop stresses [Pa].

    Notes
    -----
    Elastic, and both of one length. Pressing smooths the seats, which takes up to 0.8 times the sum of both Rz from the
    measured interference (DIN 7190); the interference here is what is left.

    References
    ----------
    Equation (I5) of :doc:`/equations`; DIN 7190-1:2017; S. P. Timoshenko, Strength of Materials II, 3rd ed. 1956,
    section 41.

    Examples
    --------
    A ring 30/40 mm of steel in a housing of steel, outside 80 mm, 20 µm on the diameter:

    >>> steel = Material(206e9, 0.3, 7850.0, 450e6, 1260e6)
    >>> fit = press_fit(ring=steel, housing=steel, bore_radius=0.015, seat_radius=0.02, outer_radius=0.04,
    ...                 interference=20e-6)
    >>> round(float(fit.pressure) / 1e6, 2)
    19.66
    """
    at_ring = rim_compliance(
        rim=seat_radius,
        other=bore_radius,
        youngs_modulus=ring.youngs_modulus,
        poisson_ratio=ring.poisson_ratio,
    )
    at_housing = rim_compliance(
        rim=seat_radius,
        other=outer_radius,
        youngs_modulus=housing.youngs_modulus,
        poisson_ratio=housing.poisson_ratio,
    )
    pressed = 0.5 * xp.maximum(xp.asarray(interference), 0.0) / (at_ring + at_housing)
    pressure = xp.where(xp.asarray(outer_radius) > seat_radius, pressed, xp.nan)
    inner, seat, outer = bore_radius**2, seat_radius**2, outer_radius**2
    at_bore = -2.0 * pressure * seat / (seat - inner)
    return PressFit(
        pressure,
        -2.0 * bore_radius * at_bore / ring.youngs_modulus,
        (at_bore, -pressure * (seat + inner) / (seat - inner)),
        pressure * (outer + seat) / (outer - seat),
    )

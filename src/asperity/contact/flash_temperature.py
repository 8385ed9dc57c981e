"""Flash temperature of a rolling line contact: the rise of its surfaces above the temperature of the bodies."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.types import Array, Real

#: Blok's constant: largest rise under a band of elliptic heat, with equal rise of both surfaces.
FLASH_CONSTANT = 1.11

#: Polynomial in the share of the width that slips, within 1.1e-4 of the rise under Carter's heat (test).
_CARTER_HEAT = (1.00006881, 0.06174581, 0.08219041, -0.03295858, 0.06474663)


def thermal_effusivity(*, conductivity: Real, density: Real, heat_capacity: Real) -> Real:
    r"""Thermal effusivity of a body, :math:`b = \sqrt{k\rho c}`.

    Parameters
    ----------
    conductivity : Real
        Thermal conductivity k [W/(m K)].
    density : Real
        Density rho [kg/m^3].
    heat_capacity : Real
        Specific heat capacity c [J/(kg K)].

    Returns
    -------
    Real
        Effusivity [W s^0.5/(m^2 K)].

    References
    ----------
    H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids, 1959, section 2.9.
    """
    return xp.sqrt(conductivity * density * heat_capacity)


def flash_temperature(
    *,
    friction_power: Real,
    surface_speed_1: Real,
    surface_speed_2: Real,
    half_width: Real,
    effusivity_1: Real,
    effusivity_2: Real,
) -> Real:
    r"""Largest temperature rise of the surfaces in a sliding line contact.

    .. math:: \Delta T = 1.11\,\frac{P'}{\sqrt{2a}\,\left(b_1\sqrt{u_1} + b_2\sqrt{u_2}\right)}

    Parameters
    ----------
    friction_power : Real
        Friction power per length of the contact, :math:`P' = \mu\,w\,|u_1-u_2|` in gross slip [W/m].
    surface_speed_1, surface_speed_2 : Real
        Speeds of the surfaces through the contact, not negative and not both 0 [m/s].
    half_width : Real
        Half-width a of the contact [m].
    effusivity_1, effusivity_2 : Real
        Thermal effusivities of the bodies, :func:`thermal_effusivity` [W s^0.5/(m^2 K)].

    Returns
    -------
    Real
        Temperature rise above that of the bodies [K].

    Notes
    -----
    Heat in proportion to the pressure, equal temperature of both surfaces, convection much larger than conduction
    along the surface: :math:`u a \rho c/k` above about 10 for both. For slower surfaces it is an upper bound. With
    partial slip only a part of the width generates heat, :func:`partial_slip_flash_factor`.

    References
    ----------
    H. Blok, Proc. Gen. Disc. Lubrication, IMechE 2 (1937) 222; AGMA 925-A03 for unlike bodies; equation (B9) of
    :doc:`/equations`.
    """
    conducted = effusivity_1 * xp.sqrt(surface_speed_1) + effusivity_2 * xp.sqrt(surface_speed_2)
    return FLASH_CONSTANT * friction_power / (xp.sqrt(2.0 * half_width) * conducted)  # (B9)


def partial_slip_flash_factor(*, stick_fraction: Real) -> Array:
    r"""Flash temperature under the heat of Carter's slip zone over that under an even share of the pressure.

    .. math:: \frac{\Delta T}{\Delta T_{Blok}} = \frac{g(s)}{\sqrt s}, \qquad s = 1 - \frac ca

    Parameters
    ----------
    stick_fraction : Real
        Share c/a of the contact width that sticks, :math:`\sqrt{1-q}`, below 1 [-].

    Returns
    -------
    Array
        Factor for the same friction power [-]; infinite without slip, where there is no heat.

    Notes
    -----
    In the slip zone, of width 2 (a − c), traction is :math:`\mu p` and the local slip :math:`(\mu/R)\sqrt{x'^2-c^2}`
    at the distance x' from the middle of the stick zone. g rises from 1.00 for a narrow slip zone to 1.18 at the onset
    of gross slip: there the slip still grows towards the trailing edge. Far beyond gross slip it grows no more, and
    the factor is 1. Interpolated within 0.011 %.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151, with the moving source of Blok 1937; equation (B9) of
    :doc:`/equations`.
    """
    slips = 1.0 - xp.asarray(stick_fraction)
    some = slips > 0.0
    share = xp.where(some, slips, 1.0)
    factor = xp.zeros_like(share)
    for coefficient in reversed(_CARTER_HEAT):
        factor = factor * share + coefficient
    return xp.where(some, factor / xp.sqrt(share), xp.inf)

r"""Interference and preload: the length by which the ring is too small for its rollers, and the force that it makes.

The interference :math:`\delta` is the length by which the ring's inner radius lies below the radius at which all
contacts of a branch just touch, the loading rollers held at their angle by the carrier's pins. By virtual work with
the forces at rest,

.. math:: \sum_k N_k \delta_k = (N_{wro} + N_{wlo})\,\delta ,

with the approaches :math:`\delta_k` of the bodies at the contacts, the ring springs and the pins. A deviation
:math:`\varepsilon` of a roller's radius counts as :math:`\varepsilon \sum N_k/(N_{wro} + N_{wlo})` over its contacts.
"""

from __future__ import annotations

from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import Array

from asperity.contact.crowned_line import CrownedLines, crown_compression
from asperity.drive.mechanism import RestState
from asperity.types import Real

_NEWTON_STEPS = 12


class CrownsAtRest(NamedTuple):
    """Crowned contacts of a drive at rest.

    Parameters
    ----------
    lines : CrownedLines
        The contacts, shape (5, ...).
    force_ratio : Array
        Their normal forces over the preload, shape (5, ...) [-].
    """

    lines: CrownedLines
    force_ratio: Array


class RestCompliance(NamedTuple):
    r"""Work of the forces at rest on the approaches, at a reference preload.

    .. math:: \delta(N_0) = N_0 \left[s - t \ln (N_0/N_{ref})\right] + \delta_c(N_0)

    Parameters
    ----------
    secant : Array
        s: interference over preload at the reference [m/N].
    logarithmic : Array
        t: share of it that decreases with the logarithm of the preload, because the contacts widen [m/N].
    reference : Array
        Reference preload [N].
    crowns : CrownsAtRest or None
        Crowned contacts, which add :math:`\delta_c`; None where none is crowned.
    """

    secant: Array
    logarithmic: Array
    reference: Array
    crowns: CrownsAtRest | None = None


def crown_interference(*, crowns: CrownsAtRest, preload: Real) -> tuple[Array, Array]:
    r"""Interference that crowns add, and its derivative by the preload.

    .. math:: \delta_c = \frac{\sum_k N_k\,\Delta\delta_k(N_k)}{N_{wro} + N_{wlo}}

    Parameters
    ----------
    crowns : CrownsAtRest
        The crowned contacts.
    preload : Real
        Normal force N_0 between sun and planet at rest [N].

    Returns
    -------
    tuple of Array
        Interference [m] and its derivative [m/N].

    References
    ----------
    Equations (I1) and (B12) of :doc:`/equations`.
    """
    ratio = crowns.force_ratio
    share = ratio / (ratio[3] + ratio[4])
    added, slope = jax.jvp(
        lambda force: crown_compression(normal_force=force, **vars(crowns.lines)),
        (ratio * preload,),
        (ratio + 0.0 * preload,),
    )
    return jnp.sum(share * added, axis=0), jnp.sum(share * slope, axis=0)


def rest_compliance(
    *,
    rest: RestState,
    preload: Real,
    secant_work: Real,
    logarithmic_compliance: Array,
    ring_compliance: Real,
    pin_compliance: Real,
    crowns: CrownedLines | None = None,
) -> RestCompliance:
    r"""Interference over preload of a drive at rest.

    .. math::
        s = \frac{W + c_o (N_{wro}^2 + N_{wlo}^2) + c_p (F_l^2 + F_r^2)}{N_0\,(N_{wro} + N_{wlo})}, \qquad
        t = \frac{\sum_k l_k N_k^2}{N_0\,(N_{wro} + N_{wlo})}

    Parameters
    ----------
    rest : RestState
        Forces at rest [N].
    preload : Real
        Preload N_0 that they belong to [N].
    secant_work : Real
        :math:`W = \sum_k N_k \delta_k` of the bodies [N·m].
    logarithmic_compliance : Array
        l: decrease of each contact's secant compliance with the logarithm of its force, shape (5, ...) [m/N].
    ring_compliance, pin_compliance : Real
        Of a ring spring under a loading roller and of a carrier pin [m/N].
    crowns : CrownedLines, optional
        Crowned contacts, whose approach W leaves out.

    Returns
    -------
    RestCompliance
        At this preload.

    References
    ----------
    Equation (I1) of :doc:`/equations`.
    """
    normal = rest.normal_force
    ring = normal[3] ** 2 + normal[4] ** 2
    pins = rest.pin_force_left**2 + rest.pin_force_right**2
    lever = preload * (normal[3] + normal[4])
    work = secant_work + ring_compliance * ring + pin_compliance * pins
    return RestCompliance(
        secant=jnp.asarray(work / lever),
        logarithmic=jnp.sum(logarithmic_compliance * normal**2, axis=0) / lever,
        reference=jnp.asarray(preload),
        crowns=None if crowns is None else CrownsAtRest(crowns, normal / preload),
    )


def interference(*, compliance: RestCompliance, preload: Real) -> Array:
    r"""Interference that makes a preload, :math:`\delta = N_0\,[s - t \ln(N_0/N_{ref})] + \delta_c`.

    Parameters
    ----------
    compliance : RestCompliance
        Of the drive.
    preload : Real
        Normal force N_0 between sun and planet at rest [N].

    Returns
    -------
    Array
        Interference [m].

    References
    ----------
    Equation (I1) of :doc:`/equations`.
    """
    bend = compliance.logarithmic * jnp.log(preload / compliance.reference)
    even = jnp.asarray(preload * (compliance.secant - bend))
    if compliance.crowns is None:
        return even
    return even + crown_interference(crowns=compliance.crowns, preload=preload)[0]


def incremental_interference(*, compliance: RestCompliance, preload: Real) -> Array:
    r"""Derivative of :func:`interference` by the preload.

    .. math:: \frac{d\delta}{dN_0} = s - t - t \ln\frac{N_0}{N_{ref}} + \frac{d\delta_c}{dN_0}

    Parameters
    ----------
    compliance : RestCompliance
        Of the drive.
    preload : Real
        Normal force N_0 between sun and planet at rest [N].

    Returns
    -------
    Array
        Compliance [m/N].

    References
    ----------
    Equation (I1) of :doc:`/equations`.
    """
    bend = compliance.logarithmic * (1.0 + jnp.log(preload / compliance.reference))
    even = jnp.asarray(compliance.secant - bend)
    if compliance.crowns is None:
        return even
    return even + crown_interference(crowns=compliance.crowns, preload=preload)[1]


def _as_logarithm(compliance: RestCompliance) -> RestCompliance:
    """The crowns by their value and slope at the reference preload, as one more share of the logarithm."""
    if compliance.crowns is None:
        return compliance
    added, slope = crown_interference(crowns=compliance.crowns, preload=compliance.reference)
    secant = added / compliance.reference
    return RestCompliance(
        compliance.secant + secant, compliance.logarithmic + (secant - slope), compliance.reference
    )


def preload_of_interference(*, compliance: RestCompliance, interference: Real) -> Array:
    r"""Preload that an interference makes: the inverse of :func:`interference`.

    .. math:: x + \ln\left(1 - \frac ts x\right) = \ln\frac{\delta}{s N_{ref}}, \qquad x = \ln\frac{N_0}{N_{ref}}

    Parameters
    ----------
    compliance : RestCompliance
        Of the drive.
    interference : Real
        Interference [m].

    Returns
    -------
    Array
        Normal force N_0 between sun and planet at rest [N]; 0 without interference: the contacts do not touch. nan
        where contacts would be as wide as their bodies.

    Notes
    -----
    With crowns this is one step of Newton's method from the reference preload, in logarithms.

    References
    ----------
    Equation (I1) of :doc:`/equations`.
    """
    compliance = _as_logarithm(compliance)
    touches = jnp.asarray(interference) > 0.0
    scale = compliance.secant * compliance.reference
    target = jnp.log(jnp.where(touches, interference, scale) / scale)
    bend = compliance.logarithmic / compliance.secant

    def newton(x: Array, target: Array, bend: Array) -> Array:
        rest = 1.0 - bend * x
        return x - (x + jnp.log(rest) - target) / (1.0 - bend / rest)

    fixed = jax.lax.stop_gradient((target, bend))
    found = jax.lax.fori_loop(
        0, _NEWTON_STEPS, lambda _, x: newton(x, *fixed), jnp.zeros_like(fixed[0] + fixed[1])
    )
    converged = jnp.abs(newton(found, *fixed) - found) < 1e-9
    exact = newton(jax.lax.stop_gradient(found), target, bend)  # its derivative is that of the solution
    force = compliance.reference * jnp.exp(jnp.where(converged, exact, jnp.nan))
    return jnp.where(touches, force, 0.0)


def interference_of_sizes(
    *, rest: RestState, sun: Real, planet: Real, right_roller: Real, left_roller: Real, ring: Real
) -> Array:
    r"""Interference that deviations of the radii add.

    .. math::
        (N_{wro} + N_{wlo})\,(\delta + \varepsilon_o) = N_{sp} \varepsilon_s
        + (N_{sp} + N_{pwr} + N_{pwl}) \varepsilon_p + (N_{pwr} + N_{wro}) \varepsilon_{wr}
        + (N_{pwl} + N_{wlo}) \varepsilon_{wl}

    Parameters
    ----------
    rest : RestState
        Forces at rest; only their ratios matter [N].
    sun, planet, right_roller, left_roller, ring : Real
        Deviations of the radii from those at which the contacts just touch, larger positive [m].

    Returns
    -------
    Array
        Interference [m].

    References
    ----------
    Equation (I1) of :doc:`/equations`.
    """
    sp, pwr, pwl, wro, wlo = rest.normal_force
    work = sp * sun + (sp + pwr + pwl) * planet + (pwr + wro) * right_roller + (pwl + wlo) * left_roller
    return jnp.asarray(work / (wro + wlo) - ring)

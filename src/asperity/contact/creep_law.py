r"""Creep of a rolling line contact whose traction depends on its slip: oil film, asperities, or both.

With :math:`z = \xi/f`, the creepage that the bodies feel beside elastic layers, and the even-slip traction
:math:`\tau(x)`, :math:`T_0` of :mod:`asperity.contact.film_traction`,

.. math::
    T_{up} = T_0\left(r - \frac{r^2}{4}\right) \;(r < 2), \; T_0 \;(r \ge 2), \qquad
    r = \frac{\pi a E^* B z}{2 T_0}

.. math::
    T_{low} = \frac{E^* B}{2}\,z \int \arctan\frac{2\tau}{E^* z}\,dx, \qquad
    T = (1 - v)\,T_{up} + v\,T_{low}, \quad v = \frac{4 n}{1 + 3 n}, \quad n = \frac{d \ln T_0}{d \ln \xi}

The first is Carter's solution with the friction of the present slip, the second is exact for a film whose traction is
in proportion to its slip.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from asperity.contact.creep_bounds import bounded_stress
from asperity.contact.film_traction import EvenSlip, MixedContact, even_slip
from asperity.contact.fluid import DataSheetTraction, FilmBody, RheologicalTraction
from asperity.contact.measured_traction import MeasuredTraction
from asperity.contact.skew import turn_exponent
from asperity.engine.arrays import xp
from asperity.types import Array, Real

#: Creepage up to which a contact is said to carry its traction [-].
CREEP_LIMIT = 0.02
#: Share of the capacity above which the law is continued as a line, for iterates of a solver only.
NEAR_CAPACITY = 0.999

#: Creepage factor of the asperities as a layer without film, over the share of the traction that is used.
LayerFactor = Callable[[Array], Array]


class CreepingContact(NamedTuple):
    """Traction of contacts at a creepage, shape (contacts, ...).

    ``traction`` [N], and ``lateral`` traction of skewed axes [N]; ``even``: of rigid bodies [N]; ``elastic_factor``: of
    film and asperities as layers [-]; ``warming`` of the film [K].
    """

    traction: Array
    lateral: Array
    even: Array
    elastic_factor: Array
    warming: Array


def film_yield(contact: MixedContact, traction: RheologicalTraction | DataSheetTraction) -> Array:
    """Creepage that a film adds that carries all and does not slip, over that of the bodies.

    Parameters
    ----------
    contact : MixedContact
        The contact.
    traction : RheologicalTraction or DataSheetTraction
        What its film does, with an elastic yield of its own.

    Returns
    -------
    Array
        (1 − A)(f_F − 1), shape (contacts, ...) [-].

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    body = FilmBody(
        thickness=contact.film_thickness,
        half_width=contact.half_width,
        peak_pressure=contact.peak_pressure,
        contact_modulus=contact.contact_modulus,
        oil_temperature=contact.oil_temperature,
        rolling_speed=contact.rolling_speed,
    )
    return traction.elastic_yield(body)


def elastic_layers_factor(*, contact: MixedContact, layer_factor: Array, slides: EvenSlip) -> Array:
    r"""Creepage of film and asperities side by side over that of the bodies alone.

    .. math:: f = 1 + \left[\frac1{f_F - 1} + \frac A{f_D - 1}\right]^{-1}, \qquad
              f_F - 1 = \frac\pi4\frac{E^* h}{a G (1 - A)}

    A film by measured curves has its yield in them already. It keeps the asperities from yielding by what it bears at
    the creepage, and only their part of the traction yields:

    .. math:: f = 1 + \frac{\tau_A}{\tau_A + \tau_F} \left[\frac{4\,\tau_F}{\pi E^* \xi}
              + \frac A{f_D - 1}\right]^{-1}

    Parameters
    ----------
    contact : MixedContact
        The contact.
    layer_factor : Array
        f_D, factor of the asperities alone, shape (contacts, ...) [-].
    slides : EvenSlip
        Traction of rigid bodies at the creepage, of which tau_A and tau_F are the means over the width.

    Returns
    -------
    Array
        Factor, shape (contacts, ...) [-].

    Notes
    -----
    Both are f_D where the asperities carry all, and the factor of the film where it does. The second is within 9 % of
    strips whose asperities yield and slip beside the film, in 95 % of random contacts.

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    traction, dry = contact.traction, layer_factor - 1.0
    if isinstance(traction, MeasuredTraction):
        return _beside_a_curve(contact, dry, slides)
    film = film_yield(contact, traction)
    # springs side by side; a film of no thickness or asperities that do not yield leave no compliance
    stiff = contact.film_share * dry + contact.asperity_share * film
    both = stiff > 0.0
    # a film that carries all does not ask for the asperities
    alone = xp.where(contact.asperity_share > 0.0, 0.0, film)
    return 1.0 + xp.where(both, film * dry / xp.where(both, stiff, 1.0), alone)


def _beside_a_curve(contact: MixedContact, dry: Array, slides: EvenSlip) -> Array:
    """Factor of asperities, which alone make up f_D - 1, beside a film by measured curves, shape (contacts, ...)."""
    coefficient, _ = contact.friction.at(slides.creepage * contact.rolling_speed)
    asperities = coefficient * contact.asperity_share * (0.25 * math.pi * contact.peak_pressure)
    film = xp.maximum(slides.mean - asperities, 0.0)
    held = film / (0.25 * math.pi * contact.contact_modulus * slides.creepage)
    stiff = held * dry + contact.asperity_share
    yields = stiff > 0.0
    return 1.0 + xp.where(yields, asperities / slides.mean * dry / xp.where(yields, stiff, 1.0), 0.0)


def traction_at_creepage(*, contact: MixedContact, creepage: Array, layer_factor: Array) -> CreepingContact:
    r"""Traction of rolling contacts at a creepage.

    Parameters
    ----------
    contact : MixedContact
        The contacts.
    creepage : Array
        xi, positive, shape (contacts, ...) [-].
    layer_factor : Array
        Creepage factor f_D of the asperities alone [-].

    Returns
    -------
    CreepingContact
        Their traction, not above the stick line, that of rigid bodies, or friction and limiting stress.

    Notes
    -----
    Exact for dry contacts (Carter), for a film in proportion to slip of any viscosity over the width, and for rigid
    bodies; a film that is elastic up to its limit has Carter's solution stretched by f, within 3 % at f = 1.2 and 8.5 %
    at f = 10. Against strips with the same shear stress on twice 600 random contacts, by
    :mod:`asperity.bem.film_rolling`: 2.7 to 3.2 % root mean square, 94 to 96 % within 7 %.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; equation (F5) of :doc:`/equations`.
    """
    size = slip_size(contact, creepage)
    slides = even_slip(contact=contact, creepage=size)
    factor = elastic_layers_factor(contact=contact, layer_factor=layer_factor, slides=slides)
    along, across = slip_forces(contact, creepage, slides, factor)
    return CreepingContact(
        traction=contact.total(along),
        lateral=contact.total(across),
        even=contact.total(slides.force),
        elastic_factor=factor,
        warming=slides.heated,
    )


def slip_size(contact: MixedContact, creepage: Array) -> Array:
    r"""Size of the creepages along and across, :math:`\sqrt{\xi^2 + \xi_y^2}`.

    Parameters
    ----------
    contact : MixedContact
        The contact, whose lateral creepage is over how much further the bodies give way that way.
    creepage : Array
        xi along, shape (contacts, ...) [-].

    Returns
    -------
    Array
        Size, of the same shape [-].

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    if contact.lateral_creepage is None:
        return creepage
    return xp.sqrt(creepage**2 + contact.lateral_creepage**2)


def slip_forces(
    contact: MixedContact, creepage: Array, slides: EvenSlip, factor: Array
) -> tuple[Array, Array]:
    r"""Tractions of contacts along and across, between the two bounds of the law.

    Parameters
    ----------
    contact : MixedContact
        The contacts, or their slices.
    creepage : Array
        Along the rolling direction, positive, shape (contacts, ...) [-].
    slides : EvenSlip
        Traction of rigid bodies at the size of the creepages.
    factor : Array
        Of elastic layers, :func:`elastic_layers_factor` [-].

    Returns
    -------
    tuple of Array
        Along and across, of slices where the contacts are sliced [N]. The direction is that of dry contacts,
        :func:`asperity.contact.skew.skewed_slip_ratios`.

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    size = slip_size(contact, creepage)
    found = bounded_stress(
        stress=slides.stress,
        mean=slides.mean,
        bodies=0.5 * contact.contact_modulus * size / factor,
        exponent=slides.exponent,
    )
    traction = 2.0 * contact.half_width * contact.contact_length * found.mean
    if contact.lateral_creepage is None:
        return traction, 0.0 * traction
    turned = contact.lateral_creepage * contact.lateral_ratio ** turn_exponent(found.slid)
    length = xp.sqrt(creepage**2 + turned**2)
    return traction * creepage / length, traction * turned / length


class Capacity(NamedTuple):
    """Largest traction of contacts [N], the creepage at which they reach it, and up to which it counts [-]."""

    traction: Array
    creepage: Array
    limit: Real


def stick_creepage(*, contact: MixedContact, traction: Array, elastic_factor: Array) -> Array:
    r"""Creepage under a traction if nothing slipped, :math:`\xi = 2 T f/(\pi a E^* B)`; the least there is.

    Parameters
    ----------
    contact : MixedContact
        The contact.
    traction : Array
        T, shape (contacts, ...) [N].
    elastic_factor : Array
        f of :func:`elastic_layers_factor` [-].

    Returns
    -------
    Array
        Creepage, shape (contacts, ...) [-].

    References
    ----------
    Carter's slope, stretched by the layers; equation (F5) of :doc:`/equations`.
    """
    area = contact.half_width * contact.contact_length * xp.ones_like(contact.film_thickness)
    stiffness = 0.5 * math.pi * contact.total(area * contact.contact_modulus / elastic_factor)
    return traction / stiffness

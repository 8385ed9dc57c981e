"""Oil film of a rolling line contact, and its thickness over the roughness."""

from __future__ import annotations

from typing import Literal

from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Array, Real

#: Laws of the central thickness, by the names of their authors.
FilmLaw = Literal["moes", "dowson_toyoda", "pan_hamrock"]


def minimum_film_thickness(
    *,
    viscosity: Real,
    pressure_coefficient: Real,
    entrainment_speed: Real,
    line_load: Real,
    effective_radius: Real,
    contact_modulus: Real,
) -> Real:
    r"""Smallest thickness of the oil film of an elastohydrodynamic line contact.

    .. math::
        \frac hR = 2.65\,\frac{U^{0.70}\,G^{0.54}}{W^{0.13}}, \qquad
        U = \frac{\eta_0\bar u}{E'R}, \; G = \alpha E', \; W = \frac{P'}{E'R}, \; E' = 2E^*

    Parameters
    ----------
    viscosity : Real
        Viscosity eta_0 of the oil at the inlet [Pa s].
    pressure_coefficient : Real
        Pressure coefficient alpha of the viscosity [1/Pa].
    entrainment_speed : Real
        Mean surface speed u > 0 [m/s].
    line_load : Real
        Normal force per length P' [N/m].
    effective_radius : Real
        Effective radius R [m].
    contact_modulus : Real
        Contact modulus E* [Pa].

    Returns
    -------
    Real
        Thickness h at the constriction near the outlet [m].

    Notes
    -----
    Smooth surfaces, flooded and isothermal inlet, the film carries the whole load. Fitted for U from 1e-13 to 1e-10,
    W from 3e-5 to 3e-4 and G from 2500 to 7500. Starved or hot inlets give less.

    References
    ----------
    D. Dowson, Proc. IMechE 182 (1968) Part 3A, 151; equation (B11) of :doc:`/equations`.
    """
    modulus = 2.0 * contact_modulus
    speed = viscosity * entrainment_speed / (modulus * effective_radius)
    load = line_load / (modulus * effective_radius)
    relative = 2.65 * speed**0.70 * (pressure_coefficient * modulus) ** 0.54 / load**0.13  # (B11)
    return relative * effective_radius


def film_ratio(*, film_thickness: Real, roughness: Real) -> Real:
    r"""Film thickness over roughness, :math:`\lambda = h/\sigma`.

    Parameters
    ----------
    film_thickness : Real
        Smallest film thickness h [m].
    roughness : Real
        Root mean square sigma of the heights of both surfaces together, :math:`\sqrt{R_{q1}^2+R_{q2}^2}` [m].

    Returns
    -------
    Real
        Ratio [-]: below 1 the asperities carry the load, above 3 the film.

    References
    ----------
    T. E. Tallian, ASLE Trans. 10 (1967) 418; equation (B11) of :doc:`/equations`.
    """
    return film_thickness / roughness


class FilmInlet(Module):
    """What a film of a rolling line contact is dragged in by, under the whole load. SI units, shape (contacts, ...).

    Parameters
    ----------
    viscosity : Real
        Viscosity eta_0 at the inlet [Pa·s].
    pressure_coefficient : Real
        Pressure coefficient alpha* [1/Pa], :func:`asperity.contact.viscosity.reciprocal_asymptotic_coefficient`.
    rolling_speed : Real
        Mean speed V > 0 of the surfaces relative to the contact [m/s].
    line_load : Real
        Normal force per length w [N/m].
    effective_radius : Real
        R [m].
    contact_modulus : Real
        E* [Pa].
    """

    viscosity: Real
    pressure_coefficient: Real
    rolling_speed: Real
    line_load: Real
    effective_radius: Real
    contact_modulus: Real


def central_film_thickness(*, inlet: FilmInlet, film_share: Real = 1.0) -> Array:
    r"""Central thickness of the oil film of a rolling line contact, of rigid or elastic bodies, at any pressure.

    .. math::
        \frac hR = \sqrt U \left[\left(H_{ri}^{7/3} + H_{ei}^{7/3}\right)^{3s/7}
        + \left(H_{rp}^{-7/2} + H_{ep}^{-7/2}\right)^{-2s/7}\right]^{1/s}, \qquad
        s = \frac15\left(7 + 8 e^{-2 H_{ei}/H_{ri}}\right)

    with :math:`H_{ri} = 3/M`, :math:`H_{ei} = 2.621 M^{-1/5}`, :math:`H_{rp} = 1.287 L^{2/3}`,
    :math:`H_{ep} = 1.311 M^{-1/8} L^{3/4}`, :math:`U = 2\eta_0 V/(E'R)`, :math:`M = w/(E'R\sqrt U)`,
    :math:`L = \alpha E' U^{1/4}`, :math:`E' = 2E^*`.

    Parameters
    ----------
    inlet : FilmInlet
        Oil, speed, load, radius and modulus.
    film_share : Real, optional
        Share of the load that the film carries, positive [-]: the film of a load and of a modulus in this proportion.

    Returns
    -------
    Array
        Thickness h in the middle of the contact [m].

    Notes
    -----
    Smooth surfaces, flooded and isothermal inlet. Stays right where asperities take the load off the film: without load
    it is the thickness of Reynolds's equation between rigid rollers, :math:`6 \eta_0 V R/w`.

    References
    ----------
    H. Moes's fit, as E. R. M. Gelinck and D. J. Schipper use it, Tribol. Int. 33 (2000) 175; equation (F2) of
    :doc:`/equations`.
    """
    modulus = 2.0 * inlet.contact_modulus * film_share
    speed = 2.0 * inlet.viscosity * inlet.rolling_speed / (modulus * inlet.effective_radius)
    root = xp.sqrt(speed)
    load = film_share * inlet.line_load / (modulus * inlet.effective_radius * root)
    pressure = inlet.pressure_coefficient * modulus * xp.sqrt(root)
    rigid, elastic = 3.0 / load, 2.621 * load**-0.2
    rigid_thick, elastic_thick = 1.287 * pressure ** (2.0 / 3.0), 1.311 * load**-0.125 * pressure**0.75
    blend = (7.0 + 8.0 * xp.exp(-2.0 * elastic / rigid)) / 5.0
    thin = (rigid ** (7.0 / 3.0) + elastic ** (7.0 / 3.0)) ** (3.0 * blend / 7.0)
    thick = (rigid_thick**-3.5 + elastic_thick**-3.5) ** (-2.0 * blend / 7.0)
    relative = (thin + thick) ** (1.0 / blend)  # (F2)
    return relative * root * inlet.effective_radius


def central_film_by(*, law: FilmLaw, inlet: FilmInlet, film_share: Real = 1.0) -> Array:
    r"""Central thickness of the film of a rolling line contact by one of several laws.

    .. math::
        \text{Dowson and Toyoda: } \frac hR = 3.06\,\frac{U^{0.69} G^{0.56}}{W^{0.10}}, \qquad
        \text{Pan and Hamrock: } \frac hR = 2.922\,\frac{U^{0.692} G^{0.470}}{W^{0.166}}

    with :math:`U = \eta_0 V/(E'R)`, :math:`G = \alpha E'`, :math:`W = w/(E'R)`.

    Parameters
    ----------
    law : FilmLaw
        ``moes``, ``dowson_toyoda`` or ``pan_hamrock``.
    inlet : FilmInlet
        Oil, speed, load, radius and modulus.
    film_share : Real, optional
        Share of the load that the film carries, as for :func:`central_film_thickness` [-].

    Returns
    -------
    Array
        Thickness [m].

    Notes
    -----
    The two rivals of :func:`central_film_thickness` are fits of elastic, piezoviscous films. They do not hold where
    asperities carry most of the load: the film then is that of rigid rollers.

    References
    ----------
    D. Dowson and A. Toyoda, 5th Leeds-Lyon Symp. 1978; P. Pan and B. J. Hamrock, J. Tribol. 111 (1989) 246. Equation
    (F2) of :doc:`/equations`.
    """
    if law == "moes":
        return central_film_thickness(inlet=inlet, film_share=film_share)
    modulus = 2.0 * inlet.contact_modulus * film_share
    speed = inlet.viscosity * inlet.rolling_speed / (modulus * inlet.effective_radius)
    load = film_share * inlet.line_load / (modulus * inlet.effective_radius)
    material = inlet.pressure_coefficient * modulus
    if law == "dowson_toyoda":
        relative = 3.06 * speed**0.69 * material**0.56 / load**0.10
    else:
        relative = 2.922 * speed**0.692 * material**0.470 / load**0.166
    return xp.asarray(relative * inlet.effective_radius)


def inlet_heat_factor(
    *,
    peak_pressure: Real,
    contact_modulus: Real,
    viscosity: Real,
    viscosity_fall: Real,
    conductivity: Real,
    rolling_speed: Real,
    slide_roll_ratio: Real = 0.0,
) -> Array:
    r"""Factor by which shear heat at the inlet thins a film.

    .. math::
        \varphi_T = \frac{1 - 13.2\,\frac{p_0}{E'}\,\ell^{0.42}}
        {1 + 0.213\left(1 + 2.23\,\Sigma^{0.83}\right)\ell^{0.64}}, \qquad
        \ell = \frac{\eta_0\,\beta_T V^2}{k}

    Parameters
    ----------
    peak_pressure, contact_modulus : Real
        Hertz's p_0 and E* [Pa].
    viscosity, viscosity_fall : Real
        eta_0 [Pa·s] and beta_T, the share by which it falls per kelvin [1/K].
    conductivity : Real
        Of the oil, k [W/(m K)].
    rolling_speed : Real
        V [m/s].
    slide_roll_ratio : Real, optional
        Sigma, difference of the surface speeds over their mean [-].

    Returns
    -------
    Array
        Factor [-].

    References
    ----------
    A. Arana et al., Proc. IMechE J 233 (2019) 303. Equation (F2) of :doc:`/equations`.
    """
    loading = viscosity * viscosity_fall * rolling_speed**2 / conductivity
    sliding = 1.0 + 2.23 * slide_roll_ratio**0.83
    cooled = 1.0 - 13.2 * peak_pressure / (2.0 * contact_modulus) * loading**0.42
    return xp.asarray(cooled / (1.0 + 0.213 * sliding * loading**0.64))

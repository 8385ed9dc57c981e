"""Oil film of a rolling line contact, and its thickness over the roughness."""

from __future__ import annotations

from asperity.types import Real


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

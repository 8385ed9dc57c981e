r"""The contact of randomly rough elastic surfaces: pressure falls exponentially with the distance of the bodies.

.. math::
    p = \beta E^* e^{-u/u_0}, \qquad u_0 = \gamma\, h_{rms}

so that rigid bodies of any shape have the stiffness :math:`N/u_0`, elastic rollers up to twice as much: one number of
the surface decides, the rms of its heights. It holds while the surfaces touch in part of their area, and far more of
real, measured surfaces follow it than one power law with D and G.
"""

from __future__ import annotations

from asperity.contact.creep_layer import layer_ratio
from asperity.contact.interface import RoughContact
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Real

#: Decay length over the rms of the heights. Persson's theory and simulations of self-affine surfaces have 0.4 to 0.5.
DECAY_LENGTH_RATIO = 0.48

#: Stiffness by this law over that of boundary elements, elastic: of eleven measured surfaces between 30 and 1000 MPa,
#: nine states in ten lie between these (``benchmarks/measured_contact.py``).
OVER_BOUNDARY_ELEMENTS = (0.39, 1.24)


class RandomRoughness(Module):
    """Roughness of a contact by its decay length: one equivalent surface with the roughness of both bodies.

    Parameters
    ----------
    decay_length : Real
        Distance in which the pressure falls by the factor e, u_0 [m]: :func:`decay_length` of the rms of the
        heights, or that of a measured map by boundary elements, :mod:`asperity.bem.pressed_map`.
    """

    decay_length: Real


def decay_length(*, rms_height: Real) -> Real:
    r"""Distance in which the pressure falls by the factor e, :math:`u_0 = 0.48\,h_{rms}`.

    Parameters
    ----------
    rms_height : Real
        Root mean square of the heights, of both bodies together, of the waves that are shorter than the contact is wide
        across it, and up to the roll-off of the spectrum along it [m].

    Returns
    -------
    Real
        u_0 [m].

    Notes
    -----
    The stiffness that follows is 0.94 to 1.03 of that of boundary elements on elastic self-affine surfaces; on measured
    ones it scatters as :data:`OVER_BOUNDARY_ELEMENTS` says. Plastic spots make a contact stiffer: :doc:`/validity`.

    References
    ----------
    B. N. J. Persson, Phys. Rev. Lett. 99 (2007) 125502; B. Lorenz and B. N. J. Persson, J. Phys.: Condens. Matter 21
    (2009) 015003. Equation (A10) of :doc:`/equations`.
    """
    return DECAY_LENGTH_RATIO * rms_height


def line_contact_factor(*, layer_ratio: Real) -> Real:
    r"""Stiffness of the asperities in a line contact of elastic rollers over that between rigid bodies.

    .. math::
        \frac{K_n u_0}{N} = 1 + \frac{1}{1 + 1.35\,s}, \qquad s = \frac{u_0 R}{a^2}

    Parameters
    ----------
    layer_ratio : Real
        Yield of the asperities over that of the bodies s, :func:`asperity.contact.creep_layer.layer_ratio` [-].

    Returns
    -------
    Real
        Factor, 2 for asperities much stiffer than the bodies and 1 for much softer ones [-].

    Notes
    -----
    Where asperities hardly yield the pressure is that of Hertz and rises as :math:`\sqrt N`: their approach
    :math:`u_0 \ln p` grows by :math:`u_0/2N` a newton. Within 1.6 % of elastic strips with this layer, s 0.005 to 20.

    References
    ----------
    Derived here; (A10) of :doc:`/equations`.
    """
    return 1.0 + 1.0 / (1.0 + 1.35 * layer_ratio)


def random_contact(
    *,
    roughness: RandomRoughness,
    normal_force: Real,
    tangential_force: Real,
    friction_coefficient: Real,
    contact_modulus: Real,
    tangential_contact_modulus: Real,
    contact_length: Real = xp.inf,
) -> RoughContact:
    r"""Stiffnesses of a randomly rough contact under load.

    .. math::
        K_n = f\,\frac N{u_0}, \qquad K_t = \kappa\,K_n \Bigl(1 - \frac T{\mu N}\Bigr), \qquad
        \kappa = \frac{4 G^*}{E^*}

    Parameters
    ----------
    roughness : RandomRoughness
        Decay length of the equivalent surface.
    normal_force, tangential_force : Real
        N, and T >= 0 [N].
    friction_coefficient : Real
        mu [-].
    contact_modulus, tangential_contact_modulus : Real
        E and G* [Pa], :mod:`asperity.materials`.
    contact_length : Real
        Of a line contact of elastic rollers, for f of :func:`line_contact_factor`; infinite between rigid bodies [m].

    Returns
    -------
    RoughContact
        In the broadcast shape of the inputs; without spots, whose sizes the law does not know: nan. All the load is
        elastic. Without contact every stiffness is 0, and that against sliding from gross slip on.

    Notes
    -----
    Valid for elastic spots in partial contact: the real area far below the nominal one. The displacement under a
    tangential force, :math:`-\frac{\mu u_0}{\kappa f} \ln(1 - T/\mu N)`, is the integral of :math:`1/K_t`; f is
    that without a tangential force.

    References
    ----------
    M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349 and J. Jäger, J. Tribol. 120 (1998) 677: tangential from
    normal contact. Equation (A10) of :doc:`/equations`.
    """
    touching = xp.asarray(normal_force) > 0.0
    load = xp.where(touching, normal_force, 0.0)
    limit = friction_coefficient * xp.where(touching, normal_force, 1.0)
    held = xp.where(touching, xp.maximum(1.0 - tangential_force / limit, 0.0), 0.0)
    rigid = load / roughness.decay_length
    ratio = layer_ratio(
        contact_modulus=contact_modulus,
        contact_length=contact_length,
        normal_stiffness=xp.where(touching, rigid, 1.0),
    )
    normal = line_contact_factor(layer_ratio=ratio) * rigid
    unknown = xp.full_like(normal, xp.nan)
    kappa = 4.0 * tangential_contact_modulus / contact_modulus
    elastic = (load, xp.zeros_like(load), kappa * normal * held, normal, rigid)
    return RoughContact(*xp.broadcast_arrays(unknown, unknown, unknown, *elastic, unknown, unknown))

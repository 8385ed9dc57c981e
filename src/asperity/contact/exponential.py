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

#: Stiffness of a surface of endless grooves over that of one without, less one: a fit to boundary elements.
LAY_STIFFENING = 0.155

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
    rolling_share : Real or None, optional
        Share of the waves that run in the rolling direction w, :mod:`asperity.surface.lay` [-]: 0 for endless grooves
        in that direction, 1 for such along the axis; None, as 0.5, for a surface without grooves.
    """

    decay_length: Real
    rolling_share: Real | None = None


def decay_length(*, rms_height: Real, rolling_share: Real | None = None) -> Real:
    r"""Distance in which the pressure falls by the factor e, :math:`u_0 = 0.48\,h_{rms}/f`.

    Parameters
    ----------
    rms_height : Real
        Root mean square of the heights, of both bodies together, of the waves that are shorter than the contact is wide
        across it, and up to the roll-off of the spectrum along it [m].
    rolling_share : Real or None
        Share of the waves that run in the rolling direction [-], for f of :func:`lay_factor`; None without grooves.

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
    (2009) 015003. Equations (A10) and (A12) of :doc:`/equations`.
    """
    if rolling_share is None:
        return DECAY_LENGTH_RATIO * rms_height
    return DECAY_LENGTH_RATIO * rms_height / lay_factor(rolling_share=rolling_share)  # (A12)


def lay_factor(*, rolling_share: Real) -> Real:
    r"""Stiffness of a surface with grooves over that of one without, of the same rms of the heights.

    .. math::
        f = 1 + 0.155\,|2w - 1|^{3/2}

    Parameters
    ----------
    rolling_share : Real
        Share of the waves in one direction w, the rolling direction or that across it [-].

    Returns
    -------
    Real
        Factor, 1 without grooves and 1.155 with endless ones [-].

    Notes
    -----
    A fit of means over boundary elements of self-affine steel surfaces at 100 and 300 MPa, within 2 % of them; single
    maps scatter by a tenth. Which of the two directions the grooves have is nothing to the normal stiffness.

    References
    ----------
    Fitted here to :data:`asperity.validation.lay_checks.ELEMENTS`; equation (A12) of :doc:`/equations`.

    Examples
    --------
    >>> round(float(lay_factor(rolling_share=0.75)), 3), float(lay_factor(rolling_share=0.5))
    (1.055, 1.0)
    """
    return 1.0 + LAY_STIFFENING * xp.abs(2.0 * rolling_share - 1.0) ** 1.5  # (A12)


def lay_stiffness_ratio(
    *, contact_modulus: Real, tangential_contact_modulus: Real, share: Real | None
) -> Real:
    r"""Tangential over normal stiffness of asperities, in a direction in which a share of the waves runs.

    .. math::
        \kappa = \frac{\kappa_0}{1 - (2w - 1)(1 - \kappa_0)}, \qquad \kappa_0 = \frac{4 G^*}{E^*}

    Parameters
    ----------
    contact_modulus, tangential_contact_modulus : Real
        E and G* [Pa], :mod:`asperity.materials`.
    share : Real or None
        Share w of the waves that run in the direction of the force [-]: 1 for a force across endless grooves, 0 for one
        along them; None, as 0.5, without grooves.

    Returns
    -------
    Real
        kappa [-]; for like bodies :math:`(1 - \nu)/(1 - \nu w)`.

    Notes
    -----
    A half-space yields to a wave of pressure by :math:`(1 - \nu)/Gq` and to one of shear by
    :math:`(1 - \nu\,q_x^2/q^2)/Gq` in its direction x. Summed over the waves and over both bodies, whatever they are
    made of: :math:`\kappa = \sum\frac{1-\nu_i}{G_i} \big/ \sum\frac{1-\nu_i w}{G_i}`, which is the formula above by
    :math:`1/E^* = \sum (1-\nu_i)/2G_i` and :math:`1/G^* = \sum (2-\nu_i)/G_i`. At w = 0.5 it is Mindlin's
    :math:`4G^*/E^*`. Within 1.5 % of boundary elements.

    References
    ----------
    Derived here; equation (A13) of :doc:`/equations`.

    Examples
    --------
    >>> steel = {"contact_modulus": 206e9 / 1.82, "tangential_contact_modulus": 206e9 / 2.6 / 3.4}
    >>> [round(float(lay_stiffness_ratio(share=w, **steel)), 3) for w in (0.0, 0.5, 1.0)]
    [0.7, 0.824, 1.0]
    """
    isotropic = 4.0 * tangential_contact_modulus / contact_modulus
    if share is None:
        return isotropic
    return isotropic / (1.0 - (2.0 * share - 1.0) * (1.0 - isotropic))  # (A13)


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
        K_n = f\,\frac N{u_0}, \qquad K_t = \kappa\,K_n \Bigl(1 - \frac T{\mu N}\Bigr)

    with :math:`\kappa = 4 G^*/E^*`, or that of :func:`lay_stiffness_ratio` in the rolling direction with grooves.

    Parameters
    ----------
    roughness : RandomRoughness
        Decay length and lay of the equivalent surface.
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
    normal contact. Equations (A10) and (A13) of :doc:`/equations`.
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
    kappa = lay_stiffness_ratio(
        contact_modulus=contact_modulus,
        tangential_contact_modulus=tangential_contact_modulus,
        share=roughness.rolling_share,
    )
    elastic = (load, xp.zeros_like(load), kappa * normal * held, normal, rigid)
    return RoughContact(*xp.broadcast_arrays(unknown, unknown, unknown, *elastic, unknown, unknown))

r"""How a rolling contact shares its load between its asperities and its oil film.

The film carries what the asperities leave, on bodies that seem as much softer; the asperities carry what the film
thickness leaves of their overlap. Both meet at one thickness.
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

from asperity.contact.film_thickness import FilmInlet, FilmLaw, central_film_by
from asperity.engine.arrays import special, xp
from asperity.engine.module import Module, static
from asperity.implicit import elementwise_root
from asperity.types import Array, Real

#: Separation without pressure over the root mean square of the heights times q_0: Persson's theory of self-affine
#: surfaces of Hurst exponents 0.6 to 0.8 gives 1.02 to 1.32.
SEPARATION_FACTOR = 1.1

#: Logits of the share between which it is sought: shares of 1e-87 to all but as much.
_LARGEST_LOGIT = 200.0
#: Relative change of the logit after which Newton's next one, its square, is not taken [-].
_SMALL_STEP = 1e-6

#: How the load is shared: by the separation of rough surfaces after Persson, or by the rival with the error function.
SharingLaw = Literal["persson", "erf"]


class LoadSharing(NamedTuple):
    """What asperities and film carry, shape (contacts, ...).

    ``asperity_share`` and ``film_share`` of the load, which add up to 1 [-]; ``film_thickness``: central thickness of
    the film that carries its share [m].
    """

    asperity_share: Array
    film_share: Array
    film_thickness: Array


def asperity_separation(
    *,
    asperity_share: Real,
    decay_length: Real,
    rms_height: Real,
    half_width: Real,
    contact_modulus: Real,
    mean_pressure: Real,
) -> Real:
    r"""Mean separation of rough surfaces whose asperities carry a share of the load.

    .. math:: u = u_0 \ln\left(1 + \frac{\beta E^*}{A \bar p}\right), \qquad \beta = 1.1\,\frac{\pi}{a} h_{rms}

    Parameters
    ----------
    asperity_share : Real
        Share A of the load, between 0 and 1 [-].
    decay_length : Real
        Separation u_0 by which their pressure falls by the factor e [m].
    rms_height : Real
        Root mean square of the heights of both surfaces together [m].
    half_width : Real
        Half-width a of the contact [m], whose wavelength 2a is the longest that counts.
    contact_modulus : Real
        E* [Pa].
    mean_pressure : Real
        Mean pressure of the whole load [Pa].

    Returns
    -------
    Real
        Separation [m], positive under any pressure.

    Notes
    -----
    Its tail is the exponential law of the asperities. Below 0.4 heights it is up to 3 times too large. The share that
    follows from it is uncertain by a factor of 1.6 in both directions; :func:`rival_share` stands beside it.

    References
    ----------
    B. N. J. Persson, Phys. Rev. Lett. 99 (2007) 125502; equation (F3) of :doc:`/equations`.
    """
    rough = _Rough(decay_length, rms_height, half_width, contact_modulus / mean_pressure)
    return rough.separation(xp.log(asperity_share))


def shared_load(
    *,
    inlet: FilmInlet,
    decay_length: Array,
    rms_height: Array,
    half_width: Array,
    mean_pressure: Array,
    thickness_factor: Real = 1.0,
    film_law: FilmLaw = "moes",
) -> LoadSharing:
    r"""Shares of asperities and film in the load of a rolling contact.

    .. math::
        \varphi\, h\bigl(w (1 - A), E' (1 - A)\bigr) = u_0 \ln\left(1 + \frac{\beta E^*}{A \bar p}\right)

    Parameters
    ----------
    inlet : FilmInlet
        Oil, speed, load, radius and modulus of the contact under its whole load.
    decay_length, rms_height, half_width, mean_pressure : Array
        As for :func:`asperity_separation`, shape (contacts, ...), positive.
    thickness_factor : Real, optional
        Factor on the thickness of the film, by heat at the inlet and by starvation [-].
    film_law : FilmLaw, optional
        Law of the film.

    Returns
    -------
    LoadSharing
        Its thickness is that of the film that carries its share; nan where the factor on the thickness is not above 0,
        beyond the range of its fit.

    Notes
    -----
    The thickness rises with the share of the asperities and the separation falls: one root at every speed above 0. At
    rest the asperities carry all; that is for the caller, who knows whether anything rolls.

    References
    ----------
    K. L. Johnson, J. A. Greenwood and S. Y. Poon, Wear 19 (1972) 91; equation (F3) of :doc:`/equations`.
    """
    rough = _Rough(decay_length, rms_height, half_width, inlet.contact_modulus / mean_pressure)
    factor = xp.asarray(thickness_factor)
    film = _Film(inlet, xp.where(factor > 0.0, factor, xp.nan), film_law)
    nothing = 0.0 * (mean_pressure + half_width + rms_height)
    ends = nothing - _LARGEST_LOGIT, nothing + _LARGEST_LOGIT
    start = xp.clip(_logit_apart(rough, film), *ends)
    logit = elementwise_root(_misfit, (rough, film), *ends, start, small_step=_SMALL_STEP)
    logit = logit + 0.0 * film.factor
    film_share = xp.exp(-xp.logaddexp(0.0, logit))
    return LoadSharing(xp.exp(-xp.logaddexp(0.0, -logit)), film_share, film.thickness(film_share))


class _Rough(NamedTuple):
    """Decay length, heights and half-width [m], and E* over the mean pressure [-]."""

    decay_length: Real
    rms_height: Real
    half_width: Real
    stiffness: Real

    @property
    def log_height(self) -> Array:
        r"""The logarithm of :math:`\beta E^*/\bar p` [-]."""
        return xp.log(SEPARATION_FACTOR * math.pi * self.rms_height / self.half_width * self.stiffness)

    def separation(self, log_share: Array) -> Array:
        """Of the logarithm of the share of the asperities, which may be too small for a float [m]."""
        return self.decay_length * xp.logaddexp(0.0, self.log_height - log_share)


class _Film(Module):
    """The oil at the inlet, the factor on the thickness of its film [-], and its law."""

    inlet: FilmInlet
    factor: Real
    law: FilmLaw = static()

    def thickness(self, film_share: Array) -> Array:
        """Of a film that carries a share of the load [m]."""
        return self.factor * central_film_by(law=self.law, inlet=self.inlet, film_share=film_share)


def _logit_apart(rough: _Rough, film: _Film) -> Array:
    """Logarithm of the load of the asperities, over the whole one, as far apart as a film that carries all [-]."""
    apart = film.thickness(xp.ones_like(rough.stiffness)) / rough.decay_length
    return rough.log_height - apart - xp.log(-xp.expm1(-apart))


def _misfit(both: tuple[_Rough, _Film], logit: Array) -> Array:
    """Logarithm of film thickness over separation, at the logit of the share of the asperities [-]."""
    rough, film = both
    separation = rough.separation(-xp.logaddexp(0.0, -logit))
    return xp.log(film.thickness(xp.exp(-xp.logaddexp(0.0, logit)))) - xp.log(separation)


def rival_share(*, film_thickness: Real, rms_height: Real) -> Array:
    r"""Share of the asperities by another closure, :math:`A = 1 - \operatorname{erf}(h/\sigma)`.

    Parameters
    ----------
    film_thickness : Real
        Central thickness of a film that carries the whole load [m].
    rms_height : Real
        Root mean square of the heights of both surfaces together [m].

    Returns
    -------
    Array
        Share [-], to be printed beside that of :func:`shared_load`.

    References
    ----------
    A. Arana et al., Proc. IMechE J 233 (2019) 303; equation (F3) of :doc:`/equations`.
    """
    share: Array = special.erfc(xp.asarray(film_thickness) / rms_height)
    return share

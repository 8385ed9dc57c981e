"""Onset of creep when a line contact under a tangential force at rest starts to roll."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np

from asperity.types import Real

#: Share of the final lag over rolled distance in steps of a quarter of the rolling-in length: boundary elements,
# mean over q = 0.1, 0.2, ... 0.8 (``examples/rolling_contact.py``).
_STEP = 0.25
_SHARE = np.array(
    [
        0.0,
        0.2429,
        0.4706,
        0.6805,
        0.8692,
        1.031,
        1.1497,
        1.1745,
        1.0737,
        0.9998,
        0.9735,
        0.9698,
        0.9773,
        0.9898,
        1.0,
    ]
)
#: Its slope at the nodes, over the length: one at the start, where the creepage is half its steady value.
_SLOPE = np.concatenate([[1.0], np.gradient(_SHARE, _STEP)[1:-1], [0.0]])


def rolling_in_length(*, half_width: Real, slip_ratio: Real) -> Real:
    r"""Distance over which a contact changes from rest to steady rolling.

    .. math:: s_0 = a\,(1 - |q|)^{2/3}

    Parameters
    ----------
    half_width : Real
        Half-width a of the contact [m].
    slip_ratio : Real
        Q/(mu N), of either sign [-].

    Returns
    -------
    Real
        Distance [m]; 0 from gross slip on.

    Notes
    -----
    A fit to boundary elements: with this length the transients of all slip ratios up to 0.9 nearly coincide
    (:func:`rolling_in_shift`). The creepage passes its steady value at 1.5 to 1.8 times this length, oscillates about
    it and stays within 3 % after about three times this length.

    References
    ----------
    :mod:`asperity.bem.transient_rolling`, by ``examples/rolling_contact.py``.
    """
    remaining = 1.0 - jnp.abs(slip_ratio)
    sticks = remaining > 0.0
    return jnp.where(sticks, half_width * jnp.where(sticks, remaining, 1.0) ** (2.0 / 3.0), 0.0)


def rolling_in_lag(*, half_width: Real, slip_ratio: Real) -> Real:
    r"""Rolled distance whose steady creep is missing once rolling has become steady.

    .. math:: L = \int_0^\infty \left(1 - \frac{\xi}{\xi_C}\right) \mathrm ds = \tfrac12\,a\,(1 - |q|)^{2/3}

    Parameters
    ----------
    half_width : Real
        Half-width a of the contact [m].
    slip_ratio : Real
        Q/(mu N), of either sign [-].

    Returns
    -------
    Real
        Distance [m].

    Notes
    -----
    Within 2 % of boundary elements for q up to 0.8, 8 % high at q = 0.9 and 18 % high at q = 0.95.

    References
    ----------
    :mod:`asperity.bem.transient_rolling`, by ``examples/rolling_contact.py``.
    """
    return 0.5 * rolling_in_length(half_width=half_width, slip_ratio=slip_ratio)


def _share(x: Real) -> Real:
    """Cubic through the table with a continuous slope; 1 beyond it."""
    within = x < _STEP * (_SHARE.size - 1)
    at = jnp.where(within, x, 0.0) / _STEP
    t = at - jnp.floor(at)
    i = jnp.floor(at).astype(int)
    left, right = jnp.asarray(_SHARE)[i], jnp.asarray(_SHARE)[i + 1]
    rise, fall = jnp.asarray(_SLOPE)[i] * _STEP, jnp.asarray(_SLOPE)[i + 1] * _STEP
    step = t**2 * (3.0 - 2.0 * t)
    cubic = left + (right - left) * step + t * (1.0 - t) * (rise * (1.0 - t) - fall * t)
    return jnp.where(within, cubic, 1.0)


def rolling_in_shift(*, rolled_distance: Real, half_width: Real, slip_ratio: Real, creepage: Real) -> Real:
    r"""Rigid tangential shift of the bodies while they roll under a constant force, from rest.

    .. math:: \delta(s) - \delta(0) = \xi_C \left[s - L\,\varphi(s/s_0)\right]

    Parameters
    ----------
    rolled_distance : Real
        Distance s that the contact has rolled, zero or positive [m].
    half_width : Real
        Half-width a of the contact [m].
    slip_ratio : Real
        Q/(mu N), of either sign [-].
    creepage : Real
        Steady creepage under that force [-].

    Returns
    -------
    Real
        Shift in addition to that of the contact at rest [m].

    Notes
    -----
    Rolling starts at half the steady creepage, whatever the force. The force is applied to the contact at rest
    (Cattaneo and Mindlin) and then kept constant. Within :math:`0.022\,\xi_C a` of boundary elements for q from 0.02 to
    0.95. Not valid for :math:`|q| \ge 1`, where the contact slips. With an even elastic layer of
    :math:`\chi = E c/(2a)` and its own steady creepage: within 0.04 of creepage times half-width for chi up to 0.2 and
    q from 0.3, within 0.09 for q = 0.1, and within 0.16 for chi up to 1.

    References
    ----------
    :mod:`asperity.bem.transient_rolling`, by ``examples/rolling_contact.py``. J. J. Kalker, Three-Dimensional Elastic
    Bodies in Rolling Contact, 1990, section 5.2.2.5 (from Cattaneo to Carter).
    """
    length = rolling_in_length(half_width=half_width, slip_ratio=slip_ratio)
    sticks = length > 0.0
    share = _share(rolled_distance / jnp.where(sticks, length, 1.0))
    lag = rolling_in_lag(half_width=half_width, slip_ratio=slip_ratio)
    return creepage * (rolled_distance - lag * share)

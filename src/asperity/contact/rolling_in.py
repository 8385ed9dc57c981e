"""Creep of a line contact that starts to roll under a tangential force, or that rolls to and fro under a constant one.

The slip that a stroke leaves behind is not taken back by the stroke in the other direction. Material that never leaves
the contact does not slip again, however: short strokes come to rest, and longer ones drift less than steady rolling.
Boundary elements give how much is left (``examples/rolling_swing.py``).
"""

from __future__ import annotations

import numpy as np

from asperity.engine.arrays import entry_of, xp
from asperity.types import Real

#: Share of the final lag over rolled distance in steps of a quarter of the rolling-in length: boundary elements,
# mean over q = 0.1, 0.2, ... 0.8 (``examples/rolling_contact.py``).
_STEP = 0.25
_SHARE = np.array([
    0.0, 0.2429, 0.4706, 0.6805, 0.8692, 1.031, 1.1497, 1.1745,
    1.0737, 0.9998, 0.9735, 0.9698, 0.9773, 0.9898, 1.0,
])  # fmt: skip
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
    remaining = 1.0 - xp.abs(slip_ratio)
    sticks = remaining > 0.0
    return xp.where(sticks, half_width * xp.where(sticks, remaining, 1.0) ** (2.0 / 3.0), 0.0)


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
    at = xp.where(within, x, 0.0) / _STEP
    t = at - xp.floor(at)
    i = xp.floor(at).astype(int)
    left, right = entry_of(_SHARE, i), entry_of(_SHARE, i + 1)
    rise, fall = entry_of(_SLOPE, i) * _STEP, entry_of(_SLOPE, i + 1) * _STEP
    step = t**2 * (3.0 - 2.0 * t)
    cubic = left + (right - left) * step + t * (1.0 - t) * (rise * (1.0 - t) - fall * t)
    return xp.where(within, cubic, 1.0)


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
    share = _share(rolled_distance / xp.where(sticks, length, 1.0))
    lag = rolling_in_lag(half_width=half_width, slip_ratio=slip_ratio)
    return creepage * (rolled_distance - lag * share)


#: Slip ratios, and strokes over a (1 − q), of the table.
SLIP_RATIOS = np.array([0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95])
STROKES = np.array([1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.2, 2.5, 3.0, 3.5, 4.0])

#: Drift of strokes that repeat over that of steady rolling; one row for each slip ratio.
_DRIFT_SHARE = np.array([
    [0.000, 0.000, 0.001, 0.004, 0.025, 0.355, 0.543, 0.625, 0.676, 0.709, 0.744],
    [0.000, 0.000, 0.000, 0.017, 0.208, 0.365, 0.525, 0.615, 0.673, 0.705, 0.737],
    [0.000, 0.000, 0.001, 0.106, 0.235, 0.346, 0.496, 0.600, 0.667, 0.700, 0.729],
    [0.000, 0.000, 0.026, 0.131, 0.231, 0.321, 0.463, 0.579, 0.660, 0.696, 0.723],
    [0.000, 0.000, 0.049, 0.136, 0.220, 0.296, 0.424, 0.552, 0.649, 0.692, 0.718],
    [0.000, 0.000, 0.059, 0.133, 0.205, 0.271, 0.386, 0.516, 0.633, 0.685, 0.714],
    [0.000, 0.001, 0.061, 0.126, 0.188, 0.246, 0.350, 0.473, 0.607, 0.673, 0.709],
    [0.000, 0.006, 0.060, 0.116, 0.170, 0.221, 0.314, 0.428, 0.566, 0.651, 0.699],
    [0.000, 0.009, 0.055, 0.104, 0.151, 0.196, 0.278, 0.382, 0.513, 0.606, 0.671],
    [0.000, 0.009, 0.049, 0.090, 0.130, 0.168, 0.238, 0.330, 0.450, 0.540, 0.609],
    [0.004, 0.008, 0.045, 0.081, 0.116, 0.151, 0.215, 0.296, 0.410, 0.493, 0.562],
])  # fmt: skip


def still_stroke(*, half_width: Real, slip_ratio: Real) -> Real:
    r"""Stroke of one direction up to which a contact that rolls to and fro does not drift.

    .. math:: S_0 = 1.5\,a\,(1 - |q|)

    Parameters
    ----------
    half_width : Real
        Half-width a of the contact [m].
    slip_ratio : Real
        Q/(mu N), of either sign [-].

    Returns
    -------
    Real
        Stroke [m]; 0 from gross slip on.

    Notes
    -----
    A fit to boundary elements on the safe side: drift begins at 1.5 (q = 0.9) to 1.9 (q = 0.02) times a (1 − q). The
    first few strokes creep before the contact comes to rest.

    References
    ----------
    :mod:`asperity.bem.transient_rolling`, by ``examples/rolling_swing.py``.
    """
    return STROKES[0] * half_width * xp.maximum(1.0 - xp.abs(slip_ratio), 0.0)


def swing_drift_share(*, stroke: Real, half_width: Real, slip_ratio: Real) -> Real:
    r"""Drift of a contact that rolls to and fro, per distance rolled, over that of steady rolling.

    .. math:: g\!\left(\frac{S}{a(1-q)}, q\right), \qquad
        g \to 1 - \frac{S_4 (1 - g_4)}{S} \text{ for } S > S_4 = 4\,a\,(1 - q)

    Parameters
    ----------
    stroke : Real
        Distance S rolled in one direction, zero or positive [m].
    half_width : Real
        Half-width a of the contact [m].
    slip_ratio : Real
        Q/(mu N), of either sign [-].

    Returns
    -------
    Real
        Share, 0 to 1 [-]; 1 from gross slip on.

    Notes
    -----
    After many strokes under a constant force. Linear between the entries of a table, and beyond it with the same
    distance lost in every reversal. Within 0.03 of boundary elements for q up to 0.9. An even elastic layer of
    E c/(2a) = 0.2 changes it by up to 0.04 for q from 0.3, and raises it by up to 0.13 for q = 0.05. Beyond q = 0.95
    the row of 0.95 is used.

    References
    ----------
    :mod:`asperity.bem.transient_rolling`, by ``examples/rolling_swing.py``.
    """
    q = xp.abs(xp.asarray(slip_ratio))
    remaining = 1.0 - q
    sticks = remaining > 0.0
    x = xp.asarray(stroke) / (half_width * xp.where(sticks, remaining, 1.0))
    row = xp.clip(xp.searchsorted(xp.asarray(SLIP_RATIOS), q) - 1, 0, SLIP_RATIOS.size - 2)
    low, high = entry_of(SLIP_RATIOS, row), entry_of(SLIP_RATIOS, row + 1)
    weight = xp.clip((q - low) / (high - low), 0.0, 1.0)
    column = xp.clip(xp.searchsorted(xp.asarray(STROKES), x) - 1, 0, STROKES.size - 2)
    left, right = entry_of(STROKES, column), entry_of(STROKES, column + 1)
    along = xp.clip((x - left) / (right - left), 0.0, 1.0)
    table, width = _DRIFT_SHARE.ravel(), STROKES.size

    def at(line: Real) -> Real:
        place = line * width + column
        return entry_of(table, place) * (1.0 - along) + entry_of(table, place + 1) * along

    within = at(row) * (1.0 - weight) + at(row + 1) * weight
    longest = STROKES[-1]
    beyond = 1.0 - longest * (1.0 - within) / xp.where(x > longest, x, longest)
    return xp.where(sticks, xp.where(x > longest, beyond, within), 1.0)

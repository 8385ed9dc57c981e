r"""Drift of a line contact that rolls to and fro under a constant tangential force.

The slip that a stroke leaves behind is not taken back by the stroke in the other direction. Material that never leaves
the contact does not slip again, however: short strokes come to rest, and longer ones drift less than steady rolling.
Boundary elements give how much is left (``examples/rolling_swing.py``).
"""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np

from asperity.types import Real

#: Slip ratios, and strokes over a (1 − q), of the table.
SLIP_RATIOS = np.array([0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95])
STROKES = np.array([1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.2, 2.5, 3.0, 3.5, 4.0])

#: Drift of strokes that repeat over that of steady rolling; one row for each slip ratio.
_SHARE = np.array([
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
    return STROKES[0] * half_width * jnp.maximum(1.0 - jnp.abs(slip_ratio), 0.0)


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
    q = jnp.abs(jnp.asarray(slip_ratio))
    remaining = 1.0 - q
    sticks = remaining > 0.0
    x = jnp.asarray(stroke) / (half_width * jnp.where(sticks, remaining, 1.0))
    row = jnp.clip(jnp.searchsorted(jnp.asarray(SLIP_RATIOS), q) - 1, 0, SLIP_RATIOS.size - 2)
    low, high = jnp.asarray(SLIP_RATIOS)[row], jnp.asarray(SLIP_RATIOS)[row + 1]
    weight = jnp.clip((q - low) / (high - low), 0.0, 1.0)
    column = jnp.clip(jnp.searchsorted(jnp.asarray(STROKES), x) - 1, 0, STROKES.size - 2)
    left, right = jnp.asarray(STROKES)[column], jnp.asarray(STROKES)[column + 1]
    along = jnp.clip((x - left) / (right - left), 0.0, 1.0)
    table = jnp.asarray(_SHARE)

    def at(line: Real) -> Real:
        return table[line, column] * (1.0 - along) + table[line, column + 1] * along

    within = at(row) * (1.0 - weight) + at(row + 1) * weight
    longest = STROKES[-1]
    beyond = 1.0 - longest * (1.0 - within) / jnp.where(x > longest, x, longest)
    return jnp.where(sticks, jnp.where(x > longest, beyond, within), 1.0)

r"""A rolling line contact between rough bodies: asperities as a layer that yields in both directions and has memory.

The nominal pressure of rough elastic surfaces falls exponentially with their separation, by e for each :math:`u_0`. The
layer acts in three ways: it yields sideways, which adds creep; it yields normally, which widens the contact, lowers its
peak and takes creep away; and an asperity that newly touches is unstressed, one that parts lets go. One ratio decides,

.. math:: s = \frac{u_0 R}{a^2}

the yield of the asperities over that of the bodies. The creepage is interpolated in a table
computed by boundary elements (``examples/rolling_layer.py``).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.engine.arrays import xp
from asperity.engine.control import traced_once
from asperity.types import Array, Real

#: Ranges of the table: layer ratio, slip ratio Q/(mu N), and tangential over normal stiffness of the asperities.
LAYER_RATIO_RANGE = (0.003, 1000.0)
SLIP_RATIO_RANGE = (0.01, 0.999)
STIFFNESS_RATIO_RANGE = (2.0 / 3.0, 4.0 / 3.0)
#: Range in which the parabola through the three stiffness ratios of the table holds: that of surfaces with grooves.
GROOVED_RANGE = (0.5, 2.0)

# Coefficients of the series below this are left out behind the last larger one: at most 0.1 % of the creepage.
_NEGLIGIBLE = 1e-3

#: Creepage over Carter's less one, over s/sqrt(1 + s): layer ratios first, then slip ratios and reciprocal stiffness
# ratios, all at :func:`table_nodes`, the largest first; by ``examples/rolling_layer.py``.
# fmt: off
_TABLE = np.array([
    [
        [4.2367, 4.1334, 3.8318, 3.3626, 2.796, 2.271, 1.9685, 1.8764, 1.8577, 1.8434, 1.8449],
        [4.2337, 4.1303, 3.8287, 3.3594, 2.7927, 2.2677, 1.9652, 1.8731, 1.8543, 1.8401, 1.8416],
        [4.2231, 4.1196, 3.8179, 3.3483, 2.7813, 2.256, 1.9533, 1.8612, 1.8424, 1.8282, 1.8297],
        [4.2007, 4.097, 3.7946, 3.3241, 2.7558, 2.2295, 1.9263, 1.8341, 1.8153, 1.801, 1.8025],
        [4.1655, 4.0609, 3.7558, 3.2811, 2.7077, 2.1768, 1.8715, 1.7787, 1.7598, 1.7454, 1.7469],
        [4.1714, 4.0625, 3.744, 3.2488, 2.6504, 2.0979, 1.7824, 1.6866, 1.6676, 1.6526, 1.6542],
        [4.5597, 4.4291, 4.0475, 3.4524, 2.7338, 2.0799, 1.7196, 1.6144, 1.5929, 1.5756, 1.5777],
        [6.2124, 6.0006, 5.3785, 4.4065, 3.2498, 2.2632, 1.7922, 1.6752, 1.6495, 1.639, 1.6311],
        [9.7526, 9.3219, 8.0658, 6.1513, 4.0595, 2.5561, 2.005, 1.943, 1.9413, 1.9413, 1.9323],
        [14.737, 13.884, 11.465, 8.0793, 4.949, 3.0353, 2.3832, 2.4461, 2.5189, 2.5429, 2.5491],
        [19.802, 18.4, 14.609, 9.8532, 5.9759, 3.6689, 2.8432, 2.986, 3.2113, 3.2803, 3.2995],
        [23.477, 21.636, 16.857, 11.267, 6.8747, 4.219, 3.2337, 3.3851, 3.7504, 3.8877, 3.9171],
        [24.816, 22.816, 17.697, 11.83, 7.2361, 4.4382, 3.3885, 3.5342, 3.9511, 4.1186, 4.1551],
    ],
    [
        [3.1697, 3.0922, 2.866, 2.5141, 2.0892, 1.6955, 1.4686, 1.3995, 1.3855, 1.3748, 1.3759],
        [3.1665, 3.089, 2.8628, 2.5108, 2.0859, 1.6921, 1.4652, 1.3962, 1.3821, 1.3714, 1.3725],
        [3.1553, 3.0777, 2.8514, 2.4993, 2.0741, 1.6801, 1.4532, 1.3841, 1.37, 1.3593, 1.3604],
        [3.1307, 3.053, 2.8262, 2.4734, 2.0474, 1.6528, 1.4254, 1.3562, 1.3421, 1.3314, 1.3326],
        [3.0862, 3.0078, 2.7791, 2.4234, 1.9939, 1.5963, 1.3675, 1.2978, 1.2837, 1.2729, 1.2741],
        [3.0467, 2.9652, 2.7271, 2.3573, 1.9112, 1.4993, 1.2636, 1.1917, 1.1775, 1.1662, 1.1674],
        [3.2176, 3.1211, 2.8395, 2.4026, 1.8786, 1.4025, 1.1371, 1.0587, 1.0422, 1.029, 1.0306],
        [4.0674, 3.9177, 3.4829, 2.8145, 2.0364, 1.3771, 1.0491, 0.96175, 0.94014, 0.93432, 0.92565],
        [5.6338, 5.3647, 4.5924, 3.4538, 2.2534, 1.3942, 1.0404, 0.97053, 0.95982, 0.95841, 0.95284],
        [7.3534, 6.9059, 5.6654, 3.9908, 2.4687, 1.5034, 1.125, 1.0892, 1.1034, 1.0986, 1.1096],
        [8.7577, 8.1348, 6.4861, 4.4527, 2.7431, 1.672, 1.2468, 1.2277, 1.2836, 1.3049, 1.3031],
        [9.6781, 8.9451, 7.0647, 4.8382, 2.9889, 1.8212, 1.3523, 1.3327, 1.4247, 1.4654, 1.4711],
        [10.009, 9.2412, 7.2878, 4.994, 3.088, 1.8808, 1.3943, 1.3723, 1.4766, 1.5271, 1.536],
    ],
    [
        [2.1027, 2.051, 1.9002, 1.6656, 1.3824, 1.1199, 0.96869, 0.92265, 0.91326, 0.90613, 0.90689],
        [2.0993, 2.0476, 1.8969, 1.6623, 1.379, 1.1165, 0.96528, 0.91923, 0.90985, 0.90271, 0.90347],
        [2.0875, 2.0358, 1.885, 1.6503, 1.3669, 1.1043, 0.95303, 0.90696, 0.89757, 0.89044, 0.8912],
        [2.0608, 2.0089, 1.8578, 1.6227, 1.3389, 1.076, 0.92456, 0.87842, 0.86903, 0.86187, 0.86264],
        [2.0068, 1.9546, 1.8024, 1.5657, 1.2801, 1.0158, 0.8635, 0.81704, 0.80763, 0.80041, 0.80118],
        [1.9219, 1.8679, 1.7103, 1.4659, 1.1719, 0.90072, 0.74468, 0.69677, 0.68733, 0.67976, 0.68059],
        [1.8755, 1.813, 1.6316, 1.353, 1.0235, 0.72511, 0.55427, 0.50245, 0.49113, 0.48237, 0.48316],
        [1.9249, 1.8383, 1.5909, 1.2266, 0.82443, 0.48859, 0.29857, 0.23529, 0.21917, 0.2155, 0.2091],
        [1.5618, 1.4556, 1.1683, 0.78653, 0.42717, 0.17977, 0.020367, -0.079872, -0.11365, -0.11982, -0.12177],
        [0.27311, 0.21155, 0.060489, -0.095833, -0.17691, -0.1979, -0.26649, -0.4255, -0.52125, -0.55638, -0.55388],
        [-1.5902, -1.556, -1.4341, -1.1938, -0.87502, -0.61804, -0.56653, -0.7452, -0.93515, -1.0064, -1.0217],
        [-3.2791, -3.1465, -2.7486, -2.1306, -1.4586, -0.96555, -0.81122, -0.98075, -1.2424, -1.3628, -1.3917],
        [-3.9678, -3.7925, -3.277, -2.503, -1.689, -1.1022, -0.90714, -1.0701, -1.355, -1.4979, -1.5326],
    ],
]).transpose(1, 2, 0)
#: Peak pressure over Hertz's, times sqrt(1 + 8 s/pi), at the same layer ratios.
_PEAKS = np.array([
    1.00002, 1.00003, 1.00005, 1.00015, 1.00055, 1.00242, 1.00993, 1.02069, 1.01319, 1.00472, 1.00185, 1.001, 1.00081,
])
# fmt: on


def layer_ratio(*, contact_modulus: Real, contact_length: Real, normal_stiffness: Real) -> Real:
    r"""Yield of the asperities over that of the bodies.

    .. math::
        s = \frac{u_0 R}{a^2} = \frac{\pi E B}{4 N/u_0}, \qquad a^2 = \frac{4 N R}{\pi E B}

    Parameters
    ----------
    contact_modulus : Real
        Contact modulus E [Pa].
    contact_length : Real
        Contact line length B [m].
    normal_stiffness : Real
        Normal stiffness N/u_0 of the asperities of the whole contact between rigid bodies, positive [N/m].

    Returns
    -------
    Real
        Ratio [-].

    Notes
    -----
    The pressure falls by the factor e in u_0. The law of Zou et al. 2025 is one of K_n alone, its local form is not
    published: :math:`u_0 = N/K_n` is then assumed to act at every place of the contact.

    References
    ----------
    B. N. J. Persson, Phys. Rev. Lett. 99 (2007) 125502 (the exponential); equation (B1) of :doc:`/equations`.

    Examples
    --------
    >>> round(layer_ratio(contact_modulus=113.19e9, contact_length=5e-3, normal_stiffness=3.37e9), 3)
    0.132
    """
    return 0.25 * math.pi * contact_modulus * contact_length / normal_stiffness


def width_factor(*, layer_ratio: Real) -> Real:
    r"""Width of the contact with asperities over Hertz's, :math:`\sqrt{1 + 4 s}`.

    Parameters
    ----------
    layer_ratio : Real
        s, zero or positive [-].

    Returns
    -------
    Real
        Factor [-].

    Notes
    -----
    Exact for the root mean square of the places at which the load acts; the pressure has no edge. From the balance
    of displacements, differentiated, times :math:`x p`, integrated.

    References
    ----------
    Equation (B1) of :doc:`/equations`.

    Examples
    --------
    >>> float(width_factor(layer_ratio=0.11))
    1.2
    """
    return xp.sqrt(1.0 + 4.0 * layer_ratio)


def table_nodes(shape: tuple[int, int, int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    r"""Ratios at which the table has its entries: Chebyshev's points.

    .. math:: \ln s_i, \quad \ln\frac{q_j}{1 - q_j} \text{ and } \frac1{\kappa_k} \text{ in } \cos\frac{\pi i}{m - 1}

    Parameters
    ----------
    shape : tuple of int
        Number of layer ratios, slip ratios and stiffness ratios.

    Returns
    -------
    tuple of ndarray
        Layer ratios s and slip ratios q, the largest first, and stiffness ratios kappa, the smallest first [-].

    References
    ----------
    L. N. Trefethen, Approximation Theory and Approximation Practice, 2013, chapter 2.
    """
    s, q, kappa = (
        low + (high - low) * (0.5 + 0.5 * np.cos(np.pi * np.arange(m) / (m - 1)))
        for m, (low, high) in zip(shape, (_LOG_LAYER, _LOGIT_SLIP, _SOFTNESS), strict=True)
    )
    return np.exp(s), 1.0 / (1.0 + np.exp(-q)), 1.0 / kappa


_LOG_LAYER = (math.log(LAYER_RATIO_RANGE[0]), math.log(LAYER_RATIO_RANGE[1]))
_LOGIT_SLIP = (
    math.log(SLIP_RATIO_RANGE[0] / (1.0 - SLIP_RATIO_RANGE[0])),
    math.log(SLIP_RATIO_RANGE[1] / (1.0 - SLIP_RATIO_RANGE[1])),
)
_SOFTNESS = (1.0 / STIFFNESS_RATIO_RANGE[1], 1.0 / STIFFNESS_RATIO_RANGE[0])


def _values_to_series(count: int) -> np.ndarray:
    """From values at Chebyshev's points to the coefficients of his series."""
    return np.linalg.inv(
        np.polynomial.chebyshev.chebvander(np.cos(np.pi * np.arange(count) / (count - 1)), count - 1)
    )


def _series_to_powers(count: int) -> np.ndarray:
    """From the coefficients of Chebyshev's series to those of powers."""
    rows = np.zeros((count, count))
    for k, polynomial in enumerate(np.eye(count)):
        rows[: k + 1, k] = np.polynomial.chebyshev.cheb2poly(polynomial)
    return rows


def _coefficients() -> np.ndarray:
    """Of the powers of the layer ratio, of the softness of the asperities and of the slip ratio, one axis each.

    Each row of Chebyshev's series ends at its last coefficient of some size. The series is summed in powers: of degree
    12 that costs three digits of sixteen, and each step of Horner's rule needs its predecessor once, which compiled
    programs keep in a register.
    """
    series = np.einsum("ai,bj,ck,ijk->abc", *(_values_to_series(m) for m in _TABLE.shape), _TABLE)
    matters = np.logical_or.accumulate((np.abs(series) > _NEGLIGIBLE)[:, ::-1], axis=1)[:, ::-1]
    return np.einsum(
        "ai,bj,ck,ijk->acb", *(_series_to_powers(m) for m in _TABLE.shape), np.where(matters, series, 0.0)
    )


_COEFFICIENTS = _coefficients()
_PEAK_COEFFICIENTS = _series_to_powers(_PEAKS.size) @ _values_to_series(_PEAKS.size) @ _PEAKS


def _position(value: Real, ends: tuple[float, float]) -> Real:
    """-1 to 1 between the ends, constant beyond."""
    return xp.clip((2.0 * value - sum(ends)) / (ends[1] - ends[0]), -1.0, 1.0)


def _soft_position(stiffness_ratio: Real) -> Real:
    """As :func:`_position` of the reciprocal stiffness ratio, beyond the table too, to the ends of grooved surfaces."""
    low, high = _SOFTNESS
    softness = xp.clip(1.0 / stiffness_ratio, 1.0 / GROOVED_RANGE[1], 1.0 / GROOVED_RANGE[0])
    return (2.0 * softness - (low + high)) / (high - low)


def _power_sum(coefficients: Array | np.ndarray, x: Real) -> Array:
    """Sums of powers of numbers x, whose coefficients lie along the first axis, the constant first."""
    total: Array = coefficients[-1]
    for k in reversed(range(len(coefficients) - 1)):
        total = total * x + coefficients[k]
    return total


def _layer_position(layer_ratio: Real) -> Real:
    ratio = xp.where(layer_ratio > 0.0, layer_ratio, LAYER_RATIO_RANGE[0])
    return _position(xp.log(ratio), _LOG_LAYER)


def peak_pressure_factor(*, layer_ratio: Real) -> Real:
    r"""Peak pressure with asperities over Hertz's.

    .. math:: \frac{p_{max}}{p_0} = \frac{h(s)}{\sqrt{1 + 8 s/\pi}}

    with h, between 1 and 1.021, from a table of boundary-element results.

    Parameters
    ----------
    layer_ratio : Real
        s of :func:`layer_ratio`, zero or positive [-].

    Returns
    -------
    Real
        Factor on Hertz's peak pressure [-].

    Notes
    -----
    Interpolation within 0.03 %. For a soft layer the pressure is Gauss's curve, h = 1.

    References
    ----------
    :mod:`asperity.bem.rough_rolling`, by ``examples/rolling_layer.py``; equation (B1) of :doc:`/equations`.
    """
    return _power_sum(_PEAK_COEFFICIENTS, _layer_position(layer_ratio)) / xp.sqrt(
        1.0 + 8.0 / math.pi * layer_ratio
    )


def layer_creepage_factor(*, layer_ratio: Real, slip_ratio: Real, stiffness_ratio: Real) -> Real:
    r"""Steady creepage with asperities over Carter's at the same traction.

    .. math:: \frac{\xi}{\xi_C} = 1 + \frac{s}{\sqrt{1 + s}}\, g(s, q, \kappa)

    with g from a table of boundary-element results. Every material point carries a bundle of springs that touch at all
    separations, with Coulomb's friction each.

    Parameters
    ----------
    layer_ratio : Real
        s of :func:`layer_ratio`, zero or positive [-].
    slip_ratio : Real
        q = Q/(mu N), of either sign [-].
    stiffness_ratio : Real
        kappa, tangential over normal stiffness of the asperities: :math:`2(1-\nu)/(2-\nu)` for like bodies; across the
        rolling direction times :func:`asperity.contact.skew.lateral_compliance_ratio` [-].

    Returns
    -------
    Real
        Factor on Carter's creepage [-]; about 1 + 1.1 s for s up to 0.2, q up to 0.5 and steel.

    Notes
    -----
    Interpolation within 0.2 % for s up to 1 and 0.6 % up to 1000, q from 0.01 to 0.999 and every Poisson ratio, of
    surfaces without grooves; with grooves, kappa from 0.5 to 2, within 1.1 % for s up to 2. For
    s below 0.003 and for smaller q, g is constant: at most 0.2 % of the creepage. Beyond 1000 it is constant too,
    within 5 % of the limit of soft asperities, :math:`\xi \propto \sqrt s/\kappa`. Above q = 0.999 the factor keeps its
    value, while the creepage grows slowly without limit: far in front of the contact, where only few asperities
    touch, some stick under any creepage.

    References
    ----------
    :mod:`asperity.bem.rough_rolling`, by ``examples/rolling_layer.py``; equation (B1) of :doc:`/equations`.
    """
    law = layer_law(layer_ratio=layer_ratio, stiffness_ratio=stiffness_ratio)
    return factor_on_creepage(law=law, slip_ratio=slip_ratio)


class LayerLaw(NamedTuple):
    r"""What :func:`layer_creepage_factor` is over the slip ratio: coefficients of its powers, and their factor.

    ``powers``: the first axis belongs to the powers of the slip ratio's position; ``scale``: :math:`s/\sqrt{1 + s}`.
    """

    powers: Array
    scale: Real


@traced_once  # traced once for all states of the contacts
def layer_law(*, layer_ratio: Real, stiffness_ratio: Real) -> LayerLaw:
    r"""The asperities of contacts as a layer, for any slip ratio.

    .. math:: \frac{\xi}{\xi_C} = 1 + \frac{s}{\sqrt{1 + s}}\, g(s, q, \kappa)

    with g as a polynomial of the position of q.

    Parameters
    ----------
    layer_ratio : Real
        s, zero or positive [-].
    stiffness_ratio : Real
        kappa, tangential over normal stiffness of the asperities [-].

    Returns
    -------
    LayerLaw
        For :func:`factor_on_creepage`; valid as :func:`layer_creepage_factor` is.

    References
    ----------
    Equation (B1) of :doc:`/equations`.
    """
    x, v = _layer_position(layer_ratio), _soft_position(stiffness_ratio)
    table = _COEFFICIENTS.reshape(*_COEFFICIENTS.shape, *(1,) * xp.ndim(x + v))
    # the slip ratio last: a derivative by it concerns one sum of three
    powers = _power_sum(_power_sum(table, x), v)
    return LayerLaw(powers, layer_ratio / xp.sqrt(1.0 + layer_ratio))


@traced_once
def factor_on_creepage(*, law: LayerLaw, slip_ratio: Real) -> Real:
    r"""Steady creepage with asperities over Carter's at the same traction, of a layer that is known.

    .. math:: \frac{\xi}{\xi_C} = 1 + \frac{s}{\sqrt{1 + s}}\, g(s, q, \kappa)

    Parameters
    ----------
    law : LayerLaw
        The layer, :func:`layer_law`.
    slip_ratio : Real
        q = Q/(mu N), of either sign [-].

    Returns
    -------
    Real
        Factor on Carter's creepage [-]; valid as :func:`layer_creepage_factor` is.

    References
    ----------
    Equation (B1) of :doc:`/equations`.
    """
    q = xp.clip(xp.abs(slip_ratio), *SLIP_RATIO_RANGE)
    return 1.0 + law.scale * _power_sum(law.powers, _position(xp.log(q / (1.0 - q)), _LOGIT_SLIP))

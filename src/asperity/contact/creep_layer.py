r"""Creepage of a rolling line contact with a thin elastic layer between the bodies, such as their asperities.

The layer's tangential compliance enters through one ratio, :math:`\chi = E c/(2a) = E B/K_t`. Its effect on the
creepage is interpolated in a table computed by boundary elements (``examples/rolling_layer.py``).
"""

from __future__ import annotations

import math

import jax
import jax.numpy as jnp
import numpy as np

from asperity.types import Real

#: Ranges of the tables: ratio of the compliances, and slip ratio Q/(mu N).
LAYER_RATIO_RANGE = (0.005, 20.0)
SLIP_RATIO_RANGE = (0.02, 0.98)

# Coefficients of the series below this are left out behind the last larger one: at most 0.08 % of the creepage.
_NEGLIGIBLE = 2e-4

#: Creepage over Carter's for a uniform layer. One row for each ratio chi, one column for each slip ratio q, both
# at :func:`table_nodes`, the largest first; by ``examples/rolling_layer.py``.
# fmt: off
_UNIFORM_LAYER = np.array([
    [62.0812, 58.9062, 50.9013, 41.5568, 34.325, 31.1347, 31.1239, 31.7644, 32.1244, 32.2204, 32.254],
    [45.5544, 43.2394, 37.4021, 30.5869, 25.308, 22.9721, 22.9612, 23.432, 23.6974, 23.768, 23.7928],
    [19.151, 18.2096, 15.8355, 13.0612, 10.9027, 9.93274, 9.92275, 10.1219, 10.2349, 10.2656, 10.2763],
    [5.74888, 5.50472, 4.88822, 4.16505, 3.5926, 3.32096, 3.31205, 3.37213, 3.4072, 3.41838, 3.42194],
    [1.99303, 1.94375, 1.81902, 1.67028, 1.5471, 1.48209, 1.47636, 1.49384, 1.50622, 1.5122, 1.51304],
    [1.21925, 1.20931, 1.18363, 1.15176, 1.12374, 1.10752, 1.10484, 1.10932, 1.11402, 1.11661, 1.11731],
    [1.06478, 1.062, 1.05468, 1.04527, 1.0367, 1.03147, 1.03027, 1.0314, 1.0329, 1.03392, 1.03426],
    [1.02913, 1.02788, 1.02458, 1.0203, 1.01634, 1.0139, 1.01325, 1.01366, 1.01431, 1.01481, 1.01493],
    [1.02198, 1.02104, 1.01855, 1.01529, 1.01229, 1.01042, 1.00991, 1.01021, 1.01066, 1.01101, 1.01113],
])
#: The same for a layer whose compliance is inversely proportional to the pressure.
_PRESSURE_LAYER = np.array([
    [95.5751, 90.3916, 76.9055, 60.0361, 44.6174, 33.5471, 27.8568, 27.7431,
     29.8836, 31.1791, 31.8264, 32.1257, 32.2615, 32.3201, 32.3366],
    [69.9844, 66.2042, 56.3704, 44.0701, 32.8282, 24.7564, 20.5993, 20.4858,
     22.0642, 23.0206, 23.4986, 23.7195, 23.8198, 23.8631, 23.8753],
    [29.1002, 27.5619, 23.5632, 18.5624, 13.9935, 10.7119, 9.00522, 8.89776,
     9.57244, 9.9874, 10.1948, 10.2906, 10.3341, 10.3529, 10.3582],
    [8.34819, 7.94784, 6.91109, 5.61487, 4.43241, 3.58147, 3.12233, 3.04255,
     3.23522, 3.37546, 3.44555, 3.47794, 3.49265, 3.499, 3.50078],
    [2.53408, 2.45368, 2.2451, 1.98568, 1.74951, 1.57629, 1.4734, 1.43736,
     1.46431, 1.52233, 1.55394, 1.56855, 1.57518, 1.57804, 1.57885],
    [1.3425, 1.32681, 1.2862, 1.23524, 1.18703, 1.14853, 1.12241, 1.1097,
     1.11038, 1.12293, 1.14157, 1.15231, 1.15718, 1.15928, 1.15987],
    [1.10915, 1.10509, 1.0943, 1.07999, 1.06533, 1.05259, 1.04321, 1.03793,
     1.03683, 1.03931, 1.04448, 1.05083, 1.05525, 1.05717, 1.0577],
    [1.05458, 1.05274, 1.04779, 1.04097, 1.03373, 1.02722, 1.02227, 1.01932,
     1.01839, 1.01916, 1.02113, 1.0238, 1.02644, 1.02817, 1.02869],
    [1.04319, 1.04178, 1.03793, 1.0326, 1.02688, 1.0217, 1.01772, 1.01532,
     1.0145, 1.01497, 1.01637, 1.01832, 1.02028, 1.02167, 1.02216],
])
# fmt: on


def layer_ratio(*, contact_modulus: Real, contact_length: Real, tangential_stiffness: Real) -> Real:
    r"""Compliance of a layer over that of the bodies.

    .. math:: \chi = \frac{E B}{K_t} = \frac{E c}{2a}, \qquad c = \frac{2 a B}{K_t}

    Parameters
    ----------
    contact_modulus : Real
        Contact modulus E [Pa].
    contact_length : Real
        Contact line length B [m].
    tangential_stiffness : Real
        Tangential stiffness K_t of the layer, the asperities of the whole contact [N/m].

    Returns
    -------
    Real
        Ratio [-].

    References
    ----------
    Definition; c is the layer's tangential compliance per area [m/Pa], a the half-width.

    Examples
    --------
    >>> round(layer_ratio(contact_modulus=113.19e9, contact_length=5e-3, tangential_stiffness=2.777e9), 2)
    0.2
    """
    return contact_modulus * contact_length / tangential_stiffness


def small_slip_creepage_factor(*, layer_ratio: Real) -> Real:
    r"""Creepage over Carter's for small traction, with bodies and layer in series.

    .. math:: \frac{\xi}{\xi_C} = 1 + \frac\pi2 \chi

    Parameters
    ----------
    layer_ratio : Real
        chi [-].

    Returns
    -------
    Real
        Factor on the creepage [-].

    Notes
    -----
    Exact for small traction with a soft layer (a brush, :math:`\chi \to \infty`). Compared with a uniform layer
    (:func:`uniform_layer_creepage_factor`), chi up to 20, it is between 1.5 % low and 5 % high for q up to 0.5, 8 %
    low at q = 0.8 and 33 % low at q = 0.95. Compared with a layer that is stiffer where the pressure is higher
    (:func:`pressure_layer_creepage_factor`) it is between 6 % low and 19 % high for q up to 0.8.

    References
    ----------
    Brush: J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990, section 2.2 (simplified theory).
    """
    return 1.0 + 0.5 * math.pi * layer_ratio


def table_nodes(shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    r"""Ratios and slip ratios at which the table has its entries: Chebyshev's points.

    .. math:: \ln\chi_i \text{ and } \ln\frac{q_j}{1 - q_j} \text{ in } \cos\frac{\pi i}{m - 1}

    Parameters
    ----------
    shape : tuple of int
        Number of ratios and of slip ratios.

    Returns
    -------
    tuple of ndarray
        Ratios chi and slip ratios q, the largest first [-].

    References
    ----------
    L. N. Trefethen, Approximation Theory and Approximation Practice, 2013, chapter 2.
    """
    chi_low, chi_high = (math.log(x) for x in LAYER_RATIO_RANGE)
    q_low, q_high = (math.log(x / (1.0 - x)) for x in SLIP_RATIO_RANGE)
    across, along = (0.5 + 0.5 * np.cos(np.pi * np.arange(m) / (m - 1)) for m in shape)
    return (
        np.exp(chi_low + across * (chi_high - chi_low)),
        1.0 / (1.0 + np.exp(-(q_low + along * (q_high - q_low)))),
    )


def _chebyshev_in_powers(count: int) -> np.ndarray:
    """Coefficients of Chebyshev's polynomials in powers, one polynomial a row."""
    rows = np.zeros((count, count))
    for k, polynomial in enumerate(np.eye(count)):
        rows[k, : k + 1] = np.polynomial.chebyshev.cheb2poly(polynomial)
    return rows


def _coefficients(table: np.ndarray) -> list[list[float]]:
    """Coefficients of ln[(f - 1)/(pi chi/2)] as a polynomial in both positions, the constant first.

    Each row of Chebyshev's series ends at its last coefficient of some size. The series is summed in powers: of degree
    14 that costs three digits of sixteen, and each step of Horner's rule needs its predecessor once, which compiled
    programs keep in a register.
    """
    chi, _ = table_nodes(table.shape)
    values = np.log((table - 1.0) / (0.5 * np.pi * chi[:, None]))
    rows, columns = (
        np.polynomial.chebyshev.chebvander(np.cos(np.pi * np.arange(m) / (m - 1)), m - 1) for m in table.shape
    )
    series = np.linalg.solve(rows, np.linalg.solve(columns, values.T).T)
    matters = np.logical_or.accumulate((np.abs(series) > _NEGLIGIBLE)[:, ::-1], axis=1)[:, ::-1]
    across, along = (_chebyshev_in_powers(m) for m in table.shape)
    powers = across.T @ np.where(matters, series, 0.0) @ along
    counts = matters.sum(axis=1)
    # in powers, a row takes something from every second row behind it
    return [list(row[: counts[k::2].max()]) for k, row in enumerate(powers)]


_UNIFORM_COEFFICIENTS = _coefficients(_UNIFORM_LAYER)
_PRESSURE_COEFFICIENTS = _coefficients(_PRESSURE_LAYER)


def _position(value: Real, low: float, high: float) -> Real:
    """-1 to 1 between low and high, constant beyond."""
    return jnp.clip((2.0 * value - low - high) / (high - low), -1.0, 1.0)


def _horner(coefficients: list, x: Real) -> Real:
    """Sum of powers, the constant first."""
    total = coefficients[-1]
    for c in coefficients[-2::-1]:
        total = total * x + c
    return total


def _tabulated(coefficients: list[list[float]], layer_ratio: Real, slip_ratio: Real) -> Real:
    chi = jnp.where(layer_ratio > 0.0, layer_ratio, LAYER_RATIO_RANGE[0])
    q = jnp.clip(jnp.abs(slip_ratio), *SLIP_RATIO_RANGE)
    x = _position(jnp.log(chi), *(math.log(v) for v in LAYER_RATIO_RANGE))
    y = _position(jnp.log(q / (1.0 - q)), *(math.log(v / (1.0 - v)) for v in SLIP_RATIO_RANGE))
    shape = _horner([_horner(row, y) for row in coefficients], x)
    return 1.0 + 0.5 * math.pi * layer_ratio * jnp.exp(shape)


@jax.jit  # traced once for all states of the contacts
def uniform_layer_creepage_factor(*, layer_ratio: Real, slip_ratio: Real) -> Real:
    r"""Steady creepage over Carter's with a layer of uniform tangential compliance.

    .. math:: \frac{\xi}{\xi_C} = 1 + \frac\pi2\,\chi\, g(\chi, q)

    with g, near one, from a table of boundary-element results.

    Parameters
    ----------
    layer_ratio : Real
        chi of :func:`layer_ratio`, zero or positive [-].
    slip_ratio : Real
        q = Q/(mu N), of either sign [-].

    Returns
    -------
    Real
        Factor on Carter's creepage at the same traction [-].

    Notes
    -----
    Interpolation within 0.15 % for chi from 0.005 to 20 and q from 0.02 to 0.98. Beyond, g is constant: the error is
    at most 0.5 % of the creepage for smaller or larger chi and for smaller q. Above q = 0.98 it is too small:
    by 5 % at chi = 0.1 and 14 % at chi = 1 for q = 0.99. The creepage grows like :math:`(1 - q)^{-1/3}` without
    limit, because at the leading edge the traction of the layer always starts below the friction limit.

    References
    ----------
    :mod:`asperity.bem.steady_rolling`, by ``examples/rolling_layer.py``.
    """
    return _tabulated(_UNIFORM_COEFFICIENTS, layer_ratio, slip_ratio)


def pressure_layer_creepage_factor(*, layer_ratio: Real, slip_ratio: Real) -> Real:
    r"""Steady creepage over Carter's with a layer whose compliance is inversely proportional to the pressure.

    .. math:: c(x) = c\,\frac{\bar p}{p(x)}, \qquad \frac{\xi}{\xi_C} = 1 + \frac\pi2\,\chi\, g(\chi, q)

    with the mean pressure :math:`\bar p`, so that the layer's stiffness :math:`K_t = 2aB/c` is the same. The contact
    of rough surfaces is stiffer in proportion to the pressure.

    Parameters
    ----------
    layer_ratio : Real
        chi of :func:`layer_ratio`, zero or positive [-].
    slip_ratio : Real
        q = Q/(mu N), of either sign [-].

    Returns
    -------
    Real
        Factor on Carter's creepage at the same traction [-].

    Notes
    -----
    Interpolation within 0.25 % for chi from 0.005 to 20 and q from 0.02 to 0.98. Beyond, g is constant, as in
    :func:`uniform_layer_creepage_factor`; above q = 0.98 it is too small, by 14 % at chi = 0.1 and
    30 % at chi = 1 for q = 0.99. The creepage grows like :math:`(1 - q)^{-2/3}`.

    References
    ----------
    :mod:`asperity.bem.steady_rolling`, by ``examples/rolling_layer.py``.
    """
    return _tabulated(_PRESSURE_COEFFICIENTS, layer_ratio, slip_ratio)

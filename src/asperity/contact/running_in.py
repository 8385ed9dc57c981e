r"""How much stiffer a rough contact is after running in: its peaks are flattened where they were pressed beyond H.

Pressed for the first time, peaks flow where the pressure reaches the hardness; afterwards the contact is elastic, on a
surface that conforms. The rms of the heights falls by at most a seventh, so that Rq does not show it. One ratio
decides, the hardness over the pressure that an elastic surface of this rms slope h' has,

.. math:: \frac{H}{E^* h'}
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from asperity.errors import InputError


class RunIn(NamedTuple):
    """Boundary elements of surfaces that ran in at their full load.

    ``hardness_ratios`` H/(E* h'), falling; ``full`` and ``half``: stiffness k u_0/p at the full load and at half of it,
    u_0 0.48 of the rms of the heights, the middle of the simulations; ``elastic``, the same without running in.
    """

    hardness_ratios: tuple[float, ...]
    full: tuple[float, ...]
    half: tuple[float, ...]
    elastic: float


#: Hills of all directions, by the rms gradient; and strips of endless grooves, by the rms slope across them.
HILLS = RunIn((0.85, 0.38, 0.19), (1.075, 1.35, 2.2), (1.13, 1.8, 3.3), 1.07)
STRIPS = RunIn((0.53, 0.27), (1.25, 1.7), (1.35, 2.15), 1.15)
#: How far single surfaces are from the factor, relative.
UNCERTAINTY = 0.1


def run_in_factor(*, hardness_ratio: float, strips: bool, load_share: float) -> float:
    r"""Stiffness of the asperities after running in over that of the elastic surface, at the same load.

    .. math::
        \frac{k}{k_{elastic}} = \frac{k_{table}(H/E^*h', N/N_{max})}{k_{elastic, table}}

    Parameters
    ----------
    hardness_ratio : float
        H/(E* h') with the hardness of the softer body and the rms gradient h' of the waves that the contact feels; of
        strips the rms of the slope across the grooves [-].
    strips : bool
        Whether the surface consists of endless grooves.
    load_share : float
        Load over the one at which the contact ran in, from 0.5 to 1 [-].

    Returns
    -------
    float
        Factor on :math:`1/u_0` [-].

    Raises
    ------
    InputError
        Outside of the ratios and loads that were simulated.

    Notes
    -----
    Between the ratios of the table the logarithms are interpolated, between the loads the factor. The simulations
    scatter by a tenth, :data:`UNCERTAINTY`. Below the least ratio nearly all spots flow; above the largest one running
    in changes little.

    References
    ----------
    Periodic boundary elements with the pressure capped at H, elastic afterwards; equation (A14) of :doc:`/equations`.

    Examples
    --------
    >>> round(run_in_factor(hardness_ratio=0.38, strips=False, load_share=1.0), 2)
    1.26
    """
    table = STRIPS if strips else HILLS
    most, *_, least = table.hardness_ratios
    if not least <= hardness_ratio <= most:
        raise InputError(
            f"H/(E h') = {hardness_ratio:.3g} is outside of the {least:g} to {most:g} for which running in of "
            f"{'grooves' if strips else 'rough surfaces'} is known"
        )
    if not 0.5 <= load_share <= 1.0:
        raise InputError(
            f"a load of {load_share:g} times that of running in: known is what happens from 0.5 to 1 times"
        )
    full, half = (
        np.exp(np.interp(np.log(hardness_ratio), np.log(table.hardness_ratios[::-1]), np.log(numbers[::-1])))
        for numbers in (table.full, table.half)
    )
    return float((half + (full - half) * (2.0 * load_share - 1.0)) / table.elastic)  # (A14)

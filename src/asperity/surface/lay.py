r"""The lay of a rough surface: which share of its waves runs in the rolling direction, and which along the axis.

Grooves are waves that run across them. With the spectrum C of the heights over the wavenumbers q,

.. math::
    w = \frac{\int C\, q_x^2/q^2\, \mathrm d^2 q}{\int C\, \mathrm d^2 q}

is 0.5 for a surface without grooves, 1 for endless grooves across the direction x, and 0 for such along it. It decides
how much stiffer grooves are than hills (:func:`asperity.contact.exponential.lay_factor`), and how unlike the stiffness
against forces across and along them is (:func:`asperity.contact.exponential.lay_stiffness_ratio`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from asperity.engine.arrays import xp
from asperity.types import Real

if TYPE_CHECKING:
    from asperity.surface.height_spectrum import HeightSpectrum

#: Direction of grooves: that in which the contact rolls, or that of the rollers' axis.
GrooveDirection = Literal["rolling", "axis"]
DIRECTIONS: tuple[GrooveDirection, ...] = get_args(GrooveDirection)
#: Ratio of correlation lengths that stands for grooves without an end.
ENDLESS = 1e6


def share_across(*, length_ratio: Real) -> Real:
    r"""Share of the waves that run across the grooves of a stretched surface.

    .. math:: w = \frac{g}{1 + g}

    Parameters
    ----------
    length_ratio : Real
        Correlation length along the grooves over that across them g [-].

    Returns
    -------
    Real
        w, 0.5 without grooves, 1 for endless ones [-].

    Notes
    -----
    Of any spectrum :math:`C(q_x^2 + g^2 q_y^2)`, whatever its other form, x across the grooves: the mean of
    :math:`g^2\cos^2\theta/(g^2\cos^2\theta + \sin^2\theta)` over all angles.

    References
    ----------
    J. Peklenik, Proc. Inst. Mech. Eng. 182 (1967-68) 108 (the ratio); derived here; equation (A12) of
    :doc:`/equations`.

    Examples
    --------
    >>> float(share_across(length_ratio=3.0))
    0.75
    """
    return xp.asarray(length_ratio) / (1.0 + length_ratio)  # (A12)


def rolling_share(*, length_ratio: Real, grooves: GrooveDirection) -> Real:
    """Share of the waves that run in the rolling direction, of a stretched surface whose grooves have a direction.

    Parameters
    ----------
    length_ratio : Real
        Correlation length along the grooves over that across them [-].
    grooves : {"rolling", "axis"}
        Direction of the grooves.

    Returns
    -------
    Real
        Share [-]; above 0.5 for grooves along the axis.

    References
    ----------
    Equation (A12) of :doc:`/equations`.
    """
    across = share_across(length_ratio=length_ratio)
    return across if grooves == "axis" else 1.0 - across


def felt_rolling_share(
    spectra: tuple[HeightSpectrum, ...], *, rolling: tuple[Any, ...], axial: tuple[Any, ...]
) -> NDArray[np.float64]:
    r"""Share of the waves that contacts feel which runs in the rolling direction, of all bodies together.

    .. math::
        w = \frac{\sum_{ij} V_{ij}\, \langle f_x^2/f^2 \rangle_{ij}}{\sum_{ij} V_{ij}}

    Parameters
    ----------
    spectra : tuple of HeightSpectrum
        Of the bodies.
    rolling, axial : tuple of arrays
        For each spectrum, the frequencies below which waves are not felt, as
        :meth:`asperity.surface.height_spectrum.HeightSpectrum.squares` takes them [1/m].

    Returns
    -------
    ndarray
        w, in the shape of the frequencies [-].

    Notes
    -----
    The mean of :math:`f_x^2/f^2` over a bin, or over the part of it that is felt, is that of evenly spread waves, by
    its integral: bins that are alike in both directions have 0.5 together, to rounding. A profile has 0 where its lay
    is "rolling", 1 where it is "axis" and 0.5 where it has none.

    References
    ----------
    Equation (A12) of :doc:`/equations`.
    """
    parts = [
        (spectrum.squares(rolling=first, axial=second), _running(spectrum, first, second))
        for spectrum, first, second in zip(spectra, rolling, axial, strict=True)
    ]
    return np.asarray(sum(running for _, running in parts) / sum(square for square, _ in parts))


def _running(spectrum: HeightSpectrum, rolling: Any, axial: Any) -> NDArray[np.float64]:
    """Mean square of the felt waves, each by the share in which it runs in the rolling direction [m^2]."""
    if not spectrum.is_map:
        share = {"rolling": 0.0, "axis": 1.0}.get(spectrum.lay or "", 0.5)
        return share * spectrum.squares(rolling=rolling, axial=axial)
    return spectrum.running(rolling=rolling, axial=axial)

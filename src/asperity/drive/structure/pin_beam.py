"""The pin of a roller as a beam: bending moment and stress."""

from __future__ import annotations

import math
from typing import Literal

import equinox as eqx
from jax import Array

from asperity.types import Real, namespace

#: How the carrier holds a pin.
PinSupport = Literal["both_ends", "one_end"]


class PinBeam(eqx.Module):
    """The carrier pin of a roller as a beam.

    Parameters
    ----------
    free_length : Real
        Length between its two supports, or from its support to its end [m]; the roller is in the middle of it.
    support : {"both_ends", "one_end"}
        How the carrier holds it.
    diameter : Real
        Its diameter [m]; 0 where it is not known.
    """

    free_length: Real
    support: PinSupport = eqx.field(static=True)
    diameter: Real


def pin_bending_moment(*, force: Real, free_length: Real, roller_length: Real, support: PinSupport) -> Real:
    r"""Largest bending moment of a carrier pin with the roller in the middle of its free length.

    .. math:: M = \frac{F (2l - b)}{8} \;\text{(held at both ends)}, \qquad M = \frac{F l}{2} \;\text{(at one end)}

    Parameters
    ----------
    force : Real
        Force F of the roller, spread evenly over its length [N].
    free_length : Real
        Length l of the pin between its two supports, or from its support to its end [m].
    roller_length : Real
        Length b of the roller, at most l [m].
    support : {"both_ends", "one_end"}
        How the carrier holds the pin.

    Returns
    -------
    Real
        Bending moment [N·m].

    Notes
    -----
    Ends that may turn: cheeks of the carrier that hold the ends stiffly reduce the moment in the middle.

    References
    ----------
    Statics of a beam; (L1) of :doc:`/equations`.
    """
    if support == "one_end":
        return 0.5 * force * free_length
    return 0.125 * force * (2.0 * free_length - roller_length)


def pin_bending_stress(*, moment: Real, diameter: Real) -> Array:
    r"""Bending stress of a solid round pin, :math:`\sigma = 32 M/(\pi d^3)`.

    Parameters
    ----------
    moment : Real
        Bending moment M [N·m].
    diameter : Real
        Diameter d [m].

    Returns
    -------
    Array
        Stress at its surface [Pa]; nan for a pin without diameter.

    References
    ----------
    Statics of a beam; (L1) of :doc:`/equations`.
    """
    xp, solid = namespace(moment, diameter), diameter > 0.0
    return xp.where(solid, 32.0 * moment / (math.pi * xp.where(solid, diameter, 1.0) ** 3), xp.nan)

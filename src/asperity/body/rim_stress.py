r"""Hoop stress of an annulus of any wall thickness at both rims, away from the contacts.

The stress at a rim follows from the same fields as the displacement (:mod:`asperity.body.annulus_modes`), since on
every circle :math:`\sigma_r + \sigma_\theta` is twice the stress :math:`\sigma_+` of the set that decays from the
loaded rim plus twice :math:`\sigma_-` of the other. On the loaded rim a radial point load causes no singular hoop
stress near it, a tangential one :math:`2F/(\pi L d)` at the distance d; these parts are summed in closed form.
"""

from __future__ import annotations

from typing import NamedTuple

from asperity.body.annulus_modes import ModeField, Wall
from asperity.engine.arrays import xp
from asperity.types import Array, Real


class HoopStress(NamedTuple):
    """Hoop stress at the two rims.

    Parameters
    ----------
    loaded_rim, other_rim : Array
        Tension positive [Pa].
    """

    loaded_rim: Array
    other_rim: Array


def mode_stress(wall: Wall, field: ModeField, plus: Real, minus: Real) -> HoopStress:
    """Hoop stress of modes n >= 2 beyond the closed part, for tractions in the channels of the field.

    Parameters
    ----------
    wall : Wall
        The annulus.
    field : ModeField
        Its fields, of :func:`asperity.body.annulus_modes.mode_field`.
    plus, minus : Real
        Tractions on the loaded rim in the two channels [-].

    Returns
    -------
    HoopStress
        At both rims; at the loaded one without the traction itself, which the disc or the hole has.

    References
    ----------
    Equation (E4) of :doc:`/equations`.
    """
    (d1_p, d1_m), (d2_p, d2_m) = field.first, field.second
    x_p = field.motion.pp * plus + field.motion.pm * minus
    x_m = field.motion.mp * plus + field.motion.mm * minus
    echo_p = field.echo.pp * x_p + field.echo.pm * x_m
    echo_m = field.echo.mp * x_p + field.echo.mm * x_m
    # d1 x+ = side t+ + d2 (E x)+, of which the first term is the closed part
    loaded = 2.0 * (d2_p * echo_p - d2_m * echo_m)
    far_p = d1_p * (field.passed.pp * x_p + field.passed.pm * x_m)
    far_m = d1_m * (field.passed.mp * x_p + field.passed.mm * x_m)
    back_p = d2_p * (field.answer.pp * x_p + field.answer.pm * x_m)
    back_m = d2_m * (field.answer.mp * x_p + field.answer.mm * x_m)
    other = (2.0 * (far_p + back_m) - 0.5 * (far_p + far_m + back_p + back_m)) / wall.ratio
    return HoopStress(xp.asarray(loaded), xp.asarray(other))

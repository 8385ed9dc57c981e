"""Elastic constants of a pair of half-spaces for the boundary elements."""

from __future__ import annotations

import math

from asperity.engine.module import Module
from asperity.errors import InputError
from asperity.materials import contact_modulus, shear_modulus
from asperity.types import Real


class ElasticPair(Module):
    r"""Elastic constants of two half-spaces with a common surface, SI units.

    A wave of pressure, or of shear traction along the wave, of wavenumber q moves the two surfaces relative
    to each other by :math:`2/(E q)` times the traction; shear traction across the wave by :math:`1/(G q)`.

    Parameters
    ----------
    contact_modulus : Real
        Contact modulus, :math:`1/E = (1-\nu_1^2)/E_1 + (1-\nu_2^2)/E_2` [Pa].
    antiplane_modulus : Real
        Two shear moduli in series, :math:`1/G = 1/G_1 + 1/G_2` [Pa].
    dundurs_constant : Real
        Dundurs' second constant, :math:`\beta = \frac E4\left[\frac{1-2\nu_1}{G_1} -
        \frac{1-2\nu_2}{G_2}\right]` [-]; zero for like bodies.

    Notes
    -----
    Both compliances are sums over the bodies, so unlike materials are combined exactly. The displacement along
    the surface under *normal* pressure, and the converse, are proportional to :math:`\beta`. It vanishes for
    like materials and for two incompressible ones. The rolling solvers use it
    (:mod:`asperity.bem.coupled_rolling`); the other solvers neglect it and solve the normal and the tangential
    problem one after the other.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, sections 3.6 and 5.4. J. Dundurs, J. Appl. Mech. 36 (1969) 650.
    """

    contact_modulus: Real
    antiplane_modulus: Real
    dundurs_constant: Real

    @property
    def poisson_ratio(self) -> Real:
        r"""Poisson's ratio [-] of a single half-space that shears like the pair, :math:`1 - 2G/E`."""
        return 1.0 - 2.0 * self.antiplane_modulus / self.contact_modulus

    @property
    def tangential_contact_modulus(self) -> Real:
        r"""G* [Pa], :math:`1/G^* = (2-\nu_1)/G_1 + (2-\nu_2)/G_2 = 1/G + 2/E`."""
        return 1.0 / (1.0 / self.antiplane_modulus + 2.0 / self.contact_modulus)


def elastic_pair(
    *, youngs_modulus_1: float, youngs_modulus_2: float, poisson_ratio_1: float, poisson_ratio_2: float
) -> ElasticPair:
    """The pair of two isotropic bodies, from Young's moduli [Pa], infinite for a rigid body, and Poisson's ratios [-].

    An ``InputError`` for a modulus that is not positive, a ratio outside -1 to 0.5 (0.5 is allowed), or two rigid
    bodies.

    Examples
    --------
    >>> pair = elastic_pair(youngs_modulus_1=206e9, youngs_modulus_2=206e9,
    ...                     poisson_ratio_1=0.3, poisson_ratio_2=0.3)
    >>> round(pair.contact_modulus / 1e9, 3), round(pair.tangential_contact_modulus / 1e9, 3)
    (113.187, 23.303)
    """
    E1 = positive("youngs_modulus_1", youngs_modulus_1, "Pa", infinite=True)
    E2 = positive("youngs_modulus_2", youngs_modulus_2, "Pa", infinite=True)
    if E1 == E2 == float("inf"):
        E1 = positive("youngs_modulus_1 of two rigid bodies", E1, "Pa")
    nu1 = inside("poisson_ratio_1", poisson_ratio_1, -1.0, 0.5)
    nu2 = inside("poisson_ratio_2", poisson_ratio_2, -1.0, 0.5)
    E = contact_modulus(youngs_modulus_1=E1, youngs_modulus_2=E2, poisson_ratio_1=nu1, poisson_ratio_2=nu2)
    G1 = shear_modulus(youngs_modulus=E1, poisson_ratio=nu1)
    G2 = shear_modulus(youngs_modulus=E2, poisson_ratio=nu2)
    return ElasticPair(
        contact_modulus=E,
        antiplane_modulus=1.0 / (1.0 / G1 + 1.0 / G2),
        dundurs_constant=0.25 * E * ((1.0 - 2.0 * nu1) / G1 - (1.0 - 2.0 * nu2) / G2),
    )


def positive(name: str, value: float, unit: str, *, infinite: bool = False) -> float:
    """The value as a float; an ``InputError`` unless it is positive, and finite too unless ``infinite``."""
    number = float(value)
    if not number > 0.0 or (math.isinf(number) and not infinite):
        kind = "positive" if infinite else "positive and finite"
        raise InputError(f"{name} = {number:g} {unit}: it must be {kind}")
    return number


def inside(name: str, value: float, low: float, high: float) -> float:
    """The value as a float; an ``InputError`` unless low < value <= high."""
    number = float(value)
    if not low < number <= high:
        raise InputError(f"{name} = {number:g}: it must lie above {low:g} and be at most {high:g}")
    return number

"""Rolling contacts with oil whose film, shares and traction an independent computation has found.

Rollers of 10 and 20 mm of steel, 10 mm long, under 2000 N, and four oils.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import NamedTuple

import numpy as np

from asperity.bem.film_rolling import FilmRolling, film_rolling
from asperity.contact.film_thickness import FilmInlet, central_film_thickness, inlet_heat_factor
from asperity.contact.film_traction import BoundaryFriction, MixedContact, even_slip, local_stress
from asperity.contact.fluid import Fluid
from asperity.contact.load_sharing import LoadSharing, shared_load
from asperity.contact.viscosity import reciprocal_asymptotic_coefficient
from asperity.engine.arrays import xp
from asperity.joint_file.lubricant import lubricant_of
from asperity.types import Array, Real

MODULUS, LENGTH, LOAD = 206e9 / (2.0 * (1.0 - 0.3**2)), 10e-3, 2000.0
RADIUS = 20e-3 / 3.0
HALF_WIDTH = math.sqrt(4.0 * LOAD / LENGTH * RADIUS / (math.pi * MODULUS))
PEAK = 2.0 * LOAD / (math.pi * HALF_WIDTH * LENGTH)
EFFUSIVITY = math.sqrt(46.0 * 7800.0 * 460.0)


def _library_oil(name: str) -> Fluid:
    """An oil of the library with a film of 0.5 GPa."""
    lubricant = lubricant_of({"lubrication": {"fluid": name}}, 0.0)
    assert lubricant is not None
    return lubricant.fluid


#: Four oils of the library: naphthenic, paraffinic, polyalphaolefin, and the traction fluid Santotrac 50.
OILS = {
    short: _library_oil(name)
    for short, name in {"N100": "N100", "M100": "M100", "PAO100": "PAO100", "S50": "Santotrac50"}.items()
}


class OiledContact(NamedTuple):
    """A contact, what drags its film in, the film without asperities [m], and its dry factor of creepage [-]."""

    contact: MixedContact
    inlet: FilmInlet
    full_film: Array
    layer_factor: Array


def oiled_contact(
    oil: str,
    celsius: Real,
    speed: Real,
    rms_height: Real,
    *,
    friction: Real = 0.12,
    load: Real = LOAD,
    rough: bool = True,
) -> OiledContact:
    r"""The rollers under a load [N] with an oil of a temperature [°C], rolling [m/s], rough [m] or smooth.

    Arrays of one shape (contacts,). The factor of asperities that carry all is :math:`f_D = 1 + 1.1 u_0 R/a^2`, with
    :math:`u_0 = 0.48` heights.
    """
    fluid, kelvin = OILS[oil], xp.asarray(celsius) + 273.15
    alike = xp.zeros(1) * speed * rms_height
    speed, rms_height, load = alike + speed, alike + rms_height, alike + load
    half_width = xp.sqrt(4.0 * load / LENGTH * RADIUS / (math.pi * MODULUS))
    peak = 2.0 * load / (math.pi * half_width * LENGTH)
    inlet = FilmInlet(
        fluid.viscosity.base(kelvin),
        reciprocal_asymptotic_coefficient(viscosity=fluid.viscosity, peak_pressure=peak, temperature=kelvin),
        speed,
        load / LENGTH,
        RADIUS,
        MODULUS,
    )
    heat = inlet_heat_factor(
        peak_pressure=peak,
        contact_modulus=MODULUS,
        viscosity=inlet.viscosity,
        viscosity_fall=fluid.viscosity.without_pressure.logarithmic_fall(kelvin),
        conductivity=fluid.conductivity,
        rolling_speed=speed,
    )
    full = xp.where(heat > 0.0, heat, xp.nan) * central_film_thickness(inlet=inlet)
    decay = 0.48 * rms_height
    if rough:
        shares = shared_load(
            inlet=inlet,
            decay_length=decay,
            rms_height=rms_height,
            half_width=half_width,
            mean_pressure=math.pi / 4.0 * peak,
            thickness_factor=heat,
        )
    else:
        shares = LoadSharing(0.0 * full, 1.0 + 0.0 * full, full)
    contact = MixedContact(
        fluid,
        BoundaryFriction(friction),
        *shares,
        half_width,
        peak,
        LENGTH,
        MODULUS,
        speed,
        kelvin,
        EFFUSIVITY,
    )
    return OiledContact(contact, inlet, full, 1.0 + 1.1 * decay * RADIUS / half_width**2)


#: Creepages at which the table has the traction [-].
CREEPAGES = (1e-4, 3e-4, 1e-3, 3e-3, 1e-2)
_TABLE = Path(__file__).with_name("oiled_rollers.csv")


class KnownContact(NamedTuple):
    """A contact of the table: its oil, temperature [°C], speed [m/s] and heights [m], and what was found.

    Film without asperities [m], their share [-], film [m], factor of the elastic layers [-], traction over the load at
    the creepages, and its largest [-].
    """

    oil: str
    celsius: float
    speed: float
    rms_height: float
    full_film: float
    asperity_share: float
    film_thickness: float
    elastic_factor: float
    tractions: tuple[float, ...]
    capacity: float

    def contact(self) -> OiledContact:
        """The same by this package, shape (1,)."""
        return oiled_contact(self.oil, self.celsius, self.speed, self.rms_height)


def known_contacts() -> list[KnownContact]:
    """The table: friction of asperities 0.12, shear modulus 0.5 GPa; a program that shares no code with this one."""
    with _TABLE.open(encoding="utf-8") as stream:
        rows = list(csv.reader(stream))[1:]
    return [_known(row[0], *(float(number) for number in row[1:])) for row in rows]


def _known(
    oil: str,
    celsius: float,
    speed: float,
    height: float,
    full: float,
    share: float,
    film: float,
    factor: float,
    *tractions: float,
) -> KnownContact:
    """A row of the table, its heights and films in µm."""
    sizes = celsius, speed, 1e-6 * height, 1e-6 * full, share, 1e-6 * film, factor
    return KnownContact(oil, *sizes, tractions[:-1], tractions[-1])


def by_strips(*, contact: MixedContact, creepage: float, elastic_factor: float, strips: int) -> FilmRolling:
    r"""A contact by boundary elements, with the shear stress of its closed form at every place.

    Parameters
    ----------
    contact : MixedContact
        One contact, of numbers without axes; the film has the temperature of even slip.
    creepage : float
        xi [-].
    elastic_factor : float
        f of the layers; an even layer of compliance :math:`c = 4 a (f - 1)/(\pi E^*)`, which for a film alone is its
        thickness over its shear modulus.
    strips : int
        Number of strips.

    Returns
    -------
    FilmRolling
        Tractions and slip; the force is per length.
    """
    width, modulus = float(contact.half_width), float(contact.contact_modulus)
    warming = even_slip(contact=contact, creepage=xp.asarray(creepage)).heated

    def stress(position: np.ndarray, slip: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        found, rise = local_stress(
            contact=contact,
            pressure_shape=xp.asarray(np.sqrt(1.0 - position**2)),
            slip_speed=xp.asarray(slip) * contact.rolling_speed,
            warming=warming,
        )
        return np.asarray(found), np.asarray(rise / found)

    return film_rolling(
        half_width=width,
        contact_modulus=modulus,
        creepage=creepage,
        stress=stress,
        layer_compliance=4.0 * width * (elastic_factor - 1.0) / (math.pi * modulus),
        strips=strips,
    )


def strip_force(*, contact: MixedContact, creepage: float, elastic_factor: float, strips: int) -> float:
    """Force of :func:`by_strips` [N], extrapolated from a number of strips and half as many."""
    coarse, fine = (
        by_strips(contact=contact, creepage=creepage, elastic_factor=elastic_factor, strips=count)
        for count in (strips // 2, strips)
    )
    return (2.0 * fine.tangential_force - coarse.tangential_force) * float(contact.contact_length)

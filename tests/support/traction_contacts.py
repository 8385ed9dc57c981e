"""Rolling contacts with oil: rollers of 10 and 20 mm of steel, 10 mm long, under 2000 N, and four oils."""

import math
from typing import NamedTuple

import numpy as np

from asperity.contact.film_thickness import FilmInlet, central_film_thickness, inlet_heat_factor
from asperity.contact.film_traction import BoundaryFriction, MixedContact
from asperity.contact.fluid import Fluid, LimitingTraction, RheologicalTraction
from asperity.contact.load_sharing import shared_load
from asperity.contact.viscosity import (
    ExponentialViscosity,
    RationalPressureRise,
    RoelandsPressureRise,
    Viscosity,
    WaltherViscosity,
    reciprocal_asymptotic_coefficient,
)
from asperity.engine.module import Partial

MODULUS, LENGTH, LOAD = 206e9 / (2.0 * (1.0 - 0.3**2)), 10e-3, 2000.0
RADIUS = 20e-3 / 3.0
HALF_WIDTH = math.sqrt(4.0 * LOAD / LENGTH * RADIUS / (math.pi * MODULUS))
PEAK = 2.0 * LOAD / (math.pi * HALF_WIDTH * LENGTH)
EFFUSIVITY = math.sqrt(46.0 * 7800.0 * 460.0)
ZERO_CELSIUS = 273.15


def exponential_oil(base, rise, limit):
    """An oil whose viscosity and its rise with pressure are rational functions of the temperature in exponents."""
    viscosity = Viscosity(ExponentialViscosity(*base), RationalPressureRise(*rise))
    return Fluid(viscosity, RheologicalTraction(LimitingTraction(limit), 0.5e9, "eyring"), 0.14)


#: A. Arana et al., Proc. IMechE J 233 (2019) 303: naphthenic, paraffinic and polyalphaolefin oils of 100 mm²/s; the
#: traction fluid Santotrac 50 by P. K. Gupta's tables.
OILS = {
    "N100": exponential_oil((161.60e-6, 650.0, -206.0), (-7.23e7, 3.48e5, 5.00e-3, -1.83e-5), 0.053),
    "M100": exponential_oil((86.86e-6, 890.0, -182.0), (-2.28e7, 2.26e5, -68.20e-3, 27.68e-5), 0.047),
    "PAO100": exponential_oil((12.26e-6, 1740.0, -116.0), (-5.73e7, 3.90e5, -39.50e-3, 23.54e-5), 0.035),
    "S50": Fluid(
        Viscosity(
            WaltherViscosity(9.5363, 3.7452, 0.8, 820.0, 0.621, 422.222),
            RoelandsPressureRise(3.916e-8, 0.0083178, 277.78),
        ),
        RheologicalTraction(LimitingTraction(0.0765, -4e-4, 27e6, 0.35e6, 386.15), 0.5e9, "limit"),
        0.104,
    ),
}


class OiledContact(NamedTuple):
    """A contact, what drags its film in, the film without asperities [m], and its dry factor of creepage [-]."""

    contact: MixedContact
    inlet: FilmInlet
    full_film: np.ndarray
    layer_factor: np.ndarray


def oiled_contact(
    oil, celsius, speed, rms_height, *, friction=0.12, load=LOAD, oils=OILS, rough=True
) -> OiledContact:
    """The rollers under a load [N] with an oil of a temperature [°C], rolling [m/s], and rough [m]."""
    fluid, kelvin = oils[oil], celsius + ZERO_CELSIUS
    load, speed, rms_height = np.broadcast_arrays(
        *(np.atleast_1d(each) for each in (load, speed, rms_height))
    )
    half_width = np.sqrt(4.0 * load / LENGTH * RADIUS / (math.pi * MODULUS))
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
    full = heat * central_film_thickness(inlet=inlet)
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
        shares = 0.0 * full, 1.0 + 0.0 * full, full
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


def dry_contact(*, friction=0.12, rms_height=0.1e-6) -> OiledContact:
    """The same rollers without oil: the asperities carry all."""
    oiled = oiled_contact("M100", 60.0, 1.0, rms_height, friction=friction)
    values = vars(oiled.contact) | {"asperity_share": np.ones(1), "film_share": np.zeros(1)}
    return oiled._replace(contact=MixedContact(**values))


def same_layer(factor):
    """A layer whose factor of creepage is the same at any traction."""
    return Partial(_always, (factor,))


def _always(factor, used):
    return factor + 0.0 * used

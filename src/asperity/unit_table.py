"""Dimensions and units: the kinds of quantity, and the exact SI factor of every accepted unit.

Factors are ratios of whole numbers times a power of pi. The angle is a dimension of its own here: N·m and
N·m/rad are different things. A temperature is counted in degrees Celsius, the unit of its difference is the kelvin.
"""

import functools
from enum import Enum

from asperity.hardness_scales import VICKERS_PRESSURE

__all__ = ["TORQUE_UNITS", "Dimension", "Exponents", "Unit", "unit_table"]

Exponents = tuple[int, int, int, int, int]  # of metre, kilogram, second, radian, kelvin
Unit = tuple[int, int, int, Exponents]  # numerator, denominator and power of pi of the SI factor; exponents

#: Products of newton and metre written in one word: name → SI factor as a ratio. "Nm" is N*m, "nm" a nanometre.
TORQUE_UNITS: dict[str, tuple[int, int]] = {
    "Nm": (1, 1),
    "MNm": (10**6, 1),
    "kNm": (10**3, 1),
    "mNm": (1, 10**3),
    "µNm": (1, 10**6),
    "Ncm": (1, 10**2),
    "Nmm": (1, 10**3),
    "kNmm": (1, 1),
}


class Dimension(Enum):
    """What a quantity measures: name, SI unit, an example to quote, exponents of m, kg, s, rad and K; units offered."""

    DIMENSIONLESS = ("a dimensionless number", "1", "0.12", (0, 0, 0, 0, 0))
    LENGTH = ("a length", "m", "13.5 mm", (1, 0, 0, 0, 0), "nm um cm thou in")
    AREA = ("an area", "m^2", "1.2 mm^2", (2, 0, 0, 0, 0))
    VOLUME = ("a volume", "m^3", "2 cm^3", (3, 0, 0, 0, 0))
    CURVATURE = ("a curvature", "1/m", "0.2 1/mm", (-1, 0, 0, 0, 0))
    ANGLE = ("an angle", "rad", "12 deg", (0, 0, 0, 1, 0), "arcsec arcmin mrad")
    TIME = ("a time", "s", "2 ms", (0, 0, 1, 0, 0), "min h")
    FREQUENCY = ("a frequency", "1/s", "50 Hz", (0, 0, -1, 0, 0))
    SPEED = ("a speed", "m/s", "2 m/s", (1, 0, -1, 0, 0))
    ANGULAR_VELOCITY = ("an angular velocity", "rad/s", "6000 rpm", (0, 0, -1, 1, 0), "deg/s")
    MASS = ("a mass", "kg", "25 g", (0, 1, 0, 0, 0))
    MOMENT_OF_INERTIA = ("a moment of inertia", "kg*m^2", "2e-6 kg*m^2", (2, 1, 0, 0, 0), "g*cm^2")
    DENSITY = ("a density", "kg/m^3", "7850 kg/m^3", (-3, 1, 0, 0, 0), "g/cm^3 lb/in^3")
    FORCE = ("a force", "N", "1000 N", (1, 1, -2, 0, 0), "kN kgf lbf")
    FORCE_PER_TORQUE = ("a force per torque", "N/Nm", "150 N/Nm", (-1, 0, 0, 0, 0), "kN/Nm")
    TORQUE = ("a torque", "N*m", "5 N*m", (2, 1, -2, 0, 0), "N*mm kN*m lbf*in lbf*ft")
    PRESSURE = ("a pressure", "Pa", "450 MPa", (-1, 1, -2, 0, 0), "kPa GPa bar psi ksi")
    HARDNESS = ("a hardness", "Pa", "1260 MPa", (-1, 1, -2, 0, 0), "GPa HV")
    VISCOSITY = ("a viscosity", "Pa*s", "30 mPa*s", (-1, 1, -1, 0, 0), "cP")
    KINEMATIC_VISCOSITY = ("a kinematic viscosity", "m^2/s", "100 mm^2/s", (2, 0, -1, 0, 0), "cSt")
    INVERSE_PRESSURE = ("a reciprocal pressure", "1/Pa", "20 1/GPa", (1, -1, 2, 0, 0), "1/MPa")
    WEAR_COEFFICIENT = ("a wear coefficient", "1/Pa", "1e-17 1/Pa", (1, -1, 2, 0, 0), "mm^3/(N*m)")
    POWER = ("a power", "W", "100 W", (2, 1, -3, 0, 0))
    STIFFNESS = ("a stiffness", "N/m", "4e6 N/mm", (0, 1, -2, 0, 0), "N/um kN/mm lbf/in")
    TORSIONAL_STIFFNESS = ("a torsional stiffness", "N*m/rad", "8.6 N*m/arcmin", (2, 1, -2, -1, 0))
    TORSIONAL_STIFFNESS_PER_MASS = (
        "a torsional stiffness per mass",
        "N*m/rad/kg",
        "4e4 N*m/rad/kg",
        (2, 0, -2, -1, 0),
    )
    TORSIONAL_STIFFNESS_PER_VOLUME = (
        "a torsional stiffness per volume",
        "N*m/rad/m^3",
        "1e9 N*m/rad/m^3",
        (-1, 1, -2, -1, 0),
    )
    TEMPERATURE_RISE = ("a temperature difference", "K", "2 K", (0, 0, 0, 0, 1))
    TEMPERATURE = ("a temperature", "degC", "20 degC", (0, 0, 0, 0, 1), "K")  # from 0 degC, also inside
    THERMAL_EXPANSION = ("a thermal expansion coefficient", "1/K", "11.5e-6 1/K", (0, 0, 0, 0, -1), "um/m/K")
    THERMAL_CONDUCTIVITY = ("a thermal conductivity", "W/m/K", "21 W/m/K", (1, 1, -3, 0, -1))
    SPECIFIC_HEAT_CAPACITY = ("a specific heat capacity", "J/kg/K", "475 J/kg/K", (2, 0, -2, 0, -1), "J/g/K")
    HEAT_CAPACITY = ("a heat capacity", "J/K", "600 J/K", (2, 1, -2, 0, -1), "kJ/K")
    THERMAL_RESISTANCE = ("a thermal resistance", "K/W", "3 K/W", (-2, -1, 3, 0, 1))
    HEAT_TRANSFER = ("a heat transfer coefficient", "W/m^2/K", "10 W/m^2/K", (0, 1, -3, 0, -1))
    STIFFNESS_PER_AREA = ("a stiffness per area", "Pa/m", "2e4 MPa/mm", (-2, 1, -2, 0, 0), "N/mm^3")

    def __init__(self, label: str, si_unit: str, example: str, exponents: Exponents, units: str = "") -> None:
        self.label = label
        self.si_unit = si_unit
        self.example = example
        self.exponents = exponents
        self.units = tuple(dict.fromkeys([si_unit, example.split(" ")[-1], *units.split()]))


@functools.cache
def unit_table() -> dict[str, Unit]:
    """Every unit by each of its spellings: those without SI prefixes, and those with SI prefixes."""
    angle, length, mass, time = (0, 0, 0, 1, 0), (1, 0, 0, 0, 0), (0, 1, 0, 0, 0), (0, 0, 1, 0, 0)
    force, pressure, energy = (1, 1, -2, 0, 0), (-1, 1, -2, 0, 0), (2, 1, -2, 0, 0)
    pound_force = 45359237 * 980665  # lbf = 0.45359237 kg * 9.80665 m/s^2, exactly; in units of 1e-13 N
    number = (0, 0, 0, 0, 0)
    alone: list[tuple[str, Unit]] = [
        ("inch inches in", (254, 10**4, 0, length)),
        ("µin microinch microinches", (254, 10**10, 0, length)),
        ("thou", (254, 10**7, 0, length)),
        ("foot feet ft", (3048, 10**4, 0, length)),
        ("micron microns", (1, 10**6, 0, length)),
        ("angstrom angstroms Å \u212b", (1, 10**10, 0, length)),
        ("kg kilogram kilograms", (1, 1, 0, mass)),
        ("pound pounds lb lbs", (45359237, 10**8, 0, mass)),
        ("ounce ounces oz", (45359237, 16 * 10**8, 0, mass)),
        ("minute minutes min", (60, 1, 0, time)),
        ("hour hours h", (3600, 1, 0, time)),
        ("lbf pound_force", (pound_force, 10**13, 0, force)),
        ("ozf ounce_force", (pound_force, 16 * 10**13, 0, force)),
        ("kgf", (980665, 10**5, 0, force)),
        ("psi", (pound_force * 10**8, 10**13 * 254**2, 0, pressure)),
        ("ksi", (pound_force * 10**11, 10**13 * 254**2, 0, pressure)),
        ("HV", (*VICKERS_PRESSURE, 0, pressure)),
        ("atm", (101325, 1, 0, pressure)),
        ("degree degrees deg ° º", (1, 180, 1, angle)),
        ("millidegree millidegrees mdeg", (1, 180 * 1000, 1, angle)),
        ("gon", (1, 200, 1, angle)),
        ("arcminute arcminutes arcmin", (1, 180 * 60, 1, angle)),
        ("arcsecond arcseconds arcsec", (1, 180 * 3600, 1, angle)),
        ("turn turns revolution revolutions rev", (2, 1, 1, angle)),
        ("rpm", (2, 60, 1, (0, 0, -1, 1, 0))),
        ("K kelvin kelvins", (1, 1, 0, (0, 0, 0, 0, 1))),
        ("degC celsius °C ℃", (1, 1, 0, (0, 0, 0, 0, 1))),  # as a difference; units.py knows the zero
        ("cP centipoise", (1, 1000, 0, (-1, 1, -1, 0, 0))),
        ("cSt centistokes", (1, 10**6, 0, (2, 0, -1, 0, 0))),
        ("percent %", (1, 100, 0, number)),
        ("ppm", (1, 10**6, 0, number)),
        ("1 dimensionless", (1, 1, 0, number)),
    ]
    prefixed: list[tuple[str, str, Unit]] = [  # symbol, full names
        ("m", "meter meters metre metres", (1, 1, 0, length)),
        ("g", "gram grams", (1, 1000, 0, mass)),
        ("s", "second seconds", (1, 1, 0, time)),
        ("N", "newton newtons", (1, 1, 0, force)),
        ("Pa", "pascal pascals", (1, 1, 0, pressure)),
        ("bar", "", (10**5, 1, 0, pressure)),
        ("J", "joule joules", (1, 1, 0, energy)),
        ("W", "watt watts", (1, 1, 0, (2, 1, -3, 0, 0))),
        ("Hz", "hertz", (1, 1, 0, (0, 0, -1, 0, 0))),
        ("rad", "radian radians", (1, 1, 0, angle)),
    ]
    prefixes = [("T", "tera", 12), ("G", "giga", 9), ("M", "mega", 6), ("k", "kilo", 3), ("", "", 0)]
    prefixes += [("d", "deci", -1), ("c", "centi", -2), ("m", "milli", -3), ("µ", "micro", -6)]
    prefixes += [("n", "nano", -9), ("p", "pico", -12), ("f", "femto", -15)]
    table: dict[str, Unit] = {}
    for symbol, names, (numerator, denominator, pi_power, exponents) in prefixed:
        for short, long, power in prefixes:
            if symbol == "rad" and power > 3:
                continue  # "Grad" is a degree in German
            up, down = 10 ** max(power, 0), 10 ** max(-power, 0)
            scaled = (numerator * up, denominator * down, pi_power, exponents)
            table[short + symbol] = scaled
            table.update({long + name: scaled for name in names.split()})
    # "min" is a minute and "ft" a foot: a unit without a prefix takes precedence
    table.update({name: unit for names, unit in alone for name in names.split()})
    return table | {name: (*ratio, 0, (2, 1, -2, 0, 0)) for name, ratio in TORQUE_UNITS.items()}

"""Every unit and spelling against pint, an independent table; the few it lacks from their definition."""

import math

import pint
import pytest

from asperity.errors import InputError
from asperity.joint_file.case_types import CASES
from asperity.joint_file.section import keys_by_path
from asperity.unit_table import TORQUE_UNITS, Dimension, unit_table
from asperity.units import from_si, parse_quantity

PINT = pint.UnitRegistry(cache_folder=None)

SPELLINGS = {
    Dimension.LENGTH: "m mm cm µm um nm pm km dm inch in ft thou micron "
    "meter metres millimeter micrometer foot",
    Dimension.AREA: "m^2 mm**2 mm^2 cm² µm² inch^2 m*mm",
    Dimension.VOLUME: "m^3 cm³ mm^3",
    Dimension.CURVATURE: "1/mm mm^-1 m⁻¹ 1/inch",
    Dimension.ANGLE: "rad mrad deg degree degrees arcmin arcsec arcminute turn revolution µrad",
    Dimension.TIME: "s ms µs min h hour minutes seconds",
    Dimension.FREQUENCY: "Hz kHz 1/s s^-1 hertz",
    Dimension.SPEED: "m/s mm/s inch/min km/h m*s^-1",
    Dimension.ANGULAR_VELOCITY: "rpm rad/s deg/s turn/s revolution/minute rad*s^-1 krad/s",
    Dimension.MASS: "kg g mg kilogram gram lb pound lbs oz ounce ounces",
    Dimension.DENSITY: "kg/m^3 kg/m**3 g/cm^3 g/cm³ kg*m^-3 lb/inch^3 kg/m/m/m",
    Dimension.FORCE: "N kN mN MN newton newtons lbf kgf kg*m/s^2 pound_force ounce_force",
    Dimension.FORCE_PER_TORQUE: "N/N/m kN/N/m 1/m",
    Dimension.TORQUE: "N*m N*mm mN*m kN*m lbf*inch lbf*ft newton*meter J",
    Dimension.PRESSURE: "Pa MPa GPa kPa psi ksi bar mbar N/mm^2 N/m^2 megapascal gigapascal kN/mm**2 atm",
    Dimension.POWER: "W kW N*m/s J/s mW",
    Dimension.TEMPERATURE_RISE: "K kelvin delta_degC",
    Dimension.THERMAL_EXPANSION: "1/K K^-1 µm/m/K ppm/K",
    Dimension.THERMAL_CONDUCTIVITY: "W/m/K W/K/m kW*m^-1*K^-1 W*m/m^2/K",
    Dimension.SPECIFIC_HEAT_CAPACITY: "J/kg/K kJ/kg/K J/g/K J*kg^-1*K^-1",
    Dimension.STIFFNESS: "N/m N/mm N/µm kN/mm N/um lbf/inch MN/m",
    Dimension.TORSIONAL_STIFFNESS: "N*m/rad N*m/arcmin N*mm/deg kN*m/rad lbf*inch/deg "
    "N*m*rad^-1 J/rad N/rad*m",
    Dimension.STIFFNESS_PER_AREA: "Pa/m MPa/mm GPa/µm N/m^3 N/mm/mm^2",
    Dimension.DIMENSIONLESS: "% percent mm/m ppm µm/mm dimensionless N/N",
}
_CELSIUS = ("degC", "celsius", "°C", "℃")  # as a difference
PAIRS = [(dimension, unit) for dimension, units in SPELLINGS.items() for unit in units.split()]


@pytest.mark.parametrize(("dimension", "unit"), PAIRS)
def test_every_spelling_agrees_with_pint(dimension, unit):
    expected = PINT.Quantity(f"3.7 {unit}").to_base_units().magnitude
    assert parse_quantity(f"3.7 {unit.replace('delta_', '')}", dimension) == pytest.approx(
        expected, rel=4e-15, abs=0.0
    )


def test_every_unit_of_the_table_agrees_with_pint():
    not_in_pint = {"°", "º", "gon", "rev", "revolutions", "microns", "1", "dimensionless", "ozf", "HV"}
    for name, (numerator, denominator, pi_power, exponents) in unit_table().items():
        if name in not_in_pint:
            continue
        if name in TORQUE_UNITS:  # pint reads products with a sign only
            prefix, _, length = name.partition("N")
            quantity = PINT.Quantity(1.0, f"{prefix}N*{length}").to_base_units()
        else:
            spelled = {"%": "percent", **dict.fromkeys(_CELSIUS, "delta_degC")}.get(name, name)
            quantity = PINT.Quantity(1.0, spelled).to_base_units()
        assert numerator / denominator * math.pi**pi_power == pytest.approx(
            quantity.magnitude, rel=4e-15, abs=0.0
        ), name
        powers = dict(quantity.unit_items())
        assert exponents == tuple(
            powers.get(base, 0) for base in ("meter", "kilogram", "second", "radian", "kelvin")
        ), name


def test_units_that_pint_spells_otherwise():
    assert parse_quantity("180 °", Dimension.ANGLE) == parse_quantity("180 º", Dimension.ANGLE) == math.pi
    assert parse_quantity("200 gon", Dimension.ANGLE) == pytest.approx(math.pi, rel=1e-15)
    with pytest.raises(InputError, match="Grad"):  # a degree in German, and never a gigaradian
        parse_quantity("1 Grad", Dimension.ANGLE)
    assert parse_quantity("60 rev/min", Dimension.ANGULAR_VELOCITY) == 2 * math.pi
    assert parse_quantity("3 microns", Dimension.LENGTH) == 3e-6
    assert parse_quantity("16 ozf", Dimension.FORCE) == parse_quantity("1 lbf", Dimension.FORCE)


@pytest.mark.parametrize("written", ["25 degC", "25 °C", "25℃", "25 celsius", "298.15 K", "298.15 kelvin"])
def test_temperatures_are_counted_from_zero_celsius(written):
    assert parse_quantity(written, Dimension.TEMPERATURE) == 25.0
    kelvin = PINT.Quantity(25.0, "degC").to("kelvin").magnitude
    assert parse_quantity(f"{kelvin} K", Dimension.TEMPERATURE) == 25.0
    assert parse_quantity("-40 °C", Dimension.TEMPERATURE) == -40.0


def test_what_stands_alone_wins_over_a_prefix():
    assert unit_table()["min"][3] == Dimension.TIME.exponents
    assert unit_table()["ft"][3] == Dimension.LENGTH.exponents


def test_si_unit_and_example_of_every_dimension_measure_it():
    for dimension in Dimension:
        assert parse_quantity(f"2 {dimension.si_unit}", dimension) == 2.0
        assert math.isfinite(parse_quantity(dimension.example, dimension))


def test_units_that_are_offered_measure_their_dimension_those_of_joint_files_among_them():
    for dimension in Dimension:
        if dimension is not Dimension.DIMENSIONLESS:
            for unit in dimension.units:
                one, none = (parse_quantity(f"{number} {unit}", dimension) for number in (1, 0))
                assert from_si(one - none, unit) == pytest.approx(1.0, rel=1e-12)
    for case in CASES.values():
        for path, key in keys_by_path(case, numbers="all").items():
            offered = {
                parse_quantity(f"1 {unit}", key.dimension) for unit in key.dimension.units if key.unit != "1"
            }
            assert key.unit == "1" or parse_quantity(f"1 {key.unit}", key.dimension) in offered, path

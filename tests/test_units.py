"""Quantities as text, against pint (an independent parser), exact decimals and SI definitions."""

import math
import subprocess
import sys
from fractions import Fraction

import pint
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from asperity.errors import InputError
from asperity.units import Dimension, format_quantity, from_si, parse_quantity, parse_tolerance

PINT = pint.UnitRegistry(cache_folder=None)

PAIRS = [(dimension, dimension.example.split(" ")[-1]) for dimension in Dimension if " " in dimension.example]
PAIRS += [(dimension, dimension.si_unit) for dimension in Dimension if dimension.si_unit != "1"]
# pint has another zero of the temperature, and reads Nm as a length: test_unit_table
PAIRS = [pair for pair in PAIRS if pair[0] not in (Dimension.TEMPERATURE, Dimension.FORCE_PER_TORQUE)]
PAIRS += [(Dimension.DIMENSIONLESS, "%"), (Dimension.PRESSURE, "psi"), (Dimension.LENGTH, "inch")]

numbers = st.one_of(
    st.floats(1e-12, 1e12).map(repr),
    st.floats(1e-12, 1e12).map("-{:.5e}".format),
    st.integers(-(10**12), 10**12).map(str),
    st.decimals(-1000, 1000, places=3).map(lambda d: format(d, "f")),
    st.sampled_from(["1e-8", "+13.5", ".5", "5.", "1E3", "2.e+4", "−7"]),
)


def by_pint(text: str) -> float:
    return PINT.Quantity(text).to_base_units().magnitude


@given(st.sampled_from(PAIRS), numbers, st.sampled_from(["", " ", "  "]))
def test_any_number_agrees_with_pint(pair, number, gap):
    dimension, unit = pair
    gap = gap or " " * unit.startswith("1")  # "51/mm" is another number
    expected = float(number.replace("−", "-")) * by_pint(f"1 {unit}")
    assert parse_quantity(f"{number}{gap}{unit}", dimension) == pytest.approx(expected, rel=1e-14, abs=0.0)


FACTORS = "N mm kg s rad MPa m deg psi min"


@given(
    st.lists(
        st.tuples(st.sampled_from("*/ "), st.sampled_from(FACTORS.split()), st.integers(-3, 3)),
        min_size=1,
        max_size=5,
    )
)
@example([("*", "min", -1)])
def test_products_and_quotients_read_like_pint(terms):
    unit = "".join(f"{op if i else ''}{name}^{power}" for i, (op, name, power) in enumerate(terms))
    quantity = PINT.Quantity(f"1 {unit}").to_base_units()
    got = f"1 {unit}"
    powers = dict(quantity.unit_items())
    exponents = tuple(
        round(powers.get(name, 0)) for name in ("meter", "kilogram", "second", "radian", "kelvin")
    )
    for dimension in Dimension:
        if dimension.exponents == exponents:
            assert parse_quantity(got, dimension) == pytest.approx(quantity.magnitude, rel=1e-13)
        elif dimension is Dimension.ANGULAR_VELOCITY and unit == "min^-1":  # turns
            assert parse_quantity(got, dimension) == pytest.approx(math.pi / 30.0, rel=1e-13)
        else:
            with pytest.raises(InputError):
                parse_quantity(got, dimension)


def test_decimal_text_gives_the_float_of_the_same_decimal_in_si():
    assert parse_quantity("13.5 mm", Dimension.LENGTH) == 0.0135
    assert parse_quantity("1e-8 mm", Dimension.LENGTH) == 1e-11
    assert parse_quantity("450 MPa", Dimension.PRESSURE) == 450e6
    assert parse_quantity("5 um", Dimension.LENGTH) == 5e-6
    assert parse_quantity("12 %", Dimension.DIMENSIONLESS) == 0.12


@given(st.decimals(-1000, 1000, places=6))
def test_millimetres_are_rounded_once(number):
    assert parse_quantity(f"{number:f} mm", Dimension.LENGTH) == float(Fraction(number) / 1000)


def test_angles_from_their_definition():
    assert parse_quantity("180 deg", Dimension.ANGLE) == math.pi
    assert parse_quantity("10800 arcmin", Dimension.ANGLE) == pytest.approx(math.pi, rel=4e-16)
    assert parse_quantity("6000 rpm", Dimension.ANGULAR_VELOCITY) == pytest.approx(200 * math.pi, rel=4e-16)
    assert parse_quantity("1 N*m/arcmin", Dimension.TORSIONAL_STIFFNESS) == pytest.approx(
        10800 / math.pi, rel=4e-16
    )


@pytest.mark.parametrize(
    "text",
    [
        *(
            "5 Nm",
            "5Nm",
            "5e3 Nmm",
            "5e3 mNm",
            "0.005 kNm",
            "5e-6 MNm",
            "500 Ncm",
            "5e6 µNm",
            "5e6 uNm",
            "5 kNmm",
        ),
        *("5 N*m", "5 N·m", "5 N m", "5N⋅m", "5 N × m", "5e3 N mm", "5\u00a0N\u202fm", "5 m N"),
    ],
)
def test_signs_of_multiplication(text):
    assert parse_quantity(text, Dimension.TORQUE) == 5.0


@pytest.mark.parametrize(
    ("text", "newton_metres_per_radian"),
    [
        ("3 Nm/rad", 3.0),
        ("3 Nmm/rad", 3e-3),
        ("3 Nm/arcmin", 3.0 * 60.0 * 180.0 / math.pi),
        ("3 Nm/'", None),
        ("3 Nm/°", 3.0 * 180.0 / math.pi),
        ("3 kNm rad^-1", 3e3),
    ],
)
def test_torques_in_one_word_are_divided_like_products(text, newton_metres_per_radian):
    if newton_metres_per_radian is None:
        with pytest.raises(InputError, match="cannot read the unit"):
            parse_quantity(text, Dimension.TORSIONAL_STIFFNESS)
        return
    assert parse_quantity(text, Dimension.TORSIONAL_STIFFNESS) == pytest.approx(
        newton_metres_per_radian, rel=1e-15
    )


def test_the_example_of_a_key_is_quoted():
    with pytest.raises(InputError, match=r"\(e\.g\. '1e-8 mm'\), got a force"):
        parse_quantity("5 N", Dimension.LENGTH, example="1e-8 mm")
    with pytest.raises(InputError, match=r"\(e\.g\. '3 \+- 3'\)"):
        parse_tolerance("5", Dimension.DIMENSIONLESS, example="3")


@pytest.mark.parametrize(
    "text",
    ["7850 kg/m^3", "7850 kg/m**3", "7850 kg/m³", "7850 kg m⁻³", "7.85 g / cm ^ 3", "7850kg/m3"[:-1] + "³"],
)
def test_signs_of_powers(text):
    assert parse_quantity(text, Dimension.DENSITY) == 7850.0


@pytest.mark.parametrize("text", ["3 um", "3 µm", "3 μm", "3 micron", "3 micrometre"])
def test_both_greek_letters_and_u_are_micro(text):
    assert parse_quantity(text, Dimension.LENGTH) == 3e-6


@pytest.mark.parametrize(
    ("value", "expected"), [("0.12", 0.12), (0.12, 0.12), (3, 3.0), (" 1e-3 ", 1e-3), ("0", 0.0)]
)
def test_bare_numbers_are_dimensionless(value, expected):
    assert parse_quantity(value, Dimension.DIMENSIONLESS) == expected


@pytest.mark.parametrize(
    ("text", "dimension", "message"),
    [
        ("450 MPa", Dimension.LENGTH, r"expected a length \(e.g. '13.5 mm'\), got a pressure 'MPa'"),
        ("5 N*m", Dimension.TORSIONAL_STIFFNESS, "expected a torsional stiffness .* got a torque 'N\\*m'"),
        ("5 N*m/rad", Dimension.TORQUE, "expected a torque .* got a torsional stiffness 'N\\*m/rad'"),
        ("50 Hz", Dimension.ANGULAR_VELOCITY, "expected an angular velocity .* got a frequency 'Hz'"),
        ("3 rad", Dimension.DIMENSIONLESS, "expected a dimensionless number .* got an angle 'rad'"),
        ("3 %", Dimension.LENGTH, "expected a length .* got a dimensionless number '%'"),
        ("5 kg*m", Dimension.MASS, r"expected a mass .* got a quantity of unit m\*kg"),
        ("13.5", Dimension.LENGTH, "with its unit .* bare number '13.5'"),
        (13.5, Dimension.LENGTH, "with its unit .* bare number 13.5"),
        (13, Dimension.LENGTH, "with its unit .* bare number 13"),
        ("5 mpa", Dimension.PRESSURE, "unknown unit 'mpa'; did you mean 'MPa'"),
        ("5 RPM", Dimension.ANGULAR_VELOCITY, "unknown unit 'RPM'; did you mean 'rpm'"),
        ("5 milimeter", Dimension.LENGTH, "unknown unit 'milimeter'; did you mean 'millimeter'"),
        ("5 NM", Dimension.TORQUE, "unknown unit 'NM'; did you mean the torque 'Nm'"),
        ("20 nmm", Dimension.TORQUE, "unknown unit 'nmm'; did you mean the torque 'Nmm'"),
        ("5 nm", Dimension.TORQUE, "expected a torque .* got a length 'nm'"),
        (
            "5 Nm^2",
            Dimension.TORQUE,
            r"power of 'Nm' in 'Nm\^2' could be that of the torque or of the length",
        ),
        ("5 1/Nmm²", Dimension.TORQUE, "power of 'Nmm'"),
        ("5 qqqqqq", Dimension.LENGTH, "unknown unit 'qqqqqq'; examples of known units"),
        ("", Dimension.LENGTH, "empty"),
        ("  ", Dimension.LENGTH, "empty"),
        ("nan mm", Dimension.LENGTH, "not a finite number"),
        ("-inf mm", Dimension.LENGTH, "not a finite number"),
        ("Infinity", Dimension.DIMENSIONLESS, "not a finite number"),
        (math.nan, Dimension.DIMENSIONLESS, "not finite"),
        (-math.inf, Dimension.DIMENSIONLESS, "not finite"),
        (10**400, Dimension.DIMENSIONLESS, "not finite"),
        ("1e400 mm", Dimension.LENGTH, "not finite in double precision"),
        ("1e99999999999999 mm", Dimension.LENGTH, "not finite in double precision"),
        ("1e-400 mm", Dimension.LENGTH, "too small for double precision"),
        ("1e-320 fm", Dimension.LENGTH, "beyond the range"),
        ("1e300 GPa", Dimension.PRESSURE, "beyond the range"),
        ("1,5 mm", Dimension.LENGTH, "decimal point"),
        ("mm", Dimension.LENGTH, "does not start with a number"),
        ("mm 5", Dimension.LENGTH, "does not start with a number"),
        ("5.5.5 mm", Dimension.LENGTH, "does not start with a number"),
        ("1 000 mm", Dimension.LENGTH, "cannot read the unit"),
        ("1/2 mm", Dimension.LENGTH, "cannot read the unit"),
        ("1 1 mm", Dimension.LENGTH, "cannot read the unit"),
        ("5 * mm", Dimension.LENGTH, "cannot read the unit"),
        ("5 N//m", Dimension.STIFFNESS, "cannot read the unit"),
        ("5 N*", Dimension.FORCE, "cannot read the unit"),
        ("5 m^1.5", Dimension.LENGTH, "cannot read the unit"),
        ("5 m^99", Dimension.LENGTH, "beyond ±12"),
        ("5 (N/m)", Dimension.STIFFNESS, "parentheses are only those of a product below a stroke"),
        ("5 N/(m/rad)", Dimension.STIFFNESS, "parentheses are only those of a product below a stroke"),
        ("5 N/((m))", Dimension.STIFFNESS, "parentheses are only those of a product below a stroke"),
        ("5 mm" + " " * 300 + "x", Dimension.LENGTH, "characters of text"),
        (True, Dimension.DIMENSIONLESS, "got True"),
        (None, Dimension.LENGTH, "got None"),
        (["13.5 mm"], Dimension.LENGTH, r"got \['13.5 mm'\]"),
        ({"mm": 5}, Dimension.LENGTH, "got {'mm': 5}"),
    ],
)
def test_bad_input_is_named(text, dimension, message):
    with pytest.raises(InputError, match=message):
        parse_quantity(text, dimension)


@given(
    st.one_of(st.text(max_size=30), st.text("0123456789.eE+-*/^ mNPakgrd%°²⁻()", max_size=30)),
    st.sampled_from(Dimension),
)
def test_any_text_is_a_finite_number_or_an_input_error(text, dimension):
    try:
        value = parse_quantity(text, dimension)
    except InputError:
        return
    assert math.isfinite(value)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("13.5 mm +- 5 um", (0.0135, 5e-6)),
        ("13.5 mm ± 5 µm", (0.0135, 5e-6)),
        ("13.5mm+/-0.005mm", (0.0135, 5e-6)),
        ("-13.5 mm +− 0 mm", (-0.0135, 0.0)),
        ("1e+1 mm + - 1e-3 mm", (0.01, 1e-6)),
    ],
)
def test_tolerance(text, expected):
    assert parse_tolerance(text, Dimension.LENGTH) == expected


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("13.5 mm", r"not exactly one '\+-'"),
        ("13.5 mm ± 1 mm ± 1 mm", r"not exactly one '\+-'"),
        ("13.5 ± 0.005 mm", "bare number"),
        ("13.5 mm ± 0.005", "bare number"),
        ("13.5 mm ± 5 N", "expected a length .* got a force"),
        ("13.5 mm ± 1 %", "got a dimensionless number"),
        ("13.5 mm ± -1 µm", "negative tolerance"),
        ("13.5 mm ±", "empty"),
        (13.5, "got 13.5"),
        (True, "got True"),
        (None, "got None"),
    ],
)
def test_bad_tolerance_is_named(text, message):
    with pytest.raises(InputError, match=message):
        parse_tolerance(text, Dimension.LENGTH)


@given(st.sampled_from(PAIRS), st.floats(-1e12, 1e12, allow_subnormal=False))
def test_text_and_value_round_trip(pair, value):
    dimension, unit = pair
    back = parse_quantity(format_quantity(value, unit, digits=17), dimension)
    assert back == pytest.approx(value, rel=1e-14, abs=1e-300)


@pytest.mark.parametrize(
    ("value", "unit", "expected"),
    [
        (0.0135, "mm", "13.5 mm"),
        (4.9999e6, "N*m/rad", "5e6 N·m/rad"),
        (4.3e6, "N*m/rad", "4.3e6 N·m/rad"),
        (-1e-11, "mm", "-1e-8 mm"),
        (46.2963, "N", "46.3 N"),
        (123456.78, "N/m", "123457 N/m"),
        (999999.7, "N", "1e6 N"),
        (7850.0, "kg/m^3", "7850 kg/m³"),
        (2.0, "kg*m**-3", "2 kg·m⁻³"),
        (0.0, "N", "0 N"),
        (-0.0, "N", "0 N"),
        (0.12, "1", "0.12"),
        (0.12, "%", "12 %"),
        (math.nan, "N", "nan N"),
        (-math.inf, "N", "-inf N"),
        (math.pi, "deg", "180 deg"),
        (200 * math.pi, "rpm", "6000 rpm"),
    ],
)
def test_display(value, unit, expected):
    assert format_quantity(value, unit) == expected


def test_conversion_to_a_unit():
    assert from_si(450e6, "MPa") == 450.0
    assert from_si(math.pi, "arcmin") == pytest.approx(10800.0, rel=4e-16)
    with pytest.raises(InputError, match="unknown unit"):
        from_si(1.0, "furlongs")
    with pytest.raises(InputError, match="beyond the range"):
        from_si(1.0, "Tm^12*Tm^12*Tm^12")


def test_importing_loads_nothing_heavy():
    heavy = "{'pint', 'numpy', 'jax', 'pydantic', 'decimal', 'fractions', 'difflib'}"
    code = f"import sys, asperity.units; print(sorted({heavy} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize("unit", ["1/min", "/min", "min^-1", "min**-1", "min⁻¹", " 1 / min"])
def test_speeds_per_minute_are_turns_per_minute(unit):
    assert parse_quantity(f"1500 {unit}", Dimension.ANGULAR_VELOCITY) == pytest.approx(
        50.0 * math.pi, rel=1e-15
    )
    assert parse_quantity(f"1500 {unit}", Dimension.FREQUENCY) == pytest.approx(25.0, rel=1e-15)


@pytest.mark.parametrize("text", ["30 cSt", "30 mm^2/s"])
def test_a_kinematic_viscosity_is_refused_with_what_to_do(text):
    with pytest.raises(InputError, match=r"kinematic viscosity; multiply it by the density.*26\.1 mPa\*s"):
        parse_quantity(text, Dimension.VISCOSITY)
    assert 30 * by_pint("1 cSt") * 870 == pytest.approx(
        parse_quantity("26.1 mPa*s", Dimension.VISCOSITY), rel=1e-12
    )


def test_centipoise_is_a_viscosity():
    assert parse_quantity("30 cP", Dimension.VISCOSITY) == pytest.approx(by_pint("30 cP"), rel=1e-15)


# spelling of drives and instruments → the product that pint reads
TORQUE_SPELLINGS = {
    "N-m": "newton * meter",
    "N.m": "newton * meter",
    "N·m": "newton * meter",
    "N‑m": "newton * meter",  # with the hyphen that does not break, as copied from a data sheet
    "N - m": "newton * meter",
    "kN-mm": "kilonewton * millimeter",
    "mN.m": "millinewton * meter",
    "in-lb": "inch * force_pound",
    "in-lbs": "inch * force_pound",
    "in.-lb": "inch * force_pound",
    "in-lbf": "inch * force_pound",
    "lb-in": "force_pound * inch",
    "lb*in": "force_pound * inch",
    "lb in": "force_pound * inch",
    "lbf-in": "force_pound * inch",
    "lbf·in": "force_pound * inch",
    "oz-in": "force_ounce * inch",
    "in-oz": "force_ounce * inch",
    "ozf-in": "force_ounce * inch",
    "ft-lb": "foot * force_pound",
    "ft.lb": "foot * force_pound",
    "lb-ft": "force_pound * foot",
    "ft-lbf": "foot * force_pound",
    "kgf-cm": "kilogram_force * centimeter",
    "kgf.cm": "kilogram_force * centimeter",
    "kgf-m": "kilogram_force * meter",
}
ANGLE_SPELLINGS = {
    "arc-min": "arcminute",
    "arc min": "arcminute",
    "arcmin": "arcminute",
    "arc-minutes": "arcminute",
    "arc-sec": "arcsecond",
    "arc sec": "arcsecond",
    "arcsec": "arcsecond",
}


@pytest.mark.parametrize(("spelling", "product"), TORQUE_SPELLINGS.items())
def test_torques_as_drives_and_instruments_write_them(spelling, product):
    expected = by_pint(f"5 {product}")
    assert parse_quantity(f"5 {spelling}", Dimension.TORQUE) == pytest.approx(expected, rel=1e-14)
    assert from_si(expected, spelling) == pytest.approx(5.0, rel=1e-14)


@pytest.mark.parametrize(("spelling", "unit"), ANGLE_SPELLINGS.items())
def test_parts_of_a_degree_with_a_hyphen(spelling, unit):
    assert parse_quantity(f"3 {spelling}", Dimension.ANGLE) == pytest.approx(by_pint(f"3 {unit}"), rel=1e-14)


@given(st.sampled_from(sorted(TORQUE_SPELLINGS)), st.sampled_from(sorted(ANGLE_SPELLINGS)))
def test_torques_over_angles_in_any_spelling(torque, angle):
    expected = by_pint(f"2 {TORQUE_SPELLINGS[torque]} / {ANGLE_SPELLINGS[angle]}")
    assert parse_quantity(f"2 {torque}/{angle}", Dimension.TORSIONAL_STIFFNESS) == pytest.approx(
        expected, rel=1e-13
    )


@pytest.mark.parametrize(
    ("text", "dimension", "by_hand"),
    [
        # a hyphen or a point makes one unit of its names, also below a fraction bar
        ("475 J/kg-K", Dimension.SPECIFIC_HEAT_CAPACITY, "475 J/kg/K"),
        ("21 W/m.K", Dimension.THERMAL_CONDUCTIVITY, "21 W/m/K"),
        ("150 lbf/in-lb", Dimension.FORCE_PER_TORQUE, "150 / inch"),
        ("2e-6 kg-m^2", Dimension.MOMENT_OF_INERTIA, "2e-6 kg * m**2"),
        ("3 kg.m²", Dimension.MOMENT_OF_INERTIA, "3 kg * m**2"),
        # the pound of a mass, and that of a force where a mass makes no sense
        ("3 lb-in^2", Dimension.MOMENT_OF_INERTIA, "3 pound * inch**2"),
        ("3 oz-in^2", Dimension.MOMENT_OF_INERTIA, "3 ounce * inch**2"),
        ("3 oz-in-s^2", Dimension.MOMENT_OF_INERTIA, "3 force_ounce * inch * s**2"),
        ("0.283 lb/in^3", Dimension.DENSITY, "0.283 pound / inch**3"),
        ("3 lb*ft/s^2", Dimension.FORCE, "3 pound * foot / s**2"),
        ("8 oz", Dimension.MASS, "8 ounce"),
        ("8 lb", Dimension.MASS, "8 pound"),
        ("8 ozf", Dimension.FORCE, "8 force_ounce"),
        ("4 in-lb/rad/lb", Dimension.TORSIONAL_STIFFNESS_PER_MASS, "4 inch * force_pound / rad / pound"),
    ],
)
def test_hyphens_pounds_and_ounces_against_pint(text, dimension, by_hand):
    assert parse_quantity(text, dimension) == pytest.approx(by_pint(by_hand), rel=1e-14)


@pytest.mark.parametrize(
    ("text", "dimension", "message"),
    [
        ("100 lb", Dimension.FORCE, "expected a force .* got a mass 'lb'"),
        ("5 lb-in", Dimension.MASS, "expected a mass .* got a torque 'lb-in'"),
        ("20 kg-cm", Dimension.TORQUE, r"got a quantity of unit m\*kg.*a kilogram is a mass.*kgf\*cm"),
        ("5 s-1", Dimension.FREQUENCY, r"cannot read the unit 's-1' from '-1' on; .*'\^', .*'s\^-1'"),
        ("5 -m", Dimension.LENGTH, "cannot read the unit"),
        ("5 .m", Dimension.LENGTH, "cannot read the unit"),
        ("5 N-", Dimension.FORCE, "cannot read the unit"),
        ("5 N--m", Dimension.TORQUE, "cannot read the unit"),
        ("5 N-M", Dimension.TORQUE, "unknown unit 'M'; did you mean 'm'"),
        ("5 ft-Ibf", Dimension.TORQUE, "unknown unit 'Ibf'; did you mean 'lbf'"),
        ("5 mm - 3 mm", Dimension.LENGTH, "cannot read the unit"),
        ("5 m-1", Dimension.CURVATURE, "cannot read the unit"),
    ],
)
def test_what_hyphens_do_not_mean(text, dimension, message):
    with pytest.raises(InputError, match=message):
        parse_quantity(text, dimension)


@pytest.mark.parametrize("text", ["3 m^-1", "3 m**-1", "3 m⁻¹", "3 1/m"])
def test_a_minus_of_an_exponent_stays_one(text):
    assert parse_quantity(text, Dimension.CURVATURE) == 3.0


def test_a_tolerance_in_a_unit_with_a_hyphen():
    value, tolerance = parse_tolerance("5 in-lb +- 1 oz-in", Dimension.TORQUE)
    assert value == pytest.approx(by_pint("5 inch * force_pound"), rel=1e-14)
    assert tolerance == pytest.approx(by_pint("1 inch * force_ounce"), rel=1e-14)

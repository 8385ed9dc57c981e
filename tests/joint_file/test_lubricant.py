"""The oil of a joint file: viscosity, traction and temperature against published numbers, and what is refused."""

import dataclasses
import math
from pathlib import Path

import jax
import numpy as np
import pytest
from assumed import assumptions
from traction_contacts import OILS

from asperity.contact.fluid import DataSheetTraction, RheologicalTraction
from asperity.contact.viscosity import reciprocal_asymptotic_coefficient
from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.joint.temperature import at_temperature
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import numeric_keys, replace_values, si_values
from asperity.page.description import form_of

EXAMPLES = Path(__file__).parents[2] / "examples"
PLANETARY = (EXAMPLES / "planetary.toml").read_text()
TEMPERATURE = '\n[temperature]\nassembly = "20 degC"\nworking = "40 degC"\n'
OWN = 'viscosity_40 = "100 mm^2/s"\nviscosity_100 = "11 mm^2/s"\ndensity = "880 kg/m^3"\n'
RIG = 'rig = {{ youngs_modulus = "206 GPa", poisson_ratio = 0.3, {} }}\n'


def oiled(oil, more="", *, temperature=TEMPERATURE):
    """A planetary joint with these keys of its oil, and sections behind them."""
    return PLANETARY.replace('viscosity = "30 mPa*s"', oil) + temperature + more


def with_own(keys):
    """A planetary joint with an oil of its own."""
    return oiled('fluid = "mine"', f"[fluids.mine]\n{keys}")


def rolling(text):
    return joint_from_case(parse_case(text, source="x")).rolling


def pressure_coefficient(fluid, celsius, peak=1.0396e9):
    return 1e9 * float(
        reciprocal_asymptotic_coefficient(
            viscosity=fluid.viscosity, peak_pressure=np.asarray(peak), temperature=celsius + 273.15
        )
    )


@pytest.mark.parametrize(
    ("name", "celsius", "viscosity", "coefficient"),
    [
        ("M100", 25, 0.18476, 21.78),
        ("M100", 40, 0.07691, 20.06),
        ("M100", 60, 0.03133, 18.11),
        ("M100", 100, 0.00914, 15.07),
        ("N100", 40, 0.06966, 27.31),
        ("PAO100", 40, 0.08346, 14.33),
        ("Santotrac 50", 40, 0.03050, 28.85),
        ("Santotrac 50", 80, 0.00766, 20.30),
    ],
)
def test_oils_of_the_library_are_those_of_an_independent_prototype(name, celsius, viscosity, coefficient):
    """Its reciprocal asymptotic coefficients are those of a steel contact of 1.04 GPa."""
    text = oiled(f'fluid = "{name}"').replace('"40 degC"', f'"{celsius} degC"')
    conditions = rolling(text)
    assert float(conditions.viscosity) == pytest.approx(viscosity, rel=2e-3)
    assert pressure_coefficient(conditions.lubricant.fluid, celsius) == pytest.approx(coefficient, rel=2e-3)
    assert conditions.lubricant.temperature == pytest.approx(celsius + 273.15)


@pytest.mark.parametrize("spelling", ["santotrac-50", "S50", "Santotrac50"])
def test_an_oil_of_the_library_has_several_spellings(spelling):
    assert (
        rolling(oiled(f'fluid = "{spelling}"')).lubricant
        == rolling(oiled('fluid = "Santotrac 50"')).lubricant
    )


def test_walther_meets_both_viscosities_and_is_straight_in_its_chart():
    """Of ASTM D341: lg lg (nu + 0.7) over lg T."""
    fluid = rolling(with_own(OWN)).lubricant.fluid
    at = fluid.viscosity.base
    assert float(at(313.15)) == pytest.approx(0.088, rel=1e-9)
    assert float(at(373.15)) == pytest.approx(0.00968, rel=1e-9)
    lg = [math.log10(math.log10(float(at(t)) / 880e-6 + 0.7)) for t in (293.15, 313.15, 353.15)]
    steep = [math.log10(t) for t in (293.15, 313.15, 353.15)]
    assert (lg[1] - lg[0]) / (steep[1] - steep[0]) == pytest.approx((lg[2] - lg[1]) / (steep[2] - steep[1]))


@pytest.mark.parametrize(
    ("name", "celsius", "share"),
    [
        ("M100", 25, 1.0),
        ("M100", 40, 1.0),
        ("M100", 60, 1.0),
        ("M100", 100, 1.0),
        ("N100", 40, 1.5),
        ("S50", 40, 1.7),
        ("PAO100", 60, 0.7),
    ],
)
def test_the_estimate_is_that_of_paraffinic_mineral_oils(name, celsius, share):
    """A second route: the viscosity of measured oils, and what they have of the estimate by what is assumed."""
    fluid = OILS[name]
    viscosity = float(fluid.viscosity.base(celsius + 273.15))
    estimate = 10.471 * (1e3 * viscosity) ** 0.1348
    assert pressure_coefficient(fluid, celsius) == pytest.approx(share * estimate, rel=0.1)


def test_the_estimate_stands_in_the_viscosity_and_under_assumed():
    case = parse_case(with_own(OWN), source="x")
    fluid = joint_from_case(case).rolling.lubricant.fluid
    # the first slope of ln(eta) over p, by a small pressure
    slope = float(fluid.viscosity.logarithmic_rise(1e3, 313.15)) / 1e3
    assert 1e9 * slope == pytest.approx(10.471 * 88.0**0.1348, rel=1e-5)
    assert fluid.traction is None
    said = " ".join(assumptions(case))
    assert "AGMA 925-A03" in said
    assert "friction as stated: no traction data of the oil" in said
    assert "no conductivity of mine: 0.14" in said


def test_a_stated_pressure_coefficient_is_the_slope_without_pressure():
    fluid = rolling(with_own(OWN + 'pressure_coefficient = "25 1/GPa"\n')).lubricant.fluid
    for kelvin in (293.15, 353.15):
        assert float(fluid.viscosity.logarithmic_rise(1e3, kelvin)) / 1e3 == pytest.approx(25e-9, rel=1e-5)


def test_the_rheology_of_a_file_replaces_single_values_of_the_library():
    text = oiled('fluid = "Santotrac50"', '[fluids.S50]\nshear_modulus = "1 GPa"\n')
    traction, known = rolling(text).lubricant.fluid.traction, OILS["S50"].traction
    assert traction == dataclasses.replace(known, shear_modulus=1e9)
    said = " ".join(assumptions(parse_case(text, source="x")))
    assert "shear_modulus" not in said
    assert "Santotrac50 at 40 degC: below the lowest temperature of its data, 80 degC" in said
    plain = " ".join(assumptions(parse_case(oiled('fluid = "S50"'), source="x")))
    assert "no shear_modulus of S50: 0.5 GPa; films of oil have 0.3 to 1.5 GPa" in plain


def test_an_oil_known_by_its_limit_alone_needs_its_viscosity():
    traction = rolling(oiled('fluid = "5P4E"', f"[fluids.5P4E]\n{OWN}")).lubricant.fluid.traction
    assert isinstance(traction, RheologicalTraction)
    assert traction.limiting_traction.share == 0.088


@pytest.mark.parametrize(
    "sizes",
    [
        'peak_pressure = "1.5 GPa"',
        # p0 = sqrt(N E*/(pi B R)) with R = 10 mm: 6245 N on 10 mm
        f'load = "{math.pi * 1.5e9**2 * 0.01 * 0.01 / (206e9 / 1.82):.10g} N", length = "10 mm", '
        'first_radius = "20 mm", second_radius = "20 mm"',
    ],
)
def test_a_data_sheet_without_its_discs(sizes):
    """m 55 at 1.5 GPa leaves 203 of the film; stated without a rig it is that of the film."""
    sheet = "maximum_traction = 0.09\ntraction_slope = 55\n"
    traction = rolling(with_own(OWN + sheet + RIG.format(sizes))).lubricant.fluid.traction
    assert isinstance(traction, DataSheetTraction)
    assert float(traction.film_slope) == pytest.approx(1.0 / (1.0 / 55.0 - 1.5e9 / (206e9 / 1.82)), rel=1e-9)
    assert round(float(traction.film_slope)) == 203
    alone = rolling(with_own(OWN + sheet)).lubricant.fluid.traction
    assert alone == DataSheetTraction(0.09, 55.0)


def test_every_key_of_the_oil_arrives():
    text = oiled(
        'fluid = "mine"\nroughness = "0.2 um"\nsupply = 0.7\nload_sharing = "erf"\nfilm_law = "pan_hamrock"\n'
        'creep_limit = 0.03\nboundary_friction = [["1 mm/s", 0.12], ["1 m/s", 0.1]]',
        f"[fluids.mine]\n{OWN}"
        'pressure_coefficient = "25 1/GPa"\nlimiting_traction = 0.05\nshear_law = "limit"\n'
        'shear_modulus = "900 MPa"\nconductivity = "0.12 W/m/K"\nlowest_temperature = "10 degC"\n',
    )
    conditions = rolling(text)
    oil, traction = conditions.lubricant, conditions.lubricant.fluid.traction
    assert (oil.supply, oil.creep_limit) == (0.7, 0.03)
    assert (oil.film_law, oil.load_sharing) == ("pan_hamrock", "erf")
    assert (oil.friction_speeds, oil.friction_coefficients) == ((1e-3, 1.0), (0.12, 0.1))
    assert oil.lowest_temperature == pytest.approx(283.15)
    assert (traction.limiting_traction.share, traction.shear_law) == (0.05, "limit")
    assert (traction.shear_modulus, oil.fluid.conductivity) == (9e8, 0.12)
    assert conditions.roughness == (0.2e-6,)


def test_a_written_file_has_other_numbers_of_the_oil_in_their_places():
    rows = (
        "[[fluids.mine.traction_table]]\ntemperature = '20 degC'\nmaximum_traction = 0.09\ntraction_slope = 60\n"
        "[[fluids.mine.traction_table]]\ntemperature = '80 degC'\nmaximum_traction = 0.08\ntraction_slope = 50\n"
    )
    text = oiled(
        'fluid = "mine"\nboundary_friction = [["1 mm/s", 0.12], ["1 m/s", 0.1]]',
        f"[fluids.mine]\n{OWN}{rows}",
    )
    changes = {
        "lubrication.boundary_friction.2.coefficient": 0.09,
        "fluids.mine.traction_table.2.maximum_traction": 0.07,
        "fluids.mine.density": 900.0,
        "lubrication.supply": 0.8,
    }
    case = parse_case(text, source="x")
    again = parse_case(joint_file_text(case, changes, comment=""), source="y")
    assert si_values(again) == replace_values(si_values(case), changes)
    assert rolling(again.text).lubricant.friction_coefficients == (0.12, 0.09)


def test_the_page_has_a_field_for_every_number_of_the_oil():
    """By the key of its description, with a star for the oil and for the row."""
    text = with_own(
        OWN + "maximum_traction = 0.09\ntraction_slope = 55\n" + RIG.format('peak_pressure = "1 GPa"')
    )
    case = parse_case(text, source="x")
    keys = {each["key"] for group in form_of(case)["groups"] for each in group["parameters"]}
    for path in numeric_keys(case):
        if path.startswith("fluids."):
            assert path.replace(".mine.", ".*.") in keys


def test_the_oil_goes_with_the_temperature_of_the_joint():
    joint = joint_from_case(parse_case(oiled('fluid = "M100"'), source="x"))
    warm = at_temperature(joint, 60.0).rolling
    assert warm.lubricant.temperature == pytest.approx(333.15)
    assert float(warm.viscosity) == pytest.approx(0.03133, rel=2e-3)
    dry = joint_from_case(parse_case(PLANETARY + TEMPERATURE, source="x"))
    assert at_temperature(dry, 60.0).rolling.viscosity == dry.rolling.viscosity


@pytest.mark.parametrize(
    "path", ["temperature.working", "fluids.mine.viscosity_40", "fluids.mine.limiting_traction"]
)
def test_the_oil_has_derivatives_by_the_numbers_of_its_file(path):
    """By JAX against a difference of NumPy's numbers."""
    values = si_values(parse_case(with_own(OWN + "limiting_traction = 0.05\n"), source="x"))
    *above, name = path.split(".")
    table = values
    for step in above:
        table = table[step]
    start = table[name]

    def stress(number):
        oil = joint_from_values(replace_values(values, {path: number})).rolling.lubricant
        limit = oil.fluid.traction.limiting_traction.at(1e9, oil.temperature)
        return oil.fluid.viscosity.at(0.5e9, oil.temperature) + 1e-9 * limit

    step = 1e-6 * start
    slope = (float(stress(start + step)) - float(stress(start - step))) / (2.0 * step)
    assert float(jax.grad(stress)(start)) == pytest.approx(slope, rel=1e-5)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (oiled('fluid = "M10"'), "lubrication.fluid: there is no fluid 'M10'; did you mean 'M100'?"),
        (oiled('fluid = "water"'), "known are N100, M100, PAO100, Santotrac50"),
        (oiled("fluid = 3"), "lubrication.fluid: expected the name of a fluid, e.g. 'M100', got 3"),
        (
            oiled('fluid = "M100"\nviscosity = "30 mPa*s"'),
            "a fluid has a viscosity of its own; leave one of them out",
        ),
        (oiled('roughness = "0.2 um"'), "lubrication.viscosity: this key is missing, or fluid in its place"),
        (oiled('fluid = "M100"\npressure_coefficient = "20 1/GPa"'), "a fluid has one of its own"),
        (oiled('fluid = "M100"', temperature=""), "section [temperature] with assembly and working"),
        (oiled('fluid = "M100"\nsupply = 80'), "supply: 80 is not allowed; it must be above 0 and at most 1"),
        (oiled('fluid = "M100"\nsupply = 0'), "supply: 0 is not allowed"),
        (oiled('viscosity = "30 mPa*s"\nsupply = 0.5'), "supply: only with lubrication.fluid"),
        (oiled('fluid = "M100"\nfilm_law = "best"'), "film_law: 'best' is not one of"),
        (oiled('fluid = "M100"\nboundary_friction = [["1 m/s", 0.1]]'), "boundary_friction"),
        (
            oiled('fluid = "M100"\nboundary_friction = [["1 m/s", 0.1], ["1 mm/s", 0.12]]'),
            "boundary_friction: the speeds must rise from pair to pair",
        ),
        (
            oiled('fluid = "M100"\nboundary_friction = [["1 m/s"], ["2 m/s", 1]]'),
            "expected [slip speed, coefficient]",
        ),
        (oiled('fluid = "PG100"'), "fluids.PG100: its viscosity is not known; give viscosity_40"),
        (with_own(""), "fluids.mine: its viscosity is not known"),
        (with_own('density = "880 kg/m^3"\n'), "give viscosity_40 and viscosity_100 as well"),
        (
            with_own(OWN.replace('"11 ', '"110 ')),
            "110 mm^2/s at 100 degC must be below the viscosity_40, 100 mm^2/s",
        ),
        (
            with_own(OWN + "limiting_traction = 4.7\n"),
            "at most 0.2; it is a share of the pressure, not %",
        ),
        (with_own(OWN + "limiting_traction = 0.001\n"), "a share of the pressure, not %"),
        (with_own(OWN + "maximum_traction = 9\ntraction_slope = 55\n"), "a share of the load, not %"),
        (with_own(OWN + "maximum_traction = 0.09\n"), "maximum_traction needs traction_slope beside it"),
        (
            with_own(OWN + "maximum_traction = 0.09\ntraction_slope = 55\nlimiting_traction = 0.05\n"),
            "all say what traction the film bears: leave all but one out",
        ),
        (
            with_own(
                OWN
                + "maximum_traction = 0.09\ntraction_slope = 75.5\n"
                + RIG.format('peak_pressure = "1.5 GPa"')
            ),
            "75.5 is steeper than the discs alone, whose slope E*/p0 is 75.46",
        ),
        (with_own(OWN + RIG.format('peak_pressure = "1.5 GPa"')), "rig: only with traction_slope"),
        (
            with_own(OWN + "maximum_traction = 0.09\ntraction_slope = 55\n" + RIG.format('load = "5 kN"')),
            "length and first_radius: missing",
        ),
        (
            with_own(
                OWN
                + "maximum_traction = 0.09\ntraction_slope = 55\n"
                + RIG.format('peak_pressure = "1 GPa", load = "5 kN"')
            ),
            "exactly one of 'peak_pressure' and the sizes",
        ),
        (with_own(OWN + 'shear_law = "limit"\n'), "without limiting_traction nothing is known"),
        (oiled('fluid = "M100"', '[fluids."a b"]\n' + OWN), "the name of a fluid consists of letters"),
        (with_own(OWN + "viscosity = 3\n"), "fluids.mine.viscosity: unknown key"),
    ],
)
def test_what_cannot_be_is_refused_with_a_remedy(text, told):
    with pytest.raises(InputError) as error:
        parse_case(text, source="x")
    assert told in str(error.value)


@pytest.mark.parametrize("name", ["oil", "measured_oil"])
def test_an_oil_creeps_more_and_carries_less_than_its_boundary_friction(name):
    """The examples, against the same drives with the friction of their asperities alone."""
    path = EXAMPLES / f"{name}.toml"
    oiled_joint = joint_from_case(read_case(path))
    dry = dataclasses.replace(
        oiled_joint, rolling=dataclasses.replace(oiled_joint.rolling, lubricant=None, viscosity=None)
    )
    oily, plain = (solve_joint(joint) for joint in (oiled_joint, dry))
    assert float(oily.rolling_capacity.output_torque) < float(plain.rolling_capacity.output_torque)
    assert "made up" in (EXAMPLES / "measured_oil.csv").read_text()


def test_what_the_film_lacks_is_said():
    """The paper's steel has no thermal properties, and its surfaces by D and G no heights."""
    text = (EXAMPLES / "zou2025.toml").read_text() + '\n[lubrication]\nfluid = "Santotrac 50"\n' + TEMPERATURE
    said = " ".join(assumptions(parse_case(text, source="x")))
    assert (
        "no flash temperature of its contacts, and the heat of slip warms the film by its own conduction"
        in said
    )
    assert "no film ratio λ; the film carries the whole load, the asperities nothing" in said
    plain = " ".join(assumptions(parse_case((EXAMPLES / "zou2025.toml").read_text(), source="x")))
    assert "warms the film" not in plain

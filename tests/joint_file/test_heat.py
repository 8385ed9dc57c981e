"""Section [heat]: what it needs, what is refused, and joints at the temperatures at which they settle."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.heat import duty_temperatures, time_constant
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values
from asperity.joint_file.solved_document import document_of, solved_case
from asperity.joint_file.window import joint_window
from asperity.results.torque_capacity import capacity_of_direction

EXAMPLES = Path(__file__).parents[2] / "examples"
STILL = 'ambient = "25 degC"\nresistance = "3 K/W"\n'


def text_with(heat, *, oil="Santotrac 50", changes=()):
    """The example with oil, cooled by a section in place of its working temperature."""
    text = (EXAMPLES / "oil.toml").read_text(encoding="utf-8").replace("Santotrac 50", oil)
    kept = [line for line in text.splitlines() if not line.startswith("working = ")]
    text = "\n".join(kept) + f"\n[heat]\n{heat}"
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return text


def case_of(*arguments, **options):
    """The joint file of :func:`text_with`."""
    return parse_case(text_with(*arguments, **options), source="joint.toml")


@pytest.fixture(scope="module")
def solved():
    """The example, cooled by still air."""
    return solved_case(case_of(STILL))


@pytest.mark.parametrize(
    ("heat", "message"),
    [
        (
            'ambient = "25 degC"',
            "heat: exactly one of resistance and area with coefficient is needed, got neither",
        ),
        (STILL + 'area = "0.05 m^2"\ncoefficient = "10 W/m^2/K"', "is needed, got both"),
        (
            'ambient = "25 degC"\narea = "0.05 m^2"',
            "heat.coefficient: this key is missing: area alone cools nothing",
        ),
        ('resistance = "3 K/W"', "heat.ambient: this key is missing: a temperature"),
        (
            'ambient = "25 degC"\nresistance = "0 K/W"',
            "heat.resistance: 0 K/W is not allowed; it must be above 0 K/W and at most 1e6 K/W",
        ),
        ('ambient = "25 degC"\nresistance = "-1 K/W"', "heat.resistance: -1 K/W is not allowed"),
        ('ambient = "25 degC"\nresistance = "3 W/K"', "heat.resistance"),
        (STILL + 'oil_limit = "20 degC"', "ambient = '25 degC' must be below oil_limit, 20 degC; lower it"),
        (STILL + 'cold_start = "130 degC"', "cold_start = '130 degC' must be below oil_limit, 120 degC"),
        (STILL + 'roller_resistance = "-0.1 K/W"', "heat.roller_resistance"),
        (STILL + 'heat_capacity = "0 J/K"', "heat.heat_capacity"),
    ],
)
def test_refused_with_key_value_and_remedy(heat, message):
    with pytest.raises(InputError) as refused:
        case_of(heat)
    assert message in str(refused.value)


def test_two_temperatures_are_refused():
    text = (EXAMPLES / "oil.toml").read_text(encoding="utf-8") + f"\n[heat]\n{STILL}"
    with pytest.raises(InputError, match=r"\[heat\] and temperature.working: .*leave one of both out"):
        parse_case(text, source="joint.toml")


def test_no_temperature_is_refused():
    text = "\n".join(
        line
        for line in (EXAMPLES / "oil.toml").read_text(encoding="utf-8").splitlines()
        if not line.startswith("working = ")
    )
    with pytest.raises(InputError, match=r"temperature.working: this key is missing, or a section \[heat\]"):
        parse_case(text, source="joint.toml")


def test_interference_needs_the_temperature_of_its_assembly():
    with pytest.raises(InputError, match=r"\[heat\] with load.interference .* give temperature.assembly"):
        case_of(STILL, changes=[("[temperature]\n", ""), ('assembly = "20 degC"\n', "")])


def test_temperature_is_what_the_losses_make(solved):
    """The document closes the balance by itself: all losses through the resistance."""
    document = document_of(case_of(STILL), solved)
    heat, loss = document["heat"], document["losses_W"]["total"]
    assert heat["steady"]
    assert heat["roller_temperature_degC"] == pytest.approx(25.0 + 3.0 * loss, abs=1e-5)
    assert heat["loss_W"] == pytest.approx(loss, rel=1e-6)
    assert document["preload"]["at_assembly"]["working_temperature_degC"] == heat["housing_temperature_degC"]
    assert float(solved.joint.rolling.lubricant.temperature) - 273.15 == pytest.approx(
        heat["roller_temperature_degC"], abs=1e-9
    )


def test_stated_temperature_gives_the_same_joint(solved):
    """The drive that settles is the drive of a file with its temperature."""
    at = float(solved.joint.heat.roller_temperature)
    text = (EXAMPLES / "oil.toml").read_text(encoding="utf-8")
    assert 'working = "40 degC"' in text
    other = solved_case(parse_case(text.replace('"40 degC"', f'"{at!r} degC"'), source="joint.toml"))
    for name in ("drift_per_output_turn", "creepage", "normal"):
        found, expected = (getattr(each.result.rolling, name) for each in (solved, other))
        assert np.asarray(found) == pytest.approx(np.asarray(expected), rel=1e-9)


def test_area_and_coefficient_are_a_resistance(solved):
    by_area = joint_from_case(
        case_of('ambient = "25 degC"\narea = "0.0333333333333333333 m^2"\ncoefficient = "10 W/m^2/K"')
    )
    assert float(by_area.heat.roller_temperature) == pytest.approx(
        float(solved.joint.heat.roller_temperature), abs=1e-9
    )


def test_warm_rollers_press_harder():
    """Rollers a kelvin above the ring add their expansion times the radius of the ring, 50 mm of 11.5e-6 1/K."""
    joint = joint_from_case(case_of(STILL + 'roller_resistance = "2 K/W"'))
    rise = float(joint.heat.roller_temperature) - float(joint.heat.housing_temperature)
    assert rise == pytest.approx(2.0 * float(joint.heat.loss), rel=1e-9)
    expansion = float(joint.materials[0].thermal_expansion)
    assert float(joint.fit.thermal_change) == pytest.approx(expansion * 50e-3 * rise, rel=1e-9)


def test_time_constant_by_hand():
    """Heat capacity of housing, sun and three planets times the resistance, less what the losses fall."""
    case = case_of(STILL + 'heat_capacity = "400 J/K"')
    joint = joint_from_case(case)
    steel = joint.materials[0]
    volume = math.pi * 5e-3 * (10e-3**2 + 3 * 20e-3**2)
    capacity = float(steel.density) * volume * float(steel.specific_heat_capacity)
    expected = 3.0 * (400.0 + capacity) / (1.0 - float(joint.heat.gain))
    assert time_constant(joint) == pytest.approx(expected, rel=1e-9)


def test_time_constant_is_the_slower_one_of_rollers_and_housing():
    """Eigenvalues of both balances of heat, with the slope of the losses at the rollers."""
    joint = joint_from_case(case_of(STILL + 'heat_capacity = "400 J/K"\nroller_resistance = "2 K/W"'))
    steel, flow = joint.materials[0], joint.heat.flow
    volume = math.pi * 5e-3 * (10e-3**2 + 3 * 20e-3**2)
    rollers = float(steel.density) * volume * float(steel.specific_heat_capacity)
    slope = float(joint.heat.gain) / 5.0
    rates = np.array(
        [
            [(slope - 1.0 / 2.0) / rollers, 1.0 / 2.0 / rollers],
            [1.0 / 2.0 / 400.0, -(1.0 / 2.0 + 1.0 / 3.0) / 400.0],
        ]
    )
    assert (float(flow.resistance), float(flow.roller_resistance)) == (3.0, 2.0)
    assert time_constant(joint) == pytest.approx(-1.0 / np.linalg.eigvals(rates).real.max(), rel=1e-9)


def test_loads_of_a_duty_alone_are_joints_with_these_loads():
    """Each temperature is that at which a joint with this load settles, and the mean lies between them."""
    duty = "".join(
        f'\n[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "{speed} rpm"\nshare = {share}\n'
        for torque, speed, share in ((14.0, 1500.0, 0.25), (4.0, 1000.0, 0.75))
    )
    found = duty_temperatures(joint_from_case(case_of(STILL + duty)))
    for at, torque, speed in zip(found.alone, (14, 4), (1500, 1000), strict=True):
        changes = [('"10 N*m"', f'"{torque} N*m"'), ('"1500 rpm"', f'"{speed} rpm"')]
        alone = joint_from_case(case_of(STILL, changes=changes))
        assert at == pytest.approx(float(alone.heat.roller_temperature), abs=0.01)
    assert found.alone[1] < found.mean < found.alone[0]
    assert math.isnan(found.peak)


def test_runaway_is_an_answer_with_the_torque_that_settles():
    case = case_of(
        STILL,
        oil="M100",
        changes=[
            ('sun_speed = "1500 rpm"', 'sun_speed = "4000 rpm"'),
            ('output_torque = "10 N*m"', 'output_torque = "4 N*m"'),
        ],
    )
    found = solved_case(case)
    document = document_of(case, found)
    assert not document["heat"]["steady"]
    assert document["heat"]["roller_temperature_degC"] is None
    (crossed,) = (entry for entry in document["diagnostics"] if entry["name"] == "ambient_reserve")
    assert not crossed["ok"]
    assert "thermal runaway" in crossed["meaning"]
    assert not document["verdict"]["works"]
    torque = document["heat"]["steady_torque_Nm"]
    assert 0.0 < torque < 4.0
    for share, steady in ((0.97, True), (1.03, False)):
        other = text_with(
            STILL,
            oil="M100",
            changes=[
                ('sun_speed = "1500 rpm"', 'sun_speed = "4000 rpm"'),
                ('output_torque = "10 N*m"', f'output_torque = "{share * torque} N*m"'),
            ],
        )
        assert bool(joint_from_case(parse_case(other, source="joint.toml")).heat.is_steady) == steady


@pytest.mark.parametrize(
    "kind", ["zou2025", "planetary", "stepped_planet", "multiroller", "planar", "wheel_pair"]
)
def test_every_drive_settles(kind):
    """A dry drive, too: its creep is what warms it."""
    text = (EXAMPLES / f"{kind}.toml").read_text(encoding="utf-8")
    kept = [line for line in text.splitlines() if not line.startswith("working = ")]
    text = "\n".join(kept)
    if "\n[temperature]" not in text:
        text += '\n[temperature]\nassembly = "20 degC"\n'
    case = parse_case(f'{text}\n[heat]\nambient = "20 degC"\nresistance = "1 K/W"\n', source="joint.toml")
    joint = joint_from_case(case)
    loss = float(solved_case(case).result.rolling.power.loss)
    assert float(joint.heat.roller_temperature) == pytest.approx(20.0 + loss, abs=1e-5)


def test_unlike_branches_warm_by_their_own_losses():
    branches = "".join(f'\n[[branch]]\nplanet_deviation = "{size} um"\n' for size in (2, 0, -1))
    case = parse_case(text_with(STILL + branches), source="joint.toml")
    joint = with_own_branches(case)
    loss = float(solved_case(case).result.rolling.power.loss)
    assert float(joint.heat.roller_temperature) == pytest.approx(25.0 + 3.0 * loss, abs=1e-5)


def test_where_the_input_stands_the_drive_is_as_its_surroundings():
    case = case_of(STILL, changes=[('sun_speed = "1500 rpm"', 'sun_speed = "0 rpm"')])
    assert float(joint_from_case(case).heat.roller_temperature) == 25.0


def dry_case(heat):
    """A drive without oil that its creep and its drag at the inlet warm, cooled by a section."""
    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8")
    text = text.replace('preload = "900 N"', 'interference = "30 um"')
    return parse_case(f'{text}\n[temperature]\nassembly = "20 degC"\n[heat]\n{heat}', source="joint.toml")


@pytest.mark.slow
def test_a_batch_finds_the_same_temperatures():
    """Values, and slopes by the ambient; no steady temperature is a status."""
    from asperity.joint.status import STATUS_NAMES
    from asperity.study.batch import derivatives_at, evaluate_points

    case = dry_case(
        'ambient = "25 degC"\nresistance = "6 K/W"\nroller_resistance = "1 K/W"\noil_limit = "90 degC"'
    )
    values, alone = si_values(case), solved_case(case)
    names = ("roller_temperature", "drift", "ambient_reserve")
    points = {
        "load.output_torque": np.array([2.0, 10.0, 10.0, 10.0]),
        "heat.ambient": np.array([25.0, 25.0, 25.1, 89.0]),
    }
    status, found = evaluate_points(values, points, names)
    assert [STATUS_NAMES[code] for code in status] == ["solved"] * 3 + ["thermal_runaway"]
    assert math.isnan(found["drift"][3])
    assert found["ambient_reserve"][3] < 0.0
    at, heat = 1, alone.joint.heat
    assert found["roller_temperature"][at] == pytest.approx(float(heat.roller_temperature), abs=1e-6)
    assert found["ambient_reserve"][at] == pytest.approx(float(heat.ambient_reserve), rel=1e-6)
    drift = float(alone.result.rolling.drift_per_output_turn)
    assert found["drift"][at] == pytest.approx(drift, rel=1e-6)
    middle = {"load.output_torque": np.array([10.0]), "heat.ambient": np.array([25.05])}
    _, _, slopes = derivatives_at(values, middle, names[:2], ("heat.ambient",))
    for name in names[:2]:
        by_difference = (found[name][2] - found[name][1]) / 0.1
        assert slopes[name][0, 0, 0] == pytest.approx(by_difference, rel=1e-3)


@pytest.mark.long
def test_a_batch_with_oil_finds_the_same_temperatures(solved):
    from asperity.study.batch import evaluate_points

    names = ("roller_temperature", "drift", "ambient_reserve")
    status, found = evaluate_points(
        si_values(case_of(STILL)), {"load.output_torque": np.array([2.0, 10.0])}, names
    )
    assert status.tolist() == [0, 0]
    heat = solved.joint.heat
    assert found["roller_temperature"][1] == pytest.approx(float(heat.roller_temperature), abs=1e-6)
    assert found["ambient_reserve"][1] == pytest.approx(float(heat.ambient_reserve), rel=1e-6)
    drift = float(solved.result.rolling.drift_per_output_turn)
    assert found["drift"][1] == pytest.approx(drift, rel=1e-6)


def test_the_document_is_json(solved):
    case = case_of(STILL + 'cold_start = "0 degC"')
    document = document_of(case, solved_case(case))
    cold = json.loads(json.dumps(document))["heat"]["cold_start"]
    text = (EXAMPLES / "oil.toml").read_text(encoding="utf-8").replace('"40 degC"', '"0 degC"')
    other = solved_case(parse_case(text, source="joint.toml"))
    assert cold["rolling_torque_capacity_Nm"] == pytest.approx(float(other.rolling_capacity), rel=1e-6)
    assert cold["efficiency"] == pytest.approx(float(other.result.rolling.power.efficiency), rel=1e-9)


def test_window_over_temperature_has_the_joint_at_its_own(solved):
    """The axis is the temperature; at that at which the drive settles the window has the capacity of the joint."""
    case = case_of(STILL + 'roller_resistance = "0.5 K/W"')
    found = joint_window(case, points=2)
    at = solved_case(case)
    assert found.axis.working == pytest.approx(float(at.joint.heat.housing_temperature), abs=1e-9)
    expected = float(capacity_of_direction(at).output_torque)
    assert found.loads[0].capacity.torque[found.working] == pytest.approx(expected, rel=1e-6)

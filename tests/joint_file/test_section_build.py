from pathlib import Path

import pytest
from assumed import assumptions

from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import numeric_keys, replace_values, si_values
from asperity.rolling.conditions import PLAIN_ROLLING


def with_values(case, changes):
    return joint_from_values(replace_values(si_values(case), changes))


def test_pins_and_rated_bearings(example_text):
    extra = """
[bearings]
sun_torque = "0 N*m"
loading_roller_torque = "0 N*m"
carrier_torque = "0 N*m"
pin_friction_coefficient = 0
pin_diameter = "4 mm"
[pin_bearing]
type = "roller"
dynamic_rating = "3.2 kN"
static_rating = "2.9 kN"
count = 2
[carrier_bearing]
type = "ball"
dynamic_rating = "5 kN"
static_rating = "3 kN"
outside_force = "200 N"
"""
    joint = joint_from_case(parse_case(example_text + extra, source="x"))
    pin, carrier = joint.pin_bearing, joint.output_bearing
    assert (pin.kind, pin.dynamic_rating, pin.static_rating, pin.count) == ("roller", 3200.0, 2900.0, 2.0)
    assert (carrier.kind, carrier.outside_force, carrier.count) == ("ball", 200.0, 1.0)
    assert joint.input_bearing is None
    varied = with_values(parse_case(example_text + extra, source="x"), {"pin_bearing.dynamic_rating": 4e3})
    assert varied.pin_bearing.dynamic_rating == 4e3


ROLLING = """
[rolling]
skew = {sp = "0.5 mrad +- 0.2 mrad", pwr = "0 rad", pwl = "0 rad", wro = "-1 mrad", wlo = "0 rad"}
hysteresis_factor = 0.01
reliability = 0.95

[lubrication]
viscosity = "30.5 mPa*s"
pressure_coefficient = "29 1/GPa"
roughness = "0.25 um"

[[duty]]
output_torque = "5 N*m"
sun_speed = "6000 rpm"
share = 0.25

[[duty]]
output_torque = "-1 N*m"
sun_speed = "0 rpm"
share = 0.75
"""


def _rolling_file(text=ROLLING):
    plain = (Path(__file__).parents[2] / "examples" / "zou2025.toml").read_text()
    return parse_case(plain + text, source="joint.toml")


def test_rolling_oil_and_duty_of_a_file():
    case = _rolling_file()
    found = joint_from_case(case).rolling
    assert found.skew == pytest.approx((5e-4, 0.0, 0.0, -1e-3, 0.0))
    assert found.viscosity == pytest.approx(0.0305)
    assert found.pressure_viscosity_coefficient == pytest.approx(29e-9)
    assert found.roughness == pytest.approx((0.25e-6,))
    assert (found.hysteresis_loss_factor, found.reliability) == (0.01, 0.95)
    assert [point.output_torque for point in found.duty] == [5.0, -1.0]
    assert [point.share for point in found.duty] == [0.25, 0.75]
    assert numeric_keys(case)["rolling.skew.sp"].tolerance == pytest.approx(2e-4)
    assert with_values(case, {"duty.2.output_torque": 2.0}).rolling.duty[1].output_torque == 2.0
    assert not any("rolling." in said or "lubrication" in said for said in assumptions(case))


def test_thermal_properties_and_what_is_absent_without_them():
    case = _rolling_file()
    assert joint_from_case(case).materials[0].thermal_conductivity is None
    (said,) = [text for text in assumptions(case) if "flash temperature" in text]
    assert said.startswith("no thermal_conductivity and specific_heat_capacity of material steel")
    given = {"materials.steel.thermal_conductivity": 46.0, "materials.steel.specific_heat_capacity": 460.0}
    ring = with_values(case, given).materials[-1]
    assert (ring.thermal_conductivity, ring.specific_heat_capacity) == (46.0, 460.0)
    without = _rolling_file(ROLLING.replace('roughness = "0.25 um"\n', ""))
    assert any(text.startswith("no lubrication.roughness") for text in assumptions(without))
    without = _rolling_file(ROLLING.replace('pressure_coefficient = "29 1/GPa"\n', ""))
    assert any(text.startswith("no lubrication.pressure_coefficient") for text in assumptions(without))


def test_a_file_that_says_nothing_of_rolling():
    case = _rolling_file("")
    assert joint_from_case(case).rolling == PLAIN_ROLLING
    said = " ".join(assumptions(case))
    assert all(word in said for word in ("rolling.skew", "hysteresis_factor", "[lubrication]", "reliability"))
    assert with_values(case, {"rolling.skew": 1e-3}).rolling.skew == (1e-3,)
    assert with_values(case, {"rolling.skew.wro": 1e-3}).rolling.skew == (0.0, 0.0, 0.0, 1e-3, 0.0)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("share = 0.75", "share = 0.7", "the shares of [[duty]] must add up to 1, they add up to 0.95"),
        ("share = 0.75", "", "duty.2.share: this key is missing"),
        (
            "share = 0.75",
            'share = "most"',
            "duty.2.share: expected a dimensionless number (e.g. '0.4'), got 'most'",
        ),
        ("share = 0.75", "share = 0", "duty.2.share: 0 is not allowed; it must be above 0 and at most 1"),
        ("share = 0.75", 'share = "0.75 +- 0.1"', "duty.2.share: a share of the time has no tolerance"),
        ('sun_speed = "0 rpm"', 'sun_speed = "-5 rpm"', "duty.2.sun_speed"),
        ("reliability = 0.95", "reliability = 1", "rolling.reliability"),
        (
            'viscosity = "30.5 mPa*s"',
            "",
            "lubrication.viscosity: this key is missing, or fluid in its place: a viscosity",
        ),
        ("-1 mrad", "1 rad", "rolling.skew.wro"),
    ],
)
def test_mistakes_about_rolling_are_named(old, new, said):
    with pytest.raises(InputError) as error:
        _rolling_file(ROLLING.replace(old, new))
    assert said in str(error.value)
    assert "empty" not in str(error.value)


def test_shares_in_per_cent_are_the_same_duty():
    per_cent = ROLLING.replace("share = 0.25", 'share = "25 %"').replace("share = 0.75", 'share = "75%"')
    found = joint_from_case(_rolling_file(per_cent)).rolling.duty
    assert [point.share for point in found] == [0.25, 0.75]


def test_edited_files_keep_the_duty():
    changes = {"duty.2.output_torque": 3.0, "rolling.skew.sp": 1e-3, "load.preload": 900.0}
    text = joint_file_text(_rolling_file(), changes, comment="changed")
    again = parse_case(text, source="again")
    assert again.duty[1].output_torque.value == 3.0
    assert again.rolling.skew["sp"].value == pytest.approx(1e-3)

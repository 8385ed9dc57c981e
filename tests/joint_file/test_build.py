import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case, joint_from_values, with_values
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values


def test_the_example_is_the_joint_of_the_paper(example_case, paper_joint):
    ours = joint_from_case(example_case)
    papers = dataclasses.replace(paper_joint(ring_wall_thickness=60e-3), ring_support="rigid_housing")
    assert jax.tree.structure(ours) == jax.tree.structure(papers)
    np.testing.assert_allclose(jax.tree.leaves(ours), jax.tree.leaves(papers), rtol=1e-15)


def test_rollers_without_a_length_are_as_long_as_their_longest_contact_line(example_case):
    joint = with_values(example_case, {"drive.contact_length.sp": 0.009, "drive.contact_length.wlo": 0.007})
    assert (joint.planet_length, joint.loading_roller_length) == (0.009, 0.007)
    stated = with_values(example_case, {"drive.planet_length": 0.02})
    assert stated.planet_length == 0.02
    swept = with_values(example_case, {"drive.contact_length.pwr": np.array([0.004, 0.008])})
    np.testing.assert_array_equal(swept.planet_length, [0.005, 0.008])


def test_sections_of_bearings_and_compliance(example_text):
    extra = """
[bearings]
sun_torque = "1 N*mm"
loading_roller_torque = "2 N*mm"
carrier_torque = "3 N*mm"
pin_friction_coefficient = 0.002
pin_diameter = "4 mm"
[compliance]
pin_stiffness = "100 N/um"
input_shaft_stiffness = "500 N*m/rad"
"""
    joint = joint_from_case(parse_case(example_text + extra, source="x"))
    assert joint.bearings.carrier_torque == 0.003
    assert joint.bearings.pin_diameter == 0.004
    assert joint.structure.pin_stiffness == 1e8
    assert joint.structure.input_shaft_stiffness == 500.0
    assert joint.structure.output_shaft_stiffness == np.inf  # rigid
    assert joint.structure.planet_support_stiffness == 0.0  # floating


def test_pins_and_rated_bearings(example_text):
    extra = """
[bearings]
sun_torque = "0 N*m"
loading_roller_torque = "0 N*m"
carrier_torque = "0 N*m"
pin_friction_coefficient = 0
pin_diameter = "4 mm"
pin_length = "8 mm"
pin_support = "one_end"
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
    assert (joint.pin.free_length, joint.pin.support) == (0.008, "one_end")
    pin, carrier = joint.pin_bearing, joint.carrier_bearing
    assert (pin.kind, pin.dynamic_rating, pin.static_rating, pin.count) == ("roller", 3200.0, 2900.0, 2.0)
    assert (carrier.kind, carrier.outside_force, carrier.count) == ("ball", 200.0, 1.0)
    assert joint.sun_bearing is None
    assert joint_from_case(parse_case(example_text, source="x")).pin is None
    varied = with_values(parse_case(example_text + extra, source="x"), {"pin_bearing.dynamic_rating": 4e3})
    assert varied.pin_bearing.dynamic_rating == 4e3


def test_crown_radii_become_curvatures(example_case, example_text):
    assert joint_from_case(example_case).crowns is None
    text = example_text.replace("[load]", 'planet_crown_radius = "800 mm"\n[load]')
    crowns = joint_from_case(parse_case(text, source="x")).crowns
    assert (crowns.sun, crowns.planet, crowns.loading_roller, crowns.ring) == (0.0, 1.25, 0.0, 0.0)
    swept = with_values(example_case, {"drive.ring_crown_radius": np.array([2.0, 4.0])})
    np.testing.assert_array_equal(swept.crowns.ring, [0.5, 0.25])
    with pytest.raises(InputError, match=r"planet_crown_radius.*0 mm"):
        parse_case(text.replace("800 mm", "0 mm"), source="x")


def test_each_contact_can_have_its_own_entry(example_text):
    tables = "".join(
        f'[surface.{name}]\nfractal_dimension = {1.3 + 0.1 * i}\nfractal_roughness = "1e-8 mm"\nfrequency_ratio = 1.5\n'
        for i, name in enumerate(("sp", "pwr", "pwl", "wro", "wlo"))
    )
    joint = joint_from_case(parse_case(example_text[: example_text.index("[surface]")] + tables, source="x"))
    assert [surface.fractal_dimension for surface in joint.surfaces] == pytest.approx(
        [1.3, 1.4, 1.5, 1.6, 1.7]
    )


def test_arrays_become_batch_axes(example_case):
    torque = np.linspace(0.0, 5.0, 4)
    joint = with_values(
        example_case, {"load.output_torque": torque, "surface.fractal_dimension": torque[:, None] / 10 + 1.3}
    )
    np.testing.assert_array_equal(joint.output_torque, torque)
    assert joint.surfaces[0].fractal_dimension.shape == (4, 1)


def test_values_out_of_range_are_refused(example_case):
    with pytest.raises(InputError, match=r"load\.preload: -1 N is not allowed"):
        with_values(example_case, {"load.preload": np.array([1.0, -1.0])})


def test_the_last_step_can_be_differentiated(example_case):
    values = si_values(example_case)

    def mean_hardness(yield_strength):
        joint = joint_from_values(replace_values(values, {"materials.steel.yield_strength": yield_strength}))
        return jnp.asarray(joint.bodies.sun.hardness)

    assert jax.grad(mean_hardness)(450e6) == pytest.approx(2.8)
    assert jax.jit(lambda force: with_values(example_case, {"load.preload": force}).preload)(7.0) == 7.0


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
    from pathlib import Path

    from asperity.joint_file.reader import parse_case

    plain = (Path(__file__).parents[2] / "examples" / "zou2025.toml").read_text()
    return parse_case(plain + text, source="joint.toml")


def test_rolling_oil_and_duty_of_a_file():
    from asperity.joint_file.assumptions import assumptions
    from asperity.joint_file.build import joint_from_case, with_values
    from asperity.joint_file.si_tables import numeric_keys

    case = _rolling_file()
    found = joint_from_case(case).rolling
    assert found.skew == pytest.approx((5e-4, 0.0, 0.0, -1e-3, 0.0))
    assert found.viscosity == pytest.approx(0.0305)
    assert found.pressure_viscosity_coefficient == pytest.approx(29e-9)
    assert found.roughness == pytest.approx(0.25e-6)
    assert (found.hysteresis_loss_factor, found.reliability) == (0.01, 0.95)
    assert [point.output_torque for point in found.duty] == [5.0, -1.0]
    assert [point.share for point in found.duty] == [0.25, 0.75]
    assert numeric_keys(case)["rolling.skew.sp"].tolerance == pytest.approx(2e-4)
    assert with_values(case, {"duty.2.output_torque": 2.0}).rolling.duty[1].output_torque == 2.0
    assert not any("rolling." in said or "lubrication" in said for said in assumptions(case))


def test_thermal_properties_and_what_is_absent_without_them():
    from asperity.joint_file.assumptions import assumptions
    from asperity.joint_file.build import joint_from_case, with_values

    case = _rolling_file()
    assert joint_from_case(case).bodies.sun.thermal_conductivity is None
    (said,) = [text for text in assumptions(case) if "flash temperature" in text]
    assert said.startswith("no thermal_conductivity and specific_heat_capacity of material steel")
    given = {"materials.steel.thermal_conductivity": 46.0, "materials.steel.specific_heat_capacity": 460.0}
    ring = with_values(case, given).bodies.ring
    assert (ring.thermal_conductivity, ring.specific_heat_capacity) == (46.0, 460.0)
    without = _rolling_file(ROLLING.replace('roughness = "0.25 um"\n', ""))
    assert any(text.startswith("no lubrication.roughness") for text in assumptions(without))
    without = _rolling_file(ROLLING.replace('pressure_coefficient = "29 1/GPa"\n', ""))
    assert any(text.startswith("no lubrication.pressure_coefficient") for text in assumptions(without))


def test_a_file_that_says_nothing_of_rolling():
    from asperity.joint.rolling_conditions import PLAIN_ROLLING
    from asperity.joint_file.assumptions import assumptions
    from asperity.joint_file.build import joint_from_case, with_values

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
        ('sun_speed = "0 rpm"', 'sun_speed = "-5 rpm"', "duty.2.sun_speed"),
        ("reliability = 0.95", "reliability = 1", "rolling.reliability"),
        ('viscosity = "30.5 mPa*s"', "", "lubrication.viscosity: this key is missing: a viscosity"),
        ("-1 mrad", "1 rad", "rolling.skew.wro"),
    ],
)
def test_mistakes_about_rolling_are_named(old, new, said):
    from asperity.errors import InputError

    with pytest.raises(InputError) as error:
        _rolling_file(ROLLING.replace(old, new))
    assert said in str(error.value)


def test_edited_files_keep_the_duty():
    from asperity.joint_file.edited_text import joint_file_text
    from asperity.joint_file.reader import parse_case

    changes = {"duty.2.output_torque": 3.0, "rolling.skew.sp": 1e-3, "load.preload": 900.0}
    text = joint_file_text(_rolling_file(), changes, comment="changed")
    again = parse_case(text, source="again")
    assert again.duty[1].output_torque.value == 3.0
    assert again.rolling.skew.sp.value == pytest.approx(1e-3)


def test_a_housing_that_expands_more_than_its_joint_takes_preload_away(example_text):
    """Aluminium around bearing steel: looser where it is warm, tighter where it is cold."""

    def preload(working):
        section = f'[temperature]\nassembly = "20 °C"\nworking = "{working} °C"\nhousing_expansion = "23.6e-6 1/K"\n\n'
        text = example_text.replace('preload = "1000 N"', 'interference = "13 um"')
        text = text.replace('= "steel"', '= "52100"').replace("[model]", section + "[model]")
        return float(joint_from_case(parse_case(text, source="x")).preload)

    cold, same, warm = map(preload, (15, 20, 25))
    assert 1.0 < warm < 0.95 * same
    assert 1.05 * same < cold < 2.0 * same

"""The joint of the paper's drive from its file."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.description import body_masses
from asperity.joint_file.build import (
    joint_from_case,
    joint_from_values,
    with_nominal_sizes,
)
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values


def with_values(case, changes):
    return joint_from_values(replace_values(si_values(case), changes))


def test_the_example_is_the_joint_of_the_paper(example_case):
    """Table 2; steel, N_0 = 1000 N, mu = 0.12, D = 1.4, G = 1e-11 m and 6000 rpm are assumed with it."""
    joint = joint_from_case(example_case)
    assert joint.contact_names == ("sp", "pwr", "pwl", "wro", "wlo")
    np.testing.assert_allclose(joint.drive.first_radius, [4e-3, 13.5e-3, 13.5e-3, 5e-3, 5e-3])
    np.testing.assert_allclose(joint.drive.second_radius, [13.5e-3, 5e-3, 5e-3, 40e-3, 40e-3])
    assert joint.drive.sectors == 3.0
    assert joint.drive.closure.equal_coefficients == (("pwr", "pwl"),)
    assert joint.drive.closure.constant_pins == ()
    assert {float(material.youngs_modulus) for material in joint.materials} == {206e9}
    assert {float(material.hardness) for material in joint.materials} == {1260e6}
    (surface,) = joint.surfaces
    assert (surface.fractal_dimension, surface.fractal_roughness) == (1.4, pytest.approx(1e-11))
    assert (joint.preload, joint.output_torque) == (1000.0, 5.0)
    assert joint.input_speed == pytest.approx(6000.0 * np.pi / 30.0)
    assert joint.friction_coefficients == (0.12,)
    assert joint.contact_lengths == (pytest.approx(5e-3),)
    assert [shape.kind for shape in joint.shapes] == [*4 * ["solid"], "ring"]
    assert (float(joint.shapes[-1].size), joint.shapes[-1].support) == (pytest.approx(60e-3), "rigid_housing")


def test_rollers_without_a_length_are_as_long_as_their_longest_contact_line(example_case):
    """Masses of solid steel cylinders."""

    def planet_and_roller(changes):
        joint = with_values(example_case, changes)
        names = [body.name for body in joint.drive.bodies]
        masses = [float(mass) for mass in body_masses(joint)]
        roller = names.index("left_loading_roller")
        return masses[names.index("planet")], masses[roller]

    def cylinder(radius, length):
        return 7850.0 * math.pi * radius**2 * length

    lines = {"drive.contact_length.sp": 0.009, "drive.contact_length.wlo": 0.007}
    assert planet_and_roller(lines) == pytest.approx((cylinder(13.5e-3, 9e-3), cylinder(5e-3, 7e-3)))
    stated = {"drive.planet_length": 0.02, "drive.loading_roller_length": 0.03}
    assert planet_and_roller(stated) == pytest.approx((cylinder(13.5e-3, 20e-3), cylinder(5e-3, 30e-3)))


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
    assert joint.bearings.output_torque == 0.003
    assert joint.bearings.pin_friction_diameter == 0.004
    assert joint.pin_stiffness == 1e8
    assert joint.input_shaft_stiffness == 500.0
    assert joint.output_shaft_stiffness == np.inf  # rigid


def test_crown_radii_become_curvatures(example_case, example_text):
    assert joint_from_case(example_case).crown_curvatures is None
    text = example_text.replace("[load]", 'planet_crown_radius = "800 mm"\n[load]')
    joint = joint_from_case(parse_case(text, source="x"))
    assert joint.crown_curvatures == pytest.approx((1.25, 1.25, 1.25, 0.0, 0.0))
    ring = with_values(example_case, {"drive.ring_crown_radius": 4.0})
    assert ring.crown_curvatures == pytest.approx((0.0, 0.0, 0.0, 0.25, 0.25))
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


def test_the_last_step_can_be_differentiated(example_case):
    values = si_values(example_case)

    def hardness(yield_strength):
        joint = joint_from_values(replace_values(values, {"materials.steel.yield_strength": yield_strength}))
        return jnp.asarray(joint.materials[0].hardness)

    assert jax.grad(hardness)(450e6) == pytest.approx(2.8)
    assert jax.jit(lambda force: with_values(example_case, {"load.preload": force}).preload)(7.0) == 7.0


@pytest.fixture
def by_interference(example_text):
    """Cases preloaded by 13 um."""

    def of(*changes):
        text = example_text.replace('preload = "1000 N"', 'interference = "13 um"')
        for old, new in changes:
            assert old in text
            text = text.replace(old, new)
        return parse_case(text, source="x")

    return of


def test_radii_that_deviate_add_to_the_interference(by_interference):
    """A micrometre of planet is 1.9413 um, one of the ring takes one, one of the sun is cos(theta)/cos(wedge) of it."""
    values = with_nominal_sizes(si_values(by_interference()))
    work = (17.5**2 + 18.5**2 - 35.0**2) / (-2.0 * 17.5 * 18.5)
    work /= (18.5**2 + 35.0**2 - 17.5**2) / (2.0 * 18.5 * 35.0)
    for name, radius, added in (
        ("planet", 13.5e-3, 1.9413),
        ("ring", 40e-3, -1.0),
        ("sun", 4e-3, work),
        ("loading_roller", 5e-3, 1.0 + 1.0 / math.cos(math.radians(13.1582))),
    ):
        joint = joint_from_values(replace_values(values, {f"drive.{name}_radius": radius + 2e-6}))
        found = float(joint.interference) * np.asarray(joint.pattern, dtype=float)
        # of virtual work: over the normal forces at rest, those of the ring as one
        forces = np.array([2.0 * work, *2 * [1.0 / math.cos(math.radians(13.1582))], 1.0, 1.0])
        assert forces @ found / 2.0 == pytest.approx(13e-6 + 2e-6 * added, rel=1e-4, abs=0.0), name
    joint = joint_from_values(values)
    np.testing.assert_allclose(joint.pattern, [0.0, 0.0, 0.0, 1.0, 1.0], atol=1e-12)


def test_interference_at_work_is_that_of_the_assembly_and_of_every_kelvin(by_interference):
    """An aluminium housing pulls 11 um/m/K at 100 mm, and Lamé's ring in plane strain, free inside, passes that on."""
    section = (
        '[temperature]\nassembly = "20 °C"\nworking = "45 °C"\nhousing_expansion = "23.6e-6 1/K"\n\n[model]'
    )
    case = by_interference(('= "steel"', '= "52100"'), ("[model]", section))
    joint = joint_from_case(case)
    inside, outside = 40.0 * (2.0 - 2.0 * 0.29), 100.0 * (1.0 - 2.0 * 0.29) + 40.0**2 / 100.0
    grown = -(23.6e-6 - 12.6e-6) * 100e-3 * inside / outside
    assert float(joint.fit.thermal_change) == pytest.approx(25.0 * grown, rel=1e-6, abs=0.0)
    assert float(joint.interference) == 13e-6
    assert joint_from_case(by_interference()).fit is None

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file import build as module
from asperity.joint_file.build import (
    branches_from_case,
    joint_from_case,
    joint_from_values,
    with_nominal_sizes,
    with_values,
)
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


@pytest.mark.slow
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


@pytest.fixture
def by_interference(example_text, monkeypatch):
    """Cases preloaded by 13 um, whose joints have their interference for a preload."""
    monkeypatch.setattr(module, "joint_preload", lambda joint, length: length)

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
        changed = replace_values(values, {f"drive.{name}_radius": radius + 2e-6})
        found = float(joint_from_values(changed).preload)
        assert found == pytest.approx(13e-6 + 2e-6 * added, rel=1e-4, abs=0.0), name
    assert float(joint_from_values(values).preload) == 13e-6


def test_interference_at_work_is_that_of_the_assembly_and_of_every_kelvin(by_interference):
    """An aluminium housing pulls 11 um/m/K at 100 mm, and Lamé's ring in plane strain, free inside, passes that on."""
    section = (
        '[temperature]\nassembly = "20 °C"\nworking = "45 °C"\nhousing_expansion = "23.6e-6 1/K"\n\n[model]'
    )
    case = by_interference(('= "steel"', '= "52100"'), ("[model]", section))
    joint = joint_from_case(case)
    inside, outside = 40.0 * (2.0 - 2.0 * 0.29), 100.0 * (1.0 - 2.0 * 0.29) + 40.0**2 / 100.0
    grown = -(23.6e-6 - 12.6e-6) * 100e-3 * inside / outside
    assert float(joint.fit.change_per_kelvin) == pytest.approx(grown, rel=1e-6, abs=0.0)
    assert float(joint.preload) == pytest.approx(13e-6 + 25.0 * grown, rel=1e-9, abs=0.0)
    interference, sizes = branches_from_case(case)
    assert interference == pytest.approx(13e-6 + 25.0 * grown, rel=1e-9, abs=0.0)
    assert sizes.planet.tolist() == [0.0, 0.0, 0.0]
    assert branches_from_case(by_interference())[0] == 13e-6

"""Laws of the contacts of a planar joint: the force that an interference makes, and what turns with the carrier."""

import dataclasses
import math

import jax.numpy as jnp
import numpy as np
import pytest
from machines import assembled_laws
from scipy.optimize import brentq

from asperity.contact.crowned_line import crown_compression
from asperity.drive.normal_springs import total_approach
from asperity.drive.state.creep import creepages
from asperity.errors import InputError
from asperity.joint.contacts import rough_joint_contacts
from asperity.joint.description import joint_contacts
from asperity.joint.evaluation import assembled_joint
from asperity.joint.laws import (
    approach_springs,
    contact_laws,
    creep_law,
    drive_load,
    logarithmic_decrease,
)
from asperity.joint.machine import joint_machine
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_values, with_nominal_sizes
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values

YOUNG, POISSON, LENGTH = 203e9, 0.29, 10e-3  # of the example
SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'plane_state = "plane_strain"': "",
    'ring_support = "free"': "",
}


def test_reference_force_of_an_interference(planar_joint):
    """30 um are the compressions of both contacts: two cylinders, and a cylinder against a wall of 8 mm."""
    unit, modulus = (1.0 - POISSON**2) / (math.pi * YOUNG * LENGTH), YOUNG / (2.0 * (1.0 - POISSON**2))

    def compression(force):
        one, two = (
            math.sqrt(4.0 * force * radius / (math.pi * LENGTH * modulus))
            for radius in (20e-3 / 3.0, 100e-3 / 3.0)
        )
        sun = sum(2.0 * math.log(4.0 * radius / one) - 1.0 for radius in (10e-3, 20e-3))
        planet = 2.0 * math.log(4.0 * 20e-3 / two) - 1.0
        ring = 2.0 * (math.log(2.0 * 8e-3 / two) - POISSON / (2.0 * (1.0 - POISSON)))
        return force * unit * (sun + planet + ring)

    joint = planar_joint("planetary", SPRINGS)
    laws = assembled_laws(joint)
    expected = brentq(lambda force: compression(force) - 30e-6, 10.0, 1e6)
    np.testing.assert_allclose(laws.reference_force, expected, rtol=1e-3)
    assert laws.coupling is None
    force = float(laws.reference_force[0])
    secants = np.asarray(laws.springs.secant_compliance)
    assert force * secants.sum() == pytest.approx(compression(force), rel=1e-12)


@pytest.mark.long
def test_crowns_take_from_the_force_of_an_interference(planar_joint):
    """30 um are the approaches of both contacts, that of the crowned planet's track included."""
    crown = {'contact_length = "10 mm"': 'planet_crown_radius = "1 m"\ncontact_length = "10 mm"'}
    even, joint = planar_joint("planetary", SPRINGS), planar_joint("planetary", SPRINGS | crown)
    laws = assembled_laws(joint)
    force = float(laws.reference_force[0])
    np.testing.assert_allclose(laws.reference_force, force, rtol=1e-12)
    of_cylinders = contact_laws(joint_machine(even), jnp.full(2, force))
    approach = force * float(np.sum(of_cylinders.springs.secant_compliance))
    approach += sum(
        float(
            crown_compression(
                normal_force=force,
                crown_curvature=1.0,
                contact_length=LENGTH,
                effective_radius=radius,
                contact_modulus=YOUNG / (2.0 * (1.0 - POISSON**2)),
            )
        )
        for radius in (20e-3 / 3.0, 100e-3 / 3.0)
    )
    assert approach == pytest.approx(30e-6, rel=1e-3)
    found = total_approach(
        springs=laws.springs, normal_force=laws.reference_force, rest_force=laws.reference_force
    )
    assert float(jnp.sum(found)) == pytest.approx(approach, rel=1e-12)


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "sections"),
    [
        pytest.param(
            "zou2025",
            {"bearings": {"pin_diameter": 3e-3, "pin_friction_coefficient": 1e-3}},
            marks=pytest.mark.long,
        ),
        pytest.param("planetary", {"compliance": {"planet_support_stiffness": 1e7}}, marks=pytest.mark.long),
        ("multiroller", {"compliance": {"pin_stiffness": 2e7}}),
        pytest.param("stepped_planet", {}, marks=pytest.mark.long),
    ],
)
def test_an_interference_makes_the_preload_that_makes_it(planar_case, name, sections):
    """In a rigid housing; whatever pins, bores and supports give way, and where statics leaves the forces open."""
    values = si_values(planar_case(name)) | sections
    values["drive"]["ring_support"] = "rigid_housing"
    load = {key: value for key, value in values["load"].items() if key not in ("preload", "interference")}
    stated = assembled_joint(joint_from_values(values | {"load": load | {"preload": 900.0}}))
    size = stated.rest.interference[-1] / jnp.asarray(joint_from_values(values).pattern)[-1]
    made = assembled_joint(joint_from_values(values | {"load": load | {"interference": size}}))
    np.testing.assert_allclose(made.laws.reference_force, stated.laws.reference_force, rtol=1e-7)
    np.testing.assert_allclose(made.rest.normal, stated.rest.normal, rtol=1e-10)


def test_a_given_preload_is_the_reference(planar_joint):
    joint = planar_joint("planetary", SPRINGS | {'interference = "30 um"': 'preload = "700 N"'})
    laws = assembled_laws(joint)
    np.testing.assert_allclose(laws.reference_force, 700.0, rtol=1e-12)
    rough = rough_joint_contacts(
        contacts=joint_contacts(joint), normal_force=jnp.full(2, 700.0), tangential_force=jnp.zeros(2)
    )
    np.testing.assert_allclose(laws.asperity_compliance * rough.tangential_stiffness, 1.0, rtol=1e-12)


@pytest.mark.programs("operations by JAX, one after the other")
def test_springs_and_coupling_of_exact_bodies(planar_joint, monkeypatch):
    """Half-widths grow with the root of the force: of each body an e-fold takes (1 - nu^2)/(pi E L)."""
    joint = planar_joint("planetary")
    whole = 1e-9 * jnp.array(
        [[3.0, 0.5, 9.0, 9.0], [0.5, 4.0, 9.0, 9.0], [9.0, 9.0, 9.0, 9.0], [9.0, 9.0, 9.0, 9.0]]
    )
    monkeypatch.setattr("asperity.joint.laws.body_compliance", lambda **_: whole)
    springs, coupling = approach_springs(joint_machine(joint), jnp.full(2, 700.0))
    fall = 2.0 * (1.0 - POISSON**2) / (math.pi * YOUNG * LENGTH)
    np.testing.assert_allclose(springs.incremental_compliance, [3e-9, 4e-9], rtol=1e-12)
    np.testing.assert_allclose(springs.secant_compliance, [3e-9 + fall, 4e-9 + fall], rtol=1e-9)
    np.testing.assert_allclose(coupling, [[0.0, 0.5e-9], [0.5e-9, 0.0]], rtol=1e-12, atol=1e-24)


def test_creep_of_skewed_contacts_by_hand(planar_joint):
    """(B3): creepages over those of gross slip are a vector z, and 1 - (1 - z)^2 of friction acts nearly along it."""
    skewed = {"[lubrication]": '[rolling]\nskew = { sp = "0.5 mrad", pr = "-0.8 mrad" }\n\n[lubrication]'}
    joint = planar_joint("planetary", SPRINGS | skewed)
    normal, friction = np.array([3000.0, 3000.0]), 0.08
    tangential = 0.25 * friction * normal
    found = creep_law(joint_machine(joint), normal, tangential)
    creepage = np.asarray(creepages(law=found.law, normal=normal, tangential=tangential))
    modulus = YOUNG / (2.0 * (1.0 - POISSON**2))
    for k, (angle, radius) in enumerate(((0.5e-3, 20e-3 / 3.0), (-0.8e-3, 100e-3 / 3.0))):
        width = math.sqrt(4.0 * normal[k] * radius / (math.pi * LENGTH * modulus))
        smooth, asperities = friction * width / radius, float(found.layer_factor[k])
        # across, the bodies are softer; of the asperities only the sideways part counts as along
        most = smooth * np.array([asperities, asperities * float(found.lateral_ratio[k])])
        assert 1.0 < float(found.lateral_ratio[k]) < 1.0 / (1.0 - POISSON)

        def along(x, angle=angle, most=most):
            vector = np.array([x, angle]) / most
            share = np.hypot(*vector)
            turned = vector[0], vector[1] * (most[1] / most[0]) ** (share / (4.0 - 2.0 * share))
            return (1.0 - (1.0 - share) ** 2) * turned[0] / np.hypot(*turned)

        expected = brentq(lambda x, along=along: along(x) - 0.25, 0.0, 0.5 * most[0])
        assert expected / most[0] > 1.03 * (1.0 - math.sqrt(0.75))
        assert creepage[k] == pytest.approx(expected, rel=5e-3)


def test_centrifugal_force_and_pin(planar_joint):
    """m omega^2 r outwards at 1500 rpm over the ratio 6; the pin is the reciprocal of its stiffness."""
    joint = dataclasses.replace(planar_joint("planetary"), pin_stiffness=1e8)
    load = drive_load(joint_machine(joint).under(7.0))
    mass, omega = 7833.0 * math.pi * 20e-3**2 * LENGTH, 1500.0 * math.pi / 30.0 / 6.0
    np.testing.assert_allclose(load.body_force, [[0.0, mass * omega**2 * 30e-3]], rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(load.pin_compliance, [1e-8])
    assert float(load.output_torque) == 7.0
    rigid = drive_load(joint_machine(planar_joint("planetary")))
    np.testing.assert_array_equal(rigid.pin_compliance, [0.0])


THICK = {"ring_wall_thickness": 60e-3, "body_model": "springs"}


@pytest.mark.parametrize(
    ("body_model", "plane_state", "width"),
    [
        ("exact", "plane_strain", 1.0 - 0.3**2),
        ("exact", "plane_stress", 1.0),  # thin bodies give way sideways
        ("springs", "plane_stress", 1.0 - 0.3**2),  # springs are those of long cylinders
    ],
)
def test_logarithm_of_both_bodies(paper_joint, body_model, plane_state, width):
    """Each body of a strip adds (1 - nu^2)/(pi E B) ln(1/N) in plane strain, 1/(pi E B) ln(1/N) in plane stress."""
    found = logarithmic_decrease(
        contacts=joint_contacts(paper_joint()), body_model=body_model, plane_state=plane_state
    )
    np.testing.assert_allclose(found, 2.0 * width / (np.pi * 206e9 * 5e-3), rtol=1e-12)


def preload(joint):
    return float(solve_joint(joint).result.preload)


@pytest.mark.long
def test_a_thousand_newtons_by_length(paper_joint):
    """Bodies as springs, computed independently: 12.904 um."""
    assert preload(paper_joint(interference=12.904e-6, **THICK)) == pytest.approx(1000.0, abs=0.1)


@pytest.mark.long
@pytest.mark.parametrize(("body_model", "rel"), [("springs", 1e-9), ("exact", 2e-5)])
def test_force_and_length_are_two_names_of_one_joint(paper_joint, body_model, rel):
    found = solve_joint(paper_joint(interference=11e-6, body_model=body_model)).result
    same = solve_joint(paper_joint(preload=float(found.preload), body_model=body_model)).result
    assert float(found.interference) == pytest.approx(11e-6, rel=rel)
    assert float(same.interference) == pytest.approx(11e-6, rel=rel)


@pytest.mark.long
def test_sizes_are_deviations_in_a_study_of_tolerances_only(paper_values):
    """±5 um on every planet radius make 218 or 1854 N of the 1000 N; another drive keeps its interference."""
    values = paper_values(interference=12.904e-6, output_torque=1.0, **THICK)

    def with_planets(tables, size):
        return preload(joint_from_values(replace_values(tables, {"drive.planet_radius": size})))

    sizes = 13.5e-3 + np.array([-5e-6, 0.0, 5e-6])
    changed = [with_planets(with_nominal_sizes(values), size) for size in sizes]
    assert changed == pytest.approx([218.0, 1000.0, 1854.0], rel=5e-3)
    assert [with_planets(values, size) for size in sizes] == pytest.approx([1000.0] * 3, rel=1e-2)


def test_force_and_length_exclude_each_other(paper_values, joint_text):
    both = joint_text.replace('preload = "1000 N"', 'preload = "1000 N"\ninterference = "13 um"')
    for text, said in ((both, "got both"), (joint_text.replace('preload = "1000 N"', ""), "got neither")):
        with pytest.raises(InputError, match=said):
            parse_case(text, source="x")
    by_length = joint_text.replace('preload = "1000 N"', 'interference = "13 um"')
    tables = replace_values(si_values(parse_case(by_length, source="x")), {"load.preload": 500.0})
    assert "interference" not in tables["load"]
    assert joint_from_values(tables).preload == 500.0


@pytest.mark.long
def test_a_free_ring_takes_more_micrometres_and_minds_errors_less(paper_values):
    """At 10 mm of wall 1000 N take about twice the interference, and 5 um on the planets matter half as much."""
    spread = {}
    for support in ("rigid_housing", "free"):
        stated = paper_values(output_torque=1.0, ring_support=support)
        length = float(solve_joint(joint_from_values(stated)).result.interference)
        values = with_nominal_sizes(replace_values(stated, {"load.interference": length}))
        low, high = (
            preload(joint_from_values(replace_values(values, {"drive.planet_radius": size})))
            for size in (13.5e-3 - 5e-6, 13.5e-3 + 5e-6)
        )
        spread[support] = length, high - low
    assert spread["free"][0] / spread["rigid_housing"][0] == pytest.approx(1.9, abs=0.1)
    assert spread["free"][1] / spread["rigid_housing"][1] == pytest.approx(0.52, abs=0.05)

"""A joint by interference is the joint of the preload that it makes; sizes move the preload where they should."""

import dataclasses

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from asperity.joint_file.build import joint_from_values, with_nominal_sizes, with_values

from asperity.errors import InputError
from asperity.joint.interference import joint_preload, logarithmic_decrease
from asperity.joint.planar.description import planar_contacts
from asperity.joint.planar.solve import solve_planar
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values


@pytest.fixture(scope="module")
def by_length(joint_text):
    def of(length="12.904 um", bodies="springs", **changes):
        text = joint_text.replace('preload = "1000 N"', f'interference = "{length}"')
        text = text.replace('bodies = "exact"', f'bodies = "{bodies}"')
        for old, new in changes.items():
            text = text.replace(f"{old} =", f"{old} = {new} #")
        return parse_case(text, source="x")

    return of


def test_an_interference_without_a_preload_is_no_loose_joint(by_length):
    """100 mm would press the contacts wider than their rollers: no number, and no joint without interference."""
    joint = planar_joint_from_case(by_length("100 mm"))
    assert np.isnan(float(joint.preload))
    with pytest.raises(InputError, match="choose less interference"):
        solve_planar(joint)
    assert float(joint_preload(joint, 0.0)) == 0.0


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
        contacts=planar_contacts(paper_joint()), body_model=body_model, plane_state=plane_state
    )
    np.testing.assert_allclose(found, 2.0 * width / (np.pi * 206e9 * 5e-3), rtol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(("bodies", "rel"), [("springs", 1e-12), ("exact", 2e-5)])
def test_force_and_length_are_two_names_of_one_joint(by_length, evaluated_together, bodies, rel):
    joint = planar_joint_from_case(by_length("11 um", bodies))
    assert float(evaluated_together(joint).interference) == pytest.approx(11e-6, rel=rel)
    if bodies == "springs":
        thousand = planar_joint_from_case(by_length())
        assert float(thousand.preload) == pytest.approx(1000.0, abs=0.1)


@pytest.mark.slow
def test_a_spring_of_the_ring_takes_its_own_compression(by_length, evaluated_together):
    """25 N/um under each loading roller, which carries N_o at rest: N_o/k more than in a rigid ring."""
    rigid = dataclasses.replace(
        planar_joint_from_case(by_length()), output_torque=np.asarray(0.0), sun_speed=np.asarray(0.0)
    )

    def with_spring(stiffness):
        return eqx.tree_at(lambda joint: joint.structure.ring_bending_stiffness, rigid, np.asarray(stiffness))

    stiff, soft = (evaluated_together(with_spring(k)) for k in (np.inf, 25e6))
    normal = float(stiff.forces.normal[3])
    assert float(soft.interference - stiff.interference) == pytest.approx(normal / 25e6, rel=1e-9)


@pytest.mark.slow
def test_many_at_once_and_derivatives(by_length):
    case = by_length()
    lengths = np.array([5e-6, 10e-6, 20e-6])
    joint = with_values(case, {"load.interference": lengths})
    assert np.all(np.diff(np.asarray(joint.preload)) > 0.0)
    one = planar_joint_from_case(case)

    def preload(length):
        return joint_preload(one, length)

    slope = float(jax.grad(preload)(jnp.asarray(10e-6)))
    step = 1e-9
    assert slope == pytest.approx(
        float((preload(10e-6 + step) - preload(10e-6 - step)) / (2 * step)), rel=1e-6
    )


def test_sizes_are_deviations_in_a_study_of_tolerances_only(by_length):
    """±5 um on every planet radius make 218 or 1854 N of the 1000 N; another drive keeps its interference."""
    values = si_values(by_length())
    sizes = 13.5e-3 + np.array([-5e-6, 0.0, 5e-6])
    changed = joint_from_values(replace_values(with_nominal_sizes(values), {"drive.planet_radius": sizes}))
    assert np.asarray(changed.preload) == pytest.approx(np.array([218.0, 1000.0, 1854.0]), rel=5e-3)
    other = joint_from_values(replace_values(values, {"drive.planet_radius": sizes}))
    assert np.asarray(other.preload) == pytest.approx(np.full(3, 1000.0), rel=1e-2)


def test_force_and_length_exclude_each_other(by_length, joint_text):
    both = joint_text.replace('preload = "1000 N"', 'preload = "1000 N"\ninterference = "13 um"')
    for text, said in ((both, "got both"), (joint_text.replace('preload = "1000 N"', ""), "got neither")):
        with pytest.raises(InputError, match=said):
            parse_case(text, source="x")
    tables = replace_values(si_values(by_length()), {"load.preload": 500.0})
    assert "interference" not in tables["load"]
    assert joint_from_values(tables).preload == 500.0


@pytest.mark.slow
def test_a_free_ring_takes_more_micrometres_and_minds_errors_less(by_length, evaluated_together):
    """At 10 mm of wall 1000 N take about twice the interference, and 5 um on the planets matter half as much."""
    spread = {}
    for support in ("rigid_housing", "free"):
        case = by_length("12 um", "exact", ring_wall_thickness='"10 mm"', ring_support=f'"{support}"')
        joint = planar_joint_from_case(case)
        length = float(
            evaluated_together(dataclasses.replace(joint, preload=np.asarray(1000.0))).interference
        )
        values = with_nominal_sizes(replace_values(si_values(case), {"load.interference": length}))
        sizes = 13.5e-3 + np.array([-5e-6, 5e-6])
        low, high = np.asarray(
            joint_from_values(replace_values(values, {"drive.planet_radius": sizes})).preload
        )
        spread[support] = length, high - low
    assert spread["free"][0] / spread["rigid_housing"][0] == pytest.approx(1.9, abs=0.1)
    assert spread["free"][1] / spread["rigid_housing"][1] == pytest.approx(0.52, abs=0.05)

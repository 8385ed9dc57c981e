"""A joint by interference is the joint of the preload that it makes; sizes move the preload where they should."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.description import joint_contacts
from asperity.joint.interference import logarithmic_decrease
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_values, with_nominal_sizes
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values

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


@pytest.mark.slow
def test_a_thousand_newtons_by_length(paper_joint):
    """Bodies as springs, computed independently: 12.904 um."""
    assert preload(paper_joint(interference=12.904e-6, **THICK)) == pytest.approx(1000.0, abs=0.1)


@pytest.mark.slow
@pytest.mark.parametrize(("body_model", "rel"), [("springs", 1e-9), ("exact", 2e-5)])
def test_force_and_length_are_two_names_of_one_joint(paper_joint, body_model, rel):
    found = solve_joint(paper_joint(interference=11e-6, body_model=body_model)).result
    same = solve_joint(paper_joint(preload=float(found.preload), body_model=body_model)).result
    assert float(found.interference) == pytest.approx(11e-6, rel=rel)
    assert float(same.interference) == pytest.approx(11e-6, rel=rel)


@pytest.mark.slow
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


@pytest.mark.slow
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

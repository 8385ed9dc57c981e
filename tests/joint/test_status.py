"""Every reason for a failed point is the reason for which the joint alone is refused."""

import re
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import AsperityError
from asperity.joint.solve import solve_joint
from asperity.joint.status import STATUS_MEANINGS, STATUS_NAMES, flag_attributes
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.study.batch import evaluate_points

# changes of the paper's joint in SI units, the status they should have, and what the joint alone is refused for
FAILURES = [
    ({}, "solved", None),
    ({"drive.loading_roller_radius": 0.0041}, "no_place_for_rollers", "no place"),
    ({"drive.planet_radius": 0.0185}, "no_place_for_rollers", "planet and ring overlap"),
    ({"drive.planets": 7.0}, "no_place_for_rollers", "neighbours of planet"),
    (
        {"drive.loading_roller_radius": 0.0049, "drive.ring_radius": 0.0407},
        "no_place_for_rollers",
        "left_loading_roller",
    ),
    (
        {"drive.planets": 5.0, "drive.planet_radius": 0.0125, "drive.loading_roller_radius": 0.0059},
        None,
        "not ",
    ),
    ({"bearings.pin_diameter": 0.0101}, "pin_too_thick_or_locked", "pin diameter"),
    (
        {"bearings.pin_diameter": 0.004, "bearings.pin_friction_coefficient": 3.0},
        "pin_too_thick_or_locked",
        "lock",
    ),
    ({"load.output_torque": 20.0}, "beyond_standing_capacity", "beyond the standing torque capacity"),
    ({"load.preload": 1e8, "load.friction_coefficient": 0.3}, "unbalanced", "no balance"),
]
PLASTIC = {"surface.fractal_dimension": 1.2}


@pytest.fixture(scope="module")
def codes(case):
    names = ("published_stiffness_output", "wedge_angle", "slip_ratio")
    return evaluate_points(si_values(case), points_of(case, [changes for changes, _, _ in FAILURES]), names)


def points_of(case, all_changes):
    """The paper's joint with each of these changes; thin pins without friction where only others have them."""
    base = {"bearings.pin_diameter": 1e-3, "bearings.pin_friction_coefficient": 0.0}
    paths = sorted({path for changes in all_changes for path in changes})
    for path in paths:
        node = si_values(case)
        for step in path.split("."):
            node = node.get(step, {}) if isinstance(node, dict) else node
        base.setdefault(path, node)
    return {path: np.array([changes.get(path, base[path]) for changes in all_changes]) for path in paths}


@pytest.mark.slow
@pytest.mark.parametrize("index", range(len(FAILURES)))
def test_failed_points_are_those_that_the_joint_command_refuses(case, codes, index):
    changes, name, told = FAILURES[index]
    status, found = codes
    assert name is None or STATUS_NAMES[status[index]] == name
    assert (
        (told is None)
        == (status[index] == 0)
        == bool(np.isfinite(found["published_stiffness_output"][index]))
    )
    if told is not None and index in (1, 8):  # each solution compiles anew: two stand for all
        with pytest.raises(AsperityError, match=told):
            solve_joint(joint_from_values(replace_values(si_values(case), changes)))


@pytest.mark.slow
def test_what_has_a_meaning_is_kept(codes):
    status, found = codes
    slips = status == STATUS_NAMES.index("beyond_standing_capacity")
    assert np.all(found["slip_ratio"][:, slips].max(axis=0) >= 1.0)
    assert np.all(np.isfinite(found["wedge_angle"][slips]))
    no_place = status == STATUS_NAMES.index("no_place_for_rollers")
    np.testing.assert_array_equal(np.isnan(found["wedge_angle"]).ravel(), no_place)


@pytest.mark.long
def test_a_point_whose_spots_are_all_plastic_is_not_solved_and_keeps_its_forces(case):
    """docs/validity.md: at D = 1.2 the contact law says 0, boundary elements 13 to 780 N/um of a square millimetre."""
    names = (
        "assembly_stiffness_output",
        "asperity_tangential_stiffness",
        "asperity_normal_stiffness",
        "contact_torsional_stiffness",
        "asperity_over_bulk_stiffness",
        "normal_force",
        "standing_torque_capacity",
        "wedge_angle",
        "bulk_normal_stiffness",
    )
    status, found = evaluate_points(
        si_values(case), {path: np.array([1.4, value]) for path, value in PLASTIC.items()}, names
    )
    assert [STATUS_NAMES[code] for code in status] == ["solved", "all_spots_plastic"]
    assert np.isnan(found["assembly_stiffness_output"][1])
    for name in names[1:5]:
        assert np.isnan(found[name][:, 1]).all(), name
        assert np.isfinite(found[name][:, 0]).all(), name
    for name in names[5:]:  # the surface has no part in these
        np.testing.assert_allclose(found[name][..., 1], found[name][..., 0], rtol=1e-12)


def test_names_and_meanings_belong_together():
    assert len(STATUS_NAMES) == len(STATUS_MEANINGS)
    page = (Path(__file__).parents[2] / "docs" / "studies_sweep.md").read_text(encoding="utf-8")
    listed = page.split("| name | why there is no result |")[1].split("\n\n")[0]
    assert set(re.findall(r"`(\w+)`", listed)) == {*STATUS_NAMES[1:], "not_computed"}
    assert len(flag_attributes()["flag_meanings"].split()) == len(flag_attributes()["flag_values"])

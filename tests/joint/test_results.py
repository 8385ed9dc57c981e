"""Every number of a joint's result is a row of the one table, with unit, needs and, where it is judged, its words."""

import math

import equinox as eqx
import jax
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.evaluation import evaluate
from asperity.joint.results import GROUPS, RESULTS, chosen_results, known_result, name_at_level, row_name
from asperity.joint.results.table import RENAMED
from asperity.joint_file.build import joint_from_case

# parts of the result that are not results: the state beside its check, and the same number under another name
_NOT_OFFERED = {"forces.output_torque", "solved", "contact_law_holds", "walls_hold"}
# cycles of the ten tracks, of which the lives are made; lives in hours, which the table has in seconds
_NOT_OFFERED |= {"rolling.cycles", "rolling.cycles_per_turn", "rolling.duty_life_hours"}
# as many numbers as the file has loads
_NOT_OFFERED |= {"rolling.duty_damage_shares", "rolling.duty_load_hours"}
_NOT_OFFERED |= {f"rolling.life_hours.{part}" for part in ("contact", "body", "drive")}
# rows of the table too, nan where every spot is plastic (test_status.py)
_NOT_OFFERED |= {f"interfaces.asperity_{way}" for way in ("normal", "tangential")} | {
    "contact_torsional_stiffness"
}
_SAME = {
    "contacts.tangential_stiffness": "interfaces.asperity_tangential",
    "contacts.normal_stiffness": "interfaces.asperity_normal",
}


def test_every_leaf_of_the_result_is_offered(case):
    shapes = eqx.filter_eval_shape(evaluate, joint_from_case(case))
    leaves = {
        ".".join(str(key.name) for key in path) for path, _ in jax.tree_util.tree_leaves_with_path(shapes)
    }
    offered = {
        result.value.removeprefix("result.") for result in RESULTS.values() if isinstance(result.value, str)
    }
    assert {_SAME.get(leaf, leaf) for leaf in leaves} - _NOT_OFFERED - offered == set()


def test_groups_and_names_are_chosen_once():
    chosen = chosen_results(["published", "published_stiffness_sun", "slip_ratio"])
    assert chosen[:2] == ("published_stiffness_output", "published_stiffness_sun")
    assert chosen[-1] == "slip_ratio"
    assert len(set(chosen)) == len(chosen)
    assert set(GROUPS["all"]) == set(RESULTS) - set(GROUPS["stresses"])
    assert len(GROUPS["stiffness"]) == 6


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("published_stifness_sun", "did you mean 'published_stiffness_sun'"),
        ("xyzzy", "groups: all"),
        ("gross_slip", "it was renamed to 'slip_ratio'"),
        ("normal_over_rest", "it was renamed to 'normal_force_over_preload'"),
        ("slip_margin_sp", "it was renamed to 'slip_ratio_sp'"),
        ("ratio", "did you mean 'speed_ratio'"),
    ],
)
def test_unknown_results_are_refused(name, said):
    with pytest.raises(InputError, match=said):
        chosen_results([name])
    with pytest.raises(InputError, match=f"there is no result '{name}'"):
        known_result(name)


def test_former_names_lead_to_results():
    assert set(RENAMED.values()) <= set(RESULTS)
    assert not set(RENAMED) & set(RESULTS)


def test_nothing_is_refused():
    with pytest.raises(InputError, match="no results"):
        chosen_results([])


def test_units_measure_the_dimension():
    from asperity.units import from_si, parse_quantity

    for result in RESULTS.values():
        written = parse_quantity(f"1 {result.display_unit}", result.dimension)
        assert from_si(written, result.display_unit) == pytest.approx(1.0, rel=1e-12), result.name
        assert np.isfinite(from_si(1.0, result.si_unit))


def test_limits_say_what_they_mean_and_what_to_do():
    judged = [result for result in RESULTS.values() if result.limit is not None]
    assert len(judged) >= 11
    for result in judged:
        limit = result.limit
        assert limit.kept != limit.crossed
        assert limit.remedy
        assert math.isfinite(limit.lowest) or math.isfinite(limit.highest)
        assert not limit.is_kept(math.nan)


def test_both_sides_of_a_limit():
    slip, dimension = RESULTS["slip_ratio"].limit, RESULTS["fractal_dimension"].limit
    lifted = RESULTS["normal_force_over_preload"].limit
    assert [slip.is_kept(value) for value in (0.5, 1.0, math.inf)] == [True, False, False]
    assert [lifted.is_kept(value) for value in (0.5, 0.0)] == [True, False]
    assert [dimension.is_kept(value) for value in (1.01, 1.02, 1.5, 1.99, 1.995)] == [
        False,
        True,
        True,
        True,
        False,
    ]
    assert (slip.nearer_bound(9.0), lifted.nearer_bound(9.0)) == (1.0, 0.0)
    assert [dimension.nearer_bound(value) for value in (1.01, 1.995)] == [1.02, 1.99]


def test_names_of_rows_and_levels():
    assert row_name("slip_ratio", RESULTS["slip_ratio"].row_names[0]) == "slip_ratio_sp"
    assert row_name("mass", "") == "mass"
    assert name_at_level("stiffness", "published") == "published_stiffness_output"
    assert name_at_level("stiffness_per_mass", "assembly") == "assembly_stiffness_per_mass"
    assert name_at_level("hertz_pressure", "assembly") == "hertz_pressure"


def test_limits_of_ratios_are_those_of_their_meaning():
    """What is, over what is allowed, ends at 1; "at least ten times softer" is 0.1."""
    for name in (
        "slip_ratio",
        "self_locking_ratio",
        "pressure_over_first_yield",
        "critical_over_largest_spot",
        "real_area_over_hertz_area",
        "largest_spot_over_hertz_area",
    ):
        assert RESULTS[name].limit.highest == 1.0, name
    assert RESULTS["asperity_over_bulk_stiffness"].limit.highest == 0.1
    assert RESULTS["slip_ratio"].highest_limit == 1.0
    assert RESULTS["slip_safety"].lowest_limit == RESULTS["torque_safety"].lowest_limit == 1.0


def test_rows_that_a_joint_does_not_have_are_not_judged():
    """Bearings without ratings have no row; a joint without any computes nothing."""
    from types import SimpleNamespace

    safety = RESULTS["bearing_static_safety"]
    some = SimpleNamespace(
        has_bearings=(True, False, False, True),
        bearings=SimpleNamespace(static_safety=np.array([2.0, np.nan, np.nan, 0.5])),
    )
    assert safety.rows_of(some) == {"right_pin": 2.0, "carrier": 0.5}
    assert safety.rows_of(SimpleNamespace(has_bearings=(False,) * 4)) == {}
    assert RESULTS["mass"].rows_of(SimpleNamespace(size=SimpleNamespace(mass=3.0))) == {"": 3.0}


def test_a_joint_without_ratings_has_no_lives(case):
    from types import SimpleNamespace

    from asperity.joint.results import SolvedJoint

    solved = SolvedJoint(joint_from_case(case), SimpleNamespace(solved=np.array([True, True])))
    assert RESULTS["bearing_life"].of(solved).shape == (4, 2)
    assert np.all(np.isnan(np.asarray(RESULTS["bearing_static_safety"].of(solved))))

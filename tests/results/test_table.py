"""Every number of a joint's result is a row of the one table, with unit, needs and, where it is judged, its words."""

import jax
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.results import (
    GROUPS,
    RESULTS,
    chosen_results,
    display_unit,
    known_result,
    name_at_level,
    row_name,
)
from asperity.results.table import RENAMED

# parts of the result that are not results: the state beside its check, and the same number under another name
_NOT_OFFERED = {"forces.output_torque", "speeds", "solved", "contact_law_holds", "walls_hold"}
# cycles of the ten tracks, of which the lives are made; lives in hours, which the table has in seconds
_NOT_OFFERED |= {"rolling.cycles", "rolling.cycles_per_turn", "rolling.duty_life_hours"}
# as many numbers as the file has loads
_NOT_OFFERED |= {"rolling.duty_damage_shares", "rolling.duty_load_hours", "rolling.duty_shakedown_ratios"}
_NOT_OFFERED |= {"rolling.duty_slip_ratios", "rolling.duty_film_ratios"}
_NOT_OFFERED |= {"contacts.layer_stiffness"}  # by the layer ratio
_NOT_OFFERED |= {f"rolling.life_hours.{part}" for part in ("contact", "body", "drive")}
# rows of the table too, nan where every spot is plastic (test_status.py)
_NOT_OFFERED |= {f"interfaces.asperity_{way}" for way in ("normal", "tangential")} | {
    "contact_torsional_stiffness"
}
_SAME = {
    "contacts.tangential_stiffness": "interfaces.asperity_tangential",
    "contacts.normal_stiffness": "interfaces.asperity_normal",
}


def test_every_leaf_of_the_result_is_offered(solved_paper):
    _, solution = solved_paper
    leaves = {
        ".".join(str(key.name) for key in path)
        for path, _ in jax.tree_util.tree_leaves_with_path(solution.result)
    }
    offered = {
        result.value.removeprefix("result.") for result in RESULTS.values() if isinstance(result.value, str)
    }
    leaves = {leaf for leaf in leaves if not leaf.startswith("rest.")}  # the state without torque
    assert {_SAME.get(leaf, leaf) for leaf in leaves} - _NOT_OFFERED - offered == set()


def test_groups_and_names_are_chosen_once():
    chosen = chosen_results(["published", "published_stiffness_input", "slip_ratio"])
    assert chosen[:2] == ("published_stiffness_output", "published_stiffness_input")
    assert chosen[-1] == "slip_ratio"
    assert len(set(chosen)) == len(chosen)
    assert set(GROUPS["all"]) == set(RESULTS) - {
        name for group in ("stresses", "wear", "accuracy") for name in GROUPS[group]
    }
    assert not any(RESULTS[name].of_rims for name in GROUPS["all"])  # which need a program of their own
    assert len(GROUPS["stiffness"]) == 6


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("assembly_stiffness_sun", "'assembly_stiffness_input'"),
        ("published_stifness_input", "did you mean 'published_stiffness_input'"),
        ("xyzzy", "groups: all"),
        ("gross_slip", "it was renamed to 'slip_ratio'"),
        ("normal_over_rest", "it was renamed to 'normal_force_over_preload'"),
        ("slip_margin_sp", "it was renamed to 'slip_ratio'"),
        ("planet_mass", "it was renamed to 'body_mass'"),
        ("carrier_speed", "it was renamed to 'output_speed'"),
        ("rolling_carrier_speed", "it was renamed to 'rolling_output_speed'"),
        ("ratio", "did you mean 'speed_ratio'"),
    ],
)
def test_unknown_results_are_refused(name, said):
    with pytest.raises(InputError, match=said):
        chosen_results([name])
    with pytest.raises(InputError, match=f"there is no result '{name}'"):
        known_result(name)


def test_former_names_lead_to_results():
    for name in RENAMED.values():
        assert any(name == known or name.startswith(f"{known}_") for known in RESULTS), name
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


def test_names_of_rows_and_levels():
    assert row_name("slip_ratio", "sp") == "slip_ratio_sp"
    assert row_name("mass", "") == "mass"
    assert name_at_level("stiffness", "published") == "published_stiffness_output"
    assert name_at_level("stiffness_per_mass", "assembly") == "assembly_stiffness_per_mass"
    assert name_at_level("hertz_pressure", "assembly") == "hertz_pressure"


def test_rows_are_shown_in_the_unit_of_their_result():
    assert display_unit("drift") == "arcmin"
    assert display_unit("hertz_pressure_sp") == "MPa"
    assert display_unit("drive_life") == "h"
    assert display_unit("slip_ratio") == "1"

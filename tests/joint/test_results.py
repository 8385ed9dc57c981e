"""Every number of a joint's result is a named result with a unit."""

import equinox as eqx
import jax
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.evaluation import evaluate
from asperity.joint.results import GROUPS, RESULTS, chosen_results
from asperity.joint_file.build import joint_from_case

# parts of the result that are not results: the state beside its check, and the same number under another name
_NOT_OFFERED = {"forces.output_torque", "solved", "contact_law_holds"}
_SAME = {
    "contacts.tangential_stiffness": "interfaces.asperity_tangential",
    "contacts.normal_stiffness": "interfaces.asperity_normal",
}


def test_every_leaf_of_the_result_is_offered(case):
    shapes = eqx.filter_eval_shape(evaluate, joint_from_case(case))
    leaves = {
        ".".join(str(key.name) for key in path) for path, _ in jax.tree_util.tree_leaves_with_path(shapes)
    }
    offered = {result.path.removeprefix("result.") for result in RESULTS.values()}
    assert {_SAME.get(leaf, leaf) for leaf in leaves} - _NOT_OFFERED <= offered


def test_groups_and_names_are_chosen_once():
    chosen = chosen_results(["published", "published_stiffness_sun", "gross_slip"])
    assert chosen == ("published_stiffness_output", "published_stiffness_sun", "gross_slip")
    assert set(GROUPS["all"]) == set(RESULTS)
    assert len(GROUPS["stiffness"]) == 6


@pytest.mark.parametrize(
    ("name", "told"), [("published_stifness_sun", "did you mean"), ("xyzzy", "groups: all")]
)
def test_unknown_results_are_refused(name, told):
    with pytest.raises(InputError, match=told):
        chosen_results([name])


def test_nothing_is_refused():
    with pytest.raises(InputError, match="no results"):
        chosen_results([])


def test_units_are_known():
    from asperity.units import from_si

    for result in RESULTS.values():
        assert np.isfinite(from_si(1.0, result.unit))

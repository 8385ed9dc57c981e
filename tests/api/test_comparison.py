"""Two joints side by side: what differs, and nothing else."""

import dataclasses
import json

import pytest

import asperity
from asperity.api.comparison import MAIN_RESULTS, Difference
from asperity.errors import InputError
from asperity.results import RESULTS


@pytest.fixture(scope="module")
def comparison(zou_file):
    joint = asperity.load(zou_file)
    changed = joint.with_values({"load.preload": "1100 N"})
    return asperity.compare(joint, changed.edited("# a comment\n" + changed_text(changed)))


def changed_text(joint):
    from asperity.joint_file.edited_text import joint_file_text

    return joint_file_text(joint.case, {}, comment="")


def test_the_files_differ_in_what_was_changed(comparison):
    (line,) = comparison.inputs
    assert (line.name, line.one.si, line.other.si) == ("load.preload", 1000.0, 1100.0)
    assert line.change == pytest.approx(0.1)


def test_results_are_those_of_the_two_joints(comparison):
    differing = {line.name: line for line in comparison.results}
    one, other = comparison.one.solve(), comparison.other.solve()
    for solution, side in ((one, 2), (other, 3)):
        for name in ("assembly_stiffness_output", "standing_torque_capacity", "drift"):
            assert differing[name][side].si == pytest.approx(solution[name].si, rel=1e-12)
        assert differing["slip_ratio/sp"][side].si == pytest.approx(solution["slip_ratio_sp"].si, rel=1e-12)
    # the torque alone decides the force at the sun-planet contact, and the radii the ratio
    assert "tangential_force/sp" not in differing
    assert "speed_ratio" not in differing
    singles = sum(max(len(one[name].rows), 1) for name in one if not name.endswith("_residual"))
    assert len(comparison.results) + comparison.same == singles


def test_main_results_come_in_their_order_and_are_results():
    assert not set(MAIN_RESULTS) - set(RESULTS)


def test_tables_and_document_hold_the_differences(comparison):
    shown = repr(comparison)
    assert "load.preload" in shown
    assert "+10 %" in shown
    assert f"{comparison.same} results are the same" in shown
    document = json.loads(json.dumps(comparison.document(), allow_nan=False))
    assert document["inputs"][0] | {"change": None} == {
        "name": "load.preload", "label": "preload", "si_unit": "N", "one": 1000.0, "other": 1100.0, "change": None,
    }  # fmt: skip
    assert len(document["results"]) == len(comparison.results)


def test_a_bound_stands_beside_the_side_that_has_it(zou_file):
    """Beside the label where both joints have rigid pins, beside the number of one of them otherwise."""
    joint = asperity.load(zou_file)
    rigid = joint.solve()["assembly_stiffness_output"]
    assert rigid.bound == "upper bound: pins rigid"
    assert repr(rigid).startswith(f"{rigid.label} (upper bound: pins rigid): ")
    soft = dataclasses.replace(rigid, bound="")
    both, one, none = (
        Difference("assembly_stiffness_output", rigid.label, *sides)
        for sides in ((rigid, rigid), (rigid, soft), (soft, soft))
    )
    assert (both.said, one.said, none.said) == (
        f"{rigid.label} (upper bound: pins rigid)",
        rigid.label,
        rigid.label,
    )
    comparison = asperity.compare(joint, joint.with_values({"load.preload": "1100 N"}))
    shown = dataclasses.replace(comparison, results=(both, one)).blocks()[1].rows
    assert [[" (upper bound: pins rigid)" in cell for cell in row[:3]] for row in shown] == [
        [True, False, False],
        [False, True, False],
    ]
    listed = dataclasses.replace(comparison, results=(one,)).document()["results"][0]
    assert (listed["one_bound"], listed["other_bound"]) == ("upper bound: pins rigid", None)


def test_a_file_and_itself_are_the_same(zou_file):
    comparison = asperity.compare(zou_file, str(zou_file))
    assert (comparison.inputs, comparison.results) == ((), ())
    assert repr(comparison).startswith("The files say the same.")


def test_a_joint_that_cannot_exist_is_named(zou_file, tmp_path):
    file = tmp_path / "many.toml"
    file.write_text(zou_file.read_text().replace("planets = 3", "planets = 30"))
    with pytest.raises(InputError, match=r"many\.toml: the rollers do not fit"):
        asperity.compare(zou_file, file)


def test_what_one_joint_has_not_and_the_other_does_not_know_is_no_difference(zou_file):
    """Contacts with names of their own, whose oil films neither file fixes."""
    found = asperity.compare(zou_file.with_name("planetary.toml"), zou_file)
    assert any(line.label == "Hertz pressure, pr" and line.other is None for line in found.results)
    assert not any(line.label.startswith("film ratio") for line in found.results)

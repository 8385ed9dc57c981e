"""A joint file solved in a script says what the command says, whatever the type of its drive."""

import json
import math
from pathlib import Path

import pytest
from click.testing import CliRunner

from asperity.cli import asperity
from asperity.errors import InputError
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.solved_document import solve_case, solved_case
from asperity.results.margins import margins

EXAMPLES = Path(__file__).parents[2] / "examples"
UNEQUAL = '[[branch]]\nplanet_deviation = "2 um"\n\n[[branch]]\n\n[[branch]]\n\n'


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "branches"), [("zou2025", ""), ("planetary", ""), ("planetary", UNEQUAL)], ids=str
)
def test_the_document_is_that_of_the_command(name, branches, tmp_path):
    file = tmp_path / "joint.toml"
    file.write_text((EXAMPLES / f"{name}.toml").read_text().replace("[model]", f"{branches}[model]"))
    printed = CliRunner().invoke(asperity, ["joint", str(file), "--json"], catch_exceptions=False).stdout
    assert solve_case(read_case(file)).document == json.loads(printed)
    assert bool(branches) == ('"branches": {' in printed)


def harder(name, text, sizes, torque):
    """An example whose planets are larger than nominal, under a torque at its output."""
    stated = "".join(f'[[branch]]\nplanet_deviation = "{size} um"\n\n' for size in sizes)
    for old, new in (text, ("[model]", f"{stated}[model]")):
        name = name.replace(old, new, 1)
    before, rest = name.split('output_torque = "', 1)
    return parse_case(f'{before}output_torque = "{torque} N*m"{rest[rest.index(chr(34)) + 1 :]}', source="x")


@pytest.fixture(scope="module")
def planetary():
    text = (EXAMPLES / "planetary.toml").read_text().replace('bodies = "exact" ', 'bodies = "springs" ')
    text = text.replace('ring_support = "free" ', 'ring_support = "rigid_housing" ')
    return lambda sizes, torque, interference=4.4: harder(
        text, ('interference = "30 um"', f'interference = "{interference} um"'), sizes, torque
    )


@pytest.fixture(scope="module")
def papers():
    text = (EXAMPLES / "zou2025.toml").read_text()
    return lambda sizes, torque: harder(
        text, ('preload = "1000 N"', 'interference = "12.904 um"'), sizes, torque
    )


def judge(document, torque, equal):
    branches = document["branches"]
    assert branches["torque_capacity"]["equal_branches_Nm"] == pytest.approx(equal, rel=1e-3)
    assert torque > equal
    assert document["of_own_branches"]
    assert "those of these branches, contact by contact" in branches["note"]
    turning = dict(branches["turning"])
    assert turning.pop("unknown_because") == []
    losses, sums = turning.pop("losses_W"), document["rolling"]["losses_W"]
    assert losses == {cause: None if each is None else pytest.approx(each) for cause, each in sums.items()}
    assert turning == {key: pytest.approx(document["rolling"][key]) for key in turning}
    names = [f"{contact}_{k}" for k in (1, 2, 3) for contact in branches["standing"]["contacts"]]
    assert list(document["standing"]["contacts"]) == list(document["rolling"]["contacts"]) == names
    for state, at in (("standing", document["standing"]["forces"]["normal_N"]), ("rolling", None)):
        forces = (
            [document["rolling"]["contacts"][each]["normal_N"] for each in names]
            if at is None
            else at.values()
        )
        first = list(forces)[:: len(names) // 3]
        assert first == pytest.approx(branches[state]["preload_N"])
    assert sum(branches["standing"]["share"]) == pytest.approx(1.0)
    judged = {each["name"]: each for each in document["diagnostics"]}
    assert judged["branch_slip"]["ok"]
    json.dumps(document, allow_nan=False)


def same_sums(document, stronger):
    """Torque at the input, drift and losses of branches that are alike, by the chain of equal ones."""
    assert document["standing"]["forces"]["input_torque_Nm"] == pytest.approx(10.5 / 6.0, rel=1e-9)
    for key, value in document["branches"]["turning"].items():
        wanted = stronger["rolling"][key]
        for cause, each in wanted.items() if isinstance(wanted, dict) else [("", wanted)]:
            found = value[cause] if cause else value
            assert found == (None if each is None else pytest.approx(each, rel=1e-3)), (key, cause)
    assert stronger["rolling"]["losses_W"]["creep"] > 0.1
    torque = document["rolling"]["input_torque_Nm"]
    assert torque == pytest.approx(stronger["rolling"]["input_torque_Nm"], rel=1e-5)


@pytest.mark.slow
def test_branches_that_press_harder_carry_more_than_equal_ones(planetary):
    """Planets 0.3 um larger all round are an interference 0.6 um larger."""
    stronger = solve_case(planetary([], 10.5, 5.0))
    assert not bool(stronger.document.get("branches"))
    equal = solve_case(planetary([], 8.0))
    limit = float(equal.solved.solution.capacity.output_torque)
    solved, document = solve_case(planetary([0.3] * 3, 10.5))
    branches = solved.branches
    judge(document, 10.5, limit)
    assert branches.capacity.all_slip == pytest.approx(
        float(stronger.solved.solution.capacity.output_torque), rel=2e-4
    )
    assert branches.stiffness == pytest.approx(
        float(stronger.solved.solution.result.assembly.stiffness.output), rel=1e-3
    )
    same_sums(document, stronger.document)
    for name, wanted in stronger.document["rolling"]["contacts"].items():
        for k in (1, 2, 3):
            own = document["rolling"]["contacts"][f"{name}_{k}"]
            for key in ("creepage", "hertz_pressure_Pa", "traction_coefficient", "shakedown_ratio"):
                assert own[key] == pytest.approx(wanted[key], rel=2e-3), (name, k, key)
    assert document["life_hours"] == pytest.approx(stronger.document["life_hours"], rel=2e-3)
    lives = branches.rolling.limits["life_hours"]
    assert lives.min() == pytest.approx(
        float(stronger.solved.solution.result.rolling.life_hours.drive), rel=2e-3
    )
    required = {each.result.name: each for each in margins(solved)}
    assert required["torque_safety"].actual == pytest.approx(branches.capacity.all_slip / 10.5, rel=2e-4)
    assert not any(math.isnan(each.actual) for each in required.values())


@pytest.mark.slow
def test_unlike_branches_carry_the_sum_of_what_their_friction_holds(planetary):
    """At the sun each holds mu N; the ratio of 6 makes 6 r mu N of it at the output, a third for each planet."""
    branches = solved_case(planetary([0.1, 0.2, 0.5], 10.5)).branches
    by_hand = 6.0 * 10e-3 * 0.08 * branches.preload.sum()
    assert branches.capacity.all_slip == pytest.approx(
        by_hand, rel=5e-3
    )  # the torque takes 0.2 % of the forces
    with pytest.raises(
        InputError, match=r"16 N.m is beyond what the branches carry together, 1[12]\.\d+ N.m"
    ):
        solved_case(planetary([0.1, 0.2, 0.5], 16.0))


@pytest.mark.slow
def test_the_papers_drive_by_its_own_branches(papers):
    """13.16 N*m for 1000 N of preload, in proportion to it."""
    case = papers([0.2, 0.4, 0.5], 13.5)
    document = solve_case(case).document
    judge(document, 13.5, 13.38)
    preloads = sum(each["preload_N"] for each in document["branches"]["branches"])
    by_hand = 13.16 * preloads / 3000.0
    assert document["branches"]["torque_capacity"]["all_slip_Nm"] == pytest.approx(by_hand, rel=1e-3)
    for torque in (14.3, 40.0):
        with pytest.raises(InputError, match=r"beyond what the branches carry together, 14\.19 N.m"):
            solved_case(papers([0.2, 0.4, 0.5], torque))
    # equal ones would carry this one, weaker ones do not
    with pytest.raises(InputError, match="beyond what the branches carry together"):
        solved_case(papers([-0.2, -0.4, -0.5], 13.0))

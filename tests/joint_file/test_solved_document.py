"""A joint file solved in a script says what the command says, whatever the type of its drive."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity
from asperity.errors import InputError
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.solved_document import solve_case, solved_case

EXAMPLES = Path(__file__).parents[2] / "examples"
UNEQUAL = '[[branch]]\nplanet_deviation = "2 um"\n\n[[branch]]\n\n[[branch]]\n\n'


@pytest.mark.long
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


def judge(document):
    """Every branch by itself, and what the section on branches says of them."""
    branches = document["branches"]
    assert document["of_own_branches"]
    contacts = document["standing"]["contacts"]
    assert list(contacts) == list(document["rolling"]["contacts"])
    assert {name[-2:] for name in contacts} == {"_1", "_2", "_3"}
    rest = list(document["standing"]["forces"]["normal_without_torque_N"].values())
    assert rest[:: len(rest) // 3] == pytest.approx([each["preload_N"] for each in branches["branches"]])
    for state in ("standing", "rolling"):
        assert sum(branches[state]["share"]) == pytest.approx(1.0)
    capacity = document["standing_torque_capacity"]
    assert branches["standing_torque_capacity"]["all_slip_Nm"] == capacity["output_torque_Nm"]
    assert branches["standing_torque_capacity"]["first_slip_Nm"] == capacity["first_slip"]["output_torque_Nm"]
    json.dumps(document, allow_nan=False)


@pytest.mark.long
def test_branches_that_press_harder_are_a_larger_interference(planetary):
    """Planets 0.3 um larger all round are an interference 0.6 um larger; equal ones do not carry the torque."""
    stronger = solve_case(planetary([], 10.5, 5.0)).document
    assert not bool(stronger.get("branches"))
    with pytest.raises(InputError, match="beyond the standing torque capacity"):
        solve_case(planetary([], 10.5))
    document = solve_case(planetary([0.3] * 3, 10.5)).document
    judge(document)
    # to 1e-3, because the laws of contacts are taken around the force of the nominal interference
    assert document["standing_torque_capacity"]["output_torque_Nm"] == pytest.approx(
        stronger["standing_torque_capacity"]["output_torque_Nm"], rel=2e-4
    )
    for found, wanted in (
        (each["torsional_stiffness"]["assembly"]["output_Nm_per_rad"] for each in (document, stronger)),
        (each["drift_rad_per_output_turn"] for each in (document, stronger)),
        (each["losses_W"]["creep"] for each in (document, stronger)),
        (each["rolling"]["input_torque_Nm"] for each in (document, stronger)),
        (each["efficiency"] for each in (document, stronger)),
    ):
        assert found == pytest.approx(wanted, rel=1e-3)
    assert stronger["losses_W"]["creep"] > 0.1
    assert document["standing"]["forces"]["input_torque_Nm"] == pytest.approx(10.5 / 6.0, rel=1e-9)
    for name, wanted in stronger["rolling"]["contacts"].items():
        for k in (1, 2, 3):
            own = document["rolling"]["contacts"][f"{name}_{k}"]
            for key in ("creepage", "hertz_pressure_Pa", "traction_coefficient", "shakedown_ratio"):
                assert own[key] == pytest.approx(wanted[key], rel=2e-3), (name, k, key)
    assert document["life_hours"] == pytest.approx(stronger["life_hours"], rel=2e-3)


@pytest.mark.long
def test_unlike_branches_carry_the_sum_of_what_their_friction_holds(planetary):
    """At the sun each holds mu N; the ratio of 6 makes 6 r mu N of it at the output, a third for each planet."""
    document = solve_case(planetary([0.1, 0.2, 0.5], 10.5)).document
    judge(document)
    by_hand = 6.0 * 10e-3 * 0.08 * sum(each["preload_N"] for each in document["branches"]["branches"])
    # the torque takes 0.2 % of the forces
    assert document["standing_torque_capacity"]["output_torque_Nm"] == pytest.approx(by_hand, rel=5e-3)
    with pytest.raises(InputError, match=r"16 N.m is beyond the standing torque capacity 1[12]\.\d+ N.m"):
        solved_case(planetary([0.1, 0.2, 0.5], 16.0))


@pytest.mark.long
def test_the_papers_drive_by_its_own_branches(papers):
    """13.16 N*m for 1000 N of preload, in proportion to it."""
    document = solve_case(papers([0.2, 0.4, 0.5], 13.5)).document
    judge(document)
    preloads = sum(each["preload_N"] for each in document["branches"]["branches"])
    by_hand = 13.16 * preloads / 3000.0
    assert document["branches"]["standing_torque_capacity"]["all_slip_Nm"] == pytest.approx(by_hand, rel=1e-3)
    for torque in (14.3, 40.0):
        with pytest.raises(InputError, match=r"beyond the standing torque capacity 14\.19 N.m"):
            solved_case(papers([0.2, 0.4, 0.5], torque))
    # equal ones would carry this one, weaker ones do not
    with pytest.raises(InputError, match="beyond the standing torque capacity"):
        solved_case(papers([-0.2, -0.4, -0.5], 13.0))

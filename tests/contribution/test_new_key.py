"""A contributor adds a key: a field of its section and the formula that uses it; everything else knows it."""

import json
import tomllib
from pathlib import Path

import pytest
from package_copy import changed_files, package_copy, run, run_python

EXAMPLE = Path(__file__).parents[2] / "examples" / "planetary.toml"
SECTION, FORMULA = "joint_file/model.py", "drive/bearings.py"
#: File → what stands there, and what takes its place.
CHANGES = {
    SECTION: {
        "from asperity.joint_file.quantity_key import Quantity\n": (
            "from asperity.joint_file.quantity_key import Key, Quantity\n"
            "from asperity.unit_table import Dimension\n"
        ),
        """    \"\"\"Friction of the bearings, and the pins of the carrier; an absent key is no friction.\"\"\"
""": """    \"\"\"Friction of the bearings, and the pins of the carrier; an absent key is no friction.\"\"\"

    churning_torque: Annotated[Quantity, Key(Dimension.TORQUE, 0.0, 10.0, "N*m", example="0.001 N*m")] | None = None
    \"\"\"Torque by which the oil brakes each side of a roller on a pin, churned by it; none if absent.\"\"\"
""",
    },
    FORMULA: {
        "    pin_friction_diameter: Real\n": "    pin_friction_diameter: Real\n    churning_torque: Real = 0.0\n",
        "bearings.roller_torque + pin": "bearings.roller_torque + bearings.churning_torque + pin",
    },
}
#: The page's field of the key, and the result of a joint with the key changed on the page.
PYTHON = """
import json, sys
from asperity.page.answer import joint_answer
from asperity.page.description import form_of
from asperity.page.joint_request import JointRequest
text = open(sys.argv[1], encoding="utf-8").read()
request = JointRequest("p.toml", text, {"bearings.churning_torque": "0.002 N*m"})
fields = {
    entry["key"]: entry for group in form_of(request.case())["groups"] for entry in group["parameters"]
}
print(json.dumps({
    "field": fields["bearings.churning_torque"],
    "torque": joint_answer(request)["document"]["rolling"]["input_torque_Nm"],
    "text": request.file_text(),
}))
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A copy of the package with the key."""
    folder = package_copy(tmp_path_factory.mktemp("new_key"))
    for name, changes in CHANGES.items():
        file = folder / "asperity" / name
        text = file.read_text(encoding="utf-8")
        for old, new in changes.items():
            assert text.count(old) == 1
            text = text.replace(old, new)
        file.write_text(text, encoding="utf-8")
    return folder


@pytest.fixture
def solve(folder, tmp_path):
    """The document of the example with the keys of [bearings] that are given."""

    def solve(*keys):
        file = tmp_path / "joint.toml"
        stated = "\n[bearings]\n" + "\n".join(keys)
        file.write_text(EXAMPLE.read_text(encoding="utf-8") + stated, encoding="utf-8")
        return run(folder, "joint", str(file), "--json")

    return solve


def printed(outcome):
    """The output of a command that has succeeded."""
    assert outcome.returncode == 0, outcome.stderr
    return outcome.stdout


def test_two_files_are_touched(folder):
    assert changed_files(folder) == {SECTION, FORMULA}


def test_the_formula_has_the_number_in_its_unit(solve):
    """It acts as the constant friction of the same bearings: on both sides of three planets, which turn on their pins
    with 1/4 + 1/6 of the speed of the sun.
    """
    churned = json.loads(printed(solve('churning_torque = "2 N*mm"')))
    rubbed = json.loads(printed(solve('roller_torque = "0.002 N*m"')))
    free = json.loads(printed(solve('roller_torque = "0 N*m"')))
    for section in ("rolling", "torsional_stiffness", "diagnostics"):
        assert churned[section] == rubbed[section]
    more = churned["rolling"]["input_torque_Nm"] - free["rolling"]["input_torque_Nm"]
    assert more == pytest.approx(3 * 2 * 0.002 * (1 / 4 + 1 / 6), rel=1e-3)


def test_a_wrong_value_is_refused_with_the_range(solve):
    assert "bearings.churning_torque: " in solve('churning_torque = "2 mm"').stderr
    refused = solve('churning_torque = "20 N*m"')
    assert refused.returncode == 2
    assert "20 N·m is not allowed; it must be at least 0 N·m and at most 10 N·m" in refused.stderr


def test_schema_and_page_say_what_it_is(folder, tmp_path):
    schema = printed(run(folder, "schema", "--type", "planetary"))
    assert "Torque by which the oil brakes each side of a roller" in schema
    found = json.loads(printed(run_python(folder, PYTHON, str(EXAMPLE))))
    field = found["field"]
    assert (field["unit"], field["lowest"], field["highest"]) == ("N*m", 0.0, 10.0)
    assert field["meaning"].startswith("Torque by which the oil brakes")
    assert tomllib.loads(found["text"])["bearings"] == {"churning_torque": "0.002 N*m"}


@pytest.mark.slow
def test_studies_vary_it(folder, tmp_path):
    """By its path, as every other number of a joint file."""
    file = tmp_path / "joint.toml"
    text = EXAMPLE.read_text(encoding="utf-8") + '\n[bearings]\nchurning_torque = "1 N*mm"\n'
    file.write_text(text, encoding="utf-8")
    out = tmp_path / "sweep.csv"
    axis = "bearings.churning_torque=0 N*m:2 N*mm:3"
    wanted = ("--results", "bearing_loss", "--out", str(out))
    printed(run(folder, "sweep", str(file), "--over", axis, *wanted))
    lines = [line for line in out.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    column = next(
        number for number, head in enumerate(lines[0].split(",")) if head.startswith("bearing_loss")
    )
    none, one, two = (float(line.split(",")[column]) for line in lines[1:])
    assert none == 0.0
    assert two == pytest.approx(2.0 * one, rel=1e-3)

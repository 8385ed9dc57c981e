"""A contributor adds a result: one row in one file, and everything shows it."""

import csv
import json
import math
from pathlib import Path

import pytest
from package_copy import changed_files, package_copy, run, run_python

EXAMPLE = Path(__file__).parents[2] / "examples" / "planetary.toml"
FILE = "results/contact_rows.py"
ROW = """ROWS = (
    _contact(
        "mean_hertz_pressure",
        "mean Hertz pressure",
        Dimension.PRESSURE,
        "MPa",
        lambda solved: 0.25 * np.pi * solved.result.diagnostics.hertz_pressure,
        column=Column("forces", "mean pressure"),
    ),
"""
PYTHON = """
import json, sys
import asperity
from asperity.page.answer import joint_answer
from asperity.page.chart import chart_results
from asperity.page.joint_request import JointRequest
solution = asperity.load(sys.argv[1]).solve()
found = solution["mean_hertz_pressure"]
request = JointRequest("p.toml", open(sys.argv[1], encoding="utf-8").read())
print(json.dumps({
    "unit": found.unit,
    "si": [float(value) for value in found.si],
    "one": float(solution["mean_hertz_pressure_sp"].si),
    "notebook": "mean pressure" in solution._repr_html_(),
    "page": joint_answer(request),
    "charts": [entry["name"] for entry in chart_results(request)],
}))
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A copy of the package with the row."""
    folder = package_copy(tmp_path_factory.mktemp("new_result"))
    file = folder / "asperity" / FILE
    text = file.read_text(encoding="utf-8")
    assert text.count("ROWS = (\n") == 1
    file.write_text(text.replace("ROWS = (\n", ROW), encoding="utf-8")
    return folder


def printed(outcome):
    """The output of a command that has succeeded."""
    assert outcome.returncode == 0, outcome.stderr
    return outcome.stdout


@pytest.fixture(scope="module")
def document(folder):
    return json.loads(printed(run(folder, "joint", str(EXAMPLE), "--json")))


@pytest.fixture(scope="module")
def in_python(folder):
    return json.loads(printed(run_python(folder, PYTHON, str(EXAMPLE))))


def test_one_file_is_touched(folder):
    assert changed_files(folder) == {FILE}


def test_the_document_has_it_beside_the_other_results_of_the_contacts(document):
    """The mean pressure is the force over width and length, 10 mm of every contact."""
    for name, contact in document["standing"]["contacts"].items():
        force = document["standing"]["forces"]["normal_N"][name]
        mean = force / (2.0 * contact["hertz_half_width_m"] * 10e-3)
        assert contact["mean_hertz_pressure_Pa"] == pytest.approx(mean, rel=1e-9)


def test_a_script_asks_for_it_by_its_name(in_python, document):
    contacts = document["standing"]["contacts"].values()
    assert in_python["unit"] == "MPa"
    assert in_python["si"] == pytest.approx([contact["mean_hertz_pressure_Pa"] for contact in contacts])
    assert in_python["one"] == in_python["si"][0]


# every place in which a person sees the results of contacts: views of one content
def test_it_is_shown_in_the_terminal(folder, document):
    table = printed(run(folder, "joint", str(EXAMPLE))).split("Contact forces at standstill")[1]
    for name, contact in document["standing"]["contacts"].items():
        shown = f"{1e-6 * contact['mean_hertz_pressure_Pa']:.4g}"
        line = next(line for line in table.splitlines() if line.startswith(f"{name} "))
        assert shown in line.split()


def test_it_is_shown_in_a_notebook(in_python):
    assert in_python["notebook"]


def test_it_is_shown_on_the_page_and_can_be_drawn_there(in_python):
    assert "mean_hertz_pressure_sp" in in_python["charts"]
    assert "mean pressure" in json.dumps(in_python["page"]["views"]["contacts"])


@pytest.mark.slow
def test_it_is_shown_in_a_report(folder, tmp_path):
    file = tmp_path / "report.html"
    printed(run(folder, "report", str(EXAMPLE), "--out", str(file)))
    assert "mean pressure" in file.read_text(encoding="utf-8")


def test_a_comparison_names_it(folder, tmp_path):
    other = tmp_path / "other.toml"
    other.write_text(EXAMPLE.read_text(encoding="utf-8").replace('"30 um"', '"28 um"'), encoding="utf-8")
    found = printed(run(folder, "compare", str(EXAMPLE), str(other), "--json"))
    assert "mean_hertz_pressure" in found


@pytest.mark.slow
def test_a_sweep_computes_it(folder, tmp_path, document):
    out = tmp_path / "sweep.csv"
    axis = "load.output_torque=10 N*m:11 N*m:2"
    wanted = ("--results", "mean_hertz_pressure", "--out", str(out))
    printed(run(folder, "sweep", str(EXAMPLE), "--over", axis, *wanted))
    lines = [line for line in out.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = list(csv.reader(lines))
    (column,) = [index for index, head in enumerate(rows[0]) if head.startswith("mean_hertz_pressure_sp")]
    expected = document["standing"]["contacts"]["sp"]["mean_hertz_pressure_Pa"]
    assert math.isclose(float(rows[1][column]), expected, rel_tol=1e-9)

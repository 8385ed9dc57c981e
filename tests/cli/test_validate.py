"""``asperity validate``: the evidence, its files and its exit code."""

import json

import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity
from asperity.errors import InputError
from asperity.validation import contact_checks, run


@pytest.fixture(autouse=True)
def few_groups(monkeypatch):
    monkeypatch.setattr(run, "GROUPS", {"Hertz": contact_checks.hertz})


def test_the_table_and_the_exit_code():
    found = CliRunner().invoke(asperity, ["validate"])
    assert found.exit_code == 0
    assert "found 1039.6415, expected 1039.64 MPa" in found.output
    assert "2 of 2 checks passed" in found.output


def test_json_and_both_files(tmp_path):
    page, data = tmp_path / "validation.html", tmp_path / "validation.json"
    found = CliRunner().invoke(asperity, ["validate", "--json", "--out", str(page)])
    assert json.loads(found.stdout)["passed"] == 2
    assert "All 2 checks passed." in page.read_text(encoding="utf-8")
    assert CliRunner().invoke(asperity, ["validate", "--out", str(data)]).exit_code == 0
    assert json.loads(data.read_text(encoding="utf-8"))["valid"] is True


def test_a_pdf_is_written(tmp_path):
    pytest.importorskip("typst", reason="the extra 'report' is not installed")
    out = tmp_path / "validation.pdf"
    assert CliRunner().invoke(asperity, ["validate", "--out", str(out)]).exit_code == 0
    assert out.read_bytes().startswith(b"%PDF-")


def test_any_failure_is_exit_code_1(monkeypatch):
    monkeypatch.setattr(contact_checks.hertz_line, "peak_pressure", lambda **given: 1e9)
    found = CliRunner().invoke(asperity, ["validate"])
    assert found.exit_code == 1
    assert "FAIL" in found.output
    assert "1 of 2 checks passed" in found.output


def test_other_endings_are_refused(tmp_path):
    found = CliRunner().invoke(asperity, ["validate", "--out", str(tmp_path / "validation.txt")])
    assert isinstance(found.exception, InputError)
    assert "must end in .pdf, .html or .json" in str(found.exception)

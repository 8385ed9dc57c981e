"""``asperity report``: files and refusals."""

import pytest


def test_html_is_written(call, joint_file, tmp_path):
    outcome = call("report", joint_file(), "--out", tmp_path / "r.html", "--date", "1 <March>")
    assert (outcome.code, outcome.out) == (0, "")
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert "<td class=w>1 &lt;March&gt;</td>" in text
    assert str(tmp_path) not in text  # a report says nothing about the machine's folders


def test_pdf_is_written(call, joint_file, tmp_path):
    pytest.importorskip("typst", reason="the extra 'report' is not installed")
    assert call("report", joint_file(), "--out", tmp_path / "r.pdf").code == 0
    assert (tmp_path / "r.pdf").read_bytes().startswith(b"%PDF-")


@pytest.mark.parametrize(
    ("change", "arguments", "said"),
    [
        (("5 N*m", "5 N*m"), ("--out", "r.docx"), "must end in .html or .pdf"),
        (("5 N*m", "5 N*m"), ("--out", "r.html", "--date", "x" * 41), "at most 40 characters"),
        (("5 N*m", "50 N*m"), ("--out", "r.html"), "beyond the torque capacity"),
    ],
)
def test_refusals_write_nothing(call, joint_file, tmp_path, monkeypatch, change, arguments, said):
    monkeypatch.chdir(tmp_path)
    outcome = call("report", joint_file(change), *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert said in outcome.err
    assert not list(tmp_path.glob("r.*"))

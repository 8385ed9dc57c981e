"""Drawings and reports from a script: the files of the commands."""

import pytest

import asperity
from asperity.errors import InputError


@pytest.mark.slow
@pytest.mark.parametrize("stated", [{}, {"project": "wrist", "revision": "B"}])
def test_a_drawing_is_that_of_the_command(joint, call, zou_file, tmp_path, stated):
    by_call, by_command = tmp_path / "a.svg", tmp_path / "b.svg"
    assert asperity.draw(joint, by_call, title=stated) == [by_call]
    options = [text for name, value in stated.items() for text in (f"--{name}", value)]
    assert call("draw", zou_file, "--out", by_command, *options).code == 0
    assert by_call.read_text() == by_command.read_text()


@pytest.mark.slow
def test_parts_are_files_beside_it(joint, tmp_path):
    files = asperity.draw(joint, tmp_path / "drive.svg", parts=True)
    assert sorted(file.name for file in files) == sorted(file.name for file in tmp_path.iterdir())
    assert len(files) > 3


@pytest.mark.long
def test_a_report_is_that_of_the_command(joint, call, zou_file, tmp_path):
    by_call, by_command = tmp_path / "a.html", tmp_path / "b.html"
    assert asperity.write_report(joint, by_call, title={"part": "7"}) == by_call
    assert call("report", zou_file, "--out", by_command, "--part", "7").code == 0
    assert by_call.read_text() == by_command.read_text()


@pytest.mark.parametrize(
    ("write", "name", "options", "message"),
    [
        (asperity.draw, "a.doc", {}, "must end in .svg, .pdf, .png or .dxf"),
        (asperity.draw, "a.svg", {"title": {"author": "x"}}, "a title block has no 'author'"),
        (asperity.draw, "a.svg", {"title": {"part": "x" * 61}}, "part: at most 60 characters, got 61"),
        (asperity.draw, "no/a.svg", {}, "no"),
        (asperity.write_report, "a.txt", {}, "must end in .html or .pdf"),
        (asperity.write_report, "a.html", {"distribution": "uniform"}, "belongs to tolerances=True"),
    ],
)
def test_refusals(joint, tmp_path, write, name, options, message):
    with pytest.raises(InputError, match=message):
        write(joint, tmp_path / name, **options)
    assert not list(tmp_path.iterdir())

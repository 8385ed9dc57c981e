"""Names of files are checked before anything is computed; what cannot be written is said."""

import pytest
from matplotlib.figure import Figure

from asperity.cli.study_figures import check_folder, check_image_name, write_figure, write_text
from asperity.errors import InputError


def test_names_that_will_do(tmp_path):
    check_image_name(None)
    check_folder(None)
    for name in ("a.png", "a.SVG", "a.pdf"):
        check_image_name(str(tmp_path / name))


def test_names_that_will_not(tmp_path):
    with pytest.raises(InputError, match=r"a\.jpg: an image ends in \.png, \.svg or \.pdf"):
        check_image_name("a.jpg")
    for check in (check_image_name, check_folder):
        with pytest.raises(InputError, match="there is no folder"):
            check(str(tmp_path / "nowhere" / "a.png"))


def test_files_are_written_and_named(tmp_path, capsys):
    write_figure(Figure(figsize=(1.0, 1.0)), str(tmp_path / "a.svg"))
    write_text("µ = 0.12\n", str(tmp_path / "a.toml"))
    assert (tmp_path / "a.svg").read_text().startswith("<?xml")
    assert (tmp_path / "a.toml").read_text(encoding="utf-8") == "µ = 0.12\n"
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err == f"wrote {tmp_path / 'a.svg'}\nwrote {tmp_path / 'a.toml'}\n"


def test_what_cannot_be_written(tmp_path):
    with pytest.raises(InputError, match="cannot be written: "):
        write_figure(Figure(), str(tmp_path / "nowhere" / "a.png"))
    with pytest.raises(InputError, match="cannot be written: "):
        write_text("", str(tmp_path))

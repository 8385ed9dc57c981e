"""What this package has made is told from everything else, by the files that the package itself writes."""

import io
import json
import zipfile
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from asperity import made_files
from asperity.errors import InputError
from asperity.made_files import (
    CALIBRATED_BY,
    DESIGNED_BY,
    DOCUMENT,
    DRAWING,
    EXPORTS,
    IMAGE,
    MADE_JOINT,
    REPORT,
    refuse_existing,
    table_with,
)
from asperity.report.content import Paragraph, Report
from asperity.report.html import report_html
from asperity.writing import write_image, write_pages, write_text

REPORTED = Report("A joint", [Paragraph("It holds.")])
FOREIGN = {
    "text": b"My notes about asperity, written by me.\n",
    "joint file": b"[drive]\nplanets = 3\n# Designed by asperity from a.toml: after the first entry\n[load]\n",
    "table": b"torque [N*m],angle [mrad]\n0,0\n1,1\n",
    "numbers": np.arange(1000.0).tobytes(),
    "document": b'{"asperity_version": "0.1.0", "torsional_stiffness": {}}',
    "page": b"<!DOCTYPE html><title>asperity</title>",
    "image": b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR and Software\0Matplotlib",
}
KINDS = {
    "image": IMAGE,
    "report": REPORT,
    "drawing": DRAWING,
    "document": DOCUMENT,
    "joint": MADE_JOINT,
    "table": table_with("a table", "torque_Nm", "angle_rad"),
    **EXPORTS,
}


@pytest.mark.parametrize("content", FOREIGN.values(), ids=FOREIGN)
@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
def test_what_others_have_made_is_not_replaced(tmp_path, kind, content):
    file = tmp_path / "file"
    file.write_bytes(content)
    with pytest.raises(
        InputError, match=f"{file}: this exists and is not {kind.what} that asperity has made; give"
    ):
        kind.refuse_other(file)
    (tmp_path / "link").symlink_to(file)
    with pytest.raises(
        InputError, match=f"link: this is a link to {file}, which is not {kind.what} that asperity has"
    ):
        kind.refuse_other(tmp_path / "link")
    assert file.read_bytes() == content


@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
def test_where_nothing_is_nothing_is_refused(tmp_path, kind):
    (tmp_path / "empty").touch()
    (tmp_path / "dangling").symlink_to(tmp_path / "absent")
    for name in ("absent", "empty", "dangling"):
        kind.refuse_other(tmp_path / name)
    assert not kind.is_made(tmp_path / "absent")


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf", ".PDF"])
def test_images_are_known_again(tmp_path, suffix):
    figure = Figure(figsize=(1.0, 1.0))
    figure.text(0.1, 0.5, "text")
    for _ in range(2):  # the second one replaces the first
        write_image(figure, tmp_path / f"a{suffix}")
    assert IMAGE.is_made(tmp_path / f"a{suffix}")
    assert not REPORT.is_made(tmp_path / f"a{suffix}")
    figure.savefig(tmp_path / f"b{suffix}")  # by somebody else
    with pytest.raises(InputError, match="not an image that asperity has made"):
        write_image(figure, tmp_path / f"b{suffix}")


def test_pages_are_known_again(tmp_path):
    for _ in range(2):
        write_pages([Figure(figsize=(1.0, 1.0))] * 3, tmp_path / "a.pdf")
    assert IMAGE.is_made(tmp_path / "a.pdf")


def test_reports_are_known_again(tmp_path):
    pytest.importorskip("typst")
    from asperity.report.pdf import report_pdf

    (tmp_path / "a.pdf").write_bytes(report_pdf(REPORTED))
    (tmp_path / "a.html").write_text(report_html(REPORTED), encoding="utf-8")
    for name in ("a.pdf", "a.html"):
        assert REPORT.is_made(tmp_path / name)
        assert not IMAGE.is_made(tmp_path / name)


def test_drawings_for_cad_are_known_again(tmp_path):
    pytest.importorskip("ezdxf")
    from asperity.show.sheet import Sheet
    from asperity.show.sheet_dxf import sheet_dxf

    (tmp_path / "a.dxf").write_text(sheet_dxf(Sheet(420.0, 297.0, 1.0, (0.0, 0.0), ())), encoding="utf-8")
    assert DRAWING.is_made(tmp_path / "a.dxf")


@pytest.mark.parametrize("first", ["", "#:schema ./joint.schema.json\n", "# a comment\n\n"])
@pytest.mark.parametrize("by", [DESIGNED_BY, CALIBRATED_BY])
def test_joint_files_of_a_design_or_a_calibration_are_known_again(tmp_path, first, by):
    (tmp_path / "a.toml").write_text(f'{first}# {by} from b.toml: smallest mass.\n[load]\npreload = "1 N"\n')
    assert MADE_JOINT.is_made(tmp_path / "a.toml")


def test_documents_of_checks_are_known_again(tmp_path):
    (tmp_path / "a.json").write_text(json.dumps({"asperity_version": "0.1.0", "checks": []}))
    assert DOCUMENT.is_made(tmp_path / "a.json")


def test_tables_are_known_by_their_columns(tmp_path):
    kind = table_with("a table", "torque", "angle")
    for head in ("torque [N*m],angle [arcmin]", "angle,torque,more", '"torque [N*m]","angle [mrad]"\r'):
        (tmp_path / "a.csv").write_text(f"{head}\n0,0\n")
        assert kind.is_made(tmp_path / "a.csv")
    for head in ("torque [N*m],angles [arcmin]", "torque", ";torque;angle"):
        (tmp_path / "a.csv").write_text(f"{head}\n0,0\n")
        assert not kind.is_made(tmp_path / "a.csv")


def test_a_foreign_archive_is_no_exported_joint(tmp_path):
    for content, made in (('generationTool="asperity 0.1.0"', True), ('generationTool="another"', False)):
        target = io.BytesIO()
        with zipfile.ZipFile(target, "w") as archive:
            archive.writestr("modelDescription.xml", content)
        (tmp_path / "a.fmu").write_bytes(target.getvalue())
        assert EXPORTS[".fmu"].is_made(tmp_path / "a.fmu") is made


def test_heights_do_not_say_what_has_made_them(tmp_path):
    np.save(tmp_path / "a.npy", np.zeros(3))
    with pytest.raises(
        InputError, match=r"a\.npy: this exists already, and such a file does not say what has made it"
    ):
        refuse_existing(tmp_path / "a.npy")
    (tmp_path / "empty.npy").touch()
    for name in ("empty.npy", "absent.npy"):
        refuse_existing(tmp_path / name)


def test_a_text_of_a_kind_replaces_its_own_kind_only(tmp_path):
    for content, kept in ((FOREIGN["text"], True), (f"# {DESIGNED_BY}\n".encode(), False)):
        (tmp_path / "a.toml").write_bytes(content)
        if kept:
            with pytest.raises(InputError, match="not a joint file that asperity has made"):
                write_text("new", tmp_path / "a.toml", kind=MADE_JOINT)
        else:
            write_text("new", tmp_path / "a.toml", kind=MADE_JOINT)
        assert ((tmp_path / "a.toml").read_bytes() == content) is kept
    assert [path.name for path in tmp_path.iterdir()] == ["a.toml"]


def test_both_ends_of_a_large_file_are_looked_at(tmp_path, monkeypatch):
    monkeypatch.setattr(made_files, "_LOOKED_AT", 100)
    file = Path(tmp_path, "a.pdf")
    mark = b"/Creator (asperity)"
    for content, made in (
        (mark + b"x" * 1000, True),
        (b"x" * 1000 + mark, True),
        (b"x" * 500 + mark + b"x" * 500, False),
        (b"x" * 50 + mark + b"x" * 50, True),
    ):
        file.write_bytes(content)
        assert IMAGE.is_made(file) is made

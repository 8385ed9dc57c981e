"""What this package has made is told from everything else, by the files that the package itself writes."""

import io
import json
import zipfile

import numpy as np
import pytest
from matplotlib.figure import Figure

from asperity.cli.runs.dynamics import RESPONSE
from asperity.cli.runs.loads import LOADS
from asperity.cli.runs.windup import ROLLING_CURVES, WINDUP_CURVES
from asperity.errors import InputError
from asperity.joint_file.contact_table import _RESULTS, INPUT_COLUMNS, MODEL_COLUMN, OUTPUT_COLUMNS
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
from asperity.views.blocks import Listing, Paragraph, Report
from asperity.views.html import report_html
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
    # what quotes a file of the package, or begins like one
    "notes": b"# notes: curves were written by asperity, torque rig data added by hand\ntorque,angle\n1,2\n",
    "below": b"# mine\n# Table of the joint in a.toml, written by asperity 0.1.0\ntorque_Nm\n1\n",
    "behind": b"# Table of the joint in a.toml, written by asperity 0.1.0, and changed by hand\ntorque_Nm\n1\n",
    "model": b'<mujoco model="my robot">\n  <!-- pasted from the file written by asperity -->\n</mujoco>\n',
    "pasted": b'<mujoco model="my robot">\n  <!--\n    My robot\n    MuJoCo model of the joint in a.toml, written by '
    b"asperity 0.1.0\n  -->\n</mujoco>\n",
    "package": b"// My package\n// Modelica package of the joint in a.toml, written by asperity 0.1.0\n",
    "quoted page": b'<!DOCTYPE html>\n<html><head><title>x</title></head><pre><meta name="generator" '
    b'content="asperity"></pre>',
    "loads and remarks": b"part,position,load,unit,comment\nsun,1,100,N,measured on the rig\n",
    "loads and notes": b"part,position,load,unit,without torque,comment\nsun,1,N,100,measured on the rig\n",
    "results and remarks": f"{','.join([*INPUT_COLUMNS, MODEL_COLUMN, *OUTPUT_COLUMNS])},comment\n".encode(),
    "results alone": f"specimen,{','.join(OUTPUT_COLUMNS)}\n".encode(),
    "curves and remarks": b"torque_Nm,loading_angle_rad,incremental_stiffness_Nm_per_rad,unloading_angle_rad,"
    b"reloading_angle_rad,comment\n",
}
KINDS = {
    "image": IMAGE,
    "report": REPORT,
    "drawing": DRAWING,
    "document": DOCUMENT,
    "joint": MADE_JOINT,
    "table": table_with("a table", "torque_Nm", "angle_rad"),
    "loads": LOADS,
    "results": _RESULTS,
    "wind-up": WINDUP_CURVES,
    "rolling": ROLLING_CURVES,
    "response": RESPONSE,
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


def test_tables_are_known_by_all_their_columns_in_their_order(tmp_path):
    kind = table_with("a table", "torque [N*m]", "angle [arcmin]")
    for head in ("torque [N*m],angle [arcmin]", '"torque [N*m]","angle [arcmin]"\r'):
        (tmp_path / "a.csv").write_text(f"{head}\n0,0\n")
        assert kind.is_made(tmp_path / "a.csv")
    for head in (
        "torque [N*m],angle [mrad]",
        "torque,angle",
        "angle [arcmin],torque [N*m]",
        "torque [N*m],angle [arcmin],comment",
        "torque [N*m]",
        ";torque;angle",
    ):
        (tmp_path / "a.csv").write_text(f"{head}\n0,0\n")
        assert not kind.is_made(tmp_path / "a.csv")


def test_a_foreign_archive_is_no_exported_joint(tmp_path):
    for content, made in (
        ('<fmiModelDescription guid="1"\n  generationTool="asperity 0.1.0" />', True),
        ('<fmiModelDescription guid="1" generationTool="another" />', False),
        ('<fmiModelDescription><!-- generationTool="asperity 0.1.0" --></fmiModelDescription>', False),
    ):
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


@pytest.fixture(params=["png", "svg", "pdf"])
def picture(request, tmp_path):
    """A picture that the package has made."""
    figure = Figure(figsize=(1.0, 1.0))
    figure.text(0.1, 0.5, "text")
    write_image(figure, tmp_path / f"picture.{request.param}")
    return tmp_path / f"picture.{request.param}"


def test_what_contains_a_picture_of_the_package_is_not_the_package_s(tmp_path, picture):
    inner = picture.read_bytes()
    others = Figure(figsize=(1.0, 1.0))
    others.savefig(tmp_path / f"other{picture.suffix}")
    outer = (tmp_path / f"other{picture.suffix}").read_bytes()
    svg = inner[inner.find(b"<svg") :]
    containing = {
        ".svg": (
            b'<svg xmlns="http://www.w3.org/2000/svg"><!-- my collage -->' + svg + b"</svg>",
            outer.replace(b"</svg>", svg + b"</svg>"),
        ),
        ".png": (outer + inner, outer[:8] + outer[8:].replace(b"IEND", b"IEND" + inner)),
        # an object of a file that is embedded; one that has been appended to, as by annotations
        ".pdf": (
            outer.replace(b"trailer", b"99 0 obj\n<< /Creator (asperity) >>\nendobj\ntrailer"),
            inner
            + b"1 0 obj\n<< >>\nendobj\nxref\n1 1\n0000000000 00000 n \ntrailer\n<< /Size 20 /Root 1 0 R /Prev 1 "
            b"/Info 19 0 R >>\nstartxref\n" + str(len(inner) + 20).encode() + b"\n%%EOF\n",
        ),
    }[picture.suffix]
    for content in containing:
        picture.write_bytes(content)
        assert not IMAGE.is_made(picture)


def test_a_page_that_quotes_a_report_is_no_report(tmp_path):
    page = report_html(REPORTED)
    other = page.replace('<meta name="generator" content="asperity">\n', "").replace(
        "</main>", f"<pre>{page}</pre></main>"
    )
    (tmp_path / "a.html").write_text(other, encoding="utf-8")
    assert not REPORT.is_made(tmp_path / "a.html")
    (tmp_path / "a.html").write_text(report_html(Report("A", [Listing(page)])), encoding="utf-8")
    assert REPORT.is_made(tmp_path / "a.html")

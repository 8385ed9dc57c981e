"""A report as PDF: made by typst from a hostile document, the same bytes every time."""

import sys

import pytest

from asperity.errors import MissingExtraError
from asperity.report.content import Bullets, Heading, Listing, Paragraph, Picture, Report, Table
from asperity.report.pdf import report_pdf, require_typst

SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2 1" width="2" height="1"><path d="M0 0L1 1"/></svg>'
HOSTILE = 'a" + read("/etc/passwd") #eval("1") \\ $x$ \x1b[31m\u202e'


def test_hostile_report_is_set_and_does_not_change():
    pytest.importorskip("typst", reason="the extra 'report' is not installed")
    report = Report(
        HOSTILE,
        (
            Heading(HOSTILE),
            Paragraph(HOSTILE),
            Bullets([HOSTILE]),
            Table(HOSTILE, ("x", "y\nmm"), [(HOSTILE, "1")] * 40),
            Picture(HOSTILE, SVG),
            Picture(HOSTILE, SVG, sheet=True),
            Listing(HOSTILE),
        ),
    )
    made = report_pdf(report)
    assert made.startswith(b"%PDF-")
    assert made == report_pdf(report)
    assert b"CreationDate" not in made


def test_without_typst_the_message_says_how_to_install_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(MissingExtraError, match=r"package 'typst'.*pip install .*\[report\].*\.html"):
        require_typst()

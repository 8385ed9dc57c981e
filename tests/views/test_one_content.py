"""Terminal, report, notebook and page show the same numbers with the same digits and labels."""

import html
import json
import re

import pytest

import asperity
from asperity.joint_file.reader import parse_case
from asperity.page.answer import joint_answer
from asperity.page.joint_request import JointRequest
from asperity.report.joint_report import ReportSource, joint_report
from asperity.views.blocks import Figures, block_documents
from asperity.views.html import report_html
from asperity.views.joint import contacts, key_figures


def lines_of(text):
    """The lines of a text, each with single blanks."""
    return {" ".join(line.split()) for line in text.splitlines()}


def rows_of(page):
    """The rows of all tables of a page in HTML: the texts of their cells."""
    rows = re.findall(r"<tr>(.*?)</tr>", page)
    return {tuple(map(html.unescape, re.findall(r"<td[^>]*>(.*?)</td>", row))) for row in rows}


@pytest.fixture(scope="module", params=["zou2025", "planetary"])
def screens(request, zou_file, view_of):
    """The view of an example, and what terminal, report, notebook and page show of it."""
    file = zou_file.with_name(f"{request.param}.toml")
    solution = asperity.load(file).solve()
    page = joint_answer(JointRequest(file.name, file.read_text(encoding="utf-8"), {}))["views"]
    return view_of(request.param), file, solution, page


@pytest.fixture
def wide(monkeypatch):
    """A terminal so wide that every table is one."""
    for room in ("asperity.cli.terminal", "asperity.views.terminal"):
        monkeypatch.setattr(f"{room}.WIDEST", 200)


def shown_tables(view):
    """Tables of contacts, of the joint that stands and of the one that turns."""
    return [*contacts(view), *view.contact_table("rolling", "Contacts in rolling")]


def rows_in(tables):
    """The rows of tables, of which there are some."""
    rows = {row for table in tables for row in table.rows}
    assert rows
    return rows


@pytest.mark.usefixtures("wide")
def test_the_terminal_shows_every_row_in_a_line(call, screens):
    view, file, _, _ = screens
    joint = call("joint", file, "--all").out
    lines = lines_of(joint + call("roll", file).out)
    assert {" ".join(row) for row in rows_in(shown_tables(view))} <= lines
    for figure in key_figures(view):
        said = f"{figure.name} {figure.text} {figure.detail}"
        assert said in " ".join(joint.split())


@pytest.mark.usefixtures("wide")
def test_the_notebook_shows_every_row(screens):
    view, _, solution, _ = screens
    rows, figures = rows_in(contacts(view)), key_figures(view)
    text, page = repr(solution), rows_of(solution._repr_html_())
    assert {" ".join(row) for row in rows} <= lines_of(text)
    assert rows <= page
    for figure in figures:
        assert f"{figure.name} {figure.text} {figure.detail}" in " ".join(text.split())
        assert (figure.name, figure.text, figure.detail) in page


def test_the_page_shows_every_table(screens):
    view, _, _, page = screens
    shown = json.loads(json.dumps(page))
    for table in json.loads(json.dumps(block_documents(shown_tables(view)))):
        assert table in shown["contacts"]
    assert shown["cards"] == json.loads(json.dumps(block_documents([Figures(key_figures(view))])))


@pytest.mark.slow
def test_the_report_shows_every_row(screens):
    view, file, _, _ = screens
    text = file.read_text(encoding="utf-8")
    page = report_html(joint_report(ReportSource(file.name, text, parse_case(text, source=file.name))))
    shown = rows_of(page)
    assert rows_in(shown_tables(view)) <= shown
    for figure in key_figures(view):
        assert (figure.name, figure.text, figure.detail) in shown

"""Terminal, report, notebook and page show the same numbers with the same digits and labels."""

import html
import re

import pytest

import asperity
from asperity.joint_file.reader import parse_case
from asperity.page.answer import joint_answer
from asperity.page.joint_request import JointRequest
from asperity.report.joint_report import ReportSource, joint_report
from asperity.views.html import report_html
from asperity.views.joint import contacts, key_figures


def texts_in(document):
    """Every text in a document for JSON."""
    if isinstance(document, str):
        return {document}
    if isinstance(document, dict):
        document = document.values()
    elif not isinstance(document, list | tuple):
        return set()
    return set().union(*map(texts_in, document))


def cells_of(page):
    """The texts of all cells of a page in HTML."""
    return {html.unescape(text) for text in re.findall(r"<td[^>]*>(.*?)</td>", page)}


@pytest.fixture(scope="module", params=["zou2025", "planetary"])
def screens(request, zou_file, view_of):
    """The view of an example, and what terminal, report, notebook and page show of it."""
    file = zou_file.with_name(f"{request.param}.toml")
    solution = asperity.load(file).solve()
    page = joint_answer(JointRequest(file.name, file.read_text(encoding="utf-8"), {}))["views"]
    return view_of(request.param), file, solution, page


def shown_cells(view):
    """Cells of the tables of contacts and of the key figures."""
    tables = [*contacts(view), *view.contact_table("rolling", "Contacts in rolling")]
    return {cell for table in tables for row in table.rows for cell in row}, key_figures(view)


def test_the_terminal_shows_every_cell(call, screens):
    view, file, _, _ = screens
    cells, figures = shown_cells(view)
    words = set((call("joint", file, "--all").out + call("roll", file).out).split())
    assert cells <= words
    text = " ".join(call("joint", file, "--all").out.split())
    for figure in figures:
        assert f"{figure.name} {figure.text}" in text


def test_the_notebook_shows_every_cell(screens):
    view, _, solution, _ = screens
    tables = contacts(view)
    cells, figures = {cell for table in tables for row in table.rows for cell in row}, key_figures(view)
    text, page = repr(solution), cells_of(solution._repr_html_())
    assert cells <= set(text.split())
    assert cells <= page
    for figure in figures:
        assert f"{figure.name} {figure.text}" in " ".join(text.split())
        assert {figure.name, figure.text, figure.detail} <= page


def test_the_page_shows_every_cell(screens):
    view, _, _, page = screens
    cells, figures = shown_cells(view)
    assert cells <= texts_in(page["contacts"])
    (cards,) = page["cards"]
    assert [(card["name"], card["shown"], card["unit"], card["detail"]) for card in cards["items"]] == [
        (figure.name, figure.shown, figure.unit, figure.detail) for figure in figures
    ]


@pytest.mark.slow
def test_the_report_shows_every_cell(screens):
    view, file, _, _ = screens
    cells, figures = shown_cells(view)
    text = file.read_text(encoding="utf-8")
    page = report_html(joint_report(ReportSource(file.name, text, parse_case(text, source=file.name))))
    shown = cells_of(page)
    assert cells <= shown
    for figure in figures:
        assert {figure.name, figure.text, figure.detail} <= shown

import sys

import pytest
from matplotlib.figure import Figure

from asperity.api.shown import Shown, displayed, frame
from asperity.errors import MissingExtraError
from asperity.views.blocks import Heading, Paragraph, Table

TABLE = Table("Title", ("what", "how much"), [("a", "1"), ("longer", "12 <N>")])


class Thing(Shown):
    def blocks(self):
        return [Paragraph("a < b\nnext"), TABLE]


def test_text_is_that_of_a_terminal():
    lines = [line.rstrip() for line in repr(Thing()).split("\n")]
    assert lines[:4] == ["a < b", "next", "", "Title"]
    assert [line.split() for line in lines[4:5] + lines[6:]] == [
        ["what", "how", "much"], ["a", "1"], ["longer", "12", "<N>"],
    ]  # fmt: skip
    assert len({len(line) for line in lines[6:]}) == 1  # numbers at the right


def test_html_is_escaped():
    found = Thing()._repr_html_()
    assert "<p>a &lt; b<br>next</p>" in found
    assert "<td>12 &lt;N&gt;</td>" in found
    assert found.count("<tr>") == 3


def test_headings_of_a_notebook_have_no_numbers_and_no_places():
    class Headed(Shown):
        def blocks(self):
            return [Heading("One"), Heading("Two")]

    found = Headed()._repr_html_()
    assert ">One<" in found
    assert ">Two<" in found
    assert "id=" not in found


def test_a_figure_shows_itself_in_a_notebook():
    figure = displayed(Figure())
    assert figure._repr_png_()[:4] == b"\x89PNG"


def test_missing_pandas_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingExtraError, match=r"need the package 'pandas'.*\[study\]"):
        frame({"a": [1]})

import sys

import pytest
from matplotlib.figure import Figure

from asperity.api.shown import Shown, Table, displayed, frame
from asperity.errors import MissingExtraError

TABLE = Table(("what", "how much"), [("a", "1"), ("longer", "12 <N>")], "Title")


class Thing(Shown):
    def _parts(self):
        return ["a < b\nnext", TABLE]


def test_text_has_columns_of_equal_width():
    assert TABLE.text().split("\n") == [
        "Title", "what    how much", "────────────────", "a              1", "longer    12 <N>",
    ]  # fmt: skip
    assert repr(Thing()).startswith("a < b\nnext\n\nTitle\n")


def test_html_is_escaped():
    found = Thing()._repr_html_()
    assert "<p>a &lt; b<br>next</p>" in found
    assert "<td>12 &lt;N&gt;</td>" in found
    assert found.count("<tr>") == 3


def test_a_figure_shows_itself_in_a_notebook():
    figure = displayed(Figure())
    assert figure._repr_png_()[:4] == b"\x89PNG"


def test_missing_pandas_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingExtraError, match=r"need the package 'pandas'.*\[study\]"):
        frame({"a": [1]})

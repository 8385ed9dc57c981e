"""A bar on a terminal, silence elsewhere."""

import io

from asperity.cli.progress import progress_bar


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_nothing_is_said_where_nobody_watches(monkeypatch):
    stream = io.StringIO()
    monkeypatch.setattr("sys.stderr", stream)
    with progress_bar("points") as report:
        report(1, 2)
    assert stream.getvalue() == ""


def test_a_terminal_sees_how_far_the_work_is(monkeypatch):
    stream = Terminal()
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setenv("TERM", "xterm")
    with progress_bar("points") as report:
        report(0, 40)
        report(30, 40)
    shown = stream.getvalue()
    assert "compiling, then points" in shown
    assert "30/40" in shown

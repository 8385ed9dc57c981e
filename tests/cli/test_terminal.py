import io

import pytest
from rich.console import Console

from asperity.cli.terminal import WIDEST, console, table


def test_a_pipe_without_unicode_gets_plain_letters(monkeypatch):
    raw = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(raw, encoding="ascii"))
    target = console()
    shown = table(target, "Stiffness", "model", "K\nN·m/rad", "area\nmm²")
    shown.add_row("published → bound", "5", "1")
    target.print(shown)
    target.print("± é")
    import sys

    sys.stdout.flush()
    text = raw.getvalue().decode("ascii")
    assert "N*m/rad" in text
    assert "mm^2" in text
    assert "published -> bound" in text
    assert "+- ?" in text
    assert "\x1b" not in text


def test_a_pipe_is_as_wide_as_tables_may_be(monkeypatch):
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(io.BytesIO(), encoding="utf-8"))
    assert console().width == WIDEST


@pytest.mark.parametrize("width", [100, 80])
def test_rows_keep_their_names_in_a_table_of_many_columns(width):
    target = Console(file=io.StringIO(), width=width)
    shown = table(target, "Contacts", "contact", *(f"quantity {k}" for k in range(9)))
    shown.add_row("wro", *("1.23" for _ in range(9)))
    target.print(shown)
    assert any(line.startswith(" wro ") for line in target.file.getvalue().splitlines())


def test_units_in_brackets_are_no_markup(monkeypatch):
    raw = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(raw, encoding="utf-8"))
    target = console()
    shown = table(target, "lengths [mm]", "radius [mm]", "pressure [MPa]")
    shown.add_row("1", "2")
    target.print(shown)
    import sys

    sys.stdout.flush()
    lines = raw.getvalue().decode().splitlines()
    assert lines[0].strip() == "lengths [mm]"
    assert any(line.split() == ["radius", "[mm]", "pressure", "[MPa]"] for line in lines)

"""A solved joint as views read it: tables of contacts are made from the rows of the results."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.results import RESULTS


def test_a_number_of_the_joint_or_none(paper_view, planetary_view):
    assert planetary_view.value("speed_ratio") == pytest.approx(1.0 + 50.0 / 10.0)
    assert paper_view.value("drive_life") is None  # above shakedown


def test_every_result_with_a_column_stands_in_its_table(paper_view):
    tables = {
        row.column.table: paper_view.contact_table(row.column.table, "Title")
        for row in RESULTS.values()
        if row.column is not None
    }
    assert tables.pop("crowns") == tables.pop("film") == []  # no contact of this joint has a crown or oil
    for name, (table,) in tables.items():
        heads = [row.column.head for row in RESULTS.values() if row.column and row.column.table == name]
        assert [head.partition("\n")[0] for head in table.head] == ["contact", *heads]
        assert [row[0] for row in table.rows] == ["sp", "pwr", "pwl", "wro", "wlo"]
        assert {len(row) for row in table.rows} == {len(table.head)}


def test_a_contact_without_a_number_has_a_dash_and_a_column_without_any_is_left_out(paper_view):
    changed = dataclasses.replace(paper_view)
    width, area = paper_view.rows["hertz_half_width"], paper_view.rows["real_contact_area"]

    def of(values):
        return lambda _: np.asarray(values)

    changed.__dict__["rows"] = {
        "hertz_half_width": dataclasses.replace(width, value=of([math.nan, 1e-4, 1e-4, 1e-4, 1e-4])),
        "real_contact_area": dataclasses.replace(area, value=of([math.nan] * 5)),
    }
    (table,) = changed.contact_table("forces", "Title")
    assert table.head == ("contact", "Hertz width\nmm")
    assert table.rows == [("sp", "–"), *((name, "0.2") for name in ("pwr", "pwl", "wro", "wlo"))]
    del changed.__dict__["rows"]
    assert changed.contact_table("of no row", "Title") == []

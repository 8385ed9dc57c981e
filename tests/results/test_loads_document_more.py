"""Rows for the suppliers of pins and bearings, from cases made by hand."""

import numpy as np

from asperity.results.loads_document import document_of_rows


def row_of(document, part, position, quantity):
    found = [
        row["values"]
        for row in document["loads"]
        if (row["part"], row["position"], row["quantity"]) == (part, position, quantity)
    ]
    assert len(found) == 1, quantity
    return found[0]


def test_what_rounding_leaves_is_nothing():
    """5.8e-15 N·m beside 11 N·m, in a table that also has forces; a nanonewton-metre is kept."""
    cases = [
        {"name": name, "unknown_because": None} for name in ("without torque", "working torque", "load 1")
    ]
    rows = [
        ("carrier", "centre", "torque", "N*m", np.array([5.8e-15, 11.0, 1e-9])),
        ("carrier", "centre", "force", "N", 3e-13),
    ]
    document = document_of_rows(cases, rows, bearings=[], notes=[], temperature_limits=[])
    assert row_of(document, "carrier", "centre", "torque") == [0.0, 11.0, 1e-9]
    assert row_of(document, "carrier", "centre", "force") == [3e-13] * 3

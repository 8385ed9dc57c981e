"""Tilted axes in the document of loads."""

import dataclasses
import json

import pytest

from asperity.drive.structure.axis_tilts import AxisTilts
from asperity.results.loads_document import loads_document
from asperity.results.solved import solved_with_capacities
from asperity.results.tilt_document import tilt_document


def solved(planetary, **tilts):
    joint, solution, _ = planetary
    axes = AxisTilts(**tilts) if tilts else None
    return solved_with_capacities(dataclasses.replace(joint, tilts=axes), solution)


def test_it_stands_beside_the_loads_where_axes_are_tilted(planetary):
    tilted = solved(planetary, bodies=("sun",), out=(1e-3,), across=(0.5e-3,))
    document = json.loads(json.dumps(loads_document(tilted, [])))
    straight = json.loads(json.dumps(loads_document(solved(planetary), [])))
    tilt = document.pop("tilt")
    assert document == straight
    assert tilt["axes"] == {"sun_axis": {"out_rad": 1e-3, "across_rad": 0.5e-3}}
    sun, ring = tilt["contacts"].values()
    assert sun["as_stated"]["slope_rad"] == pytest.approx(1e-3)  # planets stand on their pins
    assert sun["as_stated"]["skew_rad"] == pytest.approx(0.5e-3)
    assert ring["as_stated"]["slope_rad"] == 0.0
    assert sun["as_stated"]["edge"]
    assert sun["as_stated"]["peak_pressure_Pa"] is None


def test_notes_name_contacts_with_a_free_end(planetary):
    few, many = (
        tilt_document(solved(planetary, bodies=("sun",), out=(out,), across=(0.0,))) for out in (1e-5, 5e-3)
    )
    assert not [note for note in few["notes"] if "comes free" in note]
    assert [note.split(":")[0] for note in many["notes"] if "comes free" in note] == ["sp"]
    assert many["contacts"]["sp"]["freeing_slope_rad"] < 5e-3
    assert tilt_document(solved(planetary)) is None

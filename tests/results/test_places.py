"""Places of rows in the JSON document: each its own, with its unit at the end, and all of them filled."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.results import RESULTS, Result
from asperity.results.places import OTHER_UNITS, in_order, place, unit_of_key, with_rows
from asperity.unit_table import Dimension

#: Ends of keys behind which a unit says more: per turn of the output.
PER_TURN = "_per_output_turn"


def test_every_place_belongs_to_one_row():
    places = [place(row) for row in RESULTS.values() if place(row)]
    assert len(set(places)) == len(places) > 60


@pytest.mark.parametrize("row", [row for row in RESULTS.values() if place(row)], ids=lambda row: row.name)
def test_a_key_ends_with_its_unit_and_rows_have_their_names_in_it(row):
    where = place(row)
    assert ("*" in where.split(".")) is (row.axis != "one")
    keys = [key.removesuffix(PER_TURN) for key in where.split(".") if key != "*"]
    unit = unit_of_key(row.si_unit)
    assert any(key.endswith((unit, *OTHER_UNITS)) for key in keys[-2:])


def test_units_as_ends_of_keys():
    assert [unit_of_key(unit) for unit in ("1", "N*m/rad", "m^2", "rad/s")] == [
        "", "_Nm_per_rad", "_m2", "_rad_per_s",
    ]  # fmt: skip


@pytest.fixture
def rows(monkeypatch):
    """Make a table of the given rows alone."""

    def make(*made):
        monkeypatch.setattr(
            "asperity.results.places.results_of_joint", lambda solved: {row.name: row for row in made}
        )

    return make


def row(name, value, **more):
    return Result(name, "a result", Dimension.FORCE, "kN", lambda solved: value, **more)


CONTACTS = {"axis": "contact", "rows": ("sp", "pr")}


def test_a_row_without_a_place_stands_in_the_section_of_its_group(rows):
    made = (
        row("push", 3.0, group="forces"),
        row("pull", np.array([1.0, 2.0]), group="contacts", **CONTACTS),
        row("drag", np.array([4.0, 5.0]), group="losses", **CONTACTS),
        row("load", np.array([6.0]), group="loads", axis="body", rows=("sun",)),
        row("other", 7.0, group="new"),
    )
    rows(*made)
    assert with_rows({"standing": {"forces": {"first_N": 0.0}}}, None) == {
        "standing": {
            "forces": {"first_N": 0.0, "push_N": 3.0},
            "contacts": {"sp": {"pull_N": 1.0}, "pr": {"pull_N": 2.0}},
        },
        "rolling": {"contacts": {"sp": {"drag_N": 4.0}, "pr": {"drag_N": 5.0}}},
        "loads": {"load_N": {"sun": 6.0}},
        "new": {"other_N": 7.0},
    }


def test_entries_that_wait_keep_their_order_and_leave_without_a_row(rows):
    rows(row("a", 1.0, place="b.second"), row("c", 2.0, place="b.first"))
    asked = {"b": {**in_order("first absent"), "between": 0, **in_order("second")}, **in_order("gone")}
    found = with_rows(asked, None)
    assert found == {"b": {"first": 2.0, "between": 0, "second": 1.0}}
    assert list(found["b"]) == ["first", "between", "second"]


def test_a_place_that_is_taken_is_refused(rows):
    rows(row("a", 1.0, place="b.first"))
    with pytest.raises(ValueError, match=r"b\.first: two entries"):
        with_rows({"b": {"first": None}}, None)


def test_hours_are_hours(rows):
    time = dataclasses.replace(row("a", np.array([7200.0]), axis="body", rows=("sun",)), place="life_hours.*")
    rows(time, row("b", 2.0, place="drift_rad_per_hour"))
    assert with_rows({}, None) == {"life_hours": {"sun": 2.0}, "drift_rad_per_hour": 7200.0}


def test_what_is_judged_or_counted_is_said_elsewhere():
    judged = next(row for row in RESULTS.values() if row.limit is not None and row.place is None)
    counted = dataclasses.replace(row("a", 1.0), categories=("one", "other"))
    assert place(judged) == place(counted) == ""


def test_rows_that_no_part_of_a_joint_has_are_not_computed(rows):
    def refuse(solved):
        raise AssertionError

    rows(
        dataclasses.replace(
            row("a", 0.0, group="contacts", **CONTACTS), value=refuse, present=lambda solved: (False, False)
        )
    )
    found = with_rows({}, None)["standing"]["contacts"]
    assert all(np.isnan(entry["a_N"]) for entry in found.values())


#: Rows of the paper's joint at places of the document, and the numbers at these places by hand.
BY_HAND = {
    # sun of 4 mm within a ring of 40 mm that stands: the wedge turns the carrier backwards
    "speed_ratio": -9.0,
    # sun, three planets, six loading rollers of 5 mm length, and the ring of 40 to 100 mm: rho pi r² L
    "mass": 7850.0 * math.pi * (4.0**2 + 3.0 * 13.5**2 + 6.0 * 5.0**2 + 100.0**2 - 40.0**2) * 5.0 * 1e-9,
}


def hertz_pressures(document):
    """Of each contact p = sqrt(N E*/(pi R L)) by its force; two bodies of steel, 5 mm long."""
    modulus, length = 206e9 / (2.0 * (1.0 - 0.3**2)), 5e-3
    curvature = {"sp": 1.0 / 4.0 + 1.0 / 13.5}
    curvature |= dict.fromkeys(("pwr", "pwl"), 1.0 / 13.5 + 1.0 / 5.0)
    curvature |= dict.fromkeys(("wro", "wlo"), 1.0 / 5.0 - 1.0 / 40.0)
    forces = document["standing"]["forces"]["normal_N"]
    return {
        name: math.sqrt(forces[name] * modulus * 1e3 * per_radius / (math.pi * length))
        for name, per_radius in curvature.items()
    }


def test_the_document_has_the_numbers_of_the_rows(solved_example):
    """By their places, as a reader of the document looks for them."""
    from asperity.results.document import joint_document

    document = joint_document(solved_example, inputs={}, assumptions=())
    for name, expected in BY_HAND.items():
        node = document
        for key in place(RESULTS[name]).split("."):
            node = node[key]
        assert node == pytest.approx(expected, rel=1e-9), name
    pressures = hertz_pressures(document)
    assert set(pressures) == set(document["standing"]["contacts"])
    for contact, expected in pressures.items():
        assert document["standing"]["contacts"][contact]["hertz_pressure_Pa"] == pytest.approx(
            expected, rel=1e-9
        )
    # of the others, whose numbers are judged in their own rooms, the place
    for name in ("creep_loss", "body_life", "published_stiffness_output"):
        known = RESULTS[name]
        names = [""] if known.axis == "one" else solved_example.row_names(known.axis)
        values = np.broadcast_to(np.asarray(known.of(solved_example), dtype=float), (len(names),))
        for part, value in zip(names, values, strict=True):
            node = document
            for key in place(known).split("."):
                node = node[part if key == "*" else key]
            hours = place(known).removesuffix(".*").endswith("_hours")
            expected = value / (3600.0 if hours else 1.0)
            assert node == (pytest.approx(expected, rel=1e-12) if np.isfinite(expected) else None)

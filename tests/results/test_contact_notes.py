"""Notes on contacts: crowned ones from both sides of their limits."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.results.contact_notes import contact_notes, crown_notes

NAN = float("nan")


def test_crowned_contacts_are_judged_by_their_length_and_ends():
    """A long contact with loaded ends, a short one with free ends, and an open one."""
    found = SimpleNamespace(
        loaded_length_over_width=np.array([20.0, 3.0, NAN]),
        loaded_length_share=np.array([1.0, 0.5, NAN]),
        end_line_load_ratio=np.array([0.3, 0.0, NAN]),
        peak_line_load_ratio=np.array([1.2, 2.4, NAN]),
    )
    (length, ends), (short, free) = (crown_notes(name, found, k) for k, name in enumerate(("sp", "pr")))
    assert (length.ok, ends.ok, short.ok, free.ok) == (True, False, False, True)
    assert (short.contact, short.value, short.limit) == ("pr", 1.0 / 3.0, 0.25)
    assert short.remedy == "choose a larger crown radius"
    assert "edges raise the stress" in ends.meaning
    assert "50 % of the contact length is loaded, with 2.4 times" in free.meaning
    assert crown_notes("qq", found, 2) == []


def test_a_contact_without_oil_and_scale_has_two_notes():
    notes = contact_notes(
        "sp",
        friction_coefficient=0.1,
        contact_length=10e-3,
        smaller_radius=10e-3,
        effective_radius=5e-3,
        film_ratio=NAN,
        contact_factor_model="unity",
    )
    assert [(note.name, note.value, note.ok) for note in notes] == [
        ("friction_coefficient", 0.1, True),
        ("contact_length_over_diameter", 0.5, True),
    ]


def roller(**changes):
    """Notes of a sun of 4 mm and a planet of 13.5 mm radius, 6 mm long, with Zou's contact factor."""
    given = {
        "friction_coefficient": 0.12,
        "contact_length": 6e-3,
        "smaller_radius": 4e-3,
        "effective_radius": 54e-3 / 17.5,
        "film_ratio": NAN,
        "contact_factor_model": "printed",
    }
    return {note.name: note for note in contact_notes("sp", **given | changes)}


@pytest.mark.parametrize(
    ("name", "changes", "value", "limit", "ok"),
    [
        ("friction_coefficient", {"friction_coefficient": 0.299}, 0.299, 0.3, True),
        ("friction_coefficient", {"friction_coefficient": 0.301}, 0.301, 0.3, False),
        ("contact_length_over_diameter", {"contact_length": 23.9e-3}, 2.9875, 3.0, True),
        ("contact_length_over_diameter", {"contact_length": 24.1e-3}, 3.0125, 3.0, False),
        ("contact_factor_size", {"contact_length": 29.9e-3}, 29.9e-3, 30e-3, True),
        ("contact_factor_size", {"contact_length": 30.1e-3}, 30.1e-3, 30e-3, False),
        ("contact_factor_size", {"contact_length": 4.9e-3}, 4.9e-3, 5e-3, False),
        ("contact_factor_size", {"effective_radius": 2.9e-3}, 2.9e-3, 3e-3, False),
        ("contact_factor_size", {"effective_radius": 8.3e-3}, 8.3e-3, 8.4e-3, True),
        ("contact_factor_size", {"effective_radius": 8.5e-3}, 8.5e-3, 8.4e-3, False),
    ],
)
def test_limits_from_both_sides(name, changes, value, limit, ok):
    note = roller(**changes)[name]
    assert note.value == pytest.approx(value, rel=1e-12)
    assert (note.ok, note.remedy is None) == (ok, ok)
    if not ok or name != "contact_factor_size":
        assert note.limit == limit


def test_a_film_that_carries_load_is_named_where_its_ratio_is_known():
    found = {ratio: roller(film_ratio=ratio).get("film_ratio") for ratio in (0.9, 1.3)}
    assert not any(note.ok for note in found.values())
    assert "boundary lubrication" in found[0.9].meaning
    assert "the oil film carries a part of the load" in found[1.3].meaning
    assert "film_ratio" not in roller()

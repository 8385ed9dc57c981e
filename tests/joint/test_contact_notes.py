"""Notes on contacts: crowned ones from both sides of their limits."""

from types import SimpleNamespace

import numpy as np

from asperity.joint.contact_notes import contact_notes, crown_notes

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

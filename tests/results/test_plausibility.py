"""Notes on the sizes of planar joints."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.results.plausibility import plausibility


def test_each_contact_has_its_own_numbers(planar_joint):
    """Length over diameter: 10/(2 * 10) at the sun, 50/(2 * 20) in the ring, by the smaller roller."""
    table = {
        'contact_length = "10 mm"': 'contact_length = { sp = "10 mm", pr = "50 mm" }',
        "friction_coefficient = 0.08": "friction_coefficient = { sp = 0.08, pr = 0.4 }",
    }
    found = plausibility(
        joint := planar_joint("planetary", table),
        SimpleNamespace(
            rolling=SimpleNamespace(film_ratio=np.array([np.nan, 5.0])), contact_names=joint.contact_names
        ),
    )
    values = [(note.value, note.ok) for note in found]
    assert [value for value, _ in values] == pytest.approx([0.08, 0.5, 0.4, 1.25, 5.0])
    assert values[0][1]
    assert not values[2][1]  # above what clean dry steel reaches
    assert not values[4][1]  # a full film


def test_crowned_contacts_have_two_notes_more(planar_joint):
    """Only the crowned ones: the planet's track towards the sun and the ring alike, here the ring alone."""
    crown = {'contact_length = "10 mm"': 'ring_crown_radius = "2 m"\ncontact_length = "10 mm"'}
    joint = planar_joint("planetary", crown)
    along = {
        "loaded_length_over_width": np.array([10.0, 3.0]),
        "loaded_length_share": np.array([1.0, 0.8]),
        "end_line_load_ratio": np.array([1.0, 0.0]),
        "peak_line_load_ratio": np.array([1.0, 1.7]),
    }
    result = SimpleNamespace(
        rolling=SimpleNamespace(film_ratio=np.full(2, np.nan)),
        contact_names=("sp", "pr"),
        diagnostics=SimpleNamespace(**along),
    )
    found = {(note.name, note.contact): note.ok for note in plausibility(joint, result)}
    assert found["contact_width_over_length", "pr"] is False
    assert found["crowned_end_load", "pr"] is True
    assert ("crowned_end_load", "sp") not in found


def test_the_printed_factor_has_a_range_of_sizes(planar_joint):
    printed = planar_joint("planetary", {'contact_factor = "unity"': 'contact_factor = "printed"'})
    result = SimpleNamespace(
        rolling=SimpleNamespace(film_ratio=np.full(2, np.nan)), contact_names=("sp", "pr")
    )
    assert len(plausibility(printed, result)) == len(plausibility(planar_joint("planetary"), result)) + 2

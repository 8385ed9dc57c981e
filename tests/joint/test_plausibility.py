"""Notes on joints that can exist: the ring that carries itself against exact annuli, sizes, friction, lengths."""

import dataclasses

import numpy as np
import pytest

from asperity.joint.plausibility import plausibility
from asperity.joint.solve import solve


@pytest.fixture(scope="module")
def notes(paper_joint):
    def of(**changes):
        joint = paper_joint(**changes)
        solution = solve(joint)
        found = plausibility(joint, solution.result, solution.sizes)
        return {(note.name, note.contact): note for note in found}

    return of


@pytest.mark.parametrize(
    ("wall", "exact"), [(4e-3, 2129.0), (10e-3, 15142.0), (15e-3, 23302.0), (20e-3, 27395.0)]
)
def test_the_loss_of_a_ring_that_carries_itself(paper_joint, notes, wall, exact):
    """Assembled stiffness with exact discs and a free annulus in plane strain, asperities left out [N·m/rad]."""
    changes = {"ring_wall_thickness": wall, "output_torque": 1e-3, "sun_speed": 0.0}
    note = notes(**changes)["ring_bending_loss", None]
    held = float(solve(paper_joint(**changes)).result.assembly.stiffness.output)
    assert held * (1.0 - note.value) == pytest.approx(exact, rel=0.08)
    assert not note.ok
    assert "give ring_bending_stiffness" in (note.meaning + str(note.remedy))


def test_a_thick_ring_and_ordinary_numbers_are_no_warning(notes):
    found = notes(ring_wall_thickness=60e-3)
    assert [name for name, note in found.items() if not note.ok] == []
    assert found["ring_bending_loss", None].value == pytest.approx(0.02, abs=0.01)


@pytest.mark.parametrize(
    ("changes", "name", "said"),
    [
        ({"friction_coefficient": 0.8}, "friction_coefficient", "traction fluids reach 0.12"),
        ({"contact_length": 150e-3}, "contact_length_over_diameter", "long for its roller"),
        ({"contact_length": 150e-3}, "contact_factor_size", "contact lengths of 5 mm to 30 mm"),
        (
            {"contact_length": 2e-3, "contact_factor_model": "hertz_area"},
            "contact_factor_size",
            '"hertz_area"',
        ),
    ],
)
def test_unusual_numbers_are_named(notes, changes, name, said):
    note = notes(ring_wall_thickness=60e-3, **changes)[name, "sp"]
    assert not note.ok
    assert said in (note.meaning + str(note.remedy))


def test_a_film_that_carries_load_is_named_where_its_ratio_is_known(paper_joint):
    solution = solve(paper_joint(ring_wall_thickness=60e-3))
    ratios = np.array([0.4, 0.9, 1.3, np.nan, 3.5])
    rolling = dataclasses.replace(solution.result.rolling, film_ratio=ratios)
    result = dataclasses.replace(solution.result, rolling=rolling)
    notes = plausibility(paper_joint(), result, solution.sizes)
    found = {note.contact: note for note in notes if note.name == "film_ratio"}
    assert {name: note.ok for name, note in found.items()} == {
        "sp": True,
        "pwr": True,
        "pwl": False,
        "wlo": False,
    }
    assert "the oil film carries a part of the load" in found["pwl"].meaning


def test_without_a_scale_the_size_does_not_matter(notes):
    names = {name for name, _ in notes(contact_length=150e-3, contact_factor_model="unity")}
    assert "contact_factor_size" not in names

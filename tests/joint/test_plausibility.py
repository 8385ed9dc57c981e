"""Notes on joints that can exist: the ring that carries itself against exact annuli, sizes, friction, lengths."""

import dataclasses

import pytest

from asperity.joint.plausibility import plausibility
from asperity.joint.solve import solve


@pytest.fixture(scope="module")
def notes(paper_joint):
    def of(**changes):
        joint = paper_joint(**changes)
        return {(note.name, note.contact): note for note in plausibility(joint, solve(joint).result)}

    return of


@pytest.mark.parametrize(
    ("model", "wall", "exact", "rel"),
    [
        *(("springs", wall, k, 0.08) for wall, k in ((4e-3, 2129.0), (10e-3, 15142.0), (20e-3, 27395.0))),
        *(("exact", wall, k, 0.06) for wall, k in ((4e-3, 1759.0), (10e-3, 12983.0))),
    ],
)
def test_the_loss_of_a_ring_that_carries_itself(paper_joint, model, wall, exact, rel):
    """Assembled stiffness with exact discs and a free annulus in plane strain, asperities left out [N·m/rad]: with
    radial coupling only, as the spring of the thin ring has it, and with all."""
    joint = paper_joint(ring_wall_thickness=wall, output_torque=1e-3, sun_speed=0.0)
    joint = dataclasses.replace(joint, body_model=model)
    result = solve(joint).result
    (note,) = (note for note in plausibility(joint, result) if note.name == "ring_bending_loss")
    assert float(result.assembly.stiffness.output) * (1.0 - note.value) == pytest.approx(exact, rel=rel)
    assert not note.ok
    remedy = {"springs": 'choose bodies = "exact"', "exact": "state drive.ring_support"}[model]
    assert remedy in note.remedy


@pytest.mark.parametrize("support", ["rigid_housing", "free"])
def test_a_stated_support_needs_no_warning(paper_joint, support):
    joint = dataclasses.replace(paper_joint(ring_wall_thickness=6e-3), ring_support=support)
    names = [note.name for note in plausibility(joint, solve(joint).result)]
    assert "ring_bending_loss" not in names


def test_a_thick_ring_and_ordinary_numbers_are_no_warning(notes):
    found = notes(ring_wall_thickness=60e-3)
    assert [name for name, note in found.items() if not note.ok] == []
    assert found["ring_bending_loss", None].value == pytest.approx(0.025, abs=0.01)


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


def test_without_a_scale_the_size_does_not_matter(notes):
    names = {name for name, _ in notes(contact_length=150e-3, contact_factor_model="unity")}
    assert "contact_factor_size" not in names

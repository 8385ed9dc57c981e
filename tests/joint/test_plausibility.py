"""Notes on joints that can exist: the ring that carries itself against exact annuli, sizes, friction, lengths."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint.plausibility import checked_sizes, plausibility
from asperity.joint.solve import solve


@pytest.fixture(scope="module")
def notes(paper_joint):
    def of(**changes):
        joint = paper_joint(**changes)
        solution = solve(joint)
        found = plausibility(joint, solution.result, solution.sizes)
        return {(note.name, note.contact): note for note in found}

    return of


@pytest.mark.slow
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
    solution = solve(joint)
    found = plausibility(joint, solution.result, solution.sizes)
    (note,) = (note for note in found if note.name == "ring_bending_loss")
    assert float(solution.result.assembly.stiffness.output) * (1.0 - note.value) == pytest.approx(
        exact, rel=rel
    )
    assert not note.ok
    remedy = {"springs": 'choose bodies = "exact"', "exact": "state ring_support"}[model]
    assert remedy in note.remedy


@pytest.mark.slow
@pytest.mark.parametrize("support", ["rigid_housing", "free"])
def test_a_stated_support_needs_no_warning(paper_joint, support):
    joint = dataclasses.replace(paper_joint(ring_wall_thickness=6e-3), ring_support=support)
    solution = solve(joint)
    names = [note.name for note in plausibility(joint, solution.result, solution.sizes)]
    assert "ring_bending_loss" not in names


def test_a_thick_ring_and_ordinary_numbers_are_no_warning(notes):
    found = notes(ring_wall_thickness=60e-3)
    assert [name for name, note in found.items() if not note.ok] == []
    assert found["ring_bending_loss", None].value == pytest.approx(0.025, abs=0.01)


@pytest.mark.slow
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


def test_every_film_is_a_state_with_a_consequence_where_its_ratio_is_known(paper_joint):
    solution = solve(paper_joint(ring_wall_thickness=60e-3))
    ratios = np.array([0.4, 0.9, 1.3, np.nan, 3.5])
    rolling = dataclasses.replace(solution.result.rolling, film_ratio=ratios)
    result = dataclasses.replace(solution.result, rolling=rolling)
    notes = plausibility(paper_joint(), result, solution.sizes)
    found = {note.contact: note for note in notes if note.name == "film_ratio"}
    states = {name: (note.ok, note.severity, note.state) for name, note in found.items()}
    boundary = (False, "state", "boundary lubrication")  # never a limit that is kept
    assert states == {
        "sp": boundary,
        "pwr": boundary,
        "pwl": (False, "accuracy", "mixed lubrication"),
        "wlo": (False, "accuracy", "full lubrication"),
    }
    assert "a life without a factor for the film is too long" in found["sp"].meaning
    assert "the oil film carries a part of the load" in found["pwl"].meaning


@pytest.mark.slow
def test_without_a_scale_the_size_does_not_matter(notes):
    names = {name for name, _ in notes(contact_length=150e-3, contact_factor_model="unity")}
    assert "contact_factor_size" not in names


@pytest.fixture(scope="module")
def sizes(paper_joint):
    """Notes that need no solution: what holds the ring is stated."""

    def of(**changes):
        joint = paper_joint(**changes)
        given = dataclasses.replace(joint, ring_support="rigid_housing")
        unknown = SimpleNamespace(rolling=SimpleNamespace(film_ratio=np.full(5, np.nan)))
        found = plausibility(given, unknown, checked_sizes(given, unknown))
        return {(note.name, note.contact): note for note in found}

    return of


def compared(note):
    return note.value, note.limit, note.ok


def test_values_and_limits_by_hand(sizes):
    """Rollers of 4, 13.5 and 5 mm, lines of 6 mm: 6/(2 x 4) and 6/(2 x 5)."""
    found = sizes(contact_length=6e-3)
    for contact, slenderness in {"sp": 0.75, "pwr": 0.6, "pwl": 0.6, "wro": 0.6, "wlo": 0.6}.items():
        assert compared(found["friction_coefficient", contact]) == (0.12, 0.3, True)
        note = found["contact_length_over_diameter", contact]
        assert compared(note) == (pytest.approx(slenderness, rel=1e-14), 3.0, True)
    # 54/17.5 mm is nearer to the limit of 3 mm than 6 mm to that of 5 mm; at the ring the length is nearer to its own
    assert compared(found["contact_factor_size", "sp"]) == (pytest.approx(54e-3 / 17.5), 8.4e-3, True)
    assert compared(found["contact_factor_size", "wro"]) == (pytest.approx(6e-3), 30e-3, True)


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
        # 1/R = 1/4 + 1/R_p to an effective radius of 2.9 mm, or 1/R_s + 1/13.5 to 8.3 and to 8.5 mm
        ("contact_factor_size", {"planet_radius": 116e-4 / 1.1}, 2.9e-3, 3e-3, False),
        ("contact_factor_size", {"sun_radius": 112.05e-3 / 5.2}, 8.3e-3, 8.4e-3, True),
        ("contact_factor_size", {"sun_radius": 114.75e-3 / 5.0}, 8.5e-3, 8.4e-3, False),
    ],
)
def test_limits_from_both_sides(sizes, name, changes, value, limit, ok):
    note = sizes(**({"contact_length": 6e-3} | changes))[name, "sp"]
    assert note.value == pytest.approx(value, rel=1e-12)
    assert (note.ok, note.remedy is None) == (ok, ok)
    if not ok or name != "contact_factor_size":
        assert note.limit == limit

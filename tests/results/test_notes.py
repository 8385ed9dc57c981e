"""Notes on a joint: its contacts from both sides of their limits, its sizes, and the main cause of its losses."""

import re
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.results.notes import (
    contact_notes,
    crown_notes,
    loss_notes,
    plausibility,
    rolling_notes,
    skew_notes,
)

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
    assert "the asperities carry the load" in found[0.9].meaning
    assert "the oil film carries part of the load" in found[1.3].meaning
    assert "film_ratio" not in roller()


def test_a_film_that_is_computed_asks_for_no_measured_friction():
    for ratio in (0.9, 1.3, 5.0):
        note = roller(film_ratio=ratio, with_film=True)["film_ratio"]
        assert "surfaces that touch" not in note.meaning
        assert "measured" not in (note.remedy or "")
    assert (
        "the rating life has no film factor" in roller(film_ratio=1.3, with_film=True)["film_ratio"].meaning
    )
    assert roller(film_ratio=5.0, with_film=True)["film_ratio"].remedy is None


def test_what_a_film_does_to_the_life_is_said():
    given = {"film_ratio": 1.3, "with_film": True}
    without = roller(**given)["film_ratio"]
    assert "state life.cleanliness" in without.remedy
    known = roller(**given, life_factor=0.4)["film_ratio"]
    assert "has its film factor" in known.meaning
    assert known.remedy == "make the surfaces smoother for a longer life"
    thin = roller(film_ratio=0.1, life_factor=NAN)["film_ratio"]
    assert "no rating life with so thin a film" in thin.meaning
    assert "film factor" in roller(film_ratio=5.0, life_factor=1.2)["film_ratio"].meaning
    assert "film factor" not in roller(film_ratio=5.0)["film_ratio"].meaning


def test_one_screen_has_one_advice_on_the_film():
    """Films of every band beside a drive that loses half of its power to the oil.

    No film asks for a thicker oil. Where a film is not full, the loss does not ask for a thinner one before both ask
    for smoother surfaces.
    """
    films = [roller(film_ratio=ratio)["film_ratio"].remedy for ratio in (0.18, 1.5, 5.0)]
    assert not any(re.findall(r"(thinner|thicker) oil", said) for said in films)
    for ratios in ((0.18, 5.0), (1.5, np.nan)):
        (loss,) = loss_notes(rolled(oil=(30.0, 60.0), creep=(1.0, 1.0), films=ratios), NAMES)
        assert "make the surfaces smoother and only then the oil thinner" in loss.remedy
        assert f"at λ {ratios[0]:g} a thinner oil or a lower speed shortens the life" in loss.remedy
    (full,), (unknown,) = (
        loss_notes(rolled(oil=(30.0, 60.0), creep=(1.0, 1.0), films=ratios), NAMES)
        for ratios in ((5.0, 4.0), (np.nan, np.nan))
    )
    assert full.remedy == f"{unknown.remedy}; keep λ above 3, below which the life falls"
    assert unknown.remedy.startswith("choose a thinner oil")
    smoother = (
        "make the surfaces smoother for a longer life; a thicker film also lowers the friction coefficient"
    )
    assert [said.endswith(smoother) for said in films] == [True, True, False]


def test_each_contact_has_its_own_numbers(planar_joint):
    """Length over diameter: 10/(2 * 10) at the sun, 50/(2 * 20) in the ring, by the smaller roller."""
    table = {
        'contact_length = "10 mm"': 'contact_length = { sp = "10 mm", pr = "50 mm" }',
        "friction_coefficient = 0.08": "friction_coefficient = { sp = 0.08, pr = 0.4 }",
    }
    found = plausibility(
        joint := planar_joint("planetary", table),
        SimpleNamespace(
            rolling=SimpleNamespace(
                film_ratio=np.array([np.nan, 5.0]), life_factor=np.full(2, np.nan), film=None
            ),
            contact_names=joint.contact_names,
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
        rolling=SimpleNamespace(film_ratio=np.full(2, np.nan), life_factor=np.full(2, np.nan), film=None),
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
        rolling=SimpleNamespace(film_ratio=np.full(2, np.nan), life_factor=np.full(2, np.nan), film=None),
        contact_names=("sp", "pr"),
    )
    assert len(plausibility(printed, result)) == len(plausibility(planar_joint("planetary"), result)) + 2


@pytest.mark.parametrize(
    ("torque", "capacity", "value", "ok"),
    [
        (10.0, 12.5, 0.8, True),
        (-10.0, 8.0, 1.25, False),
        (10.0, 0.0, np.inf, False),
        (10.0, np.inf, 0.0, True),
    ],
)
def test_a_joint_that_turns_must_roll_under_its_torque(torque, capacity, value, ok):
    """Standing it may carry more: a torque between both capacities is no joint that works."""
    joint = SimpleNamespace(output_torque=torque, input_speed=1.0)
    (note,) = rolling_notes(joint, capacity)
    assert (note.value, note.ok, note.severity, note.remedy is None) == (value, ok, "function", ok)
    assert rolling_notes(SimpleNamespace(output_torque=torque, input_speed=0.0), capacity) == ()
    assert rolling_notes(SimpleNamespace(output_torque=0.0, input_speed=1.0), capacity) == ()


NAMES = ("sp", "pr")


def rolled(*, output=60.0, bearings=0.0, films=(np.nan, np.nan), **losses):
    """Powers [W] of a drive with two contacts; by energy conservation what enters is what leaves and all losses."""
    each = {
        name: np.array(losses.get(name, (np.nan, np.nan))) for name in ("creep", "skew", "hysteresis", "oil")
    }
    lost = sum(np.nansum(value) for value in each.values()) + bearings
    power = SimpleNamespace(**each, bearings=bearings, loss=lost, input=output + lost, output=output)
    return SimpleNamespace(power=power, film_ratio=np.array(films))


@pytest.mark.parametrize(
    ("losses", "said", "remedy"),
    [
        ({"oil": (10, 20), "creep": (9, 1)}, "30 W of them by the oil at the inlet of the contacts, most at pr", "oil"),
        ({"oil": (1, 2), "creep": (36, 1)}, "37 W of them by the creep of the contacts, most at sp", "preload"),
        ({"bearings": 39, "creep": (1, 0)}, "39 W of them by bearings and pins", "less friction"),
        ({"skew": (0, 40), "creep": (0, 0)}, "40 W of them by the skew of the rollers, most at pr", "align"),
    ],
)  # fmt: skip
def test_the_main_cause_is_named(losses, said, remedy):
    (note,) = loss_notes(rolled(**losses), NAMES)
    assert (note.ok, note.severity, note.state) == (False, "state", "large losses")
    assert note.value == pytest.approx(0.4)
    assert note.meaning == f"40 W of the 100 W input power are lost, {said}"
    assert remedy in note.remedy


def test_a_third_is_the_bound():
    (kept,) = loss_notes(rolled(output=67.0, creep=(33.0, 0.0)), NAMES)
    (crossed,) = loss_notes(rolled(output=66.0, creep=(34.0, 0.0)), NAMES)
    assert (kept.ok, kept.remedy, crossed.ok) == (True, None, False)


@pytest.mark.parametrize("output", [0.0, np.nan])
def test_a_drive_that_passes_no_power_has_no_share(output):
    assert loss_notes(rolled(output=output, oil=(1.0, 1.0)), NAMES) == ()


def skewed(ratios, losses):
    return SimpleNamespace(slip_ratio=np.array(ratios), capacity_loss=np.array(losses))


def test_skew_that_leaves_too_little_friction_is_a_warning():
    (kept,) = skew_notes(skewed([0.5, 0.9], [0.0, 0.3]), NAMES)
    (crossed,) = skew_notes(skewed([1.4, 0.9], [0.5, 0.3]), NAMES)
    assert (kept.ok, kept.contact, kept.value) == (True, "pr", 0.9)
    assert (crossed.ok, crossed.contact, crossed.severity) == (False, "sp", "function")
    assert "slips as a whole" in crossed.meaning
    assert crossed.remedy.startswith("align the axes")


@pytest.mark.parametrize("ratio", [np.inf, np.nan])  # of some traction, and of none
def test_skew_that_takes_all_friction_is_a_warning(ratio):
    (crossed,) = skew_notes(skewed([0.5, ratio], [0.9, 1.0]), NAMES)
    assert (crossed.ok, crossed.contact, crossed.value) == (False, "pr", np.inf)


@pytest.mark.parametrize(("ratios", "losses"), [([1.4, 0.9], [0.0, 0.0]), ([np.nan, 0.9], [0.1, 0.1])])
def test_without_skew_or_without_a_state_there_is_no_note(ratios, losses):
    assert skew_notes(skewed(ratios, losses), NAMES) == ()

"""Safety margins: the worst place of every requirement, by numbers that are known without the table."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.results import SEVERITIES, Limit, Result
from asperity.results import margins as module
from asperity.results.margins import margins
from asperity.results.notes import Note, contact_notes
from asperity.unit_table import Dimension
from asperity.zou2025.kinematics import CONTACT_NAMES


def row(name, value, *, axis="one", limit=None, lowest=-math.inf):
    return Result(
        name, name, Dimension.DIMENSIONLESS, "1", value, axis=axis, limit=limit, lowest_limit=lowest
    )


def limit(severity, **bounds):
    return Limit(severity, "kept", "crossed", "remedy", **bounds)


CLEARANCES = ("planet_to_planet", "left_to_right")
STANDS = SimpleNamespace(input_speed=0.0, rolling=SimpleNamespace(duty=()))
ROWS = (
    row("model", "a", axis="contact", limit=limit("model", highest=1.0)),
    row("slip", "a", axis="contact", limit=limit("function", highest=2.0)),
    row("load", "a", axis="contact", limit=limit("function", lowest=0.1)),
    row("range", "b", limit=limit("accuracy", lowest=1.0, highest=2.0, inclusive=True)),
    row("clearance", "gaps", axis="clearance", lowest=0.0),
    row("torque_safety", "b", lowest=1.0),
    row("band", "a", axis="contact", limit=limit("accuracy", lowest=1.0, highest=1.6)),
    row("no limit", "a", axis="contact"),
)


@pytest.fixture
def found(monkeypatch):
    monkeypatch.setattr(module, "results_of_joint", lambda solved: {each.name: each for each in ROWS})
    solved = SimpleNamespace(
        joint=STANDS,
        required_life=None,
        over_turn=None,
        notes=(),
        a=np.array([0.5, 1.5, 0.2, 1.0, 0.4]),
        b=2.0,
        gaps=np.arange(2.0) - 1.0,
        row_names=lambda axis: CLEARANCES if axis == "clearance" else CONTACT_NAMES,
    )
    return {each.result.name: each for each in margins(solved)}


def test_the_worst_place_of_each_requirement(found):
    places = {name: (each.place, each.actual, each.passes) for name, each in found.items()}
    assert places == {
        "slip": ("pwr", 1.5, True),
        "load": ("pwl", 0.2, True),
        "clearance": ("planet_to_planet", -1.0, False),
        "torque_safety": ("", 2.0, True),
        "range": ("", 2.0, True),  # the bounds are included
        "band": ("pwl", 0.2, False),  # farther below than any is above
        "model": ("pwr", 1.5, False),
    }
    assert list(found) == list(places)  # the most serious first


def test_share_of_the_limit_that_is_used(found):
    assert found["slip"].utilisation == pytest.approx(0.75)
    assert found["load"].utilisation == pytest.approx(0.5)
    assert found["torque_safety"].utilisation == pytest.approx(0.5)
    assert math.isnan(found["range"].utilisation)
    assert math.isnan(found["clearance"].utilisation)


@pytest.mark.parametrize(
    ("values", "place", "outcome"),
    [
        ([0.5, np.nan, 0.2, 1.0, 0.4], "pwr", "unknown"),
        ([0.5, np.nan, 0.2, 5.0, 0.4], "wro", "FAIL"),  # what is not known does not hide what fails
        ([0.5, np.nan, 0.2, np.inf, 0.4], "wro", "FAIL"),
    ],
)
def test_what_is_not_known_does_not_pass(monkeypatch, values, place, outcome):
    monkeypatch.setattr(module, "results_of_joint", lambda solved: {"slip": ROWS[1]})
    (found,) = margins(
        SimpleNamespace(
            joint=STANDS,
            required_life=None,
            over_turn=None,
            notes=(),
            a=np.array(values),
            row_names=lambda axis: CONTACT_NAMES,
        )
    )
    assert (found.place, found.passes, found.outcome) == (place, False, outcome)


def test_an_infinite_safety_factor_passes(monkeypatch):
    monkeypatch.setattr(module, "results_of_joint", lambda solved: {"torque_safety": ROWS[5]})
    (found,) = margins(
        SimpleNamespace(joint=STANDS, required_life=None, over_turn=None, notes=(), b=math.inf)
    )
    assert (found.actual, found.passes, found.utilisation) == (math.inf, True, 0.0)


def test_of_notes_of_one_name_the_farthest_beyond_its_limit_or_the_nearest_to_it_counts(monkeypatch):
    monkeypatch.setattr(module, "results_of_joint", lambda solved: {})

    def worst(*notes):
        made = tuple(Note("x", "x", place, *rest, "model", "", None) for place, *rest in notes)
        (found,) = margins(SimpleNamespace(joint=STANDS, notes=made, required_life=None, over_turn=None))
        return found.place, found.lowest, found.highest

    assert worst(("a", 1.5, 1.0, False), ("b", 0.1, 1.0, False)) == ("b", 1.0, math.inf)
    assert worst(("a", 1.5, 1.0, False), ("b", 0.6, 1.0, False)) == ("a", -math.inf, 1.0)
    assert worst(("a", 0.5, 1.0, True), ("b", 0.9, 2.0, True)) == ("a", -math.inf, 1.0)
    assert worst(("a", 0.5, 1.0, True), ("b", 0.1, 0.4, False))[0] == "b"


def test_a_thicker_film_is_never_ranked_the_worse(monkeypatch):
    """By severity and by the share of its limit, over all bands of Tallian."""
    monkeypatch.setattr(module, "results_of_joint", lambda solved: {})
    sizes = {"contact_length": 0.01, "smaller_radius": 0.01, "effective_radius": 0.2}
    given = {"friction_coefficient": 0.12, "contact_factor_model": "unity", **sizes}
    ranks = []
    for film in (0.05, 0.18, 0.99, 1.01, 2.9, 3.1, 10.0):
        notes = tuple(contact_notes("sp", film_ratio=film, **given))
        (found,) = (
            each
            for each in margins(
                SimpleNamespace(joint=STANDS, required_life=None, over_turn=None, notes=notes)
            )
            if each.result.name == "film_ratio"
        )
        ranks.append((SEVERITIES.index(found.severity), -found.utilisation))
    assert ranks == sorted(ranks)
    assert len({severity for severity, _ in ranks}) == 1


def test_notes_are_requirements_at_the_contact_where_they_are_met_worst(monkeypatch):
    """Oil films of half and twice the roughness; a friction of 0.12 where 0.3 is usual; a roller of 200 mm radius."""
    monkeypatch.setattr(module, "results_of_joint", lambda solved: {})
    sizes = {"contact_length": 0.01, "smaller_radius": 0.01, "effective_radius": 0.2}
    notes = [
        note
        for name, film in (("sp", 0.5), ("pr", 2.0))
        for note in contact_notes(
            name, friction_coefficient=0.12, film_ratio=film, contact_factor_model="printed", **sizes
        )
    ]
    found = {
        each.result.name: each
        for each in margins(
            SimpleNamespace(joint=STANDS, required_life=None, over_turn=None, notes=tuple(notes))
        )
    }
    film = found["film_ratio"]
    assert (film.place, film.actual, film.lowest, film.passes) == ("sp", 0.5, 3.0, False)  # the thinner one
    assert (film.severity, film.state, film.outcome) == ("state", *["boundary lubrication"] * 2)
    assert found["friction_coefficient"].utilisation == pytest.approx(0.4)
    size = found["contact_factor_size"]
    assert (size.severity, size.passes, size.result.display_unit, size.actual) == ("model", False, "mm", 0.2)
    assert list(found)[-1] == "contact_factor_size"  # the least serious

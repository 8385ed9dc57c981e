"""Whether a joint works, in words and as three answers, from requirements that are written out here."""

import math
from dataclasses import replace

import pytest

from asperity.results import Limit, Result
from asperity.results.margins import Margin, verdict_document
from asperity.unit_table import Dimension
from asperity.views.joint import verdict_words

MET = "every requirement of function and strength is met."
RING = "held ring fatigue (enter fatigue_strength of material 440C)"
STEEL, LIBRARY = ({"held_ring": {"yield_safety": 3.0, "fatigue_safety": safety}} for safety in (1.5, None))
OUTSIDE = "Outside the model's range until these are resolved"


def margin(name, place, actual, *, passes=True, severity="function", missing=""):
    limit = Limit(severity, "kept", "crossed", "remedy", highest=1.0, missing=missing)
    result = Result(name, f"label of {name}", Dimension.DIMENSIONLESS, "1", "a", limit=limit)
    return Margin(result, place, actual, -math.inf, 1.0, passes, severity)


KEPT = margin("a", "sp", 0.5)
FULLER = margin("d", "", 0.75, severity="damage")
FAILED = margin("b", "held_ring", 2.0, passes=False)
DAMAGED = replace(FAILED, severity="damage")
OPEN = margin("c", "", math.nan, passes=False)
DOUBT = margin("e", "sp", 2.0349, passes=False, severity="accuracy")
B = "label of b 2 at held ring, at most 1"


@pytest.mark.parametrize(
    ("found", "rims", "title", "works", "holds", "words"),
    [
        ([KEPT], STEEL, "Works", True, True, MET),
        ([KEPT], LIBRARY, "Works, one check missing", True, None, f"{RING}."),
        ([KEPT, OPEN], LIBRARY, "Works, 2 checks missing", None, None, f"label of c, {RING}."),
        ([KEPT, FAILED], STEEL, "Fails", False, True, f"{B}."),
        ([KEPT, DAMAGED], STEEL, "Is damaged", True, False, f"{B}."),
        ([DAMAGED], LIBRARY, "Is damaged", True, False, f"{B}. Not checked: {RING}."),
        ([FAILED, OPEN], LIBRARY, "Fails", False, None, f"{B}. Not checked: label of c, {RING}."),
        ([FAILED, DAMAGED], STEEL, "Fails", False, False, f"{B}. Damaged: {B}."),
        ([KEPT, DOUBT], STEEL, OUTSIDE, None, None, "label of e 2.03 at sp, at most 1."),
        (
            [DAMAGED, FAILED, DOUBT, OPEN],
            STEEL,
            "Fails",
            False,
            False,
            f"{B}. Damaged: {B}. {OUTSIDE}: label of e 2.03 at sp, at most 1. Not checked: label of c.",
        ),
    ],
)
def test_what_fails_comes_before_what_is_not_known(found, rims, title, works, holds, words):
    verdict = verdict_document(found, rims, {"held_ring": "440C"})
    assert verdict["title"] == title
    assert (verdict["works"], verdict["holds"], verdict["words"]) == (works, holds, words)


def test_an_accuracy_that_is_not_known_is_a_check_that_is_missing():
    verdict = verdict_document([KEPT, replace(OPEN, severity="accuracy")], STEEL)
    assert (verdict["title"], verdict["words"]) == ("Works, one check missing", "label of c.")


@pytest.mark.parametrize(
    ("actual", "title", "works", "words"),
    [
        (0.5, "Works, one check missing", None, "label of f (no film factor, λ 0.18)."),
        (2.0, "Fails", False, "label of f 2, at most 1 (no film factor, λ 0.18)."),
    ],
)
def test_a_value_that_lacks_something_may_fail_but_never_passes(actual, title, works, words):
    found = margin("f", "", actual, passes=False, missing="no film factor, λ 0.18")
    verdict = verdict_document([found], STEEL)
    assert (verdict["title"], verdict["works"], verdict["words"]) == (title, works, words)
    assert found.outcome == {0.5: "unknown", 2.0: "FAIL"}[actual]


def test_a_required_life_names_hours_and_what_is_required():
    row = Result(
        "required_drive_life",
        "rating life",
        Dimension.TIME,
        "h",
        "a",
        limit=Limit("function", "kept", "crossed", "remedy", lowest=3.6e7, missing="no film factor, λ 0.17"),
    )
    found = Margin(row, "", 6001.0 * 3600.0, 3.6e7, math.inf, False, "function")
    verdict = verdict_document([found], STEEL)
    assert f"{verdict['title']}: {verdict['words']}" == (
        "Fails: rating life 6,001 h, required 10,000 h (no film factor, λ 0.17)."
    )


def test_an_infinite_value_and_both_bounds_have_words():
    row = Result("b", "dimension", Dimension.DIMENSIONLESS, "1", "a", limit=Limit("accuracy", "", "", ""))
    assert Margin(row, "", math.inf, 1.1, 1.9, False, "accuracy").words == "dimension infinite, 1.1 to 1.9"


def test_what_uses_most_of_its_limit_is_the_tightest_margin():
    assert verdict_document([KEPT, FULLER, FAILED, OPEN], STEEL)["nearest"] == {
        "label": "label of d",
        "place": None,
        "share_of_limit": 0.75,
        "words": "label of d, 75 % of its limit",
    }
    assert verdict_document([KEPT], STEEL)["nearest"]["place"] == "sp"
    assert verdict_document([FAILED], STEEL)["nearest"] is None
    almost = verdict_document([margin("a", "sp_2", 0.9967)], STEEL)["nearest"]["words"]
    assert almost == "label of a at sp 2, 99.67 % of its limit"  # never rounded to its limit


def test_a_share_has_the_names_of_its_result_and_a_least_value_its_bound():
    torque = Result("torque", "safety", Dimension.DIMENSIONLESS, "1", "a", used=("torque", "capacity"))
    of_capacity = Margin(torque, "", 1.0 / 0.812, 1.0, math.inf, True, "function")
    assert of_capacity.tightness == "torque, 81 % of capacity"
    safety = replace(of_capacity, result=replace(torque, used=()))
    assert safety.tightness == "safety 1.23, at least 1"


def test_the_verdict_is_said_with_its_tightest_margin():
    assert verdict_words(verdict_document([KEPT], STEEL)) == (
        f"Works: {MET} Tightest margin: label of a at sp, 50 % of its limit."
    )
    assert verdict_words(verdict_document([FAILED], STEEL)) == f"Fails: {B}."

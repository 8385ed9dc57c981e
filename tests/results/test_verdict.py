"""Whether a joint works, in words and as three answers, from requirements that are written out here."""

import math
from dataclasses import replace

import pytest

from asperity.results import Limit, Result
from asperity.results.margins import Margin, verdict_document
from asperity.unit_table import Dimension

START = "Requirements of function and strength that are not"
RING = "safety of the held ring against fatigue (no fatigue_strength of its material)"
STEEL, LIBRARY = ({"held_ring": {"yield_safety": 3.0, "fatigue_safety": safety}} for safety in (1.5, None))


def margin(name, place, actual, *, passes=True, severity="function"):
    limit = Limit(severity, "kept", "crossed", "remedy", highest=1.0)
    result = Result(name, f"label of {name}", Dimension.DIMENSIONLESS, "1", "a", limit=limit)
    return Margin(result, place, actual, -math.inf, 1.0, passes, severity)


KEPT = margin("a", "sp", 0.5)
FULLER = margin("d", "", 0.75, severity="damage")
FAILED = margin("b", "held_ring", 2.0, passes=False)
DAMAGED = replace(FAILED, severity="damage")
OPEN = margin("c", "", math.nan, passes=False)


@pytest.mark.parametrize(
    ("found", "rims", "works", "holds", "words"),
    [
        ([KEPT], STEEL, True, True, "All requirements of function and strength are met."),
        ([KEPT], LIBRARY, True, None, f"{START} known: {RING}. All others of function and strength are met."),
        ([KEPT, FAILED], STEEL, False, True, f"{START} met: label of b (held ring)."),
        ([KEPT, DAMAGED], STEEL, True, False, f"{START} met: label of b (held ring)."),
        (
            [OPEN],
            STEEL,
            None,
            True,
            f"{START} known: label of c (drive). All others of function and strength are met.",
        ),
        (
            [FAILED, OPEN],
            LIBRARY,
            False,
            None,
            f"{START} met: label of b (held ring); not known: label of c (drive), {RING}.",
        ),
    ],
)
def test_the_verdict_names_what_fails_and_what_is_not_known(found, rims, works, holds, words):
    verdict = verdict_document(found, rims)
    title = {(True, True): "Works", (True, None): "Not known in full", (True, False): "Is damaged"}
    assert verdict["title"] == title.get(
        (works, holds), "Not known in full" if works is None else "Does not work"
    )
    assert (verdict["works"], verdict["holds"], verdict["words"]) == (works, holds, words)


def test_nothing_is_met_where_the_numbers_cannot_be_relied_on():
    crossed = margin("e", "sp", 2.0, passes=False, severity="accuracy")
    verdict = verdict_document([KEPT, crossed], STEEL)
    assert (verdict["works"], verdict["holds"]) == (None, None)
    assert verdict["words"].endswith(
        "The numbers cannot be relied on before these warnings are settled: label of e."
    )


def test_what_uses_most_of_its_limit_is_the_nearest():
    assert verdict_document([KEPT, FULLER, FAILED, OPEN], STEEL)["nearest"] == {
        "label": "label of d",
        "place": None,
        "share_of_limit": 0.75,
    }
    assert verdict_document([KEPT], STEEL)["nearest"]["place"] == "sp"
    assert verdict_document([FAILED], STEEL)["nearest"] is None

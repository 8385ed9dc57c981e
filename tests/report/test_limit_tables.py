"""Requirements and crossed limits in words, for margins and diagnostics that are written out here."""

import math
from dataclasses import replace

from asperity.report.content import Bullets, Paragraph, Table
from asperity.report.limit_tables import margins_table, warnings
from asperity.results import Limit, Result
from asperity.results.margins import Margin
from asperity.unit_table import Dimension


def margin(name, place, actual, *, lowest=-math.inf, highest=math.inf, passes=True, inclusive=False):
    limit = Limit(
        "function", "kept", "crossed", "remedy", lowest=lowest, highest=highest, inclusive=inclusive
    )
    result = Result(name, f"label of {name}", Dimension.DIMENSIONLESS, "1", "a", limit=limit)
    return Margin(result, place, actual, lowest, highest, passes, "function")


def test_required_actual_and_result_of_each_margin():
    found = (
        margin("a", "sp", 1.25, highest=1.0, passes=False),
        margin("b", "roller_in_ring", 0.5, lowest=0.125),
        margin("c", "", 1.5, lowest=1.0, highest=2.0, inclusive=True),
        margin("d", "", math.nan, highest=1.0, passes=False),
    )
    sentence, table = margins_table(found)
    assert isinstance(sentence, Paragraph)
    assert isinstance(table, Table)
    assert [tuple(row) for row in table.rows] == [
        ("label of a", "function", "sp", "< 1", "1.25", "FAIL"),
        ("label of d", "function", "", "< 1", "–", "unknown"),
        ("label of b", "function", "roller in ring", "> 0.125", "0.5", "pass"),
        ("label of c", "function", "", "≥ 1 and ≤ 2", "1.5", "pass"),
    ]


def test_what_is_not_met_stands_first_and_then_the_fullest():
    """Shares of their limits: a 0.2, c 0.9, f -5 (no share is too small), g none."""
    found = (
        margin("a", "", 0.2, highest=1.0),
        margin("g", "", 1.5, lowest=1.0, highest=2.0),
        margin("f", "", -5.0, highest=1.0),
        margin("b", "", 1.1, highest=1.0, passes=False),
        margin("c", "", 0.9, highest=1.0),
        replace(margin("d", "", 9.0, highest=1.0, passes=False), severity="model"),
        margin("e", "", math.nan, highest=1.0, passes=False),
    )
    _, table = margins_table(found)
    assert [row[0][-1] for row in table.rows] == ["b", "d", "e", "c", "a", "f", "g"]
    assert [row[-1] for row in table.rows] == ["FAIL", "FAIL", "unknown", *["pass"] * 4]


def entry(name, contact, value, ok, meaning):
    return {
        "name": name, "label": f"label of {name}", "contact": contact, "value": value, "limit": 1.0, "ok": ok,
        "known": True, "severity": "damage", "meaning": meaning, "remedy": "less load",
        "shown": "infinite" if value is None else f"{value:g}", "limit_shown": "1",
    }  # fmt: skip


def test_contacts_that_cross_one_limit_share_a_sentence():
    crossed = [
        entry("pressure", "sp", 2.0, False, "it yields"),
        entry("pressure", "pwr", 1.5, False, "it yields"),
        entry("pressure", "pwl", 0.5, True, ""),
        entry("angle", None, 3.0, False, "it slips"),
    ]
    (bullets,) = warnings({"diagnostics": crossed})
    assert isinstance(bullets, Bullets)
    assert list(bullets.items) == [
        "label of pressure: 2 sp, 1.5 pwr (limit 1; the joint is damaged). Meaning: it yields. What to do: less load.",
        "label of angle: 3 (limit 1; the joint is damaged). Meaning: it slips. What to do: less load.",
    ]


def test_an_infinite_value_is_no_dash():
    crossed = entry("ratio", "sp", None, False, "it slips")
    (bullets,) = warnings({"diagnostics": [crossed]})
    assert bullets.items[0].startswith("label of ratio: infinite sp (limit 1;")
    (_, table) = margins_table([margin("ratio", "sp", math.inf, highest=1.0, passes=False)])
    assert table.rows[0][4] == "infinite"


def test_no_warning_is_a_sentence():
    law = entry("largest_spot", "sp", 2.0, False, "it is large") | {"severity": "model"}
    (said,) = warnings({"diagnostics": [entry("pressure", "sp", 0.5, True, ""), law]})
    assert said.text == "No warnings: all limits are met."


def test_a_life_without_a_film_factor_never_passes():
    """Longer than required it is not judged; shorter it fails."""
    lacks = Limit("function", "kept", "crossed", "less load", lowest=1.0, missing="no film factor, λ 0.18")
    row = Result("required_drive_life", "rating life", Dimension.DIMENSIONLESS, "1", "a", limit=lacks)
    found = [Margin(row, "", life, 1.0, math.inf, False, "function") for life in (2.0, 0.5)]
    _, table = margins_table(found)
    assert [(row[0], row[-1]) for row in table.rows] == [
        ("rating life (no film factor, λ 0.18)", "FAIL"),
        ("rating life (no film factor, λ 0.18)", "unknown"),
    ]
    open_ = entry("life", None, 2.0, False, "not judged: no film factor") | {"known": False, "remedy": None}
    (bullets,) = warnings({"diagnostics": [open_]})
    assert list(bullets.items) == [
        "label of life: 2 (limit 1; not checked). Meaning: not judged: no film factor."
    ]

"""What is required and reached, and what is crossed: margins and warnings."""

import math
from dataclasses import replace

import pytest

from asperity.results import RESULTS, Limit, Result
from asperity.results.margins import Margin
from asperity.results.margins import margins as judged
from asperity.unit_table import Dimension
from asperity.views.blocks import Paragraph, Table, Warnings
from asperity.views.limits import crossed_limits, margins, warnings


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
    sentence, table = margins(found)
    assert isinstance(sentence, Paragraph)
    assert isinstance(table, Table)
    assert table.verdicts
    assert [tuple(row) for row in table.rows] == [
        ("label of a", "function", "sp", "< 1", "1.25", "FAIL"),
        ("label of d", "function", "", "< 1", "–", "unknown"),
        ("label of b", "function", "roller in ring", "> 0.125", "0.5", "pass"),
        ("label of c", "function", "", "≥ 1 and ≤ 2", "1.5", "pass"),
    ]


def test_what_is_not_met_stands_first_and_then_the_fullest():
    """Shares of their limits: a 0.2, c 0.9, f -5 (no share is too small), g none; d is no limit of the joint."""
    found = (
        margin("a", "", 0.2, highest=1.0),
        margin("g", "", 1.5, lowest=1.0, highest=2.0),
        margin("f", "", -5.0, highest=1.0),
        margin("b", "", 1.1, highest=1.0, passes=False),
        margin("c", "", 0.9, highest=1.0),
        replace(margin("d", "", 9.0, highest=1.0, passes=False), severity="model"),
        margin("e", "", math.nan, highest=1.0, passes=False),
    )
    _, table = margins(found)
    assert [row[0][-1] for row in table.rows] == ["b", "e", "c", "a", "f", "g", "d"]
    assert [row[-1] for row in table.rows] == ["FAIL", "unknown", *["pass"] * 4, "out of range"]
    shares = dict(zip((row[0][-1] for row in table.rows), table.shares, strict=True))
    assert (shares["a"], shares["c"], shares["e"]) == (pytest.approx(0.2), pytest.approx(0.9), None)


def test_residuals_of_the_equations_are_no_margins():
    """Neither of the force balance nor of the closure; a limit that they are beside stays."""
    solved = replace(margin("", "", 1e-12, highest=1e-9), result=RESULTS["balance_residual"])
    closed = replace(solved, result=RESULTS["closure_residual"])
    _, table = margins([solved, margin("a", "", 0.5, highest=1.0), closed])
    assert [row[0] for row in table.rows] == ["label of a"]


def test_an_infinite_value_is_no_dash():
    _, table = margins([margin("ratio", "sp", math.inf, highest=1.0, passes=False)])
    assert table.rows[0][4:] == ("infinite", "FAIL")
    assert table.shares == [None]


def test_a_state_of_the_joint_has_no_bound_and_stands_before_what_passes():
    held = Limit("state", "kept", "crossed", "remedy", highest=1.0, state="held by the pins")
    row = Result("slip", "slip of the rollers", Dimension.DIMENSIONLESS, "1", "a", limit=held)
    found = (
        margin("kept", "", 0.9, highest=1.0),
        Margin(row, "sp", 1.5, -math.inf, 1.0, False, "state"),
        margin("open", "", math.nan, highest=1.0, passes=False),
        margin("crossed", "", 2.0, highest=1.0, passes=False),
    )
    _, table = margins(found)
    assert [row[0].split()[-1] for row in table.rows] == ["crossed", "open", "rollers", "kept"]
    assert table.rows[2] == ("slip of the rollers", "state", "sp", "–", "1.5", "held by the pins")
    assert table.shares == [pytest.approx(2.0), None, None, pytest.approx(0.9)]


def test_a_life_without_a_film_factor_never_passes():
    """Longer than required it is not judged; shorter it fails."""
    lacks = Limit("function", "kept", "crossed", "less load", lowest=1.0, missing="no film factor, λ 0.18")
    row = Result("required_drive_life", "rating life", Dimension.DIMENSIONLESS, "1", "a", limit=lacks)
    found = [Margin(row, "", life, 1.0, math.inf, False, "function") for life in (2.0, 0.5)]
    _, table = margins(found)
    assert [(row[0], row[-1]) for row in table.rows] == [
        ("rating life (no film factor, λ 0.18)", "FAIL"),
        ("rating life (no film factor, λ 0.18)", "unknown"),
    ]


def test_margins_of_a_joint_have_the_units_of_their_limits(planetary_view):
    """The torque of 10 N·m over the capacity; slip T/(mu N) of the sun; three planets of 20 mm on a circle of 30 mm."""
    _, table = margins(judged(planetary_view.solved))
    rows = {row[0]: row for row in table.rows}
    # T = 10 N·m/6 on three contacts at 10 mm, standing; N from the tables, mu = 0.08
    normal = planetary_view.document["standing"]["forces"]["normal_N"]["sp"]
    slip = 10.0 / 6.0 / 3.0 / 10e-3 / (0.08 * normal)
    assert rows["slip ratio T/(mu N)"][2:] == ("sp", "< 1", f"{slip:.4g}", "pass")
    capacity = planetary_view.document["rolling"]["torque_capacity_Nm"]
    over = ("", "≤ 1", f"{10.0 / capacity:.4g}", "pass")
    assert rows["torque over rolling capacity"][2:] == over
    gap = 2.0 * 30.0 * math.sin(math.pi / 3.0) - 2.0 * 20.0
    (clearance,) = (row for name, row in rows.items() if "clearance" in name)
    assert clearance[2:] == ("planet to planet", "> 0 mm", f"{gap:.4g} mm", "pass")


def entry(name, contact, value, ok=False, severity="damage", **more):
    return {
        "name": name, "label": name.replace("_", " "), "contact": contact, "value": value, "limit": 1.0, "ok": ok,
        "known": True, "severity": severity, "meaning": f"meaning of {name}", "remedy": f"remedy of {name}",
        "shown": "infinite" if value is None else f"{value:g}", "limit_shown": "1",
    } | more  # fmt: skip


def test_contacts_of_one_limit_share_a_warning():
    diagnostics = [
        entry("slip_ratio", "sp", 1.2, severity="function"),
        entry("slip_ratio", "right_pair", 1.1, severity="function"),
        entry("slip_ratio", "pwl", 0.9, ok=True, severity="function"),
        *(entry("pressure", contact, 2.0) for contact in ("sp", "right_pair", "pwl")),
        entry("angle", None, 3.0, severity="accuracy"),
        entry("real_area", "sp", 6.54, severity="model"),
    ]
    shown = warnings({"diagnostics": diagnostics})
    assert isinstance(shown, Warnings)
    assert [(one.severity, one.about, one.text, one.meanings, one.remedy) for one in shown.items] == [
        (
            "function",
            "Fails",
            "slip ratio 1.2 at sp, 1.1 at right pair (limit 1)",
            ("meaning of slip_ratio",),
            "remedy of slip_ratio",
        ),
        (
            "damage",
            "Damage",
            "pressure 2 at every contact (limit 1)",
            ("meaning of pressure",),
            "remedy of pressure",
        ),
        (
            "accuracy",
            "Outside the model's range",
            "angle 3 (limit 1)",
            ("meaning of angle",),
            "remedy of angle",
        ),
    ]


def test_the_range_of_the_published_law_is_no_warning(paper_view):
    law = entry("largest_spot", "sp", 2.0, severity="model")
    said = warnings({"diagnostics": [entry("pressure", "sp", 0.5, ok=True), law]})
    assert said == Paragraph("No warnings: all limits are met.", strong=True)
    shown = warnings(paper_view.document)
    crossed = {
        each["label"]
        for each in paper_view.document["diagnostics"]
        if not each["ok"] and each["severity"] != "model"
    }
    assert len(shown.items) == len(crossed)
    assert all(any(one.text.startswith(f"{label} ") for one in shown.items) for label in crossed)


def test_what_is_not_checked_is_not_said_to_be_met():
    kept = {"diagnostics": [entry("pressure", "sp", 0.5, ok=True)]}
    for works, holds in ((None, True), (True, None), (None, None)):
        said = warnings(kept | {"verdict": {"works": works, "holds": holds}})
        assert said.text == "No warnings: no limit is crossed; what is not checked is said above."
    said = warnings(kept | {"verdict": {"works": True, "holds": True}})
    assert said.text == "No warnings: all limits are met."


def test_a_warning_says_a_value_that_is_infinite_and_a_limit_that_is_not_judged():
    kept = entry("ratio", "pr", 0.5, ok=True)
    (one,) = warnings({"diagnostics": [entry("ratio", "sp", None), kept]}).items
    assert one.text == "ratio infinite at sp (limit 1)"
    open_ = entry("life", None, 2.0, known=False, remedy=None, meaning="not judged: no film factor")
    (one,) = warnings({"diagnostics": [open_]}).items
    assert (one.about, one.text, one.meanings, one.remedy) == (
        "Not checked",
        "life 2 (limit 1)",
        ("not judged: no film factor",),
        "",
    )


def test_states_stand_in_place_of_limits_and_apart_from_each_other():
    plain = entry("slip", "sp", 1.0, state="at the limit", severity="state")
    beyond = entry("slip", "pr", 1.0, state="beyond the limit", severity="state")
    other = entry("slip", "pw", 0.1, ok=True, severity="state")
    shown = warnings({"diagnostics": [plain, beyond, other]})
    assert [(one.about, one.text) for one in shown.items] == [
        ("State", "slip 1 at sp (at the limit)"),
        ("State", "slip 1 at pr (beyond the limit)"),
    ]
    assert len(crossed_limits({"diagnostics": [plain, beyond]}, model=False)) == 2

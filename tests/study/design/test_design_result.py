"""A conflict in words: the limits that restrict, what is reached of them, and the variables at their bounds."""

from types import SimpleNamespace

from asperity.study.design.design_result import DesignResult, LimitReport, conflict


def limit(name, *, at_most, limit, value, missed_by=0.0, active=True, row="", label=""):
    return LimitReport(name, label or name, row, at_most, limit, value, missed_by, active, 0.5, False, 5.0)


def result(limits, at_bound=()):
    found = SimpleNamespace(limits=limits, at_bound=dict(at_bound), feasible=False)
    found.violation = DesignResult.violation.fget(found)
    return found


def test_a_limit_says_sense_value_share_and_torque():
    slip = limit(
        "slip_ratio",
        at_most=True,
        limit=0.5,
        value=0.55,
        missed_by=0.1,
        row="rollers_ring",
        label="friction used",
    )
    assert slip.text == "friction used at rollers ring at most 0.5 (reached 0.55, 10 % off, at 5 N·m)"
    kept = limit("preload", at_most=False, limit=400.0, value=410.0)
    assert kept.text == "preload at least 400 N (reached 410 N, at 5 N·m)"


def test_a_conflict_names_the_active_limits_and_the_bounds():
    slip = limit("slip_ratio", at_most=True, limit=0.5, value=0.55, missed_by=0.1)
    load = limit("preload", at_most=True, limit=400.0, value=416.0, missed_by=0.04)
    idle = limit("mass", at_most=True, limit=1.0, value=0.5, active=False)
    found = result((slip, load, idle), {"load.preload": "upper"})
    text = conflict(found)
    assert found.violation == 0.1
    assert text.startswith(
        "no design meets all limits; the best one misses a limit by 10 %. These limits conflict: "
    )
    assert slip.text in text
    assert load.text in text
    assert idle.text not in text
    assert text.endswith("; load.preload is at its upper bound. Relax one of these, or widen the bounds")
    assert "conflict:" not in conflict(result((slip,)))
    ratio = limit("speed_ratio", at_most=True, limit=-11.0, value=-10.8, missed_by=0.02, active=False)
    assert ratio.text in conflict(result((slip, load, idle, ratio))), (
        "a limit that another one outweighs is missed too"
    )
    assert DesignResult.violation.fget(SimpleNamespace(feasible=True)) == 0.0

"""Lives compared with the life that is required: from numbers made by hand, and by two routes in solved joints."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solved_case
from asperity.results import RESULTS
from asperity.results import all_limits as module
from asperity.results.all_limits import film_too_thin, further_checks, life_checks
from asperity.results.margins import margins
from asperity.rolling.conditions import DutyPoint

DUTY = (DutyPoint(5.0, 50.0, 0.5), DutyPoint(9.0, 100.0, 0.25), DutyPoint(-4.0, 0.0, 0.25))
BEARINGS = '\n[pin_bearing]\ntype = "roller"\ndynamic_rating = "8 kN"\nstatic_rating = "9 kN"\ncount = 1\n'
LOADS = (("10 N*m", "1500 rpm", 0.3), ("6 N*m", "3000 rpm", 0.5), ("8 N*m", "0 rpm", 0.2))


@pytest.fixture
def rows(monkeypatch):
    """Of all results those of bearings."""
    monkeypatch.setattr(module, "results_of_joint", lambda solved: RESULTS)


def solved(
    *,
    life=math.nan,
    under_duty=math.nan,
    duty=(),
    required=3600.0 * 500.0,
    films=(),
    of_loads=(math.nan,) * 3,
    cleanliness=None,
):
    rolling = SimpleNamespace(
        life_hours=SimpleNamespace(drive=life),
        duty_life_hours=under_duty,
        film_ratio=np.array(films),
        duty_film_ratios=np.array(of_loads),
    )
    joint = SimpleNamespace(rolling=SimpleNamespace(duty=duty, cleanliness=cleanliness), input_speed=1.0)
    return SimpleNamespace(
        joint=joint,
        result=SimpleNamespace(rolling=rolling, contact_names=("sp", "pr", "wr")[: len(films)]),
        required_life=required,
        over_turn=None,
        has_bearings=(False,) * 4,
        row_names=lambda axis: ("right", "left", "sun", "carrier"),
    )


@pytest.mark.usefixtures("rows")
def test_nothing_is_judged_where_nothing_is_required():
    assert life_checks(solved(life=10.0, required=None)) == ()


@pytest.mark.usefixtures("rows")
@pytest.mark.parametrize(("hours", "ok"), [(499.0, False), (500.0, True), (501.0, True)])
def test_a_life_is_compared_with_what_is_required(hours, ok):
    (check,) = life_checks(solved(life=hours, under_duty=7.0))
    assert (check.ok, check.known, check.limit, check.contact) == (ok, True, 1.8e6, None)
    assert check.value == pytest.approx(3600.0 * hours, rel=1e-15)
    assert check.result.label == "rating life"
    assert ("shorter" in check.meaning) is not ok
    assert check.rule.severity == "function"
    (check,) = life_checks(solved(life=1.0, under_duty=hours, duty=DUTY))
    assert check.ok is ok
    assert check.result.label == "rating life under the duty"


@pytest.mark.usefixtures("rows")
@pytest.mark.parametrize(
    ("films", "missing"),
    [
        ((math.nan, 0.16, 4.0), "no film factor, λ 0.16"),  # boundary lubrication
        ((1.2, 4.0), "no film factor, λ 1.2"),  # mixed
        ((3.5, 4.0), ""),
        ((math.nan,), ""),
    ],
)
def test_a_life_in_a_thin_film_may_be_too_short_but_is_never_met(films, missing):
    (long,), (short,) = (life_checks(solved(life=life, films=films)) for life in (600.0, 400.0))
    assert (long.ok, long.known) == (not missing, not missing)
    assert (short.ok, short.known) == (False, True)
    assert long.rule.missing == short.rule.missing == missing
    assert ("a_ISO" in long.rule.remedy) is bool(missing)
    assert long.meaning == (f"not judged: {missing}" if missing else long.rule.kept)
    assert short.meaning == short.rule.crossed


@pytest.mark.usefixtures("rows")
def test_a_life_with_its_film_factor_is_judged_in_any_film():
    for films in ((0.3, 4.0), (1.2,), (3.5,)):
        (long,), (short,) = (
            life_checks(solved(life=life, films=films, cleanliness=0.5)) for life in (600.0, 400.0)
        )
        assert (long.ok, long.known, short.ok, short.known) == (True, True, False, True)
        assert long.rule.missing == ""


@pytest.mark.usefixtures("rows")
def test_under_a_duty_the_films_under_its_loads_count():
    """The load at rest has no film; the film under the joint's own torque is no part of its duty."""
    given = {"under_duty": 600.0, "duty": DUTY, "films": (0.5,)}
    (thin,) = life_checks(solved(**given, of_loads=(3.5, 2.0, math.nan)))
    (full,) = life_checks(solved(**given, of_loads=(3.5, 4.0, math.nan)))
    assert (thin.known, thin.rule.missing) == (False, "no film factor, λ 2")
    assert (full.ok, full.rule.missing) == (True, "")


@pytest.mark.usefixtures("rows")
def test_a_film_too_thin_for_a_factor_is_the_reason_why_a_life_is_unknown():
    (check,) = life_checks(solved(films=(0.16, 0.5), cleanliness=0.5))
    assert (check.ok, check.known) == (False, False)
    assert "to compare with the required life: at sp κ = λ^1.3 is below 0.1" in check.meaning
    (duty,) = life_checks(solved(duty=DUTY, of_loads=(0.5, 0.1, math.nan), cleanliness=0.5))
    assert "under load 2 κ" in duty.meaning
    thin, thick = (solved(films=(ratio, 2.0), cleanliness=0.5) for ratio in (0.16, 0.18))
    assert (bool(film_too_thin(thin)), bool(film_too_thin(thick))) == (True, False)
    assert not film_too_thin(solved(films=(0.16,)))


@pytest.mark.usefixtures("rows")
def test_a_joint_that_stands_or_slips_has_no_life_to_compare():
    (check,) = life_checks(solved())
    assert not check.ok
    assert not check.known
    assert "no rating life to compare" in check.meaning
    assert "slips, exceeds the shakedown limit, or stands" in check.meaning


@pytest.mark.usefixtures("rows")
def test_a_duty_that_the_joint_does_not_carry_is_the_reason_why_its_life_is_unknown():
    (check,) = life_checks(solved(life=600.0, duty=DUTY))
    assert not check.ok
    assert check.meaning.endswith("a load of the [[duty]] is not carried")


@pytest.fixture(scope="module")
def text(zou_file):
    return zou_file.with_name("planetary.toml").read_text(encoding="utf-8") + BEARINGS


def with_life(text, hours, *, duty=LOADS, branches=0):
    loads = "".join(
        f'\n[[duty]]\noutput_torque = "{torque}"\nsun_speed = "{speed}"\nshare = {share}\n'
        for torque, speed, share in duty
    )
    return f'{text}\n[rolling]\nrequired_life = "{hours} h"\n' + loads + branches * "\n[[branch]]\n"


def solved_text(text):
    return solved_case(parse_case(text, source="mine.toml"))


@pytest.mark.long
def test_margins_of_drive_and_bearings_are_in_the_list(text):
    joint = solved_text(with_life(text, 1000.0))
    found = {each.result.name: each for each in margins(joint)}
    drive, bearing = found["required_duty_life"], found["required_bearing_duty_life"]
    assert drive.actual == pytest.approx(3600.0 * float(joint.result.rolling.duty_life_hours), rel=1e-15)
    assert bearing.actual == float(np.nanmin(joint.bearings.duty_life))
    assert bearing.place == "planet_pin"
    assert (drive.lowest, drive.highest, drive.severity, drive.result.display_unit) == (
        3.6e6,
        math.inf,
        "function",
        "h",
    )
    assert drive.utilisation == pytest.approx(3.6e6 / drive.actual)
    without = with_life(text, 1000.0).replace('required_life = "1000.0 h"', "")
    without = {each.result.name for each in further_checks(solved_text(without))}
    assert not any(name.startswith("required") for name in without)


@pytest.mark.long
@pytest.mark.parametrize(
    "duty",
    [pytest.param(LOADS, id="duty", marks=pytest.mark.long), pytest.param((), id="no duty")],
)
def test_branches_without_deviations_live_as_long_as_equal_ones(text, duty):
    """One has three planets in three places, the other one planet that counts three times."""
    alike, own = (
        life_checks(solved_text(with_life(text, 1.0, duty=duty, branches=each)))[0] for each in (0, 3)
    )
    assert own.value == pytest.approx(alike.value, rel=1e-7)

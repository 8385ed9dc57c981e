import dataclasses
import math

import numpy as np
import pytest

from asperity.joint.diagnostics import Diagnostics
from asperity.results import SEVERITIES
from asperity.results.limit_check import checked_limits
from asperity.results.solved import SolvedJoint, solved_with_capacities


@pytest.fixture(scope="module")
def solved(solved_paper):
    return solved_with_capacities(*solved_paper)


@pytest.fixture(scope="module")
def paper(solved):
    return checked_limits(solved)


def by_name(entries, name):
    return {entry.contact: entry for entry in entries if entry.result.name == name}


def test_every_limit_is_listed_for_every_contact(solved, paper):
    names = {entry.result.name for entry in paper}
    near = solved.result.diagnostics
    there = {name for name in Diagnostics.__dataclass_fields__ if getattr(near, name) is not None}
    without_limit = {"hertz_half_width", "hertz_pressure"}
    others = {
        "balance_residual",
        "closure_residual",
        "fractal_dimension",
        "shakedown_ratio",
        "self_locking_ratio",
    }
    assert names == there - without_limit | others
    assert set(by_name(paper, "slip_ratio")) == {"sp", "pwr", "pwl", "wro", "wlo"}
    assert set(by_name(paper, "self_locking_ratio")) == {None}
    assert all(entry.meaning for entry in paper)


def test_the_most_serious_limits_come_first(paper):
    ranks = [SEVERITIES.index(entry.rule.severity) for entry in paper]
    assert ranks == sorted(ranks)
    assert len(set(ranks)) == 5


def test_the_facts_about_the_paper_s_joint(paper):
    """tan(beta/2) = 0.1153 with mu = 0.12; twice first yield at the sun; A_r beyond 2bB."""
    locking = by_name(paper, "self_locking_ratio")[None]
    assert locking.value == pytest.approx(0.1153 / 0.12, rel=1e-3)
    assert locking.ok
    sun = by_name(paper, "pressure_over_first_yield")["sp"]
    assert sun.value == pytest.approx(1.53e9 / (1.67 * 450e6), rel=2e-3)
    assert not sun.ok
    assert (sun.limit, sun.rule.severity) == (1.0, "damage")
    assert not by_name(paper, "real_area_over_hertz_area")["sp"].ok
    assert not by_name(paper, "asperity_over_bulk_stiffness")["sp"].ok
    for name in ("slip_ratio", "normal_force_over_preload", "fractal_dimension", "balance_residual"):
        assert all(entry.ok for entry in by_name(paper, name).values()), name


def test_an_undefined_value_is_not_ok(solved):
    """A lifted contact has no stiffness to compare."""
    near = solved.result.diagnostics
    lifted = dataclasses.replace(
        near,
        normal_force_over_preload=np.zeros(5),
        asperity_over_bulk_stiffness=np.full(5, math.nan),
    )
    result = dataclasses.replace(solved.result, diagnostics=lifted)
    entries = checked_limits(SolvedJoint(solved.joint, result, None))
    lifted = by_name(entries, "normal_force_over_preload")["sp"]
    assert (lifted.value, lifted.ok) == (0.0, False)
    undefined = by_name(entries, "asperity_over_bulk_stiffness")["sp"]
    assert math.isnan(undefined.value)
    assert not undefined.ok
    assert undefined.meaning.startswith("no value here: the contact slips, has lifted off")

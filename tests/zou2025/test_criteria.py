"""The measures behind the verdicts, on curves whose answer is known."""

import numpy as np
import pytest

from asperity.zou2025 import criteria
from asperity.zou2025.criteria import Claim, Statement

X = np.linspace(0.0, 10.0, 101)


def test_rises_and_falls_require_every_step() -> None:
    assert criteria.rises(X)
    assert not criteria.rises(-X)
    assert criteria.falls(-X)
    assert not criteria.falls(np.array([3.0, 2.0, 2.0]))
    assert not criteria.rises(np.array([[1.0, 2.0], [2.0, 1.0]]))


def test_relative_change() -> None:
    np.testing.assert_allclose(
        criteria.relative_change(np.array([[2.0, 9.0, 3.0], [4.0, 0.0, 2.0]])), [0.5, -0.5]
    )


def test_slope_change_of_a_line_and_of_a_parabola() -> None:
    assert criteria.slope_change(X, 3.0 - 2.0 * X) == pytest.approx(0.0, abs=1e-12)
    assert criteria.slope_change(X, X**2) == pytest.approx(18.0 / 19.0)  # mean slopes 1 and 19
    assert criteria.slope_change(X, -(X**2)) == pytest.approx(18.0 / 19.0)


def test_nearly_straight_curves_are_not_called_nonlinear() -> None:
    share = X / X[-1]
    assert criteria.slope_change(X, share + 0.04 * share**2) < criteria.NONLINEAR.limit  # 1 % off its chord
    assert criteria.slope_change(X, share**0.8) > criteria.NONLINEAR.limit


def test_peak_between_samples() -> None:
    assert criteria.peak(X, 7.0 - (X - 4.237) ** 2) == pytest.approx(4.237)


def test_peak_at_an_end_is_that_end() -> None:
    assert criteria.peak(X, X) == 10.0
    assert criteria.peak(X, -X) == 0.0


def test_relative_difference_does_not_care_for_order() -> None:
    assert criteria.relative_difference(np.array(8.0), np.array(10.0)) == pytest.approx(0.2)
    assert criteria.relative_difference(np.array(10.0), np.array(8.0)) == pytest.approx(0.2)


def test_rising_share() -> None:
    assert criteria.rising_share(np.array([0.0, 1.0, 2.0, 3.0, 1.0])) == pytest.approx(0.75)


def test_only_what_approaches_a_limit_saturates() -> None:
    x = 0.3 * np.array([1.0, 2.0, 4.0])
    growing = (np.log(x), x**0.1, np.cbrt(x), np.cbrt(x - 0.075))
    saturating = (1.0 - 0.05 / x, np.cbrt(1.0 - 0.05 / x), 1.0 - np.exp(-3.0 * x), x / (x + 0.1))
    assert all(criteria.growth_per_doubling(f) > criteria.SATURATED.limit for f in growing)
    assert all(criteria.growth_per_doubling(f) < criteria.SATURATED.limit for f in saturating)


def test_interval_above() -> None:
    parabola = 1.0 - ((X - 5.0) / 4.0) ** 2  # 0.75 of the top at 5 ± 2
    assert criteria.interval_above(X, parabola, 0.75) == pytest.approx((3.0, 7.0))
    assert criteria.interval_above(X, X, 0.5) == pytest.approx((5.0, 10.0))


def test_every_criterion_states_its_rule() -> None:
    assert len({c.name for c in criteria.CRITERIA}) == len(criteria.CRITERIA)
    assert all(c.limit > 0.0 and c.meaning for c in criteria.CRITERIA)


def test_slight_and_significant_share_their_border() -> None:
    assert criteria.SLIGHT.limit == criteria.SIGNIFICANT.limit


def test_a_claim_is_met_only_in_all_its_statements():
    met = Statement("rises", True, "from 1 to 2 N", {"start_N": 1.0})
    unmet = Statement("falls", False, "from 1 to 2 N", {"start_N": 1.0})
    assert Claim("C1", "title", ("4a",), (met, met)).met
    claim = Claim("C2", "title", ("4a", "4b"), (met, unmet))
    assert not claim.met
    document = claim.as_dict()
    assert (document["name"], document["panels"], document["met"]) == ("C2", ["4a", "4b"], False)
    assert document["statements"][1] == {
        "says": "falls",
        "met": False,
        "evidence": "from 1 to 2 N",
        "numbers": {"start_N": 1.0},
    }

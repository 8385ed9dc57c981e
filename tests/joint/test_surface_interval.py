"""Ends over many surfaces of one joint."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint.surface_interval import result_ends


def result(unsolved=0, plastic=0):
    rank = np.arange(11.0)
    level = SimpleNamespace(output=rank)
    return SimpleNamespace(
        solved=rank >= unsolved,
        contact_law_holds=rank < rank.size - plastic,
        published=level,
        series_with_bulk=level,
        assembly=SimpleNamespace(stiffness=level),
        rolling=SimpleNamespace(drift_per_output_turn=np.where(rank > 8.0, np.nan, 2.0 * rank)),
    )


def test_ends_are_percentiles_of_what_has_a_value():
    found = result_ends(result(unsolved=1), shape=(11,), percentiles=(0.0, 100.0), least_usable=0.5)
    assert found["published"] == pytest.approx({"low_Nm_per_rad": 1.0, "high_Nm_per_rad": 10.0})
    assert (found["unsolved"], found["all_plastic"]) == (1, 0)


def test_no_end_where_too_many_are_missing_or_one_is_not_finite():
    found = result_ends(result(plastic=1), shape=(11,), percentiles=(0.0, 100.0), least_usable=1.0)
    assert found["assembly"] == {"low_Nm_per_rad": None, "high_Nm_per_rad": None}
    found = result_ends(result(), shape=(11,), percentiles=(0.0, 100.0), least_usable=1.0)
    assert found["drift"] == {"low_rad_per_output_turn": None, "high_rad_per_output_turn": None}

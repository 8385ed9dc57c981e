"""Many surfaces of one joint, and ends over them."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint import surface_interval as module
from asperity.joint.solve import solve_joint
from asperity.joint.surface_interval import over_surfaces, result_ends
from asperity.joint_file.build import joint_from_case


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


@pytest.mark.long
def test_many_surfaces_of_another_drive_are_the_joint_with_each(planar_case, monkeypatch):
    """Few one after the other, many by one program."""
    springs = {
        'bodies = "exact"': 'bodies = "springs"',
        'ring_support = "free" ': 'ring_support = "rigid_housing" ',
    }
    joint = joint_from_case(planar_case("planetary", replaced=springs))

    def surface(dimension, roughness):
        return dataclasses.replace(
            joint.surfaces[0], fractal_dimension=dimension, fractal_roughness=roughness, frequency_ratio=1.5
        )

    numbers = (np.array([1.3, 1.5]), np.array([2e-11, 1.3e-10]))
    few = over_surfaces(joint, (surface(*numbers),), shape=(2,))
    monkeypatch.setattr(module, "_FEW", 1)
    many = over_surfaces(joint, (surface(*numbers),), shape=(2,))
    alone = [
        solve_joint(dataclasses.replace(joint, surfaces=(surface(*map(float, pair)),))).result
        for pair in zip(*numbers, strict=True)
    ]
    for found in (few, many):
        for level in ("published", "series_with_bulk"):
            expected = [float(getattr(one, level).output) for one in alone]
            np.testing.assert_allclose(getattr(found, level).output, expected, rtol=1e-9)
        expected = [float(one.rolling.drift_per_output_turn) for one in alone]
        np.testing.assert_allclose(found.rolling.drift_per_output_turn, expected, rtol=1e-9)
    ends = result_ends(many, shape=(2,), percentiles=(0.0, 100.0), least_usable=1.0)
    both = sorted(float(each) for each in many.assembly.stiffness.output)
    assert list(ends["assembly"].values()) == pytest.approx(both, rel=1e-12)

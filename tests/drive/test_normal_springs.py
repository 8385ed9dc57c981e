"""The springs of contacts against the compression formula they stand for."""

import jax
import pytest
from johnson_rollers import johnson, springs_at

from asperity.drive.normal_springs import compression


@pytest.mark.parametrize("force", [1.0, 200.0, 1000.0, 5000.0])
def test_two_compliances_at_rest_give_the_whole_compression_curve(force):
    ours = compression(springs=springs_at(1000.0), normal_force=force, rest_force=1000.0)
    assert float(ours) == pytest.approx(johnson(force) - johnson(1000.0), rel=1e-6, abs=1e-14)


def test_a_pulling_iterate_sees_the_continued_tangent():
    spring = springs_at(1000.0)
    at = [float(compression(springs=spring, normal_force=n, rest_force=1000.0)) for n in (-100.0, -50.0, 0.0)]
    assert at[0] < at[1] < at[2]
    assert at[2] - at[1] == pytest.approx(at[1] - at[0], rel=1e-9)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_slopes_and_bends_of_the_compression_by_finite_differences():
    spring = springs_at(1000.0)

    def approach(force):
        return compression(springs=spring, normal_force=force, rest_force=1000.0)

    for force in (3.0, 400.0, 2500.0):
        step = 1e-4 * force
        at = [float(approach(force + k * step)) for k in (-1, 0, 1)]
        assert float(jax.grad(approach)(force)) == pytest.approx((at[2] - at[0]) / (2 * step), rel=1e-6)
        bend = (at[2] - 2 * at[1] + at[0]) / step**2
        assert float(jax.grad(jax.grad(approach))(force)) == pytest.approx(bend, rel=1e-4, abs=0.0)

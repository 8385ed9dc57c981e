"""Parallel elasto-plastic elements: by hand, against Masing's rule, and fitted to wind-ups whose answer is known."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import brentq

from asperity.joint.play import NO_PLAY
from asperity.standing.parallel_elements import ParallelElements, _yield_angles, fit_error, parallel_elements
from asperity.standing.series_law import SeriesLaw
from asperity.standing.windup import windup_of

THREE = ParallelElements(np.zeros(3), np.array([60.0, 30.0, 10.0]), np.array([0.3 / 60, 0.6 / 30, 1.0 / 10]))


def law_of(reversible_slope, slip_compliance, largest=5.0):
    def compliances(torque):
        elastic = reversible_slope(torque)
        return elastic + slip_compliance(torque), elastic

    return SeriesLaw(
        windup_of(compliances, largest_torque=largest, stage_shares=(0.3, 0.6), play=NO_PLAY), NO_PLAY
    )


def constant(torque):
    return jnp.full_like(torque, 1e-4)


def growing(torque):
    return 2e-6 * torque**2


def test_three_elements_by_hand():
    """0.3 + 0.6 + 10 x = 1.2 at x = 0.03; back at zero torque the first two have turned by their whole 2 y."""
    torques = np.array([1.2, 0.0, -1.2, 0.0, 1.2])
    angles = THREE.angles(torques, largest_angle=0.1)
    np.testing.assert_allclose(angles, [0.03, 0.015, -0.03, -0.015, 0.03], rtol=1e-9)
    np.testing.assert_allclose(THREE.torques(angles), torques, atol=1e-9)


def test_angles_and_torques_are_inverse_with_a_spring_that_bends():
    bent = ParallelElements(np.array([5.0, 40.0, 900.0]), THREE.stiffness, THREE.yield_angle)
    torques = np.array([1.2, 0.3, -1.2, 0.5, 1.4])
    angles = bent.angles(torques, largest_angle=0.1)
    np.testing.assert_allclose(bent.torques(angles), torques, atol=1e-9)
    x = angles[0]  # the first element alone has yielded
    assert 5.0 * x + 40.0 * x**2 + 900.0 * x**3 + 0.3 + 40.0 * x == pytest.approx(1.2, rel=1e-9)


def test_masing():
    """Every branch after a reversal is the first loading curve, twice as large."""
    loading = np.linspace(0.0, 0.05, 200)
    path = np.concatenate([loading, 0.05 - 2.0 * loading])
    torque = THREE.torques(path)
    np.testing.assert_allclose(torque[200:], torque[199] - 2.0 * torque[:200], atol=1e-12)


def test_a_loop_is_fitted_within_a_few_hundredths_of_its_width():
    law = law_of(constant, growing)
    fitted = parallel_elements(law, elements=8)
    error = fit_error(law, fitted)
    width = 1.5 * 2e-6 * 5.0**3 / 3.0  # 2 gamma(T) - 4 gamma(T/2)
    assert error.angle < 0.02 * width
    assert error.loop_width < 0.02 * width
    assert fitted.spring[1] == 0.0  # both directions are alike
    assert np.all(fitted.stiffness > 0.0)
    assert np.all((fitted.yield_angle > 0.0) & (fitted.yield_angle < 5e-4 + 2e-6 * 5.0**3 / 3.0))
    dense = fit_error(law, parallel_elements(law, elements=16))
    assert dense.angle < error.angle


def test_stiffness_at_rest_and_at_the_end():
    """The sum of all springs is the slope at rest, the reversible one alone that after every element has yielded."""
    law = law_of(constant, growing)
    fitted = parallel_elements(law, elements=16)
    assert fitted.spring[0] + np.sum(fitted.stiffness) == pytest.approx(1e4, rel=5e-3)
    end = float(law.loading(np.asarray(5.0)))
    slope = fitted.spring @ (np.arange(1, 4) * end ** np.arange(3))
    assert slope == pytest.approx(1.0 / (1e-4 + 2e-6 * 25.0), rel=0.03)


def test_yield_angles_stand_denser_where_the_slip_bends_more():
    """The slip 2e-6 T^3/3 bends as T: density sqrt(T) with a twentieth of its largest, its integral in equal parts."""
    law = law_of(constant, growing)
    at = np.array([brentq(lambda t, part=k: _grown(t) - part * _grown(5.0) / 4, 0.0, 5.0) for k in (1, 2, 3)])
    expected = 1e-4 * at + 2e-6 * at**3 / 3.0
    np.testing.assert_allclose(_yield_angles(law, 6e-4, 3), expected, rtol=0.01)


def _grown(torque):
    return torque**1.5 / 1.5 + 0.05 * 5.0**0.5 * torque


def test_two_directions_that_differ():
    law = law_of(lambda torque: 1e-4 * (1.0 + 4e-3 * torque), growing)
    fitted = parallel_elements(law, elements=8)
    width = 1.5 * 2e-6 * 5.0**3 / 3.0
    assert fit_error(law, fitted).angle < 0.06 * width
    ends = (
        fitted.angles(np.array([5.0]), largest_angle=1e-2),
        fitted.angles(np.array([-5.0]), largest_angle=1e-2),
    )
    difference = 1e-4 * 4e-3 * 25.0  # 2 (half of) 4e-3 T^2
    assert float(ends[0][0] + ends[1][0]) == pytest.approx(difference, rel=0.1)


def test_without_slip_there_are_no_elements():
    law = law_of(constant, lambda torque: 0.0 * torque)
    fitted = parallel_elements(law, elements=8)
    assert fitted.stiffness.size == fitted.yield_angle.size == 0
    np.testing.assert_allclose(fitted.spring, [1e4, 0.0, 0.0], atol=1e-3)
    assert fit_error(law, fitted).angle < 1e-12

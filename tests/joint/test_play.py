"""Play: its two sides, and its compliance as the derivative of its angle."""

import jax
import numpy as np
import pytest

from asperity.joint.play import NO_PLAY, Play, play_angle, play_compliance

TORQUE = np.array([-8.0, -0.3, 0.0, 0.1, 5.0])


def test_play_is_taken_up_on_both_sides():
    gradual = play_angle(play=Play(angle=0.02, take_up_torque=0.5), output_torque=TORQUE)
    np.testing.assert_allclose(gradual, 0.01 * np.tanh(np.asarray(TORQUE) / 0.5), rtol=1e-14)
    sudden = play_angle(play=Play(angle=0.02, take_up_torque=0.0), output_torque=TORQUE)
    np.testing.assert_allclose(sudden, [-0.01, -0.01, 0.0, 0.01, 0.01], rtol=1e-14)
    assert not np.any(play_angle(play=NO_PLAY, output_torque=TORQUE))


def test_compliance_is_the_derivative_of_the_angle():
    play = Play(angle=0.02, take_up_torque=0.5)
    slope = jax.vmap(jax.grad(lambda torque: play_angle(play=play, output_torque=torque)))(TORQUE)
    np.testing.assert_allclose(
        play_compliance(play=play, output_torque=TORQUE), slope, rtol=1e-12, atol=1e-17
    )
    sudden = play_compliance(play=Play(angle=0.02, take_up_torque=0.0), output_torque=TORQUE)
    assert list(sudden) == [0.0, 0.0, np.inf, 0.0, 0.0]
    assert not np.any(play_compliance(play=NO_PLAY, output_torque=TORQUE))


@pytest.mark.parametrize("width", [0.0, 0.5])
def test_gradients_by_the_play_are_finite(width):
    def angle(play):
        return play_angle(play=play, output_torque=np.asarray(0.1))

    found = jax.grad(angle)(Play(angle=np.asarray(0.02), take_up_torque=np.asarray(width)))
    assert np.isfinite(found.angle)
    assert np.isfinite(found.take_up_torque)

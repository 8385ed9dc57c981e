"""The wind-up as a law of any torque, against closed forms."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.play import NO_PLAY, Play
from asperity.standing.series_law import SeriesLaw, slip_elements
from asperity.standing.windup import windup_of

LARGEST = 4.0


def slip(torque):
    return 1e-7 * torque**3


def reversible(torque):
    return 1e-5 * torque + 2e-7 * torque**2


@pytest.fixture(scope="module")
def law():
    play = Play(angle=1e-4, take_up_torque=0.3)

    def compliances(torque):
        elastic = 1e-5 + 4e-7 * torque
        return elastic + 3e-7 * torque**2, elastic

    return SeriesLaw(windup_of(compliances, largest_torque=LARGEST, stage_shares=(0.3, 0.6), play=play), play)


def test_loading_is_the_closed_form_without_play(law):
    torque = np.linspace(-LARGEST, LARGEST, 101)
    expected = reversible(torque) + slip(torque)
    np.testing.assert_allclose(law.loading(torque), expected, rtol=0.0, atol=1e-4 * slip(LARGEST))
    assert law.largest_torque == LARGEST


@pytest.mark.parametrize("size", [LARGEST, 1.7])
def test_branches_follow_masing(law, size):
    torque = np.linspace(-size, size, 51)
    for sense in (1.0, -1.0):
        turned = slip(-sense * size) + sense * 2.0 * slip(0.5 * np.abs(torque + sense * size))
        found = law.branch(torque, size=size, sense=sense)
        np.testing.assert_allclose(found, reversible(torque) + turned, rtol=0.0, atol=2e-4 * slip(LARGEST))


def test_loops_close_on_first_loading(law):
    for size in (0.4, 2.2, LARGEST):
        for end in (-size, size):
            ends = [float(law.branch(jnp.asarray(end), size=size, sense=sense)) for sense in (1.0, -1.0)]
            assert ends == pytest.approx([float(law.loading(np.asarray(end)))] * 2, rel=1e-9)


def test_slip_elements_are_the_second_derivative_of_the_slip(law):
    """A cubic slip spreads its elements in proportion to their threshold."""
    found = slip_elements(law, elements=20)
    assert np.all(found.compliance >= 0.0)
    width = LARGEST / 20
    np.testing.assert_allclose(found.compliance[2:], 6e-7 * found.threshold[2:] * width, rtol=0.1)
    assert found.error < 0.01 * 1.5 * slip(LARGEST)


def test_slip_elements_follow_masing(law):
    """Each slider follows the torque within its threshold, along a path of loading, unloading and reloading."""
    found = slip_elements(law, elements=20)
    missed = []
    for size in (LARGEST, 0.5 * LARGEST):
        path = np.concatenate([np.linspace(0.0, size, 50), np.linspace(size, -size, 321)])
        place = np.zeros(20)
        angle = []
        for torque in path:
            place = np.clip(place, torque - found.threshold, torque + found.threshold)
            angle.append(place @ found.compliance)
        expected = law.branch(path[50:], size=size, sense=-1.0) - law.reversible(path[50:])
        missed.append(np.max(np.abs(np.array(angle[50:]) - expected)))
    assert max(missed) == pytest.approx(found.error, rel=0.02, abs=1e-5 * slip(LARGEST))


def test_no_slip_no_error():
    flat = windup_of(
        lambda torque: (jnp.full_like(torque, 1e-5), jnp.full_like(torque, 1e-5)),
        largest_torque=LARGEST,
        stage_shares=(0.3, 0.6),
        play=NO_PLAY,
    )
    found = slip_elements(SeriesLaw(flat, NO_PLAY), elements=8)
    assert not np.any(found.compliance)
    assert found.error == 0.0

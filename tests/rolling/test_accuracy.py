"""Form errors of a joint over a turn: sums over phases that nobody knows, against sampled phases."""

import numpy as np
import pytest

from asperity.rolling.accuracy import Component, FormError, budget


def component(part, harmonic, phase=None, sector=0, *, spin=1.0):
    """A form error of a part that turns so fast in the carrier's frame, over the input."""
    error = FormError(part, sector, (), harmonic, 1e-6, phase)
    nothing = np.zeros(0)
    return Component(error, 1.0, harmonic * spin, 0j, nothing, nothing, nothing, 0j)


def test_worst_and_rms_of_unknown_phases_by_sampling():
    sizes = np.array([3.0, 1.0, 0.5])
    found = budget([component("ring", n) for n in (1, 2, 3)], sizes + 0j)
    random = np.random.default_rng(1)
    phases = random.uniform(0.0, 2.0 * np.pi, (200_000, 3))
    samples = (sizes * np.cos(phases)).sum(axis=1)
    assert found.rms == pytest.approx(np.sqrt(np.mean(samples**2)), rel=5e-3)
    assert samples.max() <= found.worst
    assert samples.max() == pytest.approx(found.worst, rel=0.02)


def test_one_frequency_with_known_phases_is_one_wave():
    values = np.array([1.0 + 0j, -1.0 + 0j, 0.5j])
    known = [component("planet", 2, phase=0.0, sector=k) for k in (1, 2, 3)]
    found = budget(known, values)
    assert found.worst == pytest.approx(0.5)
    assert found.rms == pytest.approx(0.5 / np.sqrt(2.0))
    unlike = [component("planet", n, phase=0.0) for n in (2, 3, 4)]
    assert budget(unlike, values).worst == pytest.approx(2.5)


def test_nothing_has_no_error():
    found = budget([], np.zeros((0, 2)))
    np.testing.assert_array_equal(found.worst, [0.0, 0.0])


@pytest.mark.parametrize(
    ("phases", "frequencies", "worst"),
    [
        ((0.0, np.pi), (1.6, 1.6), 0.0),  # unlike parts of one frequency that cancel
        ((0.0, 0.5 * np.pi), (1.6, 1.6), np.sqrt(2.0)),
        ((0.0, np.pi), (1.6, 1.7), 2.0),  # of two frequencies they meet some time
        ((0.0, None), (1.6, 1.6), 2.0),  # of an unknown phase it may be
    ],
)
def test_waves_of_one_frequency_add_up_with_their_phases(phases, frequencies, worst):
    parts = ("left_loading_roller", "right_loading_roller")
    both = [
        component(part, 2, phase, spin=spin)
        for part, spin, phase in zip(parts, frequencies, phases, strict=True)
    ]
    found = budget(both, np.exp(1j * np.array([phase or 0.0 for phase in phases])))
    assert float(found.worst) == pytest.approx(worst, abs=1e-12)

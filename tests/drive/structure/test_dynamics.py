"""Inertias by the kinetic energy of every body, frequencies by the matrix of two inertias, creep as a damper."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

from asperity.drive.structure.dynamics import (
    dynamic_stiffness,
    frequency_response,
    natural_frequencies,
    roller_inertia,
)


def test_a_hollow_roller_by_quadrature():
    radius, bore, mass = 5e-3, 6e-3, 0.02
    r = np.linspace(bore / 2, radius, 20_001)
    by_quadrature = mass * np.trapezoid(r**3, r) / np.trapezoid(r, r)
    assert float(roller_inertia(mass=mass, radius=radius, bore_diameter=bore)) == pytest.approx(
        by_quadrature, rel=1e-8
    )


def test_frequencies_of_two_inertias_are_the_eigenvalues():
    k, first, second = 3e4, 2e-4, 5e-2
    matrix = k * np.array([[1.0, -1.0], [-1.0, 1.0]])
    values = eigh(matrix, np.diag([first, second]), eigvals_only=True)
    found = natural_frequencies(stiffness=k, input_inertia=first, output_inertia=second)
    assert float(found.free) == pytest.approx(math.sqrt(values[1]) / (2 * math.pi), rel=1e-12)
    assert float(found.locked) == pytest.approx(math.sqrt(k / second) / (2 * math.pi), rel=1e-12)


def test_dynamic_stiffness_is_a_spring_above_and_a_damper_below_its_corner():
    given = {"stiffness": 3e4, "loss_factor": 0.0, "creep_damping": 30.0}
    corner = 3e4 / 30.0 / (2 * math.pi)
    low, at, high = (complex(dynamic_stiffness(frequency=f * corner, **given)) for f in (1e-4, 1.0, 1e4))
    assert low == pytest.approx(1j * 2 * math.pi * 1e-4 * corner * 30.0, rel=2e-4)
    assert at == pytest.approx(3e4 / (1 - 1j), rel=1e-12)
    assert high == pytest.approx(3e4, rel=2e-4)
    stands = dynamic_stiffness(frequency=10.0, stiffness=3e4, loss_factor=0.02, creep_damping=math.inf)
    assert complex(stands) == pytest.approx(3e4 * (1 + 0.02j), rel=1e-12)


@pytest.mark.slow
def test_response_is_that_of_the_differential_equations():
    """Spring and damper in series between two inertias, integrated in time until the start has died away."""
    k, c, first, second, frequency = 900.0, 40.0, 0.05, 0.8, 6.0
    omega = 2 * math.pi * frequency

    def rates(t, y):
        angle_1, speed_1, angle_2, speed_2, lost = y
        torque = k * (angle_1 - angle_2 - lost)
        return [speed_1, (math.cos(omega * t) - torque) / first, speed_2, torque / second, torque / c]

    end = 200 / frequency
    t = np.linspace(end - 1 / frequency, end, 400, endpoint=False)
    y = solve_ivp(rates, (0.0, end), np.zeros(5), t_eval=t, rtol=1e-9, atol=1e-13, method="DOP853").y
    turning = np.exp(-1j * omega * t)
    stiffness = dynamic_stiffness(frequency=frequency, stiffness=k, loss_factor=0.0, creep_damping=c)
    found = frequency_response(
        frequency=frequency, stiffness=stiffness, input_inertia=first, output_inertia=second
    )
    for speed, angle in ((y[1], found.motor), (y[3], found.load)):
        amplitude = (
            2.0 * np.mean(speed * turning) / (1j * omega)
        )  # of the speeds: the angles drift by their start
        assert complex(angle) == pytest.approx(complex(amplitude), rel=2e-5)


def test_motor_stands_at_the_antiresonance():
    given = {"input_inertia": 2e-4, "output_inertia": 5e-2}
    locked = natural_frequencies(stiffness=3e4, **given).locked
    found = frequency_response(frequency=locked, stiffness=jnp.asarray(3e4 + 0j), **given)
    assert abs(complex(found.motor)) < 1e-12 * abs(complex(found.load))
    assert jax.grad(lambda k: natural_frequencies(stiffness=k, **given).free)(3e4) > 0.0

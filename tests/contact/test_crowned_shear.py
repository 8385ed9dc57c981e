"""Crowned line contacts in shear: slip as the integral of the compliance, cylinders, no force."""

import jax
import numpy as np
import pytest
from scipy.integrate import quad

from asperity.contact.crowned_shear import crown_shear_compliance, crown_slip

E, NU, N, MU = 206e9, 0.3, 2000.0, 0.1
PAIR = {
    "contact_length": 10e-3,
    "effective_radius": 20e-3 / 3.0,
    "contact_modulus": E / (2.0 * (1.0 - NU**2)),
    "lateral_strain_compliance": 2.0 * NU * (1.0 + NU) / E,
}
_compliance, _slip = jax.jit(crown_shear_compliance), jax.jit(crown_slip)


def slip(crown, share, force=N):
    return float(
        _slip(
            normal_force=force,
            stick_force=(1.0 - share) * force,
            friction_coefficient=MU,
            crown_curvature=1.0 / crown,
            **PAIR,
        )
    )


@pytest.mark.parametrize(
    ("crown", "share", "error"), [(20.0, 0.999, 3e-3), (1.5, 0.3, 1e-4), (0.2, 0.999, 1e-4)]
)
def test_slip_is_the_integral_of_the_compliance(crown, share, error):
    """From rest to the force, where stick shrinks to the contact area under N - T/mu; under 20 m the ends come free."""

    def compliance(force):
        return float(_compliance(stick_force=N - force / MU, crown_curvature=1.0 / crown, **PAIR))

    expected, _ = quad(compliance, 0.0, share * MU * N, epsrel=1e-8, limit=200)
    assert slip(crown, share) == pytest.approx(expected, rel=error)


def test_without_crown_or_force_nothing_slips():
    assert slip(np.inf, 0.7) == pytest.approx(0.0, abs=1e-22)
    assert slip(0.5, 0.0) == 0.0

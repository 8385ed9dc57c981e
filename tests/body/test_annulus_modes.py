"""Every mode of an annulus against a dense solution with Michell's fields, and uniform pressure against Lamé."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.body.annulus_modes import (
    added_compliance,
    support_weights,
)
from asperity.body.compliance import wall_of
from asperity.body.shapes import Annulus

E, NU = 206e9, 0.3
G = E / (2.0 * (1.0 + NU))
SUPPORTS = [(0.0, 0.0), (math.inf, math.inf), (3e12, 3e12), (math.inf, 0.0), (1e13, 2e12)]


def annulus(support, rim, inner=1.0, outer=1.4, state="plane_strain"):
    return Annulus(inner, outer, 1.0, E, NU, *support, rim, state)


def fields(n, r, kappa):
    """2G u_r, 2G u_theta, sigma_r, tau of Airy's r^(n+2), r^(2-n), r^n, r^-n times cos n theta (Barber, table 9.1)."""
    columns = [
        [
            (kappa - n - 1) * r ** (n + 1),
            (kappa + n + 1) * r ** (n + 1),
            -(n + 1) * (n - 2) * r**n,
            n * (n + 1) * r**n,
        ],
        [
            (kappa + n - 1) * r ** (1 - n),
            -(kappa - n + 1) * r ** (1 - n),
            -(n + 2) * (n - 1) * r**-n,
            -n * (n - 1) * r**-n,
        ],
        [-n * r ** (n - 1), n * r ** (n - 1), -n * (n - 1) * r ** (n - 2), n * (n - 1) * r ** (n - 2)],
        [n * r ** (-n - 1), n * r ** (-n - 1), -n * (n + 1) * r ** (-n - 2), -n * (n + 1) * r ** (-n - 2)],
    ]
    return np.array(columns).T


def dense(n, support, rim, inner, outer, kappa):
    """Displacements 4G u/R on the loaded rim under unit tractions there, as a 2x2 matrix."""
    loaded, other = (outer, inner) if rim == "outer" else (inner, outer)
    side = 1.0 if rim == "outer" else -1.0
    here, there = fields(n, loaded, kappa), fields(n, other, kappa)
    rows = [side * here[2], side * here[3]]
    for k, stiffness in enumerate(support):
        if math.isinf(stiffness):
            rows.append(there[k])
        else:
            rows.append(-side * there[2 + k] + stiffness / (2.0 * G) * there[k])
    right = np.zeros((4, 2))
    right[:2] = np.eye(2)
    return here[:2] @ np.linalg.solve(np.array(rows), right) * 2.0 / loaded


@pytest.mark.parametrize("rim", ["inner", "outer"])
@pytest.mark.parametrize("support", SUPPORTS)
@pytest.mark.parametrize("n", [2, 3, 7])
def test_mode_with_michells_fields(n, support, rim):
    wall = wall_of(annulus(support, rim))
    kappa = 3.0 - 4.0 * NU
    added = added_compliance(mode=float(n), decay=jnp.asarray(1.4**-n), wall=wall)
    plus, minus = (kappa / (n + 1), 1 / (n - 1)) if rim == "outer" else (1 / (n + 1), kappa / (n - 1))
    total = np.array(
        [
            [plus + minus + added.radial, plus - minus + added.coupling],
            [plus - minus + added.coupling, plus + minus + added.tangential],
        ]
    )
    assert total == pytest.approx(dense(n, support, rim, 1.0, 1.4, kappa), rel=1e-9)


@pytest.mark.programs("operations by JAX, one after the other")
def test_weights_of_a_support_and_their_slope():
    assert [float(x) for x in support_weights(support_stiffness=0.0, radius=1.0, shear_modulus=G)] == [
        1.0,
        0.0,
    ]
    assert [float(x) for x in support_weights(support_stiffness=math.inf, radius=1.0, shear_modulus=G)] == [
        0.0,
        1.0,
    ]
    free, held = support_weights(support_stiffness=2.0 * G, radius=3.0, shear_modulus=G)
    assert float(free) == pytest.approx(0.25)
    assert float(held) == pytest.approx(0.75)
    for stiffness in (0.0, 1e12, math.inf):
        slope = jax.grad(lambda k: support_weights(support_stiffness=k, radius=1.0, shear_modulus=G)[1])(
            stiffness
        )
        assert bool(jnp.isfinite(slope))

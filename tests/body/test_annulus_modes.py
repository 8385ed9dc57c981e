"""Every mode of an annulus against a dense solution with Michell's fields, and uniform pressure against Lamé."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from michell_fields import NU, SUPPORTS, G, annulus, dense

from asperity.body.annulus_modes import (
    added_compliance,
    support_weights,
)
from asperity.body.compliance import wall_of


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

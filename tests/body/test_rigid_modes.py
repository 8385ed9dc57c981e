"""Uniform pressure against Lamé, twist against its integral, translation against Michell's fields."""

import math

import numpy as np
import pytest
from michell_fields import NU, SUPPORTS, E, G, annulus, dense, fields

from asperity.body.compliance import wall_of
from asperity.body.rigid_modes import translation_compliance, uniform_compliance


@pytest.mark.parametrize("rim", ["inner", "outer"])
@pytest.mark.parametrize("support", SUPPORTS[1:])
def test_translation_of_a_supported_body(support, rim):
    kappa = 3.0 - 4.0 * NU
    added = translation_compliance(wall_of(annulus(support, rim)))
    alone = 0.5 * kappa if rim == "outer" else 0.5
    total = np.array(
        [[alone + added.radial, alone + added.coupling], [alone + added.coupling, alone + added.tangential]]
    )
    assert total == pytest.approx(dense(1, support, rim, 1.0, 1.4, kappa), rel=1e-9)


@pytest.mark.parametrize("rim", ["inner", "outer"])
def test_translation_of_a_free_body_answers_balanced_loads(rim):
    """P = Q: r^3 and 1/r alone; the difference of the displacements is a rigid motion."""
    kappa = 3.0 - 4.0 * NU
    loaded, other, side = (1.4, 1.0, 1.0) if rim == "outer" else (1.0, 1.4, -1.0)
    here, there = fields(1, loaded, kappa)[:, [0, 3]], fields(1, other, kappa)[:, [0, 3]]
    coefficients = np.linalg.solve([side * here[2], there[2]], [1.0, 0.0])
    total = float(np.sum(here[:2] @ coefficients)) * 2.0 / loaded
    added = translation_compliance(wall_of(annulus((0.0, 0.0), rim)))
    alone = 0.5 * kappa if rim == "outer" else 0.5
    assert float(added.radial + added.tangential + 2.0 * added.coupling) + 4.0 * alone == pytest.approx(total)
    assert float(added.radial) == pytest.approx(float(added.coupling))


@pytest.mark.parametrize("state", ["plane_strain", "plane_stress"])
def test_uniform_pressure_is_lames(state):
    """Free: Lamé's thick cylinder, 1852. Held: the same with a radial stress that stops the outer rim."""
    inner, outer = 1.0, 1.4
    ratio = outer**2 / inner**2
    young, nu = (E, NU) if state == "plane_stress" else (E / (1 - NU**2), NU / (1 - NU))
    expand = (
        inner / young * ((ratio + 1.0) / (ratio - 1.0) + nu)
    )  # u at the inner rim under unit inner pressure
    radial, _ = uniform_compliance(wall_of(annulus((0.0, 0.0), "inner", state=state)))
    assert float(radial) * inner / (4.0 * G) == pytest.approx(expand, rel=1e-12, abs=0.0)
    outside = 2.0 * outer / young / (ratio - 1.0)  # u at the outer rim under it
    own = outer / young * ((ratio + 1.0) / (ratio - 1.0) - nu)  # u at the outer rim under unit outer tension
    across = 2.0 * inner * ratio / young / (ratio - 1.0)  # u at the inner rim under unit outer tension
    radial, _ = uniform_compliance(wall_of(annulus((math.inf, math.inf), "inner", state=state)))
    assert float(radial) * inner / (4.0 * G) == pytest.approx(
        expand - across * outside / own, rel=1e-12, abs=0.0
    )
    stiffness = 2e12
    radial, _ = uniform_compliance(wall_of(annulus((stiffness, 0.0), "inner", state=state)))
    held = expand - across * outside * stiffness / (1.0 + own * stiffness)
    assert float(radial) * inner / (4.0 * G) == pytest.approx(held, rel=1e-12, abs=0.0)
    radial, _ = uniform_compliance(wall_of(annulus((0.0, 0.0), "outer", state=state)))
    assert float(radial) * outer / (4.0 * G) == pytest.approx(own, rel=1e-12, abs=0.0)


@pytest.mark.parametrize("rim", ["inner", "outer"])
def test_uniform_shear_twists_the_wall_and_its_support(rim):
    """Shear stress falls as 1/r^2: du/dr - u/r = tau/G, and the support turns by the moment on it."""
    inner, outer, stiffness = 1.0, 1.4, 2e12
    loaded, other = (inner, outer) if rim == "inner" else (outer, inner)
    wall = (
        loaded * 0.5 / G * abs(1.0 - (loaded / other) ** 2)
    )  # u at the loaded rim under unit shear there, other held
    support = (loaded / other) ** 2 / stiffness * loaded / other
    _, twist = uniform_compliance(wall_of(annulus((0.0, stiffness), rim)))
    assert float(twist) * loaded / (4.0 * G) == pytest.approx(wall + support, rel=1e-12, abs=0.0)
    _, twist = uniform_compliance(wall_of(annulus((math.inf, math.inf), rim)))
    assert float(twist) * loaded / (4.0 * G) == pytest.approx(wall, rel=1e-12, abs=0.0)
    # the torque on a ring without support is reacted along its outer rim too, that on a roller is balanced
    _, free = uniform_compliance(wall_of(annulus((math.inf, 0.0), rim)))
    expected = wall if rim == "inner" else 0.0
    assert float(free) * loaded / (4.0 * G) == pytest.approx(expected, rel=1e-12, abs=0.0)

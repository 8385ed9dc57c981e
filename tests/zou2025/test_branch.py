"""Forces of a branch from two unknowns, against the paper's equations and the definition of lift-off."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.zou2025.branch import Branch, branch_forces, carrier_residual, contact_floors, held_load_sum
from asperity.zou2025.force_balance import balance_equations

LOSSES = {
    "pin_friction_coefficient": 3e-3,
    "pin_diameter": 5e-3,
    "loading_roller_torque": 2e-3,
    "left_push_angle": 0.1,
    "right_push_angle": -0.07,
}
S = jnp.array([900.0, 1200.0, 2500.0])
T = jnp.array([0.0, 46.3, 60.0])


@pytest.fixture(scope="module")
def branch(mechanism):
    drive = mechanism(**LOSSES)
    return Branch(
        mechanism=drive,
        sides=drive.sides,
        rest=drive.rest,
        output_torque=jnp.asarray(5.0),
        planet_centrifugal=40.0,
        roller_centrifugal=7.0,
    )


def test_all_equations_but_the_carriers_hold_for_any_unknowns(branch):
    force = branch_forces(branch, S, T)
    residuals = balance_equations(
        geometry=branch.mechanism.geometry,
        sides=branch.sides,
        bearings=branch.mechanism.bearings,
        input_torque=jnp.asarray(3.0 * branch.mechanism.geometry.sun_radius) * T,
        output_torque=branch.output_torque,
        planet_centrifugal=branch.planet_centrifugal,
        roller_centrifugal=branch.roller_centrifugal,
        **force._asdict(),
    )
    *others, carrier = np.abs(np.stack(jnp.broadcast_arrays(*residuals)))
    assert np.max(others) < 1e-9
    np.testing.assert_allclose(carrier, np.abs(carrier_residual(branch, force)), rtol=1e-12)
    assert force.normal[1] + force.normal[2] == pytest.approx(np.asarray(S))
    creep = (
        np.asarray(force.tangential[1] / force.normal[1]),
        np.asarray(force.tangential[2] / force.normal[2]),
    )
    np.testing.assert_allclose(*creep, atol=1e-15, rtol=1e-12)


def test_at_the_floors_one_contact_carries_nothing(branch):
    roller, planet = contact_floors(branch, T[1:])
    assert branch_forces(branch, roller, T[1:]).normal[2] == pytest.approx(np.zeros(2), abs=1e-10)
    pressed_out = branch._replace(planet_centrifugal=2000.0)
    _, planet = contact_floors(pressed_out, T)
    assert branch_forces(pressed_out, planet, T).normal[0] == pytest.approx(np.zeros(3), abs=1e-9)
    held = held_load_sum(pressed_out, S, T)
    np.testing.assert_array_equal(held, np.maximum(S, planet))


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_slopes_by_finite_differences(branch):
    def normal_sum(load_sum, sun_force):
        return sum(branch_forces(branch, load_sum, sun_force).normal)

    for index, (s, t) in enumerate([(S, T)] * 2):
        step = jnp.zeros(2).at[index].set(1e-3)
        _, slope = jax.jvp(
            normal_sum, (s, t), tuple(jnp.full_like(s, unit) for unit in np.asarray(step) / 1e-3)
        )
        difference = (normal_sum(s + step[0], t + step[1]) - normal_sum(s - step[0], t - step[1])) / 2e-3
        np.testing.assert_allclose(slope, difference, rtol=1e-6, atol=1e-8)


def test_a_pins_friction_opposes_the_push_in_either_direction(branch):
    """(3): F_cl cos = push - 2 T_B/R with 2 T_B = 2 T_0 + mu |F| d/2 (Coulomb), also where F turns round."""
    weak = branch_forces(branch, jnp.array([1e-3]), jnp.array([0.0]))
    bearings, geometry = branch.mechanism.bearings, branch.mechanism.geometry
    assert float(weak.pin_left[0]) < 0.0
    torque = (
        bearings.roller_torque
        + 0.25
        * bearings.pin_friction_coefficient
        * bearings.pin_friction_diameter
        * abs(float(weak.pin_left[0]))
    )
    push = 0.5e-3 * float(branch.sides.sin_wedge) - 2.0 * float(torque) / float(
        geometry.loading_roller_radius
    )
    assert float(weak.pin_left[0]) * np.cos(0.1) == pytest.approx(push, rel=1e-12)


def test_no_closure_or_torque_enters(branch):
    other = branch._replace(mechanism=dataclasses.replace(branch.mechanism, closure="constant_pin_force"))
    for mine, its in zip(
        jax.tree.leaves(branch_forces(branch, S, T)), jax.tree.leaves(branch_forces(other, S, T)), strict=True
    ):
        np.testing.assert_array_equal(mine, its)

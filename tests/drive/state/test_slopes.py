"""Slopes of the equations of a state against forward differentiation, and the step with the contacts eliminated."""

import dataclasses
import functools

import jax
import jax.flatten_util
import jax.numpy as jnp
import numpy as np
import pytest
from pins_in_bores import random_bores

from asperity.drive.bearings import Bearings
from asperity.drive.layout.drive import Closure
from asperity.drive.layout.unfolding import unfolded
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.state.creep import creepages
from asperity.drive.state.equations import (
    ASSEMBLED,
    ROLLING,
    STANDING,
    Task,
    Unknowns,
    contact_forces,
    contact_responses,
    machine_of,
    no_displacement,
    no_force,
    state_misfits,
    turning_members,
)
from asperity.drive.state.slopes import newton_step, responses_and_slopes, state_slopes
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.state import Creeping, DriveLoad
from asperity.drive.state.supports import carrier_supports
from asperity.drive.types.multiroller import two_row_multiroller
from asperity.drive.types.planetary import planetary_drive
from asperity.drive.types.stepped_planet import stepped_planet_drive
from asperity.drive.types.wedge import EQUAL_COEFFICIENTS, SPRING_LOADED_PINS, wedge_drive
from asperity.linear import solve

GEOMETRY = DriveGeometry(
    sun_radius=4e-3,
    planet_radius=13.5e-3,
    loading_roller_radius=5e-3,
    ring_radius=40e-3,
    planet_count=3.0,
    left_push_angle=0.1,
    right_push_angle=-0.05,
)
PAPERS = Closure(equal_coefficients=EQUAL_COEFFICIENTS, constant_pins=SPRING_LOADED_PINS)
PUBLISHED = wedge_drive(GEOMETRY, planet_count=3.0, closure=PAPERS)
DRIVES = {
    "wedge": wedge_drive(GEOMETRY, planet_count=3.0),
    "published closures": PUBLISHED,
    "three branches, sun floating": unfolded(PUBLISHED, sectors=3, floating=("sun",)),
    "three branches": unfolded(PUBLISHED, sectors=3),
    "planetary": planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=3.0),
    "multiroller": two_row_multiroller(
        sun_radius=8e-3, first_row_radii=(20e-3, 8e-3), second_row_radii=(20e-3, 8e-3), roller_count=4.0
    ),
    "stepped": stepped_planet_drive(sun_radius=10e-3, planet_radii=(20e-3, 18e-3), planet_count=3.0),
}
BEARINGS = Bearings(
    input_torque=1e-3,
    roller_torque=5e-4,
    output_torque=2e-3,
    pin_friction_coefficient=2e-3,
    pin_friction_diameter=4e-3,
)


def creep_that_grows(law, normal, tangential):
    """Creep whose law and drag of skew depend on both forces."""
    grows = 1.0 + normal / 3000.0 + 0.4 * jnp.abs(tangential) / (law.friction_coefficient * normal)
    skew_drag = 1e-2 * normal * (1.0 + 1e-4 * tangential**2)
    grown = dataclasses.replace(law, gross_slip_scale=law.gross_slip_scale * grows)
    creepage = creepages(law=grown, normal=normal, tangential=tangential)
    return Creeping(creepage, law.friction_coefficient * normal, skew_drag)


def resistance_that_grows(size, normal):
    """A drag of the oil and a moment of hysteresis that depend on the normal force."""
    return size * normal**0.3, 1e-5 * size * normal**1.5


def described(name, *, coupled, pressed):
    drive = DRIVES[name]
    count = len(drive.contacts)
    laws = smooth_contact_laws(
        drive=drive,
        contact_length=5e-3,
        friction_coefficient=np.linspace(0.1, 0.14, count),
        youngs_modulus=206e9,
        poisson_ratio=0.3,
        ring_wall_thickness=20e-3,
        reference_force=np.linspace(800.0, 1100.0, count),
    )
    if coupled:
        pattern = 1e-10 * np.random.default_rng(3).uniform(-1.0, 1.0, (count, count))
        laws = dataclasses.replace(laws, coupling=jnp.asarray(pattern - np.diag(np.diag(pattern))))
    if pressed:
        bores = random_bores(
            np.random.default_rng(4), contacts=count, count=len(drive.pinned), clearance=5e-6, size=1e-10
        )
        laws = dataclasses.replace(laws, bores=bores)
    held = [number for number, body in enumerate(drive.bodies) if body.place == "free"]
    supports = carrier_supports(
        drive=drive, pin_transverse_stiffness=3e7, planet_support_stiffness=2e7, planets=tuple(held[:1])
    )
    load = DriveLoad(
        jnp.asarray(4.0),
        pin_compliance=1e-9,
        bearings=BEARINGS,
        support_stiffness=jnp.full(len(drive.floating), 1e6),
        rotation=-1.0,
        supports=supports if held else None,
        resistance_of=jax.tree_util.Partial(resistance_that_grows, jnp.linspace(0.5, 1.0, count)),
    )
    creep_of = jax.tree_util.Partial(creep_that_grows, laws.creep)
    machine = machine_of(drive, laws, jnp.linspace(0.2, 1.0, count), None, load.supports, creep_of)
    return drive, machine, load


def unknowns(drive, machine, load, seed):
    random = np.random.default_rng(seed)
    pins = len(drive.pinned) + (0 if load.supports is None else load.supports.compliance.size)
    return Unknowns(
        normal=jnp.asarray(random.uniform(0.6, 1.3, len(drive.contacts))),
        tangential=jnp.asarray(random.uniform(-0.5, 0.5, len(drive.contacts))),
        pin=jnp.asarray(random.uniform(-0.5, 0.5, pins)),
        displacement=jnp.asarray(random.uniform(-0.5, 0.5, 2 * len(drive.floating))),
        turn=jnp.asarray(random.uniform(-1e-3, 1e-3, len(turning_members(drive)))),
        interference=jnp.asarray(random.uniform(0.5, 1.0, 1)),
    )


def whole_matrix(slopes, x):
    """All slopes as one matrix, in the order of :class:`Unknowns`, shape (unknowns, unknowns)."""
    moved, turns, pins = x.displacement.size, x.turn.size, x.pin.size
    contacts = x.normal.size
    approach = slopes.approach if slopes.approach.ndim > 1 else jnp.diag(slopes.approach)
    order = np.concatenate(
        [
            np.arange(2 * contacts),
            2 * contacts + moved + turns + np.arange(pins),
            2 * contacts + np.arange(moved + turns),
            [2 * contacts + moved + turns + pins],
        ]
    )
    matrix = jnp.block(
        [
            [approach, jnp.zeros((contacts, contacts)), slopes.approach_moves],
            [slopes.held_normal, slopes.held_tangential, slopes.held_moves],
            [slopes.normal, slopes.tangential, slopes.structure],
        ]
    )
    return matrix[order][:, order]


@functools.partial(jax.jit, static_argnames="pressed_sectors")
def both(machine, task, pressed_sectors, slides, x):
    flat, shape = jax.flatten_util.ravel_pytree(x)

    def residual(at):
        responses = contact_responses(machine, task, *contact_forces(machine, shape(at)))
        misfits = state_misfits(machine, task, pressed_sectors, slides, shape(at), responses)
        return jax.flatten_util.ravel_pytree(misfits.all)[0]

    slopes = state_slopes(machine, task, pressed_sectors, slides, x, responses_and_slopes(machine, task, x))
    step = newton_step(slopes, shape(residual(flat)), solve)
    return (
        jax.jacfwd(residual)(flat),
        whole_matrix(slopes, x),
        residual(flat),
        jax.flatten_util.ravel_pytree(step)[0],
    )


@pytest.mark.slow
@pytest.mark.parametrize("kind", [ASSEMBLED, STANDING, ROLLING])
@pytest.mark.parametrize(
    "name",
    [name if name == "wedge" else pytest.param(name, marks=pytest.mark.long) for name in DRIVES],
)
def test_slopes_are_those_of_the_equations(name, kind):
    drive, machine, load = described(
        name, coupled=name == "planetary", pressed=name in ("wedge", "planetary", "published closures")
    )
    at_rest = machine.laws.reference_force if machine.laws.bores is not None else None
    task = Task(jnp.asarray(kind), jnp.asarray(1e-5), load, no_displacement(drive), no_force(drive), at_rest)
    x = unknowns(drive, machine, load, seed=kind)
    for pressed_sectors in (0, 1, len(drive.contacts)):
        for slides in (jnp.zeros(len(drive.contacts)), jnp.eye(len(drive.contacts))[0]):
            expected, found, residual, step = (
                np.asarray(each) for each in both(machine, task, pressed_sectors, slides, x)
            )
            np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-12)
            condition = np.linalg.cond(expected)
            if condition < 1e12:  # a torque that nothing holds leaves a rotation open
                exact = np.linalg.solve(expected, residual)
                np.testing.assert_allclose(step, exact, rtol=1e-9, atol=1e-14 * condition)
            else:
                assert np.any(np.asarray(slides) != 0.0)

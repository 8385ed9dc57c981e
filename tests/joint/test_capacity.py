"""Torque capacity of planar joints by hand."""

import dataclasses
from types import SimpleNamespace

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from machines import laws_and_states

from asperity.drive.state.equations import STANDING, Task, forces_on, machine_of
from asperity.drive.state.search import known_state, solved, started_from, state_of
from asperity.drive.state.state import SLIP_TOLERANCE, STATE_TOLERANCE
from asperity.drive.state.states import closed_around
from asperity.engine.arrays import as_numbers
from asperity.errors import InputError
from asperity.joint.assembled import Pressed
from asperity.joint.capacity import (
    capacity_both_ways,
    excesses_of,
    first_guess,
    limiting_torques,
    smaller_sizes,
)
from asperity.joint.laws import drive_load
from asperity.joint.machine import joint_machine
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case

ORBIT, SUN, RING, COUNT = 30e-3, 10e-3, 50e-3, 3  # of the planetary example


def under_torque(joint, torque):
    return dataclasses.replace(joint, output_torque=torque)


def test_capacity_of_the_planetary_by_hand(planetary):
    """The sun's contact slips first: its normal force is the smaller one by the centrifugal force."""
    _, solution, document = planetary
    capacity = document["standing_torque_capacity"]
    normal = float(solution.result.forces.normal[0])
    assert (capacity["limit"], capacity["limiting_contact"]) == ("gross_slip", "sp")
    by_hand = 2.0 * COUNT * ORBIT * 0.08 * normal
    assert capacity["output_torque_Nm"] == pytest.approx(by_hand, rel=1e-3)  # N changes a little with T
    assert capacity["reverse"]["output_torque_Nm"] == pytest.approx(capacity["output_torque_Nm"], rel=1e-9)
    rolling = capacity["output_torque_Nm"] - _taken_by_the_oil(solution)
    assert document["rolling"]["torque_capacity_Nm"] == pytest.approx(rolling, rel=1e-4)
    assert rolling < 0.99 * capacity["output_torque_Nm"]


def _taken_by_the_oil(solution):
    """Torque that drags g leave less at the carrier: T_sp - T_pr = g_sp + g_pr, sun T + g, ring T - g."""
    sun, ring = (float(drag) for drag in solution.result.rolling.drag)
    return COUNT * (RING * (sun + 2.0 * ring) - SUN * sun)


@pytest.mark.slow
@pytest.mark.parametrize("rolls", [False, pytest.param(True, marks=pytest.mark.long)])
def test_half_of_the_searches_finds_the_capacity_by_hand(planetary, rolls):
    """As above, both ways: without skew, what turns passes as much as what stands, less what the oil takes."""
    joint, solution, _ = planetary

    def both(joint):
        laws, states = laws_and_states(joint)
        return capacity_both_ways(joint, states.rest, laws, rolls=rolls).output_torque

    by_hand = 2.0 * COUNT * ORBIT * 0.08 * float(solution.result.forces.normal[0])
    expected = [by_hand, by_hand]
    if rolls:  # a torque that drives the output: the ring's contact bears more, and slips first
        sun, ring = (float(drag) for drag in solution.result.rolling.drag)
        limit = 0.08 * float(solution.result.forces.normal[1])
        driven = SUN * (limit - 2.0 * sun - ring) + RING * (limit + ring)
        expected = [by_hand - _taken_by_the_oil(solution), COUNT * driven]
    np.testing.assert_allclose(jax.jit(both)(joint), expected, rtol=1e-3)


def test_a_strip_stays_below_the_smaller_radius_or_wall(planar_joint):
    """Sun 10 mm against planet 20 mm; ring wall 8 mm; a bore of 26 mm leaves a wall of 7 mm."""
    np.testing.assert_allclose(smaller_sizes(planar_joint("planetary")), [10e-3, 8e-3])
    bored = planar_joint(
        "planetary_hollow", {'ring_wall_thickness = "30 mm"': 'ring_wall_thickness = "6 mm"'}
    )
    np.testing.assert_allclose(smaller_sizes(bored), [7e-3, 6e-3])


def test_by_how_much_a_state_exceeds_each_limit():
    """Two contacts, of which the second is apart or slides: slip, lift-off, width, walls, and whether it is solved.

    Where no state was found, of its forces only one that became nothing has a meaning.
    """
    rest, slip, wide, thin = (
        np.array(pair) for pair in ([100.0, 50.0], [1.2, 0.5], [-0.3, 0.1], [-0.8, -0.9])
    )
    state = SimpleNamespace(normal=np.array([80.0, 20.0]), slides=np.zeros(2), worst=np.asarray(0.0))
    beyond = 0.2 - SLIP_TOLERANCE
    kept = [-1.0, beyond, -0.5 - SLIP_TOLERANCE, -0.8, -0.4, -0.3, 0.1, -0.8, -0.9, -1.0]
    np.testing.assert_allclose(excesses_of(state, rest, slip, wide, thin), kept, rtol=1e-9)
    apart = SimpleNamespace(
        normal=np.array([80.0, -1.0]), slides=np.array([1.0, 0.0]), worst=np.asarray(1e-3)
    )
    left = [-1.0, -1.0, -1.0, -0.8, 0.02, -1.0, -1.0, 1.0]
    np.testing.assert_allclose(excesses_of(apart, rest, slip, wide), left, rtol=1e-9)
    unknown = SimpleNamespace(normal=np.array([80.0, 20.0]), slides=np.zeros(2), worst=np.asarray(np.inf))
    nothing_else = [-1.0, -1.0, -1.0, -0.8, -0.4, -1.0, -1.0, 1.0]
    np.testing.assert_allclose(excesses_of(unknown, rest, slip, wide), nothing_else, rtol=1e-9)


def test_the_search_for_the_capacity_starts_where_all_contacts_of_one_kind_slip(planar_joint):
    joint = planar_joint("planetary")
    rest = SimpleNamespace(normal=np.array([900.0, 1000.0]))
    assert float(first_guess(joint, rest)) == pytest.approx(COUNT * (ORBIT + RING) * 0.08 * 900.0, rel=1e-9)


def test_where_one_path_carries_all_the_first_slip_is_the_end(planetary):
    _, solution, document = planetary
    first, whole = solution.first_slip, solution.standing_capacity
    assert float(first.output_torque) == pytest.approx(float(whole.output_torque), rel=1e-9)
    assert document["standing_torque_capacity"]["first_slip"] == {
        "output_torque_Nm": float(first.output_torque),
        "contact": "sp",
    }


@pytest.mark.long
@pytest.mark.parametrize("split", ["springs", "equal_coefficients"])
def test_the_first_slip_of_the_papers_drive_ends_it_only_with_equal_coefficients(paper_joint, split):
    """With springs the roller at the ring on the side that the torque unloads slips first, and keeps its friction."""
    found = solve_joint(paper_joint(ring_wall_thickness=60e-3, traction_split=split))
    for whole, first, unloaded in (
        (found.standing_capacity, found.first_slip, 4),
        (found.reverse_standing_capacity, found.reverse_first_slip, 3),
    ):
        assert int(whole.limiting_contact) == 0
        share = float(first.output_torque) / float(whole.output_torque)
        if split == "springs":
            assert share < 0.8
            assert int(first.limiting_contact) == unloaded
        else:
            assert share == pytest.approx(1.0, rel=1e-9)
    if split == "springs":
        assert float(found.first_slip.output_torque) < float(found.rolling_capacity.output_torque)


def unlike_planets(angles, friction):
    """Text of a drive with several planets in each sector, each on a path of its own from sun to ring."""
    rollers = ('"sun"\nplace = "axis"', '"ring"\nplace = "axis"\nwall_thickness = "20 mm"')
    contacts = []
    for name, angle in angles.items():
        rollers += (f'"{name}"\nplace = "pin"\norbit = "30 mm"\nangle = "{angle} deg"',)
        contacts += [
            f'"s{name}"\nfirst = "sun"\nsecond = "{name}"\nfirst_radius = "20 mm"\nsecond_radius = "10 mm"',
            f'"r{name}"\nfirst = "{name}"\nsecond = "ring"\nfirst_radius = "10 mm"\nsecond_radius = "40 mm"\n'
            "internal = true",
        ]
    return "\n".join(
        (
            'type = "planar"\n[drive]\nsectors = 3\ninput = "sun"\noutput = "carrier"\ngrounded = "ring"',
            'contact_length = "5 mm"',
            *(f"[[roller]]\nname = {roller}" for roller in rollers),
            *(f"[[contact]]\nname = {contact}" for contact in contacts),
            '[load]\npreload = "1000 N"\noutput_torque = "25 N*m"\nsun_speed = "0 rpm"',
            f"friction_coefficient = {friction}",
            '[model]\ncontact_factor = "unity"\nasperity_base = "majumdar_bhushan_1991"\nbodies = "springs"',
            "[bodies]",
            *(f'{name} = "52100"' for name in ("sun", *angles, "ring")),
            '[surface]\nfractal_dimension = 1.5\nfractal_roughness = "1.3e-7 mm"\nfrequency_ratio = 1.5',
        )
    )


@pytest.mark.long
def test_two_planets_of_different_friction_hold_the_sum():
    """By hand: n times two orbits times (mu_1 + mu_2) N; at 25 N·m the weak one bears 60 N, the strong one the rest."""
    text = unlike_planets({"one": 90, "two": 30}, "{ sone = 0.06, rone = 0.06, stwo = 0.1, rtwo = 0.1 }")
    joint = joint_from_case(parse_case(text, source="two.toml"))
    found = solve_joint(joint)
    path = 3.0 * 2.0 * 30e-3
    for whole, first in (
        (found.standing_capacity, found.first_slip),
        (found.reverse_standing_capacity, found.reverse_first_slip),
    ):
        assert float(whole.output_torque) == pytest.approx(path * (0.06 + 0.1) * 1000.0, rel=1e-9)
        assert joint.contact_names[int(whole.limiting_contact)] in ("stwo", "rtwo")
        # nearly as stiff as each other; the weak one less, as it is nearer to slip
        assert 2.0 * 0.06 * path * 1000.0 < float(first.output_torque) < 0.8 * float(whole.output_torque)
        assert joint.contact_names[int(first.limiting_contact)] in ("sone", "rone")
    bears = dict(zip(found.result.contact_names, np.abs(found.result.forces.tangential), strict=True))
    assert [bears[name] for name in ("sone", "rone")] == pytest.approx([60.0, 60.0], rel=1e-9)
    assert [bears[name] for name in ("stwo", "rtwo")] == pytest.approx([25.0 / path - 60.0] * 2, rel=1e-9)
    # the strong planet's springs alone hold the carrier; the other's are in series with a contact that slides
    two = np.array([name.endswith("two") for name in joint.contact_names])
    stiff = np.asarray(found.result.interfaces.tangential)[two]
    held = 3.0 * (2.0 * 30e-3) ** 2 / np.sum(1.0 / stiff)
    assert float(found.result.assembly.stiffness.output) == pytest.approx(held, rel=1e-9)
    with pytest.raises(
        InputError, match=r"beyond the standing torque capacity 28\.8 N·m, at which contact [sr]two slips"
    ):
        solve_joint(under_torque(joint, 28.81))


def loaded_step_by_step(drive, laws, rest, load):
    """The drive under the largest torque that it carries: contacts that slide keep doing so as the torque grows."""
    load = dataclasses.replace(load, output_torque=jnp.zeros(()))
    laws, rest, borne = closed_around(drive=drive, laws=laws, rest=rest, load=load)
    size = jnp.max(rest.interference)
    machine = machine_of(drive, laws, rest.interference / size, supports=borne.supports)

    def at(torque):
        under = dataclasses.replace(borne, output_torque=torque, body_force=forces_on(drive, borne))
        return Task(STANDING, size, under, rest.displacement.ravel(), rest.pin_force, rest.normal)

    def unfinished(path):
        *_, torque, step, steps = path
        return ~(step < 1e-11 * jnp.maximum(torque, 1.0)) & (steps < 400)

    def further(path):
        unknowns, state, torque, step, steps = path
        task = at(torque + step)
        found = solved(machine, task, unknowns, slides=state.slides, pressed_sectors=0)
        new = state_of(machine, task, found)
        holds = new.residual < STATE_TOLERANCE
        step = step * jnp.where(holds, 1.5, 0.4)
        kept = jax.tree.map(
            lambda one, other: jnp.where(holds, one, other),
            (found.unknowns, new, task.load.output_torque),
            (unknowns, state, torque),
        )
        return *kept, step, steps + 1

    begin = started_from(machine, rest, size)
    at_rest = known_state(machine, at(jnp.zeros(())), begin, rest.slides, pressed_sectors=0)
    state = state_of(machine, at(jnp.zeros(())), at_rest)
    path = (begin, state, jnp.zeros(()), jnp.ones(()), jnp.asarray(0))
    _, state, torque, *_ = jax.lax.while_loop(unfinished, further, path)
    return state, torque


@pytest.mark.long
def test_the_search_from_rest_finds_the_capacity_of_one_loading():
    """Two ways: each torque solved from rest, and the loading followed while two of three planets slide."""
    draws = 64
    text = unlike_planets({"one": 90, "two": 52, "three": 12}, "0.1")
    joint = joint_from_case(parse_case(text, source="three.toml"))
    joint = as_numbers(joint)
    random = np.random.default_rng(1)
    frictions = tuple(jnp.asarray(0.03 * 10.0 ** random.uniform(size=draws)) for _ in joint.contact_names)

    def both(frictions):
        there = dataclasses.replace(joint, friction_coefficients=frictions)
        laws, states = laws_and_states(there)
        machine = joint_machine(there)
        found = limiting_torques(
            machine,
            Pressed(laws, states.rest),
            direction=jnp.ones(2),
            rolls=False,
            holds=jnp.array([False, True]),
        )
        load = drive_load(machine.under(1.0))
        end, torque = loaded_step_by_step(there.drive, laws, states.rest, load)
        return found.output_torque, torque, jnp.sum(end.slides != 0.0)

    found, torque, sliding = jax.jit(jax.vmap(both))(frictions)
    np.testing.assert_array_equal(sliding, 2)
    np.testing.assert_allclose(found[:, 0], torque, rtol=1e-8)
    assert np.all(found[:, 1] < found[:, 0])

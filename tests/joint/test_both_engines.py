"""Joints by NumPy and within programs of JAX: equal formulas and slopes, and equal states."""

import dataclasses
import math
from pathlib import Path

import jax
import numpy as np
import pytest
from both_engines import Engines, Formula, assert_alike, direction, engine_tests, rows
from joint_changes import BEARINGS, CAM, CROWNS, SKEW, SPRINGS
from machines import laws_and_states

from asperity.engine import trees
from asperity.engine.arrays import as_numbers
from asperity.engine.derivatives import value_and_slope
from asperity.joint import (
    bodies,
    body_compliance,
    bores,
    contacts,
    crowned_contacts,
    description,
    laws,
    status,
    stiffness,
)
from asperity.joint.bearing_lives import joint_bearing_lives
from asperity.joint.diagnostics import diagnose
from asperity.joint.evaluation import evaluate, evaluated_with_laws
from asperity.joint.fit import Fit, loose_temperature
from asperity.joint.housing import seats
from asperity.joint.machine import joint_machine
from asperity.joint.mounting import mounting
from asperity.joint.play import Play, play_angle, play_compliance
from asperity.joint.rims import joint_rims
from asperity.joint.unfolding import SectorSizes, settled_sectors, unfolded_joint
from asperity.joint.working_loads import member_speeds, pin_bending, working_loads
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case

PINS = f"""{BEARINGS}pin_radial_clearance = "5 um"

[pin_bearing]
type = "roller"
dynamic_rating = "1500 N"
static_rating = "1200 N"
count = 2

[model]"""
HOUSED = """
[housing]
outer_diameter = "200 mm"
interference = "60 um"
friction_coefficient = 0.12

[temperature]
assembly = "20 degC"
working = "60 degC"
"""
#: Examples and what is replaced in their text, by what they are a case of.
JOINTS = {
    "planetary": ("planetary", {}),
    "the paper's": ("zou2025", {}),
    "skew": ("planetary", {**SPRINGS, "[lubrication]": SKEW}),
    "crowns": ("planetary", {**SPRINGS, "[load]": CROWNS}),
    "cam": ("planetary", {**SPRINGS, "[load]\n": CAM}),
    "pins": ("zou2025", {"[model]": PINS}),
    "hollow": ("planetary_hollow", {}),
    "multiroller": ("multiroller", {}),
    "stepped": ("stepped_planet", {}),
    "wheels": ("wheel_pair", {}),
    "planar": ("planar", {}),
}


@pytest.fixture(scope="module")
def made(planar_case):
    """Maker of a joint of NumPy's numbers by its name."""
    examples = Path(__file__).parents[2] / "examples"

    def make(name):
        if name == "housing":
            text = (examples / "planetary.toml").read_text(encoding="utf-8")
            text = text.replace('ring_support = "free" ', 'ring_support = "elastic_housing" ')
            text = text.replace("\n[bodies]", '\n[bodies]\nhousing = "6061-T6"', 1)
            case = parse_case(text + HOUSED, source="housing.toml")
        else:
            example, replaced = JOINTS[name]
            case = planar_case(example, replaced=replaced)
        return as_numbers(joint_from_case(case))

    return make


# --- formulas


def of_contacts(joint, normal, tangential):
    """The contacts of a joint without bodies around them."""
    each = description.joint_contacts(joint)
    under = {"contacts": each, "normal_force": normal, "tangential_force": tangential}
    loaded = contacts.loaded_contacts(**under)
    springs = contacts.bulk_springs(contacts=each, half_width=each.pairs.half_width(normal))
    rough = contacts.rough_joint_contacts(**under)
    diagnosed = diagnose(
        pairs=each.pairs,
        normal_force=normal,
        tangential_force=tangential,
        loaded=loaded,
        rest_force=abs(normal) + 1.0,
    )
    return loaded, springs, rough, diagnosed, laws.smooth_creep(each, normal)


def of_bodies(joint, normal):
    """The bodies of a joint, and what they weigh."""
    machine = joint_machine(joint)
    width = machine.contacts.pairs.half_width(normal)
    compliance = body_compliance.body_compliance(
        machine=machine, half_width=width, stick_half_width=0.5 * width
    )
    known = body_compliance.walls_known(machine=machine, half_width=width)
    return compliance, known, machine.masses, bodies.joint_inertias(joint)


def of_laws(joint, normal, tangential):
    """The laws of the contacts around their forces without torque, and the loads of the drive."""
    machine = joint_machine(joint)
    return (
        laws.contact_laws(machine, normal),
        laws.creep_law(machine, normal, tangential),
        laws.drive_load(machine),
        laws.centrifugal_forces(joint, machine.masses),
    )


def of_stiffness(joint, normal, tangential):
    still, nothing = np.zeros(len(joint.drive.contacts)), np.zeros(len(joint.drive.pinned))
    pins = bores.PinLoads(nothing, 0.0 * normal, tangential, normal[0])
    return stiffness.loaded_stiffness(joint_machine(joint), normal, tangential, still, pins)


def of_crowns(joint, normal, tangential):
    """Crowned contacts in slices."""
    each = description.joint_contacts(joint)
    crowns = {"pairs": each.pairs, "crown_curvature": each.crown_curvature}
    lines = crowned_contacts.loads_along(**crowns, normal_force=normal)
    materials = {"driving": each.driving, "driven": each.driven}
    return (
        lines,
        crowned_contacts.crown_compliances(
            **crowns, **materials, normal_force=normal, tangential_force=tangential
        ),
        crowned_contacts.slice_friction(pairs=each.pairs, lines=lines),
        crowned_contacts.slice_slip_ratios(
            pairs=each.pairs, lines=lines, slip_ratio=tangential / (0.08 * normal)
        ),
    )


def of_play(*, angle, take_up_torque, output_torque):
    play = Play(angle=angle, take_up_torque=take_up_torque)
    at = {"play": play, "output_torque": output_torque}
    return play_angle(**at), play_compliance(**at)


def of_fit(**numbers):
    return loose_temperature(Fit(**numbers))


PLAY = {"angle": (0.0, 1e-3), "take_up_torque": (3.0, 5.0), "output_torque": (-5.0, 5.0)}
FIT = {
    "interference": (1e-5, 3e-5),
    "change_per_kelvin": (-1e-7, 1e-7),
    "assembly_temperature": (0.0, 30.0),
    "working_temperature": (0.0, 90.0),
}
#: Forces of a sun's and of a ring's contact: usual ones, lifted, at gross slip, and unknown.
FORCES = {
    "": ([1000.0, 1100.0], [50.0, -50.0]),
    ", one lifted": ([0.0, 1100.0], [0.0, 60.0]),
    ", one slips": ([1000.0, 1100.0], [80.0, -50.0]),
    ", one unknown": ([1000.0, math.nan], [50.0, 50.0]),
}


def formulas(made):
    """Formulas by their names; joints in motion, so that every number of theirs is one of its own."""
    planetary, crowned, hollow = (
        description.in_motion(made(name)) for name in ("planetary", "crowns", "hollow")
    )

    def under(function, joint, forces, *names):
        numbers = dict(zip(("normal", "tangential"), map(np.array, FORCES[forces]), strict=True))
        given = {"joint": joint, **{name: numbers[name] for name in names}}
        return Formula(lambda these: function(**these), given)

    both = ("normal", "tangential")
    return {
        "play": rows(of_play, PLAY, {"take_up_torque": 0.0, "output_torque": 0.0}),
        "loose temperature": rows(of_fit, FIT),
        **{f"contacts{forces}": under(of_contacts, planetary, forces, *both) for forces in FORCES},
        **{f"crowns{forces}": under(of_crowns, crowned, forces, *both) for forces in ("", ", one unknown")},
        "bodies": under(of_bodies, planetary, "", "normal"),
        "hollow bodies": under(of_bodies, hollow, "", "normal"),
        "laws": under(of_laws, planetary, "", *both),
        "stiffness": under(of_stiffness, planetary, "", *both),
    }


SMALL = ("play", "loose temperature", *(f"contacts{forces}" for forces in FORCES))
LARGE = ("crowns", "crowns, one unknown", "bodies", "hollow bodies", "laws", "stiffness")
NAMES = [*SMALL, *(pytest.param(name, marks=pytest.mark.slow) for name in LARGE)]


@pytest.fixture(scope="module")
def engines(made):
    all_of_them = formulas(made)
    return Engines(
        {name: all_of_them[name] for name in SMALL}, alone={name: all_of_them[name] for name in LARGE}
    )


test_both_engines_compute_the_same_numbers, test_slopes_under_numpy_are_those_of_jax = engine_tests(NAMES)


# --- states

#: Residuals are rounding, each engine's own.
ROUNDING = ("residual", "worst", "unbalanced")


def changed(joint):
    """A joint under other torques and speeds, with other numbers, and pressed so little that it slips."""
    torque, generator = joint.output_torque, np.random.default_rng(3)

    def near(leaf):
        return leaf * (1.0 + 1e-4 * generator.uniform(-1.0, 1.0, np.shape(leaf)))

    slippery = tuple(0.02 * friction for friction in joint.friction_coefficients)
    name = "preload" if joint.interference is None else "interference"
    return {
        "as it is": joint,
        "the other way": dataclasses.replace(joint, output_torque=-torque),
        "without torque": dataclasses.replace(joint, output_torque=0.0 * torque),
        "standing": dataclasses.replace(joint, input_speed=0.0 * joint.input_speed),
        "other numbers": dataclasses.replace(trees.map(near, joint), drive=joint.drive),
        "slips": dataclasses.replace(joint, friction_coefficients=slippery),
        "loose": dataclasses.replace(joint, **{name: -getattr(joint, name)}),
        "not a number": dataclasses.replace(joint, output_torque=np.nan * torque),
    }


def beside(result):
    """What the arrays of a result are measured by: forces of pins, and shares, by the others beside them."""
    rest = dataclasses.replace(result.rest, pin_force=result.rest.normal, tangential=result.rest.normal)
    assembly = dataclasses.replace(result.assembly, normal_share=result.assembly.tangential_share)
    return dataclasses.replace(result, rest=rest, assembly=assembly)


def strength(joint):
    """The state of a joint, and what follows from it for its bearings, pins, rims and seats."""
    result, its_laws = evaluated_with_laws(joint)
    loads, rims = working_loads(joint, result), joint_rims(joint, result)
    expands = joint.materials[0].thermal_expansion is not None
    return result, {
        "status": status.joint_status(joint, result),
        "loads": loads,
        "rims": dataclasses.replace(rims, seat_pressure=0.0 * rims.seat_pressure),  # rounding without a seat
        "lives": joint_bearing_lives(joint, result, its_laws),
        "seats": seats(joint, loads),
        "mounting": mounting(joint, result, 1e-6) if expands else None,
        "speeds": member_speeds(joint, result),
        "bending": pin_bending(joint, loads.pin),
    }


def state(joint):
    return evaluate(joint), {}


def assert_same_states(joint, function):
    """Everything that is known of a joint is the same; of one that has no state, that it has none."""
    program, (usual, more) = jax.jit(function), function(joint)
    for label, other in changed(joint).items():
        (ours, after), (theirs, after_theirs) = function(other), program(other)
        without = label in ("slips", "loose", "not a number")
        assert bool(ours.solved) == bool(theirs.solved) == (not without), label
        if without:
            known = (ours.rest, ours.speeds, ours.masses, after.get("status"))
            theirs = (theirs.rest, theirs.speeds, theirs.masses, after_theirs.get("status"))
            scales = beside(usual)
            scales = (scales.rest, scales.speeds, scales.masses, more.get("status"))
            assert_alike(known, theirs, 1e-9, beside=scales, skip=ROUNDING)
        else:
            given = (ours, after), (theirs, after_theirs)
            assert_alike(*given, 1e-9, beside=(beside(usual), more), skip=ROUNDING)


#: Of further drives, what a slow test has one of.
FURTHER = ("hollow", "multiroller", "stepped", "planar", "housing")


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.long if name in FURTHER else pytest.mark.slow)
        for name in (*JOINTS, "housing")
    ],
)
def test_both_engines_find_the_same_states(made, name):
    assert_same_states(made(name), strength if name in ("pins", "housing") else state)


@pytest.mark.parametrize(
    "floating", [pytest.param((), marks=pytest.mark.long), pytest.param(("sun",), marks=pytest.mark.slow)]
)
def test_both_engines_find_the_same_states_of_unlike_branches(planar_joint, floating):
    joint = as_numbers(planar_joint("planetary", SPRINGS))
    added = np.outer([2e-6, 0.0, -1e-6], [1.0, 1.0])
    given = SectorSizes(added, np.zeros_like(added), np.asarray(5e7))

    def settled(joint, sizes):
        return settled_sectors(3, floating, joint, sizes)

    ours, theirs = settled(joint, given), jax.jit(settled)(joint, given)
    pressed = ours.without_torque.rest
    by_forces = dataclasses.replace(pressed, pin_force=pressed.normal)
    known = ours._replace(without_torque=ours.without_torque._replace(rest=by_forces))
    assert_alike(ours, theirs, 1e-9, beside=known, skip=(*ROUNDING, "change"))
    assert max(ours.change, theirs.change) < 1e-9
    unfolded = unfolded_joint(joint, ours.sizes, sectors=3, floating=floating)
    found = evaluate(unfolded)
    assert found.solved
    assert_alike(found, jax.jit(evaluate)(unfolded), 1e-9, beside=beside(found), skip=ROUNDING)


@pytest.mark.slow
def test_slopes_of_the_states_of_a_joint_with_a_cam_are_those_of_jax(made):
    """By all its numbers, under its torque and without one, where the cam begins to turn."""
    joint = description.in_motion(made("cam"))

    def states(joint):
        found = laws_and_states(joint)[1]
        standing, rolling = found.standing, found.rolling
        return standing.normal, standing.tangential, standing.input_torque, rolling.normal, rolling.speed_loss

    program = jax.jit(lambda joint, slopes: jax.jvp(states, (joint,), (slopes,)))
    along = direction(joint)
    for torque in (joint.output_torque, 0.0 * joint.output_torque):
        at = dataclasses.replace(joint, output_torque=torque)
        value, slope = value_and_slope(states, (at,), (along,))
        assert_alike(slope, program(at, along)[1], 1e-9, beside=value)

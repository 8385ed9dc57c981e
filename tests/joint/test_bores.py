"""Pins that press in bores: planetaries by hand, wind-up against the assembly, stepped rollers, refusals."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from machines import laws_and_states
from pressed_pin import hole, pressed_pin

from asperity.body.bore import bore_modes
from asperity.body.conforming_pin import SHARED
from asperity.body.pin_contact import pin_contact
from asperity.body.shapes import Annulus
from asperity.drive.structure.dynamics import natural_frequencies, sprung_drive
from asperity.engine.arrays import as_numbers
from asperity.errors import InputError
from asperity.joint.bores import bore_stiffness, pins_in_bores, refuse_pins
from asperity.joint.description import in_motion
from asperity.joint.evaluation import evaluate
from asperity.joint.solve import solve_joint
from asperity.standing.springs_over_torque import springs_of_solution, springs_over_torque

ARCMIN = math.pi / 180.0 / 60.0
FITTING = '[bearings]\npin_diameter = "26 mm"\n\n[model]'


@pytest.fixture(scope="module")
def hollow(planar_joint):
    """The hollow planetary example as it is, and on pins of 26 mm in its bores, with the solution of the first."""
    bare, pinned = planar_joint("planetary_hollow"), planar_joint("planetary_hollow", {"[model]": FITTING})
    return bare, solve_joint(bare), pinned


def stiffness(solution):
    return float(solution.result.assembly.stiffness.output)


@pytest.mark.slow
@pytest.mark.parametrize("clearance", ["", 'pin_radial_clearance = "5 um"\npin_length = "30 mm"\n'])
def test_a_load_alone_swings_on_the_stiffness_of_the_assembly(planar_joint, clearance):
    """One inertia, the motor held and no other masses: (2 pi f)^2 J = K, with the pins as they press."""
    joint = planar_joint("planetary_hollow", {"[model]": FITTING.replace("\n\n", f"\n{clearance}\n")})
    solution, drive = solve_joint(joint), in_motion(joint).drive
    springs = springs_of_solution(joint, solution)
    nothing = np.zeros((np.shape(springs.elongation)[1],) * 2)
    made = sprung_drive(
        drive=drive, springs=springs, shafts=(0.0, 0.0), mass=nothing, ends=(1e6, 0.05), creep=None
    )
    found = (2.0 * math.pi * natural_frequencies(made).locked) ** 2 * 0.05
    assert found == pytest.approx(stiffness(solution), rel=1e-9)
    over_torque = springs_over_torque(joint, np.array([float(joint.output_torque)]))
    assert float(over_torque.stiffness[0]) == pytest.approx(found, rel=1e-9)


def planet_by_elements(joint, clearance, force):
    """How far a planet gives way, and how far both contacts part, if a newton more drags it at each, around its force.

    Elements of pin and bore; the modes of the wall are those that finite elements confirm.
    """
    steel, bore, radius, length = joint.materials[1], 0.5 * joint.shapes[1].size, 20e-3, 10e-3
    elastic = steel.youngs_modulus, steel.poisson_ratio
    body = Annulus(bore, radius, length, *elastic, 0.0, 0.0, "outer", "plane_strain")
    modes = bore_modes(body=body, contact_angles=np.array([0.0, math.pi]), push_angle=0.5 * math.pi)
    kolosov, modulus = 3.0 - 4.0 * elastic[1], elastic[0] / (2.0 * (1.0 + elastic[1]))
    added = 0.5 * math.pi * (kolosov + 1.0) * np.asarray(modes.wall)
    first = float(modes.shift) * 2.0 * math.pi * modulus * length - 0.25 * (kolosov - 1.0)
    walls = np.concatenate([[1.0 + added[0], first], hole(SHARED[1:], kolosov) + 0.5 * added[1:]])
    less, more = (
        pressed_pin(
            walls=walls,
            kolosov=kolosov,
            modulus=modulus,
            radius=bore,
            clearance=clearance,
            line_load=share * force / length,
            span=0.4 if clearance else 2.4,
        )
        for share in (0.98, 1.02)
    )
    step = 0.04 * force
    elements = 2.0 * np.cos(np.outer(SHARED, more.centres)) * (more.centres[1] - more.centres[0])
    shares = elements @ (more.pressure - less.pressure) * bore * length / step
    by_pin = 2.0 * (np.asarray(modes.along) + np.asarray(modes.rim) @ shares)
    gives = 4.0 * (more.approach - less.approach) / step + 2.0 * by_pin @ np.array([0.0, 0.0, -1.0, 1.0])
    return gives, by_pin[0] + by_pin[1]


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "bore", "clearance", "shown"),
    [
        ("planetary_hollow", "26 mm", 0.0, 289.9),
        ("planetary_hollow", "26 mm", 5e-6, 164.2),
        ("planetary", "12 mm", 0.0, 172.3),
        ("planetary", "12 mm", 5e-6, 142.3),
    ],
)
def test_a_hollow_planet_on_its_pin_by_hand(planar_joint, name, bore, clearance, shown):
    """525 N·m/arcmin become 290 on pins of 26 mm without clearance, and 164 with 5 µm, which narrow the arc to 11 deg.

    Of a newton metre at the output each of three planets bears T = 50/9 N at either contact, its pin twice that. The
    loop of sun, planet and ring gives way by C to a normal force; its interference stays, dN = -dT parts/C. What the
    fall of the normal forces does to the arc, here up to 1.4 % of the stiffness, is left out.
    """
    drilled = {} if name == "planetary_hollow" else {"[drive]": f'[drive]\nplanet_bore_diameter = "{bore}"'}
    pins = {"[model]": f'[bearings]\npin_diameter = "{bore}"\n\n[model]'}
    bare, joint = (planar_joint(name, drilled | more) for more in ({}, pins))
    joint = dataclasses.replace(joint, pin_clearance=clearance)
    found, without = solve_joint(joint), solve_joint(bare)
    (force,) = np.abs(found.result.forces.pins)
    gives, parts = planet_by_elements(joint, clearance, float(force))
    tighter = solve_joint(dataclasses.replace(bare, interference=1.01 * bare.interference))
    loop = 0.01 * bare.interference / float(tighter.result.preload - without.result.preload)
    by_hand = ARCMIN / (1.0 / stiffness(without) + 3.0 * (50.0 / 9.0) ** 2 * (gives - parts**2 / loop))

    assert force == pytest.approx(100.0 / 9.0 * float(joint.output_torque), rel=1e-9)
    assert stiffness(found) * ARCMIN == pytest.approx(by_hand, rel=0.03)
    assert stiffness(found) * ARCMIN == pytest.approx(shown, rel=1e-3)
    # without torque nothing presses in the bores
    assert np.asarray(found.result.rest.normal) == pytest.approx(
        np.asarray(without.result.rest.normal), rel=1e-9
    )


@pytest.mark.long
@pytest.mark.parametrize(("clearance", "torque"), [(0.0, 0.5), (1e-6, 10.0), (5e-6, 10.0)])
def test_the_drive_winds_up_as_its_assembly_gives_way(hollow, clearance, torque):
    """What pins add to the slope of the wind-up of the standing drive, they add to its incremental compliance."""

    def turned(joint, at):
        _, states = laws_and_states(dataclasses.replace(joint, output_torque=np.asarray(at)))
        return states.standing.rotation[joint.drive.members.index(joint.drive.output)]

    turned = jax.jit(turned)
    bare, _, pinned = hollow
    step, compliances = 0.01 * torque, []
    for joint in (bare, dataclasses.replace(pinned, pin_clearance=clearance)):
        numbers = as_numbers(joint)
        more, less = (float(turned(numbers, torque + side * step)) for side in (1.0, -1.0))
        at = solve_joint(dataclasses.replace(joint, output_torque=torque))
        compliances.append((abs(more - less) / (2.0 * step), 1.0 / stiffness(at)))
    (wound, gives), (wound_on_pins, gives_on_pins) = compliances
    assert wound_on_pins - wound == pytest.approx(gives_on_pins - gives, rel=0.01)


@pytest.mark.long
def test_both_senses_are_alike(hollow):
    joint = dataclasses.replace(hollow[2], pin_clearance=5e-6)
    found, back = (
        solve_joint(dataclasses.replace(joint, output_torque=sense * joint.output_torque))
        for sense in (1.0, -1.0)
    )
    assert stiffness(back) == pytest.approx(stiffness(found), rel=1e-4)
    assert float(found.result.assembly.pin_share) > 0.3


@pytest.mark.long
def test_friction_of_pins_needs_no_bore(planar_joint):
    """4 mm in 10 mm: a bore makes the squeezed roller 15 % softer, what its pin presses there changes that by 1 %.

    Friction that acts at 4 mm leaves the rollers solid: 30,552 N·m/rad, with the friction 30,550.
    """
    torques = 'sun_torque = "0 N*m"\nloading_roller_torque = "0 N*m"\ncarrier_torque = "0 N*m"\n'
    bored = {"[drive]": '[drive]\nloading_roller_bore_diameter = "4 mm"'}

    def bearings(friction, key):
        pins = f'[bearings]\n{torques}pin_friction_coefficient = {friction}\n{key} = "4 mm"\n\n[model]'
        return {"[model]": pins}

    solid, smooth, rubbed, hollow, pinned = (
        stiffness(solve_joint(planar_joint("zou2025", replaced)))
        for replaced in (
            {},
            bearings(0, "pin_friction_diameter"),
            bearings(0.002, "pin_friction_diameter"),
            bored,
            bearings(0, "pin_diameter"),
        )
    )
    assert solid == pytest.approx(30552.0, abs=1.0)
    assert smooth == pytest.approx(solid, rel=1e-12)
    assert rubbed == pytest.approx(solid, rel=2e-4)
    assert hollow / solid == pytest.approx(0.845, abs=0.01)
    assert pinned / hollow == pytest.approx(1.0, abs=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("clearance", [0.0, 5e-6])
def test_derivatives_by_the_clearance(planar_joint, clearance):
    """Of the stiffness and the wind-up, by finite differences; from one side where there is no clearance."""
    joint = planar_joint("planetary_hollow", {"[model]": FITTING})
    numbers = as_numbers(joint)

    def found(gap):
        result = evaluate(dataclasses.replace(numbers, pin_clearance=gap))
        return jnp.log(result.assembly.stiffness.output), result.forces.normal[0]

    slopes = jax.jit(lambda gap: jax.jvp(found, (gap,), (jnp.ones_like(gap),)))
    step = 1e-8 if clearance else 1e-10
    (at, slope), (more, after) = slopes(np.asarray(clearance)), slopes(np.asarray(clearance + step))
    for one, other, first, last in zip(at, more, slope, after, strict=True):
        assert float(other - one) / step == pytest.approx(0.5 * float(first + last), rel=1e-4)
        assert float(first) < 0.0


@pytest.mark.slow
def test_pins_bend_where_their_length_is_known(planar_joint):
    """1/K of the planetary grows by 3 (100/9)^2 c: planets of 10 mm on pins of 12 mm, 20 mm long between supports.

    Three fifths of it is bending, the rest shear. A stated stiffness takes the place of the beam.
    """
    pins = '[bearings]\npin_diameter = "12 mm"\n{}\n[model]'
    beam = {"[model]": pins.format('pin_length = "20 mm"\n')}
    stiff, bent = (planar_joint("planetary", replaced) for replaced in ({"[model]": pins.format("")}, beam))
    modulus, poisson = float(bent.materials[1].youngs_modulus), float(bent.materials[1].poisson_ratio)
    bending = modulus * math.pi * 12e-3**4 / 64.0
    shear = 6.0 / (7.0 + 6.0 * poisson) * modulus / 2.0 * math.pi * 12e-3**2 / 4.0
    bent_by = (1.0 / 48.0 + 1.0 / 16.0 + 1.0 / 24.0 + 1.0 / 120.0) * 10e-3**3 / bending
    sheared_by = (20e-3 / 4.0 - 10e-3 / 6.0) / shear
    by_hand = 3.0 * (100.0 / 9.0) ** 2 * (bent_by + sheared_by)
    before, after = (1.0 / stiffness(solve_joint(joint)) for joint in (stiff, bent))
    assert after - before == pytest.approx(by_hand, rel=1e-6)
    stated = dataclasses.replace(bent, pin_stiffness=5e7)
    stated_by_hand = 3.0 * (100.0 / 9.0) ** 2 / 5e7
    assert 1.0 / stiffness(solve_joint(stated)) - before == pytest.approx(stated_by_hand, rel=1e-6)


def test_tracks_of_a_stepped_planet_give_way_beside_each_other(planar_joint):
    joint = planar_joint("stepped_planet", {"[model]": '[bearings]\npin_diameter = "8 mm"\n\n[model]'})
    steel, lengths = joint.materials[1], {float(length) for length in joint.contact_lengths}
    assert len(lengths) == 1
    each = [
        Annulus(
            4e-3, radius, lengths.copy().pop(), steel.youngs_modulus, steel.poisson_ratio, 0.0, 0.0, "outer",
            joint.plane_state,
        )
        for radius in sorted({float(radius) for radius in np.asarray(joint.drive.second_radius)[:1]}
                             | {float(radius) for radius in np.asarray(joint.drive.first_radius)[1:]})
    ]  # fmt: skip
    pressed = np.ones((1, 2), dtype=bool)
    modes = [bore_modes(body=body, contact_angles=np.zeros(1), push_angle=0.0) for body in each]
    parts = {
        name: np.stack([np.asarray(getattr(of, name)) for of in modes])[None]
        for name in ("shift", "scale", "wall")
    }
    both = pin_contact(**parts, pressed=pressed, clearance=np.zeros(1))
    bores = pins_in_bores(joint)
    own = 1.0 / float(both.compliance(both.angle(np.ones(1)))[0])
    found = bore_stiffness(joint, np.array([100.0]), np.array([1e3, 1e3, 1e3]))
    assert float(found[0]) == pytest.approx(own, rel=1e-12)
    assert not np.any(np.asarray(bores.along_normal))


def test_pins_that_do_not_fit_their_bores_are_refused(planar_joint):
    wide = {"[model]": '[bearings]\npin_diameter = "27 mm"\n\n[model]'}
    with pytest.raises(InputError, match="27 mm do not fit into the bores of planet"):
        refuse_pins(planar_joint("planetary_hollow", wide))
    thick = {"[model]": '[bearings]\npin_diameter = "41 mm"\n\n[model]'}
    with pytest.raises(InputError, match="must be below the diameter of planet"):
        refuse_pins(planar_joint("planetary", thick))


def test_a_clearance_for_which_the_contact_is_not_computed_is_refused(planar_joint):
    """At most a fiftieth of the diameter: 520 µm of 26 mm."""
    wide = planar_joint(
        "planetary_hollow", {"[model]": FITTING.replace('mm"', 'mm"\npin_radial_clearance = "600 um"')}
    )
    with pytest.raises(
        InputError, match=r"600 um: the contact of a pin is computed up to a clearance of 0\.02 of its"
    ):
        refuse_pins(wide)
    refuse_pins(dataclasses.replace(wide, pin_clearance=500e-6))

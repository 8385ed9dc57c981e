"""Loads of the structure against the states that they belong to, and by hand."""

import dataclasses

import numpy as np
import pytest
from steel_laws import steel_laws

from asperity.drive.state.creep import creepages
from asperity.drive.state.loads import (
    drag_levers,
    drag_pairs,
    member_loads,
    pin_components,
    resistance_moments,
)
from asperity.drive.state.state import Creeping, DriveLoad, Resistance, surface_speeds
from asperity.drive.state.states import drive_states
from asperity.drive.types.planetary import planetary_drive
from asperity.engine.control import at_once
from asperity.engine.module import Partial


@pytest.mark.parametrize(
    ("name", "torque"),
    [
        ("wedge", 5.0),
        ("planetary", 8.0),
        ("multiroller", 20.0),
        ("stepped", 6.0),
    ],
)
def test_every_body_and_the_whole_drive_are_in_balance(drives, solved, name, torque):
    drive = drives[name]
    _, state = solved(name, torque)
    found = member_loads(
        drive=drive,
        normal=state.normal,
        tangential=state.tangential,
        body_force=np.zeros((len(drive.floating), 2)),
    )
    np.testing.assert_allclose(found.pin, state.pin_force, atol=1e-7)
    np.testing.assert_allclose(found.unbalanced, 0.0, atol=1e-7)
    moments = dict(zip(drive.members, np.asarray(found.moments), strict=True))
    # input, output and grounded member hold each other about the axis; nothing else carries a torque
    assert sum(moments.values()) == pytest.approx(0.0, abs=1e-9)
    ends = (drive.input, drive.output, drive.grounded)
    assert abs(moments[drive.output]) == pytest.approx(torque, rel=1e-9)
    assert -drive.sense * moments[drive.input] == pytest.approx(float(state.input_torque), rel=1e-9)
    for member, moment in moments.items():
        if member not in ends:
            assert moment == pytest.approx(0.0, abs=1e-9)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_a_planet_of_a_planetary_by_hand(drives):
    """7 N at sun and ring push the pin with 14 N; 5 N outward press the ring, and leave the pin alone.

    The planet turns against the sun.
    """
    drive = drives["planetary"]
    found = member_loads(
        drive=drive,
        normal=np.array([100.0, 105.0]),
        tangential=np.array([7.0, -7.0]),
        body_force=5.0 * drive.centres[1:2] / np.linalg.norm(drive.centres[1]),
    )
    np.testing.assert_allclose(np.abs(found.pin), [14.0], rtol=1e-12)
    np.testing.assert_allclose(found.unbalanced, 0.0, atol=1e-9)
    np.testing.assert_allclose(np.abs(found.moments), 3.0 * np.array([0.07, 0.0, 0.35, 0.42]), atol=1e-12)


@pytest.mark.parametrize("name", ["wedge", "planetary", "stepped"])
@pytest.mark.parametrize("sense", [1, -1])
def test_tangential_forces_turn_the_carrier_and_count_in_the_sense_of_the_input(drives, name, sense):
    """Whatever the contacts do: force times distance from the axis, by any push angle."""
    drive = drives[name]
    drive = dataclasses.replace(drive, sense=sense, push_angles=drive.push_angles + 0.3)
    normal = np.linspace(90.0, 110.0, len(drive.contacts))
    found = member_loads(
        drive=drive,
        normal=normal,
        tangential=0.1 * normal[::-1],
        body_force=np.zeros((len(drive.floating), 2)),
    )
    radial, tangential = pin_components(drive=drive, force=found.pin)
    np.testing.assert_allclose(np.hypot(radial, tangential), np.abs(found.pin), rtol=1e-12)
    arms = np.linalg.norm(np.asarray(drive.centres)[list(drive.pinned)], axis=1)
    carrier = drive.members.index("carrier")
    moment = sense * float(drive.sectors) * np.sum(np.asarray(tangential) * arms)
    assert moment == pytest.approx(float(found.moments[carrier]), rel=1e-9, abs=1e-9)


SUN, PLANET, RING, ORBIT, COUNT = 10e-3, 20e-3, 50e-3, 30e-3, 3


def film_on_bodies(first, second, outward):
    """Forces on both bodies in the direction of rolling, and the drag on a surface, per length.

    Reynolds' equation of rigid rollers with Swift and Stieber's outlet; pressure on each curved surface, shear of its
    gradient.
    """
    radius = 1.0 / (1.0 / first + outward / second)
    viscosity, speed, least = 0.03, 2.0, 1e-6
    span = np.sqrt(2.0 * radius * least)
    x = (
        np.linspace(-60.0, 0.475133, 400_001) * span
    )  # the outlet of the infinite wedge, where p and p' vanish
    film = least + x**2 / (2.0 * radius)
    slope = 12.0 * viscosity * speed * (film - film[-1]) / film**3
    pressure = np.concatenate([[0.0], np.cumsum(0.5 * (slope[1:] + slope[:-1]) * np.diff(x))])
    shear = np.trapezoid(-0.5 * film * slope, x)
    assert pressure[-1] == pytest.approx(0.0, abs=2e-3 * pressure.max())
    tilted = np.trapezoid(pressure * x, x)
    return shear - tilted / first, shear - tilted * outward / second, -shear


@pytest.mark.parametrize(("first", "second", "outward"), [(10e-3, 20e-3, 1.0), (20e-3, 50e-3, -1.0)])
def test_shear_and_pressure_of_the_film(first, second, outward):
    on_first, on_second, drag = film_on_bodies(first, second, outward)
    drive = planetary_drive(sun_radius=SUN, planet_radius=PLANET, planet_count=3.0)
    place = 0 if outward > 0.0 else 1
    pair = float(drag_pairs(drive, np.full(2, drag))[place])
    assert -pair == pytest.approx(on_first, rel=0.02)  # a tangential force opposes the first surface
    assert on_second == pytest.approx(-on_first, rel=0.02)


def test_drag_brakes_every_body_by_its_radius():
    """Sun +, planet against it, ring with the planet; the carrier feels it through its pins only."""
    drive = planetary_drive(sun_radius=SUN, planet_radius=PLANET, planet_count=3.0)
    moments = drag_levers(drive) @ np.array([2.0, -3.0])  # the planet turns clockwise in the ring
    np.testing.assert_allclose(moments, [-3 * 2.0 * SUN, (2.0 + 3.0) * PLANET, 3 * 3.0 * RING, 0.0])


def test_hysteresis_turns_both_bodies_and_skew_brakes_both_surfaces():
    """Sun +, planet against it, ring with the planet: couples of 2 and 3 N·m, drags of 5 and 7 N.

    Equal and opposite couples leave nothing; the moments of skew are left for the bearings on the carrier.
    """
    drive = planetary_drive(sun_radius=SUN, planet_radius=PLANET, planet_count=3.0)
    none = np.zeros(2)
    couples = resistance_moments(drive, Resistance(none, np.array([2.0, -3.0]), none))
    np.testing.assert_allclose(couples, [-3 * 2.0, 2.0 + 3.0, -3 * 3.0, 0.0], atol=1e-12)
    brakes = resistance_moments(drive, Resistance(none, none, np.array([5.0, -7.0])))
    on_planet, on_ring = (5.0 + 7.0) * PLANET, 3 * 7.0 * RING
    left = 3 * 5.0 * SUN - 3 * on_planet - on_ring
    np.testing.assert_allclose(brakes, [-3 * 5.0 * SUN, on_planet, on_ring, left], atol=1e-12)


@pytest.mark.parametrize("rotation", [1.0, -1.0])
def test_a_planetary_drive_that_resists_by_hand(drives, rotation):
    """Oil g, hysteresis h and skew b: the planet needs T_1 - T_2 = g_1 + g_2 + b_1 + b_2 + (h_1 + h_2)/R_p.

    The pin takes the forces along its orbit, the sun feels R_s (T_1 + g_1 + b_1) + h_1.
    """
    drive = drives["planetary"]
    drags, moments, brakes = np.array([6.0, 4.0]), np.array([0.05, 0.03]), np.array([2.0, 3.0])

    def rolled(drive, drags, moments, brakes):
        laws = steel_laws(drive=drive, reference_force=1000.0)

        def resists(drags, moments, normal):
            return drags * (normal / normal), moments * (normal / normal)

        def creeps(law, brakes, normal, tangential):
            creepage = creepages(law=law, normal=normal, tangential=tangential)
            return Creeping(creepage, law.friction_coefficient * normal, brakes * (normal / normal))

        load = DriveLoad(
            10.0,
            rotation=rotation,
            resistance_of=Partial(resists, (drags, moments)),
        )
        return drive_states(
            drive=drive,
            laws=laws,
            pattern=np.array([0.0, 1.0]),
            preload=1000.0,
            load=load,
            creep_of=Partial(creeps, (laws.creep, brakes)),
        )

    states = at_once(rolled, drive, drags, moments, brakes)
    assert float(states.rolling.residual) < 1e-9
    # of a drive that rolls backwards the torque drives what it resisted before, and oil, hysteresis, skew resist still
    one, two = rotation * np.asarray(drags)
    turned = rotation * np.asarray(moments)
    first_brake, second_brake = rotation * np.asarray(brakes)
    # what the bearings of the planet bear of skew turns the carrier
    borne = first_brake * (SUN - PLANET) - second_brake * (PLANET + RING)
    force = (10.0 / COUNT - borne) / ORBIT
    along = force + one - 2.0 * one * SUN / ORBIT - two + 2.0 * two * RING / (RING - PLANET)
    resisted = one + two + first_brake + second_brake + turned.sum() / PLANET
    first, second = 0.5 * (along + resisted), 0.5 * (along - resisted)
    assert np.abs(states.rolling.tangential) == pytest.approx([first, second], rel=1e-9)
    assert np.abs(states.rolling.pin_force) == pytest.approx([force], rel=1e-9)
    assert float(states.rolling.input_torque) == pytest.approx(
        COUNT * (SUN * (first + one + first_brake) + turned[0]), rel=1e-9
    )
    # what enters and does not leave is creep, oil, hysteresis and skew
    speed = states.rolling.speed
    surfaces = surface_speeds(drive=drive, speed=speed)
    dragged = COUNT * float(np.sum((drags + brakes) * sum(surfaces)))
    rolling = surfaces[0] / np.array([SUN, PLANET]) + surfaces[1] / np.array([PLANET, -RING])
    shifted = COUNT * float(np.sum(moments * rolling))
    slips = np.abs(surfaces[0] - surfaces[1])
    creep = COUNT * float(np.sum(np.array([first, second]) * slips))
    entered = rotation * float(states.rolling.input_torque * speed[0] - 10.0 * speed[3])
    assert entered == pytest.approx(dragged + shifted + creep, rel=1e-9)
    assert float(states.standing.input_torque) == pytest.approx(10.0 / 6.0, rel=1e-9)

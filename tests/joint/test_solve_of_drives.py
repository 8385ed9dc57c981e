"""Planetary, multiroller and stepped-planet drives from their files: forces and stiffness by hand, refusals."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.joint.solve import refuse_no_rolling, solve_joint
from asperity.joint_file.solved_document import solve_case
from asperity.views.screens import joint_screen, rolling_screen
from asperity.views.terminal import plain_text

ORBIT, COUNT = 30e-3, 3  # of the planetary example


def test_forces_of_the_planetary_by_hand(planetary):
    _, solution, document = planetary
    result, torque = solution.result, 10.0
    assert document["geometry"]["speed_ratio"] == pytest.approx(1.0 + 50.0 / 10.0, rel=1e-12)
    # the carrier pushes each planet; sun and ring take half of it each
    each = torque / (COUNT * ORBIT) / 2.0
    np.testing.assert_allclose(result.forces.tangential, [each, each], rtol=1e-12)
    # the planet pushes its pin in the sense in which the sun turns
    assert document["standing"]["forces"]["pin_N"]["planet"] == pytest.approx(
        {"radial": 0.0, "tangential": 2.0 * each}, rel=1e-12, abs=1e-9
    )
    assert document["standing"]["forces"]["input_torque_Nm"] == pytest.approx(torque / 6.0, rel=1e-12)
    # at rest the planet is pressed alike from both sides; turning, the ring holds it on its orbit
    np.testing.assert_allclose(*result.rest.normal, rtol=1e-12)
    mass = 7810.0 * math.pi * 20e-3**2 * 10e-3
    speed = 1500.0 * 2.0 * math.pi / 60.0 / 6.0
    sun, ring = result.forces.normal
    assert document["standing"]["forces"]["body_mass_kg"]["planet"] == pytest.approx(mass, rel=5e-3)
    planet = document["standing"]["forces"]["body_mass_kg"]["planet"]
    assert ring - sun == pytest.approx(planet * speed**2 * ORBIT, rel=1e-9)
    assert float(solution.result.forces.balance_residual) < 1e-9


def oiled_planet(contacts):
    """Tangential forces of both contacts along the orbit, and what turns the planet against its oil [N]."""
    one, two = (contacts[name]["oil_drag_N"] for name in ("sp", "pr"))
    force = 10.0 / (COUNT * ORBIT)
    return force + one * (1.0 - 2.0 * 10.0 / 30.0) + two * (2.0 * 50.0 / 30.0 - 1.0), one + two


@pytest.mark.long
def test_thrust_and_loss_of_skewed_axes_by_hand(skewed_planetary):
    _, solution, document = skewed_planetary
    found = document["rolling"]["contacts"]
    one, two = (found[name]["axial_force_N"] for name in ("sp", "pr"))
    assert one > 1.0
    assert two < -1.0
    along, drags = oiled_planet(found)
    assert found["sp"]["tangential_N"] == pytest.approx(0.5 * (along + drags), rel=1e-9)
    thrust = document["rolling"]["axial_thrust_N"]
    assert thrust == pytest.approx({"sun": -3.0 * one, "planet": one - two, "ring": 3.0 * two}, rel=1e-12)
    # sideways friction takes from the torque: force times angle times rolling speed
    speed = 1500.0 * math.pi / 30.0 * (1.0 - 1.0 / 6.0) * 10e-3
    expected = COUNT * (one * 0.5e-3 - two * 0.8e-3) * speed
    losses = document["rolling"]["losses_W"]
    assert losses["skew"] == pytest.approx(expected, rel=2e-3)
    assert losses["total"] == pytest.approx(losses["creep"] + losses["oil"] + losses["skew"], rel=1e-12)
    assert np.all(solution.result.rolling.capacity_loss > 0.0)


@pytest.mark.long
def test_at_the_capacity_in_rolling_a_skewed_contact_uses_all_that_skew_leaves(skewed_planetary):
    joint, solution, _ = skewed_planetary
    capacity = float(solution.rolling_capacity.output_torque)
    assert capacity < 0.9 * float(solution.standing_capacity.output_torque)
    rolling = solve_joint(dataclasses.replace(joint, output_torque=capacity)).result.rolling
    left = 0.08 * (1.0 - np.asarray(rolling.capacity_loss)) * np.asarray(rolling.normal)
    used = np.abs(np.asarray(rolling.tangential)) / left
    assert np.max(used) == pytest.approx(1.0, abs=1e-6)
    assert np.argmax(used) == int(solution.rolling_capacity.limiting_contact)


def test_drift_and_power_of_the_planetary(planetary):
    _, _, document = planetary
    rolling = document["rolling"]
    one, two = (contact["creepage"] for contact in rolling["contacts"].values())
    assert one > two > 0.0
    # seen from the carrier the ring's surface is slower than the sun's by both creepages
    assert rolling["speed_loss"] == pytest.approx((one + two) * 50.0 / 60.0, rel=2e-3)
    assert rolling["efficiency"] == pytest.approx(
        rolling["output_power_W"] / rolling["input_power_W"], rel=1e-12
    )
    # creep takes from the speed of what passes the contacts, the oil from the torque on both sides of each
    speed = 1500.0 * math.pi / 30.0
    for name, contact in rolling["contacts"].items():
        rolled = contact["losses_W"]["creep"] / (COUNT * contact["tangential_N"] * contact["creepage"])
        assert rolled == pytest.approx(speed * 5.0 / 6.0 * 10e-3, rel=2e-3), name
        assert contact["losses_W"]["oil"] == pytest.approx(
            2.0 * COUNT * contact["oil_drag_N"] * rolled, rel=1e-9
        )
    turns = rolling["output_power_W"] / 10.0 / (2.0 * math.pi)
    assert rolling["life_hours"] * 3600.0 * turns == pytest.approx(rolling["life_output_turns"], rel=1e-9)
    assert list(rolling["body_life_hours"]) == ["sun", "planet", "ring"]
    # the motor feeds all of it: without losses 10 N·m/6, over the efficiency and the speed that creep takes
    share = rolling["efficiency"] / (1.0 - rolling["speed_loss"])
    assert rolling["input_torque_Nm"] == pytest.approx(10.0 / 6.0 / share, rel=1e-9)


def test_the_oil_brakes_the_drive_at_its_contacts(planetary):
    """What the motor feeds by the powers is what the contacts and their oil do to the sun, by its moment balance."""
    _, solution, document = planetary
    rolling, found = solution.result.rolling, document["rolling"]
    tangential, drag = np.asarray(rolling.tangential), np.asarray(rolling.drag)
    assert np.all(drag > 0.0)
    along, drags = oiled_planet(found["contacts"])
    np.testing.assert_allclose(tangential, [0.5 * (along + drags), 0.5 * (along - drags)], rtol=1e-9)
    assert found["input_torque_Nm"] == pytest.approx(COUNT * 10e-3 * (tangential[0] + drag[0]), rel=1e-9)
    # Biboulet and Houpert's force where the bodies deform, 1.47 U^(3/4) E' R a length
    scale, speed = 2.0 * 206e9 / 1.82 * 20e-3 / 3.0, 1500.0 * math.pi / 30.0 * (5.0 / 6.0) * 10e-3
    assert drag[0] == pytest.approx(10e-3 * 1.47 * (2.0 * 0.03 * speed / scale) ** 0.75 * scale, rel=0.02)


def test_the_tables_name_contacts_members_and_bodies(planetary_view):
    document = planetary_view.document
    losses = sum(loss or 0.0 for cause, loss in document["losses_W"].items() if cause != "total")
    power_out = (
        10.0 * document["standing"]["forces"]["output_speed_rad_per_s"] * (1.0 - document["speed_loss"])
    )
    power_in = power_out + losses
    for screen, said in (
        (
            joint_screen,
            ["planetary drive", "sun in, carrier out, ring grounded", "contact sp slips", "Speed ratio"],
        ),
        (
            rolling_screen,
            ["drift per output turn", "one planet", f"efficiency {100.0 * power_out / power_in:.4g} %"],
        ),
    ):
        text = plain_text(screen(planetary_view, "planetary.toml"))
        assert all(words in text for words in said)


def test_a_torque_beyond_the_capacity_is_refused(planar_case):
    slow = planar_case("planetary", replaced={'"10 N*m"': '"13 N*m"'})
    with pytest.raises(
        InputError,
        match=r"13 N·m is beyond the standing torque capacity 12\.1\d N·m, at which contact sp slips",
    ) as refused:
        solve_case(slow)
    interference = str(refused.value).split("raise the interference (load.interference) to ")[1].split(",")[0]
    tighter = planar_case("planetary", replaced={'"10 N*m"': '"13 N*m"', '"30 um"': f'"{interference}"'})
    assert float(solve_case(tighter)[0].solution.standing_capacity.output_torque) == pytest.approx(
        13.0, rel=0.01
    )


def test_an_interference_without_a_balance_is_told(planar_case):
    thick = planar_case("planetary", replaced={'"30 um"': '"3 mm"'})
    with pytest.raises(NoSolutionError, match="with an interference of 3000 um no state was found"):
        solve_case(thick)


def test_bodies_that_do_not_fit_are_refused(planar_case):
    fast = planar_case("planetary", replaced={'"1500 rpm"': '"60000 rpm"'})
    with pytest.raises(
        InputError,
        match=r"at which contact sp lifts off; raise the interference \(load.interference\), or lower the speed",
    ):
        solve_case(fast)
    with pytest.raises(InputError, match=r"neighbours of planet overlap by 10 mm"):
        solve_case(planar_case("planetary", replaced={"planets = 3": "planets = 6"}))
    with pytest.raises(InputError, match=r"the bore of planet, 45 mm, leaves no wall in a roller of 40 mm"):
        solve_case(planar_case("planetary_hollow", replaced={'"26 mm"': '"45 mm"'}))
    with pytest.raises(
        NoSolutionError,
        match=r"no state was found .* the thinnest wall is that of planet: its bore_diameter of 39\.9999 mm leaves "
        r"0\.05 um of 40 mm$",
    ):
        solve_case(planar_case("planetary_hollow", replaced={'"26 mm"': '"39.9999 mm"'}))
    wide = {"[drive]": '[drive]\nplanet_bore_diameter = "24 mm"'}
    with pytest.raises(
        InputError, match=r"the bore of planet, 24 mm, is wider than 0\.65 .* 23\.4 mm: beyond"
    ):
        solve_case(planar_case("stepped_planet", replaced=wide))
    with pytest.raises(InputError, match="there is no place for second_row where it touches"):
        solve_case(
            planar_case(
                "multiroller",
                replaced={'first_row_small_radius = "10 mm"': 'first_row_small_radius = "0.1 mm"'},
            )
        )


@pytest.mark.long
def test_preload_and_interference_make_each_other(planar_case):
    by_size = solve_case(planar_case("planetary")).document["preload"]
    text = {'interference = "30 um"': f'preload = "{by_size["force_N"]!r} N"'}
    by_force = solve_case(planar_case("planetary", replaced=text)).document["preload"]
    assert by_force["interference_m"] == pytest.approx(30e-6, rel=1e-6)


@pytest.mark.long
def test_hollow_planets_are_softer(planar_case):
    """A thin planet is the preload's spring: the same interference presses less, and the stiffness falls."""
    hollow, thick = (
        solve_case(planar_case("planetary_hollow", replaced={'"26 mm"': bore})).document
        for bore in ('"26 mm"', '"8 mm"')
    )
    assert hollow["preload"]["force_N"] < 0.7 * thick["preload"]["force_N"]
    assert hollow["standing"]["forces"]["body_mass_kg"]["planet"] / thick["standing"]["forces"][
        "body_mass_kg"
    ]["planet"] == pytest.approx((40.0**2 - 26.0**2) / (40.0**2 - 8.0**2), rel=1e-9)
    stiffness = [each["torsional_stiffness"]["assembly"]["output_Nm_per_rad"] for each in (hollow, thick)]
    assert stiffness[0] < stiffness[1]


@pytest.mark.slow
def test_the_multiroller_by_hand(planar_case):
    document = solve_case(planar_case("multiroller")).document
    orbit, half = 26.0, math.pi / 4.0
    far = orbit * math.cos(half) + math.sqrt(28.0**2 - (orbit * math.sin(half)) ** 2)
    ring = far + 9.4
    ratio = (16.0 / 10.0) * (18.0 / 10.0) * (ring / 9.4)
    assert abs(document["geometry"]["speed_ratio"]) == pytest.approx(ratio, rel=1e-12)
    assert ratio == pytest.approx(15.0, rel=0.01)
    forces = document["standing"]["forces"]
    assert forces["input_torque_Nm"] == pytest.approx(10.0 / ratio, rel=1e-9)
    tangential = forces["tangential_N"]
    assert tangential["sr"] == pytest.approx(10.0 / (4.0 * ring * 1e-3), rel=1e-9)
    assert tangential["sf"] == pytest.approx(10.0 / ratio / (4.0 * 10e-3), rel=1e-9)
    # at rest the first row is pressed by two rollers against the sun, the second row by the ring between two
    rest = forces["normal_without_torque_N"]
    lean = math.asin(orbit * math.sin(half) / 28.0)  # at the second row, from its radius to the first row
    assert rest["fsl"] == pytest.approx(rest["fsr"], rel=1e-9)
    assert rest["sr"] == pytest.approx(2.0 * rest["fsl"] * math.cos(lean), rel=1e-9)
    assert rest["sf"] == pytest.approx(2.0 * rest["fsl"] * math.cos(lean + half), rel=1e-9)


@pytest.mark.slow
def test_stepped_planets_by_hand(planar_case):
    document = solve_case(planar_case("stepped_planet")).document
    ratio = (1.0 + 50.0 / 10.0) / (1.0 - 50.0 * 18.0 / (48.0 * 20.0))
    assert document["geometry"]["speed_ratio"] == pytest.approx(ratio, rel=1e-12)
    forces = document["standing"]["forces"]
    tangential, sun, ring = forces["tangential_N"], 10.0 / ratio / (3.0 * 10e-3), 10.0 / (3.0 * 48e-3)
    assert abs(tangential["sp"]) == pytest.approx(sun, rel=1e-9)
    assert abs(tangential["pr2"]) == pytest.approx(ring, rel=1e-9)
    # the free cage takes no torque: the forces on a planet balance by themselves
    assert abs(tangential["pr1"]) == pytest.approx(ring - sun, rel=1e-9)
    assert forces["pin_N"]["planet"] == pytest.approx({"radial": 0.0, "tangential": 0.0}, abs=1e-9)
    rest = forces["normal_without_torque_N"]
    assert rest["sp"] == pytest.approx(rest["pr1"] + rest["pr2"], rel=1e-9)


@pytest.mark.slow
def test_a_joint_without_creep_is_told(planar_case):
    """A surface so rough that every spot is plastic has no stiffness for its creep."""
    solved, document = solve_case(planar_case("planetary", replaced={'"1.3e-7 mm"': '"1e-2 mm"'}))
    assert document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"] is None
    with pytest.raises(NoSolutionError, match="every spot of a contact is plastic"):
        refuse_no_rolling(solved.joint, solved.solution)


@pytest.mark.long
def test_the_papers_drive_as_a_list_of_rollers(planar_case):
    """Forces at rest by hand, and the balance of torques."""
    document = solve_case(planar_case("planar")).document
    theta, beta = math.radians(27.083145), math.radians(13.158247)
    side = 500.0 / math.cos(theta)
    rest = document["standing"]["forces"]["normal_without_torque_N"]
    by_hand = [1000.0, side, side, side * math.cos(beta), side * math.cos(beta)]
    np.testing.assert_allclose(list(rest.values()), by_hand, rtol=1e-6)
    assert document["geometry"]["speed_ratio"] == pytest.approx(-9.0, rel=1e-9)
    assert document["standing"]["forces"]["input_torque_Nm"] == pytest.approx(5.0 / 9.0, rel=1e-9)
    assert document["rolling"]["residual"] < 1e-9


@pytest.mark.long
def test_a_thin_ring_is_the_spring_of_the_preload(planar_case):
    """Thin-ring theory: three loads bend a free ring by 0.01593859 P R^3/EI, stretch and shear it."""
    force, radius, wall, length = 100.0, 51.5e-3, 3e-3, 10e-3
    young, poisson = 203e9, 0.29  # of 52100 in the library
    modulus, area, inertia = young / (1.0 - poisson**2), wall * length, length * wall**3 / 12.0
    bending = 0.01593859 * force * radius**3 / (modulus * inertia)
    stretching = 0.49340 * force * radius / (modulus * area)
    shear = 0.20473 * force * radius * 1.2 * 2.0 * (1.0 + poisson) / (young * area)
    text = {'"8 mm"': '"3 mm"', 'interference = "30 um"': 'preload = "100 N"', '"10 N*m"': '"0.1 N*m"'}
    free = solve_case(planar_case("planetary", replaced=text)).document
    held_text = text | {'ring_support = "free"': 'ring_support = "rigid_housing"'}
    held = solve_case(planar_case("planetary", replaced=held_text)).document
    found = free["preload"]["interference_m"] - held["preload"]["interference_m"]
    assert found == pytest.approx(bending + stretching + shear, rel=0.02)

"""Layouts that cannot exist are refused with their numbers."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.drive import CARRIER, Body, Contact, speeds
from asperity.drive.layout.existence import (
    LEAST_OUTPUT_SHARE,
    has_room,
    neighbour_gaps,
    output_share,
    pulling_contacts,
    refuse_impossible,
)
from asperity.drive.layout.unfolding import unfolded
from asperity.drive.types.multiroller import two_row_multiroller
from asperity.drive.types.planetary import planetary_drive
from asperity.drive.types.stepped_planet import stepped_planet_drive
from asperity.errors import InputError

# the difference of two ways to square this distance is not 0 in NumPy
AWKWARD = (0.0, 0.030627527170000002)


def test_bodies_that_do_not_touch_are_named(drives):
    drive = drives["planetary"]
    larger = dataclasses.replace(drive, second_radius=jnp.asarray(drive.second_radius).at[1].add(1e-4))
    with pytest.raises(InputError, match=r"contact pr: planet and ring do not touch \(gap 0\.1 mm\)"):
        refuse_impossible(larger)


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_room_is_judged_as_it_is_refused(drives, compiled):
    drive = drives["planetary"]
    apart = dataclasses.replace(drive, second_radius=jnp.asarray(drive.second_radius).at[1].add(1e-4))
    crowded = dataclasses.replace(drive, sectors=jnp.asarray(30.0))
    nowhere = dataclasses.replace(drive, centres=jnp.full_like(drive.centres, jnp.nan))
    judge = jax.jit(has_room) if compiled else has_room
    assert [bool(judge(each)) for each in (drive, apart, crowded, nowhere)] == [True, False, False, False]
    for each in (apart, crowded, nowhere):
        with pytest.raises(InputError):
            refuse_impossible(each)


def test_gaps_are_judged_by_the_size_of_the_drive(drives):
    """A nanometre is 2e-8 of the ring's radius: a gap. In a drive a million times smaller all is as before."""
    drive = drives["planetary"]
    with pytest.raises(InputError, match=r"do not touch \(gap 1e-06 mm\)"):
        refuse_impossible(
            dataclasses.replace(drive, second_radius=jnp.asarray(drive.second_radius).at[1].add(1e-9))
        )
    small = {name: getattr(drive, name) * 1e-6 for name in ("centres", "first_radius", "second_radius")}
    refuse_impossible(dataclasses.replace(drive, **small))


def test_degrees_of_freedom_are_counted(drives):
    drive = drives["planetary"]
    loose = dataclasses.replace(
        drive,
        bodies=(*drive.bodies, Body("idle", "axis")),
        centres=jnp.concatenate([drive.centres, jnp.zeros((1, 2))]),
    )
    with pytest.raises(InputError, match="2 degrees of freedom; it must have 1: ground another member"):
        refuse_impossible(loose)
    with pytest.raises(InputError, match="there is no member 'rim'"):
        refuse_impossible(dataclasses.replace(drive, grounded="rim"))


def test_sizes_and_places_decide_the_overlap(drives):
    """Neighbouring planets: centres 2 * 30 mm * sin(180 deg / n) apart, 42.43 mm for four, 35.27 mm for five."""
    refuse_impossible(dataclasses.replace(drives["planetary"], sectors=4))
    with pytest.raises(
        InputError, match=r"neighbours of planet overlap by 4\.7328\d mm; reduce their radii, or how many"
    ):
        refuse_impossible(dataclasses.replace(drives["planetary"], sectors=5))


def test_rollers_without_a_place_are_named():
    """Three rollers on 32 mm: neighbours 2 * 32 mm * sin(60 deg) = 55.4 mm apart, more than 2 * 27 mm."""
    apart = two_row_multiroller(
        sun_radius=10e-3, first_row_radii=(22e-3, 9e-3), second_row_radii=(18e-3, 14e-3), roller_count=3
    )
    with pytest.raises(InputError, match="no place for second_row"):
        refuse_impossible(apart)


def test_contacts_that_block_each_other(drives):
    """Between two planets that touch there is no rolling: both turn in one sense."""
    radius = 10e-3 / (
        1.0 / jnp.sin(jnp.pi / 4.0) - 1.0
    )  # four planets that just touch: sin 45 deg = p/(s + p)
    drive = drives["planetary"]
    locked = dataclasses.replace(
        drive,
        contacts=(*drive.contacts, Contact("pp", "planet", "planet", sector=1)),
        first_radius=jnp.array([10e-3, radius, radius]),
        second_radius=jnp.array([radius, 10e-3 + 2.0 * radius, radius]),
        centres=jnp.asarray(drive.centres).at[1, 1].set(10e-3 + radius),
        sectors=4,
    )
    with pytest.raises(
        InputError, match="0 degrees of freedom; it must have 1: the contacts block each other"
    ):
        refuse_impossible(locked)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_a_cage_that_nothing_carries_is_no_freedom(drives):
    """Planets on the ring and the sun alone, held by no pin: the carrier has no say in their speeds."""
    drive = drives["planetary"]
    free = dataclasses.replace(
        drive,
        bodies=(drive.bodies[0], Body("planet", "free"), drive.bodies[2]),
        push_angles=jnp.zeros(0),
        output="ring",
        grounded=CARRIER,
    )
    refuse_impossible(free)
    sun, planet, ring, carrier = speeds(free)
    assert [float(each / sun) for each in (planet, ring, carrier)] == pytest.approx(
        [-10.0 / 20.0, -10.0 / 50.0, 0.0], abs=1e-12
    )


def test_gaps_between_neighbours(drives):
    # planets of 20 mm on an orbit of 30 mm, three of them
    chord = 2.0 * 30e-3 * math.sin(math.pi / 3.0)
    assert neighbour_gaps(drives["planetary"]) == {
        ("planet", "planet"): pytest.approx(chord - 40e-3, rel=1e-12)
    }
    # the paper's joint by its radii: centres of the loading rollers at 35 mm from the axis, 18.5 mm from the planet's
    found = neighbour_gaps(drives["wedge"])
    sun, planet, roller, orbit = 4e-3, 13.5e-3, 5e-3, 35e-3
    cosine = ((sun + planet) ** 2 + orbit**2 - (planet + roller) ** 2) / (2.0 * (sun + planet) * orbit)
    apart = math.acos(cosine)
    between = 2.0 * orbit * math.sin(apart)
    assert found["right_loading_roller", "left_loading_roller"] == pytest.approx(
        between - 2.0 * roller, rel=1e-9
    )
    assert found["sun", "right_loading_roller"] == pytest.approx(orbit - sun - roller, rel=1e-9)
    assert found["planet", "planet"] == pytest.approx(
        2.0 * (sun + planet) * math.sin(math.pi / 3.0) - 2.0 * planet
    )


def test_one_planet_alone_has_no_neighbour(drives):
    alone = dataclasses.replace(drives["planetary"], sectors=1)
    refuse_impossible(alone)
    assert neighbour_gaps(alone) == {("planet", "planet"): math.inf}
    alone = jax.tree.map(lambda leaf: np.array(leaf, dtype=float), alone)
    alone.centres[alone.members.index("planet")] = AWKWARD
    assert neighbour_gaps(alone) == {("planet", "planet"): math.inf}


def test_two_rollers_at_one_place_overlap_by_their_sizes(drives):
    whole = unfolded(drives["planetary"], sectors=3, floating=())
    whole = jax.tree.map(lambda leaf: np.array(leaf, dtype=float), whole)
    whole.centres[[whole.members.index(name) for name in ("planet_1", "planet_2")]] = AWKWARD
    assert neighbour_gaps(whole)["planet_1", "planet_2"] == pytest.approx(-40e-3, rel=1e-12)


def test_the_number_of_planets_may_vary():
    def gap(count):
        drive = planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=count)
        return neighbour_gaps(drive)["planet", "planet"]

    slope = -2.0 * 30e-3 * math.cos(math.pi / 4.0) * math.pi / 16.0
    assert jax.grad(gap)(4.0) == pytest.approx(slope, rel=1e-12)


@pytest.mark.parametrize(("count", "radius"), [(4, 16e-3), (4, 22e-3), (5, 16e-3)])
def test_rows_that_push_the_first_one_outward_are_refused(count, radius):
    """By hand: the second row presses the first one onto the sun where y_1 + x_2 > (s + x_1) tan(pi/n)."""
    limit = (10e-3 + radius) * math.tan(math.pi / count) - 9e-3
    for second, pulling in ((1.001 * limit, ()), (0.999 * limit, ("sf",))):
        drive = two_row_multiroller(
            sun_radius=10e-3,
            first_row_radii=(radius, 9e-3),
            second_row_radii=(second, 9e-3),
            roller_count=count,
        )
        assert pulling_contacts(drive) == pulling


def test_a_contact_that_would_have_to_pull_is_named(drives):
    for drive in drives.values():
        assert pulling_contacts(drive) == ()
    drive = two_row_multiroller(
        sun_radius=10e-3, first_row_radii=(16e-3, 12e-3), second_row_radii=(12e-3, 9e-3), roller_count=4
    )
    with pytest.raises(
        InputError, match="no interference presses all contacts of this drive: sf would have to pull"
    ):
        refuse_impossible(drive)


def test_an_output_that_stands_still_is_refused(drives):
    """Both tracks of the planets are alike: the driven ring stands as the grounded one does."""
    still = stepped_planet_drive(sun_radius=10e-3, planet_radii=(20e-3, 20e-3), planet_count=3)
    assert float(output_share(still)) < LEAST_OUTPUT_SHARE
    with pytest.raises(InputError, match="driven_ring, the output, stands still whatever sun does"):
        refuse_impossible(still)
    drive = drives["stepped"]
    fastest = float(jnp.max(jnp.abs(speeds(drive))))
    ratio = (1.0 + 50.0 / 10.0) / (
        1.0 - 50.0 * 18.0 / (48.0 * 20.0)
    )  # of the sun to the driven ring, by hand
    assert float(output_share(drive)) == pytest.approx(1.0 / ratio / fastest, rel=1e-9)

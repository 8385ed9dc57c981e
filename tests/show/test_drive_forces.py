"""Forces on the rollers of a drive: their sums are those of the matrices that balance the drive."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.drive.state.loads import member_loads
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.rolling.turning import driving_sense
from asperity.show.drive_forces import body_forces


@pytest.fixture
def drawn(zou_file):
    """Joint and loads of an example under any forces of its contacts, and the forces that are drawn."""

    def make(name):
        joint = joint_from_case(read_case(zou_file.with_name(f"{name}.toml")))
        count = len(joint.drive.contacts)
        normal, tangential = 1000.0 + 100.0 * np.arange(count), 50.0 + 7.0 * np.arange(count) ** 2
        loads = member_loads(
            drive=joint.drive,
            normal=normal,
            tangential=np.asarray(driving_sense(joint.drive)) * tangential,
            body_force=np.zeros((len(joint.drive.floating), 2)),
        )
        forces = SimpleNamespace(normal=normal, tangential=tangential, pins=np.asarray(loads.pin))
        return joint, loads, body_forces(joint, SimpleNamespace(forces=forces))

    return make


def radius_of(joint, force):
    drive = joint.drive
    contact = next(each for each in drive.contacts if each.name == force.name)
    radii = drive.first_radius if contact.first == force.body else drive.second_radius
    return float(radii[drive.contacts.index(contact)])


@pytest.mark.parametrize("name", ["planetary", "multiroller", "stepped_planet", "planar", "zou2025"])
def test_forces_and_moments_on_each_roller_are_those_of_the_balance(drawn, name):
    """Whatever the contacts do, what pins do not hold is left over on the rollers."""
    joint, loads, found = drawn(name)
    for row, number in enumerate(joint.drive.floating):
        body = joint.drive.bodies[number].name
        mine = [each for each in found if each.body == body]
        total = sum(each.size * np.array(each.direction) for each in mine)
        np.testing.assert_allclose(total, np.asarray(loads.unbalanced)[row], atol=1e-9)
        moment = sum(
            radius_of(joint, each)
            * each.size
            * (each.place[0] * each.direction[1] - each.place[1] * each.direction[0])
            for each in mine
            if each.kind == "T"
        )
        assert moment == pytest.approx(float(loads.moments[number]), abs=1e-9)


def test_a_planetary_by_hand(drawn):
    """The first planet is above the sun: pushed up by it and down by the ring; its pin holds it back."""
    _, _, found = drawn("planetary")
    planet = {(each.name, each.kind): each for each in found if each.body == "planet"}
    assert set(planet) == {("sp", "N"), ("sp", "T"), ("pr", "N"), ("pr", "T"), ("pin", "F")}
    sun = planet["sp", "N"]
    assert sun.place == pytest.approx((0.0, -1.0), abs=1e-12)
    assert sun.size * np.array(sun.direction) == pytest.approx((0.0, 1000.0), abs=1e-9)
    ring = planet["pr", "N"]
    assert ring.place == pytest.approx((0.0, 1.0), abs=1e-12)
    assert ring.size * np.array(ring.direction) == pytest.approx((0.0, -1100.0), abs=1e-9)
    # the sun turns counter-clockwise: sun and ring push the planet to the left, 50 N and 57 N, the pin to the right
    pin = planet["pin", "F"]
    assert pin.size * np.array(pin.direction) == pytest.approx((107.0, 0.0), abs=1e-9)
    of_ring = [each for each in found if each.body == "ring" and each.kind == "N"]
    assert [each.size * each.direction[1] for each in of_ring] == pytest.approx([1100.0])
    assert math.hypot(*of_ring[0].place) == pytest.approx(1.0)

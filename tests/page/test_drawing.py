"""The shapes of a drive for the browser: centres by the law of cosines, forces where the bodies touch."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.page.drawing import drive_shapes

NORMAL = np.array([1000.0, 600.0, 500.0, 590.0, 490.0])
TANGENTIAL = np.array([46.0, 26.0, 20.0, 26.0, 20.0])


@pytest.fixture(scope="module")
def shapes(paper_joint):
    forces = SimpleNamespace(normal=NORMAL, tangential=TANGENTIAL, pins=np.ones(2))
    return drive_shapes(paper_joint(), SimpleNamespace(forces=forces))


def test_every_roller_in_its_place(shapes):
    rollers = shapes["rollers"]
    counts = {name: sum(each["body"] == name for each in rollers) for name in ("sun", "planet")}
    assert counts == {"sun": 1, "planet": 3}
    assert len(rollers) == 10
    orbit = {"sun": 0.0, "planet": 17.5e-3}
    for each in rollers:
        expected = orbit.get(each["body"], 35e-3)
        assert math.hypot(each["x_m"], each["y_m"]) == pytest.approx(expected, abs=1e-12)
    (ring,) = shapes["rings"]
    assert (ring["inner_radius_m"], ring["wall_m"]) == pytest.approx((40e-3, 10e-3))


def test_forces_act_where_the_bodies_touch(shapes):
    forces = {each["contact"]: each for each in shapes["forces"]}
    assert list(forces) == ["sp", "pwr", "pwl", "wro", "wlo"]
    assert (forces["sp"]["x_m"], forces["sp"]["y_m"]) == pytest.approx((0.0, 4e-3), abs=1e-12)
    for name in ("wro", "wlo"):  # on the ring
        assert math.hypot(forces[name]["x_m"], forces[name]["y_m"]) == pytest.approx(40e-3, rel=1e-9)
        assert forces[name]["on"].endswith("loading roller")
    # the planet presses the sun inwards; every normal and tangential force has its size
    np.testing.assert_allclose(forces["sp"]["normal_N"], [0.0, -1000.0], atol=1e-9)
    for name, normal, tangential in zip(forces, NORMAL, TANGENTIAL, strict=True):
        assert math.hypot(*forces[name]["normal_N"]) == pytest.approx(normal, rel=1e-12)
        assert math.hypot(*forces[name]["tangential_N"]) == pytest.approx(tangential, rel=1e-12)
        assert np.dot(forces[name]["normal_N"], forces[name]["tangential_N"]) == pytest.approx(0.0, abs=1e-6)
    # the ring presses the loading rollers inwards
    right = forces["wro"]
    assert np.dot(right["normal_N"], [right["x_m"], right["y_m"]]) < 0.0


def test_circles_and_forces_of_another_drive(zou_file):
    """A planetary: sun 10 mm, three planets of 20 mm, a ring of 50 mm with a wall of 8 mm."""
    joint = joint_from_case(read_case(zou_file.with_name("planetary.toml")))
    forces = SimpleNamespace(
        normal=np.array([1000.0, 1100.0]), tangential=np.array([50.0, 60.0]), pins=np.array([-110.0])
    )
    found = drive_shapes(joint, SimpleNamespace(forces=forces))
    assert found["rings"] == [{"body": "ring", "inner_radius_m": pytest.approx(50e-3), "wall_m": 8e-3}]
    rollers = [(each["body"], round(1e3 * each["radius_m"], 9)) for each in found["rollers"]]
    assert rollers == [("sun", 10.0)] + 3 * [("planet", 20.0)]
    for each in found["rollers"][1:]:
        assert math.hypot(each["x_m"], each["y_m"]) == pytest.approx(30e-3)
    sun, ring = found["forces"]
    assert (sun["on"], ring["on"]) == ("sun", "planet")
    planet = found["rollers"][1]
    outward = np.array([planet["x_m"], planet["y_m"]]) / 30e-3
    np.testing.assert_allclose([sun["x_m"], sun["y_m"]], 10e-3 * outward, atol=1e-12)
    np.testing.assert_allclose([ring["x_m"], ring["y_m"]], 50e-3 * outward, atol=1e-12)
    np.testing.assert_allclose(sun["normal_N"], -1000.0 * outward, atol=1e-9)
    np.testing.assert_allclose(ring["normal_N"], -1100.0 * outward, atol=1e-9)
    # the sun turns counter-clockwise: the planet holds it back; sun and ring push the planet the way the carrier goes
    clockwise = np.array([outward[1], -outward[0]])
    np.testing.assert_allclose(sun["tangential_N"], 50.0 * clockwise, atol=1e-9)
    np.testing.assert_allclose(ring["tangential_N"], -60.0 * clockwise, atol=1e-9)
    (free,) = found["bodies"]
    assert (free["body"], free["radii_m"]) == ("planet", [pytest.approx(20e-3)])
    kinds = [(each["name"], each["kind"]) for each in free["forces"]]
    assert kinds == [
        ("sp", "normal"),
        ("sp", "tangential"),
        ("pr", "normal"),
        ("pr", "tangential"),
        ("pin", "pin"),
    ]
    assert [each["radius_m"] for each in free["forces"][:4]] == pytest.approx([20e-3] * 4)
    # what the sun takes from the planet, the planet takes from the sun; the pin holds what the contacts push
    np.testing.assert_allclose(free["forces"][0]["force_N"], 1000.0 * outward, atol=1e-9)
    np.testing.assert_allclose(free["forces"][1]["force_N"], -50.0 * clockwise, atol=1e-9)
    np.testing.assert_allclose(free["forces"][4]["force_N"], 110.0 * clockwise, atol=1e-9)


def test_a_stepped_roller_has_a_radius_for_each_force(zou_file):
    joint = joint_from_case(read_case(zou_file.with_name("stepped_planet.toml")))
    one = np.ones(3)
    found = drive_shapes(joint, SimpleNamespace(forces=SimpleNamespace(normal=one, tangential=one, pins=one)))
    (free,) = found["bodies"]
    assert sorted(free["radii_m"]) == pytest.approx([18e-3, 20e-3])
    radii = {each["name"]: each["radius_m"] for each in free["forces"]}
    assert radii == pytest.approx({"sp": 20e-3, "pr1": 20e-3, "pr2": 18e-3, "pin": 0.0})


def test_a_hollow_roller_has_its_bore_in_both_pictures(zou_file):
    joint = joint_from_case(read_case(zou_file.with_name("planetary_hollow.toml")))
    one = np.ones(2)
    forces = SimpleNamespace(normal=one, tangential=one, pins=one[:1])
    found = drive_shapes(joint, SimpleNamespace(forces=forces))
    bore = 0.5 * next(float(shape.size) for shape in joint.shapes if shape.kind == "hollow")
    (free,) = found["bodies"]
    planets = [each["radius_m"] for each in found["rollers"] if each["body"] == "planet"]
    for radii in (free["radii_m"], planets):
        assert sorted(set(radii)) == pytest.approx([bore, 20e-3])

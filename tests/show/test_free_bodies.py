"""Forces on the bodies drawn apart: every body is in balance, and every arrow points as its force."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.joint.solve import solve
from asperity.show.free_bodies import body_forces, free_bodies
from asperity.show.sheet import Circle, Line, Text
from asperity.show.sheet_figure import text_width


@pytest.fixture(scope="module")
def standing():
    from pathlib import Path

    from asperity.joint_file.build import joint_from_values
    from asperity.joint_file.reader import read_case
    from asperity.joint_file.si_tables import replace_values, si_values

    file = Path(__file__).parents[2] / "examples" / "zou2025.toml"
    changes = {"load.sun_speed": 0.0, "drive.left_push_angle": 0.1, "drive.right_push_angle": -0.05}
    joint = joint_from_values(replace_values(si_values(read_case(file)), changes))
    return joint, solve(joint).result.forces


def test_every_body_is_in_balance(standing):
    """Drawn vectors add up to nothing: the sun stands, so there are no centrifugal forces."""
    found = body_forces(*standing)
    for body in {force.body for force in found}:
        vectors = [force.size * np.array(force.direction) for force in found if force.body == body]
        moments = [
            force.place[0] * force.direction[1] * force.size
            - force.place[1] * force.direction[0] * force.size
            for force in found
            if force.body == body
        ]
        assert np.abs(np.sum(vectors, axis=0)).max() < 1e-6 * max(abs(force.size) for force in found)
        assert abs(sum(moments)) < 1e-6 * max(abs(force.size) for force in found)


def test_action_equals_reaction_between_planet_and_rollers(standing):
    found = {(f.body.split()[0], f.name, f.kind): f for f in body_forces(*standing)}
    for side, name in (("right", "pwr"), ("left", "pwl")):
        for kind in "NT":
            a, b = found["planet", name, kind], found[side, name, kind]
            assert a.size == b.size
            assert np.allclose(np.add(a.direction, b.direction), 0.0)


def test_pins_pass_the_torque_of_the_carrier(standing):
    joint, forces = standing
    arm = 35e-3  # R_o - R_w
    found = {f.body.split()[0]: f for f in body_forces(joint, forces) if f.kind == "F"}
    moment = 0.0
    polar = math.acos((17.5**2 + 35.0**2 - 18.5**2) / (2.0 * 17.5 * 35.0))
    for side, sign in (("right", 1.0), ("left", -1.0)):
        x, y = sign * arm * math.sin(polar), arm * math.cos(polar)
        moment += (
            x * found[side].direction[1] * found[side].size - y * found[side].direction[0] * found[side].size
        )
    assert abs(3.0 * moment) == pytest.approx(5.0, rel=1e-6)


def test_view_has_three_bodies_an_arrow_for_each_force_and_every_number(standing):
    joint, forces = standing
    items = free_bodies(joint, forces, centre=(10.0, 20.0), scale=2.0, room=200.0)
    planet, right, left = [item for item in items if isinstance(item, Circle)]
    assert planet.centre == (10.0, 20.0)
    assert planet.radius / right.radius == pytest.approx(13.5 / 5.0)
    assert left.centre[0] < 10.0 < right.centre[0]
    assert math.dist(planet.centre, right.centre) > planet.radius + right.radius
    assert len([item for item in items if isinstance(item, Line)]) == 16
    texts = [item.text for item in items if isinstance(item, Text)]
    for name in ("sp", "pwr", "pwl", "wro", "wlo"):
        assert sum(text.startswith(f"{name}: N = ") and text.endswith(" N") for text in texts) == 1
    assert sum(text.startswith("pin: ") for text in texts) == 2
    normal = next(item for item in items if isinstance(item, Line))  # of the sun on the planet: upwards
    assert normal.points[1] == pytest.approx((10.0, 20.0 - planet.radius))
    assert normal.points[0][1] < normal.points[1][1]


def overlaps(text, line):
    """Whether a line crosses the letters of a text that is centred or at one side of its place."""
    left = {"left": 0.0, "center": 0.5, "right": 1.0}[text.align]
    width = text_width(text.text)
    low = np.array(text.at) - np.array([left * width, 0.0])
    high = low + np.array([width, 2.5])
    points = np.linspace(*map(np.array, line.points), 40)
    return bool(np.any(np.all((points > low) & (points < high), axis=1)))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("planet", "roller", "sun", "ring"),
    [(13.5, 5.0, 4.0, 40.0), (13.0, 5.0, 5.0, 39.0), (8.0, 9.0, 20.0, 48.0), (15.0, 9.0, 3.0, 40.0)],
)
def test_the_view_keeps_to_its_room_and_no_number_covers_an_arrow(standing, planet, roller, sun, ring):
    """Sizes in mm, up to rollers beside the planet rather than above it."""
    joint, forces = standing
    radii = {
        "sun_radius": sun, "planet_radius": planet, "loading_roller_radius": roller, "ring_radius": ring
    }  # fmt: skip
    geometry = dataclasses.replace(joint.geometry, **{name: 1e-3 * each for name, each in radii.items()})
    joint = dataclasses.replace(joint, geometry=geometry)
    items = free_bodies(joint, forces, centre=(0.0, 0.0), scale=1.0, room=136.0)
    texts = [item for item in items if isinstance(item, Text)]
    lines = [item for item in items if isinstance(item, Line)]
    for text in texts:
        left = {"left": 0.0, "center": 0.5, "right": 1.0}[text.align]
        assert text.at[0] - left * text_width(text.text) >= -68.0
        assert text.at[0] + (1.0 - left) * text_width(text.text) <= 68.0
        assert not any(overlaps(text, line) for line in lines), text.text
    for item in items:
        if isinstance(item, Circle):
            assert abs(item.centre[0]) + item.radius <= 68.0

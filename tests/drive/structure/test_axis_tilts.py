"""Slopes and skews of contacts between tilted axes: an independent computation, least energy, and by hand."""

import dataclasses
import itertools

import numpy as np
import pytest
from scipy.optimize import minimize

from asperity.drive.layout.drive import Body, Contact, Drive
from asperity.drive.layout.unfolding import unfolded
from asperity.drive.structure.axis_tilts import AxisTilts, contact_angles_of_tilts
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.template import template

#: K of the check joint of the companion tables, sp pwr pwl wro wlo [N·m/rad].
STIFFNESS = np.array([563.5, 542.6, 516.4, 579.1, 547.8])


def drive_of(name):
    return joint_from_case(parse_case(template(name), source=name)).drive


def tilted(name="sun", out=0.0, across=0.0):
    return AxisTilts(bodies=(name,), out=(out,), across=(across,))


@pytest.fixture(scope="module")
def wedge():
    return drive_of("wedge")


def test_check_joint_of_an_independent_computation(wedge):
    """Sun axis by 1 mrad; rollers on pins held, planets floating."""
    out = contact_angles_of_tilts(drive=wedge, stiffness=STIFFNESS, tilts=tilted(out=1e-3))
    assert 1e3 * np.abs(out.slope) == pytest.approx([0.598, 0.349, 0.367, 0.0, 0.0], abs=1e-3)
    across = contact_angles_of_tilts(drive=wedge, stiffness=STIFFNESS, tilts=tilted(across=1e-3))
    assert np.abs(across.slope) == pytest.approx(0.0, abs=1e-15)
    assert 1e3 * np.abs(across.skew) == pytest.approx([1.0, 0.0, 0.0, 0.0, 0.0], abs=1e-9)


def test_the_worst_direction_is_found_by_trying_them(wedge):
    angles = np.linspace(0.0, np.pi, 721)
    tried = [
        contact_angles_of_tilts(
            drive=wedge, stiffness=STIFFNESS, tilts=tilted(out=1e-3 * np.cos(a), across=1e-3 * np.sin(a))
        )
        for a in angles
    ]
    stated = contact_angles_of_tilts(
        drive=wedge, stiffness=STIFFNESS, tilts=tilted(out=0.6e-3, across=0.8e-3)
    )
    assert stated.largest_slope == pytest.approx(np.max([abs(t.slope) for t in tried], axis=0), rel=1e-4)
    assert stated.largest_skew == pytest.approx(np.max([abs(t.skew) for t in tried], axis=0), rel=1e-4)


@pytest.mark.parametrize("name", ["wedge", "multiroller"])
def test_floating_bodies_take_the_least_energy(name, wedge):
    """Heights z above and below the middle approach by A(w z): the energy of all sectors, minimised without A."""
    drive = wedge if name == "wedge" else drive_of(name)
    stiffness = 500.0 + 40.0 * np.arange(len(drive.contacts))
    given = tilted(out=0.8e-3, across=0.6e-3)
    found = contact_angles_of_tilts(drive=drive, stiffness=stiffness, tilts=given)
    sectors = round(float(drive.sectors))
    whole = unfolded(drive, sectors=sectors)
    centres = np.asarray(whole.centres)
    planet = centres[next(i for i, body in enumerate(whole.bodies) if not body.central)]
    radial = planet / np.linalg.norm(planet)
    sun = 0.8e-3 * radial + 0.6e-3 * np.array([-radial[1], radial[0]])
    free = [i for i, body in enumerate(whole.bodies) if body.place == "free"]
    number = {body.name: i for i, body in enumerate(whole.bodies)}
    normals = []
    for contact in whole.contacts:
        between = centres[number[contact.second]] - centres[number[contact.first]]
        normals.append((-1.0 if contact.internal else 1.0) * between / np.linalg.norm(between))

    def slopes(flat):
        w = np.zeros_like(centres)
        w[number["sun"]] = 1e3 * sun
        w[free] = flat.reshape(-1, 2)
        return np.array(
            [
                normal @ (w[number[contact.first]] - w[number[contact.second]])
                for normal, contact in zip(normals, whole.contacts, strict=True)
            ]
        )

    def energy(flat):
        return float(np.tile(stiffness, sectors) @ slopes(flat) ** 2) / 1000.0

    best = minimize(energy, np.zeros(2 * len(free)), tol=1e-14, options={"gtol": 1e-10}).x
    assert 1e3 * found.slope == pytest.approx(slopes(best)[: len(drive.contacts)], abs=1e-5)


def test_the_carrier_tilts_all_pins(wedge):
    """Sun, ring and carrier together: a joint that is turned as a whole opens no contact."""
    count = 3
    whole = AxisTilts(bodies=("sun", "ring", "carrier"), out=(1e-3,) * count, across=(0.3e-3,) * count)
    found = contact_angles_of_tilts(drive=wedge, stiffness=STIFFNESS, tilts=whole)
    assert np.abs([*found.slope, *found.skew]) == pytest.approx(0.0, abs=1e-14)


def test_a_floating_body_on_one_line_has_a_slope_and_no_known_skew():
    """Two springs in series share the slope; across nothing holds the planet, whatever its sun does."""
    drive = Drive(
        bodies=(Body("sun", "axis"), Body("planet", "free"), Body("ring", "axis")),
        contacts=(Contact("sp", "sun", "planet"), Contact("pr", "planet", "ring", internal=True)),
        centres=np.array([[0.0, 0.0], [0.0, 30e-3], [0.0, 0.0]]),
        first_radius=np.array([10e-3, 20e-3]),
        second_radius=np.array([20e-3, 50e-3]),
        push_angles=np.zeros(0),
        sectors=3.0,
        input="sun",
        output="carrier",
        grounded="ring",
    )
    found = contact_angles_of_tilts(drive=drive, stiffness=np.array([300.0, 100.0]), tilts=tilted(out=1e-3))
    assert np.abs(found.slope) == pytest.approx([0.25e-3, 0.75e-3], rel=1e-9)
    assert np.all(np.isnan([found.skew, found.largest_skew]))
    beside = dataclasses.replace(
        drive,
        bodies=(*drive.bodies, Body("roller", "pin")),
        contacts=(*drive.contacts, Contact("sr", "sun", "roller")),
        centres=np.array([*drive.centres, [25e-3, 0.0]]),
        first_radius=np.array([10e-3, 20e-3, 10e-3]),
        second_radius=np.array([20e-3, 50e-3, 15e-3]),
        push_angles=np.zeros(1),
    )
    springs = np.array([300.0, 100.0, 200.0])
    found = contact_angles_of_tilts(drive=beside, stiffness=springs, tilts=tilted(out=1e-3))
    assert np.isnan(found.skew).tolist() == [True, True, False]
    assert abs(found.skew[2]) == pytest.approx(1e-3)  # the roller stands a right angle from the planet
    pinned = dataclasses.replace(
        drive,
        bodies=(Body("sun", "axis"), Body("planet", "pin"), Body("ring", "axis")),
        push_angles=np.zeros(1),
    )
    for out, across in itertools.product((0.0, 1e-3), repeat=2):
        found = contact_angles_of_tilts(
            drive=pinned, stiffness=np.array([300.0, 100.0]), tilts=tilted(out=out, across=across)
        )
        assert np.abs(found.slope) == pytest.approx([out, 0.0], abs=1e-15)
        assert np.abs(found.skew) == pytest.approx([across, 0.0], abs=1e-15)
    found = contact_angles_of_tilts(
        drive=pinned, stiffness=np.array([300.0, 100.0]), tilts=tilted("planet", 2e-3, 1e-3)
    )
    assert np.abs(found.slope) == pytest.approx([2e-3, 2e-3])
    assert np.abs(found.skew) == pytest.approx([1e-3, 1e-3])


@pytest.mark.parametrize(
    ("name", "body"), [("wheel_pair", "driver"), ("wheel_pair", "driven"), ("planetary", "ring")]
)
def test_bodies_without_floating_ones_pass_their_tilt_on(name, body):
    drive = drive_of(name)
    found = contact_angles_of_tilts(
        drive=drive, stiffness=np.full(len(drive.contacts), 400.0), tilts=tilted(body, 1e-3, 2e-3)
    )
    touched = [body in (contact.first, contact.second) for contact in drive.contacts]
    assert np.abs(found.slope) == pytest.approx(np.where(touched, 1e-3, 0.0), abs=1e-15)
    assert np.abs(found.skew) == pytest.approx(np.where(touched, 2e-3, 0.0), abs=1e-15)
    assert found.largest_slope == pytest.approx(np.where(touched, np.hypot(1e-3, 2e-3), 0.0), abs=1e-15)

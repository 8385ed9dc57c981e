"""Mirror images of drives: by hand for a pair of rollers, and by what torques of either sign do."""

import dataclasses

import numpy as np
import pytest

from asperity.drive.layout.drive import Body, Closure, Contact, Drive
from asperity.drive.layout.mirror import MirrorImage, mirror_image
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.types.multiroller import two_row_multiroller
from asperity.drive.types.wedge import EQUAL_COEFFICIENTS, SPRING_LOADED_PINS, wedge_drive
from asperity.joint_file.build import joint_from_case
from asperity.standing.over_torque import standing_over_torque


def pair(angle, radius=10e-3, push=0.0):
    """Two rollers of each sector between sun and ring, the second at an angle from the first, in sectors of three."""
    polar = np.array([0.3, 0.3 + angle])
    return Drive(
        bodies=(Body("sun", "axis"), Body("one", "pin"), Body("two", "pin"), Body("ring", "axis")),
        contacts=(
            Contact("s1", "sun", "one"),
            Contact("s2", "sun", "two"),
            Contact("r1", "one", "ring", internal=True),
            Contact("r2", "two", "ring", internal=True),
        ),
        centres=30e-3 * np.stack([[0.0, 0.0], *np.stack([np.cos(polar), np.sin(polar)], 1), [0.0, 0.0]]),
        first_radius=np.array([20e-3, 20e-3, 10e-3, radius]),
        second_radius=np.array([10e-3, radius, 40e-3, 40e-3]),
        push_angles=np.array([push, push]),
        sectors=np.asarray(3.0),
        input="sun",
        output="ring",
        grounded="carrier",
    )


def test_rollers_midway_between_others_are_mirrored_into_themselves():
    assert mirror_image(pair(np.pi / 3.0)) == MirrorImage((0, 1, 2, 3), (0, 1, 2, 3))


def test_rollers_at_any_other_angle_have_no_image_in_the_line_through_one_of_them():
    assert mirror_image(pair(np.pi / 4.0)) is None
    assert mirror_image(pair(np.pi / 3.0, push=0.1)) is None


def test_an_assumption_on_one_side_only_has_no_image():
    """A spring at the right pin of the paper's drive; equal coefficients of both sides are their own image."""
    geometry = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
    paper = wedge_drive(geometry, planet_count=3.0)
    image = mirror_image(paper)
    assert image == MirrorImage((0, 1, 3, 2, 4), (0, 2, 1, 4, 3))
    assert mirror_image(dataclasses.replace(paper, closure=Closure(EQUAL_COEFFICIENTS))) == image
    assert mirror_image(dataclasses.replace(paper, closure=Closure((), SPRING_LOADED_PINS))) is None
    assert mirror_image(dataclasses.replace(paper, closure=Closure((("pwr", "wro"),)))) is None


def test_rows_that_lie_between_others_exchange_their_contacts():
    drive = two_row_multiroller(
        sun_radius=12e-3,
        first_row_radii=(14e-3, 7e-3),
        second_row_radii=(21e-3, 9.4e-3),
        roller_count=4,
    )
    image = mirror_image(drive)
    names = [contact.name for contact in drive.contacts]
    assert image is not None
    assert [names[k] for k in image.contacts] == ["sf", "fsr", "fsl", "sr"]
    uneven = np.asarray(drive.first_radius) * np.where(np.array(names) == "fsl", 1.001, 1.0)
    assert mirror_image(dataclasses.replace(drive, first_radius=uneven)) is None


def test_the_order_in_which_contacts_name_their_bodies_plays_no_part():
    drive = two_row_multiroller(
        sun_radius=12e-3,
        first_row_radii=(14e-3, 7e-3),
        second_row_radii=(21e-3, 9.4e-3),
        roller_count=4,
    )
    between = np.array([contact.name in ("fsr", "fsl") for contact in drive.contacts])
    turned = tuple(
        Contact(each.name, each.second, each.first, sector=-each.sector, tracks=each.tracks[::-1])
        if swap
        else each
        for each, swap in zip(drive.contacts, between, strict=True)
    )
    one, two = np.asarray(drive.first_radius), np.asarray(drive.second_radius)
    swapped = dataclasses.replace(
        drive,
        contacts=turned,
        first_radius=np.where(between, two, one),
        second_radius=np.where(between, one, two),
    )
    assert mirror_image(swapped) == mirror_image(drive)


def test_rollers_on_either_side_of_the_line_are_exchanged():
    """One of three rollers of each sector lies on the line, the others 40 degrees beside it."""
    polar = 0.3 + np.array([0.0, 1.0, -1.0]) * np.radians(40.0)
    names = ("one", "two", "three")
    drive = Drive(
        bodies=(Body("sun", "axis"), *(Body(name, "pin") for name in names), Body("ring", "axis")),
        contacts=(
            *(Contact(f"s_{name}", "sun", name) for name in names),
            *(Contact(f"r_{name}", name, "ring", internal=True) for name in names),
        ),
        centres=30e-3 * np.stack([[0.0, 0.0], *np.stack([np.cos(polar), np.sin(polar)], 1), [0.0, 0.0]]),
        first_radius=np.repeat([20e-3, 10e-3], 3),
        second_radius=np.repeat([10e-3, 40e-3], 3),
        push_angles=np.zeros(3),
        sectors=np.asarray(3.0),
        input="sun",
        output="ring",
        grounded="carrier",
    )
    assert mirror_image(drive) == MirrorImage((0, 1, 3, 2, 4), (0, 2, 1, 3, 5, 4))


@pytest.mark.slow
def test_torques_of_either_sign_do_the_same_to_a_mirrored_drive(planar_case):
    """The solver knows nothing of the mirror: both directions are solved."""
    joint = joint_from_case(planar_case("multiroller"))
    torques = np.array([2.0, -2.0, 0.9 * float(joint.output_torque), -0.9 * float(joint.output_torque)])
    found = standing_over_torque(joint, torques, no_slip_friction=1e30)
    np.testing.assert_allclose(found.assembly[::2], found.assembly[1::2], rtol=1e-9)
    assert abs(found.assembly[0, 0] / found.assembly[2, 0] - 1.0) > 1e-4
    image = mirror_image(joint.drive)
    np.testing.assert_allclose(
        found.slip_ratio[::2], found.slip_ratio[1::2][:, list(image.contacts)], rtol=1e-7
    )

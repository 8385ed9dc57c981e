"""Oil, hysteresis and skew in the balance of every body: positions, and the forces that the document states."""

import math

import numpy as np
import pytest

from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solve_case

SKEW, HYSTERESIS = 0.3e-3, 0.02
SECTION = f'\n[rolling]\nskew = "{1e3 * SKEW} mrad"\nhysteresis_factor = {HYSTERESIS}\n'
OIL = '\n[lubrication]\nviscosity = "30 mPa*s"\n'


def turned(vector, angle):
    x, y = vector
    return np.array([x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)])


def cross(a, b):
    return float(a[0] * b[1] - a[1] * b[0])


@pytest.fixture(scope="module")
def solved(zou_file):
    """Joint and document of an example whose rolling everything resists."""
    known = {}

    def of(name, more=""):
        if (name, more) not in known:
            text = zou_file.with_name(f"{name}.toml").read_text(encoding="utf-8")
            oil = "" if "\n[lubrication]" in text else OIL
            case = parse_case(text + SECTION + oil + more, source=f"{name}.toml")
            joint, document = solve_case(case)
            known[name, more] = joint.joint, document
        return known[name, more]

    return of


def moments_of(joint, document):
    """Moments on all members, counter-clockwise [N·m], by vectors; of those off the axis about their own centres."""
    drive, rolling = joint.drive, document["rolling"]
    sectors, members = round(float(drive.sectors)), drive.members
    centres = {body.name: np.asarray(drive.centres[k]) for k, body in enumerate(drive.bodies)}
    turns = {name: drive.sense * speed for name, speed in document["geometry"]["speeds_over_input"].items()}
    moments = dict.fromkeys(members, 0.0)
    on_carrier = {name: np.zeros(2) for name in members}
    for k, contact in enumerate(drive.contacts):
        stated = rolling["contacts"][contact.name]
        normal, along = stated["normal_N"], stated["tangential_N"]
        oil, shifted, skew = stated["oil_drag_N"], stated["hysteresis_moment_Nm"], stated["skew_drag_N"]
        radii = float(drive.first_radius[k]), float(drive.second_radius[k])
        angle = 2.0 * math.pi * contact.sector / sectors
        first, second = centres[contact.first], turned(centres[contact.second], angle)
        inside = -1.0 if contact.internal else 1.0
        outward = inside * (second - first) / np.linalg.norm(second - first)
        point = first + radii[0] * outward
        spin = math.copysign(1.0, turns[contact.first] - turns["carrier"])
        ahead = spin * np.array([-outward[1], outward[0]])  # where the first surface moves
        rounded = 1.0 / (1.0 / radii[0] + inside / radii[1])
        for body, centre, radius, sign in (
            (contact.first, first, radii[0], -1.0),
            (contact.second, second, radii[1], 1.0),
        ):
            pressed, pulled = sign * normal * outward, sign * along * ahead
            # hysteresis moves the pressure to the inlet; oil drags the surface, and pushes the body through its centre
            acts = [
                (point - shifted / normal * ahead, pressed),
                (point, pulled),
                (point, -oil * ahead),
                (centre, (1.0 if sign < 0.0 else inside) * 2.0 * oil * rounded / radius * ahead),
            ]
            way = spin if sign < 0.0 else -inside * spin
            brakes = -way * skew * radius
            copies = sectors if np.allclose(centre, 0.0) else 1
            moments[body] += copies * (sum(cross(at - centre, force) for at, force in acts) + brakes)
            moments["carrier"] -= sectors * brakes
            on_carrier[body] += turned(sum(force for _, force in acts), 0.0 if sign < 0.0 else -angle)
    for name, force in on_carrier.items():
        if name in centres and not np.allclose(centres[name], 0.0):
            moments["carrier"] += sectors * cross(centres[name], force)
    return moments


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "more"),
    [
        ("planetary", ""),
        pytest.param("planetary", "\n[[branch]]\n" * 3, marks=pytest.mark.long),
        pytest.param("multiroller", "", marks=pytest.mark.long),
        pytest.param("stepped_planet", "", marks=pytest.mark.long),
        pytest.param("zou2025", "", marks=pytest.mark.long),
        pytest.param("planar", "", marks=pytest.mark.long),
    ],
)
def test_stated_forces_and_moments_balance_every_member(solved, name, more):
    """The input takes what is stated, the output gives its torque; on all others, but what stands, nothing is left."""
    joint, document = solved(name, more)
    drive, rolling = joint.drive, document["rolling"]
    moments = moments_of(joint, document)
    entered = -drive.sense * moments.pop(drive.input)
    assert rolling["input_torque_Nm"] == pytest.approx(entered, rel=1e-8)
    moments.pop(drive.grounded)
    torque = float(joint.output_torque)
    assert abs(moments.pop(drive.output)) == pytest.approx(torque, rel=1e-8)
    np.testing.assert_allclose(list(moments.values()), 0.0, atol=1e-8 * torque)
    # and what enters and does not leave is lost
    lost = rolling["input_power_W"] - rolling["output_power_W"]
    assert rolling["losses_W"]["total"] == pytest.approx(lost, rel=1e-9)
    causes = [rolling["losses_W"][cause] for cause in ("creep", "skew", "hysteresis", "oil")]
    assert all(each > 0.0 for each in causes)
    assert sum(causes) == pytest.approx(lost, rel=1e-9)


@pytest.mark.slow
def test_what_skew_and_hysteresis_take_is_stated_as_moments(solved):
    """Half of the axial force's work on each surface; 2 alpha a N/(3 pi) of the Hertzian width."""
    _, document = solved("planetary")
    modulus = 206e9 / 2.0 / (1.0 - 0.3**2)
    for name, radius in (("sp", 20e-3 / 3.0), ("pr", 20e-3 * 50.0 / 30.0)):
        contact = document["rolling"]["contacts"][name]
        assert contact["skew_drag_N"] == pytest.approx(0.5 * contact["axial_force_N"] * SKEW, rel=1e-9)
        width = math.sqrt(4.0 * contact["normal_N"] / 10e-3 * radius / (math.pi * modulus))
        moment = HYSTERESIS * 2.0 * width / (3.0 * math.pi) * contact["normal_N"]
        assert contact["hysteresis_moment_Nm"] == pytest.approx(moment, rel=0.02)
    speed = 1500.0 * math.pi / 30.0 * 5.0 / 6.0 * 10e-3
    for name, contact in document["rolling"]["contacts"].items():
        lost = contact["losses_W"]
        assert lost["skew"] == pytest.approx(3.0 * 2.0 * contact["skew_drag_N"] * speed, rel=2e-3), name


@pytest.mark.slow
def test_a_drive_that_stands_is_not_resisted(zou_file):
    text = zou_file.with_name("planetary.toml").read_text(encoding="utf-8")
    still = text.replace('sun_speed = "1500 rpm"', 'sun_speed = "0 rpm"') + SECTION
    _, document = solve_case(parse_case(still, source="x"))
    assert document["standing"]["forces"]["input_torque_Nm"] == pytest.approx(10.0 / 6.0, rel=1e-9)

"""The paper's drive whose contacts are springs: three unknowns by statics, by SciPy, against the general equations.

Statics leaves S = N_pwr + N_pwl, T_sp and T_pwr. They follow from the carrier's moment, the approaches and the slips,
which fit displacements of planet and rollers; a contact that would bear more than its friction bears just that.
"""

import dataclasses
import math

import numpy as np
import pytest
from scipy.optimize import fsolve

from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.state import STATE_TOLERANCE, DriveLoad
from asperity.drive.state.states import drive_states
from asperity.drive.types.wedge import wedge_drive
from asperity.engine.control import at_once

FRICTION, RING = 0.12, 40e-3


def drive(**changed):
    """The paper's, with asperities as compliances."""
    plain = {"sun": 4e-3, "planet": 13.5e-3, "roller": 5e-3, "left": 0.0, "right": 0.0, "wall": 60e-3}
    plain |= {"preload": 1000.0, "outward": np.zeros(2), "asperities": np.full(5, 2e-10), "torque": 5.0}
    return plain | changed


def random_drive(rng):
    preload = rng.uniform(600.0, 2000.0)
    return drive(
        sun=rng.uniform(3.8e-3, 4.4e-3),
        planet=rng.uniform(13.4e-3, 13.6e-3),
        roller=rng.uniform(5.0e-3, 5.2e-3),
        left=rng.uniform(-0.1, 0.1),
        right=rng.uniform(-0.1, 0.1),
        wall=rng.uniform(4e-3, 60e-3),
        preload=preload,
        outward=rng.uniform(0.0, 30.0, 2),
        asperities=rng.uniform(0.0, 3e-9, 5),
        torque=rng.choice([-1.0, 1.0]) * rng.uniform(6.0, 12.5) * preload / 1000.0,
    )


def _states(made, asperities, wall, rest, torque, outward, preload):
    laws = smooth_contact_laws(
        drive=made,
        youngs_modulus=206e9,
        poisson_ratio=0.3,
        friction_coefficient=FRICTION,
        contact_length=5e-3,
        ring_wall_thickness=wall,
        reference_force=rest,
    )
    laws = dataclasses.replace(laws, asperity_compliance=asperities)
    radial = made.centres[1:4] / np.linalg.norm(made.centres[1:4], axis=1)[:, None]
    states = drive_states(
        drive=made,
        laws=laws,
        pattern=np.array([0.0, 0.0, 0.0, 1.0, 1.0]),
        preload=preload,
        load=DriveLoad(torque, outward[np.array([0, 1, 1])][:, None] * radial),
    )
    return states.standing, laws.springs


def sides(x):
    """Orbit of the rollers, and theta and beta by the law of cosines."""
    planet, pair, orbit = x["sun"] + x["planet"], x["planet"] + x["roller"], RING - x["roller"]
    theta = math.pi - math.acos((planet**2 + pair**2 - orbit**2) / (2.0 * planet * pair))
    return orbit, theta, math.acos((pair**2 + orbit**2 - planet**2) / (2.0 * pair * orbit))


def general(x):
    """Standing state and springs, and the forces at rest around which these are given."""
    geometry = DriveGeometry(x["sun"], x["planet"], x["roller"], RING, 3.0, x["left"], x["right"])
    _, theta, beta = sides(x)
    side = x["preload"] / (2.0 * math.cos(theta))
    ring = [side * (math.cos(beta) + math.sin(beta) * math.tan(x[name])) for name in ("right", "left")]
    rest = np.array([x["preload"], side, side, *ring])
    numbers = (x["asperities"], x["wall"], rest, x["torque"], x["outward"], x["preload"])
    found, springs = at_once(_states, wedge_drive(geometry, planet_count=3.0), *numbers)
    return found, springs, rest


def forces(x, load_sum, sun_force, right_force):
    """All forces of a branch by (2)-(4), and what the carrier's moment (5) leaves over, as a force."""
    orbit, theta, beta = sides(x)
    left_force, difference = sun_force - right_force, sun_force / math.tan(theta / 2.0)
    pwr, pwl = (load_sum + difference) / 2.0, (load_sum - difference) / 2.0
    sp = (right_force - left_force) * math.sin(theta) + load_sum * math.cos(theta) - x["outward"][0]
    left = pwl * math.sin(beta) + left_force * (1.0 + math.cos(beta))  # pushes along the tangent
    right = pwr * math.sin(beta) - right_force * (1.0 + math.cos(beta))
    wro = right * math.tan(x["right"]) + pwr * math.cos(beta) + right_force * math.sin(beta) + x["outward"][1]
    wlo = left * math.tan(x["left"]) + pwl * math.cos(beta) - left_force * math.sin(beta) + x["outward"][1]
    tangential = np.array([sun_force, right_force, left_force, right_force, left_force])
    return np.array([sp, pwr, pwl, wro, wlo]), tangential, left - right - x["torque"] / (3.0 * orbit)


def slips(x, secant, incremental, normal, tangential):
    """Integrals of the compliances of bodies and asperities from 0 to T, a line above 99.9 % of friction."""
    q = np.abs(tangential) / (FRICTION * normal)
    held, bend = np.minimum(q, 0.999), secant - incremental
    left = 1.0 - held
    slip = (
        incremental * held
        + bend * (left * np.log(left) + held)
        + 1.5 * x["asperities"] * (1.0 - left ** (2 / 3))
    )
    slope = incremental - bend * np.log(left) + x["asperities"] * left ** (-1 / 3)
    return np.sign(tangential) * FRICTION * normal * (slip + slope * (q - held))


def by_statics(x, springs, rest):
    _, theta, beta = sides(x)
    secant, incremental = np.asarray(springs.secant_compliance), np.asarray(springs.incremental_compliance)
    unit = 3e-8 / x["preload"]

    def misfits(unknowns, slides=None):
        normal, tangential, carrier = forces(x, *(unknowns * x["preload"]))
        pressed = np.maximum(normal, 1e-6 * rest)
        approach = normal * (secant - (secant - incremental) * np.log(pressed / rest)) - rest * secant
        closure = approach @ rest / rest[1]
        slip = slips(x, secant, incremental, pressed, tangential)
        outward = [math.sin(beta) - (1.0 + math.cos(beta)) * math.tan(x[side]) for side in ("right", "left")]
        moved = 2.0 * math.sin(theta) * approach[0] + outward[0] * approach[3] + outward[1] * approach[4]
        split = (slip[1] + slip[3] - slip[2] - slip[4] + moved) / unit
        if slides is not None:
            split = abs(tangential[slides]) - FRICTION * normal[slides]
        return np.array([closure / unit, carrier, split]) / x["preload"]

    start = np.array([2.0 * rest[1], 10.0 * x["torque"], 5.0 * x["torque"]]) / x["preload"]
    found = fsolve(misfits, start, xtol=1e-12)
    normal, tangential, _ = forces(x, *(found * x["preload"]))
    over = np.abs(tangential) / (FRICTION * normal)
    slides = int(np.argmax(over)) if np.max(over) > 1.0 else None
    if slides is not None:
        found = fsolve(lambda at: misfits(at, slides), found, xtol=1e-12)
        normal, tangential, _ = forces(x, *(found * x["preload"]))
    assert np.max(np.abs(misfits(found, slides))) < 1e-10
    return normal, tangential, slides


def compared(x):
    """The number of the contact that slides; None where all hold."""
    found, springs, rest = general(x)
    if not float(found.residual) < STATE_TOLERANCE:
        return -1
    normal, tangential, slides = by_statics(x, springs, rest)
    np.testing.assert_allclose(found.normal, normal, rtol=1e-8)
    signs = np.array([-1.0, 1.0, 1.0, -1.0, -1.0])  # positive where it opposes the first surface
    np.testing.assert_allclose(found.tangential, signs * tangential, rtol=1e-8, atol=1e-7)
    assert np.flatnonzero(np.asarray(found.slides)).tolist() == ([] if slides is None else [slides])
    return slides


@pytest.mark.parametrize(
    ("torque", "slides"), [(5.0, None), (9.0, None), (10.0, 4), (12.0, 4), (-7.0, None), (-12.0, 3)]
)
def test_the_papers_joint(torque, slides):
    assert compared(drive(torque=torque)) == slides


@pytest.mark.long
def test_random_drives():
    rng = np.random.default_rng(11)
    found = [compared(random_drive(rng)) for _ in range(50)]
    assert found.count(-1) <= 12  # beyond their capacity
    assert found.count(None) >= 8
    assert sum(slides is not None and slides >= 0 for slides in found) >= 8

"""Which bodies meet at which contact: springs against the published line-contact formulas written out by hand."""

import dataclasses

import equinox as eqx
import numpy as np
import pytest

from asperity.drive.force_balance import DriveForces
from asperity.joint.contacts import bulk_springs, closure_springs, rough_contacts, rough_interfaces

LENGTH, WALL, NU = 5e-3, 10e-3, 0.3
RADII = {"sun": 4e-3, "planet": 13.5e-3, "loading_roller": 5e-3, "ring": 40e-3}
PAIRS = (
    ("sun", "planet"),
    ("planet", "loading_roller"),
    ("planet", "loading_roller"),
    ("loading_roller", "ring"),
    ("loading_roller", "ring"),
)
# each body of another steel, so that a contact with the wrong body shows
MODULI = {"sun": 200e9, "planet": 210e9, "loading_roller": 220e9, "ring": 190e9}
NORMAL = np.array([1000.0, 650.0, 460.0, 640.0, 450.0])


@pytest.fixture(scope="module")
def joint(paper_joint):
    made = paper_joint(ring_wall_thickness=WALL)
    bodies = {
        name: dataclasses.replace(getattr(made.bodies, name), youngs_modulus=np.asarray(modulus))
        for name, modulus in MODULI.items()
    }
    return dataclasses.replace(made, bodies=dataclasses.replace(made.bodies, **bodies))


def approach(force):
    """Johnson 1985, 5.6 for a roller, Weber and Banaschek 1953 for the ring's wall, shape (5,) [m]."""
    found = []
    for load, (first, second) in zip(force, PAIRS, strict=True):
        inner = second == "ring"
        curvature = 1.0 / RADII[first] + (-1.0 if inner else 1.0) / RADII[second]
        soft = sum((1.0 - NU**2) / MODULI[body] for body in (first, second))  # 1/E*
        width = np.sqrt(4.0 * load * soft / (np.pi * LENGTH * curvature))
        total = 0.0
        for body in (first, second):
            logarithm = 2.0 * np.log(4.0 * RADII[body] / width) - 1.0
            if body == "ring":
                logarithm = 2.0 * np.log(2.0 * WALL / width) - NU / (1.0 - NU)
            total += load / LENGTH * (1.0 - NU**2) / (np.pi * MODULI[body]) * logarithm
        found.append(total)
    return np.array(found)


@pytest.fixture(scope="module")
def found(joint):
    """Everything the module says about the joint, one compiled program."""

    @eqx.filter_jit
    def said(joint, normal, forces):
        contacts = rough_contacts(joint=joint, normal_force=forces.normal, tangential_force=forces.tangential)
        both = dataclasses.replace(joint, closure_springs="bulk_and_asperities")
        pressed = rough_contacts(joint=joint, normal_force=normal, tangential_force=0.0 * normal)
        return {
            "bulk": bulk_springs(joint=joint, normal_force=normal),
            "closure": closure_springs(joint=joint, rest_force=normal),
            "closure with asperities": closure_springs(joint=both, rest_force=normal),
            "pressed": pressed,
            "interfaces": rough_interfaces(joint=joint, forces=forces, contacts=contacts),
            "contacts": contacts,
        }

    lifted = NORMAL * [1.0, 1.0, 0.0, 1.0, 0.0]
    zero = np.zeros(())
    forces = DriveForces(lifted, 0.05 * lifted * [1, 1, 1, -1, 1], *[zero] * 8)
    return said(joint, NORMAL, forces)


def test_bulk_springs_are_those_of_the_bodies_that_meet(found):
    np.testing.assert_allclose(found["bulk"].secant_compliance * NORMAL, approach(NORMAL), rtol=1e-12)
    step = 1e-4 * NORMAL
    slope = (approach(NORMAL + step) - approach(NORMAL - step)) / (2.0 * step)
    np.testing.assert_allclose(found["bulk"].incremental_compliance, slope, rtol=1e-7)


def test_the_closure_adds_the_asperities_where_asked(found):
    for kind in ("secant_compliance", "incremental_compliance"):
        bulk = np.asarray(getattr(found["bulk"], kind))
        np.testing.assert_array_equal(getattr(found["closure"], kind), bulk)
        added = np.asarray(getattr(found["closure with asperities"], kind)) - bulk
        np.testing.assert_allclose(added, 1.0 / np.asarray(found["pressed"].normal_stiffness), rtol=1e-9)


def test_a_lifted_contact_has_no_stiffness_and_the_others_those_of_their_springs(found):
    interfaces, touching = found["interfaces"], np.array([True, True, False, True, False])
    for name in ("asperity_normal", "asperity_tangential", "bulk_normal", "bulk_tangential"):
        values = np.asarray(getattr(interfaces, name))
        assert (values[touching] > 0.0).all(), name
        assert (values[~touching] == 0.0).all(), name
    stiffness = 1.0 / np.asarray(found["bulk"].incremental_compliance)
    np.testing.assert_allclose(np.asarray(interfaces.bulk_normal)[touching], stiffness[touching], rtol=1e-12)
    np.testing.assert_array_equal(interfaces.asperity_tangential, found["contacts"].tangential_stiffness)


def test_the_sense_of_a_tangential_force_does_not_matter(found):
    """wro is pulled backwards in the fixture; its slip factor is that of the same force forwards: no nan, no gain."""
    ratio = np.asarray(found["contacts"].tangential_stiffness) / np.asarray(
        found["pressed"].tangential_stiffness
    )
    slip_factor = (1.0 - 0.05 / 0.12) ** (1.0 / 3.0)  # T = 0.05 N, mu = 0.12
    np.testing.assert_allclose(ratio[[0, 1, 3]], slip_factor, rtol=1e-9)

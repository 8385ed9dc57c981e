"""Which bodies meet at which contact: springs against the published line-contact formulas written out by hand."""

import dataclasses

import numpy as np
import pytest

from asperity.engine.control import at_once
from asperity.joint.contacts import (
    bulk_springs,
    closure_springs,
    loaded_contacts,
    rough_joint_contacts,
)
from asperity.joint.description import joint_contacts
from asperity.materials import Material

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
    names = ("sun", "planet", "loading_roller", "loading_roller", "ring")
    materials = tuple(
        dataclasses.replace(material, youngs_modulus=np.asarray(MODULI[name]))
        for name, material in zip(names, made.materials, strict=True)
    )
    return dataclasses.replace(made, materials=materials)


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
    """Everything the module says about the joint."""

    def said(joint, normal, lifted):
        contacts = joint_contacts(joint)
        loaded = loaded_contacts(
            contacts=contacts,
            normal_force=lifted,
            tangential_force=0.05 * lifted * np.array([1.0, 1.0, 1.0, -1.0, 1.0]),
        )
        return {
            "bulk": bulk_springs(contacts=contacts, half_width=contacts.pairs.half_width(normal)),
            "closure": closure_springs(contacts=contacts, rest_force=normal, model="bulk"),
            "closure with asperities": closure_springs(
                contacts=contacts, rest_force=normal, model="bulk_and_asperities"
            ),
            "pressed": rough_joint_contacts(
                contacts=contacts, normal_force=normal, tangential_force=0.0 * normal
            ),
            "half_width": loaded.half_width,
            "interfaces": loaded.interfaces,
            "contacts": loaded.rough,
        }

    return at_once(said, joint, NORMAL, NORMAL * [1.0, 1.0, 0.0, 1.0, 0.0])


def test_pairs_of_materials_by_hand(paper_joint):
    """1/E = sum (1 - nu^2)/E_i and 1/G* = sum (2 - nu)/G_i, model.md section 3; hardness of the softer body."""
    sun, planet, roller, ring = [
        Material(modulus, ratio, 7800.0, strength, 3.0 * strength)
        for modulus, ratio, strength in (
            (200e9, 0.30, 4e8),
            (210e9, 0.28, 5e8),
            (300e9, 0.26, 9e8),
            (100e9, 0.34, 2e8),
        )
    ]
    materials = (sun, planet, roller, roller, ring)
    contacts = joint_contacts(dataclasses.replace(paper_joint(), materials=materials))
    assert contacts.driving.youngs_modulus.tolist() == [200e9, 210e9, 210e9, 300e9, 300e9]
    assert contacts.driven.youngs_modulus.tolist() == [210e9, 300e9, 300e9, 100e9, 100e9]
    moduli = contacts.pairs.moduli
    for index, (one, two) in enumerate(((sun, planet), *2 * ((planet, roller),), *2 * ((roller, ring),))):
        flexibility = sum((1.0 - body.poisson_ratio**2) / body.youngs_modulus for body in (one, two))
        shear = sum(
            (2.0 - body.poisson_ratio) * 2.0 * (1.0 + body.poisson_ratio) / body.youngs_modulus
            for body in (one, two)
        )
        assert float(moduli.contact_modulus[index]) == pytest.approx(1.0 / flexibility, rel=1e-14)
        assert float(moduli.tangential_contact_modulus[index]) == pytest.approx(1.0 / shear, rel=1e-14)
        assert float(moduli.hardness[index]) == min(one.hardness, two.hardness)
        assert float(moduli.yield_strength[index]) == min(one.yield_strength, two.yield_strength)


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
    assert (np.asarray(found["half_width"]) > 0.0).tolist() == touching.tolist()


def test_bodies_in_partial_slip_have_the_logarithm_of_plane_strain(found):
    """T/(mu N) = 0.05/0.12: sum (1 - nu^2)/(pi E B) ln[1/(1 - T/mu N)] beside the normal compliance."""
    logarithm = np.log(1.0 / (1.0 - 0.05 / 0.12))
    for index in (0, 1, 3):
        scale = sum((1.0 - NU**2) / (np.pi * MODULI[body] * LENGTH) for body in PAIRS[index])
        expected = 1.0 / (np.asarray(found["bulk"].incremental_compliance)[index] + scale * logarithm)
        assert float(found["interfaces"].bulk_tangential[index]) == pytest.approx(expected, rel=1e-12)


def test_the_sense_of_a_tangential_force_does_not_matter(found):
    """wro is pulled backwards in the fixture; its slip factor is that of the same force forwards: no nan, no gain."""
    ratio = np.asarray(found["contacts"].tangential_stiffness) / np.asarray(
        found["pressed"].tangential_stiffness
    )
    slip_factor = (1.0 - 0.05 / 0.12) ** (1.0 / 3.0)  # T = 0.05 N, mu = 0.12
    np.testing.assert_allclose(ratio[[0, 1, 3]], slip_factor, rtol=1e-9)

"""Springs of the structure of the paper's drive, listed as bodies, against a chain of that drive alone.

Without torque both have the same forces; the numbers are those of that chain, an independent program (November 2026).
"""

import dataclasses
import math

import numpy as np
import pytest

from asperity.drive.stiffness.torsional_stiffness import Assembly
from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.joint.body_shape import SOLID, BodyShape
from asperity.joint.evaluation import evaluate
from asperity.joint.solve import solve_joint
from asperity.joint.temperature import contact_fit
from asperity.joint_file.build import joint_from_case

pytestmark = pytest.mark.slow

HOUSING = 4e11
RING = BodyShape("ring", 60e-3, "elastic_housing", HOUSING)


def shares(assembly: Assembly) -> dict[str, float]:
    return {name: float(np.sum(value)) for name, value in vars(assembly).items() if name.endswith("_share")}


@pytest.mark.parametrize(
    ("springs", "stiffness", "interference", "expected"),
    [
        (
            {
                "pin_stiffness": 1e8,
                "pin_transverse_stiffness": 3e7,
                "input_shaft_stiffness": 500.0,
                "output_shaft_stiffness": 5e4,
            },
            13144.468853667657,
            1.3018212055349064e-05,
            {"pin": 0.045136788254889294, "input_shaft": 0.3245547865103125},
        ),
        pytest.param(
            {"planet_support_stiffness": 4e7},
            60641.7678163772,
            1.2719353717310108e-05,
            {"planet_support": 0.4444029980394197, "normal": 0.3655546194423609},
            marks=pytest.mark.long,
        ),
        pytest.param(
            {"pin_stiffness": 2e8, "ring_bending_stiffness": 3e8},
            24397.34104008148,
            1.4691564036951152e-05,
            {"ring_bending": 0.19074667326536965, "normal": 0.7108468334556154},
            marks=pytest.mark.long,
        ),
        pytest.param(
            {"shapes": (*4 * (SOLID,), RING)},
            30143.460955762737,
            1.3248317771187401e-05,
            {"tangential": 0.10192121107236307},
            marks=pytest.mark.long,
        ),
    ],
)
def test_stiffness_interference_and_shares(case, springs, stiffness, interference, expected):
    joint = dataclasses.replace(joint_from_case(case), output_torque=0.0, input_speed=0.0, **springs)
    numbers = as_numbers(joint)
    found = at_once(evaluate, numbers)
    if "shapes" in springs:
        # that chain reacted the torque on the ring along its inner rim: the twist of the wall up to the outer one, at
        # which its housing holds it; the ring carries 40/36 of the output torque, and turns the output by 40/36
        shear = 206e9 / 2.6
        twist = (40 / 36) ** 2 * (1.0 / 40e-3**2 - 1.0 / 100e-3**2) / (4.0 * math.pi * shear * 5e-3)
        softer = 1.0 + twist * stiffness
        expected = {"tangential": (expected["tangential"] + twist * stiffness) / softer}
        stiffness = stiffness / softer
    assert float(found.assembly.stiffness.output) == pytest.approx(stiffness, rel=1e-9)
    assert float(found.interference) == pytest.approx(interference, rel=1e-9)
    parts = shares(found.assembly)
    assert sum(parts.values()) == pytest.approx(1.0, rel=1e-9)
    for name, share in expected.items():
        assert parts[f"{name}_share"] == pytest.approx(share, rel=1e-9)


def test_an_elastic_housing_moves_the_ring_as_it_expands(case):
    joint = joint_from_case(case)
    steel, ring = (
        dataclasses.replace(joint.materials[0], thermal_expansion=each) for each in (11.5e-6, 13e-6)
    )
    joint = dataclasses.replace(
        joint,
        preload=None,
        interference=13e-6,
        materials=(*4 * (steel,), ring),
        shapes=(*4 * (SOLID,), RING),
    )
    temperatures = {"assembly_temperature": 20.0, "working_temperature": 60.0}
    fit = contact_fit(joint, **temperatures, housing_expansion=23.6e-6)
    assert float(fit.change_per_kelvin) == pytest.approx(-2.1268698060941811e-07, rel=1e-12)


@pytest.mark.long
def test_a_housing_between_none_and_a_rigid_one(case):
    """The assembled stiffness grows with the housing's, from that of a free ring to nearly that of a held one."""
    joint = dataclasses.replace(
        joint_from_case(case), output_torque=0.0, input_speed=0.0, closure_springs=None
    )

    def stiffness(*support):
        shapes = (*4 * (SOLID,), BodyShape("ring", 10e-3, *support))
        there = dataclasses.replace(joint, shapes=shapes)
        numbers = as_numbers(there)
        return float(at_once(evaluate, numbers).assembly.stiffness.output)

    found = [
        stiffness("free"),
        *(stiffness("elastic_housing", each) for each in (1e6, 4e11, 1e17)),
        stiffness("rigid_housing"),
    ]
    assert found == sorted(found)
    assert found[1] == pytest.approx(found[0], rel=1e-4)
    assert found[3] == pytest.approx(found[4], rel=2e-2)  # it does not hold the rim along the circle
    assert not math.isnan(found[0])


def test_a_ring_of_a_hundred_metres_is_as_stiff_free_as_held(paper_joint):
    """Whatever holds a rim that is far away."""
    free, held = (
        solve_joint(
            paper_joint(ring_wall_thickness=100.0, ring_support=support)
        ).result.assembly.stiffness.output
        for support in ("free", "rigid_housing")
    )
    assert float(free) == pytest.approx(float(held), rel=1e-9)

"""Rings in a described housing: by hand, in every drive, and what is refused."""

import math
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.drive.layout.expansion import ring_expansion
from asperity.engine.control import at_once
from asperity.errors import InputError
from asperity.joint.housing import heating, housing_room, ring_fit, seated, seats
from asperity.joint.rims import bends, joint_rims
from asperity.joint.solve import refuse_impossible_joint
from asperity.joint.status import STATUS_NAMES
from asperity.joint.temperature import contact_expansion
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values
from asperity.results import RESULTS
from asperity.study.batch import evaluate_points

EXAMPLES = Path(__file__).parents[2] / "examples"
HOUSED = """
[housing]
outer_diameter = "{outer}"
interference = "{interference}"
friction_coefficient = 0.12
"""


def _case(
    name="planetary", *, support="rigid_housing", outer="200 mm", interference="60 um", more="", **changes
):
    text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
    text = text.replace('ring_support = "free"', f'ring_support = "{support}"')
    text = text.replace('ring_support = "rigid_housing"', f'ring_support = "{support}"')
    text = text.replace("\n[bodies]", '\n[bodies]\nhousing = "6061-T6"', 1)
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    return parse_case(text + HOUSED.format(outer=outer, interference=interference) + more, source="a.toml")


def _ring(joint):
    return seated(joint).index(True)


def _seats(joint, torque=8.0):
    return seats(joint, SimpleNamespace(moments=np.full(len(joint.drive.members), torque)))


def _compliances():
    """Of a steel ring 50/58 mm and of an aluminium housing 58/100 mm at their seat [m/Pa]."""
    a, b, c = 0.05, 0.058, 0.1
    ring = b / 203e9 * ((b**2 + a**2) / (b**2 - a**2) - 0.29)
    return ring, b / 68.9e9 * ((c**2 + b**2) / (c**2 - b**2) + 0.33)


def test_a_planetary_ring_by_hand():
    joint = joint_from_case(_case())
    at = _ring(joint)
    assert joint.drive.bodies[at].name == "ring"
    steel, aluminium = joint.materials[at], joint.housing.material
    assert (steel.youngs_modulus, aluminium.youngs_modulus) == (203e9, 68.9e9)
    assert (steel.poisson_ratio, aluminium.poisson_ratio) == (0.29, 0.33)
    pressure = 30e-6 / sum(_compliances())
    force = 0.12 * pressure * 2.0 * math.pi * 0.058 * 0.01  # 10 mm long
    held = _seats(joint, torque=-8.0)
    assert float(ring_fit(joint, at).pressure) == pytest.approx(pressure, rel=1e-9)
    assert float(held.force[at]) == pytest.approx(force, rel=1e-9)
    assert float(held.torque_safety[at]) == pytest.approx(force * 0.058 / 8.0, rel=1e-9)
    assert float(held.torque[at]) == pytest.approx(force * 0.058, rel=1e-9)
    assert float(held.heating[at]) == pytest.approx(30e-6 / (aluminium.thermal_expansion * 0.058), rel=1e-9)
    assert float(held.cooling[at]) == pytest.approx(30e-6 / (steel.thermal_expansion * 0.058), rel=1e-9)
    hoop = pressure * (0.1**2 + 0.058**2) / (0.1**2 - 0.058**2)
    assert float(held.housing_stress[at]) == pytest.approx(hoop, rel=1e-9)
    mises = math.sqrt(hoop**2 + hoop * pressure + pressure**2)  # of p across it
    assert float(held.yield_safety[at]) == pytest.approx(aluminium.yield_strength / mises, rel=1e-9)
    narrower = 4.0 * pressure * 0.05 * 0.058**2 / (203e9 * (0.058**2 - 0.05**2))
    assert float(held.bore_change[at]) == pytest.approx(narrower, rel=1e-9)
    assert np.isnan(np.delete(np.stack(held), at, axis=1)).all()


def test_the_seat_of_a_warm_drive():
    """Aluminium expands by 11e-6 more: 40 K take 51 um of 60 um; what the bore gains is what the drive loses."""
    warm = '\n[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n'
    spring = {"support": "elastic_housing", 'interference = "30 um"': 'preload = "1000 N"'}
    joint, cold = (joint_from_case(_case(**spring, more=more)) for more in (warm, ""))
    at = _ring(joint)
    alpha, housing = joint.materials[at].thermal_expansion, joint.housing.material.thermal_expansion
    left = 60e-6 - 2.0 * 0.058 * (housing - alpha) * 40.0
    pressure = 0.5 * left / sum(_compliances())
    assert float(ring_fit(joint, at).pressure) == pytest.approx(pressure, rel=1e-9)
    assert float(_seats(joint).force[at]) == pytest.approx(float(_seats(cold).force[at]), rel=1e-12)
    assert float(_seats(joint).torque_safety[at]) == pytest.approx(
        pressure / float(ring_fit(cold, at).pressure) * float(_seats(cold).torque_safety[at]), rel=1e-9
    )
    # the strength is that of the assembly, where the fit is tightest
    assert float(_seats(joint).yield_safety[at]) == pytest.approx(
        float(_seats(cold).yield_safety[at]), rel=1e-12
    )
    wider = alpha * 40.0 * 0.05 + 0.5 * float(
        ring_fit(cold, at).bore_change - ring_fit(joint, at).bore_change
    )
    shape = joint.shapes[at]
    assert float(shape.housing_stiffness) == pytest.approx(1.0 / _compliances()[1], rel=1e-9)
    expansion = ring_expansion(
        ring=alpha, housing=housing, inner_radius=0.05, wall_thickness=0.008, youngs_modulus=203e9,
        poisson_ratio=0.29, housing_stiffness=shape.housing_stiffness, plane_state="plane_stress",
    )  # fmt: skip
    assert float(expansion) * 40.0 * 0.05 == pytest.approx(wider, rel=1e-9)
    lost = contact_expansion(joint, housing_expansion=housing)
    assert float(lost[1]) == pytest.approx(alpha * 0.05 - float(expansion) * 0.05, rel=1e-9)


def test_a_seat_without_a_torque_holds():
    joint = joint_from_case(_case())
    limit = RESULTS["seat_torque_safety"].limit
    assert [
        limit.is_kept(float(_seats(joint, torque).torque_safety[_ring(joint)])) for torque in (0.0, 1e9)
    ] == [
        True,
        False,
    ]


def test_heating_a_ring_with_its_housing_by_hand():
    """Aluminium lets a ring go that 20 um hold; one that 400 um hold expands with it."""
    for size, holds in (("20 um", False), ("400 um", True)):
        joint = joint_from_case(_case(interference=size))
        at = _ring(joint)
        alpha, housing = joint.materials[at].thermal_expansion, joint.housing.material.thermal_expansion
        rise, wanted = float(heating(joint, at, 50e-6)), float(size.split()[0]) * 1e-6
        left = max(0.0, wanted - 2.0 * 0.058 * (housing - alpha) * rise)
        assert (left > 0.0) == holds
        narrower = (
            2.0 * 0.05 * 0.058**2 / (203e9 * (0.058**2 - 0.05**2)) * 0.5 / sum(_compliances())
        )  # a radius
        assert alpha * rise * 0.05 + narrower * (wanted - left) == pytest.approx(50e-6, rel=1e-9)


@pytest.mark.parametrize(
    ("name", "rings"),
    [
        ("planetary", ["ring"]),
        ("zou2025", ["ring"]),
        ("multiroller", ["ring"]),
        ("stepped_planet", ["held_ring"]),  # the driven ring carries itself
        ("planar", ["ring"]),
    ],
)
def test_every_drive_has_seats(name, rings):
    joint = joint_from_case(_case(name, outer="300 mm"))
    names = [body.name for body in joint.drive.bodies]
    assert [one for one, holds in zip(names, seated(joint), strict=True) if holds] == rings
    assert np.isfinite(np.stack(_seats(joint))[:3, _ring(joint)]).sum() >= 1
    assert float(_seats(joint).torque_safety[_ring(joint)]) > 0.0


def _pressed(joint, normal, tangential):
    zeros = np.zeros(len(joint.drive.contacts))
    forces = SimpleNamespace(
        normal=zeros + normal,
        tangential=zeros + tangential,
        drag=zeros,
        hysteresis_moment=zeros,
        skew_drag=zeros,
    )
    return SimpleNamespace(
        forces=forces,
        rolling=forces,
        rest=forces,
        diagnostics=SimpleNamespace(hertz_half_width=zeros + 1e-4),
        solved=np.array(True),
    )


def test_the_seat_adds_to_what_the_rollers_do():
    """Its pressure and the hoop stress of the ring, tension less at the bore; without rollers the seat is all."""
    joint, loose = (joint_from_case(_case(interference=size)) for size in ("60 um", "1e-9 um"))
    at = _ring(joint)
    fit = ring_fit(joint, at)
    assert bends(joint)[at]  # in a rigid housing too

    def rims(joint, *forces):
        return at_once(lambda joint: joint_rims(joint, _pressed(joint, *forces)), joint)

    alone = rims(joint, 0.0, 0.0)
    assert float(alone.seat_pressure[at]) == pytest.approx(float(fit.pressure), rel=1e-9)
    assert np.asarray(alone.stress[:, at]) == pytest.approx(np.array(fit.ring_hoop), rel=1e-9)
    seated_rims, free_rims = (rims(each, 900.0, 50.0) for each in (joint, loose))
    added = float(seated_rims.seat_pressure[at] - free_rims.seat_pressure[at])
    assert added == pytest.approx(float(fit.pressure), rel=1e-6)
    assert float(free_rims.seat_pressure[at]) < 0.0  # the rollers pull it off between them
    difference = np.asarray(seated_rims.stress - free_rims.stress)[:, at]
    assert difference == pytest.approx(np.array(fit.ring_hoop), rel=1e-6)
    assert np.asarray(seated_rims.amplitude)[:, at] == pytest.approx(np.asarray(free_rims.amplitude)[:, at])


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"support": "free"}, r"\[housing\]: drive.ring_support = \"free\" has no housing"),
        (
            {"more": '[compliance]\nring_housing_stiffness = "400 MPa/mm"\n', "support": "elastic_housing"},
            "leave out compliance.ring_housing_stiffness",
        ),
        (
            {
                "more": '[temperature]\nassembly = "20 degC"\nworking = "40 degC"\n'
                'housing_expansion = "23e-6 1/K"\n'
            },
            "leave out temperature.housing_expansion",
        ),
        ({'housing = "6061-T6"': ""}, "bodies.housing is missing: the material of"),
        ({"outer": "-1 mm"}, "housing.outer_diameter"),
    ],
)
def test_a_housing_that_contradicts_the_file(changes, message):
    with pytest.raises(InputError, match=message):
        _case(**changes)


def test_a_material_of_no_housing():
    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8")
    with pytest.raises(InputError, match=r"bodies.housing: there is no section \[housing\]"):
        parse_case(text.replace("\n[bodies]", '\n[bodies]\nhousing = "6061-T6"', 1), source="a.toml")


def test_temperatures_need_the_expansion_of_the_housing():
    """Also where a spring makes the preload: the fit changes all the same."""
    with pytest.raises(InputError, match="needs the thermal_expansion of every material: give it for steel"):
        _case("zou2025", more='[temperature]\nassembly = "20 degC"\nworking = "40 degC"\n')


def test_a_housing_inside_its_ring():
    with pytest.raises(
        InputError, match=r"housing\.outer_diameter 110 mm: the outer diameter of the ring is 116 mm"
    ):
        refuse_impossible_joint(joint_from_case(_case(outer="110 mm")))
    warm = '\n[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n'
    with pytest.raises(
        InputError, match=r"110 mm: the outer diameter of the ring is 116 mm; make the housing larger"
    ):
        refuse_impossible_joint(
            joint_from_case(_case(outer="110 mm", support="elastic_housing", more=warm))
        )  # what temperature does to the fit is not known
    inside = joint_from_case(_case(outer="110 mm", support="elastic_housing"))  # a point of a study
    assert float(housing_room(inside).min()) == pytest.approx(-3e-3)
    assert np.isnan(inside.shapes[_ring(inside)].housing_stiffness)
    assert np.isnan(_seats(inside).torque_safety[_ring(inside)])


@pytest.mark.slow
def test_a_point_of_a_study_with_a_housing_inside_its_ring_says_so():
    values = si_values(_case(support="elastic_housing"))
    status, found = evaluate_points(
        values, {"housing.outer_diameter": np.array([0.110, 0.116, 0.117])}, ("seat_force",)
    )
    assert [STATUS_NAMES[code] for code in status] == ["housing_inside_ring", "housing_inside_ring", "solved"]
    assert np.isnan(found["seat_force"][:, :2]).all()
    assert np.isfinite(found["seat_force"][_ring(joint_from_case(_case())), 2])

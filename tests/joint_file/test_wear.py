"""Wear of a joint file: which coefficient, whose preload, over which life, and what is refused."""

import numpy as np
import pytest
from tests.support.worn import EXAMPLES, changed, check_case, check_text, check_wear

from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import contact_in, replace_values, si_values
from asperity.joint_file.wear import wear_of_case
from asperity.results.wear_document import wear_document
from asperity.views.blocks import Figures
from asperity.views.wear import wear

BY_PART = '{ sun = "1e-8 mm^3/(N*m)", planet = "2e-17 1/Pa", loading_roller = "0.5e-17 1/Pa", ring = "1e-9 mm^3/Nm" }'


def with_coefficient(text):
    return check_case(more=f"\n[wear]\ncoefficient = {text}\n")


def wheels(more="", **changes):
    text = changed((EXAMPLES / "wheel_pair.toml").read_text(), changes)
    return parse_case(text + more, source="wheels.toml")


def test_one_coefficient_for_all_or_one_each():
    assert joint_from_case(with_coefficient('"1e-17 1/Pa"')).wear_coefficients == (1e-17,) * 5
    each = joint_from_case(with_coefficient(BY_PART)).wear_coefficients
    assert each == pytest.approx((1e-17, 2e-17, 0.5e-17, 0.5e-17, 1e-18))
    branches = "\n[[branch]]\n" * 3
    unfolded = with_own_branches(check_case(more=f"\n[wear]\ncoefficient = {BY_PART}\n{branches}"))
    of = dict(zip([body.name for body in unfolded.drive.bodies], unfolded.wear_coefficients, strict=True))
    assert (of["sun"], of["planet_3"], of["ring"]) == pytest.approx((1e-17, 2e-17, 1e-18))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            '"0 1/Pa"',
            "wear.coefficient: 0 1/Pa is not allowed; it must be above 0 1/Pa and at most 1e-11 1/Pa",
        ),
        ('"2e-11 1/Pa"', "at most 1e-11 1/Pa"),
        ('"-1e-17 1/Pa"', "is not allowed"),
        ("1e-17", "expected a wear coefficient with its unit"),
        ('"1e-17 Pa"', "wear.coefficient"),
        ('{ sun = "1e-17 1/Pa" }', "planet, loading_roller, ring are missing"),
        ('{ sun = "1e-17 1/Pa", planets = "1e-17 1/Pa" }', "has no such body; did you mean 'planet'"),
    ],
)
def test_refused_coefficients(text, said):
    with pytest.raises(InputError, match=said):
        with_coefficient(text)


def test_hours_are_products_over_the_coefficient():
    found = wear_of_case(with_coefficient('"2e-17 1/Pa"'), life=3.6e6)
    first = found.wear.first_slide.coefficient_time
    assert found.coefficient == pytest.approx(2e-17)
    assert found.hours(first) == pytest.approx(first / 2e-17 / 3600.0)
    assert found.allowed_coefficient == pytest.approx(first / 3.6e6)
    assert np.any(np.isclose(found.wear.course.coefficient_time, 2e-17 * 3.6e6, rtol=1e-12, atol=0.0))


def test_without_a_coefficient_there_are_no_hours():
    found = check_wear()
    assert (found.coefficient, found.life, found.allowed_coefficient, found.life_time) == (None,) * 4
    assert found.hours(1e-10) is None


def test_life_of_the_file_or_of_the_call():
    case = check_case(more='\n[rolling]\nrequired_life = "500 h"\n')
    assert wear_of_case(case).life == 1.8e6
    assert wear_of_case(case, life=7200.0).life == 7200.0
    with pytest.raises(InputError, match=r"rolling.required_life: .* is not allowed"):
        wear_of_case(case, life=0.0)


def test_a_preload_force_is_refused():
    case = check_case({'interference = "12.9043 um"': 'preload = "1000 N"'})
    with pytest.raises(
        InputError, match=r"state load.interference, .*or a cam \(load.cam_force_per_torque\)"
    ):
        wear_of_case(case)


def test_a_cam_keeps_the_force():
    case = check_case({'interference = "12.9043 um"': 'preload = "200 N"\ncam_force_per_torque = "160 N/Nm"'})
    found = wear_of_case(case)
    assert found.follows
    assert found.wear.course is None
    assert found.wear.now.preload == pytest.approx(1000.0, rel=1e-6)
    # as pressed as the check joint: its depths
    by_interference = check_wear()
    assert found.wear.now.depth_rate == pytest.approx(by_interference.wear.now.depth_rate, rel=5e-3)


def test_wheels_say_what_presses_them():
    by_spring = wear_of_case(wheels())
    assert by_spring.wear.course is not None
    # the spring of 50 N/mm relaxes by what wear takes
    course = by_spring.wear.course
    lost = course.interference[0] - course.interference
    assert course.preload[0] - course.preload == pytest.approx(50e3 * lost, rel=2e-2, abs=1e-3)
    by_force = wear_of_case(
        wheels(**{'pressed_by = "spring"': 'pressed_by = "force"', "spring_stiffness": "# spring_stiffness"})
    )
    assert by_force.follows
    assert by_force.wear.course is None


def test_a_joint_that_does_not_fit_is_refused_as_everywhere():
    text = changed(check_text(), {'ring_radius = "40 mm"': 'ring_radius = "25 mm"'})
    with pytest.raises(InputError):
        wear_of_case(parse_case(text, source="small.toml"))


def test_a_cam_beside_an_interference_carries_on():
    """The cam presses with its part whatever wear takes; the preload of the interference goes."""
    stated = 'interference = "12.9043 um"'
    found = wear_of_case(check_case({stated: f'{stated}\ncam_force_per_torque = "100 N/Nm"'}))
    course = found.wear.course
    assert course.preload[0] == pytest.approx(1500.0, rel=1e-4)
    assert course.preload[-1] == pytest.approx(500.0, rel=1e-3)
    assert course.interference[-1] == pytest.approx(0.0, abs=2e-8)
    assert (found.wear.first_slide, found.wear.nothing_left) == (None, None)
    assert found.wear.ends[-1].kind == "loose"
    document = wear_document(found)["wear"]
    assert document["computed_until"]["limit"] == "loose"
    said = [
        item.detail
        for block in wear(wear_document(found))
        if isinstance(block, Figures)
        for item in block.items
    ]
    assert all("not computed beyond: the whole interference is gone" in detail for detail in said)


def test_the_coefficient_of_one_body_splits_that_of_all():
    values = si_values(with_coefficient('"1e-17 1/Pa"'))
    changed = replace_values(values, {"wear.coefficient.sun": 2e-17})["wear"]["coefficient"]
    assert changed == {"sun": 2e-17, "planet": 1e-17, "loading_roller": 1e-17, "ring": 1e-17}
    all_alike = replace_values(si_values(with_coefficient(BY_PART)), {"wear.coefficient": 3e-17})
    assert set(all_alike["wear"]["coefficient"].values()) == {3e-17}
    with pytest.raises(InputError, match="this drive has no body 'suns'; did you mean 'sun'"):
        replace_values(values, {"wear.coefficient.suns": 2e-17})
    assert contact_in("wear.coefficient.sun") == "sun"

"""The joint of a pair of wheels against closed forms, and what its file refuses."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.joint.working_loads import forces_on_axis, working_forces, working_loads
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case

TEXT = (Path(__file__).parents[2] / "examples" / "wheel_pair.toml").read_text(encoding="utf-8")
#: Of the example [m], [N], [N·m]; 52100 of the library [Pa].
R_1, R_2, B, N, MU, TORQUE = 20e-3, 40e-3, 10e-3, 1000.0, 0.08, 2.0
E, NU = 203e9, 0.29
RADIUS, MODULUS = R_1 * R_2 / (R_1 + R_2), E / (2.0 * (1.0 - NU**2))
WIDTH = math.sqrt(4.0 * N * RADIUS / (math.pi * B * MODULUS))
T = TORQUE / R_2


def case_of(**lines):
    """The example, some of its lines replaced by others: key → line."""
    text = TEXT
    for key, line in lines.items():
        text, count = re.subn(rf"(?m)^{key} = .*$", line, text)
        assert count == 1, key
    return parse_case(text, source="mine.toml")


def solved(**lines):
    joint = joint_from_case(case_of(**lines))
    return joint, solve_joint(joint)


FIXED = {"pressed_by": 'pressed_by = "fixed_centres"', "spring_stiffness": ""}
BY_FORCE = {"pressed_by": 'pressed_by = "force"', "spring_stiffness": ""}


@pytest.mark.parametrize("pressed", [{}, FIXED, BY_FORCE], ids=["spring", "fixed centres", "force"])
def test_the_contact_is_that_of_two_rollers_whatever_presses_it(pressed):
    """Hertz: b = sqrt(4 N R/(pi B E*)), p = 2 N/(pi b B); capacity mu N R_2, in both senses."""
    joint, solution = solved(**pressed)
    result = solution.result
    for normal in (result.rest.normal, result.forces.normal, result.rolling.normal):
        np.testing.assert_allclose(normal, N, rtol=1e-9)
    np.testing.assert_allclose(result.forces.tangential, T, rtol=1e-9)
    np.testing.assert_allclose(result.diagnostics.slip_ratio, T / (MU * N), rtol=1e-9)
    np.testing.assert_allclose(result.diagnostics.hertz_half_width, WIDTH, rtol=1e-9)
    np.testing.assert_allclose(result.diagnostics.hertz_pressure, 2.0 * N / (math.pi * WIDTH * B), rtol=1e-9)
    assert float(result.speed_ratio) == pytest.approx(-2.0, rel=1e-14)
    assert float(solution.standing_capacity.output_torque) == pytest.approx(MU * N * R_2, rel=1e-6)
    assert float(solution.reverse_standing_capacity.output_torque) == pytest.approx(MU * N * R_2, rel=1e-6)
    assert joint.contact_names == ("dd",)


def test_the_stiffness_is_that_of_the_contact_at_the_driven_wheel():
    """K = K_t R_2^2; K_t of asperities and of two half-spaces in series, in full stick the normal one (Johnson)."""
    joint, solution = solved(
        output_torque='output_torque = "1e-9 N*m"',
        asperity_base='bodies = "springs"\nasperity_base = "circular_spot"',
    )
    result = solution.result
    strain = (1.0 - NU**2) / (math.pi * E * B)
    normal = sum(strain * (2.0 * math.log(4.0 * radius / WIDTH) - 2.0) for radius in (R_1, R_2))
    asperities = float(result.contacts.tangential_stiffness[0])
    expected = R_2**2 / (normal + 1.0 / asperities)
    assert joint.body_model == "springs"
    assert float(result.assembly.stiffness.output) == pytest.approx(expected, rel=1e-7)
    assert float(result.assembly.stiffness.input) == pytest.approx(expected / 4.0, rel=1e-7)
    assert float(result.published.output) == pytest.approx(asperities * R_2**2, rel=1e-7)


def test_creep_and_efficiency_are_those_of_carter():
    """Without oil only creep loses power: (1 - xi/2)/(1 + xi/2); a rough contact creeps more than a smooth one."""
    dry = TEXT.replace('[lubrication]\nviscosity = "30 mPa*s"\n', "")
    rolling = solve_joint(joint_from_case(parse_case(dry, source="mine.toml"))).result.rolling
    smooth = MU * WIDTH / RADIUS * (1.0 - math.sqrt(1.0 - T / (MU * N)))
    factor = float(rolling.layer_creepage_factor[0])
    xi = float(rolling.creepage[0])
    assert 1.0 < factor < 1.1
    assert xi == pytest.approx(smooth * factor, rel=1e-3)
    assert float(rolling.power.efficiency) == pytest.approx((1.0 - 0.5 * xi) / (1.0 + 0.5 * xi), rel=1e-6)


def test_the_bearings_carry_the_force_of_the_contact_with_its_friction():
    joint, solution = solved()
    loads = working_loads(joint, solution.result)
    normal, tangential = working_forces(joint, solution.result)
    held = forces_on_axis(joint, normal, tangential, loads.pin)
    np.testing.assert_allclose(held[:2], math.hypot(N, float(tangential[0])), rtol=1e-9)
    assert abs(float(tangential[0])) > T  # the oil drags too
    np.testing.assert_allclose(np.sum(loads.moments), 0.0, atol=1e-12)  # on wheels and frame together


def test_a_spring_keeps_its_force_where_fixed_centres_do_not():
    """The sizes press: 20 um of thermal growth change the force of a spring of 50 N/mm by 1 N."""
    warm = '\n[temperature]\nassembly = "20 degC"\nworking = "60 degC"\nhousing_expansion = "4.26666666666667e-6 1/K"\n'
    growth = (12.6e-6 - 4.26666666666667e-6) * (R_1 + R_2) * 40.0
    assert growth == pytest.approx(20e-6, rel=1e-12)
    for lines, stiffness in (
        ({"preload": 'interference = "20 mm"'}, 50e3),
        ({**FIXED, "preload": 'interference = "8 um"'}, None),
    ):
        text = TEXT
        for key, line in lines.items():
            text = re.sub(rf"(?m)^{key} = .*$", line, text)
        forces = [
            float(
                solve_joint(joint_from_case(parse_case(text + more, source="mine.toml"))).result.rest.normal[
                    0
                ]
            )
            for more in ("", warm)
        ]
        added = forces[1] - forces[0]
        if stiffness is not None:
            assert added == pytest.approx(stiffness * growth, rel=1e-3)
        else:
            assert added > 2000.0


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (
            {"pressed_by": ""},
            "drive.pressed_by: this key is missing: one of 'force', 'spring', 'fixed_centres'",
        ),
        (
            {"preload": ""},
            "load: exactly one of 'preload' and 'interference' is needed, got neither",
        ),
        ({"preload": 'preload = "0 N"'}, "load.preload: 0 N is not allowed; it must be at least 0.001 N"),
        (
            {"spring_stiffness": ""},
            'drive.pressed_by = "spring": the stiffness of the spring is missing; give drive.spring_stiffness, e.g. '
            '"20 N/mm", or pressed_by = "force"',
        ),
        (
            {"pressed_by": 'pressed_by = "fixed_centres"'},
            "drive.spring_stiffness = '50 N/mm': with drive.pressed_by = \"fixed_centres\" no spring presses",
        ),
        (
            {**BY_FORCE, "preload": 'interference = "5 um"'},
            "load.interference = '5 um': with drive.pressed_by = \"force\" no size makes the force of the contact",
        ),
        (
            {
                "output_inertia": 'output_inertia = "1 kg*m^2"\n[compliance]\nring_bending_stiffness = "1e5 N/mm"'
            },
            "compliance.ring_bending_stiffness: this drive has no ring; leave it out",
        ),
        (
            {"output_torque": 'output_torque = "2 N*m"\ncam_force_per_torque = "300 N/Nm"'},
            "load.cam_force_per_torque = '300 N/Nm': with drive.pressed_by = \"spring\" it is not known whether",
        ),
        (
            {"output_inertia": 'output_inertia = "1 kg*m^2"\n[[branch]]'},
            'branch: only for drives of type "wedge", "planetary"',
        ),
        ({"driven_radius": 'driven_radius = "40 mm"\nplanets = 3'}, "drive.planets: only for drives of type"),
    ],
)
def test_what_does_not_press_two_wheels_is_refused(lines, message):
    with pytest.raises(InputError) as refused:
        case_of(**lines)
    assert message in str(refused.value)


def test_a_ratio_stands_for_one_radius():
    case = case_of(driven_radius="ratio = 2.5")
    assert case.open_radius.radius == pytest.approx(50e-3, rel=1e-12)


def test_a_cam_adds_to_the_force_and_bearings_take_torque():
    """N = 1000 + 300 . 2; friction of two bearings each: T R_2 = 2 + 2 . 0.002, T R_1 + 2 . 0.001 at the input."""
    _, pressed = solved(
        **BY_FORCE, output_torque='output_torque = "2 N*m"\ncam_force_per_torque = "300 N/Nm"'
    )
    np.testing.assert_allclose(pressed.result.forces.normal, 1600.0, rtol=1e-9)
    bearings = '\n[bearings]\ninput_torque = "0.001 N*m"\noutput_torque = "0.002 N*m"\n'
    result = solve_joint(joint_from_case(parse_case(TEXT + bearings, source="mine.toml"))).result
    np.testing.assert_allclose(result.forces.tangential, 2.004 / R_2, rtol=1e-9)
    assert float(result.forces.input_torque) == pytest.approx(2.004 * R_1 / R_2 + 0.002, rel=1e-9)

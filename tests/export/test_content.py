"""Sentences at the head of exported files, and the numbers they state."""

import dataclasses
import re
from types import SimpleNamespace

import numpy as np
import pytest

import asperity
from asperity.errors import InputError
from asperity.export.content import _friction, export_content, fitted_elements, heading
from asperity.export.fmu import fmu_parts
from asperity.export.mjcf import mjcf_file
from asperity.export.modelica import modelica_file
from asperity.export.targets import csv_file
from asperity.joint.bodies import joint_inertias
from asperity.joint.description import Joint
from asperity.joint.play import Play
from asperity.joint.solve import solve_joint
from asperity.standing.dynamics import Inertias, dynamics

ARCMINUTE = np.pi / 180.0 / 60.0


def test_heading_states_both_numbers(content):
    text = "\n".join(heading(content, what="Table"))
    stiffness = 3e4 / (1.0 + 2e-3 * 25.0)
    drift = 3e-3 * (5.0 + 0.1 * 25.0)
    for part in (
        f"made.toml, written by asperity {asperity.__version__}",
        "SI units",
        f"Stiffness at 5 N*m, sun locked, level assembly: {stiffness:.6g} N*m/rad ({stiffness * ARCMINUTE:.4g} N*m",
        f"Drift per output turn at 5 N*m, steady rolling: {drift:.6g} rad ({drift / ARCMINUTE:.4g} arcmin)",
        "Play: none.",
        "two regimes",
        "Range: -5 N*m to 5 N*m",
    ):
        assert part in text, part
    assert text.isascii()


def test_heading_says_what_bounds_the_stiffness(content, monkeypatch):
    """Behind the stiffness, in the same line."""
    for bound in ("upper bound: pins rigid", ""):
        monkeypatch.setattr("asperity.export.content.stiffness_bound", lambda _, bound=bound: bound)
        (line,) = (each for each in heading(content, what="Table") if each.startswith("Stiffness at"))
        assert line.endswith(f"N*m/arcmin); {bound}" if bound else "N*m/arcmin)")


def test_heading_says_what_is_unknown_and_the_play(made_content):
    loose = made_content(play=Play(angle=2.0 * ARCMINUTE, take_up_torque=0.1))
    text = "\n".join(
        heading(dataclasses.replace(loose, no_drift_because=("no creep: all plastic",)), what="T")
    )
    assert "Play: 2 arcmin from side to side, taken up over 0.1 N*m" in text
    assert "Drift per output turn at 5 N*m: unknown; no creep: all plastic" in text
    sudden = made_content(play=Play(angle=2.0 * ARCMINUTE, take_up_torque=0.0))
    assert "taken up at zero torque" in "\n".join(heading(sudden, what="T"))


@pytest.mark.parametrize(
    ("friction", "because", "expected"),
    [
        (
            float("nan"),
            (),
            "unknown, because the sun stands in the joint file; a model has none.",
        ),
        (
            float("nan"),
            ("no creep: all plastic",),
            "unknown, no creep: all plastic; a model has none.",
        ),
        (0.0, (), "none in the joint file."),
        (
            0.01,
            (),
            "0.01 N*m, which bearings, rolling and skew take from it at 5 N*m and the speed of "
            "the joint file; constant in a model.",
        ),
    ],
)
def test_heading_says_what_the_friction_at_the_motor_is(content, friction, because, expected):
    parts = dataclasses.replace(content.parts, friction=friction)
    lines = heading(dataclasses.replace(content, parts=parts, no_drift_because=because), what="FMU")
    assert f"Friction at the motor: {expected}" in lines


def test_every_target_says_that_the_friction_is_unknown(content):
    unknown = dataclasses.replace(content, parts=dataclasses.replace(content.parts, friction=float("nan")))
    fitted = fitted_elements(unknown, program="model")
    parts = fmu_parts(unknown)
    for text in (
        csv_file(unknown).decode(),
        mjcf_file(unknown, fitted).decode(),
        modelica_file(unknown, fitted).decode(),
        parts.description,
    ):
        assert text.count("Friction at the motor: unknown, because the sun stands in the joint file") == 1
    assert unknown.friction == 0.0


def test_name_of_a_file_cannot_leave_its_line(content):
    odd = dataclasses.replace(content, source="a\nb–é.toml")
    lines = heading(odd, what="Table")
    assert all(line.isascii() and line.isprintable() for line in lines)


def test_reduction(content):
    assert content.reduction == pytest.approx(9.0)  # (40 - 4)/4


@pytest.mark.slow
def test_two_inertias_swing_as_all_bodies_do(planar_joint):
    """Of a planetary on a soft ring: the inertia of everything, and the natural frequency with both sides free."""
    joint, inertias = planar_joint("planetary"), Inertias(2e-5, 0.05, 0.0)
    at = dynamics(joint, inertias).at_torque
    parts = export_content(
        joint, inertias=inertias, source="joint.toml", largest_torque=None, level="assembly"
    ).parts
    motor = 36.0 * parts.input
    assert motor + parts.output == pytest.approx(
        float(at.input_inertia + at.spin_inertia + at.output_inertia), rel=1e-9
    )
    squared = float(at.stiffness) * (1.0 / motor + 1.0 / parts.output)
    assert np.sqrt(squared) / (2.0 * np.pi) == pytest.approx(float(at.free_frequency), rel=1e-9)
    assert motor < parts.output
    # without motor and load: the planets turn the other way faster than without slip where the sun holds them more
    bare = export_content(
        joint, inertias=None, source="joint.toml", largest_torque=None, level="assembly"
    ).parts
    entry, spinning, moved = (float(each) for each in joint_inertias(joint))
    assert bare.input > entry + spinning
    assert 36.0 * bare.input + bare.output == pytest.approx(36.0 * (entry + spinning) + moved, rel=1e-9)


@pytest.mark.slow
def test_numbers_are_those_of_the_joint_solved_alone(paper_joint):
    joint = paper_joint(output_torque=4.0)
    made = export_content(joint, inertias=None, source="joint.toml", largest_torque=None, level="assembly")
    alone = solve_joint(joint).result
    assert made.largest_torque == 4.0
    assert made.stiffness == pytest.approx(float(alone.assembly.stiffness.output), rel=1e-9)
    assert made.drift == pytest.approx(float(alone.rolling.drift_per_output_turn), rel=1e-9)


def test_texts_name_the_members_of_the_drive(content):
    joint = SimpleNamespace(
        ends=("driving ring", "cage"),
        play=content.joint.play,
        drive=content.joint.drive,
        pin_stiffness=5e7,
        pin=None,
        unlike=None,
        input_speed=0.0,
        friction_coefficients=(0.12,),
    )
    other = dataclasses.replace(content, joint=joint)
    assert "Stiffness at 5 N*m, driving ring locked" in "\n".join(heading(other, what="Table"))
    assert "angle of the motor at the driving ring" in fmu_parts(other).description


def test_files_say_whose_branches_they_hold(content, made_content):
    def said(joint):
        each = dataclasses.replace(content, joint=joint)
        return [line for line in heading(each, what="Table") if line.startswith("Branches")]

    assert said(made_content().joint) == []
    own = object.__new__(Joint)
    vars(own).update(
        unlike=object(),
        play=content.joint.play,
        pin_stiffness=None,
        drive=SimpleNamespace(input="sun", output="carrier", pinned=(), contacts=(object(),)),
        input_speed=0.0,
        friction_coefficients=(0.12,),
    )
    assert said(own) == [
        "Branches: of unlike sizes, as the sections [[branch]] of the joint file state them."
    ]


def test_friction_is_the_power_that_is_not_creep_over_the_speed(content):
    """Creep takes speed from the output, not torque from the motor: of 5 W lost 2 W by creep, 3 W at 628.3 rad/s."""
    power = SimpleNamespace(loss=np.array(5.0), creep=np.array([0.5, 1.5]))
    solution = SimpleNamespace(result=SimpleNamespace(rolling=SimpleNamespace(power=power)))
    speed = abs(float(content.joint.input_speed))
    assert _friction(content.joint, solution) == pytest.approx(3.0 / speed)
    still = dataclasses.replace(content.joint, input_speed=0.0)
    assert np.isnan(_friction(still, solution))


def test_stated_error_covers_the_exported_curves(content):
    fitted = fitted_elements(content, program="MuJoCo")
    curve = content.windup
    torque = np.asarray(curve.torque)
    forward = torque[torque > 0.0]
    path = np.concatenate([forward, torque[-2::-1], torque[1:]])
    angles = fitted.elements.angles(path, largest_angle=1e-3)
    loading, unloading, reloading = np.split(angles, [forward.size, forward.size + torque.size - 1])
    deviation = max(
        np.max(np.abs(loading - np.asarray(curve.angle)[torque > 0.0])),
        np.max(np.abs(unloading - np.asarray(curve.unloading_angle)[-2::-1])),
        np.max(np.abs(reloading - np.asarray(curve.reloading_angle)[1:])),
    )
    shares = [float(each) for each in re.findall(r"([0-9.e-]+) %", fitted.sentences[0])]
    assert deviation <= 1.05 * 0.01 * shares[0] * float(curve.angle[-1])
    assert deviation <= 1.05 * 0.01 * shares[1] * float(curve.hysteresis)
    assert shares[1] < 3.0


def test_a_curve_that_bends_more_than_its_loop_is_wide(made_content):
    """Both directions differ by far more than a cubic spring follows, and slip is small."""
    fitted = fitted_elements(made_content(skewness=0.15, slip=0.003), program="MuJoCo")
    times = float(re.search(r"([0-9.e+]+) times the width of its loop", fitted.sentences[0]).group(1))
    assert times > 1.0
    assert "an FMU follows both" in fitted.sentences[1]


def test_without_slip_nothing_is_said_about_a_loop(made_content):
    fitted = fitted_elements(made_content(slip=0.0), program="MuJoCo")
    assert fitted.elements.stiffness.size == 0
    assert "loop at zero torque" not in fitted.sentences[0]
    assert fitted.linear_stiffness == pytest.approx(3e4)


def test_play_is_refused(made_content):
    loose = made_content(play=Play(angle=1e-3, take_up_torque=0.0))
    with pytest.raises(
        InputError, match=r"play of 3.438 arcmin, in series .* springs of MuJoCo cannot carry it"
    ):
        fitted_elements(loose, program="MuJoCo")

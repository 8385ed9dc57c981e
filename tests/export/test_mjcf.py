"""Exported models run in MuJoCo: a slow cycle of torque on the locked motor, against the wind-up."""

import dataclasses
import re

import numpy as np
import pytest

from asperity.export.content import fitted_elements
from asperity.export.mjcf import mjcf_file
from asperity.joint.play import NO_PLAY

mujoco = pytest.importorskip("mujoco", reason="MuJoCo is not installed (extra 'test')")
plastic = pytest.mark.skipif(
    not hasattr(mujoco.MjModel, "tendon_springyield"), reason="this MuJoCo is older than 4.0: no springyield"
)


def exported(content):
    return mjcf_file(content, fitted_elements(content, program="MuJoCo")).decode("ascii")


def with_linear_spring(text):
    """What the comment in the file tells users of older versions to do."""
    (spring,) = re.findall(
        r"no\n       hysteresis, in place of all tendons above\.\n(.*?)  -->", text, re.DOTALL
    )
    return re.sub(r"<tendon>.*?</tendon>", f"<tendon>{spring}</tendon>", text, flags=re.DOTALL)


def angles(text, torques):
    """Angle of the output after each torque on it has settled, the motor held by a large inertia."""
    model = mujoco.MjModel.from_xml_string(text)
    motor, output = (model.joint(name).dofadr[0] for name in ("motor", "output"))
    stiffness = float(np.sum(model.tendon_stiffness))
    inertia = stiffness * (5.0 * model.opt.timestep) ** 2  # slow for the step, whatever the joint file says
    model.dof_frictionloss[:] = model.tendon_damping[:] = model.body_inertia[:] = 0.0
    model.dof_armature[motor], model.dof_armature[output] = 1e9 * inertia, inertia
    model.dof_damping[output] = 2.4 * np.sqrt(inertia * stiffness)  # no overshoot
    data, found = mujoco.MjData(model), []
    mujoco.mj_setConst(model, data)  # takes over the new inertias
    for torque in torques:
        data.qfrc_applied[output] = -torque  # resists the motion
        mujoco.mj_step(model, data, nstep=200)
        found.append(-data.qpos[output])
    return np.array(found)


def cycle(curve):
    """Loading, unloading and reloading, and what the wind-up says about each."""
    torque = np.asarray(curve.torque)
    forward = torque > 0.0
    path = np.concatenate([torque[forward], torque[::-1], torque])
    expected = np.concatenate(
        [
            np.asarray(curve.angle)[forward],
            np.asarray(curve.unloading_angle)[::-1],
            np.asarray(curve.reloading_angle),
        ]
    )
    return path, expected


@plastic
@pytest.mark.parametrize("skewness", [0.0, 0.002])
def test_cycle_follows_the_windup(made_content, skewness):
    """Loading, unloading and reloading within 4 % of the loop's width, which is 0.1 % of the wind-up."""
    content = made_content(skewness=skewness)
    path, expected = cycle(content.windup)
    found = angles(exported(content), path)
    width = float(content.windup.hysteresis)
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=0.04 * width)
    at_rest = np.flatnonzero(path == 0.0)
    assert found[at_rest[0]] - found[at_rest[1]] == pytest.approx(width, rel=0.04)


@plastic
@pytest.mark.slow
@pytest.mark.parametrize("closure", ["elastic", "constant_pin_force"])
def test_cycle_of_the_papers_joint(papers_content, closure):
    """Its loop is 0.7 % of its wind-up; with a constant pin force both directions differ by 5 %."""
    content = papers_content[closure]
    path, expected = cycle(content.windup)
    width = float(content.windup.hysteresis)
    tolerance = 0.02 if closure == "elastic" else 0.06
    np.testing.assert_allclose(angles(exported(content), path), expected, rtol=0.0, atol=tolerance * width)


def test_older_versions_get_a_straight_line_between_the_ends(content):
    text = with_linear_spring(exported(content))
    assert "springyield=" not in text
    path = np.array([-5.0, 0.0, 2.5, 5.0])
    end = float(content.windup.angle[-1])
    np.testing.assert_allclose(angles(text, path), path / 5.0 * end, rtol=1e-6, atol=1e-6 * end)


@plastic
def test_reduction_inertias_and_friction(content):
    model = mujoco.MjModel.from_xml_string(exported(content))
    motor, output = (model.joint(name) for name in ("motor", "output"))
    assert model.body("motor").inertia[2] == 2e-6
    assert model.body("output").inertia[2] == 0.05
    assert model.dof_frictionloss[motor.dofadr[0]] == 0.01
    assert model.dof_frictionloss[output.dofadr[0]] == 0.0
    data = mujoco.MjData(model)
    data.joint("motor").qpos, data.joint("output").qpos = 9.0 * 0.3, 0.3  # the sun turns nine times as far
    mujoco.mj_forward(model, data)
    np.testing.assert_allclose(data.ten_length, 0.0, atol=1e-12)
    np.testing.assert_array_equal(model.jnt_axis, [[0, 0, -1], [0, 0, 1]])


@plastic
def test_free_vibration_has_the_frequency_of_both_inertias(made_content):
    """A small swing about zero torque, counted by its zero crossings."""
    content = made_content(slip=0.0)
    model = mujoco.MjModel.from_xml_string(exported(content))
    model.dof_frictionloss[:] = 0.0
    data = mujoco.MjData(model)
    data.joint("output").qpos = 1e-5
    lengths = []
    for _ in range(2000):
        mujoco.mj_step(model, data)
        lengths.append(float(data.ten_length[0]))
    lengths = np.array(lengths)
    crossings = np.flatnonzero(np.diff(np.sign(lengths)))
    period = 2.0 * (crossings[-1] - crossings[0]) / (crossings.size - 1) * model.opt.timestep
    joined = 1.0 / (1.0 / (81.0 * 2e-6) + 1.0 / 0.05)
    assert period == pytest.approx(2.0 * np.pi * np.sqrt(joined / 3e4), rel=0.01)
    size = np.abs(lengths)
    peaks = size[1:-1][(size[1:-1] > size[:-2]) & (size[1:-1] > size[2:])]
    decay = np.log(peaks[0] / peaks[-1]) / (peaks.size - 1)
    assert decay == pytest.approx(np.pi * 0.02 / 2.0, rel=0.05)  # loss factor 0.02


def test_head_of_the_file(made_content):
    text = exported(made_content())
    for part in (
        "Stiffness at 5 N*m",
        "Drift per output turn at 5 N*m",
        "elasto-plastic elements",
        "not part of this",
    ):
        assert part in text, part
    assert text == exported(made_content())


def test_without_dynamics_the_file_asks_for_inertias(made_content):
    content = made_content(play=NO_PLAY)
    bare = dataclasses.replace(
        content,
        source="a--b<.toml",
        parts=dataclasses.replace(content.parts, coupled=False, loss_factor=0.0, friction=float("nan")),
    )
    text = exported(bare)
    assert "add those of motor and load" in text
    assert "unknown, because the sun stands" in text
    assert "frictionloss" not in text
    model = mujoco.MjModel.from_xml_string(text) if hasattr(mujoco.MjModel, "tendon_springyield") else None
    assert model is None or model.nq == 2

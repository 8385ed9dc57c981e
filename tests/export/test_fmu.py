"""Exported FMUs, compiled and run by FMPy: the wind-up and its loop, play, two directions, drift while they turn."""

import dataclasses
import os
import shutil
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from asperity.errors import InputError
from asperity.export.fmu import ELEMENTS, fmu_file, fmu_parts
from asperity.joint.play import Play, play_angle
from asperity.standing.series_law import SeriesLaw, slip_elements

fmpy = pytest.importorskip("fmpy", reason="FMPy is not installed (extra 'test')")

LARGEST = 5.0
REDUCTION = 9.0


def tools():
    """Search path with the CMake that FMPy brings."""
    return os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])


needs_compiler = pytest.mark.skipif(
    not (shutil.which("cmake", path=tools()) and shutil.which("cc")),
    reason="there is no C compiler, or no CMake",
)


def written(content, folder):
    file = folder / "joint.fmu"
    file.write_bytes(fmu_file(content, fmu_parts(content)))
    return file


class Unit:
    """An FMU that stands at zero torque."""

    def __init__(self, folder, **parameters):
        from fmpy.fmi2 import FMU2Slave

        described = fmpy.read_model_description(folder)
        self.at = {each.name: each.valueReference for each in described.modelVariables}
        self.slave = FMU2Slave(
            guid=described.guid,
            unzipDirectory=str(folder),
            modelIdentifier=described.coSimulation.modelIdentifier,
            instanceName="joint",
        )
        self.slave.instantiate()
        self.set(**parameters)
        self.slave.setupExperiment()
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()
        self.time = 0.0

    def set(self, **values):
        self.slave.setReal([self.at[name] for name in values], list(map(float, values.values())))

    def step(self, **inputs):
        self.set(**inputs)
        self.slave.doStep(self.time, 1.0)
        self.time += 1.0

    def get(self, *names):
        return np.array(self.slave.getReal([self.at[name] for name in names]))

    def torques(self, angles):
        """Torque at each angle by which the output lies behind the locked motor."""
        found = []
        for angle in angles:
            self.step(output_angle=-angle)
            found.append(self.get("output_torque")[0])
        return np.array(found)


def compiled(content, folder):
    """The folder of an FMU that FMPy has compiled."""
    from fmpy.build import build_platform_binary

    fmpy.extract(str(written(content, folder)), str(folder / "unit"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PATH", tools())
        (folder / "build").mkdir()
        flags = "-Wall -Wextra -Wno-unused-parameter -Werror"
        build_platform_binary(
            folder / "unit", folder / "build", cmake_options={"CMAKE_C_FLAGS:STRING": flags}
        )
    return folder / "unit"


@pytest.fixture(scope="module")
def unzipped(made_content, tmp_path_factory):
    """The FMU of a joint whose directions differ; its parameters serve all tests."""
    return compiled(made_content(skewness=0.01), tmp_path_factory.mktemp("fmu"))


def cycle(curve):
    torque = np.asarray(curve.torque)
    forward = torque > 0.0
    path = np.concatenate([torque[forward], torque[-2::-1], torque[1:]])
    angles = [curve.angle[forward], curve.unloading_angle[-2::-1], curve.reloading_angle[1:]]
    return path, np.concatenate([np.asarray(each) for each in angles])


@pytest.mark.slow
@needs_compiler
def test_cycle_follows_the_windup(made_content, unzipped):
    """Driven along the angles of the loop, the torque is that of the wind-up within 1 % of the loop's height."""
    curve = made_content(skewness=0.01).windup
    path, angles = cycle(curve)
    found = Unit(unzipped).torques(angles)
    height = float(curve.hysteresis) * 3e4
    np.testing.assert_allclose(found, path, rtol=0.0, atol=0.01 * height)


@pytest.mark.long
@needs_compiler
@pytest.mark.parametrize("closure", ["elastic", "constant_pin_force"])
def test_cycle_of_the_papers_joint(papers_content, closure, tmp_path):
    """Its loop is 0.7 % of its wind-up; with a constant pin force both directions differ by 5 %."""
    content = papers_content[closure]
    path, angles = cycle(content.windup)
    height = float(content.windup.hysteresis) * 3e4
    found = Unit(compiled(content, tmp_path)).torques(angles)
    np.testing.assert_allclose(found, path, rtol=0.0, atol=0.01 * height)


@needs_compiler
def test_parameters_can_be_changed(closed_form, unzipped):
    """Without slip it is the reversible curve both ways, with twice the stiffness half of it."""
    torque = np.array([2.0, 4.0, 1.0, -3.0, 2.0])
    unit = Unit(unzipped, slip_factor=0.0, stiffness_factor=2.0, damping=7.0)
    np.testing.assert_allclose(
        unit.torques(0.5 * closed_form.reversible_angle(torque, 0.01)), torque, rtol=1e-5
    )
    unit.step(output_angle=0.0, motor_speed=9.0, output_speed=0.5)
    assert unit.get("output_torque")[0] == pytest.approx(7.0 * 0.5)


@needs_compiler
@pytest.mark.parametrize("take_up_torque", [0.3, 0.0])
def test_play(closed_form, unzipped, take_up_torque):
    play = Play(angle=1e-3, take_up_torque=take_up_torque)
    torque = np.array([0.1, 0.5, 3.0])
    angle = closed_form.reversible_angle(torque, 0.01) + np.asarray(
        play_angle(play=play, output_torque=torque)
    )
    unit = Unit(unzipped, slip_factor=0.0, play_angle=1e-3, take_up_torque=take_up_torque)
    np.testing.assert_allclose(unit.torques(angle), torque, rtol=1e-5, atol=2e-5)
    if take_up_torque == 0.0:  # nothing resists between the sides
        np.testing.assert_allclose(unit.torques([4.9e-4, 0.0, -3e-4, -4.9e-4]), 0.0, atol=1e-12)
        assert unit.get("windup")[0] == pytest.approx(-4.9e-4)


@needs_compiler
def test_drift_under_a_constant_torque(closed_form, unzipped):
    """A motor that makes up for the drift keeps the torque; the output loses the stated angle in each turn."""
    per_turn = closed_form.DRIFT * (4.0 + 0.1 * 16.0)
    held = float(closed_form.reversible_angle(4.0, 0.01))
    unit = Unit(unzipped, slip_factor=0.0)
    unit.step(output_angle=-held)
    for turned in np.linspace(0.0, 4.0 * np.pi, 101)[1:]:
        behind = held + per_turn * turned / (2.0 * np.pi)
        unit.step(output_angle=turned - held, motor_angle=REDUCTION * (turned - held + behind))
    torque, drift, motor, windup = unit.get("output_torque", "drift", "motor_torque", "windup")
    assert torque == pytest.approx(4.0, rel=1e-4)
    assert drift == pytest.approx(2.0 * per_turn, rel=1e-4)
    assert motor == pytest.approx(4.0 / REDUCTION, rel=1e-4)
    assert windup == pytest.approx(held, rel=1e-4)
    # back, against the torque: the output runs ahead by the drift of braking, and nothing is recovered
    for turned in np.linspace(4.0 * np.pi, 2.0 * np.pi, 101)[1:]:
        behind = held + 2.0 * per_turn + 0.9 * per_turn * (4.0 * np.pi - turned) / (2.0 * np.pi)
        unit.step(output_angle=turned - held, motor_angle=REDUCTION * (turned - held + behind))
    assert unit.get("drift")[0] == pytest.approx(2.9 * per_turn, rel=1e-4)


@needs_compiler
def test_torque_relaxes_while_the_joint_turns(closed_form, unzipped):
    """Motor and output that turn together lose their torque by creep, as an equation solved by SciPy says."""

    def rate(turned, state):  # the motor's angle at the output is given, and the output loses its drift on it
        per_angle = closed_form.DRIFT * (state[0] + 0.1 * state[0] ** 2) / (2.0 * np.pi)
        return [-per_angle / (1.0 + per_angle) / (1.0 + 0.01 * state[0]) * 3e4]

    end = 0.15
    expected = solve_ivp(rate, (0.0, end), [4.0], rtol=1e-9, atol=1e-12).y[0, -1]
    assert expected < 1.0
    unit = Unit(unzipped, slip_factor=0.0)
    held = float(closed_form.reversible_angle(4.0, 0.01))
    unit.step(output_angle=-held)
    for turned in np.linspace(0.0, end, 2001)[1:]:
        unit.step(output_angle=turned - held, motor_angle=REDUCTION * turned)
    assert unit.get("output_torque")[0] == pytest.approx(expected, rel=5e-3)
    unit.step(
        output_angle=10.0 * end - held, motor_angle=REDUCTION * 10.0 * end
    )  # a coarse step stays stable
    assert 0.0 < unit.get("output_torque")[0] < 0.1 * expected


@needs_compiler
def test_friction_range_state_and_reset(closed_form, unzipped):
    unit = Unit(unzipped)
    unit.step(motor_speed=-50.0)
    assert unit.get("motor_torque")[0] == pytest.approx(-0.01)  # the content's friction
    saved = unit.slave.getFMUState()
    beyond = float(closed_form.reversible_angle(6.0, 0.01) + closed_form.slip_angle(6.0))
    inside = float(closed_form.reversible_angle(4.0, 0.01))
    assert unit.torques([beyond])[0] > LARGEST
    assert unit.get("out_of_range")[0] == 1.0
    after = unit.torques([inside])[0]
    assert unit.get("out_of_range")[0] == 0.0
    unit.slave.setFMUState(saved)
    unit.slave.freeFMUState(saved)
    fresh = unit.torques([inside])[0]
    assert fresh > after + 0.01  # first loading is stiffer than what comes back from beyond
    unit.slave.reset()
    assert unit.get("output_torque", "drift") == pytest.approx(0.0)


@needs_compiler
def test_simulation_by_fmpy(unzipped, closed_form):
    """A whole simulation with input signals, as a user runs it."""
    time = np.linspace(0.0, 1.0, 11)
    angle = -closed_form.reversible_angle(4.0 * time, 0.01)
    signals = np.array(list(zip(time, angle, strict=True)), dtype=[("time", float), ("output_angle", float)])
    found = fmpy.simulate_fmu(
        str(unzipped),
        start_values={"slip_factor": 0.0},
        input=signals,
        output=["output_torque", "windup"],
        stop_time=1.0,
        step_size=0.01,
        output_interval=0.01,
    )
    assert found["output_torque"][-1] == pytest.approx(4.0, rel=0.03)  # inputs of the step's beginning


@pytest.mark.slow
def test_description_is_valid_and_states_both_numbers(content, tmp_path):
    from fmpy.validation import validate_fmu

    file = written(content, tmp_path)
    assert [each for each in validate_fmu(str(file)) if "binar" not in str(each).lower()] == []
    described = fmpy.read_model_description(str(file))
    assert "Stiffness at 5 N*m" in described.description
    assert "Drift per output turn at 5 N*m" in described.description
    with zipfile.ZipFile(file) as archive:
        texts = {name: archive.read(name).decode() for name in archive.namelist()}
    for name in ("sources/joint_data.h", "documentation/index.html"):
        assert "Drift per output turn at 5 N*m" in texts[name], name
    assert file.read_bytes() == fmu_file(content, fmu_parts(content))


def test_names_that_are_no_names_of_c(content):
    assert fmu_parts(dataclasses.replace(content, source="3-joint*ü.toml")).identifier == "joint_3_joint__"
    assert "a*/b" not in fmu_parts(dataclasses.replace(content, source="a*/b.toml")).data


def test_without_drift_it_is_refused(content):
    drift = np.asarray(content.curves.driving_drift).copy()
    drift[-1] = np.nan
    holes = dataclasses.replace(content, curves=dataclasses.replace(content.curves, driving_drift=drift))
    with pytest.raises(
        InputError, match=r"no steady rolling at 5 N\*m; an FMU needs its drift at every torque"
    ):
        fmu_parts(holes)


def test_the_error_of_the_slip_elements_is_stated_as_a_share_of_the_loop(content):
    error = slip_elements(SeriesLaw(content.windup, content.play), elements=ELEMENTS).error
    share = f"{100.0 * error / float(content.windup.hysteresis):.2g}"
    assert (
        f"{ELEMENTS} slip elements in series follow the loop within {share} % of its width"
        in (fmu_parts(content).sentences[0])
    )
    assert 0.0 < float(share) < 5.0

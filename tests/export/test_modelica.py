"""Exported packages compiled and simulated by the Modelica compiler Rumoca: loop, drift, flanges."""

import dataclasses

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from asperity.errors import InputError
from asperity.export.content import fitted_elements
from asperity.export.modelica import modelica_file, package_name

RATE = 1.7e-4  # rad/s

#: What the model needs of the Modelica Standard Library, and two bodies to connect it with.
LIBRARY = """
package Modelica
  package Mechanics
    package Rotational
      package Interfaces
        connector Flange_a
          Real phi;
          flow Real tau;
        end Flange_a;
        connector Flange_b
          Real phi;
          flow Real tau;
        end Flange_b;
      end Interfaces;
    end Rotational;
  end Mechanics;
end Modelica;
model Moved
  Modelica.Mechanics.Rotational.Interfaces.Flange_b flange;
  Real phi;
equation
  flange.phi = phi;
end Moved;
model Body
  parameter Real inertia = 0.05;
  Modelica.Mechanics.Rotational.Interfaces.Flange_a flange;
  Real phi(start = 1e-5, fixed = true);
  Real w(start = 0.0, fixed = true);
equation
  flange.phi = phi;
  der(phi) = w;
  inertia*der(w) = flange.tau;
end Body;
"""


@pytest.fixture(scope="module")
def simulated():
    """Compile a model and simulate it."""
    rumoca = pytest.importorskip(
        "rumoca", reason="the Modelica compiler Rumoca is not installed (extra 'test')"
    )

    def run(text, model, *, end, step):
        assert [each.message for each in rumoca.validate_source(text, model=model)] == []
        return rumoca.Session().loads(text, model=model).simulate(t=(0.0, end), dt=step)

    return run


def exported(content):
    fitted = fitted_elements(content, program="the Modelica model")
    return modelica_file(content, fitted).decode("ascii"), fitted


def cycle(first, there, back):
    """Angle from rest to one end of the loop, to the other, and back, at a constant rate."""
    ends = (np.cumsum(np.abs([first, there, back])) / RATE).tolist()
    return (
        f"""
model Cycle
  Made.Spring spring(driftFactor = 0.0);
  Real phi(start = 0.0, fixed = true);
equation
  der(phi) = if time < {ends[0]!r} then {RATE} else if time < {ends[1]!r} then -{RATE} else {RATE};
  spring.behind = phi;
  spring.turning = 0.0;
end Cycle;
""",
        ends,
    )


@pytest.mark.parametrize("skewness", [0.0, 0.002])
def test_cycle_follows_the_windup(made_content, simulated, skewness):
    """Within 4 % of the loop's height on loading, unloading and reloading, and that of the elements far closer."""
    content = made_content(skewness=skewness)
    curve = content.windup
    low, high = float(curve.angle[0]), float(curve.angle[-1])
    text, fitted = exported(content)
    model, ends = cycle(high, high - low, high - low)
    found = simulated(text + model, "Cycle", end=ends[-1], step=0.02)
    time, angle, torque = (np.asarray(found[name]) for name in ("time", "phi", "spring.torque"))
    height = float(curve.hysteresis) * 3e4
    np.testing.assert_allclose(torque, fitted.elements.torques(angle), rtol=0.0, atol=0.005 * height)
    pieces = {
        "angle": time <= ends[0],
        "unloading_angle": (time > ends[0]) & (time <= ends[1]),
        "reloading_angle": time > ends[1],
    }
    for name, piece in pieces.items():
        expected = np.interp(angle[piece], np.asarray(getattr(curve, name)), np.asarray(curve.torque))
        np.testing.assert_allclose(torque[piece], expected, rtol=0.0, atol=0.04 * height, err_msg=name)


def test_torque_relaxes_while_the_joint_turns(made_content, closed_form, simulated):
    """Motor and load turn, the load falls behind by a ramp: SciPy solves the same equation of the drift."""
    content = made_content(slip=0.0)
    text, _ = exported(content)
    model = """
model Turn
  Made.Joint joint(friction = 0.0);
  Moved motor, load;
equation
  motor.phi = 9.0*2.0*time;
  load.phi = 2.0*time - 1.2e-4*time/0.1;
  connect(motor.flange, joint.motor);
  connect(joint.load, load.flange);
end Turn;
"""
    found = simulated(text + LIBRARY + model, "Turn", end=0.1, step=0.001)

    def rate(time, state):
        torque = 3e4 * (1.2e-3 * time - state[0])
        per_angle = closed_form.DRIFT * (torque + 0.1 * torque**2) / (2.0 * np.pi)
        return [2.0 * per_angle / (1.0 + per_angle)]

    drift = solve_ivp(rate, (0.0, 0.1), [0.0], rtol=1e-9, atol=1e-15).y[0, -1]
    assert found["joint.drift"][-1] == pytest.approx(drift, rel=2e-3)
    torque = found["joint.torque"][-1]
    assert torque == pytest.approx(3e4 * (1.2e-4 - drift), rel=2e-3)
    assert found["joint.motor.tau"][-1] == pytest.approx(torque / 9.0, rel=1e-9)
    assert found["joint.load.tau"][-1] == pytest.approx(-torque, rel=1e-9)


def test_load_swings_on_the_locked_motor(made_content, simulated):
    """Its frequency is that of the spring and its inertia."""
    text, _ = exported(made_content(slip=0.0))
    model = """
model Swing
  Made.Joint joint(friction = 0.0);
  Moved motor;
  Body load;
equation
  motor.phi = 0.0;
  connect(motor.flange, joint.motor);
  connect(joint.load, load.flange);
end Swing;
"""
    found = simulated(text + LIBRARY + model, "Swing", end=0.05, step=1e-4)
    angle, time = np.asarray(found["load.phi"]), np.asarray(found["time"])
    crossings = time[np.flatnonzero(np.diff(np.sign(angle)))]
    period = 2.0 * (crossings[-1] - crossings[0]) / (crossings.size - 1)
    assert period == pytest.approx(2.0 * np.pi * np.sqrt(0.05 / 3e4), rel=0.01)


def test_head_and_names(content):
    text, _ = exported(content)
    assert text.isascii()
    for part in ("Stiffness at 5 N*m", "Drift per output turn at 5 N*m", "elasto-plastic elements"):
        assert part in text.split("package")[0] or part in text, part
    assert text == exported(content)[0]
    names = {"model.toml": "Model", "a-b.toml": "A_b", "2.toml": "Joint_2", "ü.toml": "Joint__"}
    assert {source: package_name(source) for source in names} == names


def test_without_drift_it_is_refused(content):
    drift = np.full_like(np.asarray(content.curves.driving_drift), np.nan)
    holes = dataclasses.replace(content, curves=dataclasses.replace(content.curves, driving_drift=drift))
    with pytest.raises(InputError, match="a Modelica model needs its drift at every torque"):
        exported(holes)

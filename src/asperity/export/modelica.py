"""A joint as a Modelica package: a spring with elasto-plastic elements and drift, and the same with flanges."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from asperity.errors import InputError
from asperity.export.content import ExportContent, FittedElements, heading


def modelica_file(content: ExportContent, fitted: FittedElements) -> bytes:
    """The Modelica package of a joint."""
    curves, elements = content.curves, fitted.elements
    drifts = [np.asarray(drift) for drift in (curves.driving_drift, curves.braking_drift)]
    if not all(np.all(np.isfinite(drift)) for drift in drifts):
        raise InputError(
            "the joint has no steady rolling at some torques, and a Modelica model needs its drift at every torque: "
            "lower the largest torque, or export to a table",
            options=["torque"],
        )
    name = package_name(content.source)
    lines = [
        *(f"// {line}" for line in (*heading(content, what="Modelica package"), *fitted.sentences, *_SAID)),
        f'package {name} "Traction-drive joint"',
        *_INTERPOLATED,
        '  model Spring "Torque over the angle by which the output lies behind the motor"',
        f'    parameter Real reduction = {content.reduction!r} "Turns of the motor in one turn of the output";',
        f'    parameter Real spring[3] = {_array(elements.spring)} "Reversible: a*x + b*x^2 + c*x^3";',
        *_elements(elements.stiffness, elements.yield_angle),
        '    parameter Real driftFactor = 1.0 "Factor of the drift; 0 for a joint without creep";',
        f'    parameter Real driftTorque[{drifts[0].size}](each unit="N.m") = {_array(np.asarray(curves.torque))};',
        f'    parameter Real driftDriving[{drifts[0].size}](each unit="rad") = {_array(drifts[0])} "Per output turn";',
        f'    parameter Real driftBraking[{drifts[0].size}](each unit="rad") = {_array(drifts[1])} "Per output turn";',
        *_spring_equations(elements.stiffness.size),
        "  end Spring;",
        *_joint(content.friction),
        f"end {name};",
    ]
    return ("\n".join(lines) + "\n").encode("ascii")


def package_name(source: str) -> str:
    """Name of the package of a joint file."""
    name = re.sub(r"\W", "_", Path(source).stem, flags=re.ASCII)
    if not re.match("[A-Za-z]", name):
        name = f"Joint_{name}"
    return name[0].upper() + name[1:]  # no keyword of Modelica begins with a capital


_SAID = (
    "Parallel elements: a reversible spring, and elements that are springs in series with sliders (Jenkins); together "
    "Iwan's model.",
    "Drift grows as the motor turns, at once as in steady rolling. In the joint it is half as large over the first "
    "contact width, and short swings to and fro hardly drift.",
    "Angles of motor and output grow together: each is counted in its own sense.",
    "Spring needs no library. Joint needs the Modelica Standard Library for its flanges; inertias are outside.",
)

_INTERPOLATED = (
    '  function interpolated "Table; beyond its ends it goes on as a straight line"',
    "    input Real x;",
    "    input Real xs[:];",
    "    input Real ys[:];",
    "    output Real y;",
    "  protected",
    "    Integer low;",
    "  algorithm",
    "    low := 1;",
    "    for place in 2:size(xs, 1) - 1 loop",
    "      if x >= xs[place] then",
    "        low := place;",
    "      end if;",
    "    end for;",
    "    y := ys[low] + (ys[low + 1] - ys[low])*(x - xs[low])/(xs[low + 1] - xs[low]);",
    "  end interpolated;",
)


def _elements(stiffness: np.ndarray, yield_angle: np.ndarray) -> list[str]:
    if not stiffness.size:
        return []
    size = stiffness.size
    return [
        f'    parameter Real stiffness[{size}](each unit="N.m/rad") = {_array(stiffness)} "Elements";',
        f'    parameter Real yieldAngle[{size}](each unit="rad") = {_array(yield_angle)} "Where they yield";',
        f'    Real element[{size}](each start = 0.0, each fixed = true, each unit="rad") "Their elastic angles";',
    ]


def _spring_equations(size: int) -> list[str]:
    lines = [
        '    Real behind(unit="rad") "motor/reduction - output";',
        '    Real turning(unit="rad/s") "Speed of the motor over the reduction";',
        '    Real windup(unit="rad") "Angle without the drift";',
        '    Real drift(start = 0.0, fixed = true, unit="rad") "Angle lost by creep";',
        '    Real torque(unit="N.m") "On the load, positive where it drives a positive speed";',
        '    Real perAngle "Drift per angle of the output";',
        "  protected",
        '    Real rate(unit="rad/s");',
        "  equation",
        "    windup = behind - drift;",
        "    rate = der(windup);",
    ]
    total = "windup*(spring[1] + windup*(spring[2] + windup*spring[3]))"
    if size:
        lines += [
            f"    for i in 1:{size} loop",
            "      der(element[i]) = if (element[i] >= yieldAngle[i] and rate > 0.0)",
            "        or (element[i] <= -yieldAngle[i] and rate < 0.0) then 0.0 else rate;",
            "    end for;",
        ]
        total += " + stiffness*element"
    return [
        *lines,
        f"    torque = {total};",
        "    perAngle = driftFactor*(if torque*turning < 0.0 then interpolated(torque, driftTorque, driftBraking)",
        "      else interpolated(torque, driftTorque, driftDriving))/6.283185307179586;",
        "    der(drift) = perAngle*abs(turning)/(if torque*turning < 0.0 then 1.0 - abs(perAngle) else 1.0 +",
        "      abs(perAngle));",
    ]


def _joint(friction: float) -> list[str]:
    return [
        '  model Joint "The spring between the flanges of motor and load"',
        "    extends Spring;",
        f'    parameter Real friction(unit="N.m") = {friction!r} "Friction torque at the motor";',
        '    parameter Real frictionSpeed(unit="rad/s") = 0.1 "Motor speed over which it changes sign";',
        "    Modelica.Mechanics.Rotational.Interfaces.Flange_a motor;",
        "    Modelica.Mechanics.Rotational.Interfaces.Flange_b load;",
        "  equation",
        "    behind = motor.phi/reduction - load.phi;",
        "    turning = der(motor.phi)/reduction;",
        "    motor.tau = torque/reduction + friction*tanh(reduction*turning/frictionSpeed);",
        "    load.tau = -torque;",
        "  end Joint;",
    ]


def _array(values: Iterable[float]) -> str:
    return "{" + ", ".join(repr(float(value)) for value in values) + "}"

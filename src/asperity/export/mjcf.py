"""A joint as a MuJoCo model: motor and output as two hinges, joined by tendons that are springs with hysteresis."""

from __future__ import annotations

import math
from xml.sax.saxutils import quoteattr

import numpy as np

from asperity.export.content import ExportContent, FittedElements, heading

#: Step of the model as a share of the time 1/omega of its fastest vibration.
_STEP = 0.1
_LONGEST_STEP = 2e-3  # s, MuJoCo's own


def mjcf_file(content: ExportContent, fitted: FittedElements) -> bytes:
    """The MJCF file of a joint."""
    parts, elements = content.parts, fitted.elements
    # viscous, and loses what the loss factor loses at the fastest vibration [N·m·s/rad]
    damping = parts.loss_factor * content.stiffness / _fastest(content)
    tendons = [_tendon(content, "spring", stiffness=elements.spring, damping=damping)]
    tendons += [
        _tendon(content, f"slip{place}", stiffness=np.array([stiffness]), yield_angle=yield_angle)
        for place, (stiffness, yield_angle) in enumerate(
            zip(elements.stiffness, elements.yield_angle, strict=True), start=1
        )
    ]
    old = _tendon(content, "spring", stiffness=np.array([fitted.linear_stiffness]), damping=damping)
    friction = f' frictionloss="{content.friction:.9g}"' if content.friction > 0.0 else ""
    name = quoteattr(content.name)
    axis = math.copysign(1.0, content.speed_ratio)
    lines = [
        f"<mujoco model={name}>",
        *_comment([*heading(content, what="MuJoCo model"), *fitted.sentences, *_said(content)]),
        '  <compiler angle="radian"/>',
        f'  <option timestep="{_time_step(content):.1g}" gravity="0 0 0"/>',
        "  <worldbody>",
        '    <body name="motor">',
        f'      <joint name="motor" type="hinge" axis="0 0 {axis:.0f}"{friction}/>',
        _inertial(parts.input),
        "    </body>",
        '    <body name="output">',
        '      <joint name="output" type="hinge" axis="0 0 1"/>',
        _inertial(parts.output),
        "    </body>",
        "  </worldbody>",
        "  <tendon>",
        *[line for tendon in tendons for line in tendon],
        "  </tendon>",
        "  <!-- For MuJoCo older than 4.0, which has no springyield: put this one linear spring, which has no",
        "       hysteresis, in place of all tendons above.",
        *old,
        "  -->",
        "  <actuator>",
        '    <motor name="motor" joint="motor"/>',
        "  </actuator>",
        "</mujoco>",
    ]
    return ("\n".join(lines) + "\n").encode("ascii", "xmlcharrefreplace")


def _said(content: ExportContent) -> list[str]:
    parts = content.parts
    entry, out = content.ends
    ways = (
        "They turn opposite ways in space: the axis of the motor is reversed, so that both angles grow together."
        if content.speed_ratio < 0.0
        else "They turn the same way in space."
    )
    lines = [
        "The drift is not part of this model: no spring of MuJoCo creeps as its hinge turns.",
        f"motor: the {entry}, in its own angles; output: the {out}. {content.reduction:.9g} turns of the motor make "
        f"one of the output. {ways}",
        "The length of each tendon is the wind-up, motor/reduction - output; a positive output torque, which resists "
        "the motion, makes it positive.",
    ]
    if parts.coupled:
        lines.append(
            "Inertias: of motor, rollers and load, divided between the two bodies so that they have the inertia of "
            "everything, and at the stiffness above the natural frequency of all bodies with both sides free."
        )
    else:
        lines.append(
            "Inertias: of the rollers, at the motor as it moves them while the output is held, the rest at the output. "
            "The joint file has no section [dynamics]: add those of motor and load, and enlarge the time step."
        )
    lines.append("Masses are placeholders: they sit on the axis.")
    return lines


def _comment(lines: list[str]) -> list[str]:
    safe = [line.replace("--", "- -") for line in lines]
    return ["  <!--", *(f"    {line}" for line in safe), "  -->"]


def _inertial(inertia: float) -> str:
    about = " ".join([f"{inertia:.9g}"] * 3)
    return f'      <inertial pos="0 0 0" mass="0.1" diaginertia="{about}"/>'


def _tendon(
    content: ExportContent,
    name: str,
    *,
    stiffness: np.ndarray,
    yield_angle: float | None = None,
    damping: float = 0.0,
) -> list[str]:
    numbers = " ".join(f"{float(value):.12g}" for value in stiffness)
    more = "" if yield_angle is None else f' springyield="{yield_angle:.12g}"'
    more += f' damping="{damping:.9g}"' if damping > 0.0 else ""
    return [
        f'    <fixed name="{name}" springlength="0" stiffness="{numbers}"{more}>',
        f'      <joint joint="motor" coef="{1.0 / content.reduction:.15g}"/>',
        '      <joint joint="output" coef="-1"/>',
        "    </fixed>",
    ]


def _fastest(content: ExportContent) -> float:
    """Angular frequency of the joint between motor and output, both free [rad/s]."""
    motor = content.parts.input * content.reduction**2
    joined = motor * content.parts.output / (motor + content.parts.output)
    return math.sqrt(float(np.max(np.asarray(content.windup.stiffness))) / joined)


def _time_step(content: ExportContent) -> float:
    wanted = _STEP / _fastest(content)
    size = 10.0 ** math.floor(math.log10(wanted))
    return min(math.floor(wanted / size) * size, _LONGEST_STEP)

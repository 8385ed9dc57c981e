"""Temperatures at which a drive settles, against an independent program and exponentials."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.template import template
from asperity.rolling.duty_heat import duty_heat
from asperity.rolling.heat import HeatFlow
from asperity.validation.check import Check, compared

_SOURCE = (
    "a program that shares no code with this one, whose contacts do not carry the drag of the oil: the joint of the "
    "paper in Santotrac 50, 6000 rpm, 5 N·m, heights of 0.2 µm, 25 °C around it"
)
_RESISTANCES, _TEMPERATURES, _LOSSES = (1.0, 3.0, 6.0), (48.2, 67.6, 86.4), (23.2, 14.2, 10.2)


def _settled(resistance: float) -> tuple[float, float]:
    """Rise of temperature [K] and losses [W] of the paper's joint in oil."""
    text = template("wedge")
    for old, new in (
        ("fractal_dimension = 1.4", 'rms_height = "0.2 um"'),
        ('fractal_roughness = "1e-8 mm"', ""),
        ("frequency_ratio = 1.5", ""),
    ):
        text = text.replace(old, new, 1)
    text += f'\n[heat]\nambient = "25 degC"\nresistance = "{resistance} K/W"\n'
    text += '[lubrication]\nfluid = "Santotrac 50"\nroughness = "0.2 um"\n'
    heat = joint_from_case(parse_case(text, source="the paper's joint")).heat
    assert heat is not None
    return float(heat.roller_temperature) - 25.0, float(heat.loss)


def heat() -> Iterator[Check]:
    """Steady temperatures, and the peak of a duty."""
    rises, losses = zip(*map(_settled, _RESISTANCES), strict=True)
    yield compared(
        model="Balance of losses and heat",
        reference=_SOURCE,
        quantity="rise of temperature at 1, 3 and 6 K/W",
        unit="K",
        expected=[each - 25.0 for each in _TEMPERATURES],
        computed=rises,
        tolerance=0.01,
    )
    yield compared(
        model="Balance of losses and heat",
        reference=_SOURCE,
        quantity="losses at these temperatures",
        unit="W",
        expected=list(_LOSSES),
        computed=losses,
        tolerance=0.01,
    )
    shares, powers, seconds = np.array([0.25, 0.75]), np.array([30.0, 5.0]), 600.0
    flow = HeatFlow(20.0, 2.0, 0.0, 120.0, heat_capacity=300.0, duty_time=seconds)
    rollers = np.linspace(20.0, 120.0, 24)
    found = duty_heat(flow, rollers, powers[:, None] + 0.0 * rollers, shares, 100.0)
    fall = np.exp(-shares * seconds / (2.0 * 400.0))
    hot, cold = 20.0 + 2.0 * powers
    peak = (hot * (1.0 - fall[0]) + cold * (1.0 - fall[1]) * fall[0]) / (1.0 - fall[0] * fall[1])
    yield compared(
        model="Duty that repeats",
        reference="exponentials between two steady temperatures",
        quantity="highest temperature",
        unit="°C",
        expected=[float(peak)],
        computed=[found.peak],
        tolerance=1e-6,
    )

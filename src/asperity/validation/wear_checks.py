"""Wear of the paper's drive against an independent program."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

import asperity.joint_file
from asperity.joint_file.reader import parse_case
from asperity.joint_file.wear import wear_of_case
from asperity.validation.check import Check, compared

_SOURCE = (
    "a program that shares no code with this one: the paper's radii as springs, smooth, 12.9043 µm, 5 N·m"
)
_CHANGES = {
    'preload = "1000 N"': 'interference = "12.9043 um"',
    'bodies = "exact"': 'bodies = "springs"',
    'traction_split = "equal_coefficients"': 'traction_split = "springs"',
    'closure_springs = "bulk"': "",
    'density = "7850 kg/m^3"': 'density = "1 kg/m^3"',
}
_SURFACE = '[surface]\nfinish = "ground"\nroughness_average = "0.5 nm"\n[wear]\ncoefficient = "1e-17 1/Pa"\n'
_DEPTHS = (0.6482, 0.1030, 0.1046, 0.0859, 0.0320)  # in 1000 h
_THOUSAND_HOURS = 3.6e6


def wear() -> Iterator[Check]:
    """Depths of all tracks, interference, and both ends."""
    text = Path(asperity.joint_file.__file__).with_name("zou2025.toml").read_text(encoding="utf-8")
    for old, new in _CHANGES.items():
        text = text.replace(old, new, 1)
    text = text[: text.index("[surface]")] + _SURFACE
    found = wear_of_case(parse_case(text, source="the paper's drive"))
    shown = 1e6 * _THOUSAND_HOURS * (found.coefficient or np.nan)
    yield compared(
        model="Wear",
        reference=_SOURCE,
        quantity="depth of sun, planet, rollers and ring in 1000 h",
        unit="µm",
        expected=_DEPTHS,
        computed=shown * found.wear.now.depth_rate,
        tolerance=2e-3,
    )
    yield compared(
        model="Wear",
        reference=_SOURCE,
        quantity="interference that 1000 h take",
        unit="µm",
        expected=1.01766,
        computed=shown * found.wear.now.interference_rate,
        tolerance=1e-3,
    )
    yield compared(
        model="Wear",
        reference=_SOURCE,
        quantity="wear coefficient times time to the first slide and to nothing left",
        unit="s/Pa",
        expected=[1.95500e-10, 2.01376e-10],
        computed=[
            np.nan if end is None else end.coefficient_time
            for end in (found.wear.first_slide, found.wear.nothing_left)
        ],
        tolerance=2e-3,
    )

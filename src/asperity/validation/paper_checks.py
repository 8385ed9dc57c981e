"""What the published figures show, a profile of known roughness, and units."""

from __future__ import annotations

import functools
from collections.abc import Iterator

import numpy as np

from asperity.surface.height_parameters import height_parameters
from asperity.surface.roughness import roughness as roughness_parameters
from asperity.surface.topography import Topography
from asperity.units import Dimension, parse_quantity
from asperity.validation.check import Check, compared
from asperity.zou2025.claims import judge
from asperity.zou2025.curves import compute


def figures() -> Iterator[Check]:
    """Numbers that the paper's figures and statics fix."""
    curves = compute()
    numbers: dict[str, dict[str, float]] = {}
    for claim in judge(curves):
        numbers[claim.name] = {key: value for part in claim.statements for key, value in part.numbers.items()}
    check = functools.partial(compared, model="Figures of Zou et al. 2025")
    yield check(
        reference="figure 4c: maximum near D = 1.85",
        quantity="fractal dimension of the stiffest pair",
        unit="-",
        expected=1.85,
        computed=numbers["C3"]["peak_fractal_dimension"],
        tolerance=0.02,
        absolute=True,
    )
    peaks = [value for key, value in numbers["C9"].items() if key.startswith("peak_fractal_dimension")]
    yield check(
        reference="figure 7a: maximum near D = 1.85 at every torque",
        quantity="fractal dimension of the stiffest joint, 0 to 5 N·m",
        unit="-",
        expected=[1.85] * len(peaks),
        computed=peaks,
        tolerance=0.02,
        absolute=True,
    )
    yield check(
        reference="figure 4b: no stiffness from T = mu F on, 0.12 of 1000 N",
        quantity="tangential force at which the pair slips",
        unit="N",
        expected=120.0,
        computed=numbers["C2"]["slip_force_N"],
        tolerance=1e-9,
    )
    yield check(
        reference="statics of (1)-(5) by hand: 5 N·m over three planets, ratio 9, sun of 4 mm",
        quantity="tangential force of the sun at 5 N·m",
        unit="N",
        expected=5.0 / (9.0 * 3.0 * 4e-3),
        computed=numbers["C7"]["T_sp_end_N"],
        tolerance=1e-9,
    )
    yield check(
        reference="independent script, two digits: D 1.4, no torque",
        quantity="published torsional stiffness at the output",
        unit="N·m/rad",
        expected=5.0e6,
        computed=float(curves.loads.output_stiffness[0, 0]),
        tolerance=0.01,
    )


def roughness() -> Iterator[Check]:
    """Height parameters of a sine."""
    x = 0.1e-6 * np.arange(20_000)
    heights = 1e-6 * np.sin(2.0 * np.pi * (x + 0.5e-7) / 40e-6)
    profile = height_parameters(topography=Topography(heights, 0.1e-6))
    yield compared(
        model="Height parameters (ISO 21920)",
        reference="a sine of amplitude A: Pa = 2A/π, Pq = A/√2, Pt = 2A",
        quantity="Pa, Pq and Pt for A = 1 µm",
        unit="µm",
        expected=[2.0 / np.pi, np.sqrt(0.5), 2.0],
        computed=1e6 * np.array([profile.arithmetic_mean, profile.root_mean_square, profile.total_height]),
        tolerance=1e-4,
    )
    yield compared(
        model="Height parameters (ISO 21920)",
        reference="a sine: no skewness, kurtosis 3/2",
        quantity="skewness and kurtosis",
        unit="-",
        expected=[0.0, 1.5],
        computed=[profile.skewness, profile.kurtosis],
        tolerance=1e-6,
        absolute=True,
    )
    x = 1e-6 * np.arange(6000)
    waves = Topography(1e-6 * np.sin(2.0 * np.pi * x / 0.8e-3), 1e-6)
    rough = roughness_parameters(topography=waves, cut_off=0.8e-3, short_cut_off=None)
    assert not isinstance(rough, str)
    yield compared(
        model="Roughness behind the Gaussian filter (ISO 16610-21, ISO 21920-2)",
        reference="a sine as long as the cut-off: half of the amplitude passes, Ra = A/π, Rq = A/√8, Rz = A",
        quantity="Ra, Rq and Rz for A = 1 µm",
        unit="µm",
        expected=[1.0 / np.pi, np.sqrt(0.125), 1.0],
        computed=1e6 * np.array([rough.lengths[symbol] for symbol in ("Ra", "Rq", "Rz")]),
        tolerance=1e-3,
    )


def units() -> Iterator[Check]:
    """Quantities as users write them."""
    written: tuple[tuple[str, Dimension, float], ...] = (
        ("1 deg", Dimension.ANGLE, np.pi / 180.0),
        ("1 arcmin", Dimension.ANGLE, np.pi / 10_800.0),
        ("6000 rpm", Dimension.ANGULAR_VELOCITY, 200.0 * np.pi),
        ("1 N*m/arcmin", Dimension.TORSIONAL_STIFFNESS, 10_800.0 / np.pi),
        ("1 N/um", Dimension.STIFFNESS, 1e6),
        ("450 MPa", Dimension.PRESSURE, 450e6),
        ("5 um", Dimension.LENGTH, 5e-6),
    )
    yield compared(
        model="Units",
        reference="definitions of the SI",
        quantity=", ".join(text for text, _, _ in written),
        unit="SI",
        expected=[value for _, _, value in written],
        computed=[parse_quantity(text, dimension) for text, dimension, _ in written],
        tolerance=1e-15,
    )

"""Crowned and skewed rollers and rolling bearings, against Hertz, Kalker, Carter and published examples."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from asperity.contact import (
    carter,
    crowned_line,
    hertz_line,
    roller_profiles,
    skew,
    tilt_stiffness,
    tilted_line,
)
from asperity.drive.structure.bearing_life import RatedBearing
from asperity.engine.arrays import xp
from asperity.engine.control import at_once, vectorised
from asperity.joint.bearing_lives import BearingLives, BearingState, lives_of_bearings
from asperity.types import Array, Document, Real
from asperity.validation.check import Check, compared

_YOUNG, _POISSON = 206e9, 0.3
_MODULUS = _YOUNG / (2.0 * (1.0 - _POISSON**2))
_RADIUS = 20e-3 / 3.0  # of rollers of 10 and 20 mm


def crowns() -> Iterator[Check]:
    """Crowned rollers whose ends are free, and cylinders."""

    def pressed(force: Array, curvature: Array, length: Array) -> tuple[crowned_line.CrownedLine, Real]:
        pair: Document = {
            "normal_force": force,
            "crown_curvature": curvature,
            "contact_length": length,
            "effective_radius": _RADIUS,
            "contact_modulus": _MODULUS,
        }
        return crowned_line.crowned_line(**pair), crowned_line.crown_compression(**pair)

    axes, short = np.array([1000.0, 100.0]), 1e-4  # the long over the short semi-axis, which is in metres
    squared = 1.0 - axes**-2
    first, second = ellipk(squared), ellipe(squared)
    crown = _RADIUS * (axes**2 * second - first) / (first - second)
    peak = _MODULUS * axes**2 * short * squared / (2.0 * crown * (first - second))
    force, roller = 2.0 / 3.0 * math.pi * peak * axes * short**2, 20.0 * axes * short
    contact, more = at_once(
        vectorised(pressed),
        np.append(force, 2000.0),  # the last roller is a cylinder
        np.append(1.0 / crown, 0.0),
        np.append(roller, 10e-3),
    )
    width = np.sqrt(4.0 * force * _RADIUS / (math.pi * _MODULUS * roller))
    # the middle of an evenly loaded line of this length on half-spaces, Lundberg 1939
    even = force / (math.pi * _MODULUS * roller) * (2.0 * np.log(2.0 * roller / width) + 1.0)
    source = "Hertz's ellipse 100 and 1000 times as long as wide; Johnson 1985, (4.25)-(4.29)"
    for quantity, values in (
        (
            "largest pressure over that of the ellipse",
            2.0 * contact.line_load[:2, 0] / (math.pi * contact.half_width[:2, 0]) / peak,
        ),
        ("approach over that of the ellipse", (even + more[:2]) / (peak * short * first / _MODULUS)),
        ("loaded length over that of the ellipse", contact.loaded_share[:2] * roller / (2.0 * axes * short)),
    ):
        yield compared(
            model="Crowned rollers",
            reference=source,
            quantity=quantity,
            unit="-",
            expected=[1.0, 1.0],
            computed=values,
            tolerance=0.02,
        )
    yield compared(
        model="Crowned rollers",
        reference="the even line: 2000 N on 10 mm",
        quantity="load per length without a crown, in the middle and at the ends",
        unit="N/mm",
        expected=[200.0, 200.0],
        computed=1e-3 * np.array([contact.line_load[2, 0], contact.end_line_load[2]]),
        tolerance=1e-12,
    )


def _tilted_ends(tilt: float, force: float, length: float) -> np.ndarray:
    """Loads per length at both ends and in the middle of a tilted cylinder [N/m], by quadrature and fixed points."""
    places, weights = np.polynomial.legendre.leggauss(40)

    def loads(approach: float, at: np.ndarray) -> np.ndarray:
        load = np.full(at.size, force / length)
        for _ in range(60):
            width = np.sqrt(4.0 * load * _RADIUS / (math.pi * _MODULUS))
            compliance = 2.0 * np.log(2.0 * length / (math.sqrt(math.e) * width)) - 1.0
            load = math.pi * _MODULUS * (approach + tilt * at) / compliance
        return load

    def carried(approach: float) -> float:
        return 0.5 * length * float(weights @ loads(approach, 0.5 * length * places))

    approach = brentq(lambda approach: carried(approach) - force, 0.5 * tilt * length, 1e-4, xtol=1e-18)
    return loads(approach, np.array([-0.5, 0.0, 0.5]) * length)


def tilted() -> Iterator[Check]:
    """A tilted cylinder that touches over its whole length."""
    tilt, force, length = 0.5e-3, 2000.0, 10e-3
    pair = {"normal_force": force, "contact_length": length, "effective_radius": _RADIUS}
    found = at_once(
        lambda gap: tilted_line.profiled_line(gap=gap, contact_modulus=_MODULUS, **pair),
        -tilt * length * tilted_line.PLACES,
    )
    yield compared(
        model="Tilted rollers",
        reference="slices by quadrature and fixed points: cylinders of 10 and 20 mm, 10 mm long, 2000 N, 0.5 mrad",
        quantity="load per length at both ends and in the middle",
        unit="N/mm",
        expected=1e-3 * _tilted_ends(tilt, force, length),
        computed=1e-3 * found.line_load[[0, 100, 200]],
        tolerance=1e-4,
    )
    yield from _profiled()


#: Peak pressures of slices without tilt and at 0.5 mrad by an independent program [MPa].
_PEAKS = {
    "cylinder": (1039.6, 1328.1),
    "Johns and Gohar": (1081.5, 1246.7),
    "Lundberg": (1082.8, 1247.0),
    "ISO/TS 16281, 20 mm": (1383.0, 1398.2),
}


def _profiled() -> Iterator[Check]:
    """Cylinders of 10 and 20 mm, 10 mm long, with profiles under 2000 N, and what resists their tilt."""
    force, length, tilt = 2000.0, 10e-3, 0.5e-3
    pair = {
        "normal_force": force,
        "contact_length": length,
        "effective_radius": _RADIUS,
        "contact_modulus": _MODULUS,
    }
    width = float(hertz_line.half_width(**pair))
    coefficient = roller_profiles.lundberg_coefficient(line_load=force / length, contact_modulus=_MODULUS)
    share = roller_profiles.johns_gohar_share(even_half_width=width, contact_length=length)
    gaps = {
        "cylinder": 0.0 * tilted_line.PLACES,
        "Johns and Gohar": roller_profiles.logarithmic_profile(coefficient=coefficient, end_share=share),
        "Lundberg": roller_profiles.logarithmic_profile(coefficient=coefficient, end_share=1.0),
        "ISO/TS 16281, 20 mm": roller_profiles.logarithmic_profile(
            coefficient=roller_profiles.iso_16281_coefficient(roller_diameter=20e-3), end_share=1.0
        ),
    }
    source = "slices by an independent program: cylinders of 10 and 20 mm, 10 mm long, 2000 N"
    for name, expected in _PEAKS.items():
        found = [
            at_once(
                lambda gap: tilted_line.profiled_line(gap=gap, **pair),
                np.asarray(gaps[name]) - angle * length * tilted_line.PLACES,
            )
            for angle in (0.0, tilt)
        ]
        yield compared(
            model="Tilted rollers",
            reference=source,
            quantity=f"{name}: peak pressure of slices without tilt and at 0.5 mrad",
            unit="MPa",
            expected=list(expected),
            computed=np.array([1e-6 * float(line.peak_pressure) for line in found]),
            tolerance=2e-3,
        )
    stiffness = tilt_stiffness.line_load_stiffness(
        half_width=width, loaded_length=length, contact_modulus=_MODULUS
    )
    against = tilt_stiffness.tilt_stiffness(line_load_stiffness=stiffness, contact_length=length)
    yield compared(
        model="Tilted rollers",
        reference=source,
        quantity="tilt stiffness",
        unit="N*m/rad",
        expected=[4120.6],
        computed=np.array([float(against)]),
        tolerance=1e-4,
    )


def skewed() -> Iterator[Check]:
    """Rollers whose axes are not parallel."""
    force, length, friction, small = 1000.0, 5e-3, 0.12, 1e-9
    shares = np.array([0.1, 0.25, 0.5, 0.8, 0.95])
    bodies = {"youngs_modulus": _YOUNG, "poisson_ratio": _POISSON}

    def found(shares: Array, small: Array) -> Document:
        width = hertz_line.half_width(
            normal_force=force, contact_length=length, effective_radius=_RADIUS, contact_modulus=_MODULUS
        )
        along = carter.gross_slip_creepage(
            friction_coefficient=friction, half_width=width, effective_radius=_RADIUS
        )
        ratio = skew.lateral_compliance_ratio(
            **{f"{name}_{side}": value for name, value in bodies.items() for side in (1, 2)}
        )
        limits = {"gross_slip_creepage": along, "lateral_gross_slip_creepage": along * ratio}
        lateral = (1.0 - xp.sqrt(1.0 - shares)) * along * ratio
        straight = skew.skewed_contact(longitudinal_slip_ratio=shares, lateral_creepage=0.0, **limits)
        # longitudinal and lateral creepage: small ones, 3 : 4, far beyond gross slip
        ways = xp.stack(
            [xp.stack([small, 0.0 * small]), xp.stack([0.0 * small, small]), xp.array([3.0, 4.0])]
        )
        forces = skew.skewed_slip_ratios(
            longitudinal_creepage=ways[:, 0], lateral_creepage=ways[:, 1], **limits
        )
        return {
            "width": width,
            "straight": straight.longitudinal_creepage / along,
            "sideways": skew.skewed_slip_ratios(
                longitudinal_creepage=0.0, lateral_creepage=lateral, **limits
            )[1],
            "forces": xp.stack(forces),
        }

    check = functools.partial(compared, model="Skewed rollers", unit="-")
    computed = at_once(found, shares, small)
    shear = _YOUNG / (2.0 * (1.0 + _POISSON))
    # of a strip, Q = (2/pi) C G a B xi: summed over the strips of a long ellipse it is Kalker's C G a b xi
    per_share = friction * force / small * 0.5 * math.pi / (shear * computed["width"] * length)
    yield check(
        reference="Kalker 1967, coefficients of a long contact: pi²/(4(1 - nu)) and pi²/4",
        quantity="creep coefficients C11 and C22",
        expected=[math.pi**2 / (4.0 * (1.0 - _POISSON)), math.pi**2 / 4.0],
        computed=per_share * computed["forces"][[0, 1], [0, 1]],
        tolerance=1e-6,
    )
    yield check(
        reference="Carter 1926; Johnson 1985, section 8.3",
        quantity="without skew: creepage at 10 to 95 % of friction over that at gross slip",
        expected=1.0 - np.sqrt(1.0 - shares),
        computed=computed["straight"],
        tolerance=1e-12,
    )
    yield check(
        reference="Carter 1926, across: antiplane shear has the same curve",
        quantity="skew alone: axial force over friction at the skew that takes 10 to 95 %",
        expected=shares,
        computed=computed["sideways"],
        tolerance=1e-12,
    )
    yield _skewed_alike()
    yield check(
        reference="Coulomb: far beyond gross slip the force opposes the sliding, 3 : 4",
        quantity="forces over friction",
        expected=[0.6, 0.8],
        computed=computed["forces"][:, 2],
        tolerance=1e-5,
    )


def _skewed_alike() -> Check:
    """Skew of a strip that does not contract across: it answers alike in every direction of its plane."""
    alike = {"gross_slip_creepage": 1e-3, "lateral_gross_slip_creepage": 1e-3}

    def found(longitudinal: Array, lateral: Array, skewed: Array) -> Array:
        half = skew.skewed_slip_ratios(longitudinal_creepage=longitudinal, lateral_creepage=lateral, **alike)
        return xp.stack([*half, skew.longitudinal_capacity_ratio(lateral_creepage=skewed, **alike)])

    return compared(
        model="Skewed rollers",
        unit="-",
        reference="Poisson's ratio 0: Carter's curve along the creepage, Vermeulen and Johnson's rule for a strip",
        quantity="forces over friction at half of the creepage of gross slip, 3 : 4; force left by a skew of 60 %",
        expected=[0.75 * 0.6, 0.75 * 0.8, 0.8],
        computed=at_once(found, 0.3e-3, 0.4e-3, 0.6e-3),
        tolerance=1e-12,
    )


def bearings() -> Iterator[Check]:
    """Lives of rolling bearings."""
    turns = 2.0 * math.pi / 60.0
    ball = RatedBearing(55.3e3, 31.5e3, 1.0, 0.0, "ball")
    roller = RatedBearing(8e3, 9e3, 1.0, 100.0, "roller")
    speeds = np.array([3000.0, 1500.0]) * turns
    duty = BearingState(
        np.array([[10e3, 700.0], [5e3, 1500.0]]), np.array([[3000.0, 1500.0], [1500.0, 3000.0]]) * turns
    )

    def found(working: BearingState, duty: BearingState, shares: Array) -> BearingLives:
        return lives_of_bearings((ball, roller), working=working, rest=xp.zeros(2), duty=duty, shares=shares)

    lives = at_once(found, BearingState(np.array([10e3, 700.0]), speeds), duty, np.array([0.6, 0.4]))
    check = functools.partial(compared, model="Rolling bearings")
    yield check(
        reference="SKF, Rolling bearings, calculation example 1: 6309, C = 55.3 kN, 10 kN, 3000 rpm",
        quantity="basic rating life",
        unit="h",
        expected=940.0,
        computed=float(lives.life[0]) / 3600.0,
        tolerance=1e-3,
    )
    million_turns = np.array([(8.0 / 0.8) ** (10.0 / 3.0), (8.0 / 1.6) ** (10.0 / 3.0)])
    hours = 1e6 * million_turns / (60.0 * np.array([1500.0, 3000.0]))
    source = "ISO 281 and Miner's sum by hand: roller bearing, C = 8 kN, 800 and 1600 N at 1500 and 3000 rpm"
    yield check(
        reference=source,
        quantity="life under the first load, and under both for 60 and 40 % of the time",
        unit="h",
        expected=[hours[0], 1.0 / (0.6 / hours[0] + 0.4 / hours[1])],
        computed=np.array([float(lives.life[1]), float(lives.duty_life[1])]) / 3600.0,
        tolerance=1e-12,
    )
    yield check(
        reference="ISO 76 by hand: C_0 over the largest load, 31.5/10 and 9/1.6",
        quantity="static safety",
        unit="-",
        expected=[3.15, 5.625],
        computed=np.asarray(lives.static_safety),
        tolerance=1e-12,
    )

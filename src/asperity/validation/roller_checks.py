"""Crowned and skewed rollers and rolling bearings, against Hertz, Kalker, Carter and published examples."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

import jax.numpy as jnp
import numpy as np
from scipy.special import ellipe, ellipk

from asperity.contact import carter, crowned_line, hertz_line, skew
from asperity.drive.structure.bearing_life import RatedBearing
from asperity.joint.bearing_lives import BearingState, lives_of_bearings
from asperity.validation.check import Check, compared

_YOUNG, _POISSON = 206e9, 0.3
_MODULUS = _YOUNG / (2.0 * (1.0 - _POISSON**2))
_RADIUS = 20e-3 / 3.0  # of rollers of 10 and 20 mm


def crowns() -> Iterator[Check]:
    """Crowned rollers whose ends are free, and cylinders."""
    pressure, approach, length = [], [], []
    for axes in (1000.0, 100.0):  # the long over the short semi-axis
        squared, short = 1.0 - axes**-2, 1e-4
        first, second = ellipk(squared), ellipe(squared)
        crown = _RADIUS * (axes**2 * second - first) / (first - second)
        peak = _MODULUS * axes**2 * short * squared / (2.0 * crown * (first - second))
        force, roller = 2.0 / 3.0 * math.pi * peak * axes * short**2, 20.0 * axes * short
        pair = {
            "normal_force": force,
            "crown_curvature": 1.0 / crown,
            "contact_length": roller,
            "effective_radius": _RADIUS,
            "contact_modulus": _MODULUS,
        }
        contact = crowned_line.crowned_line(**pair)
        width = math.sqrt(4.0 * force * _RADIUS / (math.pi * _MODULUS * roller))
        # the middle of an evenly loaded line of this length on half-spaces, Lundberg 1939
        even = force / (math.pi * _MODULUS * roller) * (2.0 * math.log(2.0 * roller / width) + 1.0)
        more = float(crowned_line.crown_compression(**pair))
        pressure.append(2.0 * float(contact.line_load[0]) / (math.pi * float(contact.half_width[0])) / peak)
        approach.append((even + more) / (peak * short * first / _MODULUS))
        length.append(float(contact.loaded_share) * roller / (2.0 * axes * short))
    source = "Hertz's ellipse 100 and 1000 times as long as wide; Johnson 1985, (4.25)-(4.29)"
    for quantity, values in (
        ("largest pressure over that of the ellipse", pressure),
        ("approach over that of the ellipse", approach),
        ("loaded length over that of the ellipse", length),
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
    cylinder = crowned_line.crowned_line(
        normal_force=2000.0,
        crown_curvature=0.0,
        contact_length=10e-3,
        effective_radius=_RADIUS,
        contact_modulus=_MODULUS,
    )
    yield compared(
        model="Crowned rollers",
        reference="the even line: 2000 N on 10 mm",
        quantity="load per length without a crown, in the middle and at the ends",
        unit="N/mm",
        expected=[200.0, 200.0],
        computed=[1e-3 * float(cylinder.line_load[0]), 1e-3 * float(cylinder.end_line_load)],
        tolerance=1e-12,
    )


def skewed() -> Iterator[Check]:
    """Rollers whose axes are not parallel."""
    check = functools.partial(compared, model="Skewed rollers", unit="-")
    force, length, friction = 1000.0, 5e-3, 0.12
    width = float(
        hertz_line.half_width(
            normal_force=force, contact_length=length, effective_radius=_RADIUS, contact_modulus=_MODULUS
        )
    )
    along = carter.gross_slip_creepage(
        friction_coefficient=friction, half_width=width, effective_radius=_RADIUS
    )
    bodies = {"youngs_modulus": _YOUNG, "poisson_ratio": _POISSON}
    ratio = skew.lateral_compliance_ratio(
        **{f"{name}_{side}": value for name, value in bodies.items() for side in (1, 2)}
    )
    limits = {"gross_slip_creepage": along, "lateral_gross_slip_creepage": along * ratio}
    small = 1e-9
    shear = _YOUNG / (2.0 * (1.0 + _POISSON))
    # of a strip, Q = (2/pi) C G a B xi: summed over the strips of a long ellipse it is Kalker's C G a b xi
    slopes = [
        float(pair[axis]) * friction * force / small * 0.5 * math.pi / (shear * width * length)
        for axis, pair in enumerate(
            skew.skewed_slip_ratios(longitudinal_creepage=x, lateral_creepage=y, **limits)
            for x, y in ((small, 0.0), (0.0, small))
        )
    ]
    yield check(
        reference="Kalker 1967, coefficients of a long contact: pi²/(4(1 - nu)) and pi²/4",
        quantity="creep coefficients C11 and C22",
        expected=[math.pi**2 / (4.0 * (1.0 - _POISSON)), math.pi**2 / 4.0],
        computed=slopes,
        tolerance=1e-6,
    )
    shares = jnp.array([0.1, 0.25, 0.5, 0.8, 0.95])
    straight = skew.skewed_contact(longitudinal_slip_ratio=shares, lateral_creepage=0.0, **limits)
    _, sideways = skew.skewed_slip_ratios(
        longitudinal_creepage=0.0, lateral_creepage=(1.0 - jnp.sqrt(1.0 - shares)) * along * ratio, **limits
    )
    yield check(
        reference="Carter 1926; Johnson 1985, section 8.3",
        quantity="without skew: creepage at 10 to 95 % of friction over that at gross slip",
        expected=1.0 - jnp.sqrt(1.0 - shares),
        computed=np.asarray(straight.longitudinal_creepage) / float(along),
        tolerance=1e-12,
    )
    yield check(
        reference="Carter 1926, across: antiplane shear has the same curve",
        quantity="skew alone: axial force over friction at the skew that takes 10 to 95 %",
        expected=shares,
        computed=np.asarray(sideways),
        tolerance=1e-12,
    )
    # without contraction across, a strip answers alike in every direction of its plane
    alike = {"gross_slip_creepage": 1e-3, "lateral_gross_slip_creepage": 1e-3}
    half = skew.skewed_slip_ratios(longitudinal_creepage=0.3e-3, lateral_creepage=0.4e-3, **alike)
    left = skew.longitudinal_capacity_ratio(lateral_creepage=0.6e-3, **alike)
    yield check(
        reference="Poisson's ratio 0: Carter's curve along the creepage, Vermeulen and Johnson's rule for a strip",
        quantity="forces over friction at half of the creepage of gross slip, 3 : 4; force left by a skew of 60 %",
        expected=[0.75 * 0.6, 0.75 * 0.8, 0.8],
        computed=[*map(float, half), float(left)],
        tolerance=1e-12,
    )
    slides = skew.skewed_slip_ratios(longitudinal_creepage=3.0, lateral_creepage=4.0, **limits)
    yield check(
        reference="Coulomb: far beyond gross slip the force opposes the sliding, 3 : 4",
        quantity="forces over friction",
        expected=[0.6, 0.8],
        computed=[*map(float, slides)],
        tolerance=1e-5,
    )


def bearings() -> Iterator[Check]:
    """Lives of rolling bearings."""
    turns = 2.0 * math.pi / 60.0
    ball = RatedBearing(55.3e3, 31.5e3, 1.0, 0.0, "ball")
    roller = RatedBearing(8e3, 9e3, 1.0, 100.0, "roller")
    speeds = jnp.array([3000.0, 1500.0]) * turns
    duty = BearingState(
        jnp.array([[10e3, 700.0], [5e3, 1500.0]]), jnp.array([[3000.0, 1500.0], [1500.0, 3000.0]]) * turns
    )
    lives = lives_of_bearings(
        (ball, roller),
        working=BearingState(jnp.array([10e3, 700.0]), speeds),
        rest=jnp.zeros(2),
        duty=duty,
        shares=jnp.array([0.6, 0.4]),
    )
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

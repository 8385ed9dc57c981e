"""One roller pair: the contact law, Hertz, creep, stresses and life, against tables and closed forms."""

from __future__ import annotations

import csv
import functools
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from asperity.contact import (
    carter,
    fractal,
    hertz_line,
    life_factor,
    population,
    rolling_fatigue,
    rolling_in,
    shakedown,
    stress_peaks,
)
from asperity.contact.interface import RoughContact
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.materials import contact_modulus, tangential_contact_modulus
from asperity.types import Array, Real
from asperity.validation.check import Check, compared

#: 40 roller pairs by direct quadrature of the definitions (7)–(24) of Zou et al. 2025, with 20 and more digits.
CONTACT_LAW_TABLE = Path(__file__).with_name("contact_law.csv")

_LAW = "Contact law of rough rollers, (7)-(24)"
_QUADRATURE = "quadrature of the published definitions, 20 digits"


def contact_law() -> Iterator[Check]:
    """Every column of :data:`CONTACT_LAW_TABLE`."""
    with CONTACT_LAW_TABLE.open(encoding="utf-8") as stream:
        table = list(csv.DictReader(stream))
    names = {
        "psi": ("domain extension factor", "-", "domain_extension_factor", 1.0),
        "lam": ("contact factor lambda", "-", "contact_factor", 1.0),
        "a_c_mm2": ("critical area", "mm²", "critical_area", 1e6),
        "a_l_mm2": ("largest contact spot", "mm²", "largest_area", 1e6),
        "A_r_mm2": ("real contact area", "mm²", "real_contact_area", 1e6),
        "Fe_N": ("elastic load", "N", "elastic_load", 1.0),
        "Fp_N": ("plastic load", "N", "plastic_load", 1.0),
        "Kt_N_per_mm": ("tangential stiffness", "N/mm", "tangential_stiffness", 1e-3),
        "Kn_N_per_mm": ("normal stiffness", "N/mm", "normal_stiffness", 1e-3),
    }
    models: tuple[population.ContactFactorModel, ...] = ("printed", "hertz_area", "unity")

    def law(x: dict[str, Array], chosen: Array) -> RoughContact:
        elastic = {
            "youngs_modulus_1": 1e6 * x["E1_MPa"],
            "youngs_modulus_2": 1e6 * x["E2_MPa"],
            "poisson_ratio_1": x["nu1"],
            "poisson_ratio_2": x["nu2"],
        }
        modulus = contact_modulus(**elastic)
        factors = [
            population.contact_factor(
                model=model,
                radius_1=1e-3 * x["R1_mm"],
                radius_2=1e-3 * x["R2_mm"],
                sign=x["sign"],
                contact_length=1e-3 * x["B_mm"],
                contact_modulus=modulus,
                normal_force=x["F_N"],
            )
            for model in models
        ]
        return fractal.fractal_contact(
            surface=fractal.Surface(x["D"], 1e-3 * x["G_mm"], 1.5, "majumdar_bhushan_1991"),
            normal_force=x["F_N"],
            tangential_force=x["T_N"],
            friction_coefficient=x["mu"],
            contact_factor=xp.select([chosen == number for number in range(3)], factors),
            contact_modulus=modulus,
            tangential_contact_modulus=tangential_contact_modulus(**elastic),
            hardness=1e6 * x["H_MPa"],
        )

    columns = {key: np.array([float(row[key]) for row in table]) for key in table[0] if key != "lambda"}
    computed = at_once(law, columns, np.array([models.index(row["lambda"]) for row in table]))
    for name, (quantity, unit, attribute, scale) in names.items():
        yield compared(
            model=_LAW,
            reference=_QUADRATURE,
            quantity=quantity,
            unit=unit,
            expected=columns[name],
            computed=scale * getattr(computed, attribute),
            tolerance=1e-10,
        )


_MODULUS = 206e9 / (2.0 * 0.91)
#: Steel rollers of 10 and 20 mm radius, 10 mm long, under 2000 N.
_RADIUS, _LENGTH, _FORCE = 20e-3 / 3.0, 10e-3, 2000.0


def hertz() -> Iterator[Check]:
    """Two steel rollers by hand."""

    def pair(force: Array) -> tuple[Real, Real]:
        modulus = contact_modulus(
            youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
        )
        width = hertz_line.half_width(
            normal_force=force, contact_length=_LENGTH, effective_radius=_RADIUS, contact_modulus=modulus
        )
        return width, hertz_line.peak_pressure(normal_force=force, contact_length=_LENGTH, half_width=width)

    width, peak = at_once(pair, _FORCE)
    source = "Johnson 1985, (4.43)-(4.45), by hand: 10/20 mm, 10 mm long, 2000 N"
    for quantity, unit, expected, computed, tolerance in (
        ("half-width", "µm", 122.47, 1e6 * width, 1e-4),
        ("peak pressure", "MPa", 1039.64, 1e-6 * peak, 1e-5),
    ):
        yield compared(
            model="Hertz line contact",
            reference=source,
            quantity=quantity,
            unit=unit,
            expected=expected,
            computed=computed,
            tolerance=tolerance,
        )


def creep() -> Iterator[Check]:
    """Carter's law by hand, and CONTACT's deck ``carter2d``."""

    def by_hand(shares: Array) -> Real:
        width = hertz_line.half_width(
            normal_force=_FORCE, contact_length=_LENGTH, effective_radius=_RADIUS, contact_modulus=_MODULUS
        )
        limit = carter.gross_slip_creepage(
            friction_coefficient=0.1, half_width=width, effective_radius=_RADIUS
        )
        return carter.creepage(slip_ratio=shares, gross_slip_creepage=limit)

    def deck(creepage: Array) -> tuple[Real, Real]:
        width = hertz_line.half_width(
            normal_force=178.9e3, contact_length=1.0, effective_radius=0.5, contact_modulus=82e9 / 0.72
        )
        limit = carter.gross_slip_creepage(friction_coefficient=0.3, half_width=width, effective_radius=0.5)
        share = carter.slip_ratio_at_creepage(creepage=creepage, gross_slip_creepage=limit)
        return share, carter.stick_half_width(slip_ratio=share, half_width=width)

    check = functools.partial(compared, model="Creep of a rolling line contact (Carter)")
    creepages, (share, stick) = at_once(
        lambda shares, creepage: (by_hand(shares), deck(creepage)),
        np.array([0.1, 0.25, 0.5, 0.75, 1.0]),
        2.4e-4,
    )
    yield check(
        reference="Carter 1926, by hand: 10/20 mm, 10 mm long, 2000 N, friction 0.1",
        quantity="creepage at 10, 25, 50, 75 and 100 % of friction",
        unit="-",
        expected=[9.427e-5, 2.4612e-4, 5.3806e-4, 9.1852e-4, 1.8370e-3],
        computed=creepages,
        tolerance=6e-5,
    )
    for how, quantity, unit, expected, computed, tolerance in (
        ("50 cells", "traction over friction", "-", 0.6480, share, 0.015),
        ("analytical", "traction over friction", "-", 0.64, share, 1e-4),
        ("analytical", "half-width of the stick zone", "mm", 0.6, 1e3 * stick, 1e-4),
    ):
        yield check(
            reference=f"CONTACT, example carter2d (Vollebregt), {how}",
            quantity=quantity,
            unit=unit,
            expected=expected,
            computed=computed,
            tolerance=tolerance,
        )


def onset() -> Iterator[Check]:
    """The start of rolling, from rest under a constant force."""
    shares, near = np.array([0.25, 0.5, 0.657, 0.8]), np.array([0.25, 0.5, 0.75, 1.0])

    def rolled(shares: Array, distance: Array) -> tuple[Real, Real]:
        at_once = rolling_in.rolling_in_shift(
            rolled_distance=distance, half_width=1.0, slip_ratio=0.25, creepage=1.0
        )
        return rolling_in.rolling_in_lag(half_width=1.0, slip_ratio=shares), at_once

    missing, shift = at_once(rolled, shares, near)
    # creepage over its steady value at 0, 0.02, 0.25, 0.5, 0.75 and 1 half-width, summed by trapezia
    places, rates = [0.0, 0.02, *near], np.array([0.5, 0.501, 0.537, 0.582, 0.638, 0.711])
    summed = np.cumsum(0.5 * (rates[1:] + rates[:-1]) * np.diff(places))[1:]
    check = functools.partial(
        compared,
        model="Onset of rolling",
        reference="two independent two-dimensional solvers, 200 cells, two digits",
        unit="-",
        absolute=True,
    )
    yield check(
        quantity="distance whose steady creep is missing over the half-width, at 25 to 80 % of friction",
        expected=[0.42, 0.32, 0.25, 0.17],
        computed=missing,
        tolerance=8e-3,
    )
    yield check(
        quantity="creep after 0.25 to 1 half-widths over the steady one of a half-width, at 25 % of friction",
        expected=summed,
        computed=shift,
        tolerance=8e-3,
    )


def stresses() -> Iterator[Check]:
    """Stresses below a line contact where they are known, where they are largest, and the shakedown limit."""
    around = 1.0 + 1e-3 * np.arange(-300, 301)
    depths = np.linspace(0.0, 2.0, 2001)
    friction = np.array([0.0, 0.02, 0.05, 0.08, 0.10, 0.15, 0.20, 0.25, 0.30, 0.35])

    def below(x: Array, z: Array, depth: Array, friction: Array) -> tuple[Real, Real, Real]:
        beside = stress_peaks.full_slip_stress(position=x, depth=z, friction_coefficient=0.0)
        middle = stress_peaks.full_slip_stress(position=0.0, depth=depth, friction_coefficient=0.0)
        limit = shakedown.shakedown_limit(friction_coefficient=friction)
        return beside.shear, 0.5 * (middle.longitudinal - middle.normal), limit

    x, z = np.meshgrid(np.sqrt(0.75) * around, 0.5 * around, indexing="ij")
    shear, principal, limits = at_once(below, x, z, depths, friction)
    largest = np.unravel_index(np.argmax(np.abs(shear)), shear.shape)
    deepest = int(np.argmax(principal))
    check = functools.partial(compared, model="Stresses below a line contact", unit="-")
    yield check(
        reference="closed form: p0/4 at half the half-width, (√3/2) a beside the middle",
        quantity="largest alternating shear stress over the peak pressure, its position and depth over the half-width",
        expected=[0.25, np.sqrt(0.75), 0.5],
        computed=[abs(shear[largest]), x[largest], z[largest]],
        tolerance=1e-9,
    )
    yield check(
        reference="Johnson 1985, (4.46): z/a - (z/a)²/√(1 + (z/a)²)",
        quantity="principal shear stress over the peak pressure below the middle, to the depth of the width",
        expected=(depths - depths**2 / np.sqrt(1.0 + depths**2))[1:],
        computed=principal[1:],
        tolerance=1e-9,
    )
    yield check(
        reference="Johnson 1985, figure 4.5: 0.300 at 0.78",
        quantity="largest principal shear stress over the peak pressure, and its depth over the half-width",
        expected=[0.300, 0.786],
        computed=[principal[deepest], depths[deepest]],
        tolerance=2e-3,
    )
    yield compared(
        model="Shakedown limit of rolling with traction",
        reference="Melan's theorem, optimised independently; Johnson 1985, section 9.2, gives 4.00",
        quantity="peak pressure over the shear yield strength for friction 0 to 0.35",
        unit="-",
        expected=[4.0, 3.906, 3.772, 3.645, 3.564, 3.375, 3.202, 3.044, 2.900, 2.767],
        computed=limits,
        tolerance=2e-4,
    )


def fatigue() -> Iterator[Check]:
    """Lives of a rolling track by hand."""
    peaks = np.array([1.0e9, 1.03964e9, 1.4e9, 1.8e9, 2.0e9])
    lives, rates, shares = np.array([2e8, 5e8, 1e7]), np.array([20.0, 10.0, 40.0]), np.array([0.5, 0.3, 0.2])

    def life(peak: Array) -> Real:
        return rolling_fatigue.line_contact_life(
            peak_pressure=peak,
            half_width=2.0 * peak * _RADIUS / _MODULUS,
            contact_length=_LENGTH,
            track_radius=10e-3,
            material_constant=rolling_fatigue.BEARING_STEEL,
        )

    def duty(lives: Array, rates: Array, shares: Array) -> tuple[Real, Real]:
        loads = {"lives": lives, "cycle_rates": rates, "time_shares": shares}
        return rolling_fatigue.spectrum_life(**loads), rolling_fatigue.damage_shares(**loads)

    alone, (together, damage) = at_once(
        lambda peak, *loads: (life(peak), duty(*loads)), peaks, lives, rates, shares
    )
    yield compared(
        model="Fatigue life of a rolling track (Lundberg-Palmgren)",
        reference="published form by hand: track of 10 mm radius and length",
        quantity="life with 90 % reliability at 1000 to 2000 MPa",
        unit="1e6 cycles",
        expected=[2.2117e5, 1.6143e5, 1.4491e4, 1.8925e3, 8.0610e2],
        computed=alone,
        tolerance=2e-4,
    )
    lost = shares * rates / lives  # a second
    check = functools.partial(compared, model="Life under a duty", tolerance=1e-12)
    source = (
        "Palmgren 1924 and Miner 1945 by hand: 2e8, 5e8 and 1e7 cycles, 20, 10 and 40 Hz, 50, 30 and 20 %"
    )
    yield check(
        reference=source,
        quantity="life",
        unit="h",
        expected=1.0 / lost.sum() / 3600.0,
        computed=together / 3600.0,
    )
    yield check(
        reference=source,
        quantity="shares of the loads in the damage",
        unit="-",
        expected=lost / lost.sum(),
        computed=damage,
    )
    yield from _films()


def _films() -> Iterator[Check]:
    """Factor of the life for films of four viscosity ratios, at two loads, by hand."""
    films, loads = np.array([0.1, 0.4, 1.0, 4.0]), np.array([[0.2], [1.0]])

    def factors(kappa: Array, load: Array) -> Array:
        return life_factor.life_modification_factor(
            viscosity_ratio=kappa, cleanliness=0.5, fatigue_load_ratio=2.0 * load
        )

    yield compared(
        model="Factor a_ISO of the life for the oil film (ISO 281)",
        reference="published form by hand: kappa 0.1, 0.4, 1 and 4, cleanliness times C_u/P 0.2 and 1",
        quantity="life with the film over life without",
        unit="-",
        expected=[[0.099972, 0.177338, 0.650507, 1.33505], [0.0999462, 0.307475, 5.31064, 32.9195]],
        computed=at_once(factors, films, loads),
        tolerance=1e-5,
    )

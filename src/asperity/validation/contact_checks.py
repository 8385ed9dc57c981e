"""One roller pair: the contact law, Hertz, creep, stresses and life, against tables and closed forms."""

from __future__ import annotations

import csv
import functools
from collections.abc import Iterator
from pathlib import Path

import jax.numpy as jnp
import numpy as np

from asperity.contact import carter, fractal, hertz_line, population, rolling_fatigue, shakedown, stress_peaks
from asperity.materials import contact_modulus, tangential_contact_modulus
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
    expected: dict[str, list[float]] = {name: [] for name in names}
    computed: dict[str, list[float]] = {name: [] for name in names}
    for model in ("printed", "hertz_area", "unity"):
        rows = [row for row in table if row["lambda"] == model]
        x = {key: jnp.array([float(row[key]) for row in rows]) for key in table[0] if key != "lambda"}
        elastic = {
            "youngs_modulus_1": 1e6 * x["E1_MPa"],
            "youngs_modulus_2": 1e6 * x["E2_MPa"],
            "poisson_ratio_1": x["nu1"],
            "poisson_ratio_2": x["nu2"],
        }
        modulus = contact_modulus(**elastic)
        factor = population.contact_factor(
            model=model,
            radius_1=1e-3 * x["R1_mm"],
            radius_2=1e-3 * x["R2_mm"],
            sign=x["sign"],
            contact_length=1e-3 * x["B_mm"],
            contact_modulus=modulus,
            normal_force=x["F_N"],
        )
        law = fractal.fractal_contact(
            surface=fractal.Surface(x["D"], 1e-3 * x["G_mm"], 1.5, "majumdar_bhushan_1991"),
            normal_force=x["F_N"],
            tangential_force=x["T_N"],
            friction_coefficient=x["mu"],
            contact_factor=factor,
            contact_modulus=modulus,
            tangential_contact_modulus=tangential_contact_modulus(**elastic),
            hardness=1e6 * x["H_MPa"],
        )
        for name, (_, _, attribute, scale) in names.items():
            expected[name] += list(x[name])
            computed[name] += list(scale * np.asarray(getattr(law, attribute)))
    for name, (quantity, unit, _, _) in names.items():
        yield compared(
            model=_LAW,
            reference=_QUADRATURE,
            quantity=quantity,
            unit=unit,
            expected=expected[name],
            computed=computed[name],
            tolerance=1e-10,
        )


#: Steel rollers of 10 and 20 mm radius, 10 mm long, under 2000 N.
_RADIUS, _LENGTH, _FORCE = 20e-3 / 3.0, 10e-3, 2000.0


def hertz() -> Iterator[Check]:
    """Two steel rollers by hand."""
    modulus = contact_modulus(
        youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )
    width = hertz_line.half_width(
        normal_force=_FORCE, contact_length=_LENGTH, effective_radius=_RADIUS, contact_modulus=modulus
    )
    peak = hertz_line.peak_pressure(normal_force=_FORCE, contact_length=_LENGTH, half_width=width)
    source = "Johnson 1985, (4.43)-(4.45), by hand: 10/20 mm, 10 mm long, 2000 N"
    for quantity, unit, expected, computed, tolerance in (
        ("half-width", "µm", 122.47, 1e6 * np.asarray(width), 1e-4),
        ("peak pressure", "MPa", 1039.64, 1e-6 * np.asarray(peak), 1e-5),
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
    check = functools.partial(compared, model="Creep of a rolling line contact (Carter)")
    modulus = 206e9 / (2.0 * 0.91)
    width = hertz_line.half_width(
        normal_force=_FORCE, contact_length=_LENGTH, effective_radius=_RADIUS, contact_modulus=modulus
    )
    limit = carter.gross_slip_creepage(friction_coefficient=0.1, half_width=width, effective_radius=_RADIUS)
    yield check(
        reference="Carter 1926, by hand: 10/20 mm, 10 mm long, 2000 N, friction 0.1",
        quantity="creepage at 10, 25, 50, 75 and 100 % of friction",
        unit="-",
        expected=[9.427e-5, 2.4612e-4, 5.3806e-4, 9.1852e-4, 1.8370e-3],
        computed=carter.creepage(
            slip_ratio=jnp.array([0.1, 0.25, 0.5, 0.75, 1.0]), gross_slip_creepage=limit
        ),
        tolerance=6e-5,
    )
    width = hertz_line.half_width(
        normal_force=178.9e3, contact_length=1.0, effective_radius=0.5, contact_modulus=82e9 / 0.72
    )
    limit = carter.gross_slip_creepage(friction_coefficient=0.3, half_width=width, effective_radius=0.5)
    share = carter.slip_ratio_at_creepage(creepage=2.4e-4, gross_slip_creepage=limit)
    stick = 1e3 * np.asarray(carter.stick_half_width(slip_ratio=share, half_width=width))
    for how, quantity, unit, expected, computed, tolerance in (
        ("50 cells", "traction over friction", "-", 0.6480, share, 0.015),
        ("analytical", "traction over friction", "-", 0.64, share, 1e-4),
        ("analytical", "half-width of the stick zone", "mm", 0.6, stick, 1e-4),
    ):
        yield check(
            reference=f"CONTACT, example carter2d (Vollebregt), {how}",
            quantity=quantity,
            unit=unit,
            expected=expected,
            computed=computed,
            tolerance=tolerance,
        )


def stresses() -> Iterator[Check]:
    """Largest stresses below a line contact, and the shakedown limit."""
    shear = stress_peaks.shear_peak(friction_coefficient=jnp.zeros(1))
    mises = stress_peaks.mises_peak(friction_coefficient=jnp.zeros(1), poisson_ratio=0.5)
    check = functools.partial(compared, model="Stresses below a line contact", unit="-")
    yield check(
        reference="closed form: p0/4 at half the half-width, (√3/2) a beside the middle",
        quantity="largest alternating shear stress over the peak pressure, its position and depth over the half-width",
        expected=[0.25, np.sqrt(0.75), 0.5],
        computed=[float(v[0]) for v in (shear.stress, shear.position, shear.depth)],
        tolerance=1e-9,
    )
    yield check(
        reference="Johnson 1985, figure 4.5: 0.300 at 0.78",
        quantity="largest principal shear stress over the peak pressure, and its depth over the half-width",
        expected=[0.300, 0.786],
        computed=[float(mises.stress[0]), float(mises.depth[0])],
        tolerance=2e-3,
    )
    friction = jnp.array([0.0, 0.02, 0.05, 0.08, 0.10, 0.15, 0.20, 0.25, 0.30, 0.35])
    yield compared(
        model="Shakedown limit of rolling with traction",
        reference="Melan's theorem, optimised independently; Johnson 1985, section 9.2, gives 4.00",
        quantity="peak pressure over the shear yield strength for friction 0 to 0.35",
        unit="-",
        expected=[4.0, 3.906, 3.772, 3.645, 3.564, 3.375, 3.202, 3.044, 2.900, 2.767],
        computed=shakedown.shakedown_limit(friction_coefficient=friction),
        tolerance=2e-4,
    )


def fatigue() -> Iterator[Check]:
    """Life of a rolling track by hand."""
    modulus = 206e9 / (2.0 * 0.91)
    peak = jnp.array([1.0e9, 1.03964e9, 1.4e9, 1.8e9, 2.0e9])
    yield compared(
        model="Fatigue life of a rolling track (Lundberg-Palmgren)",
        reference="published form by hand: track of 10 mm radius and length",
        quantity="life with 90 % reliability at 1000 to 2000 MPa",
        unit="1e6 cycles",
        expected=[2.2117e5, 1.6143e5, 1.4491e4, 1.8925e3, 8.0610e2],
        computed=rolling_fatigue.line_contact_life(
            peak_pressure=peak,
            half_width=2.0 * peak * _RADIUS / modulus,
            contact_length=_LENGTH,
            track_radius=10e-3,
            material_constant=rolling_fatigue.BEARING_STEEL,
        ),
        tolerance=2e-4,
    )

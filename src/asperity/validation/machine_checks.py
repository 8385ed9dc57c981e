"""What surrounds the contacts: oil and heat, asperities in rolling, fits, temperature, cams and pins, by hand."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

import numpy as np

from asperity.body.press_fit import PressFit, press_fit
from asperity.contact import creep_layer, film_thickness, flash_temperature, rolling_losses
from asperity.drive.layout.expansion import interference_of_strains, ring_expansion, ring_interference
from asperity.drive.stiffness.loading_cam import cam_angle, cam_preload
from asperity.drive.structure.pin_beam import pin_bending_moment, pin_bending_stress
from asperity.drive.types.planetary import planetary_drive
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.materials import Material
from asperity.types import Array, Document, Real
from asperity.validation.check import Check, compared

#: Steel rollers of 10 and 20 mm radius, 10 mm long, under 2000 N, which roll at 1 m/s.
_MODULUS, _RADIUS, _LENGTH, _FORCE, _SPEED = 206e9 / 1.82, 20e-3 / 3.0, 10e-3, 2000.0, 1.0
_ROLLERS = "10/20 mm, 10 mm long, 2000 N, 1 m/s"


def oil() -> Iterator[Check]:
    """Film, drag and heat of a lubricated contact."""
    pair: Document = {
        "line_load": _FORCE / _LENGTH,
        "effective_radius": _RADIUS,
        "contact_modulus": _MODULUS,
    }
    slides, half_width = 0.005, 122.474e-6  # m/s, m

    def found(viscosity: Array, conductivity: Array) -> tuple[Real, ...]:
        flow = {"viscosity": viscosity, "entrainment_speed": _SPEED, **pair}
        film = film_thickness.minimum_film_thickness(pressure_coefficient=2.918e-8, **flow)
        drag = rolling_losses.inlet_rolling_power(
            rolling_force=rolling_losses.inlet_rolling_force(**flow),
            contact_length=_LENGTH,
            entrainment_speed=_SPEED,
        )
        effusivity = flash_temperature.thermal_effusivity(
            conductivity=conductivity, density=7800.0, heat_capacity=460.0
        )
        heat = flash_temperature.flash_temperature(
            friction_power=0.07 * slides * _FORCE / _LENGTH,
            surface_speed_1=_SPEED + 0.5 * slides,
            surface_speed_2=_SPEED - 0.5 * slides,
            half_width=half_width,
            effusivity_1=effusivity,
            effusivity_2=effusivity,
        )
        return film, drag, heat

    film, drag, heat = at_once(found, 30.5e-3, 46.0)
    for model, source, quantity, unit, expected, computed, tolerance in (
        (
            "Lubricating film",
            "Dowson and Higginson 1968 by hand: 30.5 mPa·s, 29.18 1/GPa",
            "smallest thickness",
            "µm",
            0.2128,
            1e6 * film,
            5e-4,
        ),
        (
            "Drag of the oil",
            "Biboulet and Houpert 2010 by hand: 30.5 mPa·s",
            "power lost at the inlet",
            "W",
            0.712,
            drag,
            7e-4,
        ),
        (
            "Flash temperature",
            "Blok 1937 by hand: friction 0.07, slip 0.5 %, steel of 46 W/(m·K)",
            "rise",
            "K",
            0.193,
            heat,
            2.5e-3,
        ),
    ):
        yield compared(
            model=model,
            reference=f"{source}; {_ROLLERS}",
            quantity=quantity,
            unit=unit,
            expected=expected,
            computed=computed,
            tolerance=tolerance,
        )


def layers() -> Iterator[Check]:
    """Asperities as springs with memory between two rolling cylinders."""
    ratios, shares = np.array([0.01, 0.02, 0.05, 0.1, 0.2]), np.array([0.1, 0.25, 0.5, 0.8])
    factors, peaks = at_once(
        lambda ratio, share: (
            creep_layer.layer_creepage_factor(
                layer_ratio=ratio[:, None], slip_ratio=share, stiffness_ratio=1.4 / 1.7
            ),
            creep_layer.peak_pressure_factor(layer_ratio=ratio),
        ),
        ratios,
        shares,
    )
    check = functools.partial(
        compared,
        model="Asperities in rolling",
        reference="independent solver: elastic strips with springs of every gap, 600 cells; layer ratio 0.01 to 0.2",
        unit="-",
    )
    yield check(
        quantity="creepage over Carter's at 10, 25, 50 and 80 % of friction",
        expected=[
            [1.014, 1.014, 1.015, 1.020],
            [1.027, 1.026, 1.028, 1.037],
            [1.059, 1.060, 1.065, 1.085],
            [1.110, 1.113, 1.125, 1.163],
            [1.205, 1.214, 1.237, 1.306],
        ],
        computed=factors,
        tolerance=4e-3,
    )
    yield check(
        quantity="peak pressure over Hertz's",
        expected=[0.990, 0.980, 0.952, 0.907, 0.830],
        computed=peaks,
        tolerance=6e-4,
        absolute=True,
    )


_STEEL = Material(206e9, 0.3, 7850.0, 450e6, 1260e6)
_ALUMINIUM = Material(69e9, 0.33, 2700.0, 276e6, 900e6)


def _lame(material: Material, radius: float) -> np.ndarray:
    """Radial stress, hoop stress and displacement of A r + B/r in plane stress, per A and per B, shape (3, 2)."""
    young, poisson = material.youngs_modulus, material.poisson_ratio
    even, uneven = young / (1.0 - poisson), young / (1.0 + poisson) / radius**2
    return np.array([[even, -uneven], [even, uneven], [radius, 1.0 / radius]])


_BORE, _SEAT, _OUTER, _INTERFERENCE = 50e-3, 58e-3, 100e-3, 40e-6
#: Thermal expansion of the ring, of the housing, and of the ring beyond that of its rollers [1/K].
_RING_EXPANSION, _HOUSING_EXPANSION, _BEYOND_ROLLERS = 12.6e-6, 23.6e-6, 11.5e-6


def fits() -> Iterator[Check]:
    """A steel ring pressed into an aluminium housing."""
    none = xp.zeros(2)
    rows = np.array(
        [
            [*_lame(_STEEL, _BORE)[0], *none],
            [*none, *_lame(_ALUMINIUM, _OUTER)[0]],
            [*_lame(_STEEL, _SEAT)[0], *-_lame(_ALUMINIUM, _SEAT)[0]],
            [*-_lame(_STEEL, _SEAT)[2] * 1e9, *_lame(_ALUMINIUM, _SEAT)[2] * 1e9],
        ]
    )
    ring, housing = np.linalg.solve(rows, [0.0, 0.0, 0.0, 0.5e9 * _INTERFERENCE]).reshape(2, 2)

    def found(interference: Array) -> PressFit:
        return press_fit(
            ring=_STEEL,
            housing=_ALUMINIUM,
            bore_radius=_BORE,
            seat_radius=_SEAT,
            outer_radius=_OUTER,
            interference=interference,
        )

    fit = at_once(found, _INTERFERENCE)
    check = functools.partial(
        compared,
        model="Press fit of a ring in its housing",
        reference="Lamé's fields of both, fitted to each other: steel 50/58 mm in aluminium 58/100 mm, 40 µm",
        tolerance=1e-9,
    )
    yield check(
        quantity="pressure; hoop stress of the ring at bore and seat, and of the housing at its bore",
        unit="MPa",
        expected=1e-6
        * np.array(
            [
                -_lame(_STEEL, _SEAT)[0] @ ring,
                _lame(_STEEL, _BORE)[1] @ ring,
                _lame(_STEEL, _SEAT)[1] @ ring,
                _lame(_ALUMINIUM, _SEAT)[1] @ housing,
            ]
        ),
        computed=1e-6 * np.array([fit.pressure, *fit.ring_hoop, fit.housing_hoop]),
    )
    yield check(
        quantity="narrowing of the bore",
        unit="µm",
        expected=-2e6 * _lame(_STEEL, _BORE)[2] @ ring,
        computed=1e6 * fit.bore_change,
    )
    yield from _expansions()


def _expansions() -> Iterator[Check]:
    """What temperature does to a ring in its housing, and to the interference of its rollers."""
    drive = planetary_drive(sun_radius=10e-3, planet_radius=15e-3, planet_count=3)

    def found(rise: Array) -> tuple[Real, Real]:
        widening = ring_expansion(
            ring=_RING_EXPANSION,
            housing=_HOUSING_EXPANSION,
            inner_radius=_BORE,
            wall_thickness=_SEAT - _BORE,
            youngs_modulus=206e9,
            poisson_ratio=0.3,
            housing_stiffness=math.inf,
            plane_state="plane_stress",
        )
        # the ring grows by more than the rollers, of whichever material they are
        none = xp.zeros(2)
        strains = none, xp.stack([0.0 * rise, _BEYOND_ROLLERS * rise])
        change = interference_of_strains(drive=drive, strains=strains, carrier=none[0])
        return widening, ring_interference(drive=drive, forces=xp.ones(2), interference=change)

    widening, loosening = at_once(found, 20.0)
    # u = A r + B/r without stress at the bore, pulled by the housing at the seat
    pulled = np.linalg.solve(
        [_lame(_STEEL, _BORE)[0] / 1e11, _lame(_STEEL, _SEAT)[2]],
        [0.0, (_HOUSING_EXPANSION - _RING_EXPANSION) * _SEAT],
    )
    check = functools.partial(compared, model="Temperature", tolerance=1e-9)
    yield check(
        reference="Lamé's field: a steel ring 50/58 mm in a rigid aluminium housing",
        quantity="expansion of the bore",
        unit="1e-6/K",
        expected=1e6 * _RING_EXPANSION + 1e6 * (_lame(_STEEL, _BORE)[2] @ pulled) / _BORE,
        computed=1e6 * widening,
    )
    yield check(
        reference="by hand: a ring of 40 mm that expands by 11.5e-6/K more than its rollers, 20 K",
        quantity="interference that it takes",
        unit="µm",
        expected=_BEYOND_ROLLERS * 40e-3 * 20.0 * 1e6,
        computed=-1e6 * loosening,
    )


def structure() -> Iterator[Check]:
    """A loading cam, and pins as beams."""
    pin: dict[str, float] = {"force": 120.0, "free_length": 9e-3, "roller_length": 5e-3}

    def found(torque: Array, diameter: Array) -> Document:
        both = pin_bending_moment(support="both_ends", **pin)
        return {
            "preload": cam_preload(least_preload=200.0, force_per_torque=150.0, output_torque=torque),
            "angle": cam_angle(
                branches=3.0,
                rest_force=xp.asarray([400.0, 600.0]),
                preload=1000.0,
                force_per_torque=150.0,
                closed=xp.asarray([3e-6, 5e-6]),
            ),
            "moments": [both, pin_bending_moment(support="one_end", **pin)],
            "stress": pin_bending_stress(moment=both, diameter=diameter),
        }

    computed = at_once(found, np.array([-4.0, 0.0, 4.0]), 4e-3)
    cam = functools.partial(compared, model="Loading cam", tolerance=1e-12)
    yield cam(
        reference="by hand: 200 N and 150 N per N·m of torque",
        quantity="preload at -4, 0 and 4 N·m",
        unit="N",
        expected=[800.0, 200.0, 800.0],
        computed=computed["preload"],
    )
    yield cam(
        reference="work of the torque is that of the forces: 3 branches, 400 N by 3 µm and 600 N by 5 µm of 1000 N",
        quantity="angle at the output",
        unit="µrad",
        expected=3.0 * 150.0 * (0.4 * 3.0 + 0.6 * 5.0),
        computed=1e6 * computed["angle"],
    )
    beam = functools.partial(compared, model="Pins as beams", tolerance=1e-12)
    yield beam(
        reference="statics by hand: 120 N over 5 mm in the middle of a pin of 9 mm, F (2 l - b)/8 and F l/2",
        quantity="bending moment, held at both ends and at one",
        unit="N·mm",
        expected=[120.0 * 13.0 / 8.0, 120.0 * 9.0 / 2.0],
        computed=1e3 * np.array(computed["moments"]),
    )
    yield beam(
        reference="second moment of area of a circle: pin of 4 mm",
        quantity="bending stress",
        unit="MPa",
        expected=195.0 / (math.pi * 2.0**4 / 4.0) * 2.0,
        computed=1e-6 * computed["stress"],
    )

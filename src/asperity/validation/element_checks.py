"""Half-spaces, discs and rings as elastic bodies, against CONTACT, closed forms and independent solvers."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator, Sequence

import jax
import jax.numpy as jnp
import numpy as np

from asperity.bem import (
    ElasticPair,
    FreeHalfSpace,
    elastic_pair,
    normal_contact,
    partial_slip,
    steady_rolling,
    transient_rolling,
)
from asperity.body.compliance import compliance_matrix, modes_needed
from asperity.body.shapes import Annulus, Disc
from asperity.validation.check import Check, compared

_LIKE = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)


def half_space() -> Iterator[Check]:
    """The response of the half-space far from a load."""
    free = FreeHalfSpace(_LIKE, shape=(41, 41), pixel_size=(1.0, 1.0))
    load = np.zeros((2, 41, 41))
    load[0, 0, 0] = 1.0
    x, y = 40.0, 30.0
    r = np.hypot(x, y)
    poisson, shear = _LIKE.poisson_ratio, _LIKE.antiplane_modulus
    pressed = np.asarray(free.normal_displacement(jnp.asarray(load[0])))[40, 30]
    sheared = np.asarray(free.shear_displacement(jnp.asarray(load)))[:, 40, 30]
    yield compared(
        model="Boundary elements: half-space",
        reference="Boussinesq and Cerruti; Johnson 1985, (3.22a) and (3.75)",
        quantity="displacements 50 pixels from a point load",
        unit="m",
        expected=[
            1.0 / (2.0 * np.pi * r),
            (1.0 - poisson + poisson * x**2 / r**2) / (2.0 * np.pi * shear * r),
            poisson * x * y / r**3 / (2.0 * np.pi * shear),
        ],
        computed=[pressed, *sheared],
        tolerance=1e-4,
    )


def sliding() -> Iterator[Check]:
    """Partial slip of a ball."""
    shear, poisson, radius, force, friction, pixel = 200e6, 0.42, 50e-3, 9.1954, 0.4, 0.13333e-3
    young = 2.0 * shear * (1.0 + poisson)
    pair = elastic_pair(
        youngs_modulus_1=young, youngs_modulus_2=young, poisson_ratio_1=poisson, poisson_ratio_2=poisson
    )
    x = (np.arange(19) - 9) * pixel
    ball = normal_contact(
        FreeHalfSpace(pair, shape=(19, 19), pixel_size=(pixel, pixel)),
        -(x[:, None] ** 2 + x**2) / (2.0 * radius),
        normal_force=force,
    )
    slip = partial_slip(
        ball.half_space,
        ball.pressure,
        friction_coefficient=friction,
        axis=0,
        tangential_force=np.array([0.875 * friction * force]),
    )
    for quantity, unit, expected, computed, tolerance in (
        ("displacement at 7/8 of sliding", "µm", 8.155, slip.displacement, 3e-3),
        ("work of friction", "µJ", 2.750, slip.friction_work, 1e-2),
    ):
        yield compared(
            model="Boundary elements: partial slip",
            reference="CONTACT, example cattaneo (Vollebregt, Kalker)",
            quantity=quantity,
            unit=unit,
            expected=expected,
            computed=1e6 * np.asarray(computed[0]),
            tolerance=tolerance,
        )


def _line_contact(margin: int) -> tuple[FreeHalfSpace, np.ndarray]:
    """Half-width 1, contact modulus 2, largest traction 1: gross slip begins at creepage 1."""
    cells = 200
    pixel = 2.0 / cells
    strip = FreeHalfSpace(_LIKE, shape=(cells + 2 * margin,), pixel_size=(pixel,), reference_distance=10.0)
    edge = np.linspace(-1.0, 1.0, cells + 1)
    integral = 0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))
    return strip, np.pad(np.diff(integral) / pixel, margin)


def rolling() -> Iterator[Check]:
    """A line contact that rolls, steadily and from rest."""
    shares = np.array([0.1, 0.25, 0.5, 0.8, 0.95])
    strip, pressure = _line_contact(0)
    load = float(pressure.sum() * strip.pixel_size[0])
    creepage = [
        float(
            steady_rolling(
                strip,
                pressure,
                friction_coefficient=1.0,
                layer_compliance=0.0,
                lateral_creepage=0.0,
                longitudinal_force=share * load,
            ).creepage[0]
        )
        for share in shares
    ]
    yield compared(
        model="Boundary elements: steady rolling",
        reference="Carter 1926; Johnson 1985, section 8.3",
        quantity="creepage at 10 to 95 % of friction over that at gross slip, 200 cells",
        unit="-",
        expected=1.0 - np.sqrt(1.0 - shares),
        computed=creepage,
        tolerance=5e-3,
    )
    strip, pressure = _line_contact(2)
    onset = transient_rolling(
        strip,
        pressure,
        friction_coefficient=1.0,
        axis=0,
        layer_compliance=0.0,
        rolled_pixels=np.array([0] + [1] * 310),
        tangential_force=np.full(311, 0.5 * load),
    )
    middle = np.asarray(onset.rolled_distance)[1:] - 0.005
    ratio = np.asarray(onset.creepage)[1:] / (1.0 - np.sqrt(0.5))
    yield compared(
        model="Boundary elements: onset of rolling",
        reference="two independent two-dimensional solvers",
        quantity="creepage over Carter's after 0.02 to 3 half-widths, at half of friction",
        unit="-",
        expected=[0.502, 0.546, 0.604, 0.687, 0.837, 1.222, 1.052, 0.970, 0.998, 1.002],
        computed=np.interp([0.02, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0], middle, ratio),
        tolerance=0.015,
    )


_MODULUS, _POISSON, _LENGTH = 206e9, 0.3, 5e-3
_compared = functools.partial(compared, model="Elastic discs and rings")

_compiled = jax.jit(compliance_matrix, static_argnames=("copies", "mode_count"))


def _matrix(
    body: Disc | Annulus, angles: Sequence[float], half_width: float, *, copies: int, modes: int
) -> np.ndarray:
    widths = jnp.full(len(angles), half_width)
    return np.asarray(
        _compiled(
            body=body,
            contact_angles=jnp.asarray(angles, dtype=float),
            half_widths=widths,
            stick_half_widths=widths,
            copies=copies,
            mode_count=modes,
        )
    )


def discs() -> Iterator[Check]:
    """A roller between two contacts."""
    disc = Disc(13.5e-3, _LENGTH, _MODULUS, _POISSON, "plane_strain")
    c = _matrix(disc, [0.0, math.pi], 80e-6, copies=1, modes=0)
    by_hand = (
        2.0
        * (1.0 - _POISSON**2)
        / (math.pi * _MODULUS * _LENGTH)
        * (2.0 * math.log(4.0 * 13.5e-3 / 80e-6) - 2.0)
    )
    yield _compared(
        reference="Johnson 1985, (5.57), differentiated: R 13.5, L 5 mm, half-width 80 µm",
        quantity="approach of two opposite contacts per force",
        unit="µm/kN",
        expected=1e9 * by_hand,
        computed=1e9 * (c[0, 0] + c[0, 1] + c[1, 0] + c[1, 1]),
        tolerance=5e-4,
    )
    # of a half-space, by the same derivative: (2 ln(2d/b) - nu/(1 - nu) - 1) in place of (2 ln(4R/b) - 2)
    half = 0.5 * (c[0, 0] + c[0, 1] + c[1, 0] + c[1, 1]) * math.pi * _MODULUS * _LENGTH / (1.0 - _POISSON**2)
    depth = 0.5 * 80e-6 * math.exp(0.5 * (half + _POISSON / (1.0 - _POISSON) + 1.0))
    yield _compared(
        reference="measured: three quarters of the diameter, J. Tribol. 110(2) 285 (1988)",
        quantity="depth at which a half-space moves as the middle of a roller, over the diameter",
        unit="-",
        expected=0.75,
        computed=depth / (2.0 * 13.5e-3),
        tolerance=0.02,
    )


def rings() -> Iterator[Check]:
    """The paper's ring with three walls, and thin rings under equal radial loads."""
    polar = math.radians(13.9248)
    walls = (4e-3, 10e-3, 60e-3)
    for support, name, expected in (
        (0.0, "free", (2.21915e-7, 2.43827e-8, 4.93787e-9)),
        (math.inf, "held", (2.20987e-9, 2.71043e-9, 3.81412e-9)),
    ):
        displacements = []
        for wall in walls:
            ring = Annulus(
                40e-3, 40e-3 + wall, _LENGTH, _MODULUS, _POISSON, support, support, "inner", "plane_strain"
            )
            modes = modes_needed(inner_radius=40e-3, outer_radius=40e-3 + wall, copies=3)
            displacements.append(_matrix(ring, [-polar, polar], 91.2e-6, copies=3, modes=modes)[0, :2].sum())
        yield _compared(
            reference="independent sum of 40 000 modes: ring of 40 mm under six loads, walls of 4, 10 and 60 mm",
            quantity=f"radial displacement per force, outer rim {name}",
            unit="µm/kN",
            expected=1e9 * np.array(expected),
            computed=1e9 * np.array(displacements),
            tolerance=1e-3,
        )
    counts, wall = (2, 3, 4), 2e-3
    displacements = []
    for count in counts:
        ring = Annulus(
            1.0 - wall / 2, 1.0 + wall / 2, 1.0, _MODULUS, _POISSON, 0.0, 0.0, "inner", "plane_stress"
        )
        c = _matrix(ring, [0.0], wall / 50, copies=count, modes=math.ceil(6000 / count))
        displacements.append(c[0, 0] * _MODULUS * wall**3 / 12.0)
    yield _compared(
        reference="bending of a thin ring under 2, 3 and 4 equal loads, closed form (Timoshenko)",
        quantity="displacement of a load times EI/(P R³)",
        unit="-",
        expected=[0.07438920, 0.01593859, 0.00607931],
        computed=displacements,
        tolerance=2e-3,
    )

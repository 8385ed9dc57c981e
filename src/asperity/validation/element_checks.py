"""Boundary elements against CONTACT, closed forms and two independent solvers."""

from __future__ import annotations

from collections.abc import Iterator

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
    deck = "CONTACT, example cattaneo (Vollebregt, Kalker)"
    yield compared(
        model="Boundary elements: partial slip",
        reference=deck,
        quantity="displacement at 7/8 of sliding",
        unit="µm",
        expected=8.155,
        computed=1e6 * np.asarray(slip.displacement[0]),
        tolerance=3e-3,
    )
    yield compared(
        model="Boundary elements: partial slip",
        reference=deck,
        quantity="work of friction",
        unit="µJ",
        expected=2.750,
        computed=1e6 * np.asarray(slip.friction_work[0]),
        tolerance=1e-2,
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
    """A line contact that rolls, steadily and from rest.

    Yields
    ------
    Check
        Creepage over friction.
    """
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

"""Discs and rings as elastic bodies, against Johnson, ring theory and independent sums of modes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.body.compliance import compliance_matrix, modes_needed
from asperity.body.shapes import Annulus, Disc
from asperity.validation.check import Check, compared

_MODULUS, _POISSON, _LENGTH = 206e9, 0.3, 5e-3
_MODEL = "Elastic discs and rings"

_compiled = jax.jit(compliance_matrix, static_argnames=("copies", "mode_count"))


def _matrix(
    body: Disc | Annulus, angles: Sequence[float], half_width: float, *, copies: int, modes: int
) -> np.ndarray:
    widths: Array = jnp.full(len(angles), half_width)
    compliance: np.ndarray = np.asarray(
        _compiled(
            body=body,
            contact_angles=jnp.asarray(angles, dtype=float),
            half_widths=widths,
            stick_half_widths=widths,
            copies=copies,
            mode_count=modes,
        )
    )
    return compliance


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
    yield compared(
        model=_MODEL,
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
    yield compared(
        model=_MODEL,
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
        yield compared(
            model=_MODEL,
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
    yield compared(
        model=_MODEL,
        reference="bending of a thin ring under 2, 3 and 4 equal loads, closed form (Timoshenko)",
        quantity="displacement of a load times EI/(P R³)",
        unit="-",
        expected=[0.07438920, 0.01593859, 0.00607931],
        computed=displacements,
        tolerance=2e-3,
    )

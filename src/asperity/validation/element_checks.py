"""Half-spaces, discs and rings as elastic bodies, against CONTACT, closed forms and independent solvers."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator, Sequence

import numpy as np

from asperity.bem import (
    ElasticPair,
    FreeHalfSpace,
    elastic_pair,
    normal_contact,
    partial_slip,
    steady_rolling,
)
from asperity.body.compliance import compliance_matrix
from asperity.body.shapes import Annulus, Disc, LoadedRim
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.types import Array
from asperity.validation.check import Check, compared

_LIKE = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)


def half_space() -> Iterator[Check]:
    """The response of the half-space far from a load."""

    def displacements(load: Array) -> tuple[Array, Array]:
        free = FreeHalfSpace(_LIKE, shape=(41, 41), pixel_size=(1.0, 1.0))
        return free.normal_displacement(load[0])[40, 30], free.shear_displacement(load)[:, 40, 30]

    load = np.zeros((2, 41, 41))
    load[0, 0, 0] = 1.0
    x, y = 40.0, 30.0
    r = np.hypot(x, y)
    poisson, shear = _LIKE.poisson_ratio, _LIKE.antiplane_modulus
    pressed, sheared = at_once(displacements, load)
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


def rolling() -> Iterator[Check]:
    """A line contact that rolls steadily: half-width 1, gross slip begins at creepage 1."""
    cells = 200
    pixel = 2.0 / cells
    strip = FreeHalfSpace(_LIKE, shape=(cells,), pixel_size=(pixel,), reference_distance=10.0)
    edge = np.linspace(-1.0, 1.0, cells + 1)
    pressure = np.diff(0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))) / pixel
    load = float(pressure.sum() * pixel)
    shares = np.array([0.1, 0.25, 0.5, 0.8, 0.95])
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


_MODULUS, _POISSON, _LENGTH = 206e9, 0.3, 5e-3
_compared = functools.partial(compared, model="Elastic discs and rings")


def _matrix(
    body: Disc | Annulus, angles: Sequence[float], half_width: float, *, copies: int, modes: int
) -> np.ndarray:
    widths = xp.full(len(angles), half_width)
    return np.asarray(
        compliance_matrix(
            body=body,
            contact_angles=xp.asarray(angles, dtype=float),
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


#: Loads in each third of a ring are two, one on either side of a planet: one program serves every wall and support.
_COPIES, _MODES = 3, 2000


def _ring(
    inner: float,
    wall: float,
    angle: float,
    width: float,
    *,
    modulus: float,
    support: float,
    loaded: LoadedRim,
) -> np.ndarray:
    ring = Annulus(inner, inner + wall, _LENGTH, modulus, _POISSON, support, support, loaded, "plane_strain")
    return _matrix(ring, [-angle, angle], width, copies=_COPIES, modes=_MODES)


def rings() -> Iterator[Check]:
    """The paper's ring with three walls, and a thin ring and a thin hollow roller under equal radial loads."""
    polar, walls = math.radians(13.9248), (4e-3, 10e-3, 60e-3)
    for support, name, expected in (
        (0.0, "free", (2.21917e-7, 2.43847e-8, 4.93983e-9)),
        (math.inf, "held", (2.21183e-9, 2.71239e-9, 3.81608e-9)),
    ):
        found = [
            _ring(40e-3, wall, polar, 91.2e-6, modulus=_MODULUS, support=support, loaded="inner")[0, :2].sum()
            for wall in walls
        ]
        yield _compared(
            reference="independent sum of all modes: ring of 40 mm under six loads, walls of 4, 10 and 60 mm",
            quantity=f"radial displacement per force, outer rim {name}",
            unit="µm/kN",
            expected=1e9 * np.array(expected),
            computed=1e9 * np.array(found),
            tolerance=2e-5,
        )
    wall, plate = (
        2e-3,
        _MODULUS * (1.0 - _POISSON**2),
    )  # whose modulus in plane strain is that of the thin ring
    rims: tuple[tuple[LoadedRim, str], ...] = (("inner", "ring, inside"), ("outer", "hollow roller, outside"))
    for rim, name in rims:
        at = 1.0 - 0.5 * wall, wall, math.pi / 6.0, wall / 50.0
        c = _ring(*at, modulus=plate, support=0.0, loaded=rim)
        yield _compared(
            reference="bending of a thin ring under 3 and 6 equal loads, closed form (Timoshenko)",
            quantity=f"displacement of a load on a {name}, times EI/(P R³)",
            unit="-",
            expected=[0.01593859, 0.00168182],
            computed=np.array([c[0, 0], c[0, 0] + c[0, 1]]) * _MODULUS * _LENGTH * wall**3 / 12.0,
            tolerance=2e-3,
        )

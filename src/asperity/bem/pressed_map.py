"""Measured maps pressed by boundary elements: patches of a map, mirrored, under rising nominal pressures."""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
from collections.abc import Callable
from dataclasses import replace

import jax.numpy as jnp
import numpy as np
from jax import Array
from numpy.typing import NDArray

from asperity.bem.elastic_pair import ElasticPair, elastic_pair
from asperity.bem.half_space import HalfSpace, PeriodicHalfSpace
from asperity.bem.normal_contact import NormalContact, normal_contact
from asperity.bem.stick_stiffness import normal_stiffness, tangential_stiffness
from asperity.errors import InputError
from asperity.kept_numbers import keep_numbers, kept_numbers
from asperity.surface.levelling import levelled
from asperity.surface.measure_files import MeasuredFiles
from asperity.surface.pressed_map import PressedMap, plain_numbers, pressed_map_from_document
from asperity.surface.topography import Topography

#: Nominal pressures on steel [Pa]; those on other bodies are as many times their contact modulus.
PRESSURES_ON_STEEL = (10e6, 30e6, 100e6, 300e6, 600e6, 1000e6, 1700e6, 3000e6)
#: Number of patches, and fewest and most points of one along each side.
PATCHES = 4
FEWEST_POINTS, MOST_POINTS = 32, 512
STATES = 2 * PATCHES * len(PRESSURES_ON_STEEL)
#: Largest share of the hardness that a nominal pressure may be, to be carried by the capped pressure of spots.
_LARGEST_SHARE = 0.9
#: A limit of the pressure over the contact modulus that no elastic contact reaches: one program for both.
_ELASTIC = 1e3


def steel_pair() -> ElasticPair:
    """Two bodies of steel, E = 206 GPa and nu = 0.3."""
    return elastic_pair(
        youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )


def loaded_state(
    half_space: HalfSpace,
    heights: NDArray[np.float64],
    *,
    normal_force: float,
    hardness: float | None,
    axes: tuple[int, ...],
    start: NormalContact | None = None,
) -> tuple[NormalContact, Array]:
    """A rough surface under load, and its area [m^2] and normal and tangential stiffness [N/m], shape (3,).

    As :func:`asperity.bem.normal_contact.normal_contact` on a periodic half-space; the tangential stiffness is the mean
    over some axes, and both are infinite in complete contact.
    """
    contact = normal_contact(half_space, heights, normal_force=normal_force, hardness=hardness, start=start)
    mask = contact.pressure > 0.0
    stiffness = [jnp.asarray(jnp.inf)] * 2
    if contact.contact_fraction < 1.0:
        shear = jnp.stack([tangential_stiffness(half_space, mask, axis=axis).stiffness for axis in axes])
        stiffness = [normal_stiffness(half_space, mask).stiffness, jnp.mean(shear)]
    return contact, jnp.stack([contact.real_contact_area, *stiffness])


def map_patches(
    topography: Topography, *, points: int
) -> tuple[list[NDArray[np.float64]], tuple[float, float]]:
    """Four patches of a map, about square and half as wide as it, and the size of their cells (rows, columns) [m].

    Heights in means over cells, of which a patch has at most ``points`` along each side, less a plane [m]. Of a
    long map the patches are spread over it. An ``InputError`` is raised for a profile, missing points, fewer than
    64 points along a side, and a patch without roughness.
    """
    if topography.spacing_across is None:
        raise InputError(
            f"{topography.source}: a profile; boundary elements need a map of the surface, such as that of a "
            "white-light interferometer. For profiles there is the exponential law of their spectrum"
        )
    if not FEWEST_POINTS <= points <= MOST_POINTS:
        raise InputError(
            f"{2 * points} points along a side; allowed are {2 * FEWEST_POINTS} to {2 * MOST_POINTS}"
        )
    z, (width, height) = topography.heights, topography.size
    if np.isnan(z).any():
        raise InputError(
            f"{topography.source}: points are missing; keep a complete piece or interpolate",
            options=["missing"],
        )
    parts = [2 * max(1, round(side / min(width, height))) for side in (height, width)]
    tall, wide = (count // part for count, part in zip(z.shape, parts, strict=True))
    rows, columns = (math.ceil(count / points) for count in (tall, wide))
    if min(tall // rows, wide // columns) < FEWEST_POINTS:
        raise InputError(
            f"{topography.source}: {' x '.join(str(count) for count in z.shape)} points; boundary elements on patches "
            f"of half its width need {2 * FEWEST_POINTS} or more along each side"
        )
    cell = (topography.spacing_across * rows, topography.spacing * columns)
    patches = []
    for k in np.linspace(0, parts[0] * parts[1] - 1, PATCHES).round().astype(int):
        top, left = tall * (k // parts[1]), wide * (k % parts[1])
        patch = z[top : top + tall // rows * rows, left : left + wide // columns * columns]
        mean = patch.reshape(tall // rows, rows, wide // columns, columns).mean(axis=(1, 3))
        flat = levelled(topography=Topography(mean, cell[1], cell[0], source=topography.source), form="plane")
        if not flat.heights.std() > 0.0:
            raise InputError(f"{topography.source}: a patch of the map is a plane, without roughness")
        patches.append(flat.heights)
    return patches, cell


def mirrored(heights: NDArray[np.float64]) -> NDArray[np.float64]:
    """A map with its images beyond two of its edges, which continues periodically without a step."""
    both = np.concatenate([heights, heights[:, ::-1]], axis=1)
    return np.concatenate([both, both[::-1]], axis=0)


def pressed_map(
    topography: Topography,
    *,
    rolling: str,
    hardness: float,
    points: int = 128,
    solved: Callable[[], None] = lambda: None,
) -> PressedMap:
    """Patches of a map of the roughness of both bodies on an elastic half-space, by boundary elements.

    The map is levelled and has no missing points; ``rolling``, "x" or "y", is the direction in which the contact rolls;
    ``hardness`` the largest pressure of the capped states over the contact modulus [-]; ``points`` the most points of a
    patch along each side, more are averaged. ``solved`` is called after each of :data:`STATES` states. A map that was
    pressed before comes from the folder of kept programs. Patches are mirrored, which makes them periodic. Their
    longest waves are those of the patch.

    An ``InputError`` for what is no such map, a hardness outside 1e-3 to 1, or a map that is pressed flat at the
    smallest load; a ``NoSolutionError`` if a state does not converge.
    """
    if not 1e-3 <= hardness <= 1.0:
        raise InputError(
            f"a hardness of {hardness:g} contact moduli; allowed are 0.001 to 1 (0.11 to 113 GPa on steel)"
        )
    patches, cell = map_patches(topography, points=points)
    asked = json.dumps([list(cell), rolling, hardness, [patch.shape for patch in patches]]).encode()
    asked = hashlib.sha256(asked + b"".join(patch.tobytes() for patch in patches)).digest()
    rms = np.array([heights.std() for heights in patches])
    kept = kept_numbers(asked)
    if kept is not None:
        with contextlib.suppress(InputError):  # written by somebody else
            found = pressed_map_from_document(kept)
            if plain_numbers([hardness, *rms]) == plain_numbers([found.hardness, *found.rms_height]):
                return found
    pair = steel_pair()
    modulus = float(pair.contact_modulus)
    half_space = PeriodicHalfSpace(
        pair, shape=tuple(2 * count for count in patches[0].shape), pixel_size=cell
    )
    nominal = float(half_space.nominal_area)
    states = np.full((2, len(patches), len(PRESSURES_ON_STEEL), 3), np.nan)
    for k, limit in enumerate((_ELASTIC * modulus, hardness * modulus)):
        for row, heights in zip(states[k], patches, strict=True):
            for n, pressure in enumerate(PRESSURES_ON_STEEL):
                if pressure < _LARGEST_SHARE * limit:
                    _, state = loaded_state(
                        half_space,
                        mirrored(heights),
                        normal_force=pressure * nominal,
                        hardness=limit,
                        axes=(1 if rolling == "x" else 0,),
                    )
                    row[n] = state
                solved()
    area, normal, tangential = np.moveaxis(np.where(np.isinf(states), np.nan, states), -1, 0)
    pressures = np.array(PRESSURES_ON_STEEL)
    ratio = pressures * nominal / normal / rms[:, None]
    if not np.isfinite(ratio).all(axis=1).any(axis=-1).all():
        raise InputError(
            f"{topography.source}: pressed flat by {1e-6 * PRESSURES_ON_STEEL[0]:g} MPa on steel; so smooth "
            "a surface has no interface whose stiffness counts: use the exponential law"
        )
    made = PressedMap(
        pressure=pressures / modulus,
        hardness=hardness,
        rms_height=rms,
        decay_ratios=ratio,
        contact_fractions=area / nominal,
        tangential_ratios=tangential[0] / normal[0],
        size=np.array([patches[0].shape[1] * cell[1], patches[0].shape[0] * cell[0]]),
    )
    keep_numbers(asked, made.document())
    return pressed_map_from_document(made.document())


def with_pressed_map(measured: MeasuredFiles, *, hardness: float) -> MeasuredFiles:
    """Measured files with their map pressed by boundary elements, with a hardness of the softer body on steel [Pa].

    Errors are those of :func:`pressed_map`.
    """
    pressed = pressed_map(
        measured.topographies[0],
        rolling=measured.direction,
        hardness=hardness / float(steel_pair().contact_modulus),
    )
    assert measured.spectrum is not None
    return replace(measured, spectrum=replace(measured.spectrum, pressed=pressed))

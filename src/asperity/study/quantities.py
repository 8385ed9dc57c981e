"""What a design can be judged by: named quantities of a joint, with their derivatives by any number of its file."""

from __future__ import annotations

import functools
import itertools
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.drive.geometry import CONTACT_NAMES, clearances
from asperity.joint.evaluation import evaluate
from asperity.joint.size import joint_size
from asperity.joint.windup import StiffnessLevel
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.structure import numbers, table_structure, with_numbers
from asperity.joint_file.values import Values, replace_values
from asperity.unit_table import Dimension

#: Which rows a quantity has: one number, one for each contact, or one for each clearance of the rollers.
Rows = Literal["one", "contacts", "clearances"]

CLEARANCE_NAMES = (
    "loading roller in ring",
    "loading roller reaches from planet to ring",
    "planet to ring",
    "planet to planet",
    "loading rollers of one planet",
    "loading rollers of neighbours",
    "loading roller to next planet",
    "loading rollers outside the planet's centre circle",
)


@dataclass(frozen=True)
class QuantityKind:
    """One quantity that objectives and constraints can name.

    Parameters
    ----------
    label : str
        What it is, for tables and axes.
    dimension : Dimension or None
        What it measures; None for a quotient that has no dimension of its own in files.
    unit : str
        Unit for display.
    rows : {"one", "contacts", "clearances"}
        How many numbers it has.
    ratio : bool
        Whether it is positive and compared by its ratio to the limit; by its difference otherwise.
    """

    label: str
    dimension: Dimension | None
    unit: str
    rows: Rows = "one"
    ratio: bool = True

    @property
    def row_names(self) -> tuple[str, ...]:
        """Names of its rows; empty text for a single number."""
        return {"one": ("",), "contacts": CONTACT_NAMES, "clearances": CLEARANCE_NAMES}[self.rows]


_PLAIN = Dimension.DIMENSIONLESS

#: Every quantity by its name in a design file.
QUANTITIES: dict[str, QuantityKind] = {
    "stiffness": QuantityKind("torsional stiffness at the output", Dimension.TORSIONAL_STIFFNESS, "N*m/rad"),
    "stiffness_per_mass": QuantityKind("output stiffness per mass", None, "N*m/rad/kg"),
    "stiffness_per_volume": QuantityKind("output stiffness per envelope volume", None, "N*m/rad/m^3"),
    "preload": QuantityKind("preload", Dimension.FORCE, "N"),
    "mass": QuantityKind("mass of the rolling parts", Dimension.MASS, "kg"),
    "envelope_diameter": QuantityKind("outer diameter of the ring", Dimension.LENGTH, "mm"),
    "envelope_length": QuantityKind("length of the rolling parts", Dimension.LENGTH, "mm"),
    "envelope_volume": QuantityKind("volume of the envelope", Dimension.VOLUME, "cm^3"),
    "slip_ratio": QuantityKind("slip ratio T/(mu N)", _PLAIN, "1", "contacts"),
    "self_locking_ratio": QuantityKind("self-locking ratio tan(beta/2)/mu", _PLAIN, "1"),
    "pressure_over_first_yield": QuantityKind("Hertz pressure over first yield", _PLAIN, "1", "contacts"),
    "real_area_over_hertz_area": QuantityKind("real area over Hertz area", _PLAIN, "1", "contacts"),
    "critical_over_largest_spot": QuantityKind("critical over largest spot", _PLAIN, "1", "contacts"),
    "normal_over_rest": QuantityKind(
        "normal force over its value at rest", _PLAIN, "1", "contacts", ratio=False
    ),
    "clearance": QuantityKind("clearance", Dimension.LENGTH, "mm", "clearances", ratio=False),
}


LEVELS: tuple[StiffnessLevel, ...] = ("published", "series_with_bulk", "assembly")

#: Points of one call of the compiled program. One program serves every study of joints of one kind, so that it is
#: compiled once and found in the cache ever after; more points are more calls.
_BLOCK = 64

#: Up to so many points, calling that program is quicker than compiling one without derivatives.
_FEW = 4096


def joint_quantities(values: Values) -> dict[str, Array]:
    """All quantities of the joints that tables of SI numbers describe.

    Parameters
    ----------
    values : dict
        Tables of SI numbers; arrays share one batch axis.

    Returns
    -------
    dict
        Name of :data:`QUANTITIES` → array of shape (rows, batch) [SI], stiffnesses as ``stiffness.<level>``; and
        ``solved``, shape (1, batch).
    """
    joint = joint_from_values(values)
    result = evaluate(joint)
    size = joint_size(joint)
    limits = result.diagnostics
    levels = dict(
        zip(LEVELS, (result.published, result.series_with_bulk, result.assembly.stiffness), strict=True)
    )
    found: dict[str, Any] = {
        **{f"stiffness.{level}": [stiffness.output] for level, stiffness in levels.items()},
        "preload": [joint.preload],
        "mass": [size.mass],
        "envelope_diameter": [size.envelope_diameter],
        "envelope_length": [size.envelope_length],
        "envelope_volume": [size.envelope_volume],
        "slip_ratio": limits.gross_slip,
        "self_locking_ratio": [limits.self_locking],
        "pressure_over_first_yield": limits.pressure_over_first_yield,
        "real_area_over_hertz_area": limits.real_area_over_hertz_area,
        "critical_over_largest_spot": limits.critical_over_largest_spot,
        "normal_over_rest": limits.normal_over_rest,
        "clearance": [gap.gap for gap in clearances(joint.geometry)],
        "solved": [jnp.where(result.solved, 1.0, 0.0)],
    }
    shape = result.solved.shape
    return {
        name: jnp.stack([jnp.broadcast_to(jnp.asarray(row), shape) for row in rows])
        for name, rows in found.items()
    }


def _values_and_slopes(
    structure: str, table: Array, tangents: Array
) -> tuple[dict[str, Array], dict[str, Array]]:
    """Quantities and their derivatives along a direction, for the rows of numbers of files of one structure."""
    tables = json.loads(structure)
    return jax.jvp(lambda rows: joint_quantities(with_numbers(tables, rows)), (table,), (tangents,))


@functools.partial(jax.jit, static_argnums=0)
def _values_only(structure: str, table: Array) -> dict[str, Array]:
    return joint_quantities(with_numbers(json.loads(structure), table))


def _in_blocks(structure: str, *tables: np.ndarray) -> Any:
    """Call the compiled program block by block; the last block is filled up with copies of its last point."""
    points = tables[0].shape[1]
    parts = []
    for start in range(0, points, _BLOCK):
        block = [table[:, start : start + _BLOCK] for table in tables]
        missing = _BLOCK - block[0].shape[1]
        padded = [np.pad(part, ((0, 0), (0, missing)), mode="edge") for part in block]
        program = compile_fast(_values_and_slopes, *padded, options=(structure,))
        parts.append(jax.tree.map(np.asarray, program(*padded)))
    return jax.tree.map(lambda *pieces: np.concatenate(pieces, axis=-1)[..., :points], *parts)


def quantities_at(values: Values, changes: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """All quantities of the joints that a file with changed numbers describes.

    Parameters
    ----------
    values : dict
        Tables of SI numbers.
    changes : mapping
        Dotted path → numbers [SI], shape (points,).

    Returns
    -------
    dict
        Name → array of shape (rows, points) [SI], as :func:`joint_quantities`, with ratios of stiffness.
    """
    points = max((np.size(value) for value in changes.values()), default=1)
    structure, table = _tabulated(replace_values(values, changes), points)
    if points <= _FEW:
        return _with_quotients(_in_blocks(structure, table, np.zeros_like(table))[0])
    return _with_quotients({n: np.asarray(v) for n, v in _values_only(structure, jnp.asarray(table)).items()})


def _tabulated(values: Values, points: int) -> tuple[str, np.ndarray]:
    """Structure of the tables, and all their numbers at every point, shape (numbers, points)."""
    rows = [np.broadcast_to(np.asarray(number, float), (points,)) for number in numbers(values)]
    return table_structure(values), np.stack(rows)


def quantities_and_slopes(
    values: Values, changes: Mapping[str, Any], variables: tuple[str, ...]
) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """All quantities and their exact derivatives by some of the numbers.

    Parameters
    ----------
    values : dict
        Tables of SI numbers.
    changes : mapping
        Dotted path → numbers [SI], shape (points,); must contain the variables.
    variables : tuple of str
        Dotted paths by which to differentiate.

    Returns
    -------
    values, slopes : dict
        Name → array of shape (rows, points) [SI], and (rows, points, variables) [SI].

    Notes
    -----
    Forward-mode automatic differentiation; the points are repeated once for each variable along the batch axis.
    """
    points = max(np.size(value) for value in changes.values())
    filled = replace_values(values, changes)
    structure, table = _tabulated(filled, points)
    nothing = with_numbers(filled, itertools.repeat(0.0))
    count = max(len(variables), 1)
    directions = np.zeros((len(table), count))
    for index, path in enumerate(variables):
        directions[:, index] = numbers(replace_values(nothing, {path: 1.0}))
    primal = np.tile(table, (1, count))
    tangent = np.repeat(directions, points, axis=1)
    found, slopes = _in_blocks(structure, primal, tangent)
    first = {name: value[:, :points] for name, value in found.items()}
    by_variable = {
        name: np.moveaxis(value.reshape(value.shape[0], count, points), 1, 2)[:, :, : len(variables)]
        for name, value in slopes.items()
    }
    return _with_quotients(first), _with_quotient_slopes(first, by_variable)


def _with_quotients(found: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    extra = {}
    for level in LEVELS:
        stiffness = found[f"stiffness.{level}"]
        extra[f"stiffness_per_mass.{level}"] = stiffness / found["mass"]
        extra[f"stiffness_per_volume.{level}"] = stiffness / found["envelope_volume"]
    return {**found, **extra}


def _with_quotient_slopes(
    found: dict[str, np.ndarray], slopes: dict[str, np.ndarray]
) -> dict[str, np.ndarray]:
    extra = {}
    for level in LEVELS:
        top, slope = found[f"stiffness.{level}"], slopes[f"stiffness.{level}"]
        for name, below in (("mass", "mass"), ("volume", "envelope_volume")):
            bottom = found[below]
            extra[f"stiffness_per_{name}.{level}"] = (
                slope - (top / bottom)[..., None] * slopes[below]
            ) / bottom[..., None]
    return {**slopes, **extra}


def at_level(name: str, level: StiffnessLevel) -> str:
    """Key of a quantity in the dictionaries of this module.

    Parameters
    ----------
    name : str
        Name in :data:`QUANTITIES`.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness is meant.

    Returns
    -------
    str
        The name, with the level behind the stiffnesses.
    """
    return f"{name}.{level}" if name.startswith("stiffness") else name

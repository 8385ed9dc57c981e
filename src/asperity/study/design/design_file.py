"""Design files: which numbers of a joint are free, what is wanted of it, and within which limits."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, get_args

from asperity.errors import InputError
from asperity.joint.windup import StiffnessLevel
from asperity.joint_file.messages import nearest
from asperity.joint_file.model import Case
from asperity.joint_file.reader import read_case
from asperity.joint_file.values import key_at, numeric_keys
from asperity.library import read_finishes
from asperity.study.design.design_problem import Constraint, DesignProblem, Objective, Variable, WorstCase
from asperity.study.quantities import QUANTITIES
from asperity.unit_table import Dimension
from asperity.units import parse_quantity

#: Numbers of a joint file that span decades; designs search and report them by their logarithm.
_LOGARITHMIC = ("fractal_roughness", "preload", "stiffness")


_SECTIONS = ("joint", "level", "variables", "objective", "constraints", "worst_case", "search")


def read_design(path: str | Path) -> DesignProblem:
    """Read a design file.

    Parameters
    ----------
    path : str or Path
        A TOML file with ``joint``, ``[variables]``, ``[objective]`` and, if wanted, ``level``, ``[constraints]``,
        ``[worst_case]`` and ``[search]``.

    Returns
    -------
    DesignProblem
        What it says, checked.

    Raises
    ------
    InputError
        If it cannot be read or says something that is not allowed.
    """
    file = Path(path)
    try:
        tables = tomllib.loads(file.read_text(encoding="utf-8-sig"))
    except FileNotFoundError:
        raise InputError(f"{path}: there is no such file") from None
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path}: not valid TOML: {error}") from None
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    try:
        return design_from_tables(tables, folder=file.parent)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def design_from_tables(tables: Mapping[str, Any], *, folder: Path) -> DesignProblem:
    """Check the tables of a design file.

    Parameters
    ----------
    tables : mapping
        The design file as :func:`tomllib.loads` returns it.
    folder : Path
        Where the path of the joint file starts.

    Returns
    -------
    DesignProblem
        What they say, checked.

    Raises
    ------
    InputError
        If they say something that is not allowed.
    """
    _only(tables, _SECTIONS, "")
    for name in ("joint", "variables", "objective"):
        if name not in tables:
            raise InputError(f"{name}: this key is missing")
    if not isinstance(tables["joint"], str):
        raise InputError(f"joint: expected the path of a joint file as text, got {tables['joint']!r}")
    case = read_case(folder / tables["joint"])
    levels = get_args(StiffnessLevel)
    level = tables.get("level", "assembly")
    if level not in levels:
        raise InputError(f"level: {level!r} is not one of {', '.join(levels)}")
    search = _table(tables.get("search", {}), "search")
    _only(search, ("starts", "seed"), "search")
    problem = DesignProblem(
        case=case,
        joint_file=str(folder / tables["joint"]),
        level=level,
        variables=tuple(_variables(_table(tables["variables"], "variables"), case)),
        objectives=_objectives(_table(tables["objective"], "objective")),
        constraints=tuple(_constraints(_table(tables.get("constraints", {}), "constraints"))),
        worst_case=_worst_case(_table(tables.get("worst_case", {}), "worst_case")),
        starts=_count(search.get("starts", 8), "search.starts", 1, 1000),
        seed=_count(search.get("seed", 1), "search.seed", 0, 2**31),
    )
    if problem.worst_case.tolerances != "none" and not any(k.tolerance for k in numeric_keys(case).values()):
        raise InputError(
            "worst_case.tolerances: the joint file states no tolerance; write one, e.g. '13.5 mm +- 5 um'"
        )
    return problem


def _table(value: Any, name: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise InputError(f"{name}: expected a table, got {value!r}")
    return value


def _only(table: Mapping[str, Any], known: tuple[str, ...], place: str) -> None:
    for name in table:
        if name not in known:
            where = f"{place}.{name}" if place else name
            raise InputError(
                f"{where}: unknown key{nearest(name, known) or '; known are ' + ', '.join(known)}"
            )


def _count(value: Any, name: str, lowest: int, highest: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not lowest <= value <= highest:
        raise InputError(f"{name}: expected a whole number from {lowest} to {highest}, got {value!r}")
    return value


def _flat(table: Mapping[str, Any], path: str) -> Iterator[tuple[str, dict[str, Any]]]:
    """Leaf tables of bounds, whether their dotted path is quoted or not."""
    for name, value in table.items():
        below = f"{path}.{name}" if path else name
        entry = _table(value, f"variables.{below}")
        if any(isinstance(each, dict) for each in entry.values()):
            yield from _flat(entry, below)
        else:
            yield below, entry


def _variables(table: dict[str, Any], case: Case) -> Iterator[Variable]:
    found = dict(_flat(table, ""))
    if not found:
        raise InputError("variables: at least one free variable is needed, e.g. load.preload")
    if len(found) > 30:
        raise InputError(f"variables: at most 30 free variables, got {len(found)}")
    finishes = read_finishes() if any("finish" in entry for entry in found.values()) else {}
    for path, entry in found.items():
        where = f"variables.{path}"
        key = key_at(path)
        _only(entry, ("lower", "upper", "scale", "finish"), where)
        if key.whole:
            raise InputError(
                f"{where}: whole numbers cannot be free variables; try each in a design of its own"
            )
        if "finish" in entry:
            name = entry["finish"]
            if name not in finishes:
                raise InputError(f"{where}: there is no finish {name!r}{nearest(str(name), finishes)}")
            ranges = finishes[name].ranges
            kind = path.rsplit(".", 1)[-1]
            if kind not in ranges:
                raise InputError(
                    f"{where}: the finish {name!r} has no range for it; it has {', '.join(ranges)}"
                )
            lower, upper = ranges[kind]
            if lower == upper:
                raise InputError(
                    f"{where}: the finish {name!r} has one value for it, {lower:g}; write that into the joint file"
                )
        else:
            for side in ("lower", "upper"):
                if side not in entry:
                    raise InputError(f"{where}.{side}: this bound is missing, e.g. '{key.dimension.example}'")
            try:
                lower, upper = (key.read(entry[side]).value for side in ("lower", "upper"))
            except InputError as error:
                raise InputError(f"{where}: {error}") from None
        scale = entry.get("scale", "log" if path.rsplit(".", 1)[-1].endswith(_LOGARITHMIC) else "linear")
        if scale not in ("log", "linear"):
            raise InputError(f"{where}.scale: {scale!r} is not one of log, linear")
        if not lower < upper:
            raise InputError(
                f"{where}: the lower bound {entry.get('lower')} must be below the upper {entry.get('upper')}"
            )
        if scale == "log" and lower <= 0.0:
            raise InputError(
                f"{where}: a logarithmic scale needs a positive lower bound, got {entry['lower']}"
            )
        yield Variable(path, lower, upper, scale == "log")


def _objectives(table: dict[str, Any]) -> tuple[Objective, ...]:
    _only(table, ("maximise", "minimise"), "objective")
    found = []
    for word, sign in (("maximise", -1.0), ("minimise", 1.0)):
        names = table.get(word, [])
        for name in [names] if isinstance(names, str) else names:
            _known_quantity(name, f"objective.{word}")
            if QUANTITIES[name].rows == "contacts" and sign < 0.0 and name != "normal_over_rest":
                raise InputError(
                    f"objective.maximise: {name} can only be minimised (its largest contact counts)"
                )
            found.append(Objective(name, sign))
    if not 1 <= len(found) <= 3:
        raise InputError(f"objective: one objective, or two or three for a Pareto front, got {len(found)}")
    if len({each.name for each in found}) < len(found):
        raise InputError("objective: the same quantity is named twice")
    return tuple(found)


def _known_quantity(name: Any, where: str) -> None:
    if name not in QUANTITIES:
        hint = nearest(str(name), QUANTITIES) or "; known are " + ", ".join(QUANTITIES)
        raise InputError(f"{where}: there is no quantity {name!r}{hint}")


def _constraints(table: dict[str, Any]) -> Iterator[Constraint]:
    for name, value in table.items():
        where = f"constraints.{name}"
        _known_quantity(name, where)
        kind, entry = QUANTITIES[name], _table(value, where)
        _only(entry, ("at_most", "at_least", "contacts"), where)
        if "at_most" not in entry and "at_least" not in entry:
            raise InputError(f"{where}: say 'at_most' or 'at_least'")
        if kind.dimension is None:
            raise InputError(f"{where}: this quotient can be an objective but no constraint")
        rows = tuple(range(len(kind.row_names)))
        if "contacts" in entry:
            listed = entry["contacts"]
            if kind.rows != "contacts" or not isinstance(listed, list):
                raise InputError(f"{where}.contacts: expected a list of contacts of a quantity that has them")
            for each in listed:
                if each not in kind.row_names:
                    raise InputError(f"{where}.contacts: {each!r} is not one of {', '.join(kind.row_names)}")
            rows = tuple(kind.row_names.index(each) for each in listed)
        for side in ("at_most", "at_least"):
            if side in entry:
                try:
                    limit = parse_quantity(entry[side], kind.dimension)
                except InputError as error:
                    raise InputError(f"{where}.{side}: {error}") from None
                if kind.ratio and limit <= 0.0:
                    raise InputError(f"{where}.{side}: {entry[side]} is not allowed; it must be above 0")
                if name == "slip_ratio" and (side == "at_least" or limit > 1.0):
                    raise InputError(
                        f"{where}: allowed is at_most, up to 1 (gross slip); got {side} {entry[side]}"
                    )
                if name in ("clearance", "normal_over_rest") and side == "at_least" and limit < 0.0:
                    raise InputError(
                        f"{where}.{side}: {entry[side]} is not allowed; it must be at least 0, since rollers that "
                        "overlap or lift off make no joint"
                    )
                yield Constraint(name, side == "at_most", limit, rows)
    stated = {(name, side) for name, value in table.items() for side in value}
    every_contact, every_gap = tuple(range(5)), tuple(range(8))
    if ("slip_ratio", "at_most") not in stated or "contacts" in table.get("slip_ratio", {}):
        yield Constraint("slip_ratio", True, 1.0, every_contact, implied=True)
    if ("clearance", "at_least") not in stated:
        yield Constraint("clearance", False, 0.0, every_gap, implied=True)
    if ("normal_over_rest", "at_least") not in stated or "contacts" in table.get("normal_over_rest", {}):
        yield Constraint("normal_over_rest", False, 0.0, every_contact, implied=True)


def _worst_case(table: dict[str, Any]) -> WorstCase:
    _only(table, ("torque", "tolerances", "samples", "seed"), "worst_case")
    torques: tuple[float, ...] = ()
    if "torque" in table:
        entry = _table(table["torque"], "worst_case.torque")
        _only(entry, ("lower", "upper", "points"), "worst_case.torque")
        bounds = []
        for side in ("lower", "upper"):
            try:
                bounds.append(parse_quantity(entry.get(side, ""), Dimension.TORQUE))
            except InputError as error:
                raise InputError(f"worst_case.torque.{side}: {error}") from None
        if not 0.0 <= bounds[0] < bounds[1]:
            raise InputError(
                f"worst_case.torque: needs 0 <= lower < upper, got {entry['lower']} and {entry['upper']}"
            )
        points = _count(entry.get("points"), "worst_case.torque.points", 2, 50)
        torques = tuple(bounds[0] + (bounds[1] - bounds[0]) * k / (points - 1) for k in range(points))
    tolerances = table.get("tolerances", "none")
    if tolerances not in ("none", "corners", "samples"):
        raise InputError(f"worst_case.tolerances: {tolerances!r} is not one of none, corners, samples")
    if tolerances == "samples" and "samples" not in table:
        raise InputError("worst_case.samples: the number of samples is missing")
    return WorstCase(
        torques=torques,
        tolerances=tolerances,
        samples=_count(table.get("samples", 1), "worst_case.samples", 1, 1000),
        seed=_count(table.get("seed", 0), "worst_case.seed", 0, 2**31),
    )

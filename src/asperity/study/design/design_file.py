"""Design files: the free numbers of a joint, its objectives and its limits."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from asperity.drive.layout.drive import speed_ratio
from asperity.errors import InputError, listed, nearest, quoted
from asperity.joint_file.any_joint import results_of, rows_of_file
from asperity.joint_file.part_names import type_of
from asperity.joint_file.parts import layout_of
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import AnyCase, Values, key_at, numeric_keys, si_values
from asperity.library import read_finishes
from asperity.reading import read_toml
from asperity.results import LEVELS, RESULTS, Result, known_result, name_at_level
from asperity.standing.windup import StiffnessLevel
from asperity.study.design.design_problem import (
    Constraint,
    DesignProblem,
    Objective,
    Variable,
    WorstCase,
)
from asperity.study.design.implied_limits import implied_limits
from asperity.study.design.rounding import MOST_STEPPED
from asperity.study.parameters import refuse_twice
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import format_quantity, parse_quantity

#: Numbers of a joint file that span decades; designs search and report them by their logarithm.
_LOGARITHMIC = ("fractal_roughness", "preload", "stiffness")
#: Key that picks rows of a result, by what they stand for.
_PLURALS = {"contact": "contacts", "body": "bodies", "pin": "pins", "bearing": "bearings", "rim": "rims"}

#: Entries of one section; a file with more was not written by a person.
_MOST_ENTRIES = 1000
_SECTIONS = ("joint", "level", "variables", "objective", "constraints", "worst_case", "search")


def read_design(path: str | Path) -> DesignProblem:
    """The checked content of a design file; an ``InputError`` if it cannot be read or says what is not allowed.

    It is TOML with ``joint``, ``[variables]``, ``[objective]`` and, if wanted, ``level``, ``[constraints]``,
    ``[worst_case]`` and ``[search]``.
    """
    file = Path(path)
    tables = read_toml(file)
    try:
        return design_from_tables(tables, folder=file.parent)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


class _Errors:
    """Errors of a file, collected so that one message lists all of them."""

    def __init__(self) -> None:
        self.messages: list[str] = []

    @contextmanager
    def gathered(self) -> Iterator[None]:
        """Keep an :class:`InputError` of the block for later."""
        try:
            yield
        except InputError as error:
            self.messages.append(str(error))

    def refuse(self) -> None:
        """Raise if there were any."""
        if self.messages:
            raise InputError(listed(self.messages))


def design_from_tables(
    tables: Mapping[str, Any], *, folder: Path = Path(), case: AnyCase | None = None
) -> DesignProblem:
    """Check the tables of a design file, with its joint file in a ``folder``, or with the ``case`` in its place."""
    errors = _Errors()
    with errors.gathered():
        _only(tables, _SECTIONS, "")
    for name in ("joint", "variables", "objective"):
        if name not in tables:
            errors.messages.append(f"{name}: this key is missing")
    errors.refuse()
    # where the joint file cannot be read, what it decides is not checked
    kind, known, values = None, RESULTS, Values()
    with errors.gathered():
        if not isinstance(tables["joint"], str):
            raise InputError(f"joint: expected the path of a joint file as text, got {tables['joint']!r}")
        case = case or read_case(folder / tables["joint"])
        values = si_values(case)
        kind, known = type_of(values), results_of(values)
    level = tables.get("level", "assembly")
    if level not in LEVELS:
        errors.messages.append(f"level: {level!r} is not one of {', '.join(LEVELS)}")
        level = "assembly"
    variables: list[Variable] = []
    with errors.gathered():
        for path, entry in _flat(_table(tables["variables"], "variables"), ""):
            with errors.gathered():
                variables.append(_variable(path, entry, kind))
        _check_count(variables if not errors.messages else [None])
        if case is not None:
            refuse_twice(case, [variable.path for variable in variables], named="variables")
    objectives: tuple[Objective, ...] = ()
    with errors.gathered():
        objectives = _objectives(_table(tables["objective"], "objective"), level, values, known)
    constraints: list[Constraint] = []
    with errors.gathered():
        stated: dict[str, str] = {}
        for name, entry in _table(tables.get("constraints", {}), "constraints").items():
            with errors.gathered():
                found = tuple(constraint_of(name, entry, level, values, known))
                other = stated.setdefault(found[0].name, name)
                if other != name:
                    raise InputError(
                        f"constraints.{other} and constraints.{name} limit the same result; limit it once"
                    )
                constraints.extend(found)
    worst_case, starts, seed = WorstCase((), "none", 1, 0), 1, 0
    with errors.gathered():
        worst_case = _worst_case(_table(tables.get("worst_case", {}), "worst_case"))
    with errors.gathered():
        search = _table(tables.get("search", {}), "search")
        _only(search, ("starts", "seed"), "search")
        starts = _count(search.get("starts", 8), "search.starts", 1, 1000)
        seed = _count(search.get("seed", 1), "search.seed", 0, 2**31)
    errors.refuse()
    problem = DesignProblem(
        case=case,
        joint_file=str(folder / tables["joint"]),
        level=level,
        variables=tuple(variables),
        objectives=objectives,
        constraints=(*constraints, *implied_limits(constraints, case, values, known)),
        worst_case=worst_case,
        starts=starts,
        seed=seed,
    )
    if problem.worst_case.tolerances != "none" and not any(k.tolerance for k in numeric_keys(case).values()):
        raise InputError(
            "worst_case.tolerances: the joint file states no tolerance; write one, e.g. '13.5 mm +- 5 um'"
        )
    return problem


def _table(value: Any, name: str) -> Document:
    if not isinstance(value, dict):
        raise InputError(f"{name}: expected a table, got {quoted(value)}")
    if len(value) > _MOST_ENTRIES:
        raise InputError(f"{name}: at most {_MOST_ENTRIES} entries, got {len(value)}")
    return value


def _only(table: Mapping[str, Any], known: tuple[str, ...], place: str) -> None:
    for name in table:
        if name not in known:
            where = f"{place}.{name}" if place else name
            meant = "constraints" if where == "limits" else name
            hint = nearest(meant, known) or f"; known are {', '.join(known)}"
            raise InputError(f"{where}: unknown key{hint}")


def _count(value: Any, name: str, lowest: int, highest: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not lowest <= value <= highest:
        raise InputError(f"{name}: expected a whole number from {lowest} to {highest}, got {value!r}")
    return value


def _flat(table: Mapping[str, Any], path: str) -> Iterator[tuple[str, Document]]:
    """Leaf tables of bounds, whether their dotted path is quoted or not."""
    for name, value in table.items():
        below = f"{path}.{name}" if path else name
        entry = _table(value, f"variables.{below}")
        if any(isinstance(node, dict) for node in entry.values()):
            yield from _flat(entry, below)
        else:
            yield below, entry


def _check_count(variables: Sequence[object]) -> None:
    if not variables:
        raise InputError("variables: at least one free variable is needed, e.g. load.preload")
    if len(variables) > 30:
        raise InputError(f"variables: at most 30 free variables, got {len(variables)}")
    stepped = sum(isinstance(variable, Variable) and variable.step is not None for variable in variables)
    if stepped > MOST_STEPPED:
        raise InputError(f"variables: at most {MOST_STEPPED} variables may have a step, got {stepped}")


def _variable(path: str, entry: Document, kind: str | None) -> Variable:
    where = f"variables.{path}"
    try:
        key = key_at(path, kind)
    except InputError as error:
        raise InputError(f"{where}: {error}") from None
    _only(entry, ("lower", "upper", "scale", "finish", "step"), where)
    if key.integer:
        raise InputError(
            f"{where}: whole numbers cannot be free variables; run a separate design for each value"
        )
    if "finish" in entry:
        lower, upper = _finish_bounds(entry["finish"], path)
    else:
        for side in ("lower", "upper"):
            if side not in entry:
                raise InputError(f"{where}.{side}: this bound is missing, e.g. '{key.dimension.example}'")
        bounds = []
        for side in ("lower", "upper"):
            try:
                bounds.append(key.read(entry[side]).value)
            except InputError as error:
                raise InputError(f"{where}.{side}: {error}") from None
        lower, upper = bounds
    scale = entry.get("scale", "log" if path.rsplit(".", 1)[-1].endswith(_LOGARITHMIC) else "linear")
    if scale not in ("log", "linear"):
        raise InputError(f"{where}.scale: {scale!r} is not one of log, linear")
    if not lower < upper:
        raise InputError(
            f"{where}: the lower bound {entry.get('lower')} must be below the upper {entry.get('upper')}"
        )
    if scale == "log" and lower <= 0.0:
        raise InputError(f"{where}: a logarithmic scale needs a positive lower bound, got {entry['lower']}")
    step = None
    if "step" in entry:
        try:
            step = parse_quantity(entry["step"], key.dimension)
        except InputError as error:
            raise InputError(f"{where}.step: {error}") from None
        if not step > 0.0 or math.ceil(lower / step - 1e-9) > math.floor(upper / step + 1e-9):
            raise InputError(
                f"{where}.step: {entry['step']} is not allowed; a multiple of it must lie between the bounds"
            )
    return Variable(path, lower, upper, scale == "log", step)


def _finish_bounds(name: Any, path: str) -> tuple[float, float]:
    """Bounds of a surface parameter that a finish of the library has."""
    where, finishes = f"variables.{path}", read_finishes()
    if name not in finishes:
        raise InputError(f"{where}: there is no finish {name!r}{nearest(str(name), finishes)}")
    ranges, kind = finishes[name].ranges, path.rsplit(".", 1)[-1]
    if kind not in ranges:
        raise InputError(f"{where}: the finish {name!r} has no range for it; it has {', '.join(ranges)}")
    lower, upper = ranges[kind]
    if lower == upper:
        raise InputError(
            f"{where}: the finish {name!r} has one value for it, {lower:g}; write that into the joint file"
        )
    return lower, upper


def _objectives(
    table: Document, level: StiffnessLevel, values: Values, results: Mapping[str, Result]
) -> tuple[Objective, ...]:
    _only(table, ("maximise", "minimise"), "objective")
    goals = []
    for word, sign in (("maximise", -1.0), ("minimise", 1.0)):
        listed = table.get(word, [])
        for name in listed if isinstance(listed, list) else [listed]:
            full = _result(name, level, f"objective.{word}", results)
            limit = results[full].limit
            if limit is not None and math.isinf(limit.lowest if sign < 0.0 else limit.highest):
                other = "minimised (its largest value counts)" if sign < 0.0 else "maximised"
                raise InputError(f"objective.{word}: {name} can only be {other}")
            goals.append(Objective(full, sign, _rows(results[full], values, f"objective.{word}")))
    if not 1 <= len(goals) <= 3:
        raise InputError(f"objective: one objective, or two or three for a Pareto front, got {len(goals)}")
    if len({goal.name for goal in goals}) < len(goals):
        raise InputError("objective: the same result is named twice")
    return tuple(goals)


def _result(name: Any, level: StiffnessLevel, where: str, results: Mapping[str, Result]) -> str:
    """The full name of a result in a design file."""
    short = tuple(
        full.removeprefix(f"{level}_") for full in results if full.startswith(f"{level}_stiffness_per")
    )
    known = ("stiffness", *short, *(full for full, row in results.items() if row.differentiable))
    try:
        return name_at_level(known_result(name, among=known), level)
    except InputError as error:
        raise InputError(f"{where}: {error}") from None


def constraint_of(
    name: str,
    table: Any,
    level: StiffnessLevel,
    values: Values,
    results: Mapping[str, Result],
    *,
    said: str = "",
) -> Iterator[Constraint]:
    """The limits of one result: its name, and a table of ``at_most``, ``at_least`` and the rows that are meant.

    ``said`` is how messages call it; by default its key in a design file.
    """
    where = said or f"constraints.{name}"
    full = _result(name, level, where, results)
    result, entry = results[full], _table(table, where)
    plural = _PLURALS.get(result.axis, "contacts")
    _only(entry, ("at_most", "at_least", plural), where)
    if "at_most" not in entry and "at_least" not in entry:
        raise InputError(f"{where}: state 'at_most' or 'at_least'")
    rows = _rows(result, values, where)
    if plural in entry:
        listed = entry[plural]
        if result.axis not in _PLURALS or not isinstance(listed, list):
            raise InputError(f"{where}.{plural}: expected a list of {plural} of a result that has them")
        for row in listed if values else ():
            if row not in result.row_names:
                raise InputError(f"{where}.{plural}: {row!r} is not one of {', '.join(result.row_names)}")
            if result.row_names.index(row) not in rows:
                raise InputError(f"{where}.{plural}: {row!r} has none; {result.only}")
        rows = tuple(result.row_names.index(row) for row in listed) if values else ()
    for side in ("at_most", "at_least"):
        if side in entry:
            key = said or f"{where}.{side}"
            try:
                limit = parse_quantity(entry[side], result.dimension)
            except InputError as error:
                raise InputError(f"{key}: {error}") from None
            _check_limit(result, limit, f"{key}: {entry[side]}")
            if full == "speed_ratio" and values:
                _refuse_other_sense(values, limit, f"{key}: {entry[side]}")
            yield Constraint(full, side == "at_most", limit, rows)


def _rows(result: Result, values: Values, where: str) -> tuple[int, ...]:
    """Rows that the joint file has; none where that cannot be read."""
    rows = rows_of_file(values, result) if values else ()
    if values and not rows:
        raise InputError(f"{where}: {result.only}")
    return rows


def _check_limit(result: Result, limit: float, written: str) -> None:
    """Refuse a limit that no joint can meet, or that every joint meets."""
    if result.positive and limit <= 0.0:
        raise InputError(f"{written} is not allowed; it must be above 0")
    low, high = result.lowest_limit, result.highest_limit
    if not low <= limit <= high:
        words = [f"at least {format_quantity(low, result.display_unit)}"] * math.isfinite(low)
        words += [f"at most {format_quantity(high, result.display_unit)}"] * math.isfinite(high)
        note = f" ({result.note})" if result.note else ""
        raise InputError(f"{written} is not allowed; it must be {' and '.join(words)}{note}")


def _refuse_other_sense(values: Values, limit: float, written: str) -> None:
    """Refuse a limit of the speed ratio whose sign is not that of the drive."""
    ratio = float(speed_ratio(layout_of(values)[0]))
    if ratio * limit < 0.0:
        turn = "the same direction" if ratio > 0.0 else "opposite directions"
        raise InputError(
            f"{written} is not allowed; input and output of this drive turn in {turn}, its speed_ratio is {ratio:.4g}; "
            "limit absolute_speed_ratio, which has no sign"
        )


def _worst_case(table: Document) -> WorstCase:
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

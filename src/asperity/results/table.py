"""All rows of the table of results, by name and by group."""

from __future__ import annotations

import dataclasses
import difflib
import functools
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from asperity.drive.layout.wedge import wedges
from asperity.engine.arrays import xp
from asperity.errors import InputError
from asperity.joint.pin_bound import stiffness_bound
from asperity.results import (
    accuracy_rows,
    contact_rows,
    drive_rows,
    heat_rows,
    limit_rows,
    load_rows,
    rolling_rows,
    stiffness_rows,
    wear_rows,
)
from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.results.torque_capacity import place_labels
from asperity.types import Array

if TYPE_CHECKING:
    from asperity.standing.windup import StiffnessLevel

#: Every result of any drive by name.
RESULTS: dict[str, Result] = {
    row.name: row
    for row in (
        *stiffness_rows.ROWS,
        *contact_rows.ROWS,
        *limit_rows.ROWS,
        *rolling_rows.ROWS,
        *heat_rows.ROWS,
        *wear_rows.ROWS,
        *accuracy_rows.ROWS,
        *load_rows.ROWS,
        *drive_rows.ROWS,
    )
}

#: Levels of the stiffness, the fullest model first.
LEVELS: tuple[StiffnessLevel, ...] = ("assembly", "series_with_bulk", "published")

#: Groups each of which takes more time than all others together, and which are therefore asked for by their names.
_SLOW_GROUPS = ("stresses", "wear", "accuracy")

#: Groups of results that can be asked for by one word; ``all`` is everything but those that take long.
GROUPS: dict[str, tuple[str, ...]] = {
    "all": tuple(name for name, row in RESULTS.items() if row.group not in _SLOW_GROUPS),
    "stiffness": tuple(name for name in RESULTS if name.endswith(("_stiffness_output", "_stiffness_input"))),
    **{
        group: tuple(name for name, row in RESULTS.items() if row.group == group)
        for group in dict.fromkeys(row.group for row in RESULTS.values())
    },
}

#: Former names of results, and what they are called now.
RENAMED = {
    "gross_slip": "slip_ratio",
    "self_locking": "self_locking_ratio",
    "normal_over_rest": "normal_force_over_preload",
    "hertz_peak_pressure": "hertz_pressure",
    "carrier_speed": "output_speed",
    "rolling_carrier_speed": "rolling_output_speed",
    "slip_margin": "slip_ratio",
    "pressure_margin": "pressure_over_first_yield",
    "self_locking_margin": "self_locking_ratio",
    "left_pin_force": "pin_force_left_loading_roller",
    "right_pin_force": "pin_force_right_loading_roller",
    "planet_mass": "body_mass_planet",
    "loading_roller_mass": "body_mass_right_loading_roller",
    **{
        f"{body}_{kind}": f"rim_{kind}_{rows}"
        for body, rows in (("ring", "ring"), ("planet", "planet"), ("loading_roller", "right_loading_roller"))
        for kind in ("stress", "stress_at_rest", "stress_amplitude", "yield_safety", "fatigue_safety")
    },
    "limiting_contact": "limiting_place",
    "reverse_limiting_contact": "reverse_limiting_place",
    "life_hours": "drive_life",
    "contact_life_hours": "contact_life",
    "body_life_hours": "body_life",
    "duty_life_hours": "duty_life",
    **{f"{level}_stiffness_sun": f"{level}_stiffness_input" for level in LEVELS},
}

_MOST_LISTED = 20
_WHERE_LISTED = "the page 'Results' of the documentation lists all of them"

#: What an engineer may call a result whose name is another.
_ALSO_CALLED = {
    "ratio": "speed_ratio",
    "pressure": "hertz_pressure",
    "torque": "torque_capacity",
    "life": "drive_life",
}


def known_result(name: object, *, among: Sequence[str] = (), what: str = "result") -> str:
    """A name of a result, checked."""
    known = tuple(among) or tuple(RESULTS)
    if not isinstance(name, str):
        raise InputError(f"expected the name of a {what} as text, got {name!r}")
    if name in known:
        return name
    if what.endswith("result"):
        _refuse_for_the_drive(name)
    listed = f"known are {', '.join(known)}" if len(known) <= _MOST_LISTED else _WHERE_LISTED
    hint = _hint(name, known) or f"; {listed}"
    raise InputError(f"there is no {what} '{name}'{hint}")


def _refuse_for_the_drive(name: str) -> None:
    """Raise if only another kind of drive has these results; called where a drive lacks them."""
    rows = [RESULTS[member] for member in GROUPS.get(name, (name,)) if member in RESULTS]
    if rows and all(row.needs_wedges for row in rows):
        raise InputError(
            f"a drive of this type has no result '{name}': only one with wedges between planets and ring has it"
        )


def _hint(name: str, known: Sequence[str]) -> str:
    for old, new in RENAMED.items():
        if name == old or name.startswith(f"{old}_"):
            full = now = f"{new}{name[len(old) :]}"
            while now not in known and "_" in now:  # the result of which it is one number
                now = now.rpartition("_")[0]
            return f"; it was renamed to '{now if now in known else full}'"
    other = _ALSO_CALLED.get(name)
    near = [other] if other in known else difflib.get_close_matches(name, known, n=1, cutoff=0.5)
    return f"; did you mean '{near[0]}'?" if near else ""


def chosen_results(names: Iterable[str], *, table: Mapping[str, Result] = RESULTS) -> tuple[str, ...]:
    """Names of single results from names of results and groups."""
    wanted: dict[str, None] = {}
    for name in names:
        group = tuple(member for member in GROUPS.get(name, (name,)) if member in table)
        if not group:
            _refuse_for_the_drive(name)
            groups = [word for word, members in GROUPS.items() if any(member in table for member in members)]
            hint = _hint(name, [*groups, *table])
            raise InputError(f"there is no result '{name}'{hint} (groups: {', '.join(groups)})")
        wanted.update(dict.fromkeys(group))
    if not wanted:
        raise InputError(f"no results are asked for; choose among {', '.join(GROUPS)}")
    return tuple(wanted)


def name_at_level(name: str, level: StiffnessLevel) -> str:
    """The full name of a result."""
    if name == "stiffness":
        return f"{level}_stiffness_output"
    return name if name in RESULTS else f"{level}_{name}"


def row_name(name: str, row: str) -> str:
    """Name of one row of a result: ``slip_ratio_sp``."""
    return f"{name}_{row}" if row else name


def display_unit(name: str) -> str:
    """Unit in which a result is shown."""
    rows = [known for known in RESULTS if name == known or name.startswith(f"{known}_")]
    return RESULTS[max(rows, key=len)].display_unit


def result_values(names: Sequence[str], solved: SolvedJoint) -> dict[str, Array]:
    """The chosen results of a solved joint; the rest costs nothing, because the compiler drops it."""
    values = {}
    for name in names:
        value = RESULTS[name].of(solved)
        if isinstance(value, list | tuple):
            value = xp.stack(xp.broadcast_arrays(*value))
        values[name] = xp.asarray(value, dtype=float)
    return values


@functools.lru_cache(maxsize=32)
def results_of_drive(
    contacts: tuple[str, ...],
    bodies: tuple[str, ...],
    neighbours: tuple[str, ...],
    bearings: tuple[str, ...],
    pins: tuple[str, ...],
    *,
    has_wedges: bool,
    bound: str = "",
) -> dict[str, Result]:
    """Every result that a drive has; ``bound`` is what its stiffness is beyond a value."""
    names = {"contact": contacts, "body": bodies, "clearance": neighbours, "bearing": bearings, "pin": pins}
    rows = [_named(row, names, bound) for row in RESULTS.values() if has_wedges or not row.needs_wedges]
    return {row.name: row for row in rows if row.row_names}


def results_of_joint(solved: SolvedJoint) -> dict[str, Result]:
    """Every result that a single solved joint has: name → row."""
    return results_of_drive(
        *(solved.row_names(axis) for axis in ("contact", "body", "clearance", "bearing", "pin")),
        has_wedges=bool(wedges(solved.joint.drive)),
        bound=stiffness_bound(solved.joint),
    )


def _named(row: Result, names: dict[str, tuple[str, ...]], bound: str) -> Result:
    if row.categories[-1:] == ("none",):  # the contacts or all parts of the drive before it
        of_contacts = row.categories == ("contact", "none")
        places = (*names["contact"], "none") if of_contacts else place_labels(names)
        row = dataclasses.replace(
            row, categories=places, note=f"its number in the order {', '.join(places)}, from 0"
        )
    return dataclasses.replace(row, rows=names.get(row.axis, ()), bound=bound if row.gives_way else "")

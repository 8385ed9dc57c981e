"""What a result is: a named number of a solved joint, its unit, and the limit by which it is judged."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from asperity.engine.arrays import xp
from asperity.joint.pin_bound import bounded
from asperity.joint.status import Needs
from asperity.results.notes import Severity
from asperity.unit_table import Dimension

if TYPE_CHECKING:
    from asperity.results.solved import SolvedJoint
    from asperity.standing.windup import StiffnessLevel


@dataclass(frozen=True)
class Limit:
    """The limit by which a result is judged, and what to do where it is crossed.

    ``severity``: how serious it is; ``kept`` and ``crossed``: what it means that the limit is kept or crossed;
    ``remedy``: what to do where it is crossed. The result must lie between ``lowest`` and ``highest`` [SI], bounds that
    are allowed themselves if ``inclusive``. ``unknown``: what it means that the result is not known, nan; ``state``, of
    severity "state": in which state the joint is where the limit is crossed, in a few words. ``missing``: what a value
    between the bounds still lacks, in a few words; such a limit may be crossed, but it is never kept. ``beyond``: what
    is beyond the limit said of the contact or body, in a few words that follow its name, such as "yields at a rim".
    """

    severity: Severity
    kept: str
    crossed: str
    remedy: str
    lowest: float = -math.inf
    highest: float = math.inf
    inclusive: bool = False
    unknown: str = "no value: the contact slips, has lifted off, has plastic spots only or no known oil film"
    state: str = ""
    missing: str = ""
    beyond: str = ""

    def excess(self, value: Any) -> Any:
        """By how much an array of values exceeds the limit: negative where it is kept, 0 at a bound [-].

        Relative to the bound, of a lower one as the bound over the value: with a force a safety falls as its inverse.
        Absolute for a bound of 0; nan where the value is.
        """
        excess = xp.where(xp.isnan(value), xp.nan, -xp.inf)
        if math.isfinite(self.highest):
            over = value / self.highest - 1.0 if self.highest > 0.0 else value - self.highest
            excess = xp.maximum(excess, over)
        if math.isfinite(self.lowest):
            positive = value > 0.0
            share = self.lowest / xp.where(positive, value, 1.0) - 1.0
            under = xp.where(positive, share, xp.inf) if self.lowest > 0.0 else self.lowest - value
            excess = xp.maximum(excess, under)
        return excess

    def is_kept(self, value: float) -> bool:
        """Whether a value keeps the limit; nan never does, and no value that still lacks something."""
        return self._holds(value) and not self.missing

    def is_known(self, value: float) -> bool:
        """Whether a value shows that the limit is kept or crossed."""
        return not math.isnan(value) and not (self._holds(value) and self.missing)

    def _holds(self, value: float) -> bool:
        """Whether a value lies between the bounds."""
        if self.inclusive:
            return self.lowest <= value <= self.highest
        return self.lowest < value < self.highest

    def nearer_bound(self, value: float) -> float:
        """The bound that a value is nearer to, or has crossed."""
        low = math.isinf(self.highest) or (
            not math.isinf(self.lowest) and value < 0.5 * (self.lowest + self.highest)
        )
        return self.lowest if low else self.highest


@dataclass(frozen=True)
class Column:
    """Where a result of the contacts is shown: in which table, under which head, in which unit.

    ``table``: ``forces``, ``crowns`` and ``stiffness`` of the contacts that stand, ``rolling`` or ``film``; a column
    without any number is left out. ``unit``: that of the column, empty for the unit of the result; ``factor``: times
    what the result is shown, 2 for a width by its half; ``unit_shown``: how the unit is written where a factor stands
    in it.
    """

    table: Literal["forces", "crowns", "stiffness", "rolling", "film"]
    head: str
    unit: str = ""
    factor: float = 1.0
    unit_shown: str = ""


@dataclass(frozen=True)
class Result:
    """One result of a joint.

    Parameters
    ----------
    name : str
        Its name in files, options and datasets.
    label : str
        What it is, in a few words.
    dimension : Dimension
        What it measures.
    display_unit : str
        Unit in tables and figures; datasets and JSON documents are in SI units.
    value : str or callable
        Where it is in a :class:`SolvedJoint`: a dotted path, or a function of the solved joint. Results with rows may
        be sequences of arrays.
    axis : {"one", "contact", "clearance", "body", "pin", "bearing"}
        Whether it is one number, or one for each contact, clearance, body, pin or bearing of the drive.
    needs : {"geometry", "balance", "operation"}
        What must hold for it to mean anything; elsewhere it is nan in datasets.
    group : str
        The group by which it can be asked for.
    level : {"published", "series_with_bulk", "assembly"} or None
        Which model of the stiffness it belongs to.
    differentiable : bool
        Whether its derivatives by the numbers of a joint file mean anything.
    positive : bool
        Whether it is always positive: designs then compare it with a limit by its ratio, otherwise by its difference.
    lowest_limit, highest_limit : float
        Range of the limits that a design may set [SI].
    limit : Limit or None
        The limit of the model by which it is judged, if there is one.
    categories : tuple of str
        What its values number, from 0, where it is no quantity: such a result has no mean.
    note : str
        What else has to be said about it.
    used : tuple of str
        What the share of its limit that is used is called: a share of what, and of what it is the limit. Empty: the
        result itself and its limit.
    present : callable or None
        Which of its rows a joint has; the others are not judged. None: all of them.
    only : str
        What has it, in a sentence, where ``present`` is stated: why the other rows are absent.
    needs_wedges : bool
        Whether only a drive with wedges between planets and ring has it.
    rows : tuple of str
        Names of its rows; empty in the table of all drives, :mod:`asperity.results.table` fills them in.
    gives_way : bool
        Whether it counts the stiffness of the pins.
    bound : str
        What its value is of the drive, if more than a value: an upper bound. Filled in likewise.
    column : Column or None
        Where it stands in the tables of the contacts that terminal, report, notebook and page show; None: in none.
    place : str or None
        Where it stands in the JSON document of a joint: dotted path with the unit at the end of the key, ``*`` for the
        name of the row. None: by group, name and unit (:func:`asperity.results.places.place`); empty: nowhere, because
        the document says it elsewhere in other words.
    """

    name: str
    label: str
    dimension: Dimension
    display_unit: str
    value: str | Callable[[SolvedJoint], Any]
    axis: Literal["one", "contact", "clearance", "body", "pin", "bearing"] = "one"
    needs: Needs = "operation"
    group: str = ""
    level: StiffnessLevel | None = None
    differentiable: bool = True
    positive: bool = True
    lowest_limit: float = -math.inf
    highest_limit: float = math.inf
    limit: Limit | None = None
    categories: tuple[str, ...] = ()
    note: str = ""
    used: tuple[str, str] | tuple[()] = ()
    present: Callable[[SolvedJoint], tuple[bool, ...]] | None = None
    only: str = ""
    needs_wedges: bool = False
    rows: tuple[str, ...] = ()
    gives_way: bool = False
    bound: str = ""
    column: Column | None = None
    place: str | None = None

    @property
    def said(self) -> str:
        """What it is, in a few words, and what bounds it."""
        return bounded(self.label, self.bound)

    @property
    def si_unit(self) -> str:
        """SI unit; ``"1"`` for a ratio."""
        return self.dimension.si_unit

    @property
    def has_none(self) -> str:
        """Where it has no value although the joint has a solution, by its note; empty where that says nothing.

        As in ``"without lubrication.viscosity or where the input stands"``.
        """
        return " or ".join(
            part.removeprefix("nan ") for part in self.note.split("; ") if part.startswith("nan ")
        )

    @property
    def of_rims(self) -> bool:
        """Whether it is read from the rims of a solved joint."""
        return isinstance(self.value, str) and self.value.startswith("rims.")

    @property
    def row_names(self) -> tuple[str, ...]:
        """Names of its rows; one empty text for a single number."""
        return ("",) if self.axis == "one" else self.rows

    @property
    def row_shape(self) -> tuple[int, ...]:
        """Shape of its rows: nothing for a single number."""
        return () if self.axis == "one" else (len(self.row_names),)

    def rows_of(self, solved: SolvedJoint) -> dict[str, float]:
        """Name → value [SI] of the rows that one joint has, without batch axes."""
        names = self.row_names if self.axis == "one" else solved.row_names(self.axis)
        present = (True,) * len(names) if self.present is None else self.present(solved)
        computed = self.of(solved) if any(present) else None
        if computed is None:
            return {}
        values = np.broadcast_to(np.asarray(computed, dtype=float), (len(present),))
        named = zip(names, values, present, strict=True)
        return {name: float(value) for name, value, exists in named if exists}

    def of(self, solved: SolvedJoint) -> Any:
        """Its value [SI]: an array, with the axis of its rows first, or a sequence of its rows."""
        with np.errstate(all="ignore"):  # what has no value divides by zero
            return (
                operator.attrgetter(self.value)(solved) if isinstance(self.value, str) else self.value(solved)
            )

"""Two joints side by side: what differs in their files, and in their results."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from asperity.api.joint import DescribedJoint, load, require_joint
from asperity.api.named_quantity import NamedQuantity
from asperity.api.shown import Shown
from asperity.api.solution import JointSolution
from asperity.errors import InputError, NoSolutionError
from asperity.joint.pin_bound import bounded
from asperity.joint_file.si_tables import stated_tables
from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import quantity

#: Results that a table shows if not all are asked for.
MAIN_RESULTS = (
    "assembly_stiffness_output",
    "series_with_bulk_stiffness_output",
    "published_stiffness_output",
    "preload",
    "interference",
    "hertz_pressure",
    "slip_ratio",
    "torque_capacity",
    "reverse_torque_capacity",
    "standing_torque_capacity",
    "rolling_torque_capacity",
    "torque_safety",
    "drift",
    "efficiency",
    "total_loss",
    "drive_life",
    "duty_life",
    "film_ratio",
    "life_factor",
    "pin_load",
    "speed_ratio",
    "envelope_diameter",
    "envelope_length",
    "mass",
)
#: Relative difference up to which two numbers are the same.
_SAME = 1e-9


class Difference(NamedTuple):
    """One line: ``name`` of a key or result, ``label`` in words, and what it is in ``one`` and in the ``other``.

    A number is a :class:`NamedQuantity`, a choice a text; None where one of both does not have it.
    """

    name: str
    label: str
    one: NamedQuantity | str | None
    other: NamedQuantity | str | None

    @property
    def said(self) -> str:
        """The label, and what bounds both sides."""
        return bounded(self.label, self.bound)

    @property
    def bound(self) -> str | None:
        """What bounds both sides alike; None where they differ in that, or nothing does."""
        one, other = _bound(self.one), _bound(self.other)
        return one if one == other else None

    @property
    def change(self) -> float:
        """The other over the one, less 1 [-]; nan where that means nothing."""
        sizes = [q.si if isinstance(q, NamedQuantity) and not q.categories else math.nan for q in self[2:]]
        return sizes[1] / sizes[0] - 1.0 if sizes[0] else math.nan


@dataclass(frozen=True, repr=False)
class JointComparison(Shown):
    """What differs between two joints; ``inputs`` and ``results`` hold one :class:`Difference` each.

    Parameters
    ----------
    one, other : DescribedJoint
        The joints.
    inputs, results : tuple of Difference
        Numbers and choices of the files, and results, in the order of their tables; only those that differ.
    same : int
        Number of results that are the same.
    """

    one: DescribedJoint
    other: DescribedJoint
    inputs: tuple[Difference, ...]
    results: tuple[Difference, ...]
    same: int

    @property
    def main(self) -> tuple[Difference, ...]:
        """The results of :data:`MAIN_RESULTS` that differ."""
        by_name = {name: place for place, name in enumerate(MAIN_RESULTS)}
        chosen = [line for line in self.results if _row_of(line.name) in by_name]
        return tuple(sorted(chosen, key=lambda line: by_name[_row_of(line.name)]))

    def blocks(self, *, in_full: bool = False) -> list[Block]:
        """The differences of the files, then those of the results: the main ones, or all."""
        sources = (self.one.source, self.other.source)
        short = Path(sources[0]).name, Path(sources[1]).name
        names = short if short[0] != short[1] else sources
        parts: list[Block] = [Paragraph("The files say the same.")]
        if self.inputs:
            rows = [(line.name, _shown(line.one), _shown(line.other), _change(line)) for line in self.inputs]
            parts = [Table("What differs in the files", ("number or choice", *names, "change"), rows)]
        lines = self.results if in_full else self.main
        if lines:
            rows = [(line.said, *_sides(line), _change(line)) for line in lines]
            parts.append(Table("What differs in the results", ("result", *names, "change"), rows))
        rest = len(self.results) - len(lines)
        more = f"{rest} more results differ, " if rest else ""
        parts.append(Paragraph(f"{more}{self.same} results are the same."))
        return parts

    def document(self) -> Document:
        """All differences in SI units, for JSON; a number that is not known is None."""

        def plain(side: NamedQuantity | str | None) -> float | str | None:
            if not isinstance(side, NamedQuantity):
                return side
            return side.value if side.categories else float(side.si) if math.isfinite(side.si) else None

        def listed(lines: tuple[Difference, ...]) -> list[Document]:
            return [
                {
                    "name": line.name,
                    "label": line.label,
                    "si_unit": next((q.si_unit for q in line[2:] if isinstance(q, NamedQuantity)), None),
                    "one": plain(line.one),
                    "other": plain(line.other),
                    "change": line.change if math.isfinite(line.change) else None,
                }
                for line in lines
            ]

        return {
            "one": self.one.source,
            "other": self.other.source,
            "inputs": listed(self.inputs),
            "results": [
                entry | {"one_bound": _bound(line.one), "other_bound": _bound(line.other)}
                for entry, line in zip(listed(self.results), self.results, strict=True)
            ],
            "same_results": self.same,
        }


def compare(one: DescribedJoint | str | Path, other: DescribedJoint | str | Path) -> JointComparison:
    """What differs between two joints, in what their files say and in what comes out.

    Parameters
    ----------
    one, other : DescribedJoint, str or Path
        Joints, or names of joint files.

    Returns
    -------
    JointComparison
        Tables in a terminal or a notebook, ``inputs``, ``results`` and ``document()``.

    Raises
    ------
    InputError, NoSolutionError
        If one of both cannot be read or solved.
    """
    joints = [load(joint) if isinstance(joint, str | Path) else joint for joint in (one, other)]
    for joint in joints:
        require_joint(joint)
    files = [dict(_stated(joint)) for joint in joints]
    results = [dict(_singles(_solved(joint))) for joint in joints]
    lines = [line for line in _lines(*results) if not _absent(line)]
    differing = tuple(line for line in lines if not _alike(line.one, line.other))
    inputs = tuple(line for line in _lines(*files) if not _alike(line.one, line.other))
    return JointComparison(joints[0], joints[1], inputs, differing, len(lines) - len(differing))


def _solved(joint: DescribedJoint) -> JointSolution:
    """The solution, or a refusal that begins with the name of the joint."""
    try:
        return joint.solve()
    except (InputError, NoSolutionError) as error:
        raise type(error)(f"{joint.source}: {error}") from None


def _stated(joint: DescribedJoint) -> Iterator[tuple[str, NamedQuantity | str]]:
    """Numbers and choices of a file by their dotted paths."""
    yield from joint.numbers.items()
    yield from _words(stated_tables(joint.case), "")


def _words(table: Mapping[str, Any], path: str) -> Iterator[tuple[str, str]]:
    for key, entry in table.items():
        if isinstance(entry, Mapping):
            yield from _words(entry, f"{path}{key}.")
        elif isinstance(entry, str):
            yield f"{path}{key}", entry


def _singles(solution: JointSolution) -> Iterator[tuple[str, NamedQuantity]]:
    """Results by row and contact, joined with a slash, without those that are remainders of a search."""
    for row in solution:
        if row.endswith("_residual"):
            continue
        for single in solution[row].singles():
            rest = single.name.removeprefix(row).removeprefix("_")
            yield f"{row}/{rest}" if rest else row, single


def _row_of(name: str) -> str:
    return name.partition("/")[0]


def _lines(
    one: Mapping[str, NamedQuantity | str], other: Mapping[str, NamedQuantity | str]
) -> list[Difference]:
    """Both sides by name, in the order of the first, then those that only the second has."""
    lines = []
    for name in dict.fromkeys([*one, *other]):
        sides = one.get(name), other.get(name)
        label = next((side.label for side in sides if isinstance(side, NamedQuantity)), name)
        lines.append(Difference(name, label, *sides))
    return lines


def _alike(one: NamedQuantity | str | None, other: NamedQuantity | str | None) -> bool:
    if not (isinstance(one, NamedQuantity) and isinstance(other, NamedQuantity)):
        return one == other
    sizes = float(one.si), float(other.si)
    return all(map(math.isnan, sizes)) or math.isclose(*sizes, rel_tol=_SAME, abs_tol=1e-300)


def _absent(line: Difference) -> bool:
    """Whether one joint does not have a result, and the other does not know it."""
    return (line.one is None or line.other is None) and _shown(line.one) == _shown(line.other)


def _bound(side: NamedQuantity | str | None) -> str | None:
    return (side.bound or None) if isinstance(side, NamedQuantity) else None


def _sides(line: Difference) -> tuple[str, str]:
    """Both sides, each with what bounds it alone."""
    one, other = (bounded(_shown(side), None if line.bound else _bound(side)) for side in line[2:])
    return one, other


def _shown(side: NamedQuantity | str | None) -> str:
    if isinstance(side, NamedQuantity) and not side.categories:
        return quantity(side.si, side.unit, 6)
    return "–" if side is None else str(side)


def _change(line: Difference) -> str:
    change = line.change
    return f"{100.0 * change:+.3g} %" if math.isfinite(change) else ""

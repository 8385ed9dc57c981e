"""A solved joint in a script: every row of the table of results by its name, with its unit."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from asperity.api.named_quantity import NamedQuantity, columns_of
from asperity.api.shown import Shown, displayed, frame, installed_pandas
from asperity.joint_file.si_tables import AnyCase
from asperity.joint_file.solved_document import document_of, full_document
from asperity.joint_file.stated_parts import made_interference
from asperity.results import LEVELS, Result, known_result, name_at_level
from asperity.results.solved import SolvedJoint
from asperity.results.table import results_of_joint
from asperity.show.compliance_figure import compliance_figure
from asperity.show.style import plain_title
from asperity.types import Document
from asperity.views.blocks import Block
from asperity.views.screens import joint_screen
from asperity.views.solved_view import SolvedView

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

    from asperity.standing.windup import StiffnessLevel


class JointSolution(Shown):
    """A solved joint: ``solution["stiffness"]`` is a number with its unit, and so is every other result.

    Parameters
    ----------
    case : Case
        The joint file.
    solved : SolvedJoint
        What came out.
    source, summary : str
        Where the joint comes from, and the joint in one line, for titles.
    """

    def __init__(self, case: AnyCase, solved: SolvedJoint, *, source: str, summary: str) -> None:
        self.solution, self._solved = solved.solution, solved
        self._case, self._source, self._summary = case, source, summary
        self._table = results_of_joint(solved)

    def __getitem__(self, asked: str | tuple[str, StiffnessLevel]) -> NamedQuantity:
        """One result.

        ``solution["stiffness"]`` is the output stiffness of the fullest model, ``solution["stiffness", "published"]``
        that of another; ``solution["slip_ratio"]`` has a number for each contact, ``solution["slip_ratio_sp"]`` is one.
        """
        name, level = asked if isinstance(asked, tuple) and len(asked) == 2 else (asked, LEVELS[0])
        if isinstance(asked, tuple):
            known_result(level, among=LEVELS, what="level of the stiffness")
        if isinstance(name, str) and name not in self._table:
            full = name_at_level(name, level)
            name = full if full in self._table else name
            for row in self._table.values():
                for contact in filter(None, row.row_names):
                    if name == f"{row.name}_{contact}":
                        return self._quantity(row)[contact]
        return self._quantity(self._table[known_result(name, among=("stiffness", *self._table))])

    def _quantity(self, row: Result) -> NamedQuantity:
        value = row.of(self._solved)
        values = np.asarray(value, dtype=float)
        rows = row.row_names if row.row_shape else ()
        return NamedQuantity(
            name=row.name,
            label=row.label,
            si=np.broadcast_to(values, row.row_shape) if rows else float(values),
            dimension=row.dimension,
            unit=row.display_unit,
            rows=rows,
            level=row.level,
            categories=row.categories,
            bound=row.bound,
        )

    def __iter__(self) -> Iterator[str]:
        return iter(self._table)

    def __len__(self) -> int:
        return len(self._table)

    def __contains__(self, name: object) -> bool:
        return name in self._table

    def keys(self) -> list[str]:
        """Names of all results."""
        return list(self._table)

    def _ipython_key_completions_(self) -> list[str]:
        return ["stiffness", *self._table]

    @property
    def limits(self) -> list[Document]:
        """Every limit of the joint and of its model in SI units, with ``ok``, ``meaning`` and ``remedy``."""
        return self._of_joint["diagnostics"]

    @functools.cached_property
    def _of_joint(self) -> Document:
        return document_of(self._case, self._solved)

    @functools.cached_property
    def document(self) -> Document:
        """The document that ``asperity joint --json`` prints, in SI units."""
        return full_document(self._case, self._solved)

    def to_frame(self) -> pandas.DataFrame:
        """Every number as a row of a pandas data frame: label, value, unit, SI value, SI unit, level."""
        singles = self._singles()
        return frame(
            {
                "label": [quantity.said for quantity in singles],
                **columns_of(singles),
                "level": [quantity.level for quantity in singles],
            },
            index=[quantity.name for quantity in singles],
            index_name="result",
        )

    def to_series(self) -> pandas.Series:
        """Every number as a pandas series of SI values; the index holds the name and the SI unit."""
        singles = self._singles()
        index = [(quantity.name, quantity.si_unit) for quantity in singles]
        library = installed_pandas()
        return library.Series(
            [quantity.si for quantity in singles],
            index=library.MultiIndex.from_tuples(index, names=["result", "unit"]),
            name=self._source,
        )

    def _singles(self) -> list[NamedQuantity]:
        return [single for name in self for single in self[name].singles()]

    def plot(self) -> Figure:
        """Draw what gives way: the share of every spring in the compliance, and the stiffness on every level.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        return displayed(compliance_figure(self._solved, title=plain_title(self._summary)))

    def blocks(self) -> list[Block]:
        """What ``asperity joint`` prints, without the assumptions."""
        return list(joint_screen(self.view, self._source))

    @functools.cached_property
    def view(self) -> SolvedView:
        """The solved joint with its document, from which every table is made."""
        made = made_interference(self._case, self._solved.result).size
        return SolvedView(self._solved, self.document, made)

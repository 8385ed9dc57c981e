"""What the command of :mod:`asperity.cli.loads` does."""

from __future__ import annotations

import csv
import math
import re
from typing import TYPE_CHECKING

from asperity.api.joint import DescribedJoint
from asperity.api.structure import loads as loads_of
from asperity.cli.options import read_option
from asperity.cli.terminal import about, print_json, say_written, show_blocks
from asperity.joint_file.reader import read_case
from asperity.made_files import table_where
from asperity.unit_table import Dimension
from asperity.writing import check_file, replacing

if TYPE_CHECKING:
    from asperity.api.structure import JointLoads

#: Columns of every table of loads, and those that follow, one for each load that is stated.
_COLUMNS = ["part", "position", "load", "unit", "without torque"]
_STATED = re.compile(r".+, (in rolling|standing), \S+ N·m, \S+ rpm", re.DOTALL)


def _is_of_loads(columns: list[str]) -> bool:
    count = len(_COLUMNS)
    return columns[:count] == _COLUMNS and all(map(_STATED.fullmatch, columns[count:]))


LOADS = table_where("a table of loads", _is_of_loads)


def loads(file: str, mounting_gap: str, csv_file: str | None, as_json: bool) -> None:
    """What ``asperity loads`` does; its options stand in :mod:`asperity.cli.loads`."""
    read_option("mounting-gap", mounting_gap, Dimension.LENGTH)  # refuses what is no length
    check_file(csv_file, file, kind=LOADS)
    case = read_case(file)
    with about(file):
        carried = loads_of(DescribedJoint(case, file), mounting_gap=mounting_gap)
    if csv_file:
        _write(carried, csv_file)
        say_written(csv_file)
    if as_json:
        print_json(carried.document)
        return
    show_blocks(*carried.blocks())


def _write(carried: JointLoads, path: str) -> None:
    """The table as a CSV file: one row a load, one column a case."""
    columns = carried.columns()
    with replacing(path, kind=LOADS) as part, part.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(columns)
        for row in zip(*columns.values(), strict=True):
            writer.writerow(
                [cell if isinstance(cell, str) else "" if math.isnan(cell) else repr(cell) for cell in row]
            )

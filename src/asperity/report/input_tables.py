"""The inputs of a joint as tables: every number with its unit and tolerance, and every choice."""

from __future__ import annotations

from typing import Any

from asperity.joint_file.model import Case
from asperity.joint_file.si_tables import numeric_keys, si_values
from asperity.report.content import Table
from asperity.units import format_quantity


def inputs_table(case: Case) -> Table:
    """Every number of a joint file."""
    rows = []
    for path, number in numeric_keys(case).items():
        unit = number.key.unit
        tolerance = f"± {format_quantity(number.tolerance, unit, 6)}" if number.tolerance else ""
        rows.append((path, format_quantity(number.value, unit, 8), tolerance))
    duty: dict[str, Any] = si_values(case).get("duty", {})
    rows += [(f"duty.{load}.share", f"{entry['share']:.8g}", "") for load, entry in duty.items()]
    return Table("Numbers of the joint file", ("number", "value", "tolerance"), rows)


def choices_table(case: Case) -> Table:
    """Everything in a joint file that is not a number."""
    return Table(
        "Choices of the joint file", ("key", "value"), list(_words(si_values(case), "")), words=(0, 1)
    )


def _words(node: Any, path: str) -> list[tuple[str, str]]:
    if isinstance(node, dict):
        return [
            each for name, below in node.items() for each in _words(below, f"{path}.{name}" if path else name)
        ]
    return [(path, node)] if isinstance(node, str) else []

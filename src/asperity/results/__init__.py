"""The one table of results: every number of a solved joint that studies, designs, diagnostics and documents name.

A row says name, label, unit, whether there is one for each contact, what must hold for it to mean anything, and, where
it is judged, its limit, what crossing it means and what to do. A new result is a new row in one of the modules of this
package, and the function that computes it.
"""

from asperity.results.notes import SEVERITIES, Severity
from asperity.results.result import Limit, Result
from asperity.results.table import (
    GROUPS,
    LEVELS,
    RESULTS,
    chosen_results,
    display_unit,
    known_result,
    name_at_level,
    result_values,
    row_name,
)

__all__ = [
    "GROUPS",
    "LEVELS",
    "RESULTS",
    "SEVERITIES",
    "Limit",
    "Result",
    "Severity",
    "chosen_results",
    "display_unit",
    "known_result",
    "name_at_level",
    "result_values",
    "row_name",
]

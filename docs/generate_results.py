"""Write docs/results.md from the table of results: `python docs/generate_results.py` (`--check` only compares)."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from pathlib import Path

from asperity.results import GROUPS, RESULTS, Limit, Result
from asperity.results.table import RENAMED
from asperity.units import format_quantity

PAGE = Path(__file__).with_name("results.md")

HEAD = """\
# Results

<!-- Written by docs/generate_results.py from asperity.results; edit the rows there, then run it. -->

Every number that `asperity` computes for a joint. The names are the same everywhere: `asperity sweep --results`,
`asperity sensitivity --result`, `asperity uncertainty --results`, objectives and limits of `asperity design`, the
warnings of `asperity joint`. `--results` also takes the name of a group, `stiffness` (at sun and output, every model)
and `all`, which is everything but the group `stresses`.

Tables show the unit given here; datasets and JSON documents are in SI units. A result *of contacts* has one number for
each contact of the drive, in the paper's `sp`, `pwr`, `pwl`, `wro`, `wlo`; its single numbers are called
`slip_ratio_sp` and so on. Likewise those *of bodies*, *of bearings*, *of pins*, which have the names of their rollers,
and *of clearances*, which name two bodies without a contact, `clearance_planet_to_ring`. Results that need
the *balance* are nan where the force balance does not close, those that need *operation* also where a contact slips;
all are nan where the rollers do not fit.

In a design file, `stiffness`, `stiffness_per_mass` and `stiffness_per_volume` stand for the results of the level that
the file states. Results without derivatives can be neither objectives nor limits, and have no sensitivities.
"""


def _describe(result: Result) -> str:
    parts = [result.label, *([result.note] if result.note else [])]
    if not result.differentiable:
        parts.append("no derivatives")
    return "; ".join(parts)


def _groups() -> Iterator[str]:
    for group, names in GROUPS.items():
        if group in ("all", "stiffness"):
            continue
        yield f"## {group}\n"
        yield "| result | meaning | of | unit | needs |\n|---|---|---|---|---|"
        for name in names:
            result = RESULTS[name]
            rows = "" if result.axis == "one" else {"body": "bodies"}.get(result.axis, f"{result.axis}s")
            unit = "-" if result.display_unit == "1" else result.display_unit
            yield f"| `{name}` | {_describe(result)} | {rows} | {unit} | {result.needs} |"
        yield ""


def _bounds(limit: Limit, unit: str) -> str:
    words = []
    if math.isfinite(limit.lowest):
        words.append(f"{'from' if limit.inclusive else 'above'} {format_quantity(limit.lowest, unit)}")
    if math.isfinite(limit.highest):
        words.append(f"{'to' if limit.inclusive else 'below'} {format_quantity(limit.highest, unit)}")
    return " ".join(words)


def _limits() -> Iterator[str]:
    yield "## Limits of the joint and of its model\n"
    yield (
        "`asperity joint` warns where one of these is crossed, the most serious first: *function* (the joint does\n"
        "not work), *damage*, *accuracy* (the numbers cannot be trusted), "
        "*state* (it works, with a consequence), *model* (the published contact law is\n"
        "outside its range, as for most joints).\n"
    )
    yield "| result | allowed | severity | where it is crossed | what to do |\n|---|---|---|---|---|"
    for name, result in RESULTS.items():
        limit = result.limit
        if limit is not None:
            bounds = _bounds(limit, result.display_unit)
            yield f"| `{name}` | {bounds} | {limit.severity} | {limit.crossed} | {limit.remedy} |"
    yield ""


def _renamed() -> Iterator[str]:
    yield "## Former names\n"
    yield "| former | now |\n|---|---|"
    yield from (f"| `{old}` | `{new}` |" for old, new in RENAMED.items())


def page() -> str:
    """The page as it must be."""
    return "\n".join([HEAD, *_groups(), *_limits(), *_renamed()]) + "\n"


def main() -> int:
    """Write the page, or with --check say whether it is current."""
    if "--check" in sys.argv[1:]:
        if PAGE.read_text(encoding="utf-8") == page():
            return 0
        print("docs/results.md is out of date: run `python docs/generate_results.py`", file=sys.stderr)
        return 1
    PAGE.write_text(page(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())

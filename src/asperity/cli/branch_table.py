"""Unequal branches as a table to read."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from asperity.cli.document_text import in_unit, number, print_wrapped, scaled
from asperity.cli.terminal import table
from asperity.results.branch_document import deviations, force_size

if TYPE_CHECKING:
    from rich.console import Console

Document = dict[str, Any]


def show_branches(target: Console, branches: Document) -> None:
    """Print what unequal branches do to a joint.

    Parameters
    ----------
    target : Console
        Where to print.
    branches : dict
        As :func:`asperity.results.branch_document.branch_document` makes it.
    """
    standing, rolling = branches["standing"], branches["rolling"]
    names = deviations(branches)
    shown = table(
        target,
        "\nBranches by their own sizes",
        branches["branch_is"],
        "deviation\n" + ",\n".join(names.values()) + " µm",
        "interference\nµm",
        "preload\nN",
        "share standing,\nrolling %",
        "slip standing,\nrolling -",
    )
    for index, entry in enumerate(branches["branches"]):
        sizes = [entry[key] for key in names]
        shown.add_row(
            str(index + 1),
            ", ".join(scaled(size, 1e6) for size in sizes),
            scaled(entry["interference_m"], 1e6),
            number(entry["preload_N"]),
            ", ".join(_of(state, "share", index, 100.0) for state in (standing, rolling)),
            ", ".join(_of(state, "slip_ratio", index, 1.0) for state in (standing, rolling)),
        )
    target.print(shown)
    print_wrapped(target, f"  {branches['note']}", indent=2)
    stiffness = branches.get("output_stiffness_Nm_per_rad")
    for label, text in (
        ("sun", _sun(branches, standing)),
        *(("centre", text) for text in _others(branches, standing or branches["without_torque"])),
        ("capacity", _capacity(branches, "torque_capacity")),
        ("rolling", _capacity(branches, "rolling_torque_capacity")),
        *([] if stiffness is None else [("stiffness", _stiffness(stiffness))]),
        *([("turning", _turning(branches["turning"]))] if "turning" in branches else []),
    ):
        print_wrapped(target, f"  {label:<10} {text}", indent=13)


def _of(state: Document | None, name: str, index: int, factor: float) -> str:
    value = None if state is None else state[name][index]
    return "-" if value is None else number(factor * value, 3)


def _sun(found: Document, standing: Document | None) -> str:
    sun = (standing or found["without_torque"])["sun"]
    force = in_unit(force_size(found, sun["force_N"]), "N") + (" standing" if standing else " without torque")
    if found["sun_support_stiffness_N_per_m"] is None:
        return f"{force} on its bearings, which hold it"
    return f"{in_unit(math.hypot(*sun['displacement_m']), 'um')} off centre, {force} on its bearings"


def _others(found: Document, state: Document) -> list[str]:
    """Forces on the other members on the axis, in words."""
    forces = state.get("central_forces_N", {})
    named = [
        f"{in_unit(force_size(found, force), 'N')} on the {name.replace('_', ' ')}"
        for name, force in forces.items()
    ]
    return [", ".join(named)] if named else []


def _turning(found: Document) -> str:
    """Drift and losses of all branches together."""
    if found["unknown_because"]:
        return "; ".join(found["unknown_because"])
    words = f"drift of {in_unit(found['drift_rad_per_output_turn'], 'arcmin')} per output turn"
    if found["efficiency"] is not None:
        total = in_unit(found["losses_W"]["total"], "W")
        words += f", losses of {total}, efficiency {scaled(found['efficiency'], 100.0)} %"
    return f"{words}, all of these branches together"


def _stiffness(value: float) -> str:
    return f"{in_unit(value, 'N*m/arcmin')} at the output, of these branches, assembled"


def _capacity(found: Document, name: str) -> str:
    entry = found[name]
    last = entry["all_slip_Nm"]
    beyond = "steady rolling ends there" if last is None else f"all slip at {in_unit(last, 'N*m')}"
    return (
        f"{in_unit(entry['first_slip_Nm'], 'N*m')}: contact {entry['first_contact']} of {found['branch_is']} "
        f"{entry['first_branch']} {entry['first_event']} first; {beyond}; equal branches pass "
        f"{in_unit(entry['equal_branches_Nm'], 'N*m')}"
    )

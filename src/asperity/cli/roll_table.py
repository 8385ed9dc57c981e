"""A joint that turns as tables to read."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from asperity.cli.document_text import (
    in_unit,
    number,
    print_wrapped,
    scaled,
    show_assumptions,
    show_branches,
    show_heading,
    show_verdict,
    show_warnings,
)
from asperity.cli.terminal import show_table, table
from asperity.results.document import input_member
from asperity.results.notes import surface_rows
from asperity.results.position_rows import position_rows
from asperity.rolling.document import rating_life_name

if TYPE_CHECKING:
    from rich.console import Console

Document = dict[str, Any]

_CAUSES = ("creep", "skew", "hysteresis", "oil")


def show_rolling(target: Console, document: Document, *, source: str, in_full: bool) -> None:
    """Print what a joint document says about the joint that turns."""
    show_heading(target, document, source)
    show_verdict(target, document)
    _show_output(target, document)
    _show_losses(target, document)
    _show_contacts(target, document)
    _show_surfaces(target, document["rolling"])
    _show_thrust(target, document)
    _show_life(target, document)
    show_warnings(target, document)
    show_assumptions(target, document, in_full=in_full)
    if "branches" in document:
        show_branches(target, document["branches"])


def _show_output(target: Console, document: Document) -> None:
    """Drift and stiffness: two numbers that do not replace each other."""
    shown = table(target, "Position of the output", "quantity", "value", "what it is")
    shown.columns[2].justify, shown.columns[2].no_wrap = "left", False
    for label, value, unit, meaning in position_rows(document):
        shown.add_row(label, in_unit(value, unit), meaning)
    target.print(shown)


def _show_losses(target: Console, document: Document) -> None:
    rolling = document["rolling"]
    if rolling["losses_W"]["total"] is None:
        target.print("Efficiency and losses", style="bold")
        for reason in rolling["unknown_because"]:
            print_wrapped(target, f"  {reason}", indent=2)
        target.print()
        return
    efficiency = rolling["efficiency"]
    shown = table(
        target,
        f"Efficiency {'-' if efficiency is None else scaled(efficiency, 100.0) + ' %'}: "
        f"{in_unit(rolling['input_power_W'], 'W')} in, {in_unit(rolling['output_power_W'], 'W')} out",
        "losses",
        *(f"{cause}\nW" for cause in _CAUSES),
        "sum\nW",
    )
    for name, contact in rolling["contacts"].items():
        losses = contact["losses_W"]
        shown.add_row(name, *(number(losses[cause]) for cause in _CAUSES), number(losses["total"]))
    sums = rolling["losses_W"]
    shown.add_row("bearings and pins", *("" for _ in _CAUSES), number(sums["bearings"]))
    shown.add_row("all", *(number(sums[cause]) for cause in _CAUSES), number(sums["total"]))
    target.print(shown)
    for reason in rolling["unknown_because"]:
        print_wrapped(target, f"  {reason}", indent=2)


def _show_contacts(target: Console, document: Document) -> None:
    friction, yields = (
        {entry["contact"]: entry["value"] for entry in document["diagnostics"] if entry["name"] == name}
        for name in ("friction_coefficient", "pressure_over_first_yield")
    )
    shown = table(
        target,
        "Contacts",
        "contact",
        "creepage\n10⁻³",
        "asperities\ntimes",
        "traction\nT/N",
        "limit\nT/N",
        "pressure\nMPa",
        "over\nfirst yield",
        "over\nshakedown",
        "rough\nMPa",
    )
    sliding = []
    for name, contact in document["rolling"]["contacts"].items():
        left, traction = contact["capacity_loss"], contact["traction_coefficient"]
        limit = None if left is None else friction[name] * (1.0 - left)
        sliding += [name] if limit is not None and abs(traction or 0.0) > limit else []
        shown.add_row(
            name,
            scaled(contact["creepage"], 1e3),
            number(contact["layer_creepage_factor"]),
            number(traction),
            number(limit),
            scaled(contact["hertz_pressure_Pa"], 1e-6),
            number(yields.get(name), 3),
            number(contact["shakedown_ratio"], 3),
            scaled(contact["rough_peak_pressure_Pa"], 1e-6),
        )
    target.print(shown)
    if sliding:
        text = f"  {', '.join(sliding)}: slips as a whole, because skew uses part of the friction; the rest of the "
        print_wrapped(target, text + "traction takes the large creepage above\n", indent=2)


def _show_surfaces(target: Console, rolling: Document) -> None:
    """Flash temperature and oil film, where the file has the numbers for one of them."""
    rows = surface_rows(rolling["contacts"])
    if not rows:
        return
    head = (
        "contact",
        "flash temperature\nK",
        "smallest oil film\nµm",
        "film ratio λ\n-",
        "lubrication",
    )
    cells = ((name, *(number(value, 3) for value in numbers), band or "-") for name, *numbers, band in rows)
    show_table(target, "Surfaces in rolling", head, cells)


def _show_thrust(target: Console, document: Document) -> None:
    rolling = document["rolling"]
    axial = [contact["axial_force_N"] for contact in rolling["contacts"].values()]
    skewed = (document["input"].get("rolling") or {}).get("skew")
    if not any(axial) and not (skewed and None in axial):
        target.print("Axial thrust: none, the axes are parallel\n", style="bold")
        return
    of_contacts = {name: contact["axial_force_N"] for name, contact in rolling["contacts"].items()}
    of_bodies = {_words(name): force for name, force in rolling["axial_thrust_N"].items()}
    for title, forces in (
        ("Axial force of each contact on its driven body, N", of_contacts),
        ("Axial thrust on each body, N", of_bodies),
    ):
        shown = table(target, title, *forces)
        shown.columns[0].justify = "right"
        shown.add_row(*(number(force) for force in forces.values()))
        target.print(shown)


def _show_life(target: Console, document: Document) -> None:
    rolling, loads = document["rolling"], document["input"].get("duty", {})
    shown = table(
        target,
        rating_life_name(rolling["reliability"]),
        "life of",
        "hours",
        "output turns",
    )
    shown.add_row(
        "the drive", _life(rolling["life_hours"]), _life(rolling["life_output_turns"]), style="bold"
    )
    for name, hours in rolling["body_life_hours"].items():
        alone = document["of_own_branches"] or name == "sun" or name.endswith("ring")
        one = "" if alone else "one "
        shown.add_row(one + _words(name), _life(hours), _life(rolling["body_life_output_turns"][name]))
    if loads:
        shown.add_row(
            "the drive under the duty",
            _life(rolling["duty_life_hours"]),
            _life(rolling["duty_life_output_turns"]),
            style="bold",
        )
    target.print(shown)
    for entry in document["diagnostics"]:
        if entry["name"].startswith("required_"):
            _print_required(target, entry)
    if rolling["no_life_because"]:
        print_wrapped(target, f"  {rolling['no_life_because']}", indent=2)
    if loads:
        _show_duty(target, document, loads)


def _show_duty(target: Console, document: Document, loads: Document) -> None:
    head = (
        "load",
        "output torque",
        input_member(document),
        "share\nof time",
        "share\nof damage",
        "life under this\nload alone, hours",
    )
    rows = []
    for name, load in loads.items():
        of_load = document["rolling"]["duty"][name]
        rows.append(
            (
                name,
                in_unit(load["output_torque"], "N*m"),
                in_unit(load["sun_speed"], "rpm"),
                f"{scaled(load['share'], 100.0)} %",
                "-" if of_load["damage_share"] is None else f"{scaled(of_load['damage_share'], 100.0)} %",
                _life(of_load["life_hours"]),
            )
        )
    show_table(target, "Duty, damage summed by Miner's rule", head, rows)


def _print_required(target: Console, entry: Document) -> None:
    """Whether the drive or a bearing lives as long as required."""
    verdict = ": met" if entry["ok"] else ": NOT met" if entry["known"] else f"; {entry['meaning']}"
    where = f", {_words(entry['contact'])}" if entry["contact"] else ""
    print_wrapped(
        target,
        f"  {entry['label']}{where} {entry['shown']}, required {entry['limit_shown']}{verdict}",
        indent=4,
    )


def _words(name: str) -> str:
    return name.replace("_", " ")


def _life(value: float | None) -> str:
    return number(value, 3)

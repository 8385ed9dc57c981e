"""Numbers, wrapped sentences, warnings and branches of a solved joint, as every command shows them."""

from __future__ import annotations

import math
import textwrap
from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from asperity.cli.terminal import console, show_table, table
from asperity.joint.pin_bound import bounded
from asperity.joint.temperature_limits import limit_words
from asperity.joint.torque_limits import standing_words
from asperity.results.branch_document import deviations, force_size
from asperity.results.document import crossed_limits, input_member, law_range_words, verdict_words
from asperity.units import format_quantity

if TYPE_CHECKING:
    from rich.console import Console

    from asperity.api.shown import Table


Document = dict[str, Any]


def number(value: float | None, digits: int = 4) -> str:
    """A number with four digits; a dash where there is none."""
    return "-" if value is None else format_quantity(value, "1", digits)


def scaled(value: float | None, factor: float) -> str:
    """A number in another unit; a dash where there is none."""
    return "-" if value is None else number(value * factor)


def in_unit(value: float | None, unit: str, digits: int = 4) -> str:
    """A quantity with its unit; a dash where there is none."""
    return "-" if value is None else format_quantity(value, unit, digits)


def count(value: float, word: str) -> str:
    """How many there are of something."""
    return f"{number(value)} {word}{'' if value == 1 else 's'}"


def print_wrapped(target: Console, text: str, *, indent: int, style: str | None = None) -> None:
    """Print a sentence, its later lines indented."""
    target.print(
        textwrap.fill(text, target.width, subsequent_indent=" " * indent),
        markup=False,
        soft_wrap=True,
        style=style,
    )


def show_parts(heading: str, parts: Iterable[str | Table]) -> None:
    """Print a heading, if there is one, then tables and sentences in their order."""
    target = console()
    if heading:
        target.print(f"{heading}\n", markup=False)
    for part in parts:
        if isinstance(part, str):
            print_wrapped(target, part, indent=2)
        else:
            show_table(target, part.title, part.head, part.rows)


def show_heading(target: Console, document: Document, source: str) -> None:
    """Name of the file, and the load for which its numbers hold."""
    drive, load, preload = document["input"]["drive"], document["input"]["load"], document["preload"]
    if "planets" in drive:
        size = count(drive["planets"], "planet")
    elif "sectors" in drive:
        size = count(drive["sectors"], "sector")
    else:
        size = f"{count(document['geometry']['sectors'], 'roller')} in each row"
    kind, entry = document["input"].get("type"), input_member(document)
    title = source if kind is None else f"{source}: {kind.replace('_', ' ')} drive"
    target.print(
        f"{title}\n{size}, {entry} at {in_unit(document['input_speed_rad_per_s'], 'rpm')}, preload "
        f"{in_unit(preload['force_N'], 'N')} (interference {in_unit(preload['interference_m'], 'um')}), "
        f"output torque {in_unit(load['output_torque'], 'N*m')}{temperatures(document)}{loading_cam(document)}\n",
        style="bold",
        markup=False,
    )


def show_verdict(target: Console, document: Document) -> None:
    """Whether the joint works and what limits it, its numbers of use, its size."""
    print_wrapped(target, verdict_words(document["verdict"]), indent=2, style="bold")
    numbers = (
        ("stiffness", document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"], "N*m/arcmin"),
        ("drift per output turn", document["drift_rad_per_output_turn"], "arcmin"),
    )
    shown = [f"{label} {'-' if value is None else in_unit(value, unit)}" for label, value, unit in numbers]
    shown[0] = bounded(shown[0], document["stiffness_bound"])
    efficiency, life = document["efficiency"], document["life_hours"]
    shown.append(f"efficiency {'-' if efficiency is None else scaled(efficiency, 100.0) + ' %'}")
    shown.append(f"life {'-' if life is None else number(life) + ' h'}")
    print_wrapped(target, ", ".join(shown), indent=2)
    print_wrapped(target, f"torque capacity {_capacity(document)}", indent=2)
    ratio = number(abs(document["geometry"]["speed_ratio"]))
    mass, diameter = in_unit(document["mass_kg"], "kg"), in_unit(document["envelope_diameter_m"], "mm")
    print_wrapped(
        target, f"ratio {ratio}, mass of the rolling parts {mass}, outside diameter {diameter}", indent=2
    )
    target.print()


def _capacity(document: Document) -> str:
    """The torque capacity in the direction of the torque, what limits it, and where the joint that stands slips."""
    capacity, standing = document["torque_capacity"], document["standing_torque_capacity"]
    if document["standing"]["forces"]["output_torque_Nm"] < 0.0:
        capacity, standing = capacity["reverse"], standing["reverse"]
    torque, meaning = capacity["output_torque_Nm"], capacity["meaning"]
    text = meaning if torque is None else f"{in_unit(torque, 'N*m')} ({meaning})"
    same = torque is not None and torque == standing["output_torque_Nm"]
    return "; ".join(filter(None, [text, "" if same else standing_words(standing)]))


def temperatures(document: Document) -> str:
    """Working temperature of a joint with its preload at the assembly, as a second line of the heading; or nothing."""
    assembled, limits = (
        document["preload"]["at_assembly"],
        limit_words(document["preload"]["temperature_limits"]),
    )
    if assembled is None:
        return "".join(f"\n{limit}" for limit in limits)
    return (
        f"\nat {in_unit(assembled['working_temperature_degC'], 'degC')}; assembled at "
        f"{in_unit(assembled['temperature_degC'], 'degC')} with {in_unit(assembled['force_N'], 'N')} "
        f"({in_unit(assembled['interference_m'], 'um')})" + "".join(f", {limit}" for limit in limits)
    )


def loading_cam(document: Document) -> str:
    """What a loading cam does, as a line of the heading; or nothing."""
    cam = document["preload"]["loading_cam"]
    if cam is None:
        return ""
    return (
        f"\nloading cam: {in_unit(cam['least_preload_N'], 'N')} plus "
        f"{in_unit(cam['force_per_torque_N_per_Nm'], 'N/Nm')}, angle {in_unit(cam['angle_rad'], 'arcmin')} at the "
        "output"
    )


#: How the assumptions begin that are those of every joint.
OF_EVERY_JOINT = ("standing: ", "torque capacity, standing: ", "every track ", "rolling: steady", "life: ")


def show_assumptions(target: Console, document: Document, *, in_full: bool) -> None:
    """What is assumed: in full, or by name what the file leaves out and in full what is not so in every joint."""
    told = document["assumptions"]
    target.print(f"\nAssumptions{'' if in_full else ' (all in full with --all)'}", style="bold")
    left_out = [] if in_full else [sentence for sentence in told if sentence.startswith("no ")]
    if left_out:
        names = ", ".join(sentence.partition(":")[0].removeprefix("no ") for sentence in left_out)
        print_wrapped(target, f"  not in the file: {names}", indent=4)
    for sentence in told:
        if in_full or not (sentence in left_out or sentence.startswith(OF_EVERY_JOINT)):
            print_wrapped(target, f"  {sentence}", indent=4)


def show_warnings(target: Console, document: Document) -> None:
    """Every crossed limit, the most serious first, with what to do; the range of the published law is no limit."""
    crossed = crossed_limits(document, model=False)
    contacts = max(Counter(e["name"] for e in document["diagnostics"] if e["contact"]).values(), default=0)
    if not crossed:
        target.print("\nNo warnings: all limits are met", style="bold")
        return
    target.print("\nWarnings, most serious first", style="bold")
    for entries in crossed:
        first = entries[0]
        beside = first.get("state") or f"limit {first['limit_shown']}"
        _print_warning(target, f"{first['label']} {_values(entries, contacts)} ({beside})", entries)


def show_law_range(target: Console, document: Document) -> None:
    """Where the published contact law is outside its range, or nothing."""
    if words := law_range_words(document):
        print_wrapped(target, f"  {words}", indent=2)
        target.print()


def _print_warning(target: Console, heading: str, entries: list[Document]) -> None:
    target.print(
        textwrap.fill(f"  {heading[0].upper()}{heading[1:]}", target.width, subsequent_indent="  "),
        style="yellow",
        markup=False,
        soft_wrap=True,
    )
    for text in dict.fromkeys(entry["meaning"] for entry in entries):
        print_wrapped(target, f"    {text}", indent=4)
    for remedy in [entry["remedy"] for entry in entries if entry["remedy"]][:1]:
        print_wrapped(target, f"    What to do: {remedy}", indent=4)


def _values(entries: list[Document], contacts: int) -> str:
    """Values by contact, or one value where all contacts have the same."""
    values = [entry["shown"] for entry in entries]
    if len(entries) == contacts and len(set(values)) == 1:
        return f"{values[0]} at every contact"
    return ", ".join(
        f"{value} at {e['contact'].replace('_', ' ')}" if e["contact"] else value
        for value, e in zip(values, entries, strict=True)
    )


def show_branches(target: Console, branches: Document) -> None:
    """Print what unequal branches do to a joint: :func:`asperity.results.branch_document.branch_document`."""
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
    for label, text in (
        ("sun", _sun(branches, standing)),
        *(("centre", text) for text in _others(branches, standing or branches["without_torque"])),
    ):
        print_wrapped(target, f"  {label:<10} {text}", indent=13)


def _of(state: Document | None, name: str, index: int, factor: float) -> str:
    value = None if state is None else state[name][index]
    return "-" if value is None else number(factor * value, 3)


def _sun(unlike: Document, standing: Document | None) -> str:
    sun = (standing or unlike["without_torque"])["sun"]
    state = "standing" if standing else "without torque"
    force = f"bearing force {in_unit(force_size(unlike, sun['force_N']), 'N')} ({state})"
    if unlike["sun_support_stiffness_N_per_m"] is None:
        return f"{force}, held by its bearings"
    return f"{in_unit(math.hypot(*sun['displacement_m']), 'um')} off centre, {force}"


def _others(unlike: Document, state: Document) -> list[str]:
    """Forces on the other members on the axis, in words."""
    forces = state.get("central_forces_N", {})
    named = [
        f"{in_unit(force_size(unlike, force), 'N')} on the {name.replace('_', ' ')}"
        for name, force in forces.items()
    ]
    return [", ".join(named)] if named else []

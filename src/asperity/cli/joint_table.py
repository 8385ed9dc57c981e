"""A solved joint as tables to read."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from asperity.cli.document_text import (
    in_unit,
    number,
    print_wrapped,
    scaled,
    show_assumptions,
    show_branches,
    show_heading,
    show_law_range,
    show_verdict,
    show_warnings,
)
from asperity.cli.terminal import show_table
from asperity.joint.torque_limits import first_slip_words, may_carry_more
from asperity.results.document import (
    INTERVAL_HEADS,
    LAW_HEADS,
    NO_SHARE,
    budget_words,
    has_elastic_bodies,
    input_member,
    interval_rows,
    law_rows,
    level_words,
    stiffness_rows,
)

if TYPE_CHECKING:
    from rich.console import Console

Document = dict[str, Any]
Rows = tuple[tuple[str, str], ...]


def show_joint(target: Console, document: Document, *, source: str, in_full: bool) -> None:
    """Print what a joint document says."""
    show_heading(target, document, source)
    show_verdict(target, document)
    _show_stiffness(target, document)
    _show_drift(target, document)
    _show_contacts(target, document)
    _show_drive(target, document)
    _show_budget(target, document)
    show_warnings(target, document)
    show_assumptions(target, document, in_full=in_full)
    if "branches" in document:
        show_branches(target, document["branches"])


def _show_stiffness(target: Console, document: Document) -> None:
    keys = ("input_Nm_per_rad", "output_Nm_per_rad", "output_Nm_per_arcmin")
    show_table(
        target,
        "Torsional stiffness",
        ("model", f"{input_member(document)}\nN·m/rad", "output\nN·m/rad", "output\nN·m/arcmin"),
        ((words, *(number(level[key]) for key in keys)) for words, level in stiffness_rows(document)),
    )
    if document["stiffness_unknown_because"]:
        print_wrapped(target, f"no value: {document['stiffness_unknown_because']}", indent=2)
    if "pin_clearance_interval" in document:
        print_wrapped(target, f"  {document['pin_clearance_interval']['words']}", indent=2)
        target.print()
    show_law_range(target, document)
    if laws := law_rows(document, number):
        show_table(target, "Contact laws side by side", LAW_HEADS, laws)
    interval = document.get("stiffness_interval")
    if interval is None:
        return
    show_table(
        target,
        interval["title"],
        ("model", "output from\nN·m/rad", "output to\nN·m/rad"),
        (
            (meaning, *(number(interval[name][f"{end}_Nm_per_rad"]) for end in ("low", "high")))
            for name, meaning in level_words(document)
        ),
    )
    low, high = (interval["drift"][f"{end}_rad_per_output_turn"] for end in ("low", "high"))
    drift = f"  drift from {in_unit(low, 'arcmin')} to {in_unit(high, 'arcmin')} per output turn"
    print_wrapped(target, drift, indent=2)
    target.print()
    rows = interval_rows(interval)
    if rows:
        show_table(target, "Asperities of the contacts in this interval", INTERVAL_HEADS, rows)
    print_wrapped(target, f"  {interval['words']}", indent=2)
    target.print()


def _show_drift(target: Console, document: Document) -> None:
    """The other number of a joint that turns: its output lags turn by turn, which no stiffness says."""
    drift, loss = document["drift_rad_per_output_turn"], document["speed_loss"]
    if drift is None:
        text = "; ".join(document["rolling"]["unknown_because"])
    else:
        text = f"{in_unit(drift, 'arcmin')} per output turn ({scaled(loss, 100.0)} % of the speed): "
        text += "creep accumulates with every turn; the stiffness above holds at standstill"
    target.print("Drift in rolling", style="bold")
    print_wrapped(target, f"  {text}", indent=2)
    target.print()


def _show_contacts(target: Console, document: Document) -> None:
    contacts, forces = document["standing"]["contacts"], document["standing"]["forces"]
    slip = {
        entry["contact"]: entry["value"] for entry in document["diagnostics"] if entry["name"] == "slip_ratio"
    }
    columns = {
        "contact": list(contacts),
        "normal\nN": [number(forces["normal_N"][name]) for name in contacts],
        "tangential\nN": [number(forces["tangential_N"][name]) for name in contacts],
        "slip T/(mu N)\n-": [number(slip.get(name), 3) for name in contacts],
        "Hertz width\nmm": [scaled(contact["hertz_half_width_m"], 2e3) for contact in contacts.values()],
        "Hertz pressure\nMPa": [scaled(contact["hertz_pressure_Pa"], 1e-6) for contact in contacts.values()],
        "real area\nmm²": [scaled(contact["real_contact_area_m2"], 1e6) for contact in contacts.values()],
    }
    title = "Contact forces at standstill, under the torque"
    show_table(target, title, columns, zip(*columns.values(), strict=True))
    if any(contact.get("loaded_length_share") is not None for contact in contacts.values()):
        _show_crowns(target, contacts)
    springs = {
        "K_t asperities\nN/µm": "asperity_tangential",
        "K_t bodies\nN/µm": "bulk_tangential",
        "K_n asperities\nN/µm": "asperity_normal",
        "K_n bodies\nN/µm": "bulk_normal",
    }
    rows = (
        (
            name,
            *(scaled(contact[f"{spring}_stiffness_N_per_m"], 1e-6) for spring in springs.values()),
            number(contact["contact_torsional_stiffness_Nm_per_rad"]),
        )
        for name, contact in contacts.items()
    )
    show_table(target, "Contact stiffness", ("contact", *springs, "own K_T, asperities\nN·m/rad"), rows)


def _show_crowns(target: Console, contacts: Document) -> None:
    head = ("contact", "loaded length\n%", "peak over mean load\n-", "end over mean load\n-")
    rows = (
        (
            name,
            scaled(contact["loaded_length_share"], 100.0),
            number(contact["peak_line_load_ratio"], 3),
            number(contact["end_line_load_ratio"], 3),
        )
        for name, contact in contacts.items()
    )
    show_table(target, "Crowned contacts", head, rows)


def _show_drive(target: Console, document: Document) -> None:
    forces, standing = document["standing"]["forces"], document["standing_torque_capacity"]
    ends = (
        in_unit(torque, "N*m")
        for torque in (
            forces["output_torque_Nm"],
            forces["input_torque_Nm"],
            document["rolling"]["input_torque_Nm"],
        )
    )
    torque = "output {}; input {} without rolling losses, {} with all losses".format(*ends)
    common = (
        ("torque", torque),
        ("capacity", capacity_text(document["torque_capacity"])),
        ("standing", capacity_text(standing)),
        *(("first slip", text) for text in first_slip_words(standing)),
        ("rolling", _rolling_capacity(document)),
    )
    before, after = _drive_rows(document)
    target.print("Drive", style="bold")
    for label, text in (*before, *common, *after):
        print_wrapped(target, f"  {label:<10} {text}", indent=13)


def _drive_rows(document: Document) -> tuple[Rows, Rows]:
    """Rows of a drive before and after those of its torques."""
    geometry, forces = document["geometry"], document["standing"]["forces"]
    speed = in_unit(forces["output_speed_rad_per_s"], "rpm")
    members = "{} in, {} out, {} grounded".format(
        *(geometry[role].replace("_", " ") for role in ("input", "output", "grounded"))
    )
    masses = ", ".join(
        f"{name.replace('_', ' ')} {in_unit(mass, 'g')}" for name, mass in forces["body_mass_kg"].items()
    )
    pins = ", ".join(
        f"{name.replace('_', ' ')} radial {in_unit(force['radial'], 'N')}, tangential "
        f"{in_unit(force['tangential'], 'N')}"
        for name, force in forces["pin_N"].items()
    )
    before = [("members", members), ("speed", f"ratio {number(geometry['speed_ratio'])}, output {speed}")]
    if "wedge_angle_rad" in geometry:
        angles = ("alpha", "alpha_rad"), ("theta", "theta_rad"), ("wedge beta", "wedge_angle_rad")
        before.append(
            ("angles", ", ".join(f"{name} {in_unit(geometry[key], 'deg', 6)}" for name, key in angles))
        )
    after = [*((("pin force", f"standing, {pins}"),) if pins else ()), *_strength(document), ("mass", masses)]
    after += [
        ("roughness", _roughness(surface, of_all=len(document["surfaces"]) == 1))
        for surface in document["surfaces"]
    ]
    gaps = [entry for entry in geometry["clearances"] if entry["gap_m"] is not None]
    if gaps:
        gap = min(gaps, key=lambda entry: entry["gap_m"])
        after.append(
            ("clearance", f"smallest {in_unit(gap['gap_m'], 'mm')}, {gap['name'].replace('_', ' ')}")
        )
    return tuple(before), tuple(after)


def _strength(document: Document) -> list[tuple[str, str]]:
    """Lives of rated bearings, and safeties of the bodies that bend."""
    lives = [
        f"{bearing['bearing'].replace('_', ' ')} {number(hours)} h"
        for bearing in document["bearings"]
        if (hours := bearing["life_hours"]) is not None
    ]
    safeties = [
        f"{name.replace('_', ' ')}: yield safety {number(rim['yield_safety'])}"
        + ("" if rim["fatigue_safety"] is None else f", fatigue safety {number(rim['fatigue_safety'])}")
        for name, rim in document["rims"].items()
    ]
    rows = []
    if document["bearings"]:
        rows.append(("bearings", f"life L10: {', '.join(lives) or 'none'}; details: 'asperity loads'"))
    if safeties:
        rows.append(("rims", "; ".join(safeties)))
    return rows


def _roughness(surface: Document, *, of_all: bool) -> str:
    """Words for D and G of a surface, with the Ra that corresponds to them."""
    where = "" if of_all else f"{', '.join(surface['contacts'])}: "
    low, high = (in_unit(surface[f"roughness_average_{end}_m"], "um", 2) for end in ("low", "high"))
    return (
        f"{where}D {number(surface['fractal_dimension'])}, G {in_unit(surface['fractal_roughness_m'], 'mm', 3)} "
        f"correspond to Ra {in_unit(surface['roughness_average_m'], 'um', 2)} on each of two like bodies ({low} to "
        f"{high} when measured over 5 cut-offs of {in_unit(surface['cut_off_m'], 'mm')})"
    )


def _rolling_capacity(document: Document) -> str:
    """Words for the torque capacity in rolling, in the direction of the joint's torque."""
    capacity = document["rolling"]["torque_capacity_Nm"]
    if capacity is None:
        return "not limited by friction"
    if capacity <= 0.0:
        return "slips without a torque"
    at_least = " at least" if may_carry_more(document["standing_torque_capacity"], capacity) else ""
    return f"up to {in_unit(capacity, 'N*m')}{at_least} without gross slip"


def capacity_text(capacity: Document) -> str:
    """Torque capacity of both directions in words."""

    def one(entry: Document) -> str:
        torque = entry["output_torque_Nm"]
        return entry["meaning"] if torque is None else f"{in_unit(torque, 'N*m')}: {entry['meaning']}"

    reverse = capacity["reverse"]
    both = [entry["output_torque_Nm"] for entry in (capacity, reverse)]
    if both[0] == both[1] or (None not in both and math.isclose(*both, rel_tol=1e-9)):
        return f"{one(capacity)} (both directions)"
    return f"{one(capacity)}; reverse {one(reverse)}"


def _show_budget(target: Console, document: Document) -> None:
    """Where the assembly's compliance comes from, largest share first."""
    shares = []
    for name, share in document["stiffness_budget"].items():
        total = sum(share.values()) if isinstance(share, dict) and None not in share.values() else share
        if isinstance(total, float) and abs(total) > NO_SHARE:
            where = share if isinstance(share, dict) else {}
            shares.append((total, name.removesuffix("_share").replace("_", " "), where))
    target.print("\nCompliance of the assembly, by spring", style="bold")
    for total, name, where in sorted(shares, key=lambda entry: -entry[0]):
        parts = sorted(
            ((part, contact) for contact, part in where.items() if abs(part) > NO_SHARE), reverse=True
        )
        by_contact = (
            f" ({', '.join(f'{contact} {100.0 * part:.1f} %' for part, contact in parts)})" if parts else ""
        )
        print_wrapped(target, f"  {name} {100.0 * total:.1f} %{by_contact}", indent=4)
    if not shares:
        why = document["stiffness_unknown_because"] or "the joint transmits no torque"
        print_wrapped(target, f"  none: {why}", indent=2)
        return
    every = [part for total, _, where in shares for part in (where.values() or [total])]
    note = budget_words(every, elastic_bodies=has_elastic_bodies(document))
    if note:
        print_wrapped(target, f"  {note}", indent=2)

"""A solved joint as tables to read."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Any

from asperity.cli.terminal import table
from asperity.units import format_quantity

if TYPE_CHECKING:
    from rich.console import Console

Document = dict[str, Any]

_MODELS = (
    ("assembly", "assembled: asperities, bodies, floating planets, structure"),
    ("series_with_bulk", "asperities and bodies in series, centres held"),
    ("published", "as published, equation (25): asperities alone, an upper bound"),
)


def _number(value: float | None, digits: int = 4) -> str:
    return "-" if value is None else format_quantity(value, "1", digits)


def _scaled(value: float | None, factor: float) -> str:
    return "-" if value is None else _number(value * factor)


def _in(value: float | None, unit: str, digits: int = 4) -> str:
    return "-" if value is None else format_quantity(value, unit, digits)


def _count(number: float, word: str) -> str:
    return f"{_number(number)} {word}{'' if number == 1 else 's'}"


def _print_wrapped(target: Console, text: str, *, indent: int) -> None:
    target.print(
        textwrap.fill(text, target.width, subsequent_indent=" " * indent), markup=False, soft_wrap=True
    )


def show_joint(target: Console, document: Document, *, source: str) -> None:
    """Print what a joint document says.

    Parameters
    ----------
    target : Console
        Where to print.
    document : dict
        As :func:`asperity.joint.document.joint_document` makes it.
    source : str
        Name of the joint file.
    """
    drive, load = document["input"]["drive"], document["input"]["load"]
    target.print(
        f"{source}\n{_count(drive['planets'], 'planet')}, sun at {_in(load['sun_speed'], 'rpm')}, preload "
        f"{_in(load['preload'], 'N')}, output torque {_in(load['output_torque'], 'N*m')}\n",
        style="bold",
        markup=False,
    )
    _show_stiffness(target, document)
    _show_drift(target, document)
    _show_contacts(target, document)
    _show_drive(target, document)
    _show_budget(target, document)
    _show_warnings(target, document)
    target.print("\nAssumed", style="bold")
    for sentence in document["assumptions"]:
        _print_wrapped(target, f"  {sentence}", indent=4)


def _show_stiffness(target: Console, document: Document) -> None:
    shown = table(
        target, "Torsional stiffness", "model", "sun\nN·m/rad", "output\nN·m/rad", "output\nN·m/arcmin"
    )
    for name, meaning in _MODELS:
        entry = document["torsional_stiffness"][name]
        shown.add_row(
            meaning,
            _number(entry["sun_Nm_per_rad"]),
            _number(entry["output_Nm_per_rad"]),
            _number(entry["output_Nm_per_arcmin"]),
        )
    target.print(shown)
    if document["stiffness_unknown_because"]:
        _print_wrapped(target, f"no value: {document['stiffness_unknown_because']}", indent=2)
    interval = document.get("stiffness_interval")
    if interval is None:
        return
    measured = document["measured_surface"]
    spread = table(
        target,
        f"{interval['confidence']:.0%} interval from the measured surface "
        f"(D = {measured['fractal_dimension']:.3f}, G = {_in(measured['fractal_roughness_m'], 'mm')})",
        "model",
        "output from\nN·m/rad",
        "output to\nN·m/rad",
    )
    for name, meaning in _MODELS:
        spread.add_row(
            meaning, _number(interval[name]["low_Nm_per_rad"]), _number(interval[name]["high_Nm_per_rad"])
        )
    target.print(spread)
    if interval["outside"] or interval["unsolved"] or interval["all_plastic"]:
        _print_wrapped(
            target,
            f"of {_count(interval['draws'], 'draw')} of D and G, {interval['outside']} had a D outside 1 to 2, "
            f"{interval['unsolved']} had no solution and {interval['all_plastic']} had plastic spots only, where the "
            "contact law has no stiffness; these are left out, and from one draw in twenty on there is no interval",
            indent=2,
        )


def _show_drift(target: Console, document: Document) -> None:
    """The other number of a joint that turns: it falls behind, turn by turn, which no stiffness says."""
    drift, loss = document["drift_rad_per_output_turn"], document["speed_loss"]
    if drift is None:
        text = "; ".join(document["rolling"]["unknown_because"])
    else:
        text = f"{_in(drift, 'arcmin')} per output turn ({_scaled(loss, 100.0)} % of the speed): "
        text += "creep adds up with every turn, the stiffness above is for a joint that stands"
    target.print("Drift when it turns", style="bold")
    _print_wrapped(target, f"  {text}\n", indent=2)


def _show_contacts(target: Console, document: Document) -> None:
    contacts, forces = document["contacts"], document["forces"]
    slip = {
        entry["contact"]: entry["value"] for entry in document["diagnostics"] if entry["name"] == "slip_ratio"
    }
    shown = table(
        target,
        "Contact forces",
        "contact",
        "normal\nN",
        "tangential\nN",
        "slip T/(mu N)\n-",
        "Hertz width\nmm",
        "Hertz pressure\nMPa",
        "real area\nmm²",
    )
    for name, contact in contacts.items():
        shown.add_row(
            name,
            _number(forces["normal_N"][name]),
            _number(forces["tangential_N"][name]),
            _number(slip[name], 3),
            _scaled(contact["hertz_half_width_m"], 2e3),
            _scaled(contact["hertz_pressure_Pa"], 1e-6),
            _scaled(contact["real_contact_area_m2"], 1e6),
        )
    target.print(shown)
    shown = table(
        target,
        "Contact stiffness",
        "contact",
        "K_t asperities\nN/µm",
        "K_t bodies\nN/µm",
        "K_n asperities\nN/µm",
        "K_n bodies\nN/µm",
        "own K_T, asperities\nN·m/rad",
    )
    for name, contact in contacts.items():
        shown.add_row(
            name,
            *(
                _scaled(contact[f"{kind}_stiffness_N_per_m"], 1e-6)
                for kind in ("asperity_tangential", "bulk_tangential", "asperity_normal", "bulk_normal")
            ),
            _number(contact["contact_torsional_stiffness_Nm_per_rad"]),
        )
    target.print(shown)


def _show_drive(target: Console, document: Document) -> None:
    geometry, forces = document["geometry"], document["forces"]
    capacity = document["torque_capacity"]
    gap = min(geometry["clearances"], key=lambda entry: entry["gap_m"])
    target.print("Drive", style="bold")
    for label, text in (
        (
            "angles",
            f"alpha {_in(geometry['alpha_rad'], 'deg', 6)}, theta {_in(geometry['theta_rad'], 'deg', 6)}, "
            f"wedge beta {_in(geometry['wedge_angle_rad'], 'deg', 6)}",
        ),
        (
            "speed",
            f"ratio {_number(geometry['speed_ratio'])}, carrier {_in(forces['carrier_speed_rad_per_s'], 'rpm')}",
        ),
        (
            "torque",
            f"in {_in(forces['input_torque_Nm'], 'N*m')}, out {_in(forces['output_torque_Nm'], 'N*m')}",
        ),
        (
            "capacity",
            capacity["meaning"]
            if capacity["output_torque_Nm"] is None
            else f"{_in(capacity['output_torque_Nm'], 'N*m')}: {capacity['meaning']}",
        ),
        (
            "pin force",
            f"left {_in(forces['pin_N']['left'], 'N')}, right {_in(forces['pin_N']['right'], 'N')}",
        ),
        (
            "mass",
            f"planet {_in(forces['planet_mass_kg'], 'g')}, loading roller {_in(forces['loading_roller_mass_kg'], 'g')}",
        ),
        ("clearance", f"at least {_in(gap['gap_m'], 'mm')}: {gap['condition']}"),
    ):
        _print_wrapped(target, f"  {label:<10} {text}", indent=13)


def _show_budget(target: Console, document: Document) -> None:
    """Where the assembly's compliance comes from, largest share first."""
    shares = []
    for name, share in document["stiffness_budget"].items():
        total = sum(share.values()) if isinstance(share, dict) and None not in share.values() else share
        if isinstance(total, float) and total > 0.0:
            shares.append((total, name.removesuffix("_share").replace("_", " ")))
    listed = ", ".join(f"{name} {100.0 * total:.1f} %" for total, name in sorted(shares, reverse=True))
    target.print("\nCompliance of the assembly, by spring", style="bold")
    _print_wrapped(target, f"  {listed or 'none: the joint passes no torque'}", indent=2)


def _show_warnings(target: Console, document: Document) -> None:
    """Every crossed limit, the most serious first, with what to do; limits of the model alone make one line."""
    crossed: dict[str, list[Document]] = {}
    for entry in document["diagnostics"]:
        if not entry["ok"]:
            crossed.setdefault(entry["name"], []).append(entry)
    if not crossed:
        target.print("\nNo warnings: every limit of the model is kept", style="bold")
        return
    target.print("\nWarnings, the most serious first", style="bold")
    model = [entries for entries in crossed.values() if entries[0]["severity"] == "model"]
    for entries in crossed.values():
        if entries[0]["severity"] != "model":
            first = entries[0]
            _print_warning(
                target, f"{first['label']} {_values(entries)} (limit {_number(first['limit'])})", entries
            )
    if model:
        parts = [f"{entries[0]['label']} up to {_largest(entries)}" for entries in model]
        _print_warning(target, f"contact law outside its range: {', '.join(parts)}", model[0], meaning=False)


def _print_warning(target: Console, heading: str, entries: list[Document], *, meaning: bool = True) -> None:
    target.print(
        textwrap.fill(f"  {heading[0].upper()}{heading[1:]}", target.width, subsequent_indent="  "),
        style="yellow",
        markup=False,
        soft_wrap=True,
    )
    if meaning:
        for text in dict.fromkeys(entry["meaning"] for entry in entries):
            _print_wrapped(target, f"    {text}", indent=4)
    _print_wrapped(target, f"    What to do: {entries[0]['remedy']}", indent=4)


def _values(entries: list[Document]) -> str:
    """Values by contact, or one value where all contacts have the same."""
    values = [_number(entry["value"]) for entry in entries]
    if len(entries) == 5 and len(set(values)) == 1:
        return f"{values[0]} at every contact"
    return ", ".join(
        f"{value} at {e['contact']}" if e["contact"] else value
        for value, e in zip(values, entries, strict=True)
    )


def _largest(entries: list[Document]) -> str:
    values = [entry["value"] for entry in entries if entry["value"] is not None]
    return _number(max(values), 3) if values else "-"

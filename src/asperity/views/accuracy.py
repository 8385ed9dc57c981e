"""The accuracy of a joint over a turn: components by order, contacts, both directions, turns without a reference."""

from __future__ import annotations

import math
from collections.abc import Iterator

from asperity.types import Document
from asperity.views.blocks import Block, Figure, Figures, Paragraph, Table
from asperity.views.numbers import NONE, number, quantity, unit_words, words

_ARCSECONDS, _ARCMINUTES = 648000.0 / math.pi, 10800.0 / math.pi


def accuracy(document: Document) -> Iterator[Block]:
    """Everything about a joint with form errors over a turn."""
    found = document["accuracy"]
    yield _headline(document)
    yield _orders(found)
    yield _contacts(found, "Contacts over a turn")
    if "reverse" in found:
        yield _directions(found)
        yield _contacts(found["reverse"], "Contacts over a turn in the other direction")
    yield Paragraph(" ".join(_notes(document)))


def _headline(document: Document) -> Figures:
    """The numbers that are asked for first."""
    found = document["accuracy"]
    error, torque = found["transmission_error_rad"], found["input_torque_Nm"]
    items = [
        _figure(
            "transmission error", _rounded(error["worst"]), "arcsec", "worst over all phases, to either side"
        ),
        _figure(
            "transmission error, rms", _rounded(error["rms"]), "arcsec", "root mean square over all phases"
        ),
        _figure(
            "drift",
            _rounded(found["drift_rad_per_output_turn"]),
            "arcmin",
            "per turn of the output, by creep",
        ),
        _figure(
            "input torque",
            _rounded(torque["worst"]),
            "mN*m",
            f"by which it swings about {quantity(_rounded(torque['mean']), 'N*m')} at worst",
        ),
    ]
    homing = found.get("homing")
    if homing is not None:
        turns = homing["turns"]
        items.append(
            Figure(
                "turns without a reference",
                number(turns, digits=3) if turns is not None else "any number",
                "",
                f"of the output, until its drift may have passed {quantity(homing['allowed_rad'], 'arcmin')}"
                if turns is not None
                else "the output does not drift",
                turns,
            )
        )
    return Figures(items)


def _figure(name: str, value: float, unit: str, detail: str) -> Figure:
    return Figure(name, quantity(value, unit).partition(" ")[0], unit_words(unit), detail, value)


def _groups(components: list[Document]) -> list[list[Document]]:
    """Components of one part and harmonic with one size together: those of the sectors."""
    groups: dict[tuple[object, ...], list[Document]] = {}
    for one in components:
        size = float(f"{one['transmission_error_rad']:.4g}")
        groups.setdefault((one["part"], one["harmonic"], one["amplitude_m"], size), []).append(one)
    return sorted(groups.values(), key=lambda group: -len(group) * group[0]["transmission_error_rad"])


def _orders(found: Document) -> Table:
    """Every harmonic, the one that the transmission error has most of first."""
    rows = []
    for group in _groups(found["components"]):
        one = group[0]
        force = max(map(float, one["normal_N"].values()))
        # the first of those that symmetry makes alike
        contact = next(name for name, size in one["normal_N"].items() if size >= (1.0 - 1e-6) * force)
        rows.append(
            (
                words(one["part"]) + _of_sectors(group),
                str(one["harmonic"]),
                number(one["amplitude_m"], 1e6),
                number(one["order"]),
                number(_rounded(one["transmission_error_rad"]), _ARCSECONDS),
                number(_rounded(one["input_torque_Nm"]), 1e3),
                number(_rounded(force)),
                words(contact) if _rounded(force) else NONE,
            )
        )
    head = (
        "part",
        "waves",
        "amplitude\nµm",
        "order\nper turn",
        "transmission error\narcsec",
        "input torque\nmN·m",
        "largest change\nof a force, N",
        "in contact",
    )
    return Table("Form errors by order, amplitudes of each", head, rows, words=(0, 7))


def _rounded(value: float) -> float:
    """A number [SI], 0 where symmetry, or no torque, leaves no more than rounding errors."""
    return 0.0 if abs(value) < 1e-12 else value


def _of_sectors(group: list[Document]) -> str:
    """Of which sectors a group of components is."""
    sectors = [one["sector"] for one in group if one["sector"] is not None]
    if not sectors:
        return ""
    return f" (each of {len(sectors)})" if len(sectors) > 1 else f" (sector {sectors[0]})"


def _contacts(found: Document, title: str) -> Table:
    """Forces and slip of every contact."""
    rows = [
        (
            words(name),
            number(contact["normal_N"]["mean"]),
            number(_rounded(contact["normal_N"]["worst"])),
            number(_rounded(contact["normal_N"]["rms"])),
            number(_traction(contact)),
            number(_rounded(contact["tangential_N"]["worst"])),
            number(_rounded(contact["slip_ratio"]["mean"])),
            number(contact["slip_ratio"]["mean"] + contact["slip_ratio"]["worst"]),
            "may slip" if contact["may_slip"] else "",
        )
        for name, contact in found["contacts"].items()
    ]
    head = (
        "contact",
        "normal force\nN",
        "worst change\nN",
        "rms\nN",
        "tangential force\nN",
        "worst change\nN",
        "slip ratio\n-",
        "at worst\n-",
        "",
    )
    return Table(title, head, rows, words=(0, 8))


def _traction(contact: Document) -> float:
    """The steady tangential force of a contact [N], 0 where rounding errors are all of it."""
    return float(contact["tangential_N"]["mean"]) if _rounded(contact["slip_ratio"]["mean"]) else 0.0


def _directions(found: Document) -> Table:
    """Transmission error of each harmonic in both directions, and their difference."""
    both = found["bidirectional_error_rad"]
    reverse = found["reverse"]
    rows = [
        (
            name,
            number(_rounded(one["worst"]), _ARCSECONDS),
            number(_rounded(one["rms"]), _ARCSECONDS),
        )
        for name, one in (
            ("in the direction of the file", found["transmission_error_rad"]),
            ("in the other one, under the same torque", reverse["transmission_error_rad"]),
            ("difference at the same position", both),
        )
    ]
    lost, repeats = found["lost_motion_rad"], found["bidirectional_repeatability_rad"]
    if lost is not None:
        rows += [
            ("lost motion of the wind-up", number(lost, _ARCSECONDS), NONE),
            ("bidirectional repeatability: both together", number(repeats, _ARCSECONDS), NONE),
        ]
    return Table(
        "Transmission error in both directions",
        ("direction", "worst\narcsec", "rms\narcsec"),
        rows,
        words=(0,),
    )


def _notes(document: Document) -> Iterator[str]:
    """For what the numbers hold."""
    found = document["accuracy"]
    yield (
        "Worst and rms are those over all phases that are not stated. Runout counts with half of its reading. The "
        "numbers are of first order in the form errors and quasi-static: of waves that are slow against the natural "
        "frequencies ('asperity dynamics')."
    )
    if any(contact["may_slip"] for contact in found["contacts"].values()):
        yield (
            "'may slip': if the phases meet, the contact passes its friction within a turn; the worst sum is not cut "
            "off there. State smaller form errors, a lower torque or a larger preload."
        )
    yield (
        "Drift is no part of the transmission error: it adds up with every turn under a torque of one sense, forwards "
        "and backwards; of a torque that turns with the rotation, such as friction, a return takes it back."
    )
    if "reverse" in found and found["lost_motion_rad"] is None:
        yield (
            "The lost motion of the wind-up is not known: there is no torque, or the joint does not stand under it in "
            "both directions. Repeatability has it besides."
        )
    elif "reverse" in found:
        yield "The lost motion is that of the middle line of 'asperity windup' under this torque."

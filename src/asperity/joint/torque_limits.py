"""Torque capacity of a joint that stands or rolls: its first slip, lift-off or width; damage does not count (A9)."""

from __future__ import annotations

import math

from asperity.drive.state.first_limit import FirstLimit
from asperity.engine.arrays import entry_of
from asperity.engine.module import Module
from asperity.types import Array, Document
from asperity.units import format_quantity

#: Kinds of limits, by the codes of :class:`TorqueCapacity`.
LIMIT_KINDS = (
    "none",
    "pins_lock",
    "gross_slip",
    "lift_off",
    "contact_too_wide",
    "no_solution",
    "wall_too_thin",
)

#: Those of them that end what is computed, not what the joint can do: its own capacity is not less.
MODEL_LIMITS = ("contact_too_wide", "wall_too_thin")

_SAME = 1e-6  # relative difference of torques that are said to be the same

_PER_CONTACT = ("gross_slip", "lift_off", "contact_too_wide")  # these have a limit for each contact


class TorqueCapacity(Module):
    """How much torque a preloaded joint can pass in one direction.

    Parameters
    ----------
    output_torque : Array
        Largest output torque that keeps every limit [N·m]; infinite where none is ever reached, 0 where one is
        reached without any torque.
    limit : Array
        Code of the first limit in :data:`LIMIT_KINDS`.
    limiting_contact : Array
        Number of the contact that reaches it; that of contacts for a limit that is not a contact's.
    """

    output_torque: Array
    limit: Array
    limiting_contact: Array


def limit_entries(*, contacts: int, walls: bool = False) -> tuple[tuple[str, int], ...]:
    """Kind and contact of every limit of a number of contacts, in the order of their excesses.

    The number of contacts for a limit that is not a contact's; ``walls``: whether the walls at the contacts have one.
    """
    limits_of_contact = (*_PER_CONTACT, "wall_too_thin") if walls else _PER_CONTACT
    return (
        ("pins_lock", contacts),
        *((name, contact) for name in limits_of_contact for contact in range(contacts)),
        ("no_solution", contacts),
    )


def named_capacity(
    limit: FirstLimit, entries: tuple[tuple[str, int], ...], *, contacts: int
) -> TorqueCapacity:
    """The capacity with its kind of limit and contact, from the first of many limits, :func:`limit_entries`."""
    kinds, places = zip(("none", contacts), *entries, strict=True)
    return TorqueCapacity(
        output_torque=limit.value,
        limit=entry_of([LIMIT_KINDS.index(kind) for kind in kinds], 1 + limit.which),
        limiting_contact=entry_of(places, 1 + limit.which),
    )


def limit_words(capacity: TorqueCapacity, *, contacts: tuple[str, ...]) -> str:
    """What limits the capacity of one joint in one direction, for example "contact sp slips"."""
    return kind_words(LIMIT_KINDS[int(capacity.limit)], (*contacts, "none")[int(capacity.limiting_contact)])


def kind_words(kind: str, contact: str) -> str:
    """What happens where a limit of :data:`LIMIT_KINDS` is reached, at the contact of a name."""
    texts = {
        "none": "no limit is reached at any torque",
        "gross_slip": f"contact {contact} slips",
        "lift_off": f"contact {contact} lifts off",
        "contact_too_wide": f"contact {contact} becomes too wide for line-contact theory",
        "wall_too_thin": f"the wall at contact {contact} is five of its half-widths thick, the least that exact bodies "
        "are computed with",
        "pins_lock": "the pins of the loading rollers lock",
        "no_solution": "the force balance has no solution",
    }
    return texts[kind]


def capacity_document(
    capacity: TorqueCapacity, *, contacts: tuple[str, ...], first_slip: TorqueCapacity | None = None
) -> Document:
    """The capacity of one joint in one direction as a part of a JSON document [N·m]."""
    torque, contact = float(capacity.output_torque), int(capacity.limiting_contact)
    at_least = LIMIT_KINDS[int(capacity.limit)] in MODEL_LIMITS
    document: Document = {
        "output_torque_Nm": torque if math.isfinite(torque) else None,
        "limit": LIMIT_KINDS[int(capacity.limit)],
        "limiting_contact": contacts[contact] if contact < len(contacts) else None,
        "meaning": limit_words(capacity, contacts=contacts)
        + ("; the joint may carry more" if at_least else ""),
        "is_lower_bound": at_least,
    }
    if first_slip is not None and LIMIT_KINDS[int(first_slip.limit)] == "gross_slip":
        document["first_slip"] = {
            "output_torque_Nm": float(first_slip.output_torque),
            "contact": contacts[int(first_slip.limiting_contact)],
        }
    return document


def first_slip_words(both: Document) -> list[str]:
    """Where a contact slides while others carry the rest; none where the first slip is the capacity."""
    early = [
        (entry["first_slip"]["contact"], format_quantity(entry["first_slip"]["output_torque_Nm"], "N*m"))
        for entry in (both, both["reverse"])
        if "first_slip" in entry
        and entry["first_slip"]["output_torque_Nm"]
        < (1.0 - _SAME) * (math.inf if entry["output_torque_Nm"] is None else entry["output_torque_Nm"])
    ]
    if len(early) < 2:
        return [f"{torque} at {contact}; others carry the rest" for contact, torque in early]
    (contact, torque), (other, back) = early
    way = "" if (contact, torque) == (other, back) else f" (reverse {other})"
    if back != torque:
        way = f" (reverse {back} at {other})"
    return [f"{torque} at {contact}{way}; others carry the rest"]


def standing_words(standing: Document) -> str:
    """Up to which torque one joint stands, whatever damage it does: of one direction of its document; or nothing.

    For a line behind the torque capacity itself, which may be less.
    """
    torque, kind = standing["output_torque_Nm"], standing["limit"]
    if kind == "none":
        return "standing, no contact slips at any torque"
    what = {"gross_slip": "gross slip", "lift_off": "lift-off"}.get(kind)
    return "" if what is None else f"{what} at {format_quantity(torque, 'N*m')} standing"

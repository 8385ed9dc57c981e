"""The wind-up of a joint whose input is locked, and what becomes of it once the input turns."""

from __future__ import annotations

import math
from collections.abc import Iterator

from asperity.joint.pin_bound import bounded
from asperity.joint.torque_limits import first_slip_words
from asperity.results.stiffness_rows import LEVEL_NAMES
from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.joint import capacity_text
from asperity.views.numbers import number, number_in, percent, quantity, words


def windup(document: Document) -> Iterator[Block]:
    """The figures of a document of a wind-up, its stages, and the joint that turns under the largest torque."""
    whose = ", of its own branches" if document["of_own_branches"] else ""
    level = bounded(f"{LEVEL_NAMES[document['level']]}{whose}", document["stiffness_bound"])
    yield Paragraph(f"Wind-up at the output, input locked, {level}.", strong=True)
    same = math.isclose(document["windup_rad"], document["reverse_windup_rad"], rel_tol=1e-9)
    yield _figures(document, same)
    yield _stages(document, same)
    yield from _turning(document, same)


def _figures(document: Document, same: bool) -> Table:
    capacity = document["standing_torque_capacity"]
    if same:
        angles = [("angle at the largest torque", quantity(document["windup_rad"], "arcmin"))]
    else:
        angles = [
            ("angle at plus the largest torque", quantity(document["windup_rad"], "arcmin")),
            ("angle at minus the largest torque", quantity(-document["reverse_windup_rad"], "arcmin")),
        ]
    rows = [
        ("torque capacity, standing", capacity_text(capacity)),
        *(("first slip, standing", text) for text in first_slip_words(capacity)),
        ("largest torque of the curve", quantity(document["largest_torque_Nm"], "N*m")),
        *angles,
        ("hysteresis (width of the loop at zero torque)", quantity(document["hysteresis_rad"], "arcmin")),
        (
            "lost motion (middle of the loop, between ±3 % of the torque)",
            quantity(document["lost_motion_rad"], "arcmin"),
        ),
        ("energy lost per cycle", f"{number(document['dissipated_energy_J'])} J"),
    ]
    return Table("Figures of the wind-up", ("quantity", "value"), rows, words=(0, 1))


def _stages(document: Document, same: bool) -> Table:
    """The secant stiffness of the three stages of the loading curve, with what bounds it."""
    bound = document["stiffness_bound"]
    title = f"Stages of the loading curve (secant stiffness{f'; {bound}' if bound else ''})"
    head = ["stage", "from\nN·m", "to\nN·m", "stiffness\nN·m/rad", "stiffness\nN·m/arcmin"]
    head += [] if same else ["reverse\nN·m/rad", "reverse\nN·m/arcmin"]
    rows = []
    for stage in document["stages"]:
        cells = [stage["name"], number(stage["from_Nm"]), number(stage["to_Nm"])]
        for key in ("stiffness_Nm_per_rad", "reverse_stiffness_Nm_per_rad")[: 1 if same else 2]:
            cells += [number_in(stage[key], unit) for unit in ("N*m/rad", "N*m/arcmin")]
        rows.append(tuple(cells))
    return Table(title, tuple(head), rows)


def _turning(document: Document, same: bool) -> Iterator[Block]:
    """Up to which angle the static curve holds, and what follows it."""
    turning = document["rolling"]
    torque = quantity(document["largest_torque_Nm"], "N*m")
    if turning["unknown_because"]:
        yield Paragraph(f"When the input turns under {torque}: {turning['unknown_because'][0]}.")
        return
    ways = [turning] if same or turning["reverse"]["unknown_because"] else [turning, turning["reverse"]]
    head = ("", "input\ndeg", "output\ndeg", "input, reverse\ndeg", "output, reverse\ndeg")[
        : 1 + 2 * len(ways)
    ]
    share = percent(turning["creep_share_of_windup"])
    rows = [
        (said, *(number_in(way[key][side], "deg") for way in ways for side in ("input_rad", "output_rad")))
        for key, said in (
            ("static_curve_up_to", f"static curve holds up to (creep {share} of the wind-up)"),
            ("steady_creep_from", "steady creep from (every contact has rolled its width)"),
            ("swing_without_drift", "largest swing to and fro without lasting drift"),
        )
    ]
    yield Table(f"When the input turns under {torque}", head, rows)
    drifts = " and, reverse, ".join(quantity(way["drift_rad_per_output_turn"], "arcmin") for way in ways)
    yield Paragraph(f"In steady rolling the output drifts by {drifts} per output turn.")
    yield _contacts(turning)
    yield Paragraph(
        "Stiffness and drift are two regimes. The wind-up is elastic and comes back when the torque is taken off. The "
        "drift grows with every angle turned under torque, in either direction; turning back does not recover it."
    )


def _contacts(turning: Document) -> Table:
    head = ("contact", "width\nµm", "rolled by it after,\ninput deg", "output\ndeg", "share of the drift\n%")
    rows = [
        (
            words(name),
            number_in(contact["width_m"], "um"),
            *(number_in(contact["rolls_its_width_in"][side], "deg") for side in ("input_rad", "output_rad")),
            number(contact["share_of_drift"], 100.0),
        )
        for name, contact in turning["contacts"].items()
    ]
    return Table("Contacts of the joint that begins to turn", head, rows)

"""Torsional stiffness on every level, what bounds it, and where the compliance comes from."""

from __future__ import annotations

import math
from collections.abc import Iterator

from asperity.joint.pin_bound import bounded
from asperity.results.document import NO_SHARE, budget_words, crossed_limits
from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.joint import input_member
from asperity.views.numbers import number, number_in, percent, quantity, sentence, words
from asperity.views.solved_view import SolvedView

#: Share of a spring below which a contact is not named beside it.
_NAMED = 5e-4

#: Levels of the torsional stiffness, the fullest model first, in words that are true for every type of drive.
LEVEL_WORDS = (
    ("assembly", "assembled: all springs, rollers free"),
    ("series_with_bulk", "bodies in series: asperities and bodies, centres fixed"),
    ("published", "asperities alone, as published by Zou et al. 2025: an upper bound"),
)
_LEVEL_HEAD = ("level of the model", "output\nN·m/arcmin", "output\nN·m/rad")
_SPRINGS = {
    "tangential": "contacts, tangential",
    "normal": "contacts, normal (rollers free to move)",
    "ring_bending": "ring, compliance.ring_bending_stiffness",
    "pin": "carrier pins",
    "planet_support": "supports of rollers without a pin",
    "input_shaft": "input shaft",
    "output_shaft": "output shaft",
    "loading_cam": "loading cam",
}


def stiffness(view: SolvedView, *, in_full: bool = True) -> Iterator[Block]:
    """Stiffness on every level, with what bounds it; in full also beside the drift of a joint that turns."""
    document = view.document
    keys = ("output_Nm_per_arcmin", "output_Nm_per_rad", "input_Nm_per_rad")
    yield Table(
        "Torsional stiffness",
        (*_LEVEL_HEAD, f"{input_member(document)}\nN·m/rad"),
        [(said, *(number(level[key]) for key in keys)) for said, level in _levels(document)],
    )
    if document["stiffness_unknown_because"]:
        yield Paragraph(f"No value: {document['stiffness_unknown_because']}.")
    if "pin_clearance_interval" in document:
        yield Paragraph(sentence(document["pin_clearance_interval"]["words"]))
    if said := law_range_words(document, brief=not in_full):
        yield Paragraph(sentence(said))
    if in_full:
        yield _drift(document)
    yield from _laws(document)
    yield from _interval(document)


def _levels(document: Document) -> list[tuple[str, Document]]:
    """Words and stiffness of each level of a joint of any drive, the fullest first.

    Of a joint with a loading cam also of the assembly whose cam is held by its friction.
    """
    rows = [(said, document["torsional_stiffness"][level]) for level, said in level_words(document)]
    cam = document["preload"]["loading_cam"]
    if cam is not None:
        output = cam["held_stiffness_output_Nm_per_rad"]
        squared = document["geometry"]["speed_ratio"] ** 2
        held = {
            "input_Nm_per_rad": None if output is None else output / squared,
            "output_Nm_per_rad": output,
            "output_Nm_per_arcmin": None if output is None else output * math.pi / 10800.0,
        }
        rows.append(
            (bounded("assembled, loading cam held by its friction", document["stiffness_bound"]), held)
        )
    return rows


def level_words(document: Document) -> list[tuple[str, str]]:
    """Levels of the torsional stiffness in words, the fullest first, with what bounds that of this joint."""
    (fullest, said), *others = LEVEL_WORDS
    return [(fullest, bounded(said, document["stiffness_bound"])), *others]


def law_range_words(document: Document, *, brief: bool = False) -> str:
    """Where the published contact law is outside its range, which concerns the level of the asperities alone; or ""."""
    known = (
        [entry for entry in entries if entry["known"]] for entries in crossed_limits(document, model=True)
    )
    crossed = [entries for entries in known if entries]
    if not crossed:
        return ""
    parts = ", ".join(f"{entries[0]['label']} {_largest(entries)}" for entries in crossed)
    remedies = [entry["remedy"] for entries in crossed for entry in entries if entry["remedy"]]
    advice = [remedy.partition(";")[0] if brief else remedy for remedy in remedies[:1]]
    return "; ".join([f"asperities alone: outside the range of this law, {parts}", *advice])


def _largest(entries: list[Document]) -> str:
    if any(entry.get("infinite") for entry in entries):
        return "infinite"
    return f"up to {max(entries, key=lambda entry: entry['value'])['shown']}"


def _drift(document: Document) -> Paragraph:
    """The other number of a joint that turns: its output lags turn by turn, which no stiffness says."""
    drift = document["drift_rad_per_output_turn"]
    if drift is None:
        return Paragraph(sentence(f"drift: {'; '.join(document['rolling']['unknown_because'])}"), strong=True)
    return Paragraph(
        f"Beside every stiffness: the output drifts by {quantity(drift, 'arcmin')} in each of its turns under this "
        f"torque ({percent(document['speed_loss'])} of the speed). The wind-up comes back, the drift does not.",
        strong=True,
    )


def _laws(document: Document) -> Iterator[Block]:
    """Stiffness and drift by every contact law that the surfaces allow."""
    entries = document.get("contact_laws", ())
    if not entries:
        return
    rows = [
        (
            entry["law"],
            number(entry["assembly_Nm_per_rad"]),
            number_in(entry["drift_rad_per_output_turn"], "arcmin"),
            " to ".join(f"{end:g}" for end in entry["over_boundary_elements"]),
            "used here" if entry["used"] else "",
        )
        for entry in entries
    ]
    head = ("law", "assembled, output\nN·m/rad", "drift per turn\narcmin", "over boundary\nelements", "")
    yield Table("Contact laws side by side", head, rows, words=(0, 4))
    yield Paragraph(
        "Over boundary elements: how stiff a contact is by this law, over the same computed by boundary elements on "
        "measured surfaces."
    )


def _interval(document: Document) -> Iterator[Block]:
    """Interval of stiffness and drift over what is open of the surfaces, drawn or measured."""
    interval, ends = document.get("stiffness_interval"), ("low", "high")
    if interval is None:
        return
    yield Table(
        interval["title"],
        ("level of the model", "output from\nN·m/rad", "output to\nN·m/rad"),
        [
            (said, *(number(interval[level][f"{end}_Nm_per_rad"]) for end in ends))
            for level, said in level_words(document)
        ],
    )
    drift = [interval["drift"][f"{end}_rad_per_output_turn"] for end in ends]
    if drift != [None, None]:
        low, high = (quantity(angle, "arcmin") for angle in drift)
        yield Paragraph(f"Drift from {low} to {high} per output turn.")
    if rows := _interval_rows(interval):
        yield Table("Asperities of the contacts in this interval", _INTERVAL_HEADS, rows)
    yield Paragraph(interval["words"])
    if "run_in" in interval:
        yield Paragraph(interval["run_in"]["words"])


_INTERVAL_HEADS = (
    "contact",
    "normal, both\nN/µm",
    "normal, law alone\nN/µm",
    "normal, heights alone\nN/µm",
    "tangential, both\nN/µm",
)


def _interval_rows(interval: Document) -> list[tuple[str, ...]]:
    """Ends of the asperities' stiffnesses by the errors of contact law and heights, one row for each contact."""

    def cell(ends: list[float]) -> str:
        return " to ".join(number(end, 1e-6, digits=3) for end in ends)

    rows = []
    for name, contact in interval.get("contacts", {}).items():
        normal, tangential = (
            contact[f"asperity_{direction}_stiffness_N_per_m"] for direction in ("normal", "tangential")
        )
        parts = [normal[part] for part in ("both", "contact_law", "rms_height")]
        rows.append((words(name), *(cell(ends) for ends in (*parts, tangential["both"]))))
    return rows


def budget(document: Document) -> Iterator[Block]:
    """Where the assembly's compliance comes from, largest share first."""
    shares = []
    for name, share in document["stiffness_budget"].items():
        total = sum(share.values()) if isinstance(share, dict) and None not in share.values() else share
        if isinstance(total, float) and abs(total) > NO_SHARE:
            spring = name.removesuffix("_share")
            shares.append(
                (total, _SPRINGS.get(spring, words(spring)), share if isinstance(share, dict) else {})
            )
    title = "Compliance of the assembled joint, by spring"
    if not shares:
        why = document["stiffness_unknown_because"] or "the joint transmits no torque"
        yield Paragraph(sentence(f"{title}: none, {why}"))
        return
    shares.sort(key=lambda entry: -entry[0])
    rows = [(spring, number(total, 100.0), _by_contact(where, total)) for total, spring, where in shares]
    head = ("spring", "share\n%", "by contact\n% of the whole")
    yield Table(title, head, rows, words=(0, 2), shares=[entry[0] for entry in shares])
    every = [part for total, _, where in shares for part in (where.values() or [total])]
    if note := budget_words(
        every, elastic_bodies=(document["input"].get("model") or {}).get("bodies") != "springs"
    ):
        yield Paragraph(sentence(note))


def _by_contact(where: dict[str, float], total: float) -> str:
    """The contacts of a spring of this share with theirs in percent of the whole, largest first."""
    named = ((part, name) for name, part in where.items() if abs(part) >= _NAMED * abs(total))
    parts = sorted(named, reverse=True)
    return ", ".join(f"{words(name)} {number(part, 100.0, digits=3)}" for part, name in parts)

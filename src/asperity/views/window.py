"""The window of a joint: whether its loads lie inside, what limits the torque where, and the numbers over the axis."""

from __future__ import annotations

import math
from collections.abc import Iterator

from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import number, number_in, percent, quantity, unit_words

#: Display unit of the axis → end of the keys of the document.
_KEYS = {"degC": "degC", "N": "N", "um": "m"}
#: About so many rows of the table over the axis; documents and CSV files have all of them.
_MOST_ROWS = 14


def window(document: Document) -> Iterator[Block]:
    """Everything about the window of a document: verdict, loads, what governs where, and the capacity over the axis."""
    yield from window_summary(document)
    yield _over_axis(document)
    yield Paragraph(" ".join(_notes(document)))


def window_summary(document: Document) -> Iterator[Block]:
    """What a picture of the window needs beside it: the verdict, the loads, and what governs where."""
    verdict = document["verdict"]
    yield Paragraph(f"{verdict['title']}.", strong=True, passed=verdict["inside"])
    yield Paragraph(verdict["words"])
    yield _loads(document)
    yield _governing(document)


def _loads(document: Document) -> Table:
    """Every load with what the joint passes in its direction at its speed, where the joint works."""
    tolerances = document["has_tolerances"]
    head: tuple[str, ...] = ("load", "torque\nN·m", "input\nrpm", "capacity\nN·m", "used", "what limits it")
    head += ("inside with\ntolerances",) if tolerances else ()
    rows = []
    for load in document["loads"]:
        cells = [
            load["name"],
            number(load["output_torque_Nm"]),
            number_in(load["input_speed_rad_per_s"], "rpm"),
            _capacity(load["torque_capacity_Nm"]),
            percent(load["share_of_capacity"]),
            load["meaning"],
            *(["yes" if load["inside_with_tolerances"] else "no"] if tolerances else []),
            "pass" if load["inside"] else "FAIL",
        ]
        rows.append(tuple(cells))
    words = (0, 5, 6) if tolerances else (0, 5)
    return Table(f"Loads at {_working(document)}", (*head, "result"), rows, words=words, verdicts=True)


def _working(document: Document) -> str:
    """Where the joint works, with its unit."""
    unit = document["axis_unit"]
    shown = quantity(document[f"working_{_KEYS[unit]}"], unit)
    return shown if document["over"] == "temperature" else f"{shown} of {document['axis']}"


def _governing(document: Document) -> Table:
    """Which limit governs where, in every direction."""
    unit, several = document["axis_unit"], len(document["regions"]) > 1
    end = _KEYS[unit]
    rows = []
    for region in document["regions"]:
        for part in region["governing"]:
            ends = (number_in(part[f"{way}_{end}"], unit) for way in ("from", "to"))
            said = f"no torque is allowed: {part['meaning']}" if part["closed"] else part["meaning"]
            rows.append((*([region["direction"]] if several else []), *ends, said))
    head = (f"from\n{unit_words(unit)}", f"to\n{unit_words(unit)}", "what limits the torque")
    if several:
        return Table("Which limit governs where", ("direction", *head), rows, words=(0, 3))
    return Table("Which limit governs where", head, rows, words=(2,))


def _over_axis(document: Document) -> Table:
    """The torque capacity over the axis in every direction: where the joint works, and at some of the other places."""
    unit = document["axis_unit"]
    places = document[f"at_{_KEYS[unit]}"]
    step = max(1, math.ceil((len(places) - 1) / _MOST_ROWS))
    working = places.index(document[f"working_{_KEYS[unit]}"])
    shown = sorted({*range(0, len(places), step), len(places) - 1, working})
    columns = [[number_in(places[row], unit) for row in shown]]
    head = [f"{document['axis']}\n{unit_words(unit)}"]
    if document["key"] != "load.preload":
        columns.append([number(document["preload_N"][row]) for row in shown])
        head.append("preload\nN")
    kinds = (("", "capacity"), ("least_", "least"), ("greatest_", "greatest"))
    for region in document["regions"]:
        way = "reverse, " if len(document["regions"]) > 1 and region["direction"] == "reverse" else ""
        for key, words in kinds[: 3 if document["has_tolerances"] else 1]:
            torques = region[f"{key}torque_capacity_Nm"]
            columns.append([_capacity(torques[row]) for row in shown])
            head.append(f"{way}{words}\nN·m")
    columns.append(["works here" if row == working else "" for row in shown])
    return Table("Torque capacity", (*head, ""), list(zip(*columns, strict=True)), words=(len(head),))


def _capacity(torque: float | None) -> str:
    """A torque capacity in N·m; infinite where no torque is a limit."""
    return quantity(math.inf if torque is None else torque, "1")


def _notes(document: Document) -> Iterator[str]:
    """For what the numbers hold."""
    speed = quantity(document["loads"][0]["input_speed_rad_per_s"], "rpm")
    several = " Each load is judged at its own speed." if len(document["loads"]) > 1 else ""
    yield f"The capacity holds at an input speed of {speed}.{several}"
    if document["required_life_s"] is not None:
        under = (
            "that under the whole duty, scaled so that its largest torque is the torque shown"
            if len(document["loads"]) > 1
            else "that under a constant torque"
        )
        film = (
            "it has the factor a_ISO for the oil film"
            if document["life_has_film_factor"]
            else "it has no factor for the oil film, and in boundary or mixed lubrication it may be too short"
        )
        yield f"The rating life is {under}; {film}."
    if document["has_tolerances"]:
        yield (
            "Least and greatest hold for parts whose preload, interference and radii all lie at the same end of their "
            "tolerances."
        )
    if any(not limit["ends_the_capacity"] for region in document["regions"] for limit in region["limits"]):
        yield (
            "Where a ring lifts off its housing between the rollers, it is softer than computed: that is outside of "
            "the range of the model, and does not end the capacity."
        )

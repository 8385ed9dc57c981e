"""The oil in the contacts over speed: films, who carries the load, traction and creep, at each temperature."""

from __future__ import annotations

import math
from collections.abc import Iterator

from asperity.results.film_bands import BANDS
from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import number, number_in, percent, quantity, words

#: About so many speeds of a table; documents have all of them.
_MOST_ROWS = 12
#: What stands where the joint does not roll steadily.
_SLIPS = "slips"
_ARCMINUTES = 10800.0 / math.pi
_FILM_HEAD = (
    "central film\nµm",
    "minimum film\nµm",
    "film ratio λ\n-",
    "lubrication",
    "asperities\ncarry",
    "by the\nother law",
    "largest\nT/N",
    "creepage\n10⁻³",
)


def film(document: Document) -> Iterator[Block]:
    """Everything about the oil over speed: at the file's own speed, then over speed at each temperature."""
    yield _here(document)
    for curves in document["over_speed"]:
        yield from _over_speed(document, curves)
    yield Paragraph(" ".join(_notes(document)))


def _here(document: Document) -> Table:
    """Every contact at the speed, torque and oil temperature of the file."""
    here = document["film"]
    rows = [(words(name), *_film_cells(contact, here["rolls"])) for name, contact in here["contacts"].items()]
    title = (
        f"Oil in the contacts at {quantity(document['input_speed_rad_per_s'], 'rpm')}, "
        f"{quantity(document['output_torque_Nm'], 'N*m')} and {_degrees(document['oil_temperature_C'])}"
    )
    return Table(title, ("contact", *_FILM_HEAD), rows, words=(0, 4))


def _film_cells(contact: Document, rolls: bool) -> tuple[str, ...]:
    """The numbers of a contact at one speed; dashes and a word where the joint does not roll."""
    return (
        number(contact["central_film_m"], 1e6),
        number(contact["minimum_film_m"], 1e6),
        number(contact["film_ratio"]),
        (contact["lubrication"] or "–") if rolls else _SLIPS,
        percent(contact["asperity_share"]),
        percent(contact["rival_asperity_share"]),
        number(contact["traction_capacity"]),
        number(contact["creepage"], 1e3),
    )


def _over_speed(document: Document, curves: Document) -> Iterator[Table]:
    """The joint and each contact over speed at one temperature of the oil."""
    speeds, rolls = curves["input_speed_rad_per_s"], curves["rolls"]
    shown, at = _shown_rows(speeds, document["input_speed_rad_per_s"]), _degrees(curves["oil_temperature_C"])
    for name, contact in curves["contacts"].items():
        rows = [
            (
                number_in(speeds[row], "rpm"),
                *_film_cells({key: values[row] for key, values in contact.items()}, rolls[row]),
            )
            for row in shown
        ]
        yield Table(
            f"Contact {words(name)} over speed, oil at {at}", ("input\nrpm", *_FILM_HEAD), rows, words=(4,)
        )
    rows = [
        (
            number_in(speeds[row], "rpm"),
            number(curves["drift_rad_per_output_turn"][row], _ARCMINUTES),
            percent(curves["efficiency"][row]),
            _remark(speeds[row] == document["input_speed_rad_per_s"], rolls[row]),
        )
        for row in shown
    ]
    head = ("input\nrpm", "drift\narcmin per turn", "efficiency", "")
    yield Table(f"The joint over speed, oil at {at}", head, rows, words=(3,))


def _shown_rows(speeds: list[float], own: float) -> list[int]:
    """Numbers of the speeds that a table has: some, both ends, and that of the file."""
    step = max(1, math.ceil((len(speeds) - 1) / _MOST_ROWS))
    return sorted(
        {*range(0, len(speeds), step), len(speeds) - 1, *(k for k, at in enumerate(speeds) if at == own)}
    )


def _remark(own: bool, rolls: bool) -> str:
    """Whether a speed is that of the file, and whether the joint rolls there."""
    return ", ".join(
        said for said, holds in (("speed of the file", own), ("no steady rolling", not rolls)) if holds
    )


def _degrees(celsius: float) -> str:
    """A temperature in °C."""
    return f"{number(celsius)} °C"


def _notes(document: Document) -> Iterator[str]:
    """For what the numbers hold."""
    yield (
        "The largest T/N is what film and asperities bear together, up to the creepage lubrication.creep_limit. The "
        "share of the asperities is uncertain by a factor of 1.6 in both directions. The minimum film and its ratio λ "
        "are as if the film carried all."
    )
    yield BANDS
    if not all(document["film"]["rolls"] and all(each["rolls"]) for each in document["over_speed"]):
        yield (
            f"'{_SLIPS}': under this torque the joint does not roll steadily at this speed, because a contact slips or "
            "lifts off."
        )
    warm = {document["oil_temperature_C"], *(each["oil_temperature_C"] for each in document["over_speed"])}
    if len(warm) > 1:
        yield (
            "Only the oil has the temperatures shown: preload and fits are those of temperature.working in the file."
        )
    lowest = document["lowest_temperature_C"]
    if lowest is not None and min(warm) < lowest:
        yield (
            f"Below {_degrees(lowest)}, the lowest temperature of its data, the oil is extrapolated: traction can fall "
            "when oils are cold."
        )

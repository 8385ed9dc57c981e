"""The oil in the contacts over speed: films, who carries the load, traction and creep, at each temperature."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator

from asperity.results.film_bands import BANDS
from asperity.results.oil_notes import DEBORAH_LIMIT
from asperity.rolling.inlet_heat import FILM_REMEDY
from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import number, number_in, percent, quantity, words

#: About so many speeds of a table; documents have all of them.
_MOST_ROWS = 12
#: What stands where the joint does not roll steadily, and at the contact whose film is beyond what can be computed.
_SLIPS, _NO_FILM = "slips", "no film"
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
    state = _state(here["contacts"].values(), here["rolls"])
    rows = [(words(name), *_film_cells(contact, state)) for name, contact in here["contacts"].items()]
    title = (
        f"Oil in the contacts at {quantity(document['input_speed_rad_per_s'], 'rpm')}, "
        f"{quantity(document['output_torque_Nm'], 'N*m')} and {_degrees(document['oil_temperature_C'])}"
    )
    return Table(title, ("contact", *_FILM_HEAD), rows, words=(0, 4))


def _state(contacts: Iterable[Document], rolls: bool) -> str:
    """Why a joint does not roll steadily at a speed, from the numbers of its contacts there; empty where it does."""
    if rolls:
        return ""
    return _NO_FILM if any(_is_unknown(contact) for contact in contacts) else _SLIPS


def _is_unknown(contact: Document) -> bool:
    """Whether the film of a contact at a speed is beyond what can be computed."""
    factor = contact["inlet_heat_factor"]
    return factor is not None and factor <= 0.0


def _film_cells(contact: Document, state: str) -> tuple[str, ...]:
    """The numbers of a contact at one speed; dashes and a word where the joint does not roll."""
    lubrication = contact["lubrication"] or "–"
    if state == _SLIPS or _is_unknown(contact):
        lubrication = state
    return (
        number(contact["central_film_m"], 1e6),
        number(contact["minimum_film_m"], 1e6),
        number(contact["film_ratio"]),
        lubrication,
        percent(contact["asperity_share"]),
        percent(contact["rival_asperity_share"]),
        number(contact["traction_capacity"]),
        number(contact["creepage"], 1e3),
    )


def _over_speed(document: Document, curves: Document) -> Iterator[Table]:
    """The joint and each contact over speed at one temperature of the oil."""
    speeds, states = curves["input_speed_rad_per_s"], _states(curves)
    shown, at = _shown_rows(speeds, document["input_speed_rad_per_s"]), _degrees(curves["oil_temperature_C"])
    for name, contact in curves["contacts"].items():
        rows = [
            (
                number_in(speeds[row], "rpm"),
                *_film_cells(_at(contact, row), states[row]),
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
            _remark(speeds[row] == document["input_speed_rad_per_s"], states[row]),
        )
        for row in shown
    ]
    head = ("input\nrpm", "drift\narcmin per turn", "efficiency", "")
    yield Table(f"The joint over speed, oil at {at}", head, rows, words=(3,))


def _states(curves: Document) -> list[str]:
    """Why the joint does not roll steadily at each speed of one temperature; empty where it does."""
    contacts = curves["contacts"].values()
    return [_state([_at(one, row) for one in contacts], rolls) for row, rolls in enumerate(curves["rolls"])]


def _at(contact: Document, row: int) -> Document:
    """The numbers of a contact at one of its speeds."""
    return {key: values[row] for key, values in contact.items()}


def _shown_rows(speeds: list[float], own: float) -> list[int]:
    """Numbers of the speeds that a table has: some, both ends, and that of the file."""
    step = max(1, math.ceil((len(speeds) - 1) / _MOST_ROWS))
    return sorted(
        {*range(0, len(speeds), step), len(speeds) - 1, *(k for k, at in enumerate(speeds) if at == own)}
    )


def _remark(own: bool, state: str) -> str:
    """Whether a speed is that of the file, and whether the joint rolls there."""
    missing = "no oil film" if state == _NO_FILM else "no steady rolling"
    return ", ".join(said for said, holds in (("speed of the file", own), (missing, state)) if holds)


def _elastic_films(document: Document) -> str:
    """Contacts whose film is elastic at some speed, with the largest Deborah number of each; empty for none."""
    shown = []
    for name, here in document["film"]["contacts"].items():
        over = [each["contacts"][name]["deborah_number"] for each in document["over_speed"]]
        known = [one for one in (here["deborah_number"], *itertools.chain(*over)) if one is not None]
        if known and max(known) > DEBORAH_LIMIT:
            shown.append(f"{words(name)} (up to {number(max(known))})")
    return " and ".join(shown)


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
    if document["unsteady_because"]:
        yield (
            f"The drive has no steady temperature ({document['unsteady_because']}): the oil has that of its "
            "surroundings here; 'asperity roll' says which torque has one."
        )
    yield BANDS
    here = document["film"]
    states = {_state(here["contacts"].values(), here["rolls"])}
    states.update(*(_states(each) for each in document["over_speed"]))
    if _NO_FILM in states:
        yield (
            f"'{_NO_FILM}': heat at the inlet of the contact is beyond the range of the fit, whose factor on the "
            f"thickness would not be above 0; {FILM_REMEDY}."
        )
    if _SLIPS in states:
        yield (
            f"'{_SLIPS}': under this torque the joint does not roll steadily at this speed, because a contact slips or "
            "lifts off."
        )
    warm = {document["oil_temperature_C"], *(each["oil_temperature_C"] for each in document["over_speed"])}
    if len(warm) > 1:
        yield (
            "Only the oil has the temperatures shown: preload and fits are those of temperature.working in the file."
        )
    if document["shear_law"] == "eyring" and (elastic := _elastic_films(document)):
        yield (
            f"The Deborah number is above {DEBORAH_LIMIT:g} at {elastic}: these films pass before they can flow. They "
            "are elastic up to their limiting stress, and Eyring's law takes too little traction at small slip; "
            'shear_law = "limit" fits them better.'
        )
    lowest = document["lowest_temperature_C"]
    if lowest is not None and min(warm) < lowest:
        yield (
            f"Below {_degrees(lowest)}, the lowest temperature of its data, the oil is extrapolated: traction can fall "
            "when oils are cold."
        )

"""What pins, bearings, shafts and housing carry, and bodies that bend."""

from __future__ import annotations

import re
from collections.abc import Iterator

from asperity.results.loads_document import shown_rows, state_of_case
from asperity.types import Document
from asperity.views.blocks import Block, Bullets, Paragraph, Table
from asperity.views.numbers import number, quantity, sentence, unit_words, words
from asperity.views.tilt import tilt

_BEARING_COLUMNS = {
    "C\nN": "dynamic_rating_N",
    "C_0\nN": "static_rating_N",
    "load\nN": "load_N",
    "largest P/C\n-": "load_over_dynamic_rating",
    "life L10\nh": "life_hours",
    "under the duty\nh": "duty_life_hours",
    "static safety\n-": "static_safety",
}
_MISES = (
    "The safety against yield is that of the Mises stress in plane strain, as in the middle of a long body; at the "
    'faces of a short one it is up to 11 % lower, which model.plane_state = "plane_stress" counts everywhere.'
)


def loads(document: Document) -> Iterator[Block]:
    """What the structure carries in each case, and how long its bearings live, from a document of loads."""
    head = ("part", "load", "unit", *(case_title(case, "\n") for case in document["cases"]))
    rows = []
    before = ""
    for part, position, quantity_words, unit, values in shown_rows(document):
        place = f"{part}, {position}"
        what = re.sub(r"\bum\b", "µm", quantity_words)
        rows.append(("" if place == before else place, what, unit_words(unit), *map(number, values)))
        before = place
    yield Table("Loads of the structure", head, rows, words=(0, 1, 2))
    bearings = document["bearings"]
    if bearings:
        yield Table(
            "Rolling bearings, each one alone",
            ("bearing", "type", *_BEARING_COLUMNS),
            [
                (
                    words(bearing["bearing"]),
                    bearing["type"],
                    *(number(bearing[key]) for key in _BEARING_COLUMNS.values()),
                )
                for bearing in bearings
            ],
            words=(0, 1),
        )
    absent = [
        sentence(f"{words(bearing['bearing'])} bearing: {reason}")
        for bearing in bearings
        for reason in bearing["absent_because"]
    ]
    unknown = [
        sentence(f"{case['name']}: {case['unknown_because']}")
        for case in document["cases"]
        if case["unknown_because"]
    ]
    if said := [*unknown, *absent, *document["notes"]]:
        yield Bullets(said)
    if "tilt" in document:
        yield from tilt(document["tilt"])


def case_title(case: Document, line: str) -> str:
    """Title of a column: the load, whether it rolls or stands, its torque and the speed of the input."""
    if case["name"] == "without torque":
        return state_of_case(case)
    torque, speed = case["output_torque_Nm"], case["sun_speed_rad_per_s"]
    return f"{state_of_case(case)}{line}{quantity(torque, 'N*m')}{line}{quantity(speed, 'rpm')}"


def rims(document: Document) -> Iterator[Block]:
    """Stresses of the ring where it bends and of hollow rollers, if there are any."""
    rows = [
        (
            words(body),
            rim,
            *(
                number(stresses[f"{name}_Pa"][rim], 1e-6)
                for name in ("stress_at_rest", "stress", "mean", "amplitude")
            ),
            number(stresses["yield_safety"]),
            number(stresses["fatigue_safety"]),
        )
        for body, stresses in document["rims"].items()
        for rim in ("inner", "outer")
    ]
    if rows:
        head = ("body", "rim", "without torque\nMPa", "under torque\nMPa", "mean\nMPa", "amplitude\nMPa")
        yield Table(
            "Hoop stress of bodies that bend, and their safety",
            (*head, "safety against\nyield", "safety against\nfatigue"),
            rows,
            words=(0, 1),
        )
        yield Paragraph(_MISES)

"""Wear of a joint: how fast, when it ends, and how preload, capacity and drift go on the way."""

from __future__ import annotations

import math
from collections.abc import Iterator

from asperity.types import Document
from asperity.views.blocks import Block, Figure, Figures, Paragraph, Table
from asperity.views.numbers import NONE, number, number_in, quantity, words

_ARCMINUTES = 10800.0 / math.pi
_HOUR = 3600.0
#: Of k t, at which depths are shown where no coefficient is stated: 1000 hours at 1e-17 1/Pa [s/Pa].
_SHOWN_TIME = 3.6e-11
#: About so many points of the course in a table; documents have all of them.
_MOST_ROWS = 12
#: Hours and wear coefficients [1/Pa] above which only that is said: 100,000 years, and what a file may state.
_MOST_HOURS, _MOST_COEFFICIENT = 1e9, 1e-11
_WHAT = {
    "gross_slip": "{contact} slides",
    "lift_off": "{contact} lifts off",
    "no_solution": "no balance is left",
    "loose": "the whole interference is gone",
    "flat": "the crown of {contact} is worn flat",
    "contact_too_wide": "{contact} is too wide for line-contact theory",
    "wall_too_thin": "the wall at {contact} is too thin for its compliance to be known",
}


def wear(document: Document) -> Iterator[Block]:
    """Everything about the wear of a joint: first figures, rates, ends, the course, what holds."""
    found = document["wear"]
    yield Figures(tuple(_figures(found)))
    yield _rates(found)
    if not found["keeps_force"]:
        yield _ends(found)
        yield _course(found)
    yield Paragraph(" ".join(_notes(found)))


def _figures(found: Document) -> Iterator[Figure]:
    """When the first contact slides, when nothing is left, and what the life allows."""
    for name, key in (("first contact slides", "first_slide"), ("nothing left", "nothing_left")):
        if found["keeps_force"]:
            continue
        hours, time = found[f"{key}_hours"], found[f"{key}_kt_s_per_Pa"]
        what = _what(found, key)
        if time is None:
            yield Figure(name, NONE, "", what, None)
        elif hours is not None:
            yield Figure(name, _bounded(hours, _MOST_HOURS), "h", what, hours * _HOUR)
        else:
            yield Figure(name, number(time), "s/Pa", f"wear coefficient times time; {what}", time)
    life, allowed = found["life_hours"], found["allowed_coefficient_per_Pa"]
    if life is not None and allowed is not None:
        detail = f"for {quantity(life * _HOUR, 'h')} to the first slide"
        yield Figure(
            "largest wear coefficient", _bounded(allowed, _MOST_COEFFICIENT), "1/Pa", detail, allowed
        )
    after = found["after_life"]
    if after is None:
        return
    at = f"after {quantity(life * _HOUR, 'h')}"
    if after["stroke_m"] is not None:
        shown = number_in(after["stroke_m"], "um")
        yield Figure("stroke", shown, "µm", f"that the cam or the force follows {at}", after["stroke_m"])
    preload = after["preload_N"]
    lost = "the joint does not reach it" if found["computed_until"] is None else "not computed as far"
    beyond = "" if preload is not None else f"; {lost}"
    yield Figure("preload", number(preload), "N", f"{at}{beyond}", preload)


def _bounded(value: float | None, most: float) -> str:
    """A number, or that it is above what means anything: a film leaves the asperities as good as nothing."""
    return number(value) if value is None or value <= most else f"> {number(most)}"


def _what(found: Document, key: str) -> str:
    """What happens at an end of wear, or why it is not known."""
    end, until = found[key], found["computed_until"]
    if end is not None:
        return _end(end)
    if until is None:  # another end comes first
        return f"none before {_end(found['nothing_left'])}"
    if until["limit"] == "gross_slip":
        return "not known: with skew or oil nothing is computed beyond the first slide"
    return f"not computed beyond: {_end(until)}"


def _end(end: Document) -> str:
    """What happens at an end, and under which load of a duty where it is not the first."""
    said = _WHAT[end["limit"]].format(contact=words(end["contact"] or ""))
    return said if end.get("load") in (None, 1) else f"{said} under load {end['load']}"


def _rates(found: Document) -> Table:
    """Depths of the tracks, and what they take off the drive, before it wears."""
    after = (found["after_life"] or {}).get("depth_m")
    known = found["depth_m_per_hour"] is not None
    factor = 1000.0 if known else _SHOWN_TIME
    depths = found["depth_m_per_hour"] if known else found["depth_per_kt_m_Pa_per_s"]
    interference = found["interference_m_per_hour"] if known else found["interference_per_kt_m_Pa_per_s"]
    per = "µm per 1000 h" if known else f"µm per k t of {number(_SHOWN_TIME)} s/Pa"
    head = ["part", per] + ([f"after {number(found['life_hours'])} h\nµm"] if after else [])
    rows = [
        (words(name), number(depth, 1e6 * factor), *([number(after[name], 1e6)] if after else []))
        for name, depth in depths.items()
    ]
    rows.append(("interference of the drive", number(interference, 1e6 * factor), *([NONE] if after else [])))
    return Table("Depth of wear at the start", tuple(head), rows)


def _ends(found: Document) -> Table:
    """Both ends with the interference that is left there."""
    rows = []
    for name, key in (("first contact slides", "first_slide"), ("nothing left", "nothing_left")):
        end = found[key]
        rows.append(
            (
                name,
                _what(found, key),
                NONE if end is None else number_in(end["interference_m"], "um"),
                number(found[f"{key}_kt_s_per_Pa"]),
                _bounded(found[f"{key}_hours"], _MOST_HOURS),
            )
        )
    head = ("end", "what happens", "interference\nµm", "k t\ns/Pa", "time\nh")
    return Table("How long the joint carries its load", head, rows, words=(0, 1))


def _course(found: Document) -> Table:
    """Interference, preload, capacity and drift over time."""
    count = len(found["kt_s_per_Pa"])
    capacity = found["torque_capacity_Nm"]
    shown = [row for row in range(count) if capacity[row] is not None]
    if len(shown) < 2:
        shown = list(range(0, count, max(1, (count - 1) // _MOST_ROWS)))
    known = found["hours"] is not None
    times = found["hours"] if known else found["kt_s_per_Pa"]
    rows = [
        (
            number(times[row]),
            number_in(found["interference_m"][row], "um"),
            number(found["preload_N"][row]),
            number(capacity[row]),
            number(found["drift_rad_per_output_turn"][row], _ARCMINUTES),
            number(found["size_drift_rad_per_output_turn"][row], _ARCMINUTES),
        )
        for row in shown
    ]
    head = (
        "time\nh" if known else "k t\ns/Pa",
        "interference\nµm",
        "preload\nN",
        "first slide at\nN·m",
        "drift by creep\narcmin per turn",
        "by worn radii\narcmin per turn",
    )
    return Table("The joint over time", head, rows, words=())


def _notes(found: Document) -> Iterator[str]:
    """For what the numbers hold."""
    if found["coefficient_per_Pa"] is None:
        yield (
            "All times are in proportion to 1/k: k t is the wear coefficient times the time. State k in [wear] "
            "coefficient for hours; there is no usual one, from 1e-20 1/Pa in a mixed film to 1e-12 1/Pa of dry mild "
            "steel."
        )
    if found["keeps_force"]:
        yield "A cam or a constant force follows the wear: the preload stays, and wear takes stroke instead."
    if (found["computed_until"] or {}).get("limit") == "gross_slip":
        yield (
            "With skew or oil a contact that slides bears something else than its friction, so that nothing is "
            "computed beyond the first slide; other contacts may still carry the load."
        )
    if found["unlike_lengths"]:
        tracks = ", ".join(map(words, found["unlike_lengths"]))
        yield (
            f"Contacts of unlike lengths roll on one track ({tracks}): it wears in a step, which is left out; the "
            "depth is that below the shortest."
        )
    if found["crowned"]:
        yield (
            "Crowns wear flatter; the worn profile is taken as a parabola through the loads, and contacts without a "
            "crown stay even. Depths are those in the middle."
        )
    yield (
        "Archard's law with one coefficient; tracks wear alike all round: running-in, runout and what wear does to "
        "the roughness are left out."
    )

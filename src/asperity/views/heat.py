"""The temperatures at which a joint settles, and what it can do cold and under its duty."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.types import Document
from asperity.views.blocks import Block, Bullets, Figure, Table
from asperity.views.numbers import number, percent, quantity

#: Why a load has no steady temperature.
_NEVER = "the drive runs away, or slips"


def temperature_figure(document: Document) -> list[Figure]:
    """The temperature of the rollers, or that there is none; nothing for a joint whose temperature is stated."""
    heat = document.get("heat")
    if heat is None:
        return []
    if not heat["steady"]:
        return [Figure("Temperature", "–", "", f"{heat['unsteady_because']}{_still_steady(heat)}", None)]
    around = f"{_rollers(document)}, steady; {quantity(heat['ambient_degC'], 'degC')} around the housing"
    return [
        Figure(
            "Temperature",
            number(heat["roller_temperature_degC"]),
            "°C",
            around,
            heat["roller_temperature_degC"],
        )
    ]


def at_temperature(document: Document) -> str:
    """The steady temperature after a number that holds there, with a blank before it; empty where it is stated."""
    heat = document.get("heat")
    if heat is None:
        return ""
    return (
        f" at {number(heat['roller_temperature_degC'])} °C"
        if heat["steady"]
        else f", {heat['unsteady_because']}"
    )


def _rollers(document: Document) -> str:
    """What has the temperature of the rollers: with oil in the contacts this, too."""
    contacts = document.get("rolling", {}).get("contacts", {}).values()
    oiled = any(contact.get("film_thickness_m") is not None for contact in contacts)
    return "rollers and oil" if oiled else "rollers"


def _still_steady(heat: Document) -> str:
    """The torque that still has a steady temperature, in words."""
    torque = heat["steady_torque_Nm"]
    if torque is None:
        return "; no torque has a steady temperature"
    return f"; up to {quantity(torque, 'N*m')} there is a steady temperature"


def heat(document: Document) -> Iterator[Block]:
    """Temperatures, what cools the drive, its cold start and its duty; nothing where its temperature is stated."""
    stated = document.get("heat")
    if stated is None:
        return
    rows = [*_steady(stated, _rollers(document)), *_cold_start(stated), *_duty(stated)]
    yield Table(
        "Heat: temperatures at which the drive settles",
        ("quantity", "value", "what it is"),
        rows,
        words=(0, 2),
    )
    others = [
        f"another {'stable' if state['stable'] else 'unstable'} steady temperature at "
        f"{quantity(state['roller_temperature_degC'], 'degC', 3)}"
        + ("" if state["stable"] else ": a drive warmer than that runs away")
        for state in stated["other_states"]
    ]
    if others:
        yield Bullets(others)


def _steady(heat: Document, rollers: str) -> list[tuple[str, str, str]]:
    """What cools the drive, and its steady temperatures; ``rollers``: what has that of the rollers."""
    around = quantity(heat["ambient_degC"], "degC")
    outward = quantity(heat["resistance_K_per_W"], "K/W")
    if not heat["steady"]:
        return [
            ("temperature", "none is steady", f"{heat['unsteady_because']}{_still_steady(heat)}"),
            ("ambient", around, f"{outward} from the housing to it"),
        ]
    inward = heat["roller_resistance_K_per_W"]
    of_rollers = f"{quantity(inward, 'K/W')} to the housing" if inward else "as warm as the housing"
    rows = [
        (rollers, quantity(heat["roller_temperature_degC"], "degC"), of_rollers),
        ("housing and rings", quantity(heat["housing_temperature_degC"], "degC"), f"{outward} to {around}"),
        ("heat", quantity(heat["loss_W"], "W"), "all losses of the joint at these temperatures"),
        (
            "reserve of the ambient",
            quantity(heat["ambient_reserve_K"], "K"),
            "how much warmer it may become before the drive runs away",
        ),
        ("thermal gain", number(_gain(heat)), "kelvins more by a kelvin more: below 1 it is stable"),
    ]
    if heat["time_constant_s"] is not None:
        rows.append(("time constant", quantity(heat["time_constant_s"], "min"), "of warming up"))
    return rows


def _gain(heat: Document) -> float:
    """The thermal gain, 0 where losses that do not depend on temperature leave rounding errors of it."""
    return float(heat["gain"]) if abs(heat["gain"]) > 1e-9 else 0.0


def _cold_start(heat: Document) -> list[tuple[str, str, str]]:
    """Capacities and torque of the input at a cold start."""
    cold = heat.get("cold_start")
    if not cold or all(value is None for value in cold.values()):
        return []
    return [
        (
            "cold start, rolling",
            quantity(cold["rolling_torque_capacity_Nm"], "N*m"),
            "torque capacity of slip alone",
        ),
        (
            "cold start, standing",
            quantity(cold["standing_torque_capacity_Nm"], "N*m"),
            "torque capacity of slip alone",
        ),
        (
            "cold start, input",
            quantity(cold["input_torque_Nm"], "N*m"),
            "none: the input stands, or the drive does not roll there"
            if cold["input_torque_Nm"] is None
            else f"torque at full speed under the load; efficiency {percent(cold['efficiency'])}",
        ),
    ]


def _duty(heat: Document) -> list[tuple[str, str, str]]:
    """Temperatures under the duty."""
    duty = heat["duty"]
    if duty is None:
        return []
    mean = duty["mean_degC"]
    what = "temperature of the rollers at the mean losses"
    rows = [("duty, mean", quantity(mean, "degC"), what if mean is not None else f"none is steady: {_NEVER}")]
    if duty["peak_beyond_oil_limit"]:
        rows.append(("duty, peak", "–", "beyond the limit of the oil"))
    elif duty["peak_degC"] is not None:
        rows.append(
            ("duty, peak", quantity(duty["peak_degC"], "degC"), "the highest one as the duty repeats")
        )
    rows += [
        (
            f"duty, load {name} alone",
            quantity(at, "degC"),
            "if it lasted" if at is not None else f"none if it lasts: {_NEVER}",
        )
        for name, at in duty["alone_degC"].items()
    ]
    return rows

"""Notes on the oil of a joint that rolls: where its film is elastic, not viscous, and where it is too cold."""

from __future__ import annotations

import math

import numpy as np

from asperity.contact.fluid import RheologicalTraction
from asperity.joint.description import Joint
from asperity.results.notes import Note
from asperity.rolling.conditions import ZERO_CELSIUS
from asperity.rolling.rolling import RollingResult
from asperity.unit_table import Dimension
from asperity.units import format_quantity

#: Deborah number above which a film is elastic before it flows [-].
DEBORAH_LIMIT = 1.0


def oil_notes(joint: Joint, rolling: RollingResult) -> tuple[Note, ...]:
    """Whether a film that thins after Eyring has the time to flow, and whether the oil is as warm as its data.

    Nothing without an oil whose traction is known, or where nothing turns.
    """
    lubricant, film = joint.rolling.lubricant, rolling.film
    if lubricant is None or film is None:
        return ()
    notes = []
    traction = lubricant.fluid.traction
    if isinstance(traction, RheologicalTraction) and traction.shear_law == "eyring":
        numbers = np.asarray(film.deborah_number, dtype=float)
        notes += [
            _deborah(name, float(number))
            for name, number in zip(joint.contact_names, numbers, strict=True)
            if math.isfinite(number)
        ]
    if lubricant.lowest_temperature is not None and float(np.asarray(joint.input_speed)) != 0.0:
        notes.append(_cold(float(lubricant.temperature), float(lubricant.lowest_temperature)))
    return tuple(notes)


def _deborah(contact: str, number: float) -> Note:
    """Whether the film of a contact flows while it passes."""
    ok = number <= DEBORAH_LIMIT
    return Note(
        "deborah_number",
        "Deborah number of the oil film",
        contact,
        number,
        DEBORAH_LIMIT,
        ok,
        "state",
        "the oil film flows while it passes the contact"
        if ok
        else "the oil film passes before it can flow: it is elastic up to its limiting stress, and Eyring's law takes "
        "too little traction at small slip",
        None
        if ok
        else 'choose shear_law = "limit" in the section [fluids] of the oil, or give its data sheet',
        state="" if ok else "elastic film",
        upper=True,
    )


def _cold(temperature: float, lowest: float) -> Note:
    """Whether an oil is as warm as its data [K]."""
    ok = temperature >= lowest
    return Note(
        "oil_temperature",
        "temperature of the oil",
        None,
        temperature - ZERO_CELSIUS,
        lowest - ZERO_CELSIUS,
        ok,
        "state",
        "the oil is as warm as its data"
        if ok
        else f"the oil is colder than its data, which begin at {format_quantity(lowest - ZERO_CELSIUS, 'degC')}: "
        "viscosity and traction are extrapolated, and traction can fall when oils are cold",
        None if ok else "measure the traction at this temperature, or warm the oil",
        Dimension.TEMPERATURE,
        "degC",
        state="" if ok else "extrapolated",
    )

"""The oil in the contacts of a joint over speed as one JSON document."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.contact.fluid import ShearLaw
from asperity.results.film_bands import film_band
from asperity.rolling.conditions import ZERO_CELSIUS
from asperity.rolling.film_curves import FilmCurves
from asperity.types import Document

#: Key of the document of a contact → field of :class:`asperity.rolling.film_curves.FilmCurves`.
_CONTACT = {
    "central_film_m": "central_film",
    "minimum_film_m": "minimum_film",
    "film_ratio": "film_ratio",
    "asperity_share": "asperity_share",
    "rival_asperity_share": "rival_asperity_share",
    "traction_capacity": "traction_capacity",
    "traction_coefficient": "traction_coefficient",
    "creepage": "creepage",
    "deborah_number": "deborah_number",
    "inlet_heat_factor": "inlet_heat_factor",
}
_JOINT = {"drift_rad_per_output_turn": "drift_per_output_turn", "efficiency": "efficiency"}


class FilmOverSpeed(NamedTuple):
    """The oil in the contacts of a joint over speed, under one torque at the output [N·m].

    ``here``: at the speed of its file and its temperature, one point; ``curves``: one for each temperature.
    ``lowest_temperature`` of the oil's data [K], None where none is known; ``housing_temperature`` [K]; ``shear_law``
    of the film, None where a data sheet or a curve states its traction. ``unsteady_because``: why the joint has no
    steady temperature, so that its surroundings' stands for it; empty otherwise.
    """

    contact_names: tuple[str, ...]
    output_torque: float
    lowest_temperature: float | None
    housing_temperature: float
    unsteady_because: str
    here: FilmCurves
    curves: tuple[FilmCurves, ...]
    shear_law: ShearLaw | None


def film_document(film: FilmOverSpeed) -> Document:
    """The oil over speed in SI units, temperatures in degC, ready for :func:`json.dumps`; null where nothing rolls."""
    here = film.here
    return {
        "oil_temperature_C": _celsius(here.temperature),
        "roller_temperature_C": _celsius(here.temperature),
        "housing_temperature_C": _celsius(film.housing_temperature),
        "unsteady_because": film.unsteady_because or None,
        "lowest_temperature_C": None
        if film.lowest_temperature is None
        else _celsius(film.lowest_temperature),
        "shear_law": film.shear_law,
        "input_speed_rad_per_s": float(here.input_speed[0]),
        "output_torque_Nm": film.output_torque,
        "film": {
            "rolls": bool(here.rolls[0]),
            "contacts": {
                name: {key: values[0] for key, values in contact.items()}
                for name, contact in _contacts(film, here).items()
            },
            **{key: _plain(getattr(here, name))[0] for key, name in _JOINT.items()},
        },
        "over_speed": [
            {
                "oil_temperature_C": _celsius(curves.temperature),
                "input_speed_rad_per_s": curves.input_speed.tolist(),
                "rolls": curves.rolls.tolist(),
                "contacts": _contacts(film, curves),
                **{key: _plain(getattr(curves, name)) for key, name in _JOINT.items()},
            }
            for curves in film.curves
        ],
    }


def film_columns(film: FilmOverSpeed) -> Document:
    """The curves as columns of one table, a row for each temperature and speed, units in the names; nan for a gap."""
    columns = {
        "oil_temperature_C": np.concatenate(
            [np.full_like(each.input_speed, _celsius(each.temperature)) for each in film.curves]
        ),
        "input_speed_rad_per_s": np.concatenate([each.input_speed for each in film.curves]),
    }
    for key, name in _JOINT.items():
        columns[key] = np.concatenate([getattr(each, name) for each in film.curves])
    for number, contact in enumerate(film.contact_names):
        for key, name in _CONTACT.items():
            columns[f"{key}_{contact}"] = np.concatenate(
                [getattr(each, name)[number] for each in film.curves]
            )
    return columns


def _contacts(film: FilmOverSpeed, curves: FilmCurves) -> dict[str, dict[str, list[float | str | None]]]:
    """Every number of each contact over the speeds, with who carries its load."""
    found: dict[str, dict[str, list[float | str | None]]] = {}
    for number, contact in enumerate(film.contact_names):
        found[contact] = {key: _plain(getattr(curves, name)[number]) for key, name in _CONTACT.items()}
        bands = [film_band(float(ratio)) or None for ratio in curves.film_ratio[number]]
        found[contact]["lubrication"] = list(bands)
    return found


def _plain(values: np.ndarray) -> list[float | str | None]:
    """Numbers for JSON; None for nan."""
    return [value if math.isfinite(value) else None for value in values.tolist()]


def _celsius(kelvin: float) -> float:
    """A temperature in degC, without what rounding adds to it."""
    return round(kelvin - ZERO_CELSIUS, 9)

"""Of what a measurement of a surface is: one of the two bodies that meet, or both together."""

from __future__ import annotations

from typing import Any, Literal, cast, get_args

from asperity.errors import InputError, quoted

#: One body of a contact, or the pair: the equivalent surface, whose heights are those of both bodies together.
MeasurementOf = Literal["body", "pair"]
WORDS: tuple[MeasurementOf, ...] = get_args(MeasurementOf)


def known_measurement_of(stated: Any) -> MeasurementOf:
    """One of the two words; an ``InputError`` for anything else."""
    if stated not in WORDS:
        raise InputError(
            f'expected "body", if the measurement is of one body, or "pair", of both together, got {quoted(stated)}',
            options=["measurement-of"],
        )
    return cast(MeasurementOf, stated)

"""Which tracks the parts of sections [[form]] are, and what is refused of their form errors."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from asperity.drive.layout.drive import Drive
from asperity.errors import InputError, nearest
from asperity.joint_file.part_names import drive_type_of
from asperity.joint_file.si_tables import Values
from asperity.rolling.accuracy import FormError
from asperity.types import Real
from asperity.units import format_quantity


class FormPart(NamedTuple):
    """A track of a drive of equal sectors.

    ``name`` in documents; ``body`` that it is on; ``sides``, its contacts, (number, "first" or "second"); ``on_axis``,
    whether all sectors share it; ``alone``, whether its body has no other track.
    """

    name: str
    body: str
    sides: tuple[tuple[int, str], ...]
    on_axis: bool
    alone: bool


def form_parts(values: Values, drive: Drive) -> dict[str, tuple[FormPart, ...]]:
    """Names that sections [[form]] may use → the tracks that they mean; of tables in SI units and their drive."""
    named: dict[str, list[FormPart]] = defaultdict(list)
    kind = drive_type_of(values)
    for number, body in enumerate(drive.bodies):
        tracks = _tracks(drive, body.name)
        for place, (track, sides) in enumerate(tracks.items(), start=1):
            alone = len(tracks) == 1
            own = f"{body.name}_track_{place}" if kind.is_listed else track
            part = FormPart(
                name=body.name if alone else own,
                body=body.name,
                sides=sides,
                on_axis=body.on_axis,
                alone=alone,
            )
            names = [part.name]
            if alone and not kind.is_listed:
                stated = kind.part(drive.bodies[number].name)
                names += [track, stated.size_key, stated.branch or part.name]
            for name in dict.fromkeys(names):
                named[name].append(part)
    return {name: tuple(parts) for name, parts in named.items()}


def _tracks(drive: Drive, body: str) -> dict[str, tuple[tuple[int, str], ...]]:
    """Tracks of a body by their names → sides of contacts on them."""
    found: dict[str, tuple[tuple[int, str], ...]] = {}
    for number, contact in enumerate(drive.contacts):
        for side, name, track in zip(
            ("first", "second"), (contact.first, contact.second), contact.tracks, strict=True
        ):
            if name == body:
                found[track] = (*found.get(track, ()), (number, side))
    return found


def form_errors(
    values: Values, parts: Mapping[str, Sequence[FormPart]], drive: Drive, sectors: int
) -> list[FormError]:
    """The form errors of a file, one for each harmonic of each part of each sector, of tables in SI units; pure.

    ``drive`` has equal sectors. Contacts have the number of their sector behind their names where there are several
    sectors. An ``InputError`` is raised for what no part can have.
    """
    found: list[FormError] = []
    seen: dict[tuple[str, int, int], str] = {}
    for number, entry in values.get("form", {}).items():
        where = f"form.{number}"
        for error in _of_entry(entry, where, parts, drive, sectors):
            key = (error.part, error.sector, error.harmonic)
            if key in seen:
                raise InputError(
                    f"{where}: harmonic {error.harmonic} of the {error.part.replace('_', ' ')} stands in {seen[key]} "
                    "too; state it once"
                )
            seen[key] = where
            found.append(error)
    return found


def _amplitudes(entry: Values) -> dict[int, Real]:
    """Number of waves → amplitude [m]; that of one wave is half of the runout."""
    found: dict[int, Real] = {1: 0.5 * entry["runout"]} if "runout" in entry else {}
    return found | {int(waves): size for waves, size in entry.get("harmonics", {}).items()}


def _of_entry(
    entry: Values, where: str, parts: Mapping[str, Sequence[FormPart]], drive: Drive, sectors: int
) -> Iterator[FormError]:
    """The form errors of one section."""
    if entry["part"] not in parts:
        raise InputError(
            f"{where}.part: the drive has no part '{entry['part']}'"
            f"{nearest(entry['part'], parts) or '; it has ' + ', '.join(parts)}"
        )
    sector = None if "sector" not in entry else int(entry["sector"])
    for part in parts[entry["part"]]:
        _refuse_sector(sector, where, part, sectors)
        for harmonic, amplitude in _amplitudes(entry).items():
            numbers = (0,) if part.on_axis else range(1, sectors + 1) if sector is None else (sector,)
            for of in numbers:
                yield FormError(
                    part=part.name,
                    sector=of,
                    sides=_sides(part, drive, of, sectors),
                    harmonic=harmonic,
                    amplitude=amplitude,
                    phase=entry.get("phase"),
                )


def refuse_floating_runout(values: Values, drive: Drive) -> None:
    """Refuse the runout of parts that float: neither an axis of their own nor another track tells where it is.

    Of tables in SI units whose numbers are known, and their drive.
    """
    springs, place = values.get("compliance", {}), {body.name: body.place for body in drive.bodies}
    supported = "planet_support_stiffness" in springs
    input_floats = springs.get("sun_support_stiffness") == 0.0
    parts = form_parts(values, drive)
    for number, entry in values.get("form", {}).items():
        eccentricity = _amplitudes(entry).get(1)
        for part in parts.get(entry["part"], ()):
            free = place[part.body] == "free"
            floats = not supported if free else input_floats and part.body == drive.input
            if eccentricity is None or not (part.alone and floats):
                continue
            key = "runout" if "runout" in entry else "harmonics.1"
            size = float(eccentricity) * (2.0 if key == "runout" else 1.0)
            raise InputError(
                f"form.{number}.{key} = {format_quantity(size, 'um')}: the {part.name.replace('_', ' ')} floats, no "
                "axis: leave it out; its centre goes where its contacts put it"
            )


def _refuse_sector(sector: int | None, where: str, part: FormPart, sectors: int) -> None:
    if sector is None:
        return
    if part.on_axis:
        raise InputError(
            f"{where}.sector = {sector}: all sectors share the {part.name.replace('_', ' ')}; leave it out"
        )
    if sector > sectors:
        raise InputError(f"{where}.sector = {sector}: the drive has {sectors} sectors; choose one of them")


def _sides(part: FormPart, drive: Drive, sector: int, sectors: int) -> tuple[tuple[str, str], ...]:
    """Sides of contacts of the whole drive on a track of one sector, by their names."""
    if sectors == 1:
        return tuple((drive.contacts[number].name, side) for number, side in part.sides)
    sides = []
    for number, side in part.sides:
        contact = drive.contacts[number]
        for of in range(1, sectors + 1) if part.on_axis else (sector,):
            # the second body of a contact may be one of the next sector
            at = (of - 1 - (contact.sector if side == "second" and not part.on_axis else 0)) % sectors + 1
            sides.append((f"{contact.name}_{at}", side))
    return tuple(sides)

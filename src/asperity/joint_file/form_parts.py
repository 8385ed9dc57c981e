"""Which tracks the parts of sections [[form]] are, and what is refused of their form errors."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from asperity.drive.layout.drive import Drive
from asperity.errors import InputError, nearest
from asperity.joint_file.form_entries import FormEntry
from asperity.joint_file.part_names import drive_type_of
from asperity.joint_file.si_tables import AnyCase, Values
from asperity.rolling.accuracy import FormError
from asperity.units import format_quantity


class FormPart(NamedTuple):
    """A track of a drive of equal sectors.

    ``name`` in documents; ``body`` that it is on; ``sides``, its contacts, (number, "first" or "second"); ``radius``
    [m]; ``on_axis``, whether all sectors share it; ``has_axis``, whether an axis of its own or another track tells
    where its centre is.
    """

    name: str
    body: str
    sides: tuple[tuple[int, str], ...]
    radius: float
    on_axis: bool
    has_axis: bool


def form_parts(values: Values, drive: Drive) -> dict[str, tuple[FormPart, ...]]:
    """Names that sections [[form]] may use → the tracks that they mean; of tables in SI units and their drive."""
    named: dict[str, list[FormPart]] = defaultdict(list)
    springs = values.get("compliance", {})
    supported = "planet_support_stiffness" in springs
    input_floats = springs.get("sun_support_stiffness") == 0.0
    kind = drive_type_of(values)
    for number, body in enumerate(drive.bodies):
        tracks = _tracks(drive, body.name)
        for place, (track, sides) in enumerate(tracks.items(), start=1):
            alone = len(tracks) == 1
            own = f"{body.name}_track_{place}" if kind.is_listed else track
            side = sides[0]
            radius = drive.first_radius if side[1] == "first" else drive.second_radius
            part = FormPart(
                name=body.name if alone else own,
                body=body.name,
                sides=sides,
                radius=float(radius[side[0]]),
                on_axis=body.on_axis,
                has_axis=not alone
                or (supported if body.place == "free" else not (input_floats and body.name == drive.input)),
            )
            names = {part.name}
            if alone and not kind.is_listed:
                stated = kind.part(drive.bodies[number].name)
                names |= {track, stated.size_key, stated.branch or part.name}
            for name in names:
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
    case: AnyCase, parts: Mapping[str, Sequence[FormPart]], drive: Drive, sectors: int
) -> list[FormError]:
    """The form errors of a file, one for each harmonic of each part of each sector.

    ``drive`` has equal sectors. Contacts have the number of their sector behind their names where there are several
    sectors. An ``InputError`` is raised for what no part can have.
    """
    found: list[FormError] = []
    seen: dict[tuple[str, int, int], str] = {}
    for number, entry in enumerate(case.form or (), start=1):
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


def _of_entry(
    entry: FormEntry, where: str, parts: Mapping[str, Sequence[FormPart]], drive: Drive, sectors: int
) -> Iterator[FormError]:
    """The form errors of one section."""
    if entry.part not in parts:
        raise InputError(
            f"{where}.part: the drive has no part '{entry.part}'"
            f"{nearest(entry.part, parts) or '; it has ' + ', '.join(parts)}"
        )
    for part in parts[entry.part]:
        _refuse_sector(entry, where, part, sectors)
        for harmonic, amplitude in entry.amplitudes().items():
            if harmonic == 1 and not part.has_axis:
                key = "runout" if entry.runout is not None else "harmonics.1"
                raise InputError(
                    f"{where}.{key} = {format_quantity(amplitude * (2 if key == 'runout' else 1), 'um')}: the "
                    f"{part.name.replace('_', ' ')} floats, no axis: leave it out; its centre goes where its contacts "
                    "put it"
                )
            numbers = (
                (0,) if part.on_axis else range(1, sectors + 1) if entry.sector is None else (entry.sector,)
            )
            for sector in numbers:
                yield FormError(
                    part=part.name,
                    sector=sector,
                    sides=_sides(part, drive, sector, sectors),
                    harmonic=harmonic,
                    amplitude=amplitude,
                    phase=None if entry.phase is None else entry.phase.value,
                )


def _refuse_sector(entry: FormEntry, where: str, part: FormPart, sectors: int) -> None:
    if entry.sector is None:
        return
    if part.on_axis:
        raise InputError(
            f"{where}.sector = {entry.sector}: all sectors share the {part.name.replace('_', ' ')}; leave it out"
        )
    if entry.sector > sectors:
        raise InputError(
            f"{where}.sector = {entry.sector}: the drive has {sectors} sectors; choose one of them"
        )


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

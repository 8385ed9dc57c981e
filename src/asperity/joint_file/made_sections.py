"""Sections of joint files that are made of what a type of drive states."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Optional

from pydantic import create_model

from asperity.drive.layout.drive_type import DriveType
from asperity.drive.layout.sizes import DEVIATION, Choice, ContactLength, Entry, Size
from asperity.joint_file.drive_sections import PartLengths, RollerDrive
from asperity.joint_file.limits import key_of
from asperity.joint_file.model import AxisCase, Case, ModelChoice
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import Section
from asperity.joint_file.sections import HeldBearing, PinEntry


def _camel(name: str) -> str:
    """A name in words, as classes are called: ``stepped_planet`` → ``SteppedPlanet``."""
    return "".join(part.capitalize() for part in name.split("_"))


def _field(entry: Entry) -> tuple[Any, Any]:
    """The annotation and the default of a key, ``...`` where it must be stated."""
    if isinstance(entry, ContactLength):
        return PartLengths, ...
    if isinstance(entry, Choice):
        words: Any = Literal[entry.words]
        if entry.required:
            return words, ...
        return (Optional[words] if entry.default is None else words), entry.default  # noqa: UP045 (a value, not an annotation)
    number: Any = Annotated[Quantity, key_of(entry.range)]
    return (number, ...) if entry.required else (Optional[number], None)  # noqa: UP045


def _meaning(kind: DriveType, entry: Entry) -> str:
    """What a key means."""
    if isinstance(entry, ContactLength):
        names = ", ".join(kind.contact_names({}))
        return f"Length B of the contact lines: one for all, or a table with {names}."
    return entry.meaning


def _made(
    name: str,
    base: type[Section],
    summary: str,
    fields: Mapping[str, tuple[Any, Any]],
    meanings: Mapping[str, str],
) -> Any:
    """A section of this name with further keys, whose meanings are stated."""
    made: Any = create_model(name, __base__=base, __doc__=summary, __module__=__name__, **dict(fields))  # type: ignore[call-overload]
    made.stated_meanings = dict(meanings)
    return made


def _deviation(name: str, meaning: str) -> Size:
    """The key NAME_deviation of a section [[branch]]."""
    return Size(f"{name}_deviation", meaning, DEVIATION, required=False)


def _of_entries(
    kind: DriveType, name: str, base: type[Section], summary: str, entries: tuple[Entry, ...]
) -> Any:
    """A section with keys that a type states."""
    return _made(
        f"{_camel(kind.name)}{name}",
        base,
        summary,
        {entry.key: _field(entry) for entry in entries},
        {entry.key: _meaning(kind, entry) for entry in entries},
    )


def drive_section(kind: DriveType) -> type[Section]:
    """The section [drive] of a type."""
    count: tuple[Entry, ...] = ()
    if kind.sectors is not None:
        count = (Size(kind.sectors.key, kind.sectors.meaning, kind.sectors.range, start=kind.sectors.start),)
    section: type[Section] = _of_entries(kind, "Drive", RollerDrive, kind.summary, count + kind.sizes)
    return section


def case_of_type(kind: DriveType) -> type[Case]:
    """The model of the joint files of a type."""
    drive = drive_section(kind)
    fields: dict[str, tuple[Any, Any]] = {
        "type": (Literal[kind.name], kind.name if kind.default_type else ...),
        "drive": (drive, ...),
    }
    meanings = {
        "type": "Type of the drive: the paper's, with two loading rollers in the wedges between each planet and the "
        "ring, if absent."
        if kind.default_type
        else "Type of the drive.",
        "drive": "Radii and arrangement.",
    }
    own = kind.bearings
    if own is not None:
        friction = _of_entries(kind, "Bearings", PinEntry, own.summary, own.keys)
        fields["bearings"] = (Optional[friction], None)  # noqa: UP045
        meanings["bearings"] = "Friction of the bearings; none if the section is absent."
        for name, meaning in own.sections.items():
            fields[name] = (Optional[HeldBearing], None)  # noqa: UP045
            meanings[name] = meaning
    sizes = kind.branches
    if sizes is not None:
        entries = tuple(_deviation(name, meaning) for name, meaning in sizes.deviations.items())
        branch = _of_entries(kind, "Branch", Section, sizes.summary, entries)
        fields["branch"] = (Optional[tuple[branch, ...]], None)  # type: ignore[valid-type]  # noqa: UP045
        meanings["branch"] = sizes.meaning
    if kind.model:
        model = _of_entries(kind, "ModelChoice", ModelChoice, ModelChoice.__doc__ or "", kind.model)
        fields["model"] = (model, ...)
        meanings["model"] = "Variants of the model."
    summary = kind.file_summary or f"A joint file with a {kind.words} drive."
    case = _made(f"{_camel(kind.name)}Case", AxisCase if own is None else Case, summary, fields, meanings)
    made: type[Case] = case
    made.drive_type = kind
    if sizes is None:
        case.branch = None  # no key of such a file, but read of every one
    return made

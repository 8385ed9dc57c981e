"""A type of drive: everything that is said of it, once.

Its joint files, their sections, schema and template, the radius that a speed ratio leaves open, and the words of
messages, drawings and reports are made from it. A new type is one file in :mod:`asperity.drive.types`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from asperity.drive.layout.drive import CARRIER, Body, Closure, Contact, Drive
from asperity.drive.layout.sizes import SECTORS, Choice, ContactLength, Entry, Range, Size, profile
from asperity.engine.arrays import xp
from asperity.types import Array, Document, Real

#: Tables of a joint file in SI units.
Tables = Mapping[str, Any]
#: The two bodies of a contact, as tables of listed contacts call them.
SIDES = ("first", "second")


@dataclass(frozen=True)
class Sectors:
    """The key of the number of equal sectors.

    ``key`` in [drive] and its ``meaning``; ``words`` for many of them, as "rollers in a row", and ``each`` for one;
    ``counted``, the words behind their number, where they are others;
    ``range`` of the number, and a number to ``start`` with in a template.
    """

    key: str
    meaning: str
    words: str
    each: str = "sector"
    range: Range = SECTORS
    start: str = "3"
    counted: str = ""

    def words_of(self, count: str) -> str:
        """Their number in words."""
        return f"{count} {self.counted or self.words}"


@dataclass(frozen=True)
class Part:
    """A body of one sector.

    ``name`` and ``place`` as of :class:`~asperity.drive.layout.drive.Body`. ``key`` is NAME in its keys of [drive],
    NAME_wall_thickness of a ring, NAME_support, NAME_bore_diameter, NAME_length, and that of its only track;
    ``material``, its key in [bodies]; ``branch``, NAME in NAME_deviation of a section [[branch]]. All are its name
    where they are empty.
    """

    name: str
    place: Literal["axis", "free", "pin", "held"]
    key: str = ""
    material: str = ""
    branch: str = ""

    @property
    def size_key(self) -> str:
        """NAME in its keys of [drive]."""
        return self.key or self.name


@dataclass(frozen=True)
class Pairing:
    """A contact of one sector: its name, and the names of the bodies that touch.

    ``tracks`` are NAME in the keys NAME_radius and NAME_crown_radius of both bodies; those of the bodies if empty.
    ``internal`` and ``sector`` as of :class:`~asperity.drive.layout.drive.Contact`. ``pressed``: whether it has the
    interference of the drive; as ``internal`` if None, because rings are made too small.
    """

    name: str
    first: str
    second: str
    tracks: tuple[str, str] = ("", "")
    internal: bool = False
    sector: int = 0
    pressed: bool | None = None

    @property
    def has_interference(self) -> bool:
        """Whether it has the interference of the drive."""
        return self.internal if self.pressed is None else self.pressed


class Places(NamedTuple):
    """Where the bodies of a drive are.

    ``centres`` of bodies off the axis, shape (2,) [m]; ``radii`` of the tracks that the file does not state, by their
    names [m]; ``push_angles`` of bodies on pins, 0 for those that are left out [rad].
    """

    centres: Mapping[str, Array]
    radii: Mapping[str, Real] = {}
    push_angles: Mapping[str, Real] = {}


class ShapeSizes(NamedTuple):
    """What a file says of the shape of a body, None where nothing: wall and support of a ring, bore, length [m]."""

    wall: Real | None = None
    support: str | None = None
    bore: Real | None = None
    length: Real | None = None


@dataclass(frozen=True)
class Branches:
    """The sections [[branch]]: their text, the meaning of the list, and of each NAME_deviation by its NAME."""

    summary: str
    meaning: str
    deviations: Mapping[str, str]


@dataclass(frozen=True)
class OwnBearings:
    """Keys of bearings by names of a type's own: ``called``, own name → name in other types.

    ``summary`` and ``keys`` of [bearings]; ``sections``, own name of a section for rolling bearings → meaning.
    """

    summary: str
    keys: tuple[Size, ...]
    sections: Mapping[str, str]
    called: Mapping[str, str]


class Assumed(NamedTuple):
    """A sentence about what is taken of the drive; said unless the file states the key ``unless`` of [drive]."""

    sentence: str
    unless: str = ""


def _no_closure(tables: Tables) -> Closure:
    """What most drives assume in place of compatibility: nothing."""
    return Closure()


def _interference(sizes: Tables) -> str:
    """What makes the preload of most drives."""
    return "interference"


@dataclass(frozen=True, kw_only=True)
class DriveType:
    """A type of drive.

    Parameters
    ----------
    name : str
        The word behind ``type =``.
    words : str
        What it is, in words that "drive" follows.
    summary : str
        What it is, in a sentence.
    rank : int, optional
        Its place in lists of types, by their names among equals.
    sectors : Sectors or None
        The key of the number of sectors; None for a drive of one.
    parts : tuple of Part
        Its bodies.
    contacts : tuple of Pairing
        Its contacts.
    sizes : tuple of Size, Choice and ContactLength
        Keys of [drive] besides the number of sectors, in their order; those of a profile come behind each crown.
    input, output, grounded : str
        Names of members, as of :class:`~asperity.drive.layout.drive.Drive`.
    layout : callable
        From the sizes of [drive] to the places of the bodies.
    sense : int, optional
        Sense of rotation of the input.
    roles : callable or None, optional
        From the sizes of [drive] to output and grounded member, where a key says which they are.
    closure : callable, optional
        From all tables to what is assumed in place of compatibility.
    refuse : callable or None, optional
        Raises an ``InputError`` for a file that no such drive can have; of the texts that its sections [drive] and
        [load] state, by the names of the sections and of their keys.
    pressing_stiffness : callable or None, optional
        From the sizes of [drive] to the stiffness of the spring that presses its one contact [N/m], None where none
        does.
    approach : callable, optional
        From the sizes of [drive] to what the length is called that makes the preload; empty where no length does.
    branches : Branches or None, optional
        The sections [[branch]]; None for a drive whose sectors are alike.
    bearings : OwnBearings or None, optional
        Keys of bearings by names of its own.
    model : tuple of Choice, optional
        Further keys of [model].
    assumed : tuple of Assumed, optional
        What is taken of it, for the list of what is assumed.
    example : str, optional
        Name of its packaged joint file; that of the type if empty.
    file_summary : str, optional
        What a joint file of it is; made of the words if empty.
    default_type : bool, optional
        Whether a file without a type describes it.
    former_names : tuple of str, optional
        Names that it had, which are still read.
    """

    name: str
    words: str
    summary: str
    sectors: Sectors | None
    parts: tuple[Part, ...]
    contacts: tuple[Pairing, ...]
    sizes: tuple[Entry, ...]
    input: str
    output: str
    grounded: str
    layout: Callable[[Tables], Places]
    rank: int = 100
    sense: int = 1
    roles: Callable[[Tables], tuple[str, str]] | None = None
    closure: Callable[[Tables], Closure] = _no_closure
    refuse: Callable[[Mapping[str, Mapping[str, str]]], None] | None = None
    pressing_stiffness: Callable[[Tables], Real | None] | None = None
    approach: Callable[[Tables], str] = _interference
    branches: Branches | None = None
    bearings: OwnBearings | None = None
    model: tuple[Choice, ...] = ()
    assumed: tuple[Assumed, ...] = (Assumed("every track is as long as its longest contact line"),)
    example: str = ""
    file_summary: str = ""
    default_type: bool = False
    former_names: tuple[str, ...] = ()
    _known: frozenset[str] = field(init=False, repr=False, compare=False, default=frozenset())

    def __post_init__(self) -> None:
        """Refuse a type that does not fit together: a contact of no body, a track of no radius."""
        object.__setattr__(self, "sizes", tuple(self._with_profiles()))
        object.__setattr__(self, "_known", frozenset(entry.key for entry in self.sizes))
        for wrong in self._misfits():
            raise TypeError(f"the drive type {self.name!r}: {wrong}")

    def _with_profiles(self) -> Iterator[Entry]:
        """Its sizes, the keys of a profile behind those of each crown."""
        stated = {entry.key for entry in self.sizes}
        rings = [contact.tracks[1] or contact.second for contact in self.contacts if contact.internal]
        sizes = {part.name: part.size_key for part in self.parts}
        for entry in self.sizes:
            yield entry
            name = entry.key.removesuffix("_crown_radius")
            if name != entry.key and f"{name}_profile" not in stated:
                yield from profile(name, ring=name in [sizes.get(ring, ring) for ring in rings])

    def _misfits(self) -> list[str]:
        """What does not fit together."""
        names = [part.name for part in self.parts]
        wrong = [
            f"contact {contact.name!r} joins {body!r}, which is none of its parts"
            for contact in self.contacts
            for body in (contact.first, contact.second)
            if body not in names
        ]
        wrong += [
            f"{role} = {member!r} is none of its members"
            for role, member in (("input", self.input), ("output", self.output), ("grounded", self.grounded))
            if member not in (*names, CARRIER)
        ]
        if (
            not wrong
            and self.branches is not None
            and set(self.branches.deviations) != set(self.sized_tracks({}))
        ):
            wrong.append(
                f"branches.deviations must name {', '.join(self.sized_tracks({}))}, the tracks off the axis"
            )
        if not any(isinstance(entry, ContactLength) for entry in self.sizes):
            wrong.append("its sizes have no ContactLength")
        if self.pressing_stiffness is not None and (len(self.contacts) != 1 or self.sectors is not None):
            wrong.append(
                "pressing_stiffness needs a drive of one contact, which bears the whole force of the spring"
            )
        return wrong

    @property
    def in_frame(self) -> bool:
        """Whether bearings in the frame hold bodies of it."""
        return any(part.place == "held" for part in self.parts)

    @property
    def is_listed(self) -> bool:
        """Whether its file lists its rollers and contacts."""
        return False

    def part(self, name: str) -> Part:
        """One of its bodies."""
        return next(part for part in self.parts if part.name == name)

    def tracks(self, contact: Pairing) -> tuple[str, str]:
        """NAME in NAME_radius and NAME_crown_radius of both bodies of a contact."""
        first, second = (
            track or self.part(body).size_key
            for track, body in zip(contact.tracks, (contact.first, contact.second), strict=True)
        )
        return first, second

    @property
    def material_keys(self) -> tuple[str, ...]:
        """Keys of [bodies]."""
        return tuple(dict.fromkeys(part.material or part.name for part in self.parts))

    def material_key(self, body: str) -> str:
        """Key in [bodies] of one of its bodies; a name that it does not know is its own key."""
        return next((part.material or part.name for part in self.parts if part.name == body), body)

    def contact_names(self, tables: Tables) -> tuple[str, ...]:
        """Names of the contacts, in the order of the drive; of tables as a file states them or in SI units."""
        return tuple(contact.name for contact in self.contacts)

    @property
    def places(self) -> tuple[str, ...]:
        """Places of its rollers off the axis: on pins of the carrier, or free."""
        return tuple(dict.fromkeys(part.place for part in self.parts if part.place in ("free", "pin")))

    @property
    def rings(self) -> tuple[Part, ...]:
        """Its rings: bodies with a wall."""
        return tuple(part for part in self.parts if self.has(f"{part.size_key}_wall_thickness"))

    def has(self, key: str) -> bool:
        """Whether [drive] has a key."""
        return key in self._known

    @property
    def radii(self) -> tuple[str, ...]:
        """Keys of the radii of its tracks, one of which a speed ratio may leave open."""
        return tuple(
            entry.key
            for entry in self.sizes
            if entry.key.endswith("_radius") and getattr(entry, "required", False)
        )

    @property
    def exact_keys(self) -> tuple[str, ...]:
        """Keys that only bodies by plane elasticity know: bores, and walls of rings that nothing holds."""
        bores = [entry.key for entry in self.sizes if entry.key.endswith("_bore_diameter")]
        free = [ring.size_key for ring in self.rings if not self.has(f"{ring.size_key}_support")]
        return (*bores, *(f"{name}_wall_thickness" for name in free))

    def sized_tracks(self, tables: Tables) -> dict[str, tuple[tuple[str, str], ...]]:
        """What every sector has in a size of its own: NAME of NAME_deviation → contacts on it, and on which side."""
        sides = [
            (self.part(body).branch or track, (contact.name, side))
            for contact in self.contacts
            for side, body, track in zip(
                SIDES, (contact.first, contact.second), self.tracks(contact), strict=True
            )
            if self.part(body).place in ("free", "pin")
        ]
        return {
            name: tuple(at for other, at in sides if other == name)
            for name in dict.fromkeys(n for n, _ in sides)
        }

    def sizes_of_tracks(self, tables: Tables) -> dict[str, str]:
        """NAME in NAME_deviation of a branch → NAME in NAME_radius of the drive."""
        own = {part.branch: part.size_key for part in self.parts if part.branch}
        return {name: own.get(name, name) for name in self.sized_tracks(tables)}

    def sides_of_track(self, name: str) -> list[tuple[str, str]]:
        """Contacts on a track by its NAME in NAME_radius, and on which side of each it is."""
        return [
            (contact.name, side)
            for contact in self.contacts
            for side, track in zip(SIDES, self.tracks(contact), strict=True)
            if track == name
        ]

    def crown_radii(self, tables: Tables) -> list[list[Any]]:
        """Crown radii of both tracks of each contact, None for a cylinder [m]."""
        return [
            [tables["drive"].get(f"{track}_crown_radius") for track in self.tracks(contact)]
            for contact in self.contacts
        ]

    def profiles(self, tables: Tables) -> list[list[tuple[Any, Any]]]:
        """Profiles of both tracks of each contact, and the normal forces of logarithmic ones [N], None where absent."""
        return [
            [
                (tables["drive"].get(f"{track}_profile"), tables["drive"].get(f"{track}_profile_load"))
                for track in self.tracks(contact)
            ]
            for contact in self.contacts
        ]

    def deviations(self, branch: Tables) -> Document:
        """Deviations of the tracks that a section [[branch]] states, 0 for the others [m]."""
        return {name: branch.get(f"{name}_deviation", 0.0) for name in self.sized_tracks({})}

    def shapes(self, tables: Tables) -> tuple[ShapeSizes, ...]:
        """What a file says of the shapes of its bodies; of tables in SI units."""
        sizes = tables["drive"]
        return tuple(
            ShapeSizes(
                wall=sizes.get(f"{part.size_key}_wall_thickness"),
                support=sizes.get(f"{part.size_key}_support")
                if self.has(f"{part.size_key}_support")
                else "free",
                bore=sizes.get(f"{part.size_key}_bore_diameter"),
                length=sizes.get(f"{part.size_key}_length"),
            )
            for part in self.parts
        )

    def interference_shares(self, tables: Tables) -> tuple[float, ...]:
        """Interference of each contact over that of the drive."""
        return tuple(1.0 if contact.has_interference else 0.0 for contact in self.contacts)

    def drive_of(self, tables: Tables) -> Drive:
        """The drive of tables in SI units."""
        return self.drive(tables["drive"], closure=self.closure(tables))

    def drive(self, sizes: Tables, *, closure: Closure | None = None) -> Drive:
        """The drive of the sizes of [drive] in SI units, which may be traced."""
        places = self.layout(sizes)
        output, grounded = (self.output, self.grounded) if self.roles is None else self.roles(sizes)
        origin, pins = xp.zeros(2), [part.name for part in self.parts if part.place == "pin"]

        def track_radii(side: int) -> Array:
            names = [self.tracks(contact)[side] for contact in self.contacts]
            known = [
                places.radii[name] if name in places.radii else sizes[f"{name}_radius"] for name in names
            ]
            return xp.stack([xp.asarray(radius, dtype=float) for radius in known])

        return Drive(
            bodies=tuple(Body(part.name, part.place) for part in self.parts),
            contacts=tuple(
                Contact(
                    contact.name,
                    contact.first,
                    contact.second,
                    internal=contact.internal,
                    sector=contact.sector,
                    tracks=self.tracks(contact),
                )
                for contact in self.contacts
            ),
            centres=xp.stack([places.centres.get(part.name, origin) for part in self.parts]),
            first_radius=track_radii(0),
            second_radius=track_radii(1),
            push_angles=xp.stack(
                [xp.asarray(places.push_angles.get(name, 0.0), dtype=float) for name in pins]
            )
            if places.push_angles
            else xp.zeros(len(pins)),
            sectors=1.0 if self.sectors is None else sizes[self.sectors.key],
            input=self.input,
            output=output,
            grounded=grounded,
            sense=self.sense,
            closure=Closure() if closure is None else closure,
        )

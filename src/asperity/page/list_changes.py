"""Lists of sections on the page, such as ``[[duty]]``: how many there are, what each may state, in any order."""

from __future__ import annotations

import copy
import re
from collections.abc import Mapping, Sequence
from typing import Any

import tomlkit

from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.errors import AsperityError, InputError, quoted
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.form_parts import form_parts
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import sized_tracks, type_of
from asperity.joint_file.section import is_list, keys_by_path, meaning
from asperity.joint_file.si_tables import key_at, si_values
from asperity.reading import parse_toml
from asperity.types import Document

#: The change of a list that has one section for each branch of the drive, however many those are.
ONE_PER_BRANCH = "each"
#: The loads of a duty that the page takes.
MOST_LOADS = 50

_PLACES = re.compile(r"\d{1,3}( \d{1,3})*")
_REMARK = re.compile(r"^\s*(#.*)?$")

#: One section: the lines above it that are about it, and those from its header to its last key.
_Section = tuple[list[str], list[str]]


#: The lists of a file that the page shows and changes.
_ON_THE_PAGE = ("branch", "duty", "form")
#: Waves round a part whose amplitudes have a field on the page, besides those of the file.
_WAVES = ("2", "3")
#: Words in the sections of a list: key of the list → key of the word.
_WORDS = {"form": "part"}


def lists_of(model: type[Case]) -> dict[str, str | None]:
    """The lists of a joint file that it may leave out, and that the page changes."""
    sectors = model.drive_type.sectors
    return {
        name: f"drive.{sectors.key}" if name == "branch" and sectors is not None else None
        for name, field in model.model_fields.items()
        if name in _ON_THE_PAGE and is_list(field.annotation) and not field.is_required()
    }


def places_of_lists(
    tables: Mapping[str, Any], changes: Mapping[str, Any], model: type[Case]
) -> dict[str, list[int]]:
    """The wanted arrangement of each list that changes."""
    places = {}
    for name, count_path in lists_of(model).items():
        if name not in changes:
            continue
        if not isinstance(tables.get(name, []), list):
            raise InputError(f"{name}: expected sections [[{name}]], got {quoted(tables[name])}")
        wanted, have = str(changes[name]).strip(), len(tables.get(name, []))
        if wanted == ONE_PER_BRANCH and count_path is not None:
            count = _count(tables, changes, count_path, otherwise=have)
            places[name] = [place if place <= have else 0 for place in range(1, count + 1)]
        elif wanted == "" or _PLACES.fullmatch(wanted):
            places[name] = [int(place) for place in wanted.split()]
        else:
            raise InputError(
                f"{name}: the sections of [[{name}]] are wanted as their places in the file, e.g. '1 3 0' with 0 for a "
                f"new one{f', or {ONE_PER_BRANCH!r}' if count_path else ''}; got {quoted(wanted)}"
            )
    return places


def _count(tables: Mapping[str, Any], changes: Mapping[str, Any], path: str, *, otherwise: int) -> int:
    """Number of branches of the drive; ``otherwise`` where it cannot be read."""
    section, name = path.split(".")
    try:
        key = key_at(path, type_of(tables))
        return round(key.read(changes.get(path, tables[section][name])).value)
    except (InputError, KeyError, TypeError):
        return otherwise


def arrange(tables: Document, places: Mapping[str, list[int]]) -> None:
    """Give the lists of a joint file another arrangement."""
    for name, wanted in places.items():
        sections = rearranged(tables.get(name, []), wanted, name=name)
        tables.pop(name, None)
        if sections:
            tables[name] = [copy.deepcopy(section) for section in sections]


def without_lists(changes: Mapping[str, Any], places: Mapping[str, list[int]]) -> Document:
    """The changes that are left when the lists have their arrangement."""

    def beyond(path: str) -> bool:
        name, _, rest = path.partition(".")
        number = rest.partition(".")[0]
        return changes.get(name) == ONE_PER_BRANCH and number.isdecimal() and int(number) > len(places[name])

    return {path: value for path, value in changes.items() if path not in places and not beyond(path)}


def stated_lists(case: Case, tables: Mapping[str, Any]) -> Document:
    """What the page has to know about the lists of a joint file to make their fields."""
    lists = {}
    for name, count_path in lists_of(type(case)).items():
        keys = [
            path.split(".", 2)[2]
            for path in keys_by_path(type(case), numbers="all")
            if path.startswith(f"{name}.*.")
        ]
        sections = [section for section in tables.get(name, []) if isinstance(section, Mapping)]
        if name == "form":
            keys = [wave for key in keys for wave in _by_waves(key, sections)]
        elif any("*" in key for key in keys):  # names of the rollers of this drive
            rollers = list(sized_tracks(si_values(case)))
            keys = [
                roller_key
                for key in keys
                for roller_key in ([key.replace("*", r) for r in rollers] if "*" in key else [key])
            ]
        lists[name] = {
            "meaning": meaning(type(case), name),
            "keys": keys,
            "words": {_WORDS[name]: _form_parts(case)} if name in _WORDS else {},
            "one_for_each": count_path,
            "most": MOST_LOADS if count_path is None else round(key_at(count_path, case.type).upper),
            "of_file": [_texts(section) for section in sections],
        }
    return lists


def _by_waves(key: str, sections: Sequence[Mapping[str, Any]]) -> list[str]:
    """A key of form errors, that of an amplitude for each number of waves of the file and of the page."""
    if "*" not in key:
        return [key]
    stated = [entry["harmonics"] for entry in sections if isinstance(entry.get("harmonics"), Mapping)]
    waves = {*_WAVES, *(str(wave) for table in stated for wave in table)}
    return [key.replace("*", wave) for wave in sorted(waves, key=lambda wave: (len(wave), wave))]


def _form_parts(case: Case) -> list[str]:
    """Parts of a drive that may have form errors, by one name each, and those that the file names."""
    values = si_values(case)
    stated = [entry.part for entry in case.form or ()]
    try:
        joint = at_once(lambda: joint_from_values(values))
    except AsperityError:  # said where the joint is solved
        return list(dict.fromkeys(stated))
    parts = form_parts(values, as_numbers(joint.drive))
    own = [name for name, tracks in parts.items() if len(tracks) > 1 or tracks[0].name == name]
    return list(dict.fromkeys([*own, *stated]))


def word_in_list(path: str) -> bool:
    """Whether a dotted path is that of a word in a section of a list, such as ``form.2.part``."""
    name, _, rest = path.partition(".")
    number, _, key = rest.partition(".")
    return number.isdecimal() and _WORDS.get(name) == key


def _texts(section: Mapping[str, Any]) -> dict[str, str]:
    """Key → text of a section; ``deviation.left`` for a key in a table of it."""
    texts = {}
    for key, value in section.items():
        if isinstance(value, Mapping):
            texts.update({f"{key}.{below}": text for below, text in _texts(value).items()})
        else:
            texts[key] = str(value)
    return texts


def rearranged(sections: Sequence[Any], places: Sequence[int], *, name: str) -> list[Any]:
    """The sections of a list in another arrangement."""
    for place in places:
        if not 0 <= place <= len(sections):
            raise InputError(f"{name}: the file has no section {place} in [[{name}]]")
    return [sections[place - 1] if place else {} for place in places]


def rearranged_text(text: str, places: Sequence[int], *, name: str) -> str:
    """The text of a joint file with the sections of a list in another arrangement [{…}]."""
    tables = parse_toml(text, source="the joint file")
    wanted = rearranged(tables.get(name, []), places, name=name)
    if wanted == tables.get(name, []):
        return text
    expected = {key: value for key, value in tables.items() if key != name} | (
        {name: wanted} if wanted else {}
    )
    edited = _edited(text, places, name)
    try:
        parsed = parse_toml(edited, source="the joint file")
    except InputError:
        parsed = {}
    return edited if parsed == expected else tomlkit.dumps(expected)


def _edited(text: str, places: Sequence[int], name: str) -> str:
    """The text with whole lines moved, which is right where every section has a header of its own."""
    lines = [line if line.endswith("\n") else f"{line}\n" for line in text.splitlines(keepends=True)]
    header = re.compile(rf"^\s*\[\[\s*{re.escape(name)}\s*\]\]")
    ends = re.compile(rf"^\s*\[(?!\s*{re.escape(name)}\s*\.)")  # not at a table inside the section
    begins = [index for index, line in enumerate(lines) if header.match(line)]
    sections: list[_Section] = []
    first = last = len(lines)
    for begin in begins:
        end = next((i for i in range(begin + 1, len(lines)) if ends.match(lines[i])), len(lines))
        while _REMARK.match(lines[end - 1]):  # what stands above the next section
            end -= 1
        above = begin
        while above > 0 and lines[above - 1].lstrip().startswith("#"):
            above -= 1
        if sections:  # remarks below a section, with an empty line behind them, are its own
            sections[-1][1].extend("".join(lines[last:above]).rstrip("\n").splitlines(keepends=True))
            if not sections[-1][1][-1].endswith("\n"):
                sections[-1][1][-1] += "\n"
        else:
            first = above
        sections.append((lines[above:begin], lines[begin:end]))
        last = end
    new: _Section = ([], [f"[[{name}]]\n"])
    chosen = [sections[place - 1] if place else new for place in places if place <= len(sections)]
    made = "\n".join("".join([*above, *body]) for above, body in chosen)
    before, after = "".join(lines[:first]), "".join(lines[last:])
    if not made:
        after = after.lstrip("\n")
    elif before and not before.endswith("\n\n"):
        before += "\n"
    return before + made + after

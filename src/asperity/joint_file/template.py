"""A commented joint file to start with: the packaged one of a type of drive, or one made of what the type states."""

from __future__ import annotations

from importlib.resources import files

from asperity.drive.layout.drive_type import DriveType
from asperity.drive.layout.sizes import Choice, ContactLength, Entry, Size
from asperity.drive.types import TYPES

#: Packaged joint files of a type besides the one that it is called by → their type.
VARIANTS = {"planetary_hollow": "planetary"}

_WIDEST = 118
_COMMON = """\
[load]
preload = "1000 N"                 # normal force of the first contact, without torque
output_torque = "1 N*m"
sun_speed = "1000 rpm"             # of the input, whatever its name
friction_coefficient = 0.08        # traction fluid; or for each contact, by its name

[model]
contact_factor = "unity"           # or "printed", equation (11), or "hertz_area"
asperity_base = "majumdar_bhushan_1991"  # or "circular_spot"
{model}
[bodies]                           # from the library: asperity materials
{bodies}

# One surface for all contacts, or [surface.NAME] for each contact.
[surface]
fractal_dimension = 1.5
fractal_roughness = "1.3e-7 mm"    # superfinished, towards the rough end
frequency_ratio = 1.5
"""


def names_of_templates() -> tuple[str, ...]:
    """Names of the joint files to start with: the types of drives, each followed by its variants."""
    return tuple(
        name
        for kind in TYPES
        for name in (kind, *(variant for variant, of in VARIANTS.items() if of == kind))
    )


def template(name: str) -> str:
    """The text of a joint file to start with, by one of :func:`names_of_templates`."""
    file = name if name in VARIANTS else TYPES[name].example or name
    packaged = files("asperity.joint_file").joinpath(f"{file}.toml")
    return packaged.read_text(encoding="utf-8") if packaged.is_file() else made_template(TYPES[name])


def made_template(kind: DriveType) -> str:
    """A joint file with every key of [drive] that a type states, those that may be absent behind a #."""
    lines = [f"# {kind.summary}", "#"]
    lines += ['# Every quantity is text with its unit. It may carry a tolerance, "20 mm +- 5 um".', ""]
    lines += [f'type = "{kind.name}"', "", "[drive]"]
    if kind.sectors is not None:
        lines += _with_comment(f"{kind.sectors.key} = {kind.sectors.start}", kind.sectors.meaning)
    for entry in kind.sizes:
        lines += _lines(entry)
    common = _COMMON.format(
        model="".join(f'{word.key} = "{word.words[0]}"\n' for word in kind.model if word.required),
        bodies="\n".join(f'{name} = "52100"' for name in kind.material_keys),
    )
    return "\n".join(lines) + "\n\n" + common


def _lines(entry: Entry) -> list[str]:
    """A key of [drive] with its meaning; behind a # if it may be absent."""
    if isinstance(entry, ContactLength):
        return [f'{entry.key} = "{entry.start}"  # one for all contacts, or a table with one for each']
    example = entry.words[0] if isinstance(entry, Choice) else entry.start or _example(entry)
    line = f"{entry.key} = {example}" if example.isdecimal() else f'{entry.key} = "{example}"'
    if not entry.required:
        return [f"# {each.removeprefix('# ')}" for each in _with_comment(line, entry.meaning)]
    return _with_comment(line, entry.meaning)


def _example(size: Size) -> str:
    """A value that a number could have."""
    return size.range.example or f"10 {size.range.unit}"


def _with_comment(line: str, comment: str) -> list[str]:
    """A line with a comment behind it, or above it where both are too long for one."""
    together = f"{line:<34} # {comment}"
    return [together] if len(together) <= _WIDEST else [*_wrapped(comment), line]


def _wrapped(comment: str) -> list[str]:
    """A comment in lines."""
    lines = ["#"]
    for word in comment.split():
        if len(lines[-1]) + len(word) + 1 > _WIDEST:
            lines.append("#")
        lines[-1] += f" {word}"
    return lines

"""Write docs/joint_file.md from the model of joint files: `python docs/generate_joint_file.py`.

`--check` only compares. `--measure` first computes which results each number moves, in a joint with every section.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from asperity.contact.laws.registry import LAWS
from asperity.joint_file.case_types import CASES, DefaultCase
from asperity.joint_file.fluid_entries import CurveEntry, Fixed, RigEntry, TractionRow
from asperity.joint_file.quantity_key import Entered, Key
from asperity.joint_file.section import Section, meaning

PAGE = Path(__file__).with_name("joint_file.md")
MOVES = Path(__file__).with_name("joint_file_moves.json")
EXAMPLE = Path(__file__).parents[1] / "examples" / "zou2025.toml"

HEAD = """\
# Joint files

<!-- Written by docs/generate_joint_file.py from asperity.joint_file.sections; edit the model, then run it. -->

A joint file is TOML. `asperity init` writes one with comments; `asperity schema` prints the JSON schema, with
which an editor completes and checks keys. A quantity is text with its unit in any unit of its kind, `"13.5
mm"`, and may have a tolerance and a distribution, `"13.5 mm +- 5 um"`. Numbers without a unit are plain. A key
that is not listed here is an error.

A hyphen or a point between two units makes one unit of them: `"5 N-m"`, `"50 in-lb"`, `"20 oz-in"`, `"3 kgf.cm"`,
`"8 N-m/arc-min"`. Pounds and ounces are masses; in a torque they are forces. A negative power has its sign:
`"m^-1"`.

*Moves* names the results that change with the number, computed by exact derivatives for the joint of the paper
with bearings, springs, skew and oil, for the crown radii with crowns of 500 mm, and for the loads of profiles with
profiles for 1000 N; results that change by less than one part in a million for one per cent are left out. *All
seven* are published and assembled stiffness, torque capacity (standing, of slip alone), pressure, drift, efficiency
and life. The range only catches typing errors where physics sets no bound. The results themselves are on the page
[](results.md).

`[bodies]` names the material of `sun`, `planet`, `loading_roller` and `ring`, and of `housing` where there is a
section `[housing]`.
"""

#: Results that the page names, with the words for them.
NAMED = {
    "published_stiffness_output": "published stiffness",
    "assembly_stiffness_output": "assembled stiffness",
    "standing_torque_capacity": "torque capacity",
    "pressure_over_first_yield": "pressure",
    "drift": "drift",
    "efficiency": "efficiency",
    "drive_life": "life",
}

#: Keys and sections that the example leaves out.
LENGTHS = """planet_length = "5 mm"
loading_roller_length = "5 mm"

"""
#: Keys that make another joint of it: only what they move is kept of that one.
CROWNS = """sun_crown_radius = "500 mm"
planet_crown_radius = "500 mm"
loading_roller_crown_radius = "500 mm"
ring_crown_radius = "500 mm"

"""
PROFILES = "".join(
    f'{name}_profile = "logarithmic"\n{name}_profile_load = "1000 N"\n'
    for name in ("sun", "planet", "loading_roller", "ring")
)
SECTIONS = """
[bearings]
sun_torque = "0.001 N*m"
loading_roller_torque = "0.0005 N*m"
carrier_torque = "0.005 N*m"
pin_friction_coefficient = 0.002
pin_diameter = "4 mm"

[compliance]
ring_bending_stiffness = "63 N/um"
pin_stiffness = "100 N/um"
pin_transverse_stiffness = "10 N/um"
planet_support_stiffness = "1 N/um"
input_shaft_stiffness = "500 N*m/rad"
output_shaft_stiffness = "50000 N*m/rad"

[rolling]
skew = "0.2 mrad"
hysteresis_factor = 0.01
reliability = 0.95

[lubrication]
viscosity = "30 mPa*s"
"""


def _parts(annotation: Any) -> Iterator[Any]:
    """An annotation and everything inside it."""
    yield annotation
    for part in get_args(annotation):
        yield from _parts(part)


def _key(field: FieldInfo) -> Key | None:
    for part in (*field.metadata, *_parts(field.annotation)):
        if isinstance(part, Key):
            return part
        if isinstance(part, Fixed | Entered):
            return part.key
    return None


def _choices(field: FieldInfo) -> tuple[str, ...]:
    return next((get_args(p) for p in _parts(field.annotation) if get_origin(p) is Literal), ())


def _allowed(field: FieldInfo) -> tuple[str, str]:
    """Unit and range of a key, or its choices."""
    key = _key(field)
    if key is not None:
        unit = "" if key.unit == "1" else key.unit
        low, high = (
            f"{bound:g}".replace("e+0", "e").replace("e-0", "e-") for bound in (key.lower, key.upper)
        )
        lower, upper = (
            f"{'above ' if key.open_lower else ''}{low}",
            f"{'below ' if key.open_upper else ''}{high}",
        )
        return unit or "-", f"{lower} to {upper}{', whole' if key.integer else ''}"
    choices = _choices(field)
    return "", ", ".join(f"`{choice}`" for choice in choices)


#: Sections of the page that are not where the model has them: those of the drive itself come first.
FIRST = ("drive", "load", "temperature", "bearings", "pin_bearing", "sun_bearing", "carrier_bearing")


#: Sections whose headers are not their names.
HEADERS = {
    "duty": "[[duty]]",
    "form": "[[form]]",
    "tilt": "[tilt.NAME_axis]",
    "branch": "[[branch]]",
    "materials": "[materials.NAME]",
    "fluids": "[fluids.NAME]",
}


def _sections() -> Iterator[tuple[str, type[Section], str]]:
    """Header in the file, model and description of every section; that of the bodies has no keys of its own."""
    for name in (
        *FIRST,
        *(name for name in DefaultCase.model_fields if name not in (*FIRST, "type", "bodies")),
    ):
        field = DefaultCase.model_fields[name]
        model = next(p for p in _parts(field.annotation) if isinstance(p, type) and issubclass(p, Section))
        yield HEADERS.get(name, f"[{name}]"), model, meaning(DefaultCase, name)
        if name == "fluids":
            yield from (
                (f"[{'[' * lists}fluids.NAME.{key}]{']' * lists}", below, meaning(model, key))
                for key, below, lists in (
                    ("traction_table", TractionRow, 1),
                    ("traction_curve", CurveEntry, 1),
                    ("rig", RigEntry, 0),
                )
            )


#: The other types of drives.
OTHER_CASES = {kind: case for kind, case in CASES.items() if case is not DefaultCase}

OTHERS = """\
# Other drives

`type` stands first in the file. These drives have the sections above but for those with the keys below, and
`[input_bearing]` and `[output_bearing]` have the keys of `[sun_bearing]`. `[bodies]` names the material of each body,
and of `housing` where there is a section `[housing]`.
What differs between contacts is a table with the names of the drive's contacts. The types are described on the page
[](drives.md).
"""


def _other_sections() -> Iterator[tuple[str, type[Section], str]]:
    """Sections of the other types of drives: their own [drive] each, and what they have in common."""
    for kind, case in OTHER_CASES.items():
        drive = case.model_fields["drive"].annotation
        assert isinstance(drive, type)
        assert issubclass(drive, Section)
        yield f'[drive] of type = "{kind}"', drive, " ".join((drive.__doc__ or "").split())
    for name in ("roller", "contact"):
        field = CASES["planar"].model_fields[name]
        model = next(p for p in _parts(field.annotation) if isinstance(p, type) and issubclass(p, Section))
        yield f'[[{name}]] of type = "planar"', model, meaning(CASES["planar"], name)
    for kind, case in OTHER_CASES.items():
        if "branch" not in case.model_fields:
            continue
        field = case.model_fields["branch"]
        model = next(p for p in _parts(field.annotation) if isinstance(p, type) and issubclass(p, Section))
        yield f'[[branch]] of type = "{kind}"', model, meaning(case, "branch")
    common = next(iter(OTHER_CASES.values()))
    for name in ("bearings", "model"):
        field = common.model_fields[name]
        model = next(p for p in _parts(field.annotation) if isinstance(p, type) and issubclass(p, Section))
        yield f"[{name}] of other drives", model, meaning(common, name)


def _other_table(model: type[Section]) -> Iterator[str]:
    yield "| key | meaning | unit | range or choices |\n|---|---|---|---|"
    for name, field in model.model_fields.items():
        unit, allowed = _allowed(field)
        optional = "" if field.is_required() else " *Optional.*"
        yield f"| `{name}` | {meaning(model, name)}{optional} | {unit} | {allowed} |"
    yield ""


def _moves() -> dict[str, list[str]]:
    found: dict[str, list[str]] = json.loads(MOVES.read_text(encoding="utf-8"))
    return found


def _table(header: str, model: type[Section], moves: dict[str, list[str]]) -> Iterator[str]:
    yield "| key | meaning | unit | range or choices | moves |\n|---|---|---|---|---|"
    section = header.strip("[]").split(".")[0]
    for name, field in model.model_fields.items():
        unit, allowed = _allowed(field)
        moved = moves.get(f"{section}.{name}", [])
        named = "all seven" if len(moved) == len(NAMED) else ", ".join(moved)
        optional = "" if field.is_required() else " *Optional.*"
        yield f"| `{name}` | {meaning(model, name)}{optional} | {unit} | {allowed} | {named} |"
    yield ""


LAW_TABLE = """\
# Contact laws

The choices of `contact_law`, from the one that knows least of the surface. *Needs* names keys of `[surface]`, of which
`roughness_average` stands for `rms_height`, and with `fractal_dimension` for `fractal_roughness`. *Error*: how stiff a
contact is by the law, over boundary elements ([](validity.md)).

| law | what it is | needs | law of files with | of a measured surface | error |
|---|---|---|---|---|---|
"""
#: What of a measured surface goes in, in words.
TAKEN = {
    "fractal": "D and G",
    "heights": "the heights that each contact feels",
    "decay_length": "the decay length of each contact",
    "nothing": "nothing",
}


def _laws() -> str:
    """A table of the contact laws."""
    rows = []
    for law in LAWS.values():
        needs, default = (", ".join(f"`{key}`" for key in keys) for keys in (law.needs, law.default_for))
        cells = (f"`{law.name}`", law.meaning, needs, default, TAKEN[law.from_measurement], law.error)
        rows.append(f"| {' | '.join(cells)} |\n")
    return LAW_TABLE + "".join(rows)


def page() -> str:
    """The page as it must be."""
    moves = _moves()
    parts = [HEAD]
    for header, model, description in _sections():
        parts += [f"## `{header}`\n", description + "\n", *_table(header, model, moves)]
    parts.append(OTHERS)
    for header, model, description in _other_sections():
        parts += [f"## `{header}`\n", description + "\n", *_other_table(model)]
    return "\n".join([*parts, _laws()])


def measured() -> dict[str, list[str]]:
    """Which results each number moves: key of the file → words for the results."""
    crowned, profiled = _measured(CROWNS), _measured(PROFILES + "\n")
    own = {name: words for name, words in crowned.items() if name.endswith("_crown_radius")}
    return (
        _measured("")
        | own
        | {name: words for name, words in profiled.items() if name.endswith("_profile_load")}
    )


def _measured(more: str) -> dict[str, list[str]]:
    """The same for the example with more keys of its drive."""
    from asperity.joint_file.reader import parse_case
    from asperity.precision import use_double_precision
    from asperity.study.tolerances.sensitivity import sensitivity

    use_double_precision()
    text = EXAMPLE.read_text(encoding="utf-8").replace("[load]", LENGTHS + more + "[load]")
    case = parse_case(text + SECTIONS, source=EXAMPLE.name)
    found = sensitivity(case, tuple(NAMED))
    moves: dict[str, list[str]] = {}
    for path in map(str, found["input"].values):
        section, *_, key = path.split(".")
        here = moves.setdefault(f"{section}.{key}", [])
        one = found.sel(input=path)
        for row, words in zip(map(str, found["result"].values), _words(found), strict=True):
            value = abs(float(one["value"])) or 1.0  # an angle of zero: per radian
            change = (
                0.01
                * value
                * float(one["derivative"].sel(result=row))
                / float(one["result_value"].sel(result=row))
            )
            if abs(change) > 1e-6 and words not in here:
                here.append(words)
    return {name: sorted(words, key=list(NAMED.values()).index) for name, words in moves.items()}


def _words(found: Any) -> Iterator[str]:
    """Words for each row of the sensitivities; the results of contacts have five."""
    for row in map(str, found["result"].values):
        yield next(words for name, words in NAMED.items() if row == name or row.startswith(f"{name}_"))


def main() -> int:
    """Write the page, or with --check say whether it is current."""
    if "--measure" in sys.argv[1:]:
        MOVES.write_text(json.dumps(measured(), indent=1) + "\n", encoding="utf-8")
    if "--check" in sys.argv[1:]:
        if PAGE.read_text(encoding="utf-8") == page():
            return 0
        print("docs/joint_file.md is out of date: run `python docs/generate_joint_file.py`", file=sys.stderr)
        return 1
    PAGE.write_text(page(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())

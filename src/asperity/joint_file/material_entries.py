"""Materials, bodies and surfaces in a joint file, and the contact law that they have."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import BeforeValidator, StringConstraints, WithJsonSchema, model_validator

from asperity.contact.laws.law import ContactLaw
from asperity.contact.laws.registry import LAWS, law_for
from asperity.errors import MOST_ERRORS, InputError, nearest, quoted
from asperity.joint_file import limits
from asperity.joint_file.law_keys import ABSENT, LAW_OF_KEY, LawKeys, refuse_halves, refuse_unknown_keys
from asperity.joint_file.quantity_key import Entered, Quantity
from asperity.joint_file.section import Section
from asperity.surface.measurement_of import WORDS, known_measurement_of

DepthText = Annotated[str, StringConstraints(max_length=100), Entered(limits.MEAN_ROUGHNESS_DEPTH)]


def _named_files(written: Any) -> Any:
    """The names of one or two files, a tuple."""
    names = tuple(written) if isinstance(written, list | tuple) else (written,)
    if not 0 < len(names) <= 2 or not all(isinstance(name, str) and 0 < len(name) <= 1000 for name in names):
        raise InputError(
            "expected the name of the JSON file of a measured surface, or a list of two, one for each "
            f"body, got {quoted(written)}"
        )
    return names


_PATH_SCHEMA = {"type": "string", "minLength": 1, "maxLength": 1000}
Measurements = Annotated[
    tuple[str, ...],
    BeforeValidator(_named_files),
    WithJsonSchema(
        {"anyOf": [_PATH_SCHEMA, {"type": "array", "items": _PATH_SCHEMA, "minItems": 1, "maxItems": 2}]}
    ),
]
OfMeasurement = Annotated[str, BeforeValidator(known_measurement_of), WithJsonSchema({"enum": list(WORDS)})]
#: Keys of a surface beside which no other may stand, but that of what a measurement is.
ALONE = ("measurement", "rms_height", "decay_length")
#: Bodies that a sentence names.
_MOST_NAMES = 8
MaterialName = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9_-]{1,60}$")]


class MaterialEntry(Section):
    """An elastic–plastic material; exactly one of hardness and hardness_factor."""

    youngs_modulus: Annotated[Quantity, limits.YOUNGS_MODULUS]
    """Young's modulus E."""
    poisson_ratio: Annotated[Quantity, limits.POISSON_RATIO]
    """Poisson's ratio."""
    density: Annotated[Quantity, limits.DENSITY]
    """Mass density."""
    yield_strength: Annotated[Quantity, limits.YIELD_STRENGTH]
    """Yield strength."""
    hardness_factor: Annotated[Quantity, limits.HARDNESS_FACTOR] | None = None
    """Hardness over yield strength, k_H; 2.8 for a blunt indenter in a ductile metal."""
    hardness: Annotated[Quantity, limits.HARDNESS] | None = None
    """Indentation hardness as a pressure; in HV, 9.80665 MPa each, or in HRC of steel, by ASTM E140, as well."""
    thermal_conductivity: Annotated[Quantity, limits.THERMAL_CONDUCTIVITY] | None = None
    """Thermal conductivity, for the flash temperature of the contacts."""
    specific_heat_capacity: Annotated[Quantity, limits.SPECIFIC_HEAT_CAPACITY] | None = None
    """Specific heat capacity, for the flash temperature of the contacts."""
    thermal_expansion: Annotated[Quantity, limits.THERMAL_EXPANSION] | None = None
    """Coefficient of linear thermal expansion, for [temperature]."""
    fatigue_strength: Annotated[Quantity, limits.FATIGUE_STRENGTH] | None = None
    """Amplitude of a stress of mean zero that the finished part endures, its surface, size and reliability counted; for
    the fatigue of ring and hollow rollers, which have no safety against it without this number."""
    tensile_strength: Annotated[Quantity, limits.TENSILE_STRENGTH] | None = None
    """Tensile strength, for the influence of the mean stress on fatigue (Goodman); without it the yield strength takes
    its place (Soderberg), which is on the safe side."""

    @model_validator(mode="after")
    def _one_hardness(self) -> MaterialEntry:
        if (self.hardness is None) == (self.hardness_factor is None):
            given = "neither" if self.hardness is None else "both"
            raise InputError(f"exactly one of 'hardness' and 'hardness_factor' is needed, got {given}")
        return self


class SurfaceKeys(Section):
    """Keys of a surface, apart from those that a contact law states itself."""

    finish: Annotated[str, StringConstraints(max_length=60)] | None = None
    """Finish of the library, e.g. "ground", for the published range of fractal_dimension; of all finishes if absent."""
    measurement: Measurements | None = None
    """Measured surface of all contacts in place of all other keys of this section: name of the JSON file of `asperity
    surface measure --json`, from the folder of the joint file, or a list of two, one for each body."""
    measurement_of: OfMeasurement | None = None
    """What one measurement is of: "body", as both bodies of a contact then are, or "pair", of both together; if absent,
    what its document says: a pair where `asperity surface combine` made it, otherwise one body."""
    rms_height: Annotated[Quantity, limits.RMS_HEIGHT] | None = None
    """Root mean square of the heights of both bodies together, of the waves shorter than the contact is wide; in place
    of all other keys of this section, for the contact law of randomly rough surfaces."""
    decay_length: Annotated[Quantity, limits.DECAY_LENGTH] | None = None
    """Distance of both bodies in which their pressure falls by the factor e: normal force over normal stiffness of the
    asperities, from a measured map or a measured stiffness; in place of all other keys of this section."""
    fractal_dimension: Annotated[Quantity, limits.FRACTAL_DIMENSION] | None = None
    """Fractal dimension D of a profile; that of the finish if absent."""
    fractal_roughness: Annotated[Quantity, limits.FRACTAL_ROUGHNESS] | None = None
    """Fractal roughness G; either this, roughness_average or rms_height."""
    roughness_average: Annotated[Quantity, limits.ROUGHNESS_AVERAGE] | None = None
    """Ra of one body, from its drawing: for the contact law of randomly rough surfaces. It does not say what D is."""
    mean_roughness_depth: DepthText | None = None
    """Rz of one body in place of its Ra, text with its unit, 0.001 to 100 um. It is read as the range of Ra that
    normally distributed heights with this Rz have; studies vary roughness_average."""
    partner_roughness_average: Annotated[Quantity, limits.PARTNER_AVERAGE] | None = None
    """Ra of the other body; the same if absent."""
    partner_mean_roughness_depth: DepthText | None = None
    """Rz of the other body in place of its Ra, read as mean_roughness_depth is, with the same cut-off."""
    cut_off: Annotated[Quantity, limits.CUT_OFF] | None = None
    """Cut-off of the profile filter with which roughness_average is measured; that of ISO 4288 for this Ra or Rz
    if absent. With an Rz one of 0.08, 0.25, 0.8, 2.5 and 8 mm."""
    frequency_ratio: Annotated[Quantity, limits.FREQUENCY_RATIO] | None = None
    """Ratio gamma of successive frequencies of the Weierstrass–Mandelbrot profile; usually 1.5, as beside an Ra."""


class SurfaceEntry(LawKeys, SurfaceKeys):
    """Roughness of a contact: D and G of both bodies together, the Ra of each, a length, or a measurement."""

    def stated_keys(self) -> frozenset[str]:
        """The keys that have a value, one of a finish or of an Rz among them."""
        return frozenset(name for name, value in self if value is not None)

    def _of_one_law(self) -> bool:
        """Whether keys that one law states say all of the roughness; an ``InputError`` if one of them is missing."""
        stated = self.stated_keys()
        own = [key for key in LAW_OF_KEY if key in stated]
        if not own or stated & {"fractal_roughness", "roughness_average"}:
            return False
        law = LAW_OF_KEY[own[0]]
        missing = [key for key in law.needs if key not in stated]
        if missing:
            raise InputError(
                f".{own[0]}: the contact law {law.name} takes it with {joined(list(law.needs))}: give "
                f"{joined(missing)}, or leave {joined(own)} out"
            )
        return True

    @model_validator(mode="after")
    def _one_roughness(self) -> SurfaceEntry:
        refuse_halves(self.stated_keys())
        for alone in ALONE:
            stated = getattr(self, alone)
            if stated is None:
                continue
            other = ("measurement_of",) if alone == "measurement" else (*LAW_OF_KEY, *ABSENT)
            beside = self.model_fields_set - {alone, *other}
            if beside:
                raise InputError(
                    f"{alone} stands alone, it is all that a contact law takes of the surface; leave "
                    f"{', '.join(sorted(beside))} out, or {alone} itself"
                )
            if alone != "measurement" and stated.tolerance >= stated.value:
                raise InputError(
                    f"{alone}: {quoted(stated.text)} reaches down to zero; its tolerance has to be smaller"
                )
            return self
        if self.measurement_of is not None:
            raise InputError("measurement_of: only with measurement; leave it out")
        if self._of_one_law():
            return self
        for name in ("fractal_dimension", "frequency_ratio"):
            if getattr(self, name) is None:
                raise InputError(f".{name}: this key is missing")
        if (self.fractal_roughness is None) == (self.roughness_average is None):
            given = "neither" if self.fractal_roughness is None else "both"
            raise InputError(
                "exactly one of 'fractal_roughness' and 'roughness_average' (or 'mean_roughness_depth') is needed, "
                f"got {given}"
            )
        of_average = ("partner_roughness_average", "partner_mean_roughness_depth", "cut_off")
        lonely = [name for name in of_average if getattr(self, name) is not None]
        if lonely and self.roughness_average is None:
            raise InputError(
                f"{' and '.join(lonely)}: only with roughness_average or mean_roughness_depth; leave out, or give one"
            )
        for name in ("roughness_average", "partner_roughness_average"):
            average = getattr(self, name)
            if average is not None and average.tolerance > average.value:
                raise InputError(
                    f"{name}: {quoted(average.text)} reaches below zero; its tolerance has to be smaller"
                )
        return self


refuse_unknown_keys(set(SurfaceEntry.model_fields))


def one_kind_of_roughness(surface: Any) -> Any:
    """The surfaces of all contacts, which one law has to describe; or a refusal."""
    if isinstance(surface, Mapping):
        kinds: dict[str, list[str]] = {}
        for name, entry in surface.items():
            kind = next((f"by {key}" for key in (*ALONE, *LAW_OF_KEY) if getattr(entry, key)), "fractal")
            if kind == "by measurement":
                raise InputError(
                    f"{name}.measurement: a measured surface is that of all contacts; give it in [surface], without "
                    "tables for each contact"
                )
            kinds.setdefault(kind, []).append(name)
        if len(kinds) > 1:
            told = ", ".join(f"{', '.join(kinds[kind])} {kind}" for kind in sorted(kinds))
            raise InputError(f"one contact law for all contacts: {told}; give all of them in one way")
    return surface


def unknown_materials(bodies: Any, known: Iterable[str]) -> list[str]:
    """Messages about bodies whose material is not defined, one for each such material."""
    defined = dict.fromkeys(known)
    if not isinstance(bodies, Mapping):
        return []
    users: dict[str, list[str]] = {}
    for body, name in bodies.items():
        if isinstance(name, str) and name not in defined:
            users.setdefault(name, []).append(f"bodies.{body}")
    choice = f"; the file defines {joined(list(defined))}; 'asperity materials' lists the library"
    return [
        f"{joined(paths)}: there is no material {quoted(name)}"
        f"{(nearest(name, defined) if number < MOST_ERRORS else '') or choice}"
        for number, (name, paths) in enumerate(users.items())
    ]


def joined(names: list[str]) -> str:
    """Names in one text; those beyond eight are counted."""
    more = len(names) - _MOST_NAMES
    return ", ".join(names[:_MOST_NAMES]) + (f" and {more} more" if more > 0 else "")


if TYPE_CHECKING:
    ContactLawName = str
else:
    ContactLawName = Literal[tuple(LAWS)]
#: Numbers of a surface that follow from its Ra.
OF_AVERAGE = ("fractal_roughness", "rms_height")


def law_words() -> str:
    """What ``model.contact_law`` chooses among, and the law of a file that states none."""
    laws = "; ".join(f"{name}, {law.meaning}" for name, law in LAWS.items())
    default = "; ".join(
        f"{law.name} for {', '.join(law.default_for)}" for law in LAWS.values() if law.default_for
    )
    return f"Law of the asperities: {laws}. If absent, that of the keys of the surfaces: {default}."


def contact_law_of(surfaces: Iterable[Collection[str]], *, stated: ContactLawName | None) -> ContactLawName:
    """The law of the asperities of all contacts, from the keys that each surface states and ``model.contact_law``.

    Without a statement, of the laws that take what all surfaces state, the one that knows most and is the law of files
    with such keys. An ``InputError`` is raised if a surface does not state what the law needs.
    """
    stated_keys = list(surfaces)
    if any("measurement" in keys for keys in stated_keys):  # until it is read
        return stated or law_for("measurement").name
    served = served_laws(stated_keys)
    if stated is None:
        default = _of_no_statement(served, stated_keys)
        if default is None:
            raise InputError(_none(served, stated_keys))
        return default
    if LAWS[stated] not in served:
        raise InputError(_unserved(LAWS[stated], stated_keys, served))
    return stated


def _of_no_statement(
    served: list[type[ContactLaw]], surfaces: list[Collection[str]]
) -> ContactLawName | None:
    """The law that knows most of those that are the law of files with such keys; None without one."""
    default = [law.name for law in served if any(key in keys for keys in surfaces for key in law.default_for)]
    return default[-1] if default else None


def _none(served: list[type[ContactLaw]], surfaces: list[Collection[str]]) -> str:
    """Why surfaces have no law, and what to do about it."""
    if served:
        return f"surfaces by {_told_keys(surfaces)}: state model.contact_law = {_choice(served)}"
    return (
        "one contact law for all contacts: no law takes what all of these surfaces state, "
        f"{_told_keys(surfaces)}; give all of them in one way"
    )


def _choice(laws: list[type[ContactLaw]]) -> str:
    """The names of laws as a joint file states them."""
    return " or ".join(f'"{law.name}"' for law in laws)


def served_laws(surfaces: Iterable[Collection[str]]) -> list[type[ContactLaw]]:
    """The laws that take what all surfaces state, by their keys, from the one that knows least."""
    known = [{*keys, *(OF_AVERAGE if "roughness_average" in keys else ())} for keys in surfaces]
    return [law for law in LAWS.values() if all(keys.issuperset(law.needs) for keys in known)]


def _told_keys(surfaces: list[Collection[str]]) -> str:
    """The keys that say how rough surfaces are."""
    telling = ("fractal_roughness", "roughness_average", *ALONE, *LAW_OF_KEY)
    return ", ".join(key for key in telling if any(key in keys for keys in surfaces))


def _unserved(law: type[ContactLaw], surfaces: list[Collection[str]], served: list[type[ContactLaw]]) -> str:
    """Why surfaces do not serve a law, and what to do about it."""
    needs = f'model.contact_law = "{law.name}" needs {law.needs_words}'
    if law.from_measurement == "decay_length":
        return f"{needs} beside the file, or surface.{' and '.join(law.needs)} in it, for all contacts"
    average = [f"; roughness_average stands for {key}" for key in law.needs if key in OF_AVERAGE]
    remedies = ["leave contact_law out"] if _of_no_statement(served, surfaces) else []
    remedies += [f"state {_choice(served)}"] if served else []
    return (
        f"{needs}, while surfaces state {_told_keys(surfaces)}: {', '.join([*remedies, ''])}"
        f"{'or ' if remedies else ''}give {joined(list(law.needs))} of all contacts{''.join(average)}"
    )

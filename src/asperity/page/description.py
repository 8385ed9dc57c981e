"""The parameters of a joint file for the page: groups, meaning, unit, range and default, from the file's own model."""

from __future__ import annotations

import functools
import re

from pydantic import BaseModel

import asperity
from asperity.joint_file.case_types import DefaultCase
from asperity.joint_file.choices import CHOICES, choices_of_case
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import HOUSING, contacts_of
from asperity.joint_file.section import keys_by_path, meaning, models_of
from asperity.joint_file.si_tables import counterparts, si_values
from asperity.library import FREQUENCY_RATIO, read_finishes, read_materials
from asperity.types import Document
from asperity.units import Dimension, from_si, parse_quantity

#: Section of a joint file → heading of its group, in the order of the page.
HEADINGS = {
    "drive": "Drive",
    "branch": "Branches of unlike sizes",
    "load": "Load",
    "temperature": "Temperature",
    "heat": "Heat",
    "surface": "Surfaces",
    "materials": "Materials",
    "roller": "Rollers",
    "contact": "Contacts",
    "compliance": "Structure",
    "housing": "Housing",
    "play": "Play",
    "bearings": "Bearing friction",
    "pin_bearing": "Rolling bearings of the pins",
    "sun_bearing": "Rolling bearings of the sun",
    "carrier_bearing": "Rolling bearings of the carrier",
    "input_bearing": "Rolling bearings of the input",
    "output_bearing": "Rolling bearings of the output",
    "rolling": "Rolling",
    "wear": "Wear",
    "tilt": "Tilted axes",
    "form": "Form errors",
    "lubrication": "Lubrication",
    "fluids": "Oils",
    "life": "Life",
    "duty": "Duty",
    "dynamics": "Dynamics",
}


def description() -> Document:
    """What can be set on the page."""
    return {
        "asperity_version": asperity.__version__,
        **_form(DefaultCase, tuple(CHOICES.items())),
        "contacts": list(contacts_of({})),
        "units": {quantity.label: _units(quantity) for quantity in Dimension if quantity.si_unit != "1"},
        "materials": [
            {"name": name, "description": entry.description, "reference": entry.reference}
            for name, entry in read_materials().items()
        ],
        "finishes": [
            {
                "name": name,
                "description": entry.description,
                "reference": entry.reference,
                "roughness_average_um": [float(f"{1e6 * value:.6g}") for value in entry.roughness_average],
                "fractal_dimension": list(entry.fractal_dimension),
                "fractal_roughness_mm": [1e3 * value for value in entry.fractal_roughness],
                "frequency_ratio": FREQUENCY_RATIO,
            }
            for name, entry in read_finishes().items()
        ],
    }


def _units(dimension: Dimension) -> list[Document]:
    """The units offered for a quantity, from the smallest: how many make an SI unit, and where they begin [SI]."""
    units = [(from_si(1.0, unit), unit, parse_quantity(f"0 {unit}", dimension)) for unit in dimension.units]
    return [{"per_si": one, "unit": unit, "zero": zero} for one, unit, zero in sorted(units, reverse=True)]


def form_of(case: Case) -> Document:
    """What can be set in one joint file."""
    return {
        **_form(type(case), tuple(choices_of_case(case).items())),
        "contacts": list(contacts_of(si_values(case))),
    }


@functools.lru_cache(maxsize=8)
def _form(case_type: type[Case], choices: tuple[tuple[str, tuple[str, ...]], ...]) -> Document:
    groups = [
        {"name": name, "heading": heading, "parameters": _parameters(case_type, name)}
        for name, heading in HEADINGS.items()
        if name in case_type.model_fields
    ]
    return {"groups": groups, "choices": [_choice(case_type, path, words) for path, words in choices]}


def _parameters(case_type: type[BaseModel], section: str) -> list[Document]:
    parameters = []
    for path, key in keys_by_path(case_type, numbers="all").items():
        if path.split(".")[0] == section:
            model, name = _field(case_type, path)
            field = model.model_fields[name]
            said = meaning(model, name)
            parameters.append(
                {
                    "key": path,
                    "meaning": said,
                    "dimension": key.dimension.label,
                    "unit": key.unit,
                    "lowest": key.lower,
                    "highest": key.upper,
                    "lowest_included": not key.open_lower,
                    "highest_included": not key.open_upper,
                    "whole": key.integer,
                    "allowed": key.allowed,
                    "example": key.typical,
                    "example_value": float(
                        f"{from_si(parse_quantity(key.typical, key.dimension), key.unit):.14g}"
                    ),
                    "required": field.is_required(),
                    "default": _default(said),
                    "replaces": list(counterparts(name)),
                }
            )
    return parameters


def _default(text: str) -> str | None:
    """Words of a meaning for an absent key; None without any."""
    said = re.search(r"[^;,.]*(?:\d\.\d+)? if absent[^;.]*", text)
    if said is None:
        said = re.search(r"if absent, [^;.]*|Without it [^.]*", text)
    words = said.group(0).strip() if said else "if absent"
    return None if words == "if absent" else words[0].lower() + words[1:]


def _field(case_type: type[BaseModel], path: str) -> tuple[type[BaseModel], str]:
    """The model and the name of the field that describe a path best: for one contact, that of the whole entry."""
    model: type[BaseModel] = case_type
    name = ""
    for part in path.split("."):
        if part == "*":
            continue
        if name:
            below = models_of(model.model_fields[name].annotation)
            inside = [inner for inner in below if part in inner.model_fields]
            if not inside:
                return model, name
            model = inside[0]
        name = part
    return model, name


def _choice(case_type: type[BaseModel], path: str, words: tuple[str, ...]) -> Document:
    model, name = _field(case_type, path)
    field = model.model_fields[name]
    said = meaning(model, name)
    section = path.split(".")[0]
    return {
        "key": path,
        "group": section,
        "meaning": said,
        "words": list(words),
        "required": field.is_required()
        and case_type.model_fields[section].is_required()
        and path != f"bodies.{HOUSING}",
        "default": _default(said),
    }

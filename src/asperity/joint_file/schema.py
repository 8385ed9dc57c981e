"""The JSON schema of joint files."""

from __future__ import annotations

from asperity.drive.types import DEFAULT_TYPE
from asperity.joint_file.case_types import CASES
from asperity.joint_file.law_keys import BESIDE, LAW_OF_KEY
from asperity.joint_file.material_entries import ALONE, MaterialEntry, SurfaceEntry
from asperity.joint_file.model import Case
from asperity.joint_file.open_radius import radii_of
from asperity.joint_file.section import models_of
from asperity.library import read_finishes, read_materials
from asperity.types import Document

Schema = Document


def joint_schema(kind: str = DEFAULT_TYPE) -> Schema:
    """JSON Schema (draft 2020-12) of a joint file of one type after TOML is read, for editors such as those with Taplo.

    It cannot express the bounds of quantities with units, nor that a body's material is one that the file or the
    library has; the reader checks them.
    """
    schema = CASES[kind].model_json_schema(mode="validation")
    _offer_library(schema)
    _offer_ratio(schema, CASES[kind])
    _offer_finishes(schema)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **schema,
        "title": "Joint file of asperity",
    }


def _offer_library(schema: Schema) -> None:
    """Add what :func:`asperity.library.fill_in_materials` fills in before the model sees the file."""
    library = read_materials()
    designations = [name for material in library.values() for name in material.also]
    names = {
        "enum": [*library, *designations],
        "description": "A material of the library: asperity materials.",
    }
    schema["required"].remove("materials")  # bodies may name the library's
    materials = schema["properties"]["materials"]
    del materials["minProperties"]
    materials["additionalProperties"] = False

    bodies = schema["properties"]["bodies"]["patternProperties"]
    for body in bodies.values():
        name_in_file = {
            "type": body.pop("type"),
            "pattern": body.pop("pattern"),
            "description": "A name of [materials].",
        }
        body["anyOf"] = [names, name_in_file]

    entry = schema["$defs"][MaterialEntry.__name__]
    numbers_needed = {
        "required": entry.pop("required"),
        "oneOf": [{"required": ["hardness"]}, {"required": ["hardness_factor"]}],
    }
    entry["description"] += " With 'library', its numbers are filled in, and keys beside it replace them."
    entry["properties"] = {
        "library": {
            "title": "Library",
            "description": "Name in the library, or in the library file that 'file' names.",
            "anyOf": [names, {"type": "string"}],
        },
        "file": {
            "title": "File",
            "description": "A library file of your own, relative to the joint file.",
            "type": "string",
        },
        **entry["properties"],
    }
    entry["dependentRequired"] = {"file": ["library"]}
    entry["if"] = {"required": ["library"]}
    entry["then"] = {
        "if": {"not": {"required": ["file"]}},
        "then": {"properties": {"library": names}},
        "not": {"required": ["hardness", "hardness_factor"]},
    }
    entry["else"] = numbers_needed


def _offer_ratio(schema: Schema, model: type[Case]) -> None:
    """Let a speed ratio stand in place of one radius, see :func:`asperity.joint_file.open_radius.fill_in_radius`."""
    radii = list(radii_of(model))
    if not radii:
        return
    (drive,) = models_of(model.model_fields["drive"].annotation)
    entry = schema["$defs"][drive.__name__]
    entry["required"] = [name for name in entry["required"] if name not in radii]
    one_open = [{"required": [other for other in radii if other != name]} for name in radii]
    entry |= {"if": {"required": ["ratio"]}, "then": {"oneOf": one_open}, "else": {"required": radii}}


def _offer_finishes(schema: Schema) -> None:
    """Add what :func:`asperity.joint_file.finish_in_surface.fill_in_finishes` fills in; the choice of G, Ra or Rz."""
    entry = schema["$defs"][SurfaceEntry.__name__]
    entry["properties"]["finish"] = {
        "title": "Finish",
        "description": entry["properties"]["finish"]["description"],
        "enum": list(read_finishes()),
    }
    heights = [{"required": ["roughness_average"]}, {"required": ["mean_roughness_depth"]}]
    own = [list(law.needs) for law in dict.fromkeys(LAW_OF_KEY.values()) if not {*law.needs} & {*ALONE}]
    entry["oneOf"] = [{"required": keys} for keys in (["fractal_roughness"], *([key] for key in ALONE), *own)]
    entry["oneOf"] += heights
    entry["anyOf"] = [
        {"required": keys}
        for keys in (["finish"], ["fractal_dimension", "frequency_ratio"], *([key] for key in ALONE), *own)
    ]
    entry["dependentSchemas"] = {
        name: {"anyOf": heights}
        for name in ("partner_roughness_average", "partner_mean_roughness_depth", "cut_off")
    }
    entry["dependentRequired"] = {key: [beside] for key, beside in BESIDE.items()}
    entry["not"] = {"required": ["partner_roughness_average", "partner_mean_roughness_depth"]}

"""Messages about errors of a joint file: the key, the value, what is allowed, and one message for each mistake."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from asperity.drive.types import DEFAULT_TYPE, TYPES
from asperity.errors import MOST_ERRORS, closest, nearest, quoted
from asperity.joint_file.case_types import CASES
from asperity.joint_file.material_entries import joined, unknown_materials
from asperity.joint_file.section import ONE_FOR_ALL, ONE_FOR_EACH, keys_by_path, models_of, variants

#: Errors of pydantic that are explained: a misspelt key is two of them, an unknown key and a missing one.
_MOST_EXPLAINED = 10 * MOST_ERRORS

#: Keys of the file from its root to what is meant.
Parts = tuple[str, ...]


def _known_names(path: tuple[str, ...], model: type[BaseModel]) -> list[str]:
    """Names that a table at this path may contain."""
    models: list[type[BaseModel]] = [model]
    for part in path:
        annotations = [model.model_fields[part].annotation for model in models if part in model.model_fields]
        below = [v for annotation in annotations for v in variants(annotation)]
        models = [m for v in below for m in models_of(v)]
        if any(get_origin(v) in (dict, tuple) for v in below):
            # the entries have names of their own; beside them there may be one table for all
            for_all = [m for v in below if get_origin(v) is None for m in models_of(v)]
            return _names_below(models if len(path) == 2 else for_all)
    return _names_below(models)


def _names_below(models: list[type[BaseModel]]) -> list[str]:
    return list(dict.fromkeys(name for model in models for name in model.model_fields))


def _parts(error: ErrorDetails) -> Parts:
    """Keys on the way to an error; loads of the duty are counted from 1."""
    return tuple(
        str(part + 1) if isinstance(part, int) else part
        for part in error["loc"]
        if part not in (ONE_FOR_ALL, ONE_FOR_EACH, "[key]")
    )


def _sentence(parts: Parts, error: ErrorDetails, model: type[BaseModel]) -> str:
    """One error of pydantic as 'key: what is wrong'."""
    path = ".".join(parts)
    kind, value, context = error["type"], error["input"], error.get("ctx", {})
    if kind == "missing":
        return f"{path}: this key is missing{_wanted(parts, model)}"
    if kind in ("model_type", "model_attributes_type", "dict_type"):
        known = ", ".join(_known_names(parts, model)) or "entries"
        return f"{path}: expected a table with {known}, got {quoted(value)}"
    if kind == "literal_error":
        return f"{path}: {quoted(value)} is not one of {context['expected']}"
    if kind == "string_pattern_mismatch":
        what = "fluid" if parts[0] == "fluids" else "material"
        return f"{path}: the name of a {what} consists of letters, digits, '-' and '_', got {quoted(value)}"
    if kind == "string_type" and parts[0] == "lubrication":
        return f"{path}: expected the name of a fluid, e.g. 'M100', got {quoted(value)}"
    if kind == "string_type":
        return f"{path}: expected the name of a material, e.g. 'steel', got {quoted(value)}"
    if kind == "tuple_type":
        noun = {"branch": "planet", "form": "part"}.get(path, "load")
        return f"{path}: expected sections [[{path}]], one for each {noun}, got {quoted(value)}"
    if kind == "too_short":
        return f"{path}: the section is empty"
    if kind == "value_error":
        reason = str(context["error"])
        if reason.startswith("."):  # about a key of the section
            key = reason[1:].partition(":")[0]
            return f"{path}{reason}{_wanted((*parts, key), model)}"
        return f"{path}: {reason}" if path else reason
    return f"{path}: {error['msg']}, got {quoted(value)}"


def _wanted(parts: Parts, model: type[BaseModel]) -> str:
    """What a missing key has to be, with an example."""
    generic = ".".join(
        "*" if i == 1 and parts[0] in ("materials", "fluids", "duty", "form", "branch", "tilt") else part
        for i, part in enumerate(parts)
    )
    key = keys_by_path(model).get(generic)
    if key:
        return f": {key.dimension.label}, e.g. '{key.typical}'"
    if parts[0] == "bodies":
        return ": the name of a material, e.g. 'steel'"
    section = model.model_fields.get(parts[0])
    for below in models_of(section.annotation) if section else []:
        choice = below.model_fields[parts[-1]].annotation if parts[-1] in below.model_fields else None
        if get_origin(choice) is Literal:
            return ": one of " + ", ".join(f"'{name}'" for name in get_args(choice))
    return ""


def _unknown_key(
    parts: Parts, value: Any, absent: set[Parts], model: type[BaseModel]
) -> tuple[str, Parts | None]:
    """What to say of an unknown key or section, and which missing one it was meant to be."""
    path, name, table = ".".join(parts), parts[-1], parts[:-1]
    what = "section" if isinstance(value, dict) else "key"
    other = closest(name, (missing[-1] for missing in absent if missing[:-1] == table))
    if other:
        return f"{path}: unknown {what}; did you mean '{other}'?", (*table, other)
    for missing in absent:
        if missing[-1] == name:
            return f"{path}: unknown {what}; it belongs in [{'.'.join(missing[:-1])}]", missing
    having, known = _drives_with(parts), _known_names(table, model)
    other = _CALLED_HERE.get(name)
    here = f"; for this drive write '{other}'" if other in known else ""
    if having == [DEFAULT_TYPE]:
        return f'{path}: only for the paper\'s drive (type = "{DEFAULT_TYPE}", or no type){here}', None
    if having and parts[0] == "branch" and len(parts) > 1:
        return f"{path}: this drive has no such roller; here you can write {', '.join(known)}", None
    if having:
        named = ", ".join(f'"{kind}"' for kind in having)
        return f"{path}: only for drives of type {named}{here}", None
    sections = sorted(
        {key_path.split(".")[0] for key_path in keys_by_path(model) if key_path.split(".")[-1] == name}
    )
    if sections and name not in known:
        # a branch has deviations of what another section states
        meant = nearest(name, known).removeprefix("; ") if parts[0] == "branch" else ""
        return f"{path}: unknown {what}; it belongs in [{sections[0]}]{meant and f', or {meant}'}", None
    return f"{path}: unknown {what}{nearest(name, known) or '; known here are ' + ', '.join(known)}", None


#: What a type of drive has by a name of its own and other drives by another.
_CALLED_HERE = {
    one: other
    for kind in TYPES.values()
    if kind.bearings is not None
    for pair in kind.bearings.called.items()
    for one, other in (pair, pair[::-1])
}


def _drives_with(parts: Parts) -> list[str]:
    """Types of the drives whose files may have a key."""
    return [kind for kind, other in CASES.items() if parts[-1] in _known_names(parts[:-1], other)]


def _missing_sections(sections: list[Parts], model: type[BaseModel]) -> str:
    names = ", ".join(f"[{'.'.join(section)}]" for section in sections)
    if len(sections) == 1:
        return f"the section {names} is missing; it contains {_content(sections[0], model)}"
    return f"the sections {names} are missing; 'asperity init' writes a complete example"


def _content(parts: Parts, model: type[BaseModel]) -> str:
    """What a section contains, whose entries may have names of their own."""
    if parts == ("materials",):
        return "a section for each material"
    if parts == ("bodies",):
        (kind,) = get_args(model.model_fields["type"].annotation)
        return ", ".join(TYPES[kind].material_keys) or "the material of each roller"
    return ", ".join(
        _known_names(parts, model) or _names_below(models_of(model.model_fields[parts[0]].annotation))
    )


def _is_section(parts: Parts, model: type[BaseModel]) -> bool:
    known = _known_names(parts, model)
    # the keys of a table for all contacts stand beside the names of the contacts
    return parts in (("materials",), ("bodies",), ("surface",)) or (bool(known) and parts[-1] not in known)


def explained(
    error: ValidationError, tables: Mapping[str, Any], refused: Mapping[str, str], *, model: type[BaseModel]
) -> tuple[list[str], int]:
    """Messages about the errors of a file, one for each mistake."""
    mistakes = [(_parts(detail), detail) for detail in error.errors(include_url=False)]
    if refused:
        mistakes = [
            (parts, detail)
            for parts, detail in mistakes
            if not any(".".join(parts[:length]) in refused for length in (1, 2))
        ]
    more = max(len(mistakes) - _MOST_EXPLAINED, 0)
    mistakes = mistakes[:_MOST_EXPLAINED]
    wrong = {parts[:1] for parts, _ in mistakes if len(parts) > 1}
    mistakes = [
        (parts, detail) for parts, detail in mistakes if detail["type"] != "too_short" or parts not in wrong
    ]
    absent = {parts for parts, detail in mistakes if detail["type"] == "missing"}
    foreign = [_drives_with(parts) for parts, detail in mistakes if detail["type"] == "extra_forbidden"]
    likely = set.intersection(*map(set, foreign)) - {DEFAULT_TYPE} if foreign else set()
    if absent and likely and "type" not in tables:
        kinds = " or ".join(f'type = "{kind}"' for kind in foreign[0] if kind in likely)
        names = joined([".".join(parts) for parts, detail in mistakes if detail["type"] == "extra_forbidden"])
        sentence = (
            f"{names}: the paper's drive, which a file without a type describes, has no such key; for another drive "
            f"write {kinds} in the first line"
        )
        return [sentence], more
    sentences = list(refused.values())
    for parts, detail in mistakes:
        if detail["type"] == "extra_forbidden":
            sentence, meant = _unknown_key(parts, detail["input"], absent, model)
            sentences.append(sentence)
            absent.discard(meant or parts)
    sections = [parts for parts, detail in mistakes if parts in absent and _is_section(parts, model)]
    if sections:
        sentences.append(_missing_sections(sections, model))
    for parts, detail in mistakes:
        known = detail["type"] == "extra_forbidden" or (detail["type"] == "missing" and parts not in absent)
        if not known and parts not in sections:
            sentences += _sentence(parts, detail, model).split("\n  ")
    if () not in [parts for parts, _ in mistakes] and isinstance(tables.get("materials"), dict):
        sentences += unknown_materials(tables.get("bodies"), tables["materials"])
    return sentences, more

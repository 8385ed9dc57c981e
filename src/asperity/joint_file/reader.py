"""From a TOML file to a checked joint file, :class:`asperity.joint_file.model.Case`."""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError

from asperity.drive.types import DEFAULT_TYPE, FORMER_NAMES
from asperity.errors import InputError, NoSolutionError, listed, nearest, quoted
from asperity.joint_file.case_types import CASES
from asperity.joint_file.finish_in_surface import fill_in_finishes
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.messages import explained
from asperity.joint_file.model import Case
from asperity.joint_file.open_radius import fill_in_radius, refuse_output_speed
from asperity.joint_file.traction_curves import fill_in_curves
from asperity.library import fill_in_materials
from asperity.precision import note_once, use_compilation_cache, use_double_precision
from asperity.reading import parse_toml, read_text
from asperity.types import Document


def read_case(path: str | Path, *, measured: bool = True) -> Case:
    """Read a joint file: its content, checked; raises as :func:`parse_case`, and if the file cannot be read."""
    file = Path(path)
    text = read_text(file, hint="'asperity init' writes an example")
    return parse_case(text, source=str(path), folder=file.parent, measured=measured)


def parse_case(text: str, *, source: str, folder: Path | None = None, measured: bool = True) -> Case:
    """The checked content of a joint file from its TOML text; ``source`` is its name for messages.

    ``folder`` is where paths of material libraries and measurements in it start. With ``measured`` a measured surface
    that it names is read, and the joint solved for what its contacts feel of it. An ``InputError`` is raised if the
    text is not valid TOML or contains something that is not allowed; with a measured surface, a ``NoSolutionError`` if
    the joint has no balance.
    """
    case = case_from_tables(parse_toml(text, source=source), source=source, folder=folder).with_text(text)
    if measured and isinstance(case.surface, SurfaceEntry) and case.surface.measurement:
        return _measured(case, case.surface, source, folder or Path())
    return case


def _measured(case: Case, surface: SurfaceEntry, source: str, folder: Path) -> Case:
    """The joint file with what each contact feels of the measured surface that it names."""
    from asperity.joint.measured_surface import measured_surface
    from asperity.joint_file.measured_surface import case_with_surface

    use_double_precision()
    use_compilation_cache()
    paths = [folder / name for name in surface.measurement or ()]
    files = tuple(str(path.absolute()) for path in paths)
    try:
        roughness = measured_surface(tuple(paths), surface.measurement_of)
    except (InputError, NoSolutionError) as error:
        raise type(error)(f"{source}: surface.measurement: {error}", options=error.options) from None
    try:
        return case_with_surface(case, roughness, files).with_text(case.text)
    except (InputError, NoSolutionError) as error:
        raise type(error)(f"{source}: {error}", options=error.options) from None


def case_from_tables(tables: Document, *, source: str, folder: Path | None = None) -> Case:
    """Check the nested tables of a joint file; a measured surface stays the name of its file."""
    tables = _with_the_name_of_now(tables)
    model = _model_of(tables.get("type", DEFAULT_TYPE), source)
    with_materials, refused = fill_in_materials(tables, folder=folder or Path())
    with_surfaces, refused_surfaces = fill_in_finishes(with_materials)
    with_surfaces, refused_curves = fill_in_curves(with_surfaces, folder=folder or Path())
    filled, refused_ratio, radius = fill_in_radius(with_surfaces, model)
    refused |= refused_surfaces | refused_curves | refused_ratio
    try:
        case = model.model_validate(filled)
    except ValidationError as error:
        sentences, more = explained(error, filled, refused, model=model)
    else:
        if not refused:
            try:
                refuse_output_speed(case)
            except InputError as error:
                raise InputError(f"{source}: {error}") from None
            return case.with_open_radius(radius)
        sentences, more = list(refused.values()), 0
    raise InputError(f"{source}: {listed(sentences, more=more)}")


def _with_the_name_of_now(tables: Document) -> Document:
    """The tables of a joint file, a former name of its type replaced by the one of now, which is said once."""
    former = tables.get("type")
    if not isinstance(former, str) or former not in FORMER_NAMES:
        return tables
    now = FORMER_NAMES[former]
    note_once(f'type = "{former}" is called "{now}" now')
    return {**tables, "type": now}


def _model_of(kind: object, source: str) -> type[Case]:
    known = tuple(CASES)
    if not isinstance(kind, str) or kind not in known:
        hint = nearest(kind, known) if isinstance(kind, str) else ""
        raise InputError(
            f"{source}: type: {quoted(kind)} is not a type of drive{hint or '; known are ' + ', '.join(known)}"
        )
    return model_of_type(kind)


def model_of_type(kind: str) -> type[Case]:
    """Model of the joint file of a type of drive."""
    return CASES[kind]

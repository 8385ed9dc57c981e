"""The report of one joint: everything that a design review asks for, and the file from which it follows."""

from __future__ import annotations

import hashlib
import math
import platform
from collections.abc import Iterator
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path
from typing import Any

import asperity
from asperity.errors import AsperityError
from asperity.joint.description import Joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.model import Case
from asperity.joint_file.si_tables import AnyCase, numeric_keys, si_values, stated_tables
from asperity.joint_file.solved_document import solve_with_surface
from asperity.joint_file.stated_parts import made_interference, stated_parts
from asperity.joint_file.window import joint_window
from asperity.report.figures import report_pictures
from asperity.report.study_sections import ReportStudies, study_files, study_sections
from asperity.report.years_sections import accuracy_section, wear_section
from asperity.results.loads_document import loads_document
from asperity.results.margins import margins
from asperity.results.solved import SolvedJoint
from asperity.results.window_document import window_document
from asperity.results.windup_document import (
    examined_windup,
    windup_capacities,
    windup_document,
    windup_onsets,
)
from asperity.rolling.onset import RollingOnset
from asperity.show.title_block import Title
from asperity.standing.windup import Windup
from asperity.types import Document
from asperity.views.blocks import Block, Figures, Heading, Listing, Paragraph, Picture, Report, Table
from asperity.views.branches import branches
from asperity.views.joint import assumptions, contacts, drive, key_figures, load, surfaces, verdict
from asperity.views.limits import margins as margins_shown
from asperity.views.limits import warnings
from asperity.views.loads import loads, rims
from asperity.views.numbers import quantity
from asperity.views.rolling import rolling, smallest_film
from asperity.views.solved_view import SolvedView
from asperity.views.stiffness import budget, stiffness
from asperity.views.window import window_summary
from asperity.views.windup import windup

_PACKAGES = ("jax", "jaxlib", "numpy", "scipy", "matplotlib")
_CREEP_SHARE = 0.05  # as in asperity windup


@dataclass(frozen=True)
class ReportSource:
    """From what a report is made.

    ``name`` and ``text`` of the joint file; ``case``: its content, with a measured surface in place of its own if there
    is one; ``measurement_texts`` of the files of this measurement; ``title``: what the title block says, without a date
    the same input makes the same report; ``studies`` of the joint that the report shows as well.
    """

    name: str
    text: str
    case: Case
    measurement_texts: tuple[str, ...] = ()
    title: Title = field(default_factory=Title)
    studies: ReportStudies = field(default_factory=ReportStudies)


def joint_report(source: ReportSource) -> Report:
    """Solve a joint and write down everything about it, to be shown as HTML or PDF.

    An ``InputError`` if the joint cannot exist, a ``NoSolutionError`` if the force balance does not close.
    """
    solved, document = solve_with_surface(source.case)
    interference = made_interference(source.case, solved.result).size
    view = SolvedView(solved, document, interference)
    examined = _examined(solved, document, source.case)
    figures, allowed = examined.windup_figures, joint_window(source.case)
    pictures = report_pictures(
        solved.joint,
        solved,
        examined.windup,
        examined.onset,
        math.copysign(examined.rolling_capacity, float(solved.joint.output_torque)),
        window=allowed,
        windup_capacities=(math.inf, math.inf) if figures is None else windup_capacities(figures),
        name=source.name,
        interference=interference,
        title=source.title,
        stated=stated_parts(source.case, joint_from_case(source.case)),
    )
    blocks = (
        *_title_block(source),
        Heading("Summary"),
        load(view),
        verdict(document),
        Figures([*key_figures(view), *smallest_film(document)]),
        Heading("Warnings"),
        warnings(document),
        Heading("Safety margins"),
        *margins_shown(margins(solved)),
        Picture("Used share of each limit", pictures["margins"]),
        Heading("Stiffness"),
        *stiffness(view),
        *surfaces(document),
        *budget(document),
        *_picture(pictures, "budget", "Stiffness budget and levels of the model"),
        Heading("Forces and contacts"),
        *contacts(view),
        *_picture(
            pictures,
            "forces",
            "Forces on the bodies drawn apart, at standstill, centrifugal forces not drawn",
        ),
        drive(view),
        *rims(document),
        *_branches(document),
        Heading("Loads of the structure"),
        *loads(loads_document(solved, document["bearings"])),
        Heading("Window of the torque"),
        *window_summary(window_document(allowed)),
        Picture("Torques that the joint may pass", pictures["window"]),
        Heading("Wind-up"),
        *_windup(examined, pictures),
        Heading("The joint in rolling"),
        *rolling(view),
        *_picture(
            pictures,
            "heat",
            "Losses over temperature, and the heat that leaves: the joint settles where they meet",
        ),
        *_picture(pictures, "rolling", "Creep, efficiency, drift and life"),
        *accuracy_section(source.case),
        *wear_section(source.case),
        *study_sections(source.studies),
        Heading("Inputs"),
        inputs_table(source.case),
        choices_table(source.case),
        *assumptions(document),
        *_drawing(pictures),
        Heading("Versions"),
        _versions(),
        *_appendix(source),
    )
    return Report(f"Traction-drive joint: {source.name}", blocks)


@dataclass(frozen=True)
class _Examined:
    """What needs more than the solution, or why it does not exist."""

    windup: Windup | None
    onset: RollingOnset | None
    windup_figures: Document | None
    no_windup: str
    rolling_capacity: float


def _examined(solved: SolvedJoint, document: Document, case: AnyCase) -> _Examined:
    joint: Joint = solved.joint
    capacity = document["rolling"]["torque_capacity_Nm"]
    capacity = math.inf if capacity is None else float(capacity)
    try:
        curve, both = examined_windup(joint, largest_torque=None, level="assembly")
    except AsperityError as error:
        return _Examined(None, None, None, str(error), capacity)
    onsets = windup_onsets(joint, curve, both, creep_share=_CREEP_SHARE)
    figures = windup_document(joint, curve, both, onsets, level="assembly")
    return _Examined(curve, onsets[0], figures, "", capacity)


def _picture(pictures: dict[str, str], name: str, caption: str) -> list[Block]:
    """A picture that a joint may lack."""
    return [Picture(caption, pictures[name])] if name in pictures else []


def _drawing(pictures: dict[str, str]) -> Iterator[Block]:
    yield Heading("Drawing")
    yield Paragraph(
        "Dimensions in mm. The drive's sheet is A4: printed in full size, it has the scale that it states."
    )
    yield Picture("The drive to scale", pictures["drive"], sheet=True)


def _title_block(source: ReportSource) -> Iterator[Block]:
    rows = [("joint file", source.name), ("computed with", f"asperity {asperity.__version__}")]
    stated = source.title._asdict()
    rows[:0] = [(name, stated[name]) for name in ("project", "part", "revision", "date") if stated[name]]
    yield Table("Document", ("item", "content"), rows, words=(0, 1))


def _branches(document: Document) -> Iterator[Block]:
    if "branches" in document:
        yield Heading("Branches by their own sizes")
        yield from branches(document["branches"])


def _windup(examined: _Examined, pictures: dict[str, str]) -> Iterator[Block]:
    if examined.windup_figures is None:
        yield Paragraph(f"No wind-up: {examined.no_windup}.")
        return
    yield from windup(examined.windup_figures)
    turning = "" if examined.onset is None else "; the joint that turns under the largest torque"
    yield Picture(f"Torque and angle, deviation from a straight line, stiffness{turning}", pictures["windup"])


def _appendix(source: ReportSource) -> Iterator[Block]:
    """The files from which the report can be made again."""
    files = [Path(name).name for name in (source.case.measured.files if source.case.measured else ())]
    surfaces = [] if files else ["--surface"] * len(source.measurement_texts)
    if len(surfaces) == 1 and source.case.measured.measured.of == "pair":
        surfaces.append("--measurement-of pair")
    option = "".join(f" {word}" for word in (*source.studies.options, *surfaces))
    yield Heading("Joint file")
    yield Paragraph(
        f"This report follows from the file below: save it and run 'asperity report{option}' on it. SHA-256 of its "
        f"text: {_digest(source.text)}"
    )
    yield Listing(source.text)
    for number, text in enumerate(source.measurement_texts):
        role = (
            f"The file {files[number]} of surface.measurement"
            if files
            else "It takes the place of the surfaces"
        )
        yield Heading("Measurement of the surface")
        yield Paragraph(
            f"{role}{'' if files else ' of the joint file'}. SHA-256 of its text: {_digest(text)}"
        )
        yield Listing(text)
    yield from study_files(source.studies)


def _versions() -> Table:
    rows = [("asperity", asperity.__version__), ("Python", platform.python_version())]
    rows += [(name, version(name)) for name in _PACKAGES]
    rows.append(("machine", f"{platform.system()} {platform.machine().replace('_', '-')}"))
    return Table("Programs with which the numbers were computed", ("program", "version"), rows, words=(0, 1))


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


#: Keys whose tables name contacts.
_OF_CONTACTS = ("contact_length", "friction_coefficient", "skew")


def label_of(path: str) -> str:
    """Words for the dotted path of a key: ``materials.steel.youngs_modulus`` is "materials steel: Young's modulus"."""
    section, *below = path.split(".")
    if len(below) > 1 and below[0] not in _OF_CONTACTS:
        section = f"{section} {below.pop(0)}"
    words = ", ".join(below).replace("_", " ").replace("youngs", "Young's").replace("poisson", "Poisson's")
    return f"{section}: {words}" if below else section.replace("_", " ")


def inputs_table(case: Case) -> Table:
    """Every number of a joint file."""
    rows = []
    for path, number in numeric_keys(case).items():
        unit = number.key.unit
        tolerance = f"± {quantity(number.tolerance, unit, 6)}" if number.tolerance else ""
        rows.append((label_of(path), quantity(number.value, unit, 8), tolerance))
    duty: Document = si_values(case).get("duty", {})
    rows += [(label_of(f"duty.{load}.share"), f"{entry['share']:.8g}", "") for load, entry in duty.items()]
    return Table("Numbers of the joint file", ("number", "value", "tolerance"), rows)


def choices_table(case: Case) -> Table:
    """Everything in a joint file that is not a number."""
    rows = [(label_of(path), text.replace("_", " ")) for path, text in _words(stated_tables(case), "")]
    return Table("Choices of the joint file", ("choice", "what is chosen"), rows, words=(0, 1))


def _words(node: Any, path: str) -> list[tuple[str, str]]:
    if isinstance(node, dict):
        return [
            pair for name, below in node.items() for pair in _words(below, f"{path}.{name}" if path else name)
        ]
    return [(path, node)] if isinstance(node, str) else []

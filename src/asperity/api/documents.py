"""The drawing and the report of a joint, from a script."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from asperity.api.joint import DescribedJoint, require_joint
from asperity.drive.layout.existence import refuse_impossible
from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.quantity_key import parse_distribution
from asperity.joint_file.stated_parts import made_interference, stated_parts
from asperity.made_files import DRAWING, IMAGE, REPORT
from asperity.reading import read_text
from asperity.report.joint_report import ReportSource, joint_report
from asperity.report.pdf import report_pdf, require_typst
from asperity.report.study_sections import STUDIED, ReportStudies
from asperity.show.drive_sheet import drive_sheet
from asperity.show.part_sheets import part_sheets
from asperity.show.sheet_figure import sheet_figure
from asperity.show.title_block import stated_title
from asperity.views.html import report_html
from asperity.writing import IMAGE_SUFFIXES, check_file, replacing, write_image, write_pages, write_text

if TYPE_CHECKING:
    from asperity.joint.evaluation import JointResult
    from asperity.joint_file.si_tables import AnyCase
    from asperity.report.study_sections import ReportStudies
    from asperity.show.sheet import Sheet
    from asperity.show.title_block import Title
    from asperity.views.blocks import Report

#: What is told how much of a long work is done: the number done and the total.
Progress = Callable[[int, int], None]


def draw(
    joint: DescribedJoint,
    path: str | Path,
    *,
    forces: bool = False,
    parts: bool = False,
    title: Mapping[str, str] | None = None,
    notice: Callable[[str], object] = warnings.warn,
) -> list[Path]:
    """Draw a drive to scale: view, section along the axis, parts, tolerances and title block.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.
    path : str or Path
        The file, .svg, .pdf, .png or .dxf; an earlier drawing is replaced.
    forces : bool, optional
        Draw the forces of one branch too; the section stays where the sheet need not be larger for it.
    parts : bool, optional
        A sheet for each kind of roller and ring too: further pages of a PDF file, otherwise files beside it.
    title : mapping, optional
        For the title block: ``project``, ``part``, ``revision``, ``date``; a dash for what nobody states.
    notice : callable, optional
        Called with a sentence if the interference with which the ring is made is not known.

    Returns
    -------
    list of Path
        The files that were written.

    Raises
    ------
    InputError
        If the rollers do not fit, no sheet can show the drive or a part, or the file cannot be written.
    MissingExtraError
        If a DXF file is asked for and ezdxf is not installed.
    """
    require_joint(joint)
    out = Path(path)
    check_drawing(out, joint.source)
    sheets = _sheets(joint, forces, parts, stated_title(title or {}), notice)
    if out.suffix.lower() == ".pdf" and parts:
        write_pages([sheet_figure(sheet) for sheet in sheets.values()], out)
        return [out]
    files = {out.with_stem(out.stem + name): sheet for name, sheet in sheets.items()}
    for file in files:
        check_drawing(file, joint.source)
    for file, sheet in files.items():
        if file.suffix.lower() == ".dxf":
            from asperity.show.sheet_dxf import sheet_dxf

            write_text(sheet_dxf(sheet), file, kind=DRAWING)
        else:
            write_image(sheet_figure(sheet), file)
    return list(files)


def check_drawing(path: str | Path, *inputs: str | Path) -> None:
    """Raise unless a drawing can have this name and replaces nothing but a drawing, before anything is computed."""
    suffix = Path(path).suffix.lower()
    if suffix not in (*IMAGE_SUFFIXES, ".dxf"):
        raise InputError(f"{path}: the name of a drawing must end in .svg, .pdf, .png or .dxf")
    if suffix == ".dxf":
        from asperity.show.sheet_dxf import require_ezdxf

        require_ezdxf()
    check_file(path, *inputs, kind=DRAWING if suffix == ".dxf" else IMAGE)


def _sheets(
    joint: DescribedJoint, forces: bool, parts: bool, title: Title, notice: Callable[[str], object]
) -> dict[str, Sheet]:
    """End of the name of each file → its sheet: the assembly, then the parts."""
    case = joint.case
    drawn = joint_from_case(case)
    refuse_impossible(drawn.drive)
    loaded = result = None
    if forces:
        loaded = with_own_branches(case)
        result = solve_joint(loaded).result
    made, stated = _interference(case, result, joint.source, notice), stated_parts(case, drawn)
    name = Path(joint.source).name
    of_parts = part_sheets(drawn, name=name, stated=stated, title=title, interference=made) if parts else {}
    drawing = drive_sheet(
        drawn,
        name=name,
        result=result,
        loaded=loaded,
        interference=made,
        stated=stated,
        title=title._replace(sheet=f"1 of {len(of_parts) + 1}"),
        section=True,
    )
    return {"": drawing} | {f"_{part}": sheet for part, sheet in of_parts.items()}


def _interference(
    case: AnyCase, result: JointResult | None, source: str, notice: Callable[[str], object]
) -> float | None:
    """The interference with which the ring is made; without it there is a drawing all the same, with a notice."""
    made = made_interference(case, result)
    if made.size is None:
        notice(
            f"{source}: the interference of the preload is not known, and the ring's bore without it: "
            f"{made.unknown_because}"
        )
    return made.size


def write_report(
    joint: DescribedJoint,
    path: str | Path,
    *,
    surfaces: Sequence[str | Path] = (),
    measurement_of: str | None = None,
    sensitivity: bool = False,
    tolerances: bool = False,
    distribution: str | None = None,
    design: str | Path | None = None,
    title: Mapping[str, str] | None = None,
    progress: Callable[[str], AbstractContextManager[Progress]] | None = None,
) -> Path:
    """Write one document about a joint: inputs, drawing, results, margins and warnings.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.
    path : str or Path
        The file, .html or .pdf; an earlier report is replaced.
    surfaces : sequence of str or Path, optional
        JSON documents of ``asperity surface measure``: the joint with this surface on both bodies of every contact, or
        with two of them, one for each body.
    measurement_of : {"body", "pair"}, optional
        What one of them is of, where its document does not say it: one body, or both together.
    sensitivity, tolerances : bool, optional
        Add how much every number of the file moves the results, and the intervals from its tolerances.
    distribution : str, optional
        For tolerances whose distribution the file does not state, such as ``"uniform"``.
    design : str or Path, optional
        Add the design of this joint that a design file asks for.
    title : mapping, optional
        For the title block: ``project``, ``part``, ``revision``, ``date``.
    progress : callable, optional
        From a word to what reports progress on it, within a ``with`` statement.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    InputError
        If the joint has no result, a file cannot be read or written, or the design is not of this joint.
    MissingExtraError
        If a PDF is asked for and typst is not installed.

    Notes
    -----
    The same input gives the same report, byte for byte.
    """
    from asperity.joint_file.edited_text import joint_file_text

    require_joint(joint)
    out, case = Path(path), joint.case
    check_report(out, joint.source, *surfaces, *([design] if design else []))
    if distribution is not None and not tolerances:
        raise InputError("a distribution belongs to tolerances=True")
    watched = progress or (lambda what: nullcontext(lambda done, total: None))
    text = case.text or joint_file_text(case, {}, comment="")
    case, surfaces = _with_surfaces(case, surfaces, measurement_of)
    source = ReportSource(
        name=Path(joint.source).name,
        text=text,
        case=case,
        measurement_texts=tuple(read_text(surface) for surface in surfaces),
        title=stated_title(title or {}),
        studies=_studies(joint.source, case, sensitivity, tolerances, distribution, design, watched),
    )
    with watched("the report") as done:
        done(0, 2)
        made = joint_report(source)
        done(2, 2)
    _write(made, out)
    return out


def _with_surfaces(
    case: AnyCase, surfaces: Sequence[str | Path], measurement_of: str | None
) -> tuple[AnyCase, Sequence[str | Path]]:
    """The joint with the surfaces that are named, and the documents of its surfaces."""
    if surfaces:
        from asperity.joint.measured_surface import measured_surface
        from asperity.joint_file.measured_surface import case_with_surface

        return case_with_surface(case, measured_surface(tuple(map(str, surfaces)), measurement_of)), surfaces
    return case, () if case.measured is None else case.measured.files


def _write(report: Report, path: Path) -> None:
    """Write a report in the format that the ending of its name says."""
    if path.suffix.lower() == ".pdf":
        content = report_pdf(report)
        with replacing(path, kind=REPORT) as part:
            part.write_bytes(content)
    else:
        write_text(report_html(report), path, kind=REPORT)


def check_report(path: str | Path, *inputs: str | Path) -> None:
    """Raise unless a report can have this name and replaces nothing but a report, before anything is computed."""
    suffix = Path(path).suffix.lower()
    if suffix not in (".html", ".pdf"):
        raise InputError(f"{path}: the name of a report must end in .html or .pdf")
    check_file(path, *inputs, kind=REPORT)
    if suffix == ".pdf":
        require_typst()


def _studies(
    source: str,
    case: AnyCase,
    sensitivity: bool,
    tolerances: bool,
    distribution: str | None,
    design_file: str | Path | None,
    progress: Callable[[str], AbstractContextManager[Progress]],
) -> ReportStudies:
    """Make the studies that a report is to show."""
    sensitivities = spread = designed = problem = None
    options = []
    otherwise = None if distribution is None else parse_distribution(distribution)
    if tolerances:
        from asperity.study.tolerances.uncertainty import toleranced_inputs, uncertainty

        toleranced_inputs(case, otherwise=otherwise)  # refuses before anything long begins
    if design_file is not None:
        from asperity.study.design.design import design
        from asperity.study.design.design_file import read_design

        problem = read_design(design_file)
        if len(problem.objectives) > 1:
            raise InputError(
                f"{design_file}: a report shows one design, and a Pareto front has many; state one objective"
            )
        if problem.case != case:
            raise InputError(
                f"{design_file}: it designs {problem.joint_file}, which is not the joint of this report, {source}"
            )
    if sensitivity:
        from asperity.study.tolerances.sensitivity import sensitivity as differentiate

        with progress("sensitivities") as done:
            done(0, 1)
            sensitivities = differentiate(case, STUDIED)
            done(1, 1)
        options.append("--sensitivity")
    if tolerances:
        with progress("samples") as done:
            spread = uncertainty(case, results=STUDIED, distribution=otherwise, report=done)
        options += ["--tolerances", *([f"--distribution '{distribution}'"] if distribution else [])]
    if problem is not None:
        with progress("searches") as done:
            designed = design(problem, progress=done)
        options.append(f"--design {Path(design_file or '').name}")
    return ReportStudies(
        sensitivities,
        spread,
        designed,
        design_name=Path(design_file or "").name,
        design_text=read_text(design_file) if design_file else "",
        options=tuple(options),
    )

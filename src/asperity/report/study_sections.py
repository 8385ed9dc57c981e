"""Sections of a report on studies of the joint: sensitivities, tolerances, and a design of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from asperity.report.figures import figure_svg
from asperity.views.blocks import Block, Heading, Listing, Paragraph, Picture

if TYPE_CHECKING:
    import xarray

    from asperity.study.design.design_result import DesignResult

#: Results of the sections on sensitivities and tolerances.
STUDIED = ("assembly_stiffness_output", "standing_torque_capacity", "drift", "efficiency", "drive_life")
#: Of them those with a picture.
DRAWN = ("assembly_stiffness_output", "drift")
_ROWS = 20
_WIDTH = 7.0  # of a picture on a page [in]


@dataclass(frozen=True)
class ReportStudies:
    """Studies that a report shows; each may be absent.

    What sensitivity and uncertainty say of :data:`STUDIED`; a design of the joint with name and text of its file; and
    options of the command that made them.
    """

    sensitivities: xarray.Dataset | None = None
    spread: xarray.Dataset | None = None
    design: DesignResult | None = None
    design_name: str = ""
    design_text: str = ""
    options: tuple[str, ...] = ()


def study_sections(studies: ReportStudies) -> Iterator[Block]:
    """The sections of the studies that were made."""
    if studies.sensitivities is not None:
        yield from sensitivity_section(studies.sensitivities)
    if studies.spread is not None:
        yield from tolerance_section(studies.spread)
    if studies.design is not None:
        yield from design_section(studies.design, name=studies.design_name)


def sensitivity_section(dataset: xarray.Dataset) -> Iterator[Block]:
    """Elasticities of the results, largest influence on the stiffness first."""
    from asperity.study.tolerances.influence_plot import tornado_figure
    from asperity.views.tolerances import elasticities

    yield Heading("Sensitivities")
    yield Paragraph(
        "Elasticities: by how many per cent a result changes for one per cent more of a number of the joint file. "
        "Exact derivatives at the file's values."
    )
    yield from elasticities(dataset, STUDIED, most=_ROWS)
    figure = tornado_figure(dataset, result=DRAWN[0], panels=DRAWN[1:], width=_WIDTH)
    yield Picture("Elasticities of stiffness and drift", figure_svg(figure))


def tolerance_section(spread: xarray.Dataset) -> Iterator[Block]:
    """Intervals of the results under the tolerances of the file, and what each tolerance contributes."""
    from asperity.study.tolerances.influence_plot import uncertainty_figure
    from asperity.views.tolerances import intervals, said, variance_shares

    yield Heading("Tolerances")
    yield Paragraph(
        f"{spread.sizes['sample']} joints drawn from the tolerances of the joint file, seed {spread.attrs['seed']}. "
        "The shares of the variance are Sobol indices: first order for a tolerance alone, total with all its "
        "interactions."
    )
    yield from intervals(spread)
    yield from variance_shares(spread, STUDIED)
    for name in DRAWN:
        yield Picture(
            f"Scatter of the {said(spread, name)}, and the shares of its variance",
            figure_svg(uncertainty_figure(spread, result=name, width=_WIDTH)),
        )


def design_section(result: DesignResult, *, name: str) -> Iterator[Block]:
    """A design of the joint: before and after, and how it stands to its limits."""
    from asperity.study.design.design_plot import design_figure
    from asperity.views.design import design

    yield Heading("Design")
    yield Paragraph(f"What {name} asks for:")
    yield from design(result)
    yield Picture(
        "The objective along each free number through the design, and the smallest margin of the limits",
        figure_svg(design_figure(result, width=_WIDTH)),
    )


def study_files(studies: ReportStudies) -> Iterator[Block]:
    """The design file and the designed joint, from which the section on the design follows."""
    if studies.design is not None:
        yield Heading("Design file")
        yield Listing(studies.design_text)
        yield Heading("Designed joint as a joint file")
        yield Listing(studies.design.joint_text)

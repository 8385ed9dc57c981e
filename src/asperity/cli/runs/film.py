"""What the command of :mod:`asperity.cli.film` does."""

from __future__ import annotations

from asperity.api.film import JointFilm
from asperity.api.film import film as found_film
from asperity.api.joint import DescribedJoint
from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.options import read_option
from asperity.cli.progress import progress_bar
from asperity.cli.terminal import about, print_json, save_image, show_blocks
from asperity.errors import InputError
from asperity.unit_table import Dimension
from asperity.writing import check_image


def film(
    file: str,
    temperatures: str | None,
    start: str | None,
    stop: str | None,
    points: int,
    plot_file: str | None,
    as_json: bool,
) -> None:
    """What ``asperity film`` does; its options stand in :mod:`asperity.cli.film`."""
    check_image(plot_file, file)
    case = read_case_of_branches(file)
    for option, end in (("from", start), ("to", stop)):
        if end is not None:
            read_option(option, end, Dimension.ANGULAR_VELOCITY)  # refuses what is no such quantity
    asked = _temperatures(temperatures) if temperatures is not None else ()
    with about(file), progress_bar("temperatures of the oil", compiles=False) as report:
        found: JointFilm = found_film(
            DescribedJoint(case, file),
            temperatures=asked,
            start=start,
            stop=stop,
            points=points,
            report=report,
        )
    if plot_file:
        save_image(found.plot(), plot_file)
    if as_json:
        print_json(found.document)
        return
    show_blocks(*found.blocks())


def _temperatures(text: str) -> tuple[str, ...]:
    """The temperatures of an option, each with its unit: '20,40,80 degC' has one unit for all."""
    parts = [part.strip() for part in text.split(",")]
    if not all(parts):
        raise InputError(
            f"--temperature: expected temperatures between commas, such as '20,40,80 degC', got '{text}'"
        )
    unit = parts[-1].lstrip("+-0123456789.eE").strip()
    each = tuple(
        part if part.lstrip("+-0123456789.eE").strip() else f"{part} {unit}".strip() for part in parts
    )
    for part in each:
        read_option("temperature", part, Dimension.TEMPERATURE)
    return each

"""What the command of :mod:`asperity.cli.report` does."""

from __future__ import annotations

from asperity.api.documents import check_report, write_report
from asperity.api.joint import DescribedJoint
from asperity.cli.joint_input import check_title, refuse_lonely_measurement_of
from asperity.cli.progress import progress_bar
from asperity.cli.terminal import about, say_written
from asperity.errors import InputError
from asperity.joint_file.reader import read_case


def report(
    file: str,
    out: str,
    surfaces: tuple[str, ...],
    measurement_of: str | None,
    sensitivity: bool,
    tolerances: bool,
    distribution: str | None,
    design_file: str | None,
    **stated: str,
) -> None:
    """What ``asperity report`` does; its options stand in :mod:`asperity.cli.report`."""
    check_report(out, file, *surfaces, *([design_file] if design_file else []))
    check_title(stated)
    refuse_lonely_measurement_of(surfaces, measurement_of)
    if distribution is not None and not tolerances:
        raise InputError("--distribution belongs to --tolerances")
    case = read_case(file, measured=not surfaces)
    with about(file, *surfaces, design_file):
        write_report(
            DescribedJoint(case, file),
            out,
            surfaces=surfaces,
            measurement_of=measurement_of,
            sensitivity=sensitivity,
            tolerances=tolerances,
            distribution=distribution,
            design=design_file,
            title=stated,
            progress=progress_bar,
        )
    say_written(out)

"""``asperity tolerances``: which deviations of the sizes of a joint file are allowed."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import json_option, prepare_computation, print_json, read_option, show_blocks

if TYPE_CHECKING:
    pass


@click.command()
@click.argument("file", type=click.Path())
@click.option("--keep", "keep", multiple=True, required=True, metavar="RESULT>=VALUE",
              help="A limit, for example 'torque_capacity>=12 N*m', 'drive_life>=5000 h', 'stiffness>=8e5 N*m/rad' or "
              "'hertz_pressure<=1500 MPa'; repeat for several.")  # fmt: skip
@click.option(
    "--share", default="99.9 %", show_default=True, help="Share of the drives that keep all limits."
)
@click.option("--sharing", default="grade", show_default=True, type=click.Choice(["equal", "grade", "cost"]),
              help="The same deviation of all radii, the same grade, or the least cost, of 1/t each.")  # fmt: skip
@click.option("--distribution", default="uniform", show_default=True, metavar="TEXT",
              help="Of the sizes within their deviations, as for 'asperity uncertainty'.")  # fmt: skip
@click.option("--samples", default=10_000, show_default=True, type=click.IntRange(100, 1_000_000),
              help="Drives of each try.")  # fmt: skip
@click.option("--seed", default=0, show_default=True, type=click.IntRange(0), help="Of the random numbers.")
@json_option("Print one JSON document in SI units.")
def tolerances(
    file: str,
    keep: tuple[str, ...],
    share: str,
    sharing: Any,
    distribution: str,
    samples: int,
    seed: int,
    as_json: bool,
) -> None:
    """The deviations of the sizes in FILE with which nearly all drives keep stated limits, as grades of ISO 286-1.

    The preload must be made by load.interference. Tolerances that FILE states are not used: its other numbers are
    exact. All parts of one size deviate alike; 'asperity uncertainty --branches' draws them one by one.
    """
    from asperity.cli.terminal import about, progress_bar, read_case_of_branches
    from asperity.errors import InputError
    from asperity.joint_file.quantity_key import parse_distribution
    from asperity.unit_table import Dimension

    kept_share = read_option("share", share, Dimension.DIMENSIONLESS)
    if not 0.5 <= kept_share < 1.0:
        raise InputError(
            f"--share: the share of the drives must be at least 50 % and below 100 %, got '{share}'"
        )
    case = read_case_of_branches(file)
    prepare_computation()
    from asperity.study.tolerances.allowed_deviations import allowed_deviations, limits_from_text

    with progress_bar("tries") as report, about(file):
        allowed = allowed_deviations(
            case,
            limits_from_text(keep, case),
            share=kept_share,
            sharing=sharing,
            distribution=parse_distribution(distribution),
            samples=samples,
            seed=seed,
            report=report,
        )
    if as_json:
        print_json(asdict(allowed))
    else:
        from asperity.views.tolerances import allowed_sizes

        show_blocks(*allowed_sizes(allowed, case))

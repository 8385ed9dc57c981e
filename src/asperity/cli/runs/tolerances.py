"""What the command of :mod:`asperity.cli.tolerances` does."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING

from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.options import read_option
from asperity.cli.progress import progress_bar
from asperity.cli.terminal import about, print_json, show_blocks
from asperity.errors import InputError
from asperity.joint_file.quantity_key import parse_distribution
from asperity.study.tolerances.form_errors import joint_forms
from asperity.study.tolerances.runout import FormSharing, form_limits
from asperity.unit_table import Dimension
from asperity.views.form_tolerances import allowed_form_errors

if TYPE_CHECKING:
    from asperity.study.tolerances.allowed_deviations import Sharing


def tolerances(
    file: str,
    keep: tuple[str, ...],
    share: str,
    sharing: Sharing | FormSharing | None,
    distribution: str,
    samples: int,
    seed: int,
    as_json: bool,
) -> None:
    """What ``asperity tolerances`` does; its options stand in :mod:`asperity.cli.tolerances`."""
    kept_share = read_option("share", share, Dimension.DIMENSIONLESS)
    if not 0.5 <= kept_share < 1.0:
        raise InputError(
            f"--share: the share of the drives must be at least 50 % and below 100 %, got '{share}'"
        )
    case = read_case_of_branches(file)
    asked = form_limits(keep)
    if asked:
        with about(file):
            forms = joint_forms(case, asked, sharing=sharing or "stated")
        if as_json:
            print_json(asdict(forms))
        else:
            show_blocks(*allowed_form_errors(forms))
        return
    if sharing == "stated":
        raise InputError(
            "--sharing: 'stated' is for form errors, whose proportions the file states; choose equal, grade or cost"
        )
    # what imports JAX, once the file is read
    from asperity.study.tolerances.allowed_deviations import allowed_deviations, limits_from_text
    from asperity.views.tolerances import allowed_sizes

    with progress_bar("tries") as report, about(file):
        allowed = allowed_deviations(
            case,
            limits_from_text(keep, case),
            share=kept_share,
            sharing=sharing or "grade",
            distribution=parse_distribution(distribution),
            samples=samples,
            seed=seed,
            report=report,
        )
    if as_json:
        print_json(asdict(allowed))
    else:
        show_blocks(*allowed_sizes(allowed, case))

"""What gives way in a joint, as a picture: shares of the compliance, and the stiffness on every level."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.joint.results import LEVELS, RESULTS, SolvedJoint

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_PER_ARCMINUTE = np.pi / 10800.0


def compliance_shares(solved: SolvedJoint) -> dict[str, float]:
    """Share of every spring in the compliance of the assembled joint, without those that have none.

    Parameters
    ----------
    solved : SolvedJoint
        One joint.

    Returns
    -------
    dict
        Spring in words → share [-], the largest first.
    """
    shares = {}
    for name, row in RESULTS.items():
        if row.group == "assembly" and name.endswith("_share"):
            words = name.removesuffix("_share").replace("_", " ")
            for place, share in zip(row.row_names, np.atleast_1d(np.asarray(row.of(solved))), strict=True):
                shares[f"{place} {words}".strip()] = float(share)
    return {
        words: share for words, share in sorted(shares.items(), key=lambda each: -each[1]) if share != 0.0
    }


def compliance_figure(solved: SolvedJoint, *, title: str) -> Figure:
    """Shares of the compliance and the output stiffness on every level, side by side.

    Parameters
    ----------
    solved : SolvedJoint
        One joint.
    title : str
        Title of the picture.

    Returns
    -------
    Figure
        A matplotlib figure; call its ``savefig``.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10.0, 4.2), layout="constrained")
    budget, levels = figure.subplots(1, 2)
    shares = compliance_shares(solved)
    bars = budget.barh(list(shares), [100.0 * share for share in shares.values()], color="tab:blue")
    budget.bar_label(bars, fmt="%.1f %%", padding=3)
    budget.invert_yaxis()
    budget.margins(x=0.25)
    budget.set(xlabel="share of the compliance at the output [%]")
    rows = [RESULTS[f"{level}_stiffness_output"] for level in LEVELS]
    numbers = [float(np.asarray(row.of(solved))) * _PER_ARCMINUTE for row in rows]
    words = [row.label.split(", ")[-1] for row in rows]
    levels.semilogx(numbers, words, "o", color="tab:orange")  # no bars: a logarithmic axis has no zero
    for number, name in zip(numbers, words, strict=True):
        levels.annotate(f"{number:.4g}", (number, name), (8, 0), textcoords="offset points", va="center")
    levels.invert_yaxis()
    levels.margins(x=0.3, y=0.3)
    levels.set(xlabel="torsional stiffness at the output [N·m/arcmin]")
    figure.suptitle(title, fontsize=10)
    return figure

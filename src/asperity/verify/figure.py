"""Figure of the comparison: area and stiffness over load, and ratio of the law to the boundary elements."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from asperity.verify.comparison import Comparison, Sample

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Attribute, axis label.
QUANTITIES = {
    "normal_stiffness": "normal stiffness $K_n$ [N/m]",
    "tangential_stiffness": "tangential stiffness $K_t$ [N/m]",
    "real_contact_area": "real contact area $A_r$ [m²]",
}


def comparison_figure(samples: Sequence[Sample], comparisons: Sequence[Comparison]) -> Figure:
    """Three quantities over the load by three methods, one colour per fractal dimension, ratios below."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11.0, 6.0), layout="constrained")
    axes = figure.subplots(2, 3, sharex=True, height_ratios=[1.5, 1.0])
    colours = ("tab:blue", "tab:orange", "tab:green", "tab:red", "tab:purple", "tab:brown", "tab:pink", "0.4")
    for column, (name, label) in enumerate(QUANTITIES.items()):
        above, below = axes[:, column]
        for index, (sample, found) in enumerate(zip(samples, comparisons, strict=True)):
            colour = colours[index % len(colours)]
            force = np.asarray(found.normal_force)
            solved = np.asarray(getattr(found, name))
            law = np.asarray(getattr(found, f"law_{name}"))
            theory = np.asarray(getattr(found, f"persson_{name}")).mean(axis=0)
            mean = solved.mean(axis=0)
            title = f"D = {sample.fractal_dimension:g}"
            above.errorbar(force, mean, solved.std(axis=0), fmt="o", markersize=4, color=colour, label=title)
            above.plot(force, _positive(law), "-", color=colour)
            above.plot(force, theory, ":", color=colour)
            below.plot(force, _positive(law / mean), "-", color=colour)
            below.plot(force, theory / mean, ":", color=colour)
            scatter = solved.std(axis=0) / mean
            below.fill_between(
                force, 1.0 / (1.0 + scatter), 1.0 + scatter, color=colour, alpha=0.15, linewidth=0
            )
        above.set(xscale="log", yscale="log", ylabel=label)
        below.set(
            xscale="log",
            yscale="log",
            ylabel="ratio to boundary elements [-]",
            xlabel="normal force $F_n$ [N]",
        )
        below.axhline(1.0, color="black", linewidth=0.8)
    axes[0, 0].legend(fontsize=8)
    axes[0, 1].set_title("dots: boundary elements; line: fractal law, λ = 1; dotted: Persson", fontsize=10)
    return figure


def _positive(values: np.ndarray) -> np.ndarray:
    """Mask zeros (no elastic spot, no stiffness), which a logarithmic axis cannot show."""
    return np.where(values > 0.0, values, np.nan)

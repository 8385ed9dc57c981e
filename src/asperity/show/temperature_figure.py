"""Preload, stiffness and torque capacity over temperature as a picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from asperity.joint.fit import Fit
from asperity.joint.looseness import loose_temperature
from asperity.joint.temperature_curves import TemperatureCurves
from asperity.show.style import ACCENT, MARK, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_PER_ARCMINUTE = np.pi / 10800.0


def draw_temperatures(axes: Sequence[Axes], curves: TemperatureCurves, fit: Fit) -> None:
    """Three panels over temperature, with the temperatures of assembly and work."""
    temperature = np.asarray(curves.temperature)
    panels = (
        ("preload [N]", np.asarray(curves.preload)),
        ("assembled stiffness [N·m/arcmin]", np.asarray(curves.stiffness) * _PER_ARCMINUTE),
        ("torque capacity [N·m]", np.asarray(curves.torque_capacity)),
    )
    loose = float(np.asarray(loose_temperature(fit)))
    marks = (
        ("assembly", float(fit.assembly_temperature), MUTED, ":"),
        ("work", float(fit.working_temperature), "black", "--"),
    )
    for panel, (label, values) in zip(axes, panels, strict=True):
        known = np.where(np.isfinite(values), values, np.nan)
        panel.plot(temperature, known, color=ACCENT)
        for name, at, color, style in marks:
            panel.axvline(at, color=color, linestyle=style, linewidth=1.0, label=name)
        if temperature[0] < loose < temperature[-1]:
            end = temperature[-1] if fit.change_per_kelvin < 0.0 else temperature[0]
            panel.axvspan(loose, end, color=MARK, alpha=0.12, label="loose")
        panel.set_xlim(temperature[0], temperature[-1])
        panel.set_ylim(bottom=0.0)
        panel.set(xlabel="temperature [°C]", ylabel=label)
    axes[0].legend(frameon=False, fontsize="small")

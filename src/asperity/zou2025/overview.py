"""One picture of the reproduction: the joint of Table 2 to scale beside its stiffness over the fractal dimension."""

from __future__ import annotations

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from asperity.show.drive_drawing import draw_drive
from asperity.show.style import MUTED, STYLE
from asperity.zou2025 import preset
from asperity.zou2025.curves import Curves
from asperity.zou2025.figures import draw
from asperity.zou2025.panels import joint_panels


def overview_figure(curves: Curves) -> Figure:
    """The drive to scale beside panel 7a, with the design window of the paper."""
    joint = preset.table_2_joint(preset.operating_grid())
    panel = joint_panels(curves)[0]
    with rc_context(STYLE):
        figure = Figure(figsize=(11.0, 4.8), layout="constrained")
        FigureCanvasAgg(figure)
        drive, stiffness = figure.subplots(1, 2, width_ratios=(1.0, 1.3))
        draw_drive(drive, joint.geometry, ring_wall_thickness=joint.ring_wall_thickness)
        drive.set_title("Planetary traction drive, to scale")
        draw(stiffness, panel)
        stiffness.set_title("Its stiffness, from the asperities alone")
        stiffness.axvspan(*preset.DESIGN_WINDOW, color="#eef4f8", lw=0, zorder=0)
        stiffness.text(
            float(np.mean(preset.DESIGN_WINDOW)),
            0.03,
            "window advised\nby the paper",
            transform=stiffness.get_xaxis_transform(),
            ha="center",
            fontsize=8.5,
            color=MUTED,
        )
    return figure

"""Why a joint settles at its temperature, as a picture: its losses over temperature, and the heat that leaves."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.rolling.heat import HeatBalance
from asperity.show.style import INK, MUTED, STYLE
from asperity.units import format_quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_LEAVES, _SMALL = "#2f7fb8", 8.5
#: Of the highest losses, the height of the panel.
_ROOM = 1.2


def heat_figure(heat: HeatBalance, *, title: str, width: float = 9.0) -> Figure:
    """Losses and heat that leaves on one sheet so wide [in]; where they meet the joint settles."""
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    flow, warm = heat.flow, np.asarray(heat.temperatures)
    losses = np.asarray(heat.losses)
    leaves = (warm - float(flow.ambient)) / float(flow.to_rollers)
    top = _ROOM * float(np.nanmax(losses, initial=0.0)) or _ROOM * float(leaves[-1])
    with rc_context(STYLE):
        figure = Figure(figsize=(width, 0.5 * width), layout="constrained")
        FigureCanvasAgg(figure)
        axes = figure.subplots()
        axes.plot(warm, losses, color=INK)
        axes.plot(warm, leaves, color=_LEAVES)
        if bool(heat.is_steady):
            at, loss = float(heat.roller_temperature), float(heat.loss)
            axes.plot([at], [loss], "o", color=INK)
            said = f"settles at {format_quantity(at, 'degC')} with {format_quantity(loss, 'W')}"
        else:
            said = f"no temperature is steady: {heat.unsteady_because}"
        axes.set(
            xlim=(warm[0], warm[-1]),
            ylim=(0.0, top),
            xlabel="temperature of rollers and oil [°C]",
            ylabel="power [W]",
        )
        axes.legend(
            ["losses of the joint", f"heat that leaves, {format_quantity(float(flow.to_rollers), 'K/W')}"]
        )
        axes.set_title("\n".join(filter(None, (title, said))), loc="left", fontsize=_SMALL, color=MUTED)
    return figure

"""Shakedown limit and first yield of a rolling line contact over its traction coefficient.

Run it: ``python examples/shakedown_map.py [picture.png]``.
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.figure import Figure

from asperity.contact.shakedown import mises_elastic_limit, shakedown_limit, tresca_elastic_limit
from asperity.precision import use_double_precision
from asperity.show.style import ACCENT, MARK, MUTED, STYLE

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "shakedown.png"
POISSON_RATIO = 0.3


def limits(friction: np.ndarray) -> dict[str, np.ndarray]:
    """Peak pressure over the yield strength in shear."""
    arguments = {"friction_coefficient": friction, "poisson_ratio": POISSON_RATIO}
    return {
        "shakedown": np.asarray(shakedown_limit(friction_coefficient=friction)),
        r"first yield, Tresca ($k = \sigma_Y/2$)": np.asarray(tresca_elastic_limit(**arguments)),
        r"first yield, Mises ($k = \sigma_Y/\sqrt{3}$)": np.asarray(mises_elastic_limit(**arguments)),
    }


def draw(friction: np.ndarray, curves: dict[str, np.ndarray]) -> Figure:
    with rc_context(STYLE):
        figure = Figure(figsize=(7.2, 4.6), layout="constrained")
        axes = figure.subplots()
        for (name, values), color in zip(curves.items(), (MARK, ACCENT, MUTED), strict=True):
            axes.plot(friction, values, color=color, label=name)
        shakedown = curves["shakedown"]
        kink = int(np.argmax(np.isclose(shakedown * friction, 1.0, rtol=1e-12)))
        axes.plot(friction[kink], shakedown[kink], "o", color=MARK)
        axes.annotate(
            "surface governs",
            (friction[kink], shakedown[kink]),
            xytext=(10, 8),
            textcoords="offset points",
            color=MARK,
        )
        axes.text(0.01, 3.45, "shakes down", color=MARK)
        axes.text(0.05, 2.5, "elastic from the first turn", color=MUTED)
        axes.text(0.2, 3.7, "yields in every turn", color=MARK)
        axes.set_title(r"Line contact in full slip, $\nu$ = 0.3")
        axes.set_xlabel(r"traction coefficient $\mu$")
        axes.set_ylabel(r"peak pressure over shear yield strength, $p_0/k$")
        axes.set_xlim(0.0, 0.6)
        axes.set_ylim(0.0, 4.3)
        axes.legend(loc="lower left")
    return figure


def main(picture: Path = PICTURE) -> dict[str, np.ndarray]:
    use_double_precision()
    friction = np.linspace(0.0, 0.6, 601)
    curves = limits(friction)
    draw(friction, curves).savefig(picture, dpi=150)
    for name, values in curves.items():
        print(f"{name:46s}{values[0]:7.3f} at mu = 0,{values[300]:7.3f} at 0.3")
    return curves


if __name__ == "__main__":
    main(*(Path(argument) for argument in sys.argv[1:2]))

"""Draw the joint of Zou et al. 2025 to scale beside its stiffness over the fractal dimension of its surfaces.

Run it to write the picture of the README: ``python examples/reproduce_overview.py [picture.png]``.
"""

import sys
from pathlib import Path

from asperity.precision import use_compilation_cache, use_double_precision
from asperity.zou2025.criteria import peak
from asperity.zou2025.curves import JointCurves, compute
from asperity.zou2025.figures import overview_figure

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "zou2025_overview.png"


def peak_dimension(curves: JointCurves) -> float:
    """Fractal dimension at which the joint is stiffest, at the largest output torque."""
    return peak(curves.values, curves.output_stiffness[-1])


def main(picture: Path) -> float:
    use_double_precision()
    use_compilation_cache()
    curves = compute()
    picture.parent.mkdir(parents=True, exist_ok=True)
    overview_figure(curves).savefig(picture, dpi=150)
    place = peak_dimension(curves.dimension)
    print(f"{picture}: the joint is stiffest at D = {place:.3f}")
    return place


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else PICTURE)

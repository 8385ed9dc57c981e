"""The picture of the README: the drive to scale, and its stiffness at three levels of the model over D.

Run it: ``python examples/stiffness_picture.py [picture.png]``.
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.figure import Figure

from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import si_values
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.show.style import ACCENT, MARK, MUTED, STYLE
from asperity.study.batch import evaluate_points
from asperity.zou2025.drive_drawing import draw_drive
from asperity.zou2025.preset import DIMENSION_RANGE, operating_grid, table_2_joint

FILE = Path(__file__).with_name("zou2025.toml")
PICTURE = Path(__file__).parents[1] / "docs" / "images" / "readme.png"


def stiffness_levels(dimension: np.ndarray) -> dict[str, np.ndarray]:
    """Output stiffness of the paper's joint at 5 N·m by level of the model [N·m/rad]."""
    names = {
        "as published: asperities alone": "published_stiffness_output",
        "with the elastic bodies in series": "series_with_bulk_stiffness_output",
        "assembled, the planets floating": "assembly_stiffness_output",
    }
    points = {"surface.fractal_dimension": dimension}
    _, found = evaluate_points(si_values(read_case(FILE)), points, tuple(names.values()))
    assert not any(np.any(np.isnan(values)) for values in found.values())
    return {words: found[name] for words, name in names.items()}


def draw(dimension: np.ndarray, levels: dict[str, np.ndarray]) -> Figure:
    with rc_context(STYLE):
        figure = Figure(figsize=(11.0, 4.8), layout="constrained")
        machine, curves = figure.subplots(1, 2, width_ratios=(1.0, 1.45))
        joint = table_2_joint(operating_grid())
        draw_drive(machine, joint.geometry, ring_wall_thickness=joint.ring_wall_thickness)
        machine.set_title("Planetary traction drive, to scale")
        for (name, values), color in zip(levels.items(), (MUTED, ACCENT, MARK), strict=True):
            curves.semilogy(dimension, values, color=color)
            at = int(0.72 * dimension.size) if color == MUTED else int(0.45 * dimension.size)
            curves.annotate(
                name,
                (dimension[at], values[at]),
                xytext=(-8, 6) if color == MUTED else (0, 7),
                textcoords="offset points",
                color=color,
                ha="right" if color == MUTED else "center",
            )
        curves.set_title("Its torsional stiffness, at three levels of the model")
        curves.set_xlabel("fractal dimension $D$ of the surfaces ($G = 10^{-8}$ mm, 5 N·m)")
        curves.set_ylabel("stiffness at the output [N·m/rad]")
        curves.set_xlim(*DIMENSION_RANGE)
    return figure


def main(picture: Path = PICTURE) -> dict[str, np.ndarray]:
    use_double_precision()
    use_compilation_cache()
    dimension = np.linspace(*DIMENSION_RANGE, 131)
    levels = stiffness_levels(dimension)
    draw(dimension, levels).savefig(picture, dpi=150)
    for name, values in levels.items():
        print(f"{name:36s}{np.min(values):10.3g} to {np.max(values):.3g} N·m/rad")
    return levels


if __name__ == "__main__":
    main(*(Path(argument) for argument in sys.argv[1:2]))

"""Where the paper's joint slips: a map of preload and output torque, and the stiffness inside it.

Run: ``python examples/sweep_preload.py [picture.png]``.
"""

import sys
from pathlib import Path

from asperity.joint_file.reader import read_case
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.study.parameters import parse_axis
from asperity.study.sweep.sweep import sweep
from asperity.study.sweep.sweep_plot import sweep_figure

FILE = Path(__file__).with_name("zou2025.toml")


def main(picture: Path | None) -> float:
    """Largest torque of the grid that 1000 N of preload carry [N·m]."""
    use_double_precision()
    use_compilation_cache()
    found = sweep(
        read_case(FILE),
        [parse_axis("load.output_torque=0 N*m:40 N*m:41"), parse_axis("load.preload=500 N:3000 N:26")],
        results=("assembly_stiffness_output",),
    )
    if picture is not None:
        sweep_figure(found).savefig(picture, dpi=150)
    solved = found["status"].sel({"load.preload": 1000.0}, method="nearest") == 0
    largest = float(found["load.output_torque"].values[solved.values].max())
    print(f"with 1000 N of preload every contact holds up to {largest:g} N·m")
    return largest


if __name__ == "__main__":  # spawned processes read this file again
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)

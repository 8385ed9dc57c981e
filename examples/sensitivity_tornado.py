"""Which numbers of the paper's joint decide its stiffness: exact elasticities, ranked and drawn.

Run: ``python examples/sensitivity_tornado.py [picture.png]``.
"""

import sys
from pathlib import Path

from asperity.joint_file.reader import read_case
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.study.tolerances.influence_plot import tornado_figure
from asperity.study.tolerances.sensitivity import ranking, sensitivity

FILE = Path(__file__).with_name("zou2025.toml")


def main(picture: Path | None) -> float:
    """Elasticity of the standing torque capacity with respect to the number of planets [-]: exactly 1."""
    use_double_precision()
    use_compilation_cache()
    found = sensitivity(read_case(FILE))
    ranked = ranking(found, "assembly_stiffness_output")
    for name, elasticity in zip(ranked["input"].values[:5], ranked["elasticity"].values, strict=False):
        print(f"one per cent more of {name}: {elasticity:+.2f} % of stiffness")
    if picture is not None:
        tornado_figure(found, result="assembly_stiffness_output").savefig(picture, dpi=150)
    return float(found["elasticity"].sel(result="standing_torque_capacity", input="drive.planets"))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)

"""The paper's joint at three levels of the model, and where the compliance of the fullest one comes from.

Run it: ``python examples/stiffness_levels.py``.
"""

import dataclasses
from pathlib import Path

import numpy as np

from asperity.joint.evaluation import JointResult
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.precision import use_compilation_cache, use_double_precision

FILE = Path(__file__).with_name("zou2025.toml")


def main() -> JointResult:
    use_double_precision()
    use_compilation_cache()
    joint = joint_from_case(read_case(FILE))
    result = solve_joint(dataclasses.replace(joint, output_torque=1e-6, input_speed=0.0)).result
    levels = {
        "published (25): asperities alone": result.published,
        "(25) with the bodies in series": result.series_with_bulk,
        "assembled, planet floating": result.assembly.stiffness,
    }
    for name, level in levels.items():
        print(
            f"{name:36s}{float(level.output):12.4g} N·m/rad {float(level.output_per_arcminute):10.4g} N·m/arcmin"
        )
    share = result.interfaces.tangential / result.interfaces.asperity_tangential  # of springs in series
    asperities = np.asarray(share * result.assembly.tangential_share)
    print(f"planet float {float(np.sum(result.assembly.normal_share)):.1%} of the compliance")
    print(f"tangential springs {float(np.sum(result.assembly.tangential_share)):.1%}, of it asperities:")
    for name, share in zip(result.contact_names, asperities, strict=True):
        print(f"  {name}: {share:.2%} of the joint's compliance")
    return result


if __name__ == "__main__":
    main()

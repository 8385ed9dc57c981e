"""The paper's joint at three levels of the model, and where the compliance of the fullest one comes from.

Run it: ``python examples/stiffness_levels.py``.
"""

import dataclasses

import numpy as np

from asperity.drive.geometry import CONTACT_NAMES
from asperity.joint.evaluation import JointResult
from asperity.joint.solve import solve
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.zou2025.preset import operating_grid, table_2_joint


def main() -> JointResult:
    use_double_precision()
    use_compilation_cache()
    joint = dataclasses.replace(table_2_joint(operating_grid()), output_torque=1e-6, sun_speed=0.0)
    result = solve(joint).result
    levels = {
        "published (25): asperities alone": result.published,
        "(25) with the bodies in series": result.series_with_bulk,
        "assembled, planet floating": result.assembly.stiffness,
    }
    for name, level in levels.items():
        print(
            f"{name:36s}{float(level.output):12.4g} N·m/rad {float(level.output_per_arcminute):10.4g} N·m/arcmin"
        )
    asperities = np.asarray(result.interfaces.asperity_share_tangential * result.assembly.tangential_share)
    print(f"planet float {float(np.sum(result.assembly.normal_share)):.1%} of the compliance")
    print(f"tangential springs {float(np.sum(result.assembly.tangential_share)):.1%}, of it asperities:")
    for name, share in zip(CONTACT_NAMES, asperities, strict=True):
        print(f"  {name}: {share:.2%} of the joint's compliance")
    return result


if __name__ == "__main__":
    main()

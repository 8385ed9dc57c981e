"""Types of planar drives, and the model of the joint file of each."""

from __future__ import annotations

from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.planar_model import MultirollerCase, PlanarCase, PlanetaryCase, SteppedPlanetCase

#: Model of the joint file of each type but the paper's.
PLANAR_CASES: dict[str, type[PlanarCase]] = {
    "planetary": PlanetaryCase,
    "multiroller": MultirollerCase,
    "stepped_planet": SteppedPlanetCase,
    "planar": GeneralCase,
}

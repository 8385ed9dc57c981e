"""Types of planar drives, and the model of the joint file of each."""

from __future__ import annotations

from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.planar_model import MultirollerCase, PlanarCase, PlanetaryCase, SteppedPlanetCase
from asperity.joint_file.wedge_model import Case

#: Model of the joint file of each type of drive.
PLANAR_CASES: dict[str, type[PlanarCase]] = {
    "zou2025": Case,
    "planetary": PlanetaryCase,
    "multiroller": MultirollerCase,
    "stepped_planet": SteppedPlanetCase,
    "planar": GeneralCase,
}

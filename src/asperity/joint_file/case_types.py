"""Types of drives, and the model of the joint file of each."""

from __future__ import annotations

from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.model import Case, MultirollerCase, PlanetaryCase, SteppedPlanetCase
from asperity.joint_file.wedge_model import WedgeCase

#: Model of the joint file of each type of drive.
CASES: dict[str, type[Case]] = {
    "zou2025": WedgeCase,
    "planetary": PlanetaryCase,
    "multiroller": MultirollerCase,
    "stepped_planet": SteppedPlanetCase,
    "planar": GeneralCase,
}

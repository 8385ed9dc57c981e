"""What is taken of the temperatures."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint_file.assumed.described import Described
from asperity.joint_file.build import thermal_change_of
from asperity.joint_file.model import Case
from asperity.joint_file.sections import without_expansion
from asperity.joint_file.si_tables import si_values


def temperature(file: Described) -> Iterator[str]:
    """Which temperatures, and what they do to the preload and the housing."""
    case, _ = file
    if case.temperature is None:
        return
    if file.joint.rolling.lubricant is None:
        stay = "elastic moduli, friction and the oil's viscosity"
    else:
        stay = "the oil's too; elastic moduli and the friction coefficient"
    yield f"temperature: the same in all bodies; {stay} stay those of the file"
    if case.load.preload is not None:
        yield (
            f"load.preload is a force: {_left_out(case)} does not move it, as if a spring or a weight made it; give "
            "load.interference if the sizes make the preload"
        )
    elif case.temperature.housing_expansion is None and case.in_frame():
        first = case.drive_type.parts[0].name.replace("_", " ")
        yield f"no temperature.housing_expansion: the frame expands as the {first} does"
    elif case.temperature.housing_expansion is None and case.housing is None and not case.without_housing():
        yield "no temperature.housing_expansion: the housing expands as the ring does"


def _left_out(case: Case) -> str:
    """What the temperatures would add to an interference, in words."""
    unknown = without_expansion(dict(case.bodies), case.materials)
    if unknown:
        return f"the thermal_expansion of {', '.join(unknown)}, which the file does not state,"
    return f"{1e6 * thermal_change_of(si_values(case)):.3g} µm of interference by temperature"

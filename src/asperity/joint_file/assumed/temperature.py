"""What is taken of the temperatures."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint_file.assumed.described import Described
from asperity.joint_file.build import thermal_change_of
from asperity.joint_file.model import Case
from asperity.joint_file.sections import OIL_LIMIT, HeatEntry, without_expansion
from asperity.joint_file.si_tables import si_values


def temperature(file: Described) -> Iterator[str]:
    """Which temperatures, and what they do to the preload and the housing."""
    case, _ = file
    if case.temperature is None and case.heat is None:
        return
    if file.joint.rolling.lubricant is None:
        stay = "elastic moduli, friction and the oil's viscosity"
    else:
        stay = "the oil's too; elastic moduli and the friction coefficient"
    if case.heat is None:
        yield f"temperature: the same in all bodies; {stay} stay those of the file"
    else:
        yield (
            "temperature: steady, one of the rollers and their oil, one of housing and rings; elastic moduli and the "
            "friction coefficient stay those of the file"
        )
        yield from _cooling(case, case.heat)
    if case.temperature is None:
        return
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


def _cooling(case: Case, heat: HeatEntry) -> Iterator[str]:
    """What is taken of the flow of heat."""
    yield (
        "heat: all losses leave through the housing, by the same resistance at every temperature; churning of the oil "
        "and heat from outside, such as a motor's, are not included"
    )
    if heat.roller_resistance is None:
        yield "no heat.roller_resistance: the rollers are as warm as the housing"
    if heat.oil_limit is None:
        yield f"no heat.oil_limit: steady temperatures up to {OIL_LIMIT:g} degC count"
    if heat.heat_capacity is None:
        yield "no heat.heat_capacity: no time constant" + (
            "" if case.duty is None else ", no peak of the duty"
        )
    elif case.duty is not None and heat.duty_time is None:
        yield "no heat.duty_time: no peak of the duty"
    if heat.cold_start is None:
        yield "no heat.cold_start: no capacities and no torque of the input at a cold start"
    if case.duty is not None:
        yield "life under the duty: at the temperature of the load of the file, not at those of its loads"


def _left_out(case: Case) -> str:
    """What the temperatures would add to an interference, in words."""
    unknown = without_expansion(dict(case.bodies), case.materials)
    if unknown:
        return f"the thermal_expansion of {', '.join(unknown)}, which the file does not state,"
    return f"{1e6 * thermal_change_of(si_values(case)):.3g} µm of interference by temperature"

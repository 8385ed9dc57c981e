"""What is taken of the joint that turns: its rolling, its oil and its heat."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint_file.assumed.contact_law import in_rolling
from asperity.joint_file.assumed.described import Described
from asperity.joint_file.part_names import HOUSING


def rolling(file: Described) -> Iterator[str]:
    """What the model of rolling takes for every joint, and what a file leaves out of it."""
    stated = file.case.rolling
    yield (
        "rolling: steady; the asperities are compliant in both directions, by u_0 = N/K_n for e times the "
        f"pressure{in_rolling(file)}; churning of the oil is not included"
    )
    yield (
        "life: rolling-contact fatigue of through-hardened bearing steel, without factors for film, cleanliness or "
        "traction; life and shakedown take the pressure of smooth bodies, which is higher than that of rough ones"
    )
    if stated is None or stated.skew is None:
        yield "no rolling.skew: the axes of the rollers are parallel, without axial forces"
    if stated is None or stated.hysteresis_factor is None:
        yield "no rolling.hysteresis_factor: no hysteresis loss of the bodies in rolling"
    if stated is None or stated.reliability is None:
        yield "no rolling.reliability: 0.9, so that lives are L10"


def oil(file: Described) -> Iterator[str]:
    """What is left out of the oil."""
    stated = file.case.lubrication
    if stated is None:
        yield "no section [lubrication]: no oil and no oil loss at the inlet of the contacts"
    elif stated.pressure_coefficient is None:
        yield "no lubrication.pressure_coefficient: no film thickness"
    elif stated.roughness is None:
        if file.joint.rolling.roughness is None:
            yield "no lubrication.roughness, and no Ra of every surface: no film ratio λ"
        else:
            yield (
                "no lubrication.roughness: that of normally distributed heights, Rq = sqrt(pi/2) Ra = 1.2533 Ra of "
                "both surfaces together"
            )


def heat(file: Described) -> Iterator[str]:
    """Materials whose thermal properties are not stated."""
    case, _ = file
    names = (name for body, name in case.bodies.items() if case.housing is None or body != HOUSING)
    for name in dict.fromkeys(names):
        material = case.materials[name]
        absent = [
            key
            for key in ("thermal_conductivity", "specific_heat_capacity")
            if getattr(material, key) is None
        ]
        if absent:
            yield f"no {' and '.join(absent)} of material {name}: no flash temperature of its contacts"

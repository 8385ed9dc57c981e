"""What is taken of the joint that turns: its rolling, its oil, its heat and its wear."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.contact.fluid import RheologicalTraction
from asperity.contact.measured_traction import MeasuredTraction
from asperity.contact.viscosity import EstimatedPressureRise
from asperity.joint_file.assumed.contact_law import in_rolling
from asperity.joint_file.assumed.described import Described
from asperity.joint_file.fluid_entries import FluidEntry
from asperity.joint_file.lubricant import CONDUCTIVITY, SHEAR_LAW, SHEAR_MODULI, SHEAR_MODULUS
from asperity.joint_file.part_names import HOUSING
from asperity.library.fluids import library_fluid, section_of
from asperity.rolling.conditions import ZERO_CELSIUS, Lubricant


def rolling(file: Described) -> Iterator[str]:
    """What the model of rolling takes for every joint, and what a file leaves out of it."""
    stated = file.case.rolling
    yield (
        "rolling: steady; the asperities are compliant in both directions, by u_0 = N/K_n for e times the "
        f"pressure{in_rolling(file)}; churning of the oil is not included"
    )
    factors = (
        "without factors for film, cleanliness or traction"
        if file.case.life is None
        else "times a_ISO of ISO 281 for film and cleanliness, with κ = λ^1.3, without a factor for traction"
    )
    yield (
        f"life: rolling-contact fatigue of through-hardened bearing steel, {factors}; life and shakedown take the "
        "pressure of smooth bodies, which is higher than that of rough ones"
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
        return
    lubricant = file.joint.rolling.lubricant
    if not _with_film(file):
        yield "friction as stated: no traction data of the oil"
    if lubricant is not None:
        yield from _fluid(file, lubricant)
    if stated.pressure_coefficient is None and stated.fluid is None:
        yield "no lubrication.pressure_coefficient: no film thickness"
    elif stated.roughness is None:
        if file.joint.rolling.roughness is None:
            alone = (
                "" if not _with_film(file) else "; the film carries the whole load, the asperities nothing"
            )
            yield f"no lubrication.roughness, and no Ra of every surface: no film ratio λ{alone}"
        else:
            yield (
                "no lubrication.roughness: that of normally distributed heights, Rq = sqrt(pi/2) Ra = 1.2533 Ra of "
                "both surfaces together"
            )
    has_ratio = file.joint.rolling.roughness is not None and (stated.pressure_coefficient or stated.fluid)
    if has_ratio and file.case.life is None:
        yield "no life.cleanliness: lives have no factor a_ISO for the oil film"


def _with_film(file: Described) -> bool:
    """Whether creep and capacity in rolling follow from the film of an oil."""
    lubricant = file.joint.rolling.lubricant
    return lubricant is not None and lubricant.fluid.traction is not None


def _fluid(file: Described, lubricant: Lubricant) -> Iterator[str]:
    """What is taken of an oil of which the file does not say it."""
    stated, sections = file.case.lubrication, file.case.fluids or {}
    assert stated is not None
    assert stated.fluid is not None
    name, known, section = stated.fluid, library_fluid(stated.fluid), section_of(stated.fluid, sections)
    entry = FluidEntry() if section is None else sections[section]
    if isinstance(lubricant.fluid.viscosity.pressure_rise, EstimatedPressureRise):
        yield (
            f"no pressure_coefficient of {name}: that of paraffinic mineral oils of its viscosity, 10.471 1/GPa times "
            "its viscosity in mPa*s to the power 0.1348 (ANSI/AGMA 925-A03); naphthenic oils have about "
            "1.5 times it, traction fluids 1.7 times, PAO 0.7 times"
        )
    elif entry.pressure_coefficient is not None:
        yield f"pressure_coefficient of {name}: the same at all temperatures, rising after Roelands"
    if entry.viscosity_40 is not None:
        yield f"viscosity of {name}: Walther's equation (ASTM D341) with the same density at all temperatures"
    if isinstance(lubricant.fluid.traction, RheologicalTraction):
        if entry.shear_law is None and (known is None or known.shear_law is None):
            yield f"no shear_law of {name}: {SHEAR_LAW}; traction fluids flow up to their limit, limit"
        if entry.shear_modulus is None:
            low, high = (1e-9 * value for value in SHEAR_MODULI)
            yield (
                f"no shear_modulus of {name}: {1e-9 * SHEAR_MODULUS:g} GPa; films of oil have {low:g} to {high:g} GPa, "
                "a softer one creeps more"
            )
    elif isinstance(lubricant.fluid.traction, MeasuredTraction) and entry.rig is None:
        yield (
            f"no rig of {name}: the discs of its traction_curve count twice, so that contacts creep up to their "
            "friction times p0/E* too much"
        )
    elif lubricant.fluid.traction is not None and entry.rig is None:
        yield f"no rig of {name}: traction_slope is that of the film alone, without the discs"
    if isinstance(lubricant.fluid.traction, MeasuredTraction):
        yield f"traction_curve of {name}: held beyond its points and conditions, with the heat of its measurement in it"
    if entry.conductivity is None and (known is None or known.conductivity is None):
        yield f"no conductivity of {name}: {CONDUCTIVITY:g} W/(m K), that of mineral oils"
    lowest = lubricant.lowest_temperature
    if lowest is not None and float(lubricant.temperature) < float(lowest):
        yield (
            f"{name} at {float(lubricant.temperature) - ZERO_CELSIUS:.4g} degC: below the lowest temperature of its "
            f"data, {float(lowest) - ZERO_CELSIUS:g} degC; viscosity and traction are extrapolated"
        )


def heat(file: Described) -> Iterator[str]:
    """Materials whose thermal properties are not stated."""
    case = file.case
    cooler = ", and the heat of slip warms the film by its own conduction alone" if _with_film(file) else ""
    names = (name for body, name in case.bodies.items() if case.housing is None or body != HOUSING)
    for name in dict.fromkeys(names):
        material = case.materials[name]
        absent = [
            key
            for key in ("thermal_conductivity", "specific_heat_capacity")
            if getattr(material, key) is None
        ]
        if absent:
            yield f"no {' and '.join(absent)} of material {name}: no flash temperature of its contacts{cooler}"


def wear(file: Described) -> Iterator[str]:
    """What is taken of the wear of the tracks."""
    if file.case.wear is not None:
        yield (
            "wear: Archard's law with a constant coefficient, without running-in; tracks wear alike all round, "
            "whatever their runout, and evenly along the axis, but for crowns, which become flatter"
        )

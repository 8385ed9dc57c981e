"""What a joint file leaves out, and what is assumed instead."""

from __future__ import annotations

from collections.abc import Mapping

from asperity.joint_file.drawn_surface import depth_assumptions, surfaces_by_average
from asperity.joint_file.material_entries import MaterialEntry
from asperity.joint_file.model import Case, Lubrication, Rolling
from asperity.joint_file.planar_model import PlanarCase, PlanarRolling
from asperity.joint_file.temperature_section import without_expansion
from asperity.library import read_finishes
from asperity.units import format_quantity

#: What is taken of crowned rollers in every drive.
LOADING_CAM = (
    "loading cam: its ramps have no friction, so that it follows every change of the torque and turns as far as the "
    "work on the contacts demands; a cam that sticks is stiffer, and adds hysteresis of its own"
)
CROWNED = (
    "crowned rollers: in slices that share one creepage, aligned and highest in the middle of their contact lines; no "
    "concentration of stress at loaded ends, no slip between slices of different radius"
)


def assumptions(case: Case) -> tuple[str, ...]:
    """What a joint file leaves out, and what is taken instead.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    tuple of str
        One sentence each.
    """
    told = []
    if case.bearings is None:
        told.append("no section [bearings]: the bearings have no friction")
    if case.compliance is None:
        told.append("no section [compliance]: pins and shafts are rigid, the planets float")
    else:
        absent = [name for name, value in case.compliance if value is None]
        if absent:
            told.append(f"[compliance] without {', '.join(absent)}: ideal, as their descriptions say")
    if case.play is None:
        told.append("no section [play]: the output has no play")
    if case.model.bodies is None:
        told.append("no model.bodies: the bodies of the assembly by plane elasticity, exact")
    if case.model.bodies != "springs" and case.model.plane_state is None:
        told.append("no model.plane_state: plane strain; plane stress is the bound for thin bodies")
    if case.drive.ring_support is None:
        told.append("no drive.ring_support: a rigid housing holds the outer rim of the ring")
    sizes = [
        f"{body}_radius"
        for body in ("sun", "planet", "loading_roller", "ring")
        if getattr(case.drive, f"{body}_radius").tolerance > 0.0
    ]
    if case.load.preload is not None and sizes:
        told.append(
            f"load.preload is a force: the tolerance of {', '.join(f'drive.{name}' for name in sizes)}, up to "
            f"{1e6 * max(getattr(case.drive, name).tolerance for name in sizes):.3g} µm, does not move it; give "
            "load.interference if the sizes make the preload"
        )
    if case.load.cam_force_per_torque is not None:
        told.append(LOADING_CAM)
    if case.branch is not None:
        told.append(
            "[[branch]]: ring and carrier are centred; the standing drive is loaded after it has rolled without "
            "torque; all numbers but those of the worst branch, of single planets, of their sums, of the forces on the "
            "members on the axis, of bearings and of rims that bend are of equal ones"
        )
        if case.drive.ring_support == "free":
            told.append(
                "[[branch]] in a free ring: it gives way to each planet as if all planets were like that one, which "
                "overstates the differences between their preloads"
            )
        if case.compliance is None or case.compliance.sun_support_stiffness is None:
            told.append(
                "[[branch]] without compliance.sun_support_stiffness: the sun is held rigidly on the axis; a sun that "
                "floats (0) shares the load among the branches"
            )
    told += _surfaces(case)
    told += temperature_assumptions(case, housed=case.drive.ring_support != "free")
    for roller in ("planet", "loading_roller"):
        if getattr(case.drive, f"{roller}_length") is None:
            told.append(f"no drive.{roller}_length: as long as the longest contact line on it")
    if any(
        getattr(case.drive, f"{body}_crown_radius") for body in ("sun", "planet", "loading_roller", "ring")
    ):
        told.append(CROWNED)
    told += _rolling(case)
    told += _fatigue(case)
    return tuple(told)


def _surfaces(case: Case) -> list[str]:
    """What is taken for surfaces that are stated by their Ra."""
    told = []
    finishes = read_finishes()
    for path, entry in surfaces_by_average(case).items():
        average = entry.roughness_average
        assert average is not None
        if entry.partner_roughness_average is None:
            told.append(f"no {path}.partner_roughness_average: both bodies have the same Ra")
        for key in ("roughness_average", "partner_roughness_average"):
            stated = getattr(entry, key)
            if stated is None or stated.tolerance > 0.0:
                continue
            told.append(
                f"{path}.{key} without a tolerance: as measured over one evaluation length, not the upper "
                "limit that a drawing states; surfaces below the limit are smoother"
            )
        known = finishes.get(entry.finish or "")
        if known and not known.roughness_average[0] <= average.value <= known.roughness_average[1]:
            low, high = (format_quantity(each, "um") for each in known.roughness_average)
            told.append(
                f"{path}.roughness_average {format_quantity(average.value, 'um')} lies outside the {low} to {high} "
                f"that are published for {known.name} surfaces"
            )
    return told + depth_assumptions(case)


def temperature_assumptions(case: Case | PlanarCase, *, housed: bool) -> list[str]:
    """What is taken for the temperatures.

    Parameters
    ----------
    case : Case or PlanarCase
        The joint file.
    housed : bool
        Whether a housing holds a ring.

    Returns
    -------
    list of str
        One sentence each.
    """
    if case.temperature is None:
        return []
    told = [
        "temperature: the same in all bodies; elastic moduli, friction and the oil's viscosity stay those of the file"
    ]
    if case.load.preload is not None:
        unknown = without_expansion(dict(case.bodies), case.materials)
        change = (
            f"the thermal_expansion of {', '.join(unknown)}, which the file does not state,"
            if unknown
            else f"{1e6 * _thermal_interference(case):.3g} µm of interference by temperature"
        )
        told.append(
            f"load.preload is a force: {change} does not move it, as if a spring or a weight made it; give "
            "load.interference if the sizes make the preload"
        )
    elif case.temperature.housing_expansion is None and housed:
        told.append("no temperature.housing_expansion: the housing expands as the ring does")
    return told


def _thermal_interference(case: Case | PlanarCase) -> float:
    from asperity.joint.temperature import thermal_interference
    from asperity.joint_file.build import joint_from_case
    from asperity.joint_file.planar_build import thermal_change_of
    from asperity.joint_file.si_tables import si_values

    values = si_values(case)
    if isinstance(case, PlanarCase):
        return thermal_change_of(values)
    given = values["temperature"]
    change = thermal_interference(
        joint_from_case(case),
        temperature_rise=given["working"] - given["assembly"],
        housing_expansion=given.get("housing_expansion"),
    )
    return float(change)


def fatigue_unknown(body: str, material: str) -> str:
    """Says that the safety of a body against fatigue is not computed.

    Parameters
    ----------
    body, material : str
        A body that bends, and the name of its material, which has no fatigue strength.

    Returns
    -------
    str
        One sentence.
    """
    return (
        f"no fatigue_strength of material {material}: the safety against fatigue of the {body.replace('_', ' ')}, "
        "which bends, is not computed"
    )


def _fatigue(case: Case) -> list[str]:
    """Which bending bodies have no safety against fatigue."""
    bends = {
        "ring": case.drive.ring_support in ("free", "elastic_housing"),
        "planet": case.drive.planet_bore_diameter is not None,
        "loading_roller": case.drive.loading_roller_bore_diameter is not None,
    }
    return [
        fatigue_unknown(body, name)
        for body, name in case.bodies
        if bends.get(body, False) and case.materials[name].fatigue_strength is None
    ]


def _rolling(case: Case) -> list[str]:
    """What is taken for the joint that turns."""
    return rolling_assumptions(case.rolling) + lubrication_assumptions(
        case.lubrication,
        materials={name: case.materials[name] for name in dict.fromkeys(value for _, value in case.bodies)},
    )


def rolling_assumptions(rolling: Rolling | PlanarRolling | None) -> list[str]:
    """What the model of rolling takes for every joint, and what a file leaves out of it.

    Parameters
    ----------
    rolling : Rolling, PlanarRolling or None
        Section [rolling] of the file.

    Returns
    -------
    list of str
        One sentence each.
    """
    told = [
        "rolling: steady, the asperities as an elastic layer of even stiffness; the churning of the oil is not counted",
        "life: rolling-contact fatigue of through-hardened bearing steel, no factors for film, cleanliness or traction",
    ]
    if rolling is None or rolling.skew is None:
        told.append("no rolling.skew: the axes of the rollers are parallel, there is no axial force")
    if rolling is None or rolling.hysteresis_factor is None:
        told.append("no rolling.hysteresis_factor: the bodies lose no work as they roll")
    if rolling is None or rolling.reliability is None:
        told.append("no rolling.reliability: nine drives in ten reach the life, 0.9")
    return told


def lubrication_assumptions(
    lubrication: Lubrication | None, *, materials: Mapping[str, MaterialEntry]
) -> list[str]:
    """What is left out of oil and heat.

    Parameters
    ----------
    lubrication : Lubrication or None
        The oil.
    materials : mapping
        Materials of the bodies by name.

    Returns
    -------
    list of str
        One sentence each.
    """
    told = []
    if lubrication is None:
        told.append("no section [lubrication]: no oil, no loss at the inlet of the contacts")
    elif lubrication.pressure_coefficient is None:
        told.append("no lubrication.pressure_coefficient: no thickness of the oil film")
    elif lubrication.roughness is None:
        told.append("no lubrication.roughness: no ratio lambda of the oil film to it")
    for name, material in materials.items():
        keys = ("thermal_conductivity", "specific_heat_capacity")
        absent = [key for key in keys if getattr(material, key) is None]
        if absent:
            told.append(f"no {' and '.join(absent)} of material {name}: no flash temperature of its contacts")
    return told

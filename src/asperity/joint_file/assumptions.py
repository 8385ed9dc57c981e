"""What a joint file leaves out, and what is assumed instead."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from asperity.joint.bodies import are_stepped
from asperity.joint.bores import pins_bend
from asperity.joint.description import Joint
from asperity.joint.pin_bound import pins_rigid
from asperity.joint.pin_interval import presses_in_bores
from asperity.joint.rims import bends
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.drawn_surface import depth_assumptions, surfaces_by_average
from asperity.joint_file.finish_in_surface import dimension_text
from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.material_entries import BY_DECAY_LENGTH, MaterialEntry
from asperity.joint_file.model import Case, Rolling
from asperity.joint_file.part_names import HOUSING, WEDGE_TYPE, material_key
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import leaves
from asperity.joint_file.section_build import film_roughness
from asperity.joint_file.sections import Lubrication, without_expansion
from asperity.joint_file.si_tables import si_values
from asperity.library import read_finishes, read_materials
from asperity.materials import Material
from asperity.unit_table import Dimension
from asperity.units import format_quantity, parse_quantity

_EQUAL_COEFFICIENTS = (
    "at standstill; the first contact that slips is the limit. With springs the forces follow from the slip of the "
    "contacts, and one of them may slip earlier, as the wind-up shows"
)
_STEPPED = {"multiroller": "the rollers of both rows", "stepped_planet": "the planets"}
_LAWS = {
    "zou_2025": "the published law, from the D and G of the surfaces",
    "exponential": "the law of randomly rough elastic surfaces, from the rms of their heights",
    "measured": "that of randomly rough elastic surfaces, from their decay_length",
    "persson_2007": "that of randomly rough elastic surfaces, from their spectrum",
}
RANDOM_ROUGHNESS = (
    "contact law exponential: randomly rough elastic surfaces, K_n = f N/(0.48 h), f from 1 to 2 because contacts "
    "widen under load, K_t proportional to 1 - T/(mu N), h the rms height of both bodies together; h counts waves "
    "shorter than the contact is wide, and along the axes up to the roll-off: longer ones make the joint look softer"
)
DECAY_LENGTH = (
    "contact law {}: K_n = f N/u with the decay_length u of each contact at every force, f from 1 to 2 because "
    "contacts widen under load, K_t proportional to 1 - T/(mu N)"
)
#: What the rms of the heights is where a file states Ra.
HEIGHTS_OF_AVERAGE = (
    "contact law exponential with roughness_average: normally distributed heights, h = 1.2533 Ra of both bodies "
    "together; D has no influence, and waves longer than the cut-off of Ra are not included"
)
LOADING_CAM = (
    "loading cam: its ramps have no friction, so that it follows every change of the torque and turns as far as the "
    "work on the contacts demands; a cam that sticks is stiffer and adds hysteresis"
)
#: What is taken of the bores of stepped rollers.
HOLLOW_STEPPED = (
    "a bore through two tracks, one of them in the middle and half of the other on either side: each track by plane "
    "elasticity, joined to the other by the shear between them. Against finite elements in space the roller's "
    "compliance is up to 2, 6 or 18 % too low for bores of 0.3, 0.5 or 0.65 of the smaller diameter; the stress that "
    "bends its rims is not computed"
)
_RIGID = (
    "no compliance.pin_stiffness: pins are rigid, and stiffness, natural frequencies and K1 to K3 are upper bounds; "
    "state it, or both pin_diameter and pin_length of [bearings], of which the bending of the pins is computed"
)
#: What is taken of crowned rollers in every drive.
CROWNED = (
    "crowned rollers: in slices that share one creepage, aligned and highest in the middle of their contact lines; no "
    "concentration of stress at loaded ends, no slip between slices of different radius"
)


def assumptions(case: Case) -> tuple[str, ...]:
    """What a joint file leaves out, and what is taken instead, one sentence each."""
    kind = case.type
    drive: Any = case.drive
    told: list[str] = []
    joint = joint_from_case(case)
    if case.open_radius is not None:
        told.append(f"{case.open_radius.words}, the radius that the file leaves open")
    if case.load.output_speed is not None:
        told.append(
            f"load.output_speed: the input turns at {format_quantity(float(joint.input_speed), 'rpm')}, by the ratio "
            "without slip"
        )
    if case.bearings is None:
        told.append("no section [bearings]: the bearings have no friction")
    else:
        told.append(
            "[bearings]: their friction opposes the rotation, in the drive that stands too; where the input has no "
            "speed it opposes the sense of the torque"
        )
    if joint.drive.pinned:
        told += _pins(joint)
    bored = [joint.drive.bodies[number].name.replace("_", " ") for number in are_stepped(joint)]
    if bored and joint.body_model == "exact":
        told.append(f"{', '.join(bored)}: {HOLLOW_STEPPED}")
    if case.play is None:
        told.append("no section [play]: the output has no play")
    if case.compliance is None:
        told.append("no section [compliance]: shafts are rigid, rollers without a pin float")
    else:
        absent = [name for name, value in case.compliance if value is None]
        if absent:
            told.append(f"[compliance] without {', '.join(absent)}: ideal, as their descriptions say")
    if isinstance(case, GeneralCase):
        told.append(
            "the rollers are placed where all contacts just touch, as near as possible to the positions in the file"
        )
        told.append("the tracks of a stepped roller lie in one plane; each contact is one spring")
        told += [
            f"contact {contact.name}: same_coefficient_as = '{contact.same_coefficient_as}': equal traction "
            f"coefficients in place of the slip of springs, {_EQUAL_COEFFICIENTS}"
            for contact in case.contact
            if contact.same_coefficient_as is not None
        ]
        told += [
            f"roller {roller.name}: pin_force = 'constant': a soft spring moves the pin and keeps its force"
            for roller in case.roller
            if roller.pin_force is not None
        ]
    elif drive.ring_support is None:
        told.append("no drive.ring_support: a rigid housing holds the outer rim of the ring")
    if joint.type == WEDGE_TYPE and joint.drive.closure.equal_coefficients:
        told.append(
            "model.traction_split: equal traction coefficients at both loading rollers of a planet, as the paper's "
            f"closure has it, {_EQUAL_COEFFICIENTS}"
        )
    if joint.closure_springs is not None:
        told.append(
            f"model.closure_springs = '{joint.closure_springs}': the forces under load are those of one spring for "
            "each contact between rigid pins, as in the paper's closure; bending rings and compliant pins change "
            "them only without this key"
        )
    if kind in _STEPPED:
        told.append(
            f"the tracks of {_STEPPED[kind]} lie in one plane: arrange them symmetrically, or their bearings carry the "
            "tilting moment; in compression a stepped roller is one spring for each contact"
        )
    if kind == "stepped_planet":
        told.append("both rings have the interference; the driven ring has no support")
    if case.model.bodies is None:
        told.append("no model.bodies: bodies by exact plane elasticity")
    if case.model.bodies != "springs" and case.model.plane_state is None:
        told.append("no model.plane_state: plane strain; plane stress is the bound for thin bodies")
    told.append("standing: forces from the slip of the contacts, loaded once from rest")
    told.append(
        "torque capacity, standing: a contact that slips keeps the force of its friction while others carry the rest; "
        "it is the torque beyond which they cannot, or at which a contact lifts off. In rolling: the first gross slip"
    )
    law = case.contact_law()
    ranged = {
        entry.fractal_dimension.tolerance > 0.0
        for entry in surfaces_by_average(case).values()
        if entry.fractal_dimension
    }
    for which, some in (
        ("middle of its range", True),
        ("value in the file, which Ra does not confirm", False),
    ):
        if law == "zou_2025" and some in ranged:
            told.append(
                f"roughness_average: Ra leaves D open, and all results are those of the {which}; 'asperity joint' "
                "gives the interval of stiffness and drift"
            )
    if case.model.contact_law is None:
        told.append(f"contact law {law}, since the file does not state model.contact_law: {_LAWS[law]}")
    if law in BY_DECAY_LENGTH:
        told.append(DECAY_LENGTH.format(law))
    if law == "exponential":
        told.append(RANDOM_ROUGHNESS)
        if surfaces_by_average(case):
            told.append(HEIGHTS_OF_AVERAGE)
    told += _surfaces(case)
    sizes = [
        path
        for path, key in leaves(case.drive, Quantity, "drive")
        if path.endswith("_radius") and key.tolerance
    ]
    if case.load.preload is not None and sizes:
        widest = max(key.tolerance for path, key in leaves(case.drive, Quantity, "drive") if path in sizes)
        told.append(
            f"load.preload is a force: the tolerance of {', '.join(sizes)}, up to {1e6 * widest:.3g} µm, does not move "
            "it; give load.interference if the sizes make the preload"
        )
    if joint.type != WEDGE_TYPE:
        told.append("every track is as long as its longest contact line")
    else:
        told += [
            f"no drive.{roller}_length: as long as the longest contact line on it"
            for roller in ("planet", "loading_roller")
            if getattr(drive, f"{roller}_length") is None
        ]
    if case.load.cam_force_per_torque is not None:
        told.append(LOADING_CAM)
    if case.branch is not None:
        told.append(
            "[[branch]]: every branch is solved by itself, together with the bodies on the axis; rings and carrier are "
            "centred, and what centres a ring that carries itself acts evenly all round; the standing drive is loaded "
            "from rest without torque"
        )
        if case.compliance is None or case.compliance.sun_support_stiffness is None:
            told.append(
                "[[branch]] without compliance.sun_support_stiffness: the input is held rigidly on the axis; a sun "
                "that floats (0) shares the load among the branches"
            )
    told += temperature_assumptions(case, housed=not case.without_housing())
    if joint.crown_curvatures is not None:
        told.append(CROWNED)
    told += rolling_assumptions(case.rolling, fractal=law == "zou_2025")
    told += lubrication_assumptions(
        case.lubrication,
        materials={
            name: case.materials[name]
            for body, name in case.bodies.items()
            if case.housing is None or body != HOUSING
        },
        by_average=film_roughness(si_values(case)) is not None,
    )
    bent = [
        (body.name, case.bodies[material_key(joint.type, body.name)], material)
        for body, acts, material in zip(joint.drive.bodies, bends(joint), joint.materials, strict=True)
        if acts
    ]
    told += dict.fromkeys(filter(None, (fatigue_assumption(*each) for each in bent)))
    return (*told, *(case.measured.assumed if case.measured else ()))


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
        dimension = entry.fractal_dimension
        if known is None and dimension and dimension.text == dimension_text(*finishes.values()):
            told.append(
                f"{path}.roughness_average without a finish: D is that of any finish, {dimension.text}; only "
                "the scatter of Ra and the published contact law take it"
            )
        if known and not known.roughness_average[0] <= average.value <= known.roughness_average[1]:
            low, high = (format_quantity(bound, "um") for bound in known.roughness_average)
            told.append(
                f"{path}.roughness_average {format_quantity(average.value, 'um')} lies outside the {low} to {high} "
                f"that are published for {known.name} surfaces"
            )
    return told + depth_assumptions(case)


def _pins(joint: Joint) -> list[str]:
    """How pins load their rollers, and what they give way."""
    if not presses_in_bores(joint):
        pressed = (
            "no bearings.pin_diameter: the force of a pin is spread over the rim of its roller; a pin that presses in "
            "a bore makes the joint softer and stresses the bore"
        )
    else:
        clearance = (
            "all round in the assembled drive, and the way of a pin across it is play, which [play] states"
            if joint.pin_clearance_stated
            else "none, since the file states no bearings.pin_radial_clearance"
        )
        pressed = (
            "bearings.pin_diameter: a pin of its roller's material presses over an arc of the bore, as an elastic "
            f"cylinder that fills it but for its clearance: {clearance}; a rolling bearing between them counts as part "
            "of the pin. Away from the arc the bore is free. The bore of a roller without a bore diameter is as wide "
            "as the pin; of a stepped roller each track has its bore to itself, and its contacts give way as those on "
            "an empty bore. For solid rollers with journals state bearings.pin_friction_diameter in its place"
        )
    if pins_bend(joint):
        bent = (
            "bearings.pin_length without compliance.pin_stiffness: pins bend and shear as beams of their rollers' "
            "material between rigid supports"
        )
        return [pressed, bent]
    return [pressed, _RIGID] if pins_rigid(joint) else [pressed]


def temperature_assumptions(case: Case, *, housed: bool) -> list[str]:
    """What is taken for the temperatures."""
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
    elif case.temperature.housing_expansion is None and case.housing is None and housed:
        told.append("no temperature.housing_expansion: the housing expands as the ring does")
    return told


def _thermal_interference(case: Case) -> float:
    from asperity.joint_file.build import thermal_change_of
    from asperity.joint_file.si_tables import si_values

    return thermal_change_of(si_values(case))


def fatigue_assumption(body: str, name: str, material: Material) -> str:
    """What is taken for the fatigue of a body that bends; empty where the file states the strength of its material."""
    if material.fatigue_strength is None:
        return (
            f"no fatigue_strength of material {name}: the fatigue safety of the {body.replace('_', ' ')}, which bends, "
            "is not computed"
        )
    strength = float(material.fatigue_strength)
    measured = [entry.numbers.get("fatigue_strength") for entry in read_materials().values()]
    if not any(text and parse_quantity(text, Dimension.PRESSURE) == strength for text in measured):
        return ""
    return (
        f"fatigue_strength of material {name}: {format_quantity(strength, 'MPa')} of specimens, from the library; the "
        "surface and the size of the finished part may lower it"
    )


def rolling_assumptions(rolling: Rolling | None, *, fractal: bool) -> list[str]:
    """What the model of rolling takes for every joint, and what a file leaves out of it."""
    local = ": the local form of the contact law is not published" if fractal else ""
    told = [
        f"rolling: steady; the asperities are compliant in both directions, by u_0 = N/K_n for e times the "
        f"pressure{local}; churning of the oil is not included",
        "life: rolling-contact fatigue of through-hardened bearing steel, without factors for film, cleanliness or "
        "traction; life and shakedown take the pressure of smooth bodies, which is higher than that of rough ones",
    ]
    if rolling is None or rolling.skew is None:
        told.append("no rolling.skew: the axes of the rollers are parallel, without axial forces")
    if rolling is None or rolling.hysteresis_factor is None:
        told.append("no rolling.hysteresis_factor: no hysteresis loss of the bodies in rolling")
    if rolling is None or rolling.reliability is None:
        told.append("no rolling.reliability: 0.9, so that lives are L10")
    return told


def lubrication_assumptions(
    lubrication: Lubrication | None, *, materials: Mapping[str, MaterialEntry], by_average: bool
) -> list[str]:
    """What is left out of oil and heat."""
    told = []
    if lubrication is None:
        told.append("no section [lubrication]: no oil and no oil loss at the inlet of the contacts")
    elif lubrication.pressure_coefficient is None:
        told.append("no lubrication.pressure_coefficient: no film thickness")
    elif lubrication.roughness is None:
        told.append(
            "no lubrication.roughness: that of normally distributed heights, Rq = sqrt(pi/2) Ra = 1.2533 Ra of both "
            "surfaces together"
            if by_average
            else "no lubrication.roughness, and no Ra of every surface: no film ratio λ"
        )
    for name, material in materials.items():
        keys = ("thermal_conductivity", "specific_heat_capacity")
        absent = [key for key in keys if getattr(material, key) is None]
        if absent:
            told.append(f"no {' and '.join(absent)} of material {name}: no flash temperature of its contacts")
    return told

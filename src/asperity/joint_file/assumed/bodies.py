"""What is taken of the bodies: their elasticity, bores, crowns and fatigue."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint.bodies import are_stepped
from asperity.joint.rims import bends
from asperity.joint_file.assumed.described import Described
from asperity.library import read_materials
from asperity.materials import Material
from asperity.unit_table import Dimension
from asperity.units import format_quantity, parse_quantity


def hollow_stepped(file: Described) -> Iterator[str]:
    """Bores of stepped rollers."""
    joint = file.joint
    bored = [joint.drive.bodies[number].name.replace("_", " ") for number in are_stepped(joint)]
    if bored and joint.body_model == "exact":
        yield (
            f"{', '.join(bored)}: a bore through two tracks, one of them in the middle and half of the other on "
            "either side: each track by plane elasticity, joined to the other by the shear between them. Against "
            "finite elements in space the roller's compliance is up to 2, 6 or 18 % too low for bores of 0.3, 0.5 or "
            "0.65 of the smaller diameter; the stress that bends its rims is not computed"
        )


def elasticity(file: Described) -> Iterator[str]:
    """By which elasticity the bodies give way."""
    model = file.case.model
    if model.bodies is None:
        yield "no model.bodies: bodies by exact plane elasticity"
    if model.bodies != "springs" and model.plane_state is None:
        yield "no model.plane_state: plane strain; plane stress is the bound for thin bodies"


def crowns(file: Described) -> Iterator[str]:
    """Crowned rollers."""
    if file.joint.crown_curvatures is not None:
        yield (
            "crowned rollers: in slices that share one creepage, aligned and highest in the middle of their contact "
            "lines; no concentration of stress at loaded ends, no slip between slices of different radius"
        )
    if file.joint.logarithmic_crowns is not None:
        yield (
            "logarithmic profiles: for each contact by its length and elasticity; without bound at the very ends, "
            "which no load reaches: what is made drops there by some micrometres more than the approach of the bodies"
        )


def fatigue(file: Described) -> Iterator[str]:
    """The fatigue strength of bodies that bend, each sentence once."""
    case, joint = file
    told = (
        _strength(body.name, case.bodies[case.drive_type.material_key(body.name)], material)
        for body, acts, material in zip(joint.drive.bodies, bends(joint), joint.materials, strict=True)
        if acts
    )
    yield from dict.fromkeys(filter(None, told))


def _strength(body: str, name: str, material: Material) -> str:
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

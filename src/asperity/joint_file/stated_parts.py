"""What a file says of its parts besides their sizes: tolerances, materials, crowns, surfaces, interference."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, NamedTuple

from asperity.drive.layout.sizes import ISO_16281, LOGARITHMIC
from asperity.drive.types import TYPES
from asperity.engine.arrays import as_numbers
from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint, tracks_of
from asperity.joint.evaluation import JointResult
from asperity.joint.solve import solve_joint
from asperity.joint_file import limits
from asperity.joint_file.build import joint_from_values, thermal_change_of
from asperity.joint_file.form_parts import form_errors, form_parts, refuse_floating_runout
from asperity.joint_file.law_keys import LAW_OF_KEY
from asperity.joint_file.sections import without_expansion
from asperity.joint_file.si_tables import AnyCase, si_values
from asperity.units import format_quantity

#: What a drawing says of profiles, with their load.
_PROFILES = {LOGARITHMIC: "logarithmic (Lundberg) for {} of normal force", ISO_16281: "ISO/TS 16281"}


class StatedTrack(NamedTuple):
    """What a file says of a track, with its radius [m].

    ``tolerance`` of the radius [m], of a ring the sum of that of its radius and that of the interference; 0 where the
    file states none. ``crown``, radius along the axis [m], None for a cylinder or a profile; names of the ``contacts``
    on it; ``profile`` in place of a crown, in words, empty for none.
    """

    radius: float
    tolerance: float
    crown: float | None
    contacts: tuple[str, ...]
    profile: str = ""


class StatedPart(NamedTuple):
    """What a file says of a body: name of its material, its tracks, and tolerances [m], 0 where it states none.

    ``form``: runout and roundness of its tracks as a drawing states them, full readings; none where it states none.
    """

    material: str
    tracks: tuple[StatedTrack, ...]
    bore: float = 0.0
    wall: float = 0.0
    length: float = 0.0
    form: tuple[str, ...] = ()

    def tolerance(self, radius: float) -> float:
        """Tolerance of the radius of a track [m]."""
        return next(
            (track.tolerance for track in self.tracks if math.isclose(track.radius, radius, rel_tol=1e-9)),
            0.0,
        )


class StatedParts(NamedTuple):
    """What a file says of its bodies, and of each contact: tolerance of its length [m], and its surface in words.

    ``symbols``: what the surface symbol of both bodies says, by lines; none where the file states no Ra or Rz, or
    another one for the partner, since it does not say which body is which. ``housing``: its material or nothing.
    """

    bodies: tuple[StatedPart, ...]
    lengths: tuple[float, ...]
    surfaces: tuple[str, ...]
    symbols: tuple[tuple[str, ...], ...]
    housing: str = ""


def stated_parts(case: AnyCase, joint: Joint) -> StatedParts:
    """What a joint file says of the bodies and contacts of its joint, in the order of the drive."""
    per_contact: tuple[Any, Any] = (case.drive.contact_length, case.surface)
    lengths, surfaces = (
        [stated[name] if isinstance(stated, dict) else stated for name in joint.contact_names]
        for stated in per_contact
    )
    form = _form_words(case, joint)
    return StatedParts(
        tuple(
            _part(case, joint, number, form.get(body.name, ()))
            for number, body in enumerate(joint.drive.bodies)
        ),
        tuple(length.tolerance for length in lengths),
        tuple(surface_words(surface) for surface in surfaces),
        tuple(surface_symbol(surface) for surface in surfaces),
        "" if joint.housing is None else case.bodies["housing"],
    )


def _form_words(case: AnyCase, joint: Joint) -> dict[str, tuple[str, ...]]:
    """Body → runout and roundness of its tracks, the largest of all sectors, as full readings."""
    if case.form is None or joint.unlike is not None:
        return {}
    drive = as_numbers(joint.drive)
    values = si_values(case)
    parts = form_parts(values, drive)
    refuse_floating_runout(values, drive)
    readings: dict[tuple[str, str], dict[int, float]] = {}
    bodies = {part.name: part.body for each in parts.values() for part in each}
    for error in form_errors(values, parts, drive, round(float(joint.drive.sectors))):
        of_track = readings.setdefault((bodies[error.part], error.part), {})
        of_track[error.harmonic] = max(2.0 * float(error.amplitude), of_track.get(error.harmonic, 0.0))
    words: dict[str, tuple[str, ...]] = {}
    for (body, part), of_track in readings.items():
        said = [
            f"runout {_length_of(size)}" if waves == 1 else f"roundness {_length_of(size)} in {waves} waves"
            for waves, size in sorted(of_track.items())
        ]
        track = "" if part == body else f" of track {part.replace('_', ' ')}"
        words[body] = (*words.get(body, ()), f"{', '.join(said)}{track} (full readings)")
    return words


def _length_of(size: float) -> str:
    return format_quantity(size, "µm", 4)


def _part(case: Any, joint: Joint, number: int, form: tuple[str, ...]) -> StatedPart:
    body = joint.drive.bodies[number].name
    kind = TYPES[case.type]
    key = kind.material_key(body)
    name = next((part.size_key for part in kind.parts if part.name == body), body)
    roller: Any = next((entry for entry in getattr(case, "roller", ()) if entry.name == body), None)

    def tolerance(what: str) -> float:
        of_type = getattr(case.drive, f"{name}_{what}", None)
        stated = of_type if roller is None else getattr(roller, what, None)
        return 0.0 if stated is None else float(stated.tolerance)

    return StatedPart(
        case.bodies[key],
        tuple(
            _track(case, joint, body, float(radius), contacts)
            for radius, contacts in tracks_of(joint, number)
        ),
        tolerance("bore_diameter"),
        tolerance("wall_thickness"),
        tolerance("length"),
        form,
    )


def _track(case: Any, joint: Joint, body: str, radius: float, contacts: list[int]) -> StatedTrack:
    tolerances, crowns, profiles = [0.0], [], []
    for number in contacts:
        contact = joint.drive.contacts[number]
        side = 0 if contact.first == body else 1
        kind = TYPES[case.type]
        if not kind.is_listed:
            table, key = case.drive, contact.tracks[side]
        else:
            table, key = case.contact[number], ("first", "second")[side]
        stated, crown = getattr(table, f"{key}_radius", None), getattr(table, f"{key}_crown_radius", None)
        in_ring = side == 1 and contact.internal and float(joint.pattern[number]) != 0.0
        added = case.load.interference if in_ring else None
        tolerances.append(sum(entry.tolerance for entry in (stated, added) if entry is not None))
        crowns += [] if crown is None else [float(crown.value)]
        profile, load = getattr(table, f"{key}_profile", None), getattr(table, f"{key}_profile_load", None)
        profiles += [] if profile is None else [_PROFILES[profile].format("" if load is None else load.text)]
    names = tuple(joint.drive.contacts[number].name for number in contacts)
    return StatedTrack(radius, max(tolerances), crowns[0] if crowns else None, names, "".join(profiles[:1]))


_GROOVES = {"rolling": "grooves in the rolling direction", "axis": "grooves along the axis"}


def surface_words(entry: Any) -> str:
    """What a file says of the surface of a contact, as a drawing states it."""
    depth, average = entry.mean_roughness_depth, entry.roughness_average
    grooves = "" if entry.lay is None else f", {_GROOVES[entry.lay]}, lay ratio {entry.lay_ratio.text}"
    if entry.rolling_share is not None:
        grooves = f", {100.0 * entry.rolling_share.value:.3g} % of the waves in the rolling direction"
    if depth is not None:
        return f"Rz {depth}" + _partner(entry) + grooves
    if average is not None:
        return f"Ra {_length(average)}" + _partner(entry) + grooves
    for words, quantity in (("Rq", entry.rms_height), ("decay length", entry.decay_length)):
        if quantity is not None:
            return f"{words} {_length(quantity)} of both bodies together{grooves}"
    of_law = [
        f"{key.replace('_', ' ')} {getattr(entry, key).text}" for key in LAW_OF_KEY if getattr(entry, key)
    ]
    if entry.fractal_dimension is None:
        return f"{', '.join(of_law)} of both bodies together"
    return (
        f"D {entry.fractal_dimension.value:.4g}, G {format_quantity(entry.fractal_roughness.value, 'm')} "
        "of both bodies together; no Ra stated"
    )


def surface_symbol(entry: Any) -> tuple[str, ...]:
    """What the surface symbol of ISO 21920-1 says of both bodies of a contact [µm]: Ra or Rz, or both of its limits."""
    if entry.partner_mean_roughness_depth is not None or entry.partner_roughness_average is not None:
        return ()
    name, quantity = "Ra", entry.roughness_average
    if entry.mean_roughness_depth is not None:
        name, quantity = "Rz", limits.MEAN_ROUGHNESS_DEPTH.read(entry.mean_roughness_depth)
    if quantity is None:
        return ()
    if not quantity.tolerance:
        return (f"{name} {1e6 * quantity.value:.4g}",)
    return tuple(
        f"{limit} {name} {1e6 * (quantity.value + sign * quantity.tolerance):.4g}"
        for limit, sign in (("U", 1.0), ("L", -1.0))
    )


def _partner(entry: Any) -> str:
    if entry.partner_mean_roughness_depth is not None:
        return f", its partner Rz {entry.partner_mean_roughness_depth}"
    partner = entry.partner_roughness_average
    return "" if partner is None else f", its partner Ra {_length(partner)}"


def _length(quantity: Any) -> str:
    tolerance = f" ±{1e6 * quantity.tolerance:.3g}" if quantity.tolerance else ""
    return f"{1e6 * quantity.value:.4g}{tolerance} µm"


class MadeInterference(NamedTuple):
    """By how much the inner radius of the rings is made smaller than that at which all contacts just touch [m].

    None where it is not known; ``unknown_because`` says why.
    """

    size: float | None
    unknown_because: str = ""


def made_interference(case: AnyCase, result: JointResult | None = None) -> MadeInterference:
    """Interference of the parts at their assembly: that of the file, or that which makes the force that it states.

    It follows from the result, if that is known; otherwise the joint is solved without torque, as it is assembled: a
    loading cam adds nothing. At another temperature than that of the assembly it is less what temperature adds.
    """
    load = case.load
    if load.interference is not None:
        return MadeInterference(load.interference.value)
    values, added = si_values(case), 0.0
    if not case.drive_type.approach(values["drive"]):
        return MadeInterference(None, "a force is stated, which no size makes")
    if case.temperature is not None:
        unknown = without_expansion(case.bodies, case.materials)
        if unknown:
            return MadeInterference(None, f"the thermal_expansion of {', '.join(unknown)} is not in the file")
    try:
        if case.temperature is not None:
            added = thermal_change_of(values)
        if result is None or load.cam_force_per_torque is not None or not math.isfinite(result.interference):
            joint = joint_from_values(values)
            result = solve_joint(dataclasses.replace(joint, output_torque=0.0)).result
    except (InputError, NoSolutionError) as error:
        return MadeInterference(None, str(error))
    return MadeInterference(float(result.interference) - added)

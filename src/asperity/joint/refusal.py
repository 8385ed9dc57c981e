"""What makes a joint impossible, in words: unknown variants, numbers out of range, bodies that do not fit."""

from __future__ import annotations

import math
import operator
from typing import get_args

import numpy as np

from asperity.body.shapes import PlaneState
from asperity.contact.asperity import AsperityBase
from asperity.contact.population import ContactFactorModel
from asperity.drive.existence import overlaps, pin_lock, smaller_body, too_wide
from asperity.drive.geometry import CONTACT_NAMES, Clearance, triangle
from asperity.drive.mechanism import Closure, rest_state
from asperity.errors import InputError
from asperity.joint.description import BodyModel, ClosureSprings, Joint, RingSupport
from asperity.joint.evaluation import JointResult
from asperity.joint.planar.evaluation import PlanarResult
from asperity.units import format_quantity

_POSITIVE = (0.0, math.inf)
_BODIES = ("sun", "planet", "loading_roller", "ring")
#: Open ranges of the numbers of a joint: path → bounds, in SI units.
_RANGES: dict[str, tuple[float, float]] = {
    **{f"geometry.{body}_radius": _POSITIVE for body in _BODIES},
    "geometry.left_push_angle": (-0.5 * math.pi, 0.5 * math.pi),
    "geometry.right_push_angle": (-0.5 * math.pi, 0.5 * math.pi),
    **{
        f"bodies.{body}.{name}": _POSITIVE
        for body in _BODIES
        for name in ("youngs_modulus", "yield_strength")
    },
    **{f"bodies.{body}.hardness": _POSITIVE for body in _BODIES},
    **{f"bodies.{body}.poisson_ratio": (-1.0, math.nextafter(0.5, 1.0)) for body in _BODIES},
    "planet_length": _POSITIVE,
    "loading_roller_length": _POSITIVE,
    "ring_wall_thickness": _POSITIVE,
    "preload": _POSITIVE,
}
_PER_CONTACT: dict[str, tuple[float, float]] = {
    "contact_lengths": _POSITIVE,
    "friction_coefficients": _POSITIVE,
}
_OF_SURFACES: dict[str, tuple[float, float]] = {
    "fractal_dimension": (1.0, 2.0),
    "fractal_roughness": _POSITIVE,
    "frequency_ratio": (1.0, math.inf),
}
_AT_LEAST_0 = (
    *(f"bearings.{body}_torque" for body in ("sun", "loading_roller", "carrier")),
    "bearings.pin_friction_coefficient",
    "bearings.pin_diameter",
    *(f"bodies.{body}.density" for body in _BODIES),
)


def refuse_unknown_variants(joint: Joint) -> None:
    """Refuse names of variants that do not exist.

    Parameters
    ----------
    joint : Joint
        The joint.

    Raises
    ------
    InputError
        With the names that do.
    """
    bases = {surface.asperity_base for surface in joint.surfaces}
    for name, found, kind in (
        ("closure", {joint.closure}, Closure),
        ("closure_springs", {joint.closure_springs}, ClosureSprings),
        ("body_model", {joint.body_model}, BodyModel),
        ("plane_state", {joint.plane_state}, PlaneState),
        ("ring_support", {joint.ring_support} - {None}, RingSupport),
        ("contact_factor_model", {joint.contact_factor_model}, ContactFactorModel),
        ("asperity_base", bases, AsperityBase),
    ):
        for value in found:
            if value not in get_args(kind):
                raise InputError(
                    f"{name} = {value!r}: there is no such variant; choose {' or '.join(get_args(kind))}"
                )


def refuse_bad_numbers(joint: Joint) -> None:
    """Refuse numbers that are none, or outside the range in which the formulas mean anything.

    Parameters
    ----------
    joint : Joint
        One joint; numbers as NumPy arrays.

    Raises
    ------
    InputError
        With the number and its range in SI units.
    """
    for name, entries in (
        ("surfaces", len(joint.surfaces)),
        *((n, len(getattr(joint, n))) for n in _PER_CONTACT),
    ):
        if entries not in (1, len(CONTACT_NAMES)):
            raise InputError(f"{name}: {entries} entries; give one for all contacts, or {len(CONTACT_NAMES)}")
    if math.isnan(_single("preload", joint.preload)):
        raise InputError(
            "the interference would press the contacts until they are as wide as their bodies: there is no such "
            "preload; choose less interference (load.interference)"
        )
    checks = [(path, operator.attrgetter(path)(joint), bounds) for path, bounds in _RANGES.items()]
    for name, bounds in _PER_CONTACT.items():
        checks += [(f"{name}[{index}]", value, bounds) for index, value in enumerate(getattr(joint, name))]
    for name, bounds in _OF_SURFACES.items():
        checks += [
            (f"surfaces[{index}].{name}", getattr(surface, name), bounds)
            for index, surface in enumerate(joint.surfaces)
        ]
    for name, value, (low, high) in checks:
        if not low < _single(name, value) < high:
            shown = f"above {low:g}" if high == math.inf else f"above {low:g} and below {high:.4g}"
            raise InputError(f"{name} = {float(value):g} (SI units) is not allowed; it must be {shown}")
    for path in _AT_LEAST_0:
        if not 0.0 <= _single(path, operator.attrgetter(path)(joint)) < math.inf:
            value = float(operator.attrgetter(path)(joint))
            raise InputError(
                f"{path} = {value:g} (SI units) is not allowed; it must be at least 0 and finite"
            )
    cam = joint.cam_force_per_torque
    if cam is not None and not 0.0 <= _single("cam_force_per_torque", cam) < math.inf:
        raise InputError(
            f"cam_force_per_torque = {float(cam):g} N/(N·m) is not allowed; it must be at least 0 and finite"
        )
    for name, stiffness in vars(joint.structure).items():
        if not _single(name, stiffness) >= 0.0:
            raise InputError(
                f"{name} = {float(stiffness):g} is not allowed; it must be at least 0, inf for rigid"
            )
    if (
        joint.pin is not None
        and not _single("pin.free_length", joint.pin.free_length) >= joint.loading_roller_length
    ):
        raise InputError(
            f"the pins have a free length of {format_quantity(float(joint.pin.free_length), 'mm')}, less than the "
            f"{format_quantity(float(joint.loading_roller_length), 'mm')} of their loading rollers: lengthen the pins "
            "(bearings.pin_length)"
        )
    count = _single("planet_count", joint.geometry.planet_count)
    if not (count >= 1.0 and count == round(count)):
        raise InputError(f"planet_count = {count:g} is not allowed; it must be a whole number, at least 1")
    for name, unit in (("sun_speed", "rad/s"), ("output_torque", "N·m")):
        if not math.isfinite(_single(name, getattr(joint, name))):
            value = float(getattr(joint, name))
            raise InputError(f"{name} = {value:g} {unit} is not allowed; it must be finite")


def _single(name: str, value: object) -> float:
    number = np.asarray(value)
    if number.ndim:
        raise InputError(
            f"{name} has the shape {number.shape}: solve takes one joint; for many, use evaluate"
        )
    return float(number)


def refuse_overlap(joint: Joint, gaps: tuple[Clearance, ...]) -> None:
    """Refuse rollers that do not fit.

    Parameters
    ----------
    joint : Joint
        One joint.
    gaps : tuple of Clearance
        Its clearances.

    Raises
    ------
    InputError
        With the condition that is not met and the radii.
    """
    geometry = joint.geometry
    for clearance in gaps:
        if not overlaps(gap=clearance.gap):
            continue
        gap = float(clearance.gap)
        radii = ", ".join(
            f"{symbol} = {format_quantity(float(value), 'mm')}"
            for symbol, value in (
                ("R_s", geometry.sun_radius),
                ("R_p", geometry.planet_radius),
                ("R_w", geometry.loading_roller_radius),
                ("R_o", geometry.ring_radius),
            )
        )
        found = f"the gap is {format_quantity(gap, 'mm')}, it must be above 0 mm"
        if math.isnan(gap):
            found = "the triangle sun, planet, loading roller does not close"
        raise InputError(
            f"the rollers do not fit: {clearance.condition}; {found} "
            f"({radii}, {float(geometry.planet_count):g} planets)"
        )


def refuse_wide_contacts(joint: Joint, result: JointResult) -> None:
    """Refuse contact strips that are not narrow against their bodies, where line-contact theory has no stiffness.

    Parameters
    ----------
    joint : Joint
        One joint.
    result : JointResult
        Its result.

    Raises
    ------
    InputError
        With the contact, its width and the body.
    """
    bodies = smaller_body(geometry=joint.geometry, ring_wall_thickness=joint.ring_wall_thickness)
    widths = result.diagnostics.hertz_half_width
    wide = too_wide(
        half_width=widths, smaller_body=bodies, bulk_normal_stiffness=result.interfaces.bulk_normal
    )
    if np.any(wide):
        first = int(np.argmax(wide))
        name, width, body = CONTACT_NAMES[first], float(np.asarray(widths)[first]), float(bodies[first])
        raise InputError(
            f"the contact {name} is {format_quantity(2.0 * width, 'mm')} wide, too wide for a radius or "
            f"wall of {format_quantity(body, 'mm')}: line-contact theory needs a half-width far below it; lower "
            "the preload, or choose longer contact lines or stiffer materials"
        )


def refuse_thin_walls(result: JointResult) -> None:
    """Refuse rings and hollow rollers whose wall is too thin for exact bodies.

    Parameters
    ----------
    result : JointResult
        The result of one joint.

    Raises
    ------
    InputError
        With the smallest wall.
    """
    if not bool(result.walls_hold):
        widest = float(np.max(np.asarray(result.diagnostics.hertz_half_width)))
        raise InputError(
            "the wall of the ring or of a hollow roller is too thin for exact bodies: it must be at least five "
            f"half-widths of its contacts, here {format_quantity(5.0 * widest, 'mm')}, and about 1 % of the ring's "
            'radius or 2 % of the roller\'s; choose a thicker wall, or bodies = "springs"'
        )


def refuse_short_contacts(result: PlanarResult) -> None:
    """Refuse crowned contacts that are too short for their width.

    Parameters
    ----------
    result : PlanarResult
        The result of one joint.

    Raises
    ------
    InputError
        With the contact, its length and its width.
    """
    holds = result.diagnostics.slices_hold
    if holds is None or np.all(np.asarray(holds)):
        return
    first = int(np.argmin(np.asarray(holds)))
    width = 2.0 * float(np.asarray(result.diagnostics.hertz_half_width)[first])
    ratio = float(np.asarray(result.diagnostics.loaded_length_over_width)[first])
    length, across = (format_quantity(each, "mm", 3) for each in (ratio * width, width))
    raise InputError(
        f"the crowned rollers touch at {result.contact_names[first]} over a length of {length} and a width of "
        f"{across}: the slices need a contact at least twice as long as wide; choose a larger crown radius"
    )


def refuse_locked_pins(joint: Joint) -> None:
    """Refuse pins that do not fit into their rollers, or hold them by friction.

    Parameters
    ----------
    joint : Joint
        One joint.

    Raises
    ------
    InputError
        With both sides of the condition.
    """
    pins = pin_lock(geometry=joint.geometry, bearings=joint.bearings)
    if pins.too_thick:
        raise InputError(
            f"the pin diameter {format_quantity(float(joint.bearings.pin_diameter), 'mm')} must be below the diameter "
            f"of the loading roller, {format_quantity(2.0 * float(joint.geometry.loading_roller_radius), 'mm')}"
        )
    if pins.locks:
        raise InputError(
            "the pins lock: pin friction coefficient times pin diameter over the diameter of the loading roller is "
            f"{float(pins.grip):.3g}, it must be below the cosine of the push angle, {float(pins.push):.3g}; choose a "
            "thinner pin, less pin friction or a push angle nearer 0"
        )


def refuse_pulled_rollers(joint: Joint, result: JointResult) -> None:
    r"""Refuse push angles at which the pins pull a loading roller off the ring at rest, :math:`\gamma \le \beta - 90°`.

    Parameters
    ----------
    joint : Joint
        One joint.
    result : JointResult
        Its result.

    Raises
    ------
    InputError
        With the angle and its lower bound.
    """
    geometry, wedge = joint.geometry, float(result.angles.wedge)
    for side, contact in (("right", 3), ("left", 4)):
        angle = float(getattr(geometry, f"{side}_push_angle"))
        if not angle <= wedge - 0.5 * math.pi:
            continue
        rest = rest_state(geometry=geometry, sides=triangle(geometry), preload=joint.preload)
        force = float(rest.normal_force[contact])
        raise InputError(
            f"{side}_push_angle {format_quantity(angle, 'deg')} pulls the {side} loading roller off the ring: without "
            f"torque the contact {CONTACT_NAMES[contact]} would have to carry {force:.3g} N; the angle must be above "
            f"{format_quantity(wedge - 0.5 * math.pi, 'deg')}, the wedge angle less 90 deg"
        )

"""How the rings of a drive sit in their housing: what holds them, and what that does to both."""

from __future__ import annotations

import dataclasses
import math
from typing import NamedTuple

from asperity.body.press_fit import PressFit, press_fit, rim_compliance
from asperity.body.rim_range import mises_stress
from asperity.drive.state.loads import MemberLoads
from asperity.engine.arrays import xp
from asperity.errors import InputError
from asperity.joint.body_shape import BodyShape, Housing
from asperity.joint.description import Joint, track_lengths, tracks_of
from asperity.materials import Material
from asperity.types import Array, Real
from asperity.units import format_quantity


class Seats(NamedTuple):
    """How each ring sits in its housing, shape (bodies,); nan of what no housing holds.

    ``force`` presses it in at the assembly [N]; ``heating`` of the housing, or ``cooling`` of the ring, takes the
    interference, without a gap [K], nan without thermal expansions; ``bore_change``, by how much the seat narrows the
    bore at the assembly, on the diameter [m]. At the working temperature: ``torque`` that friction holds [N·m], and
    ``torque_safety``, that over the one of the ring [-]; ``housing_stress``, hoop stress at the bore of the housing
    [Pa], and its ``yield_safety``, there and at the assembly [-].
    """

    force: Array
    heating: Array
    cooling: Array
    bore_change: Array
    torque: Array
    torque_safety: Array
    housing_stress: Array
    yield_safety: Array


def seated(joint: Joint) -> tuple[bool, ...]:
    """Which bodies a described housing holds."""
    return tuple(
        joint.housing is not None and shape.kind == "ring" and shape.support != "free"
        for shape in joint.shapes
    )


def _parts(joint: Joint, number: int) -> tuple[Housing, Material, Real, Real]:
    """Housing and material of a ring, and radii of its bore and of its seat [m]."""
    housing, wall = joint.housing, joint.shapes[number].size
    assert housing is not None
    assert wall is not None
    bore = tracks_of(joint, number)[0][0]
    return housing, joint.materials[number], bore, bore + wall


def _loosening(housing: Housing, ring: Material, seat_radius: Real) -> Real:
    """Interference on the diameter that a kelvin takes [m/K]; nan without thermal expansions."""
    if ring.thermal_expansion is None or housing.material.thermal_expansion is None:
        return math.nan
    return 2.0 * seat_radius * (housing.material.thermal_expansion - ring.thermal_expansion)


def loosening_temperatures(joint: Joint, assembly: float) -> list[float]:
    """Temperatures at which the fit of each ring in its housing is lost [degC]; nan where it is not, or none holds it.

    From the temperature of the assembly; equation (I5) of :doc:`/equations`.
    """
    temperatures = []
    for number, holds in enumerate(seated(joint)):
        taken = math.nan
        if holds:
            housing, ring, _, seat = _parts(joint, number)
            taken = float(_loosening(housing, ring, seat))
        fades = holds and math.isfinite(taken) and taken != 0.0
        temperatures.append(assembly + float(housing.interference) / taken if fades else math.nan)
    return temperatures


def housing_room(joint: Joint) -> Array:
    """Wall of the housing around each ring that it holds, shape (rings,) [m]; not above 0 where it lies inside it."""
    held = [_parts(joint, number) for number, holds in enumerate(seated(joint)) if holds]
    return xp.stack(
        [xp.asarray(housing.outer_radius - seat) for housing, _, _, seat in held] or [xp.ones(())]
    )


def refuse_housing(joint: Joint) -> None:
    """Refuse a housing that lies inside one of its rings."""
    for number in (number for number, holds in enumerate(seated(joint)) if holds):
        housing, _, _, seat_radius = _parts(joint, number)
        seat, outer = 2.0 * float(seat_radius), 2.0 * float(housing.outer_radius)
        if not outer > seat:
            name = joint.drive.bodies[number].name.replace("_", " ")
            raise InputError(
                f"housing.outer_diameter {format_quantity(outer, 'mm')}: the outer diameter of the {name} is "
                f"{format_quantity(seat, 'mm')}; make the housing larger, or the wall of the ring thinner"
            )


def in_housing(shape: BodyShape, bore_radius: Real, housing: Housing) -> BodyShape:
    """A ring whose elastic housing has the radial stiffness of its sizes; nan where it lies inside the ring."""
    if shape.support != "elastic_housing":
        return shape
    assert shape.size is not None
    seat = bore_radius + shape.size
    widening = rim_compliance(
        rim=seat,
        other=housing.outer_radius,
        youngs_modulus=housing.material.youngs_modulus,
        poisson_ratio=housing.material.poisson_ratio,
    )
    stiffness = xp.where(xp.asarray(housing.outer_radius) > seat, 1.0 / widening, xp.nan)
    return dataclasses.replace(shape, housing_stiffness=stiffness)


def ring_fit(joint: Joint, number: int, *, working: bool = True) -> PressFit:
    r"""The seat of a ring, alone, at the working temperature or at that of the assembly; pure.

    .. math:: \Delta d(T) = \Delta d + 2 b\,(\alpha_r - \alpha_h)\,\Delta T
    """
    housing, ring, bore, seat = _parts(joint, number)
    interference: Real = housing.interference
    if working and housing.temperature_rise is not None:
        interference = interference - _loosening(housing, ring, seat) * housing.temperature_rise
    return press_fit(
        ring=ring,
        housing=housing.material,
        bore_radius=bore,
        seat_radius=seat,
        outer_radius=housing.outer_radius,
        interference=interference,
    )


def heating(joint: Joint, number: int, gain: Real) -> Array:
    """Rise of temperature at which the bore of a ring in its housing has gained a radius [m]; [K], pure.

    As both expand until the housing lets the ring go, then as the ring does alone; nan without thermal expansions.
    """
    housing, ring, bore, seat = _parts(joint, number)
    held = 0.5 * ring_fit(joint, number, working=False).bore_change
    apart = _loosening(housing, ring, seat)
    widening = bore * (math.nan if ring.thermal_expansion is None else ring.thermal_expansion)  # m/K
    together = gain / (widening + held * apart / housing.interference)
    alone = xp.where(xp.isnan(xp.asarray(apart)), xp.nan, (gain - held) / widening)
    return xp.where(together * apart < housing.interference, together, alone)


def seats(joint: Joint, loads: MemberLoads) -> Seats:
    r"""How the rings sit in their housing under the torque; equation (I5) of :doc:`/equations`; pure.

    .. math:: F = 2\pi\mu\,p\,b\,L, \qquad T = F\,b, \qquad \Delta T = \frac{\Delta d}{2\,\alpha\,b}

    With the pressure of the seat alone: the forces of the rollers press the ring outwards and add to it.
    """
    rows = [
        _seat(joint, number, loads.moments[number]) if holds else [math.nan] * len(Seats._fields)
        for number, holds in enumerate(seated(joint))
    ]
    return Seats(*(xp.stack(xp.broadcast_arrays(*map(xp.asarray, row))) for row in zip(*rows, strict=True)))


def _seat(joint: Joint, number: int, torque: Array) -> list[Real]:
    """The numbers of :class:`Seats` for one ring."""
    housing, ring, _, radius = _parts(joint, number)
    cold, warm = (ring_fit(joint, number, working=working) for working in (False, True))
    friction = 2.0 * math.pi * housing.friction_coefficient * radius * sum(track_lengths(joint, number))
    rises = [
        math.nan if expansion is None else 0.5 * housing.interference / (expansion * radius)
        for expansion in (housing.material.thermal_expansion, ring.thermal_expansion)
    ]
    mises = [
        mises_stress(
            first=fit.housing_hoop,
            second=-fit.pressure,
            shear=0.0,
            poisson_ratio=housing.material.poisson_ratio,
            plane_state="plane_stress",
        )
        for fit in (cold, warm)
    ]
    return [
        friction * cold.pressure,
        *rises,
        cold.bore_change,
        friction * warm.pressure * radius,
        friction * warm.pressure * radius / abs(torque),
        warm.housing_hoop,
        housing.material.yield_strength / xp.maximum(*mises),
    ]

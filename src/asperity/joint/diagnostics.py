"""Limits of the model as data: each with its value, the limit, and what crossing it means."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from asperity.contact.hertz_line import first_yield_pressure, peak_pressure
from asperity.contact.roller_pairs import RollerPairs
from asperity.drive.capacity import slip_ratio
from asperity.drive.force_balance import BALANCE_TOLERANCE, DriveForces
from asperity.drive.geometry import CONTACT_NAMES, Triangle
from asperity.joint.contacts import LoadedContacts
from asperity.types import Real

if TYPE_CHECKING:
    from asperity.joint.evaluation import JointResult


class Diagnostics(eqx.Module):
    """How close a joint is to the limits of its model; every value is fine below 1 unless said otherwise.

    Parameters
    ----------
    gross_slip : Real
        T/(mu N) of each contact, shape (5, ...) [-]; infinite where a lifted contact should carry a force.
    self_locking : Real
        tan(beta/2)/mu of the planet's wedge contacts, the larger of both sides, shape (...) [-].
    real_area_over_hertz_area : Real
        Real area of contact over the Hertzian strip 2bB, shape (5, ...) [-].
    largest_spot_over_hertz_area : Real
        Largest spot over the Hertzian strip, shape (5, ...) [-].
    critical_over_largest_spot : Real
        a_c/a_l, shape (5, ...) [-]; from 1 on every spot is plastic and the law has no stiffness.
    pressure_over_first_yield : Real
        Hertzian peak pressure over 1.67 times the yield strength of the weaker body, shape (5, ...) [-].
    asperity_over_bulk_stiffness : Real
        Tangential stiffness of the asperities over that of the bodies, shape (5, ...) [-]. The published model counts
        the asperities alone, which is fair where this is far below 1.
    normal_over_rest : Real
        Normal force over its value at rest, shape (5, ...) [-]; 0 means lifted off, fine above 0.
    hertz_half_width, hertz_peak_pressure : Real
        Half-width b [m] and peak pressure p_0 [Pa] of the smooth contact, shape (5, ...).
    """

    gross_slip: Real
    self_locking: Real
    real_area_over_hertz_area: Real
    largest_spot_over_hertz_area: Real
    critical_over_largest_spot: Real
    pressure_over_first_yield: Real
    asperity_over_bulk_stiffness: Real
    normal_over_rest: Real
    hertz_half_width: Real
    hertz_peak_pressure: Real


def diagnose(
    *,
    sides: Triangle,
    pairs: RollerPairs,
    forces: DriveForces,
    loaded: LoadedContacts,
    rest_force: Real,
) -> Diagnostics:
    """Compare a solved joint with the limits of the model.

    Parameters
    ----------
    sides : Triangle
        The drive's triangle of centres.
    pairs : RollerPairs
        Its contacts.
    forces : DriveForces
        Its forces.
    loaded : LoadedContacts
        Its contacts under these forces, shape (5, ...).
    rest_force : Real
        Normal forces at rest, shape (5, ...) [N].

    Returns
    -------
    Diagnostics
        Ratios of value over limit.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, sections 4.2 and 6.2; :doc:`/assumptions`.
    """
    contacts, interfaces = loaded.rough, loaded.interfaces
    touching = forces.normal > 0.0
    width = jnp.where(touching, loaded.half_width, 1.0)  # an open contact has no load either
    length, friction_coefficient = pairs.contact_length, pairs.friction_coefficient
    pressure = peak_pressure(
        normal_force=jnp.where(touching, forces.normal, 0.0), contact_length=length, half_width=width
    )
    sticks = interfaces.bulk_tangential > 0.0
    strip = 2.0 * width * length
    friction = jnp.broadcast_to(
        friction_coefficient, jnp.broadcast_shapes(jnp.shape(friction_coefficient), forces.normal.shape)
    )
    largest = jnp.where(touching, contacts.largest_area, 1.0)
    return Diagnostics(
        gross_slip=slip_ratio(
            normal_force=forces.normal,
            tangential_force=forces.tangential,
            friction_coefficient=friction_coefficient,
        ),
        self_locking=sides.sin_wedge / (1.0 + sides.cos_wedge) / jnp.minimum(friction[1], friction[2]),
        real_area_over_hertz_area=contacts.real_contact_area / strip,
        largest_spot_over_hertz_area=contacts.largest_area / strip,
        critical_over_largest_spot=jnp.where(touching, contacts.critical_area / largest, jnp.inf),
        pressure_over_first_yield=pressure / first_yield_pressure(yield_strength=pairs.moduli.yield_strength),
        asperity_over_bulk_stiffness=jnp.where(
            sticks,
            interfaces.asperity_tangential / jnp.where(sticks, interfaces.bulk_tangential, 1.0),
            jnp.nan,
        ),
        normal_over_rest=forces.normal / rest_force,
        hertz_half_width=loaded.half_width,
        hertz_peak_pressure=pressure,
    )


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One limit of the model, told for one contact or for the whole drive.

    Parameters
    ----------
    name : str
        What is compared; the name of a field of :class:`Diagnostics` where it comes from there.
    contact : str or None
        Which contact; None for the whole drive.
    value, limit : float
        The value and the limit it is compared with.
    ok : bool
        Whether the value is on the good side of its limit; never where it is nan.
    meaning : str
        What it means that the limit is kept or crossed.
    """

    name: str
    contact: str | None
    value: float
    limit: float
    ok: bool
    meaning: str


class _Rule(NamedTuple):
    """How a field of :class:`Diagnostics` is judged, and what it means to be on either side of the limit."""

    name: str
    limit: float
    good: str
    bad: str
    fine_above: bool = False


_RULES = (
    _Rule(
        "gross_slip",
        1.0,
        "the tangential force is below what friction holds",
        "the contact slips grossly: it has no tangential stiffness",
    ),
    _Rule(
        "self_locking",
        1.0,
        "the wedge holds itself by friction",
        "the friction coefficient is below tan(beta/2): the wedge does not hold itself by friction, and the carrier "
        "pins have to keep the loading rollers in it. Make sure that they can (see the pin forces), or raise the "
        "friction coefficient above tan(beta/2), or choose radii with a smaller wedge angle",
    ),
    _Rule(
        "real_area_over_hertz_area",
        1.0,
        "the real area of contact is part of the Hertzian strip",
        "the real area of contact exceeds the whole Hertzian strip: the contact law is used beyond its validity",
    ),
    _Rule(
        "largest_spot_over_hertz_area",
        1.0,
        "the largest spot is part of the Hertzian strip",
        "one spot exceeds the whole Hertzian strip: the contact law is used beyond its validity",
    ),
    _Rule(
        "critical_over_largest_spot",
        1.0,
        "some spots are elastic",
        "every spot is plastic, where the contact law has no stiffness and fails: real surfaces keep one",
    ),
    _Rule(
        "pressure_over_first_yield",
        1.0,
        "the bodies stay elastic under the contact",
        "the Hertzian pressure exceeds first yield, 1.67 times the yield strength: the bodies deform plastically",
    ),
    _Rule(
        "asperity_over_bulk_stiffness",
        0.1,
        "the asperities are at least ten times softer than the bodies under them",
        "the bodies are not much stiffer than the asperities: the published stiffness, which leaves the bodies out, is "
        "only an upper bound",
    ),
    _Rule("normal_over_rest", 0.0, "the contact is loaded", "the contact has lifted off", fine_above=True),
)


def listing(result: JointResult) -> tuple[Diagnostic, ...]:
    """Every diagnostic of one solved joint, contact by contact, with its meaning in words.

    Parameters
    ----------
    result : JointResult
        Result of one joint, without batch axes.

    Returns
    -------
    tuple of Diagnostic
        Those of :class:`Diagnostics` that have a limit, then the residuals of the force balance.
    """
    entries = [
        entry
        for rule in _RULES
        for contact, value in _by_contact(getattr(result.diagnostics, rule.name))
        for entry in [_judged(rule, contact, value)]
    ]
    residuals = (
        ("balance_residual", "equations (1) to (5)", result.forces.balance_residual),
        ("closure_residual", "the closure (A3)", result.forces.closure_residual),
    )
    for name, equations, residual in residuals:
        value = float(residual)
        ok = value < BALANCE_TOLERANCE
        meaning = (
            f"residual of {equations}, relative to the largest force: {'solved' if ok else 'not solved'}"
        )
        entries.append(Diagnostic(name, None, value, BALANCE_TOLERANCE, ok, meaning))
    return tuple(entries)


def _by_contact(values: Real) -> list[tuple[str | None, float]]:
    numbers = np.asarray(values)
    if numbers.ndim == 0:
        return [(None, float(numbers))]
    return [(name, float(number)) for name, number in zip(CONTACT_NAMES, numbers, strict=True)]


def _judged(rule: _Rule, contact: str | None, value: float) -> Diagnostic:
    if math.isnan(value):
        told = "undefined here: the contact slips or has lifted off"
        return Diagnostic(rule.name, contact, value, rule.limit, False, told)
    ok = value > rule.limit if rule.fine_above else value < rule.limit
    return Diagnostic(rule.name, contact, value, rule.limit, ok, rule.good if ok else rule.bad)

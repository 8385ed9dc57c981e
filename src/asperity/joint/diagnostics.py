"""How close a solved joint is to the limits of its model; :mod:`asperity.results` says what crossing means."""

from __future__ import annotations

from asperity.contact.crowned_line import CrownedLine
from asperity.contact.hertz_line import first_yield_pressure, peak_pressure
from asperity.contact.roller_pairs import RollerPairs
from asperity.drive.state.first_limit import slip_ratio as traction_used
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.joint.contacts import LoadedContacts
from asperity.types import Array, Real


class Diagnostics(Module):
    """How close a joint is to the limits of its model; every value is fine below 1 unless said otherwise.

    Parameters
    ----------
    slip_ratio : Real
        T/(mu N) of each contact, shape (contacts, ...) [-]; infinite where a lifted contact should carry a force.
    real_area_over_hertz_area : Real
        Real area of contact over the Hertzian strip 2bB, shape (contacts, ...) [-].
    largest_spot_over_hertz_area : Real
        Largest spot over the Hertzian strip, shape (contacts, ...) [-].
    critical_over_largest_spot : Real
        a_c/a_l, shape (contacts, ...) [-]; from 1 on every spot is plastic and the law has no stiffness.
    pressure_over_first_yield : Real
        Hertzian peak pressure over 1.67 times the yield strength of the weaker body, shape (contacts, ...) [-].
    asperity_over_bulk_stiffness : Real
        Tangential stiffness of the asperities over that of the bodies, shape (contacts, ...) [-]. The published model
        counts the asperities alone, which is fair where this is far below 1.
    normal_force_over_preload : Real
        Normal force over its value at rest, shape (contacts, ...) [-]; 0 means lifted off, fine above 0.
    hertz_half_width, hertz_pressure : Real
        Half-width b [m] and peak pressure p_0 [Pa] of the smooth contact where it is widest, shape (contacts, ...).
    loaded_length_share : Real or None
        Share of the contact length that is loaded, shape (contacts, ...) [-]; None where no roller is crowned.
    peak_line_load_ratio, end_line_load_ratio : Real or None
        Line load in the middle, and that at the ends, over the mean line load, shape (contacts, ...) [-].
    loaded_length_over_width : Real or None
        Loaded length over the largest width, shape (contacts, ...) [-].
    slices_hold : Array or None
        Whether the contact is long enough for the law of its slices, shape (contacts, ...).
    """

    slip_ratio: Real
    real_area_over_hertz_area: Real
    largest_spot_over_hertz_area: Real
    critical_over_largest_spot: Real
    pressure_over_first_yield: Real
    asperity_over_bulk_stiffness: Real
    normal_force_over_preload: Real
    hertz_half_width: Real
    hertz_pressure: Real
    loaded_length_share: Real | None = None
    peak_line_load_ratio: Real | None = None
    end_line_load_ratio: Real | None = None
    loaded_length_over_width: Real | None = None
    slices_hold: Array | None = None


def diagnose(
    *,
    pairs: RollerPairs,
    normal_force: Array,
    tangential_force: Array,
    loaded: LoadedContacts,
    rest_force: Real,
) -> Diagnostics:
    """Ratios of value over limit of the model for a solved joint, from its forces, shape (contacts, ...) [N].

    References ---------- K. L. Johnson, Contact Mechanics, 1985, sections 4.2 and 6.2; :doc:`/assumptions`.
    """
    contacts, interfaces = loaded.rough, loaded.interfaces
    touching = normal_force > 0.0
    width = xp.where(touching, loaded.half_width, 1.0)  # an open contact has no load either
    length, friction_coefficient = pairs.contact_length, pairs.friction_coefficient
    load = xp.where(touching, normal_force, 0.0)
    along: dict[str, Array] = {}
    strip = 2.0 * width * length
    if loaded.lines is not None:
        along = _along_the_line(loaded.lines, pairs, normal_force)
        share = loaded.lines.length_share
        strip = 2.0 * length * xp.sum(share * loaded.lines.half_width, axis=0)
        width = xp.where(touching, loaded.lines.half_width[0], 1.0)
        load = xp.where(touching, loaded.lines.line_load[0] * length, 0.0)
    pressure = peak_pressure(normal_force=load, contact_length=length, half_width=width)
    compared = (interfaces.bulk_tangential > 0.0) & (interfaces.asperity_normal > 0.0)
    largest = xp.where(touching, contacts.largest_area, 1.0)
    return Diagnostics(
        slip_ratio=traction_used(
            normal_force=normal_force,
            tangential_force=tangential_force,
            friction_coefficient=friction_coefficient,
        ),
        real_area_over_hertz_area=contacts.real_contact_area / strip,
        largest_spot_over_hertz_area=contacts.largest_area / (2.0 * width * length),
        critical_over_largest_spot=xp.where(touching, contacts.critical_area / largest, xp.inf),
        pressure_over_first_yield=pressure / first_yield_pressure(yield_strength=pairs.moduli.yield_strength),
        asperity_over_bulk_stiffness=xp.where(
            compared,
            interfaces.asperity_tangential / xp.where(compared, interfaces.bulk_tangential, 1.0),
            xp.nan,
        ),
        normal_force_over_preload=normal_force / rest_force,
        hertz_half_width=loaded.half_width if loaded.lines is None else xp.where(touching, width, 0.0),
        hertz_pressure=pressure,
        **along,
    )


def _along_the_line(lines: CrownedLine, pairs: RollerPairs, normal_force: Array) -> dict[str, Array]:
    """How the loads of crowned contacts spread; nan where a contact is open."""
    touching = normal_force > 0.0
    mean = xp.where(touching, normal_force, 1.0) / pairs.contact_length
    length = lines.loaded_share * pairs.contact_length
    spread = {
        "loaded_length_share": lines.loaded_share,
        "peak_line_load_ratio": lines.line_load[0] / mean,
        "end_line_load_ratio": lines.end_line_load / mean,
        "loaded_length_over_width": 0.5 * length / lines.half_width[0],
    }
    shaped = {name: xp.where(touching, value, xp.nan) for name, value in spread.items()}
    return shaped | {"slices_hold": lines.solved | ~touching}

"""Every scalar that the solver gives, by name, with its unit: what a study can be asked for."""

from __future__ import annotations

import difflib
import functools
import operator
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal

import jax.numpy as jnp
from jax import Array

from asperity.drive.geometry import CONTACT_NAMES
from asperity.errors import InputError
from asperity.joint.capacity import LIMIT_KINDS, TorqueCapacity, torque_capacity
from asperity.joint.evaluation import Joint, JointResult

Needs = Literal["geometry", "balance", "operation"]


class Solved:
    """A solved joint, with what is worth computing only when it is asked for.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.
    result : JointResult
        What :func:`asperity.joint.evaluation.evaluate` says about it.
    """

    def __init__(self, joint: Joint, result: JointResult) -> None:
        self.joint, self.result = joint, result

    @functools.cached_property
    def capacity(self) -> TorqueCapacity:
        """Torque capacity of positive torques, and what limits it."""
        return torque_capacity(self.joint, direction=1.0)

    @functools.cached_property
    def reverse_capacity(self) -> TorqueCapacity:
        """Torque capacity of negative torques, and what limits it."""
        return torque_capacity(self.joint, direction=-1.0)


@dataclass(frozen=True)
class Result:
    """One result of the solver.

    Parameters
    ----------
    name : str
        Its name in datasets.
    group : str
        The group it can be asked for with.
    unit : str
        SI unit; ``"1"`` for a ratio.
    description : str
        What it is, for ``long_name``.
    per_contact : bool
        Whether there is one for each of the five contacts.
    needs : {"geometry", "balance", "operation"}
        What must hold for it to mean anything: that the rollers fit; that in addition the forces balance; that in
        addition no contact slips. Where that fails the result is nan.
    path : str
        Where it is in a :class:`Solved` joint.
    """

    name: str
    group: str
    unit: str
    description: str
    per_contact: bool
    needs: Needs
    path: str

    def value(self, solved: Solved) -> Array:
        """Its value, with the contact axis first if there is one."""
        found: Any = operator.attrgetter(self.path)(solved)
        return jnp.asarray(found, dtype=float)


def _table() -> dict[str, Result]:
    found: dict[str, Result] = {}

    def add(
        group: str,
        rows: str,
        *,
        contact: bool = False,
        needs: Needs = "operation",
    ) -> None:
        for row in rows.strip().splitlines():
            name, path, unit, description = (part.strip() for part in row.split("|"))
            found[name] = Result(name, group, unit, description, contact, needs, f"result.{path}")

    add(
        "assembly",
        """
        assembly_stiffness_output         | assembly.stiffness.output | N*m/rad | torsional stiffness at the output, assembly with floating bodies
        assembly_stiffness_sun            | assembly.stiffness.sun    | N*m/rad | torsional stiffness at the sun, assembly with floating bodies
        """,  # noqa: E501
    )
    add(
        "series",
        """
        series_with_bulk_stiffness_output | series_with_bulk.output   | N*m/rad | torsional stiffness at the output, asperities and bulk in series
        series_with_bulk_stiffness_sun    | series_with_bulk.sun      | N*m/rad | torsional stiffness at the sun, asperities and bulk in series
        """,  # noqa: E501
    )
    add(
        "published",
        """
        published_stiffness_output        | published.output          | N*m/rad | torsional stiffness at the output as published (asperities alone, an upper bound)
        published_stiffness_sun           | published.sun             | N*m/rad | torsional stiffness at the sun as published (asperities alone, an upper bound)
        """,  # noqa: E501
    )
    add(
        "assembly",
        """
        tangential_share | assembly.tangential_share | 1 | share of the contact's tangential spring in the compliance of the assembly
        normal_share     | assembly.normal_share     | 1 | share of the contact's normal spring (planet float) in the compliance of the assembly
        """,  # noqa: E501
        contact=True,
    )
    add(
        "assembly",
        """
        ring_bending_share   | assembly.ring_bending_share   | 1 | share of the ring's bending in the compliance of the assembly
        pin_share            | assembly.pin_share            | 1 | share of the carrier pins in the compliance of the assembly
        planet_support_share | assembly.planet_support_share | 1 | share of the planet supports in the compliance of the assembly
        input_shaft_share    | assembly.input_shaft_share    | 1 | share of the input shaft in the compliance of the assembly
        output_shaft_share   | assembly.output_shaft_share   | 1 | share of the output shaft in the compliance of the assembly
        """,  # noqa: E501
    )
    add(
        "forces",
        """
        normal_force     | forces.normal     | N | normal force of the contact
        tangential_force | forces.tangential | N | tangential force of the contact
        """,
        contact=True,
    )
    add(
        "forces",
        """
        left_pin_force      | forces.pin_left            | N   | force of the carrier pin on the left loading roller
        right_pin_force     | forces.pin_right           | N   | force of the carrier pin on the right loading roller
        input_torque        | forces.input_torque        | N*m | torque at the sun
        left_bearing_torque | forces.left_bearing_torque | N*m | friction torque of one bearing of the left loading roller
        right_bearing_torque | forces.right_bearing_torque | N*m | friction torque of one bearing of the right loading roller
        """,  # noqa: E501
    )
    add(
        "contacts",
        """
        asperity_tangential_stiffness | interfaces.asperity_tangential    | N/m     | tangential stiffness of the contact's asperities
        asperity_normal_stiffness     | interfaces.asperity_normal        | N/m     | normal stiffness of the contact's asperities
        bulk_tangential_stiffness     | interfaces.bulk_tangential        | N/m     | tangential stiffness of the contact's bodies
        bulk_normal_stiffness         | interfaces.bulk_normal            | N/m     | normal stiffness of the contact's bodies
        contact_torsional_stiffness   | contact_torsional_stiffness       | N*m/rad | torsional stiffness of the contact's asperities at its driven roller
        largest_area                  | contacts.largest_area             | m^2     | largest contact spot
        critical_area                 | contacts.critical_area            | m^2     | critical contact spot
        real_contact_area             | contacts.real_contact_area        | m^2     | real area of contact
        elastic_load                  | contacts.elastic_load             | N       | load carried by elastic spots
        plastic_load                  | contacts.plastic_load             | N       | load carried by plastic spots
        domain_extension_factor       | contacts.domain_extension_factor  | 1       | domain extension factor psi
        contact_factor                | contacts.contact_factor           | 1       | contact factor lambda
        """,  # noqa: E501
        contact=True,
    )
    diagnostics = """
        real_area_over_hertz_area    | diagnostics.real_area_over_hertz_area    | 1 | real area over the Hertzian strip
        largest_spot_over_hertz_area | diagnostics.largest_spot_over_hertz_area | 1 | largest spot over the Hertzian strip
        critical_over_largest_spot   | diagnostics.critical_over_largest_spot   | 1 | critical over largest spot; from 1 on every spot is plastic
        pressure_over_first_yield    | diagnostics.pressure_over_first_yield    | 1 | Hertzian peak pressure over first yield
        asperity_over_bulk_stiffness | diagnostics.asperity_over_bulk_stiffness | 1 | tangential stiffness of asperities over that of the bodies
        normal_over_rest             | diagnostics.normal_over_rest             | 1 | normal force over its value at rest
        hertz_half_width             | diagnostics.hertz_half_width             | m | half-width of the smooth contact
        hertz_peak_pressure          | diagnostics.hertz_peak_pressure          | Pa | Hertzian peak pressure
        """  # noqa: E501
    add("diagnostics", diagnostics, contact=True)
    slip = "gross_slip | diagnostics.gross_slip | 1 | traction used over available, T/(mu N); slips from 1 on"
    add("diagnostics", slip, contact=True, needs="balance")
    lock = "self_locking | diagnostics.self_locking | 1 | tan(beta/2)/mu; the wedge holds itself below 1"
    add("diagnostics", lock, needs="geometry")
    add(
        "geometry",
        """
        polar_angle         | angles.polar        | rad   | polar angle alpha of a loading roller from its planet
        direction_angle     | angles.direction    | rad   | direction theta from planet to loading roller
        wedge_angle         | angles.wedge        | rad   | wedge angle beta
        speed_ratio         | speed_ratio         | 1     | speed of the sun over that of the carrier
        carrier_speed       | carrier_speed       | rad/s | angular velocity of the carrier
        planet_mass         | planet_mass         | kg    | mass of one planet
        loading_roller_mass | loading_roller_mass | kg    | mass of one loading roller
        """,
        needs="geometry",
    )
    residuals = """
        balance_residual | forces.balance_residual | 1 | largest relative residual of the force balance
        closure_residual | forces.closure_residual | 1 | relative residual of the closure
        """
    add("residuals", residuals, needs="geometry")
    limits = ", ".join(f"{code} {kind}" for code, kind in enumerate(LIMIT_KINDS))
    contacts = ", ".join(CONTACT_NAMES)
    for prefix, words in (("", "positive"), ("reverse_", "negative")):
        for name, path, unit, description in (
            (
                "torque_capacity",
                "output_torque",
                "N*m",
                f"largest {words} output torque before the first limit",
            ),
            ("capacity_limit", "limit", "1", f"first limit of {words} output torques: {limits}"),
            (
                "limiting_contact",
                "limiting_contact",
                "1",
                f"contact that limits {words} output torques, in the order {contacts}; -1 for none",
            ),
        ):
            found[f"{prefix}{name}"] = Result(
                f"{prefix}{name}",
                "capacity",
                unit,
                description,
                False,
                "geometry",
                f"{prefix}capacity.{path}",
            )
    return found


#: Every result by name, grouped.
RESULTS: dict[str, Result] = _table()

_OWN_GROUPS = {
    group: tuple(name for name, result in RESULTS.items() if result.group == group)
    for group in dict.fromkeys(result.group for result in RESULTS.values())
}

#: Groups of results that can be asked for by one word.
GROUPS: dict[str, tuple[str, ...]] = {
    "all": tuple(RESULTS),
    "stiffness": tuple(name for name in RESULTS if name.endswith(("_stiffness_output", "_stiffness_sun"))),
    **_OWN_GROUPS,
}


def chosen_results(names: Iterable[str]) -> tuple[str, ...]:
    """Names of single results from names of results and groups.

    Parameters
    ----------
    names : iterable of str
        Results, or the groups of :data:`GROUPS`: ``all``, ``stiffness``, ``assembly``, ``series``,
        ``published``, ``forces``, ``contacts``, ``diagnostics``, ``geometry``, ``residuals``, ``capacity``.

    Returns
    -------
    tuple of str
        Names of :data:`RESULTS`, each once.

    Raises
    ------
    InputError
        If a name is neither, or nothing is asked for.
    """
    wanted: dict[str, None] = {}
    for name in names:
        if name not in GROUPS and name not in RESULTS:
            near = difflib.get_close_matches(name, [*GROUPS, *RESULTS], n=1, cutoff=0.5)
            hint = f"; did you mean '{near[0]}'?" if near else ""
            raise InputError(f"there is no result '{name}'{hint} (groups: {', '.join(GROUPS)})")
        wanted.update(dict.fromkeys(GROUPS.get(name, (name,))))
    if not wanted:
        raise InputError(f"no results are asked for; choose among {', '.join(GROUPS)}")
    return tuple(wanted)


def result_values(names: tuple[str, ...], joint: Joint, result: JointResult) -> dict[str, Array]:
    """The chosen results of a solved joint; the rest costs nothing, because the compiler drops it.

    Parameters
    ----------
    names : tuple of str
        Names of :data:`RESULTS`.
    joint : Joint
        One joint, or many along trailing batch axes.
    result : JointResult
        What :func:`asperity.joint.evaluation.evaluate` says about it.

    Returns
    -------
    dict
        Name → float array of shape (...) or (5, ...).
    """
    solved = Solved(joint, result)
    return {name: RESULTS[name].value(solved) for name in names}

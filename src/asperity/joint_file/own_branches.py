"""The joint of a file with the sizes of its own branches, for whatever takes a joint."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

from asperity.drive.layout.drive import Drive
from asperity.engine.arrays import xp
from asperity.implicit import SETTLED
from asperity.joint.unfolding import SectorSizes, settled_sectors, unfolded_joint
from asperity.joint_file.build import (
    added_by_branches,
    deviations_of,
    joint_at_temperatures,
    joint_from_case,
    joint_from_values,
)
from asperity.joint_file.heat import at_one_temperature, with_steady_temperatures
from asperity.joint_file.si_tables import AnyCase, Values, si_values

if TYPE_CHECKING:
    from asperity.branches.branches import AssembledBranches
    from asperity.joint.description import Joint


def with_own_branches(case: AnyCase) -> Joint:
    """The joint of a file with its own branches, where they differ; equation (I4) of :doc:`/equations`.

    With sections ``[[branch]]`` it has every branch by itself, contacts and rollers with its number behind their names;
    otherwise it has equal branches. Raised are an ``InputError`` if the bodies do not fit or the branches cannot be
    compared, and a ``NoSolutionError`` if no balance without torque was found.
    """
    branches = branches_of(case)
    return joint_from_case(case) if branches is None else branches.joint


def branches_of(case: AnyCase) -> AssembledBranches | None:
    """The own branches of a joint file, without torque; None where it has no sections ``[[branch]]``."""
    if case.branch is None:
        return None
    from asperity.branches.branches import assembled_branches

    values = si_values(case)
    return assembled_branches(joint_at_temperatures(_settled(values)), deviations_of(values))


def joint_with_branches(values: Values) -> Joint:
    """The joint of a joint file, every branch by itself where it has sections ``[[branch]]``; pure; equation (I4).

    Tables in SI units, whose numbers may be traced; as :func:`with_own_branches`. A joint whose branches do not settle
    has nan for the forces of its laws, and so no state.
    """
    if "branch" not in values:
        return joint_from_values(values)
    return _at_temperatures(_settled(values))


def at_steady_temperature(values: Values) -> Values:
    """The tables with the temperatures at which the drive settles in place of what cools it, so that they may vary."""
    return at_one_temperature(values, joint_at_temperatures if "branch" not in values else _at_temperatures)


def _settled(values: Values) -> Values:
    """The tables with the temperatures at which a drive settles that every branch warms by its own losses."""
    return with_steady_temperatures(values, _at_temperatures)


def _at_temperatures(values: Values) -> Joint:
    """As :func:`joint_with_branches`, at temperatures that are known."""
    joint, sizes, sectors, floating = _sectors(values)
    settled = settled_sectors(sectors, floating, joint, sizes)
    force = xp.where(settled.change < SETTLED, settled.sizes.reference_force, xp.nan)
    sizes = dataclasses.replace(settled.sizes, reference_force=force)
    full_joint = unfolded_joint(joint, sizes, sectors=sectors, floating=floating)
    return dataclasses.replace(
        full_joint, rolling=dataclasses.replace(full_joint.rolling, duty=joint.rolling.duty)
    )


def parts_with_branches(values: Values) -> Joint:
    """The same joint without the forces of its laws, before it warms: bodies, contacts and bearings; pure."""
    if "branch" not in values:
        return joint_at_temperatures(values)
    joint, sizes, sectors, floating = _sectors(values)
    return unfolded_joint(joint, sizes, sectors=sectors, floating=floating)


def _sectors(values: Values) -> tuple[Joint, SectorSizes, int, tuple[str, ...]]:
    """A joint with equal branches, what differs between them, their number, and what floats on the axis."""
    joint, count = joint_at_temperatures(values), len(values["branch"])
    added = added_by_branches(values, count)
    support = xp.asarray(values.get("compliance", {}).get("sun_support_stiffness", 0.0), dtype=float)
    sizes = SectorSizes(added, xp.zeros_like(added), support)
    return joint, sizes, count, floating_of(values, joint.drive)


def floating_of(values: Values, drive: Drive) -> tuple[str, ...]:
    """The input where its bearings give way."""
    return (drive.input,) if "sun_support_stiffness" in values.get("compliance", {}) else ()

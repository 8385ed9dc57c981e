"""Requirements that the worst of unequal branches has to meet, and what of a joint holds for equal branches only."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from asperity.branches.results import BranchCapacity, BranchState, UnequalBranches
from asperity.errors import InputError, NoSolutionError
from asperity.results import RESULTS, Limit, Result
from asperity.results.limit_check import LimitCheck
from asperity.unit_table import Dimension
from asperity.units import format_quantity

_EVEN = 1e-9  # relative difference of preloads up to which branches are alike


def branch_checks(branches: UnequalBranches, *, turns: bool) -> tuple[LimitCheck, ...]:
    """What unequal branches have to meet, each where it is met worst."""
    checks = [
        _slip(branches, branches.capacity, branches.standing, "standing"),
        _looseness(branches),
        _worst(branches, "pressure_over_first_yield", branches.standing or branches.rest),
    ]
    if turns:
        checks.insert(1, _slip(branches, branches.rolling_capacity, branches.rolling, "in rolling"))
    if turns or branches.rolling is not None:  # a joint that stands is judged as if it rolled slowly
        checks.append(_worst(branches, "shakedown_ratio", branches.rolling))
    return tuple(checks)


def _slip(
    branches: UnequalBranches, capacity: BranchCapacity, state: BranchState | None, when: str
) -> LimitCheck:
    """The torque over that at which the first branch slips."""
    slips = format_quantity(capacity.first_slip, "N*m", 4)
    where = f"{branches.noun} {capacity.branch + 1}"
    first = f"contact {capacity.contact_name} of {where} {capacity.event} first, at {slips}"
    reached = "slips" if capacity.event == "slips" else "reaches its limit"
    if state is None:
        last = capacity.all_slip
        used = "steady rolling ends there"
        if math.isfinite(last):
            used = f"all branches slip at {format_quantity(last, 'N*m', 4)}"
    else:
        slipping = ", ".join(str(index + 1) for index in np.flatnonzero(state.slip_ratio >= 1.0))
        used = f"under the torque T/(mu N) of the worst branch is {np.nanmax(state.slip_ratio):.3g}"
        used += f" ({branches.noun}s that slip: {slipping})" if slipping else ""
    name = "branch_slip" if when == "standing" else "branch_slip_in_rolling"
    row = Result(
        name,
        f"torque over first slip of a branch, {when}",
        Dimension.DIMENSIONLESS,
        "1",
        name,
        limit=Limit(
            "function",
            f"no branch {reached} under the torque: {first}; {used}",
            f"a branch {reached} under the torque: {first}; {used}; "
            f"equal branches pass {format_quantity(capacity.equal, 'N*m', 4)}",
            "tighten the sizes of the rollers, let the sun float (compliance.sun_support_stiffness), raise the "
            "interference, or lower the torque",
            highest=1.0,
        ),
    )
    return LimitCheck(
        row, f"{branches.noun} {capacity.branch + 1}", _over(branches.torque, capacity.first_slip)
    )


def _over(torque: float, limit: float) -> float:
    """A torque over its limit; infinite where the friction of the bearings alone makes a contact slip [-]."""
    return torque / limit if limit else math.inf


def _looseness(branches: UnequalBranches) -> LimitCheck:
    """The preload of the loosest branch over that of equal ones."""
    name = "branch_preload"
    row = Result(
        name,
        "preload of a branch over that of equal ones",
        Dimension.DIMENSIONLESS,
        "1",
        name,
        limit=Limit(
            "function",
            "every branch has an interference",
            "a branch is loose and passes no torque: the others pass its share",
            "tighten the sizes of the rollers, or raise the interference",
            lowest=0.0,
        ),
    )
    branch = int(np.argmin(branches.preload))
    return LimitCheck(
        row, f"{branches.noun} {branch + 1}", float(branches.preload[branch]) / branches.own_preload
    )


def _worst(branches: UnequalBranches, name: str, state: BranchState | None) -> LimitCheck:
    """A limit of the contacts at the contact and branch where it is nearest or crossed most."""
    known = RESULTS[name]
    row = dataclasses.replace(known, name=f"branch_{name}", label=f"{known.label}, worst branch")
    values = np.array([]) if state is None else state.limits.get(name, np.array([]))
    if not np.any(np.isfinite(values)):
        return LimitCheck(row, None, math.nan)
    contact, branch = np.unravel_index(int(np.nanargmax(values)), values.shape)
    place = f"{branches.contact_names[int(contact)]} of {branches.noun} {int(branch) + 1}"
    return LimitCheck(row, place, float(values[contact, branch]))


def pressed(branches: UnequalBranches) -> str:
    """How much harder the most loaded branch is pressed than equal ones, in words."""
    branch = int(np.argmax(branches.preload))
    if np.ptp(branches.preload) <= _EVEN * branches.preload[branch]:
        return f"every {branches.noun} is pressed {branches.preload[branch] / branches.own_preload:.3g} times as hard"
    loose = ", ".join(str(index + 1) for index in np.flatnonzero(branches.preload <= 0.0))
    return (
        f"{branches.noun} {branch + 1} is pressed {branches.preload[branch] / branches.own_preload:.3g} times as hard"
        + (f", and loose is {branches.noun} {loose}" if loose else "")
    )


def refuse_beyond(branches: UnequalBranches, output_torque: float) -> None:
    """Refuse a torque that the branches do not carry together."""
    most = branches.capacity.all_slip
    if abs(output_torque) > most:
        raise InputError(
            f"the output torque {format_quantity(output_torque, 'N*m')} is beyond what the branches carry together, "
            f"{format_quantity(most, 'N*m')}: all of them slip; lower the torque, state smaller deviations in "
            "[[branch]], or raise load.interference"
        )


def refuse_no_rolling_together(branches: UnequalBranches) -> None:
    """Refuse branches that do not roll steadily under the joint's torque."""
    refused = no_rolling_together(branches)
    if refused:
        raise NoSolutionError(refused)


def no_rolling_together(branches: UnequalBranches) -> str:
    """Why branches do not roll steadily under the joint's torque."""
    if branches.rolling is not None:
        return ""
    capacity = branches.rolling_capacity
    return (
        f"no steady rolling under {format_quantity(branches.torque, 'N*m')}: the branches of the file, [[branch]], "
        f"roll up to {format_quantity(capacity.first_slip, 'N*m')}, at which contact {capacity.contact_name} of "
        f"{branches.noun} {capacity.branch + 1} {capacity.event}; lower the torque, state smaller deviations, or raise "
        "load.interference"
    )


def equal_branches_note(branches: UnequalBranches) -> str:
    """What of a joint is that of equal branches, and by how much the most loaded branch differs."""
    what = "Forces, pressures, stiffness, drift, losses and lives of rollers outside the section on branches"
    note = f"{what} are those of equal branches; {pressed(branches)}."
    if branches.beyond_equal:
        note = (
            f"All numbers are those of these branches, contact by contact: equal ones carry "
            f"{format_quantity(branches.capacity.equal, 'N*m', 4)} at most; {pressed(branches)}."
        )
    life = least_life(branches)
    if math.isfinite(life):
        hours = f"{format_quantity(life, '1')} h"
        note += f" Were all loaded like the worst branch, the fatigue life under the torque would be {hours}."
    return note


def capacity_words(document: dict[str, Any], name: str) -> str:
    """Torque at which the worst branch slips or reaches another limit, as the first words about a capacity.

    Parameters
    ----------
    document : dict
        What :func:`asperity.results.branch_document.branch_document` says about the branches.
    name : str
        Which of its torque capacities.

    Returns
    -------
    str
        With the branch and its contact.
    """
    entry = document[name]
    return (
        f"{format_quantity(entry['first_slip_Nm'], 'N*m', 4)}: contact {entry['first_contact']} of "
        f"{document['branch_is']} {entry['first_branch']} {entry['first_event']} first"
    )


def least_life(branches: UnequalBranches) -> float:
    """Life of a drive all of whose branches are loaded like the one that lives shortest [h]."""
    return shortest_life(branches.rolling)


def shortest_life(state: BranchState | None) -> float:
    """Life of a drive all of whose branches are loaded like the one that lives shortest in a state [h]."""
    if state is None or "life_hours" not in state.limits:
        return math.nan
    lives = state.limits["life_hours"][state.preload > 0.0]
    return float(np.min(lives)) if lives.size else math.nan


def slipping_in_rolling(branches: UnequalBranches) -> str:
    """Which branches slip as a whole in rolling while others carry the rest."""
    if branches.rolling is None:
        return ""
    slips = [str(index + 1) for index in np.flatnonzero(branches.rolling.slip_ratio >= 1.0)]
    if not slips:
        return ""
    named = (
        f"{branches.noun} {slips[0]} slips"
        if len(slips) == 1
        else f"{branches.noun}s {', '.join(slips)} slip"
    )
    return (
        f"drift and losses are not known: in rolling under {format_quantity(branches.torque, 'N*m')} {named} as a "
        "whole while the others carry the rest"
    )

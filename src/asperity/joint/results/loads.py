"""Rows of the table of results: loads of pins, shafts, carrier and housing."""

from __future__ import annotations

import functools
from typing import Any

import jax.numpy as jnp

from asperity.drive.structure_loads import pin_bending_moment, pin_bending_stress
from asperity.joint.results.result import Result, SolvedJoint
from asperity.unit_table import Dimension

_load = functools.partial(Result, group="loads", wedge_only=True)
_FORCE, _TORQUE = Dimension.FORCE, Dimension.TORQUE
_STATE = "in rolling where the sun turns, standing under the torque where it stands"


def _bending_moment(solved: SolvedJoint) -> Any:
    joint, force = solved.joint, solved.loads.pin_resultant
    if joint.pin is None:
        return jnp.full_like(force, jnp.nan)
    return pin_bending_moment(
        force=force,
        free_length=joint.pin.free_length,
        roller_length=joint.loading_roller_length,
        support=joint.pin.support,
    )


def _bending_stress(solved: SolvedJoint) -> Any:
    return pin_bending_stress(moment=_bending_moment(solved), diameter=solved.joint.bearings.pin_diameter)


ROWS = (
    _load(
        "pin_load",
        "force of a loading roller on its pin",
        _FORCE,
        "N",
        lambda solved: solved.loads.pin_resultant,
        axis="pin",
        note=_STATE,
    ),
    _load(
        "pin_bending_moment",
        "bending moment of a pin",
        _TORQUE,
        "N*m",
        _bending_moment,
        axis="pin",
        note="nan without bearings.pin_length",
    ),
    _load(
        "pin_bending_stress",
        "bending stress of a pin",
        Dimension.PRESSURE,
        "MPa",
        _bending_stress,
        axis="pin",
        note="nan without bearings.pin_length and pin_diameter",
    ),
    _load(
        "carrier_torque",
        "torque of all pins on the carrier",
        _TORQUE,
        "N*m",
        "loads.carrier_torque",
        positive=False,
        note="output torque and friction of the carrier's bearings",
    ),
    _load(
        "housing_torque",
        "torque of the ring on its housing",
        _TORQUE,
        "N*m",
        "loads.housing_torque",
        positive=False,
        note=_STATE,
    ),
)

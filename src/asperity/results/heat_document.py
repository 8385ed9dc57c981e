"""The temperatures of a joint as a part of its JSON document, but what rows have."""

from __future__ import annotations

import math

import numpy as np

from asperity.joint.heat import duty_temperatures, steady_torque, time_constant
from asperity.results.places import in_order
from asperity.results.solved import SolvedJoint
from asperity.types import Document


def heat_document(solved: SolvedJoint) -> Document:
    """What cools a joint, the losses over its temperature, and its temperatures under its duty.

    The temperatures that rows have wait for them. Of a joint that has none also why, and the torque that still has one.
    """
    heat = solved.joint.heat
    assert heat is not None
    flow, duty = heat.flow, duty_temperatures(solved.joint)
    return {
        "ambient_degC": flow.ambient,
        "resistance_K_per_W": flow.resistance,
        "roller_resistance_K_per_W": flow.roller_resistance,
        "oil_limit_degC": flow.oil_limit,
        "steady": bool(heat.is_steady),
        "unsteady_because": heat.unsteady_because or None,
        **in_order("roller_temperature_degC housing_temperature_degC"),
        "loss_W": heat.loss,
        **in_order("gain ambient_reserve_K"),
        "time_constant_s": time_constant(solved.joint),
        "steady_torque_Nm": steady_torque_of(solved),
        "other_states": [
            {"roller_temperature_degC": at, "stable": stable} for at, stable in heat.other_states()
        ],
        "over_temperature": {
            "roller_temperature_degC": list(np.asarray(heat.temperatures)),
            "loss_W": list(np.asarray(heat.losses)),
        },
        "duty": None
        if duty is None
        else {
            "mean_degC": duty.mean,
            "peak_degC": duty.peak,
            "peak_beyond_oil_limit": math.isinf(duty.peak),
            "alone_degC": {str(number): at for number, at in enumerate(duty.alone, start=1)},
        },
        **in_order("cold_start"),
    }


def steady_torque_of(solved: SolvedJoint) -> float | None:
    """Of a joint without a steady temperature the largest torque that has one [N·m]; None for a steady one."""
    return solved.once(_steady_torque)


def _steady_torque(solved: SolvedJoint) -> float | None:
    joint = solved.joint
    if joint.heat is None or bool(joint.heat.is_steady):
        return None
    return steady_torque(joint, abs(float(joint.output_torque)))

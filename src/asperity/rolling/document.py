"""Words and sums about the joint that turns: losses by cause, and why numbers of it are absent."""

from __future__ import annotations

import numpy as np

from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.rolling.rolling import RollingResult
from asperity.types import Document


def losses(rolling: RollingResult) -> Document:
    """Losses by cause, all contacts together, and their sum ``total`` [W]; nan for a loss that the joint leaves out."""
    power = rolling.power
    by_contact = {
        name: np.sum(np.asarray(getattr(power, name))) for name in ("creep", "skew", "hysteresis", "oil")
    }
    return {**by_contact, "bearings": power.bearings, "total": power.loss}


def rating_life_name(reliability: float) -> str:
    """Name of the life that a share of the drives reaches [-]: L10 at 0.9, as in ISO 281."""
    return f"Rating life L{100.0 * (1.0 - reliability):.6g}"


def unknown_because(joint: Joint, result: JointResult) -> list[str]:
    """Why results of the rolling are absent, one sentence for each reason; empty if everything is there."""
    rolling, slip = result.rolling, np.asarray(result.diagnostics.slip_ratio)
    if not bool(np.isfinite(np.asarray(rolling.residual))):
        named = [name for name, ratio in zip(result.contact_names, slip, strict=True) if not ratio < 1.0]
        if named:
            verbs = "slips or has lifted off" if len(named) == 1 else "slip or have lifted off"
            return [f"no steady rolling: {', '.join(named)} {verbs}"]
        if not bool(result.contact_law_holds):
            return [
                "no creep: every spot of a contact is plastic, where the contact law gives it no stiffness"
            ]
        return [
            "no steady rolling: a contact slips or lifts off once the creepages share the torque among the contacts"
            + ("" if joint.rolling.skew is None else ", or skew alone makes it slip")
        ]
    reasons = absent_in_rolling(joint, result)
    if joint.rolling.duty and np.isnan(np.asarray(rolling.duty_life_hours)):
        reasons.append("no life under the duty: the joint does not roll under one of its loads")
    return reasons


def no_life_because(result: JointResult) -> str | None:
    """Why a joint that rolls has no rating life; None where it has one, or does not roll."""
    flowing = _named(result, result.rolling.shakedown_ratio)
    slipping = _named(result, result.rolling.slip_ratio)
    if slipping:
        verb = "slips" if len(slipping) == 1 else "slip"
        return f"no rating life: {', '.join(slipping)} {verb} as a whole; the fatigue law holds for rolling tracks only"
    if not flowing:
        return None
    return (
        f"no rating life: at {', '.join(flowing)} the Hertz pressure exceeds the shakedown limit, and the surface "
        "flows at every passage; the fatigue law holds for elastic tracks only"
    )


def _named(result: JointResult, ratios: object) -> list[str]:
    """The contacts at which a ratio has reached 1."""
    pairs = zip(result.contact_names, np.asarray(ratios), strict=True)
    return [name for name, ratio in pairs if ratio >= 1.0]


def absent_in_rolling(joint: Joint, result: JointResult) -> list[str]:
    """Why results of a joint are absent although it rolls steadily."""
    if float(np.asarray(joint.input_speed)) == 0.0:
        return [
            f"the {joint.ends[0]} stands: drift and life are per turn, for slow rolling; nothing is given per time, "
            "and there are no powers, efficiency, temperatures or oil film"
        ]
    if not bool(np.isfinite(np.asarray(result.rolling.power.efficiency))):
        return ["no efficiency: the output torque drives the rotation, but is smaller than the losses"]
    return []

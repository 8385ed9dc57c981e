"""Words and sums about the joint that turns: losses by cause, and why numbers of it are absent."""

from __future__ import annotations

import numpy as np

from asperity.contact.life_factor import LEAST_FILM_RATIO, LEAST_VISCOSITY_RATIO
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.rolling.inlet_heat import film_unknown_because
from asperity.rolling.rolling import RollingResult
from asperity.types import Document


def losses(rolling: RollingResult) -> Document:
    """Losses by cause, all contacts together, and their sum ``total`` [W]; nan for a loss that the joint leaves out."""
    power = rolling.power
    by_contact = {
        name: np.sum(np.asarray(getattr(power, name))) for name in ("creep", "skew", "hysteresis", "oil")
    }
    return {**by_contact, "bearings": power.bearings, "total": power.loss}


def rating_life_name(reliability: float, *, with_film: bool = False) -> str:
    """Name of the life that a share of the drives reaches [-]: L10 at 0.9, as in ISO 281, and L10m with a_ISO."""
    modified = "m, with the film factor a_ISO" if with_film else ""
    return f"Rating life L{100.0 * (1.0 - reliability):.6g}{modified}"


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
        no_film = film_unknown_because(result.contact_names, result.inlet_heat_factor)
        if no_film is not None:
            return [no_film]
        return [
            "no steady rolling: a contact slips or lifts off once the creepages share the torque among the contacts"
            + ("" if joint.rolling.skew is None else ", or skew alone makes it slip")
        ]
    reasons = absent_in_rolling(joint, result)
    if joint.rolling.duty and np.isnan(np.asarray(rolling.duty_life_hours)):
        because = no_duty_factor_because(joint, rolling) or "the joint does not roll under one of its loads"
        reasons.append(f"no life under the duty: {because}")
    return reasons


def no_duty_factor_because(joint: Joint, rolling: RollingResult) -> str | None:
    """Why the life under a duty has no factor for its oil films; None where it has it, or needs none."""
    if joint.rolling.cleanliness is None:
        return None
    thin = [str(k) for k, ratio in enumerate(np.asarray(rolling.duty_film_ratios), 1) if _too_thin(ratio)]
    return f"under load{'' if len(thin) == 1 else 's'} {', '.join(thin)} {_THIN}" if thin else None


#: What a film is that has no factor of the life.
_THIN = f"κ = λ^1.3 is below {LEAST_VISCOSITY_RATIO:g}; ISO 281 has no factor a_ISO for so thin an oil film"


def _too_thin(film_ratio: float) -> bool:
    """Whether a film is too thin for a factor of the life; not where it is not known."""
    return bool(film_ratio < LEAST_FILM_RATIO)


def no_life_because(joint: Joint, result: JointResult) -> str | None:
    """Why a joint that rolls has no rating life; None where it has one, or does not roll."""
    flowing = _named(result, result.rolling.shakedown_ratio)
    slipping = _named(result, result.rolling.slip_ratio)
    if slipping:
        verb = "slips" if len(slipping) == 1 else "slip"
        return f"no rating life: {', '.join(slipping)} {verb} as a whole; the fatigue law holds for rolling tracks only"
    if not flowing:
        because = no_factor_because(joint, result)
        return None if because is None else f"no rating life: {because}"
    return (
        f"no rating life: at {', '.join(flowing)} the Hertz pressure exceeds the shakedown limit, and the surface "
        "flows at every passage; the fatigue law holds for elastic tracks only"
    )


def no_factor_because(joint: Joint, result: JointResult) -> str | None:
    """Why lives that are to have a factor for their oil film have none; None where they have it, or need none."""
    if joint.rolling.cleanliness is None:
        return None
    if float(np.asarray(joint.input_speed)) == 0.0:
        return (
            f"the {joint.ends[0]} stands; without an oil film there is no factor a_ISO, which "
            "life.cleanliness asks for"
        )
    ratios = zip(result.contact_names, np.asarray(result.rolling.film_ratio), strict=True)
    thin = [name for name, ratio in ratios if _too_thin(ratio)]
    return f"at {', '.join(thin)} {_THIN}" if thin else None


def _named(result: JointResult, ratios: object) -> list[str]:
    """The contacts at which a ratio has reached 1."""
    pairs = zip(result.contact_names, np.asarray(ratios), strict=True)
    return [name for name, ratio in pairs if ratio >= 1.0]


def absent_in_rolling(joint: Joint, result: JointResult) -> list[str]:
    """Why results of a joint are absent although it rolls steadily."""
    if float(np.asarray(joint.input_speed)) == 0.0:
        slow = "drift and life are" if joint.rolling.cleanliness is None else "drift is"
        return [
            f"the {joint.ends[0]} stands: {slow} per turn, for slow rolling; nothing is given per time, "
            "and there are no powers, efficiency, temperatures or oil film"
        ]
    if not bool(np.isfinite(np.asarray(result.rolling.power.efficiency))):
        return ["no efficiency: the output torque drives the rotation, but is smaller than the losses"]
    return []

"""The joint that turns as part of the JSON document: SI units, the unit at the end of every key."""

from __future__ import annotations

from typing import Any

import numpy as np

from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.rolling.life import DriveLives
from asperity.rolling.power import rolling_input_torque
from asperity.rolling.rolling import RollingResult

Document = dict[str, Any]


def rolling_document(joint: Joint, result: JointResult) -> Document:
    """Creep, drift, axial forces, losses and life of a solved joint."""
    rolling = result.rolling
    return {
        "unknown_because": unknown_because(joint, result),
        "speed_loss": rolling.speed_loss,
        "drift_rad_per_output_turn": rolling.drift_per_output_turn,
        "drift_rad_per_hour": 3600.0 * rolling.drift_rate,
        "output_speed_rad_per_s": rolling.output_speed,
        "efficiency": rolling.power.efficiency,
        "input_torque_Nm": rolling_input_torque(
            power=rolling.power,
            output_torque=joint.output_torque,
            output_speed=rolling.output_speed,
            input_speed=joint.input_speed,
        ),
        "input_power_W": rolling.power.input,
        "output_power_W": rolling.power.output,
        "losses_W": losses(rolling),
        "axial_thrust_N": dict(zip(result.body_names, np.asarray(rolling.axial_thrust), strict=True)),
        "reliability": np.asarray(joint.rolling.reliability),
        "no_life_because": no_life_because(result),
        "life_hours": rolling.life_hours.drive,
        "life_output_turns": rolling.life_turns.drive,
        "body_life_hours": _by_body(result.body_names, rolling.life_hours),
        "body_life_output_turns": _by_body(result.body_names, rolling.life_turns),
        "duty_life_hours": rolling.duty_life_hours,
        "duty_life_output_turns": rolling.duty_life_turns,
        "duty": {
            str(index): {"damage_share": share, "life_hours": hours, "shakedown_ratio": pressure}
            for index, (share, hours, pressure) in enumerate(
                zip(
                    np.asarray(rolling.duty_damage_shares),
                    np.asarray(rolling.duty_load_hours),
                    np.asarray(rolling.duty_shakedown_ratios),
                    strict=True,
                ),
                start=1,
            )
        },
        "contacts": {name: _contact(rolling, k) for k, name in enumerate(result.contact_names)},
        "residual": rolling.residual,
    }


def losses(rolling: RollingResult) -> Document:
    """Losses by cause, all contacts together, and their sum ``total`` [W]; nan for a loss that the joint leaves out."""
    power = rolling.power
    by_contact = {
        name: np.sum(np.asarray(getattr(power, name))) for name in ("creep", "skew", "hysteresis", "oil")
    }
    return {**by_contact, "bearings": power.bearings, "total": power.loss}


def _contact(rolling: RollingResult, k: int) -> Document:
    power = rolling.power
    return {
        "creepage": rolling.creepage[k],
        "traction_coefficient": rolling.traction_coefficient[k],
        "hertz_pressure_Pa": rolling.hertz_pressure[k],
        "shakedown_ratio": rolling.shakedown_ratio[k],
        "life_hours": rolling.life_hours.contact[k],
        "slip_ratio": rolling.slip_ratio[k],
        "flash_temperature_K": rolling.flash_temperature[k],
        "film_thickness_m": rolling.film_thickness[k],
        "film_ratio": rolling.film_ratio[k],
        "normal_N": rolling.normal[k],
        "tangential_N": rolling.tangential[k],
        "oil_drag_N": rolling.drag[k],
        "hysteresis_moment_Nm": rolling.hysteresis_moment[k],
        "skew_drag_N": rolling.skew_drag[k],
        "stick_fraction": np.asarray(rolling.stick_fraction)[k],
        "layer_ratio": rolling.layer_ratio[k],
        "layer_creepage_factor": rolling.layer_creepage_factor[k],
        "rough_half_width_m": rolling.rough_half_width[k],
        "rough_peak_pressure_Pa": rolling.rough_peak_pressure[k],
        "crown_creepage_factor": None
        if rolling.crown_creepage_factor is None
        else rolling.crown_creepage_factor[k],
        "skew_creepage_factor": rolling.skew_creepage_factor[k],
        "capacity_loss": rolling.capacity_loss[k],
        "axial_force_N": rolling.axial_force[k],
        "losses_W": {
            **{name: np.asarray(getattr(power, name))[k] for name in ("creep", "skew", "hysteresis", "oil")},
            "total": np.asarray(power.contact)[k],
        },
        "life_output_turns": rolling.life_turns.contact[k],
        "life_stress_cycles": {"driving": rolling.cycles[0][k], "driven": rolling.cycles[1][k]},
        "stress_cycles_per_output_turn": {
            "driving": rolling.cycles_per_turn[0][k],
            "driven": rolling.cycles_per_turn[1][k],
        },
    }


def _by_body(names: tuple[str, ...], lives: DriveLives) -> Document:
    return dict(zip(names, np.asarray(lives.body), strict=True))


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
    ratio = np.asarray(result.rolling.shakedown_ratio)
    beyond = [name for name, pressure in zip(result.contact_names, ratio, strict=True) if pressure >= 1.0]
    if not beyond:
        return None
    return (
        f"no rating life: at {', '.join(beyond)} the Hertz pressure exceeds the shakedown limit, and the surface flows "
        "at every passage; the fatigue law holds for elastic tracks only"
    )


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

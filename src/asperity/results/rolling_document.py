"""What the rows do not say about the joint that turns, as part of its JSON document."""

from __future__ import annotations

import numpy as np

from asperity.joint.torque_limits import capacity_document
from asperity.results.film_bands import film_band
from asperity.results.places import in_order
from asperity.results.solved import SolvedJoint
from asperity.rolling.document import losses, no_life_because, unknown_because
from asperity.rolling.power import rolling_input_torque
from asperity.types import Document


def rolling_document(solved: SolvedJoint) -> Document:
    """Reasons, torques, sums and duty of the joint that turns; creep, drift, losses and lives wait for their rows."""
    joint, result, solution = solved.joint, solved.result, solved.solution
    rolling, names = result.rolling, result.contact_names
    both = {
        **capacity_document(solution.rolling_capacity, contacts=names),
        "reverse": capacity_document(solution.reverse_rolling_capacity, contacts=names),
    }
    forward = float(joint.output_torque) >= 0.0
    capacity = solution.rolling_capacity if forward else solution.reverse_rolling_capacity
    return {
        "unknown_because": unknown_because(joint, result),
        **in_order("speed_loss drift_rad_per_output_turn drift_rad_per_hour"),
        **in_order("output_speed_rad_per_s efficiency"),
        "input_torque_Nm": rolling_input_torque(
            power=rolling.power,
            output_torque=joint.output_torque,
            output_speed=rolling.output_speed,
            input_speed=joint.input_speed,
        ),
        **in_order("input_power_W output_power_W"),
        "losses_W": losses(rolling),
        **in_order("axial_thrust_N"),
        "reliability": np.asarray(joint.rolling.reliability),
        "no_life_because": no_life_because(joint, result),
        **in_order("life_hours life_output_turns body_life_hours body_life_output_turns"),
        **in_order("duty_life_hours duty_life_output_turns"),
        "duty": {
            str(index): {
                "damage_share": share,
                "life_hours": hours,
                "shakedown_ratio": pressure,
                "film_ratio": film,
            }
            for index, (share, hours, pressure, film) in enumerate(
                zip(
                    np.asarray(rolling.duty_damage_shares),
                    np.asarray(rolling.duty_load_hours),
                    np.asarray(rolling.duty_shakedown_ratios),
                    np.asarray(rolling.duty_film_ratios),
                    strict=True,
                ),
                start=1,
            )
        },
        "contacts": {name: _contact(solved, k) for k, name in enumerate(result.contact_names)},
        **in_order("residual"),
        "torque_capacity_Nm": capacity.output_torque,
        "torque_capacity": both,
    }


def _contact(solved: SolvedJoint, k: int) -> Document:
    """Stress cycles of a contact; everything else waits for its row."""
    rolling = solved.result.rolling
    return {
        **in_order("creepage traction_coefficient hertz_pressure_Pa shakedown_ratio life_hours slip_ratio"),
        **in_order("flash_temperature_K film_thickness_m film_ratio"),
        "lubrication": film_band(float(np.asarray(rolling.film_ratio)[k])) or None,
        **in_order("life_factor normal_N tangential_N oil_drag_N"),
        **in_order("hysteresis_moment_Nm skew_drag_N stick_fraction layer_ratio layer_creepage_factor"),
        **in_order("rough_half_width_m rough_peak_pressure_Pa crown_creepage_factor skew_creepage_factor"),
        **in_order("capacity_loss axial_force_N"),
        "losses_W": in_order("creep skew hysteresis oil total"),
        **in_order("life_output_turns"),
        "life_stress_cycles": {"driving": rolling.cycles[0][k], "driven": rolling.cycles[1][k]},
        "stress_cycles_per_output_turn": {
            "driving": rolling.cycles_per_turn[0][k],
            "driven": rolling.cycles_per_turn[1][k],
        },
    }

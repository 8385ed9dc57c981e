"""The dynamics of a joint as one JSON document, and its frequency response as columns."""

from __future__ import annotations

from typing import Any

import numpy as np

from asperity.standing.dynamics import Dynamics, Inertias
from asperity.types import Document


def dynamics_document(dynamics: Dynamics, inertias: Inertias) -> Document:
    """The dynamics of a joint in SI units, ready for :func:`json.dumps`."""
    names = {
        "output_torque": "output_torque_Nm",
        "stiffness": "stiffness_output_Nm_per_rad",
        "input_inertia": "input_inertia_at_output_kg_m2",
        "spin_inertia": "spin_inertia_at_output_kg_m2",
        "output_inertia": "output_inertia_kg_m2",
        "locked_frequency": "locked_frequency_Hz",
        "free_frequency": "free_frequency_Hz",
        "creep_damping": "creep_damping_Nms_per_rad",
        "corner_frequency": "corner_frequency_Hz",
    }

    def plain(values: Any) -> Any:
        listed = np.asarray(values, dtype=float)
        if listed.ndim:
            return [plain(value) for value in listed]
        return float(listed) if np.isfinite(listed) else None

    return {
        "inertia": {
            "input_kg_m2": plain(inertias.input),
            "output_kg_m2": plain(inertias.output),
            "loss_factor": plain(inertias.loss_factor),
        },
        "at_torque": {key: plain(getattr(dynamics.at_torque, name)) for name, key in names.items()},
        "over_torque": {key: plain(getattr(dynamics.over_torque, name)) for name, key in names.items()},
        "response": {key: plain(values) for key, values in response_columns(dynamics).items()},
    }


def response_columns(dynamics: Dynamics) -> dict[str, np.ndarray]:
    """Amplitudes and phases of both sides, standing and turning, as columns with units in their names."""
    columns = {"frequency_Hz": np.asarray(dynamics.frequency)}
    for name in ("standing_motor", "standing_load", "turning_motor", "turning_load"):
        angle = np.asarray(getattr(dynamics, name))
        columns[f"{name}_rad_per_Nm"] = np.abs(angle)
        phase = np.degrees(np.unwrap(np.angle(angle)))
        # two free masses: -180
        columns[f"{name}_phase_deg"] = phase - 360.0 * np.round((phase[0] + 180.0) / 360.0)
    return columns

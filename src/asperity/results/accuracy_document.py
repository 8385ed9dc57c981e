"""The accuracy of a joint over a turn as one JSON document."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

import numpy as np

from asperity.errors import InputError
from asperity.rolling.accuracy import Accuracy, Budget, OverTurn, bidirectional
from asperity.types import Document
from asperity.units import format_quantity

#: Drift per turn of the output that is rounding of none [rad].
_NO_DRIFT = 1e-12


class AccuracyOfJoint(NamedTuple):
    """A joint with form errors.

    Name of its ``output``, torque there [N·m], and number of sectors; ``forward`` in the direction of its file,
    ``backward`` in the other one under the same torque, None where nobody asked; ``over_turn`` forward;
    ``diameters`` of the tracks of the components [m]; ``lost_motion`` of the wind-up under the torque [rad], None where
    nobody asked or the joint does not stand under it in both directions.
    """

    output: str
    output_torque: float
    sectors: int
    forward: Accuracy
    backward: Accuracy | None
    over_turn: OverTurn
    diameters: tuple[float, ...]
    lost_motion: float | None = None


def accuracy_document(
    accuracy: AccuracyOfJoint, *, allowed: float | None = None, uncertainty: float | None = None
) -> Document:
    """The accuracy in SI units, ready for :func:`json.dumps`.

    With an ``allowed`` error of the position [rad], the turns of the output without a reference, where the drift is
    corrected but for a share ``uncertainty`` of it, or not at all if None. An ``InputError`` is raised unless both are
    above 0.
    """
    document: Document = {
        "output_torque_Nm": accuracy.output_torque,
        "accuracy": {
            **_direction(accuracy.forward),
            "components": _components(accuracy.forward),
        },
    }
    if uncertainty is not None and allowed is None:
        raise InputError(
            "the uncertainty of the drift says how many turns an allowed error lasts: give the error too, such as "
            "'5 arcmin'",
            options=["allowed"],
        )
    if allowed is not None:
        document["accuracy"]["homing"] = _homing(accuracy.forward, allowed, uncertainty)
    if accuracy.backward is not None:
        both = bidirectional(accuracy.forward, accuracy.backward)
        document["accuracy"]["reverse"] = {
            **_direction(accuracy.backward),
            "components": _components(accuracy.backward),
        }
        document["accuracy"]["bidirectional_error_rad"] = _budget(both)
        lost = accuracy.lost_motion
        document["accuracy"]["lost_motion_rad"] = lost
        document["accuracy"]["bidirectional_repeatability_rad"] = (
            None if lost is None else float(both.worst) + lost
        )
    return document


def _homing(accuracy: Accuracy, allowed: float, uncertainty: float | None) -> Document:
    """After how many turns the drift may have passed an allowed error."""
    share = 1.0 if uncertainty is None else uncertainty
    for value, unit, option in ((allowed, "arcmin", "allowed"), (share, "1", "uncertainty")):
        if not 0.0 < value < math.inf:
            raise InputError(
                f"{format_quantity(value, unit)} is not allowed; it must be above 0", options=[option]
            )
    drift = abs(accuracy.drift_per_output_turn)
    drift = drift if drift > _NO_DRIFT else 0.0
    turns = homing_turns(allowed=allowed, uncertainty=share * drift)
    return {
        "allowed_rad": allowed,
        "uncertainty_rad_per_output_turn": share * drift,
        "turns": turns if math.isfinite(turns) else None,
    }


def _direction(accuracy: Accuracy) -> Document:
    """What one direction has besides its components."""
    normal, slip = accuracy.budget("normal"), accuracy.budget("slip")
    tangential, torque = accuracy.budget("tangential"), accuracy.budget("input_torque")
    may_slip = accuracy.may_slip
    return {
        "transmission_error_rad": _budget(accuracy.transmission_error),
        "drift_rad_per_output_turn": accuracy.drift_per_output_turn,
        "input_torque_Nm": {"mean": accuracy.input_torque, **_budget(torque)},
        "contacts": {
            name: {
                "normal_N": _of_contact(abs(accuracy.normal), normal, k),
                "tangential_N": _of_contact(abs(accuracy.tangential), tangential, k),
                "slip_ratio": _of_contact(accuracy.slip, slip, k),
                "may_slip": bool(may_slip[k]),
            }
            for k, name in enumerate(accuracy.contact_names)
        },
    }


def _budget(budget: Budget) -> Document:
    return {"worst": float(budget.worst), "rms": float(budget.rms)}


def _of_contact(steady: np.ndarray, budget: Budget, k: int) -> Document:
    """Steady value of a contact, and by how much form errors change it."""
    return {"mean": float(steady[k]), "worst": float(budget.worst[k]), "rms": float(budget.rms[k])}


def _components(accuracy: Accuracy) -> list[Document]:
    """The amplitudes of every form error."""
    return [
        {
            "part": one.error.part,
            "sector": one.error.sector or None,
            "harmonic": one.error.harmonic,
            "amplitude_m": one.error.amplitude,
            "order": one.order,
            "transmission_error_rad": abs(one.transmission_error),
            "phase_rad": None if one.error.phase is None else cmath.phase(one.transmission_error),
            "normal_N": _by_contact(accuracy, one.normal),
            "tangential_N": _by_contact(accuracy, one.tangential),
            "input_torque_Nm": abs(one.input_torque),
        }
        for one in accuracy.components
    ]


def _by_contact(accuracy: Accuracy, amplitudes: np.ndarray) -> dict[str, float]:
    return dict(zip(accuracy.contact_names, np.abs(amplitudes).tolist(), strict=True))


def turn_columns(over_turn: OverTurn, contact_names: tuple[str, ...]) -> Document:
    """The joint over one turn of its output as columns of one table, units in the names."""
    columns = {
        "output_angle_rad": over_turn.angle,
        "transmission_error_rad": over_turn.transmission_error,
        "input_torque_Nm": over_turn.input_torque,
    }
    for k, name in enumerate(contact_names):
        columns[f"normal_N_{name}"] = over_turn.normal[:, k]
        columns[f"slip_ratio_{name}"] = over_turn.slip[:, k]
    return columns


def homing_turns(*, allowed: float, uncertainty: float) -> float:
    r"""Turns of the output after which a joint has to find its reference again.

    .. math:: n = \frac{\Delta\varphi_{allowed}}{u(\Delta\varphi_{turn})}

    Parameters
    ----------
    allowed : float
        Error of the position of the output that is allowed [rad].
    uncertainty : float
        Uncertainty of its drift per turn of the output: the whole drift where nothing corrects it [rad].

    Returns
    -------
    float
        Turns in one sense of the torque, infinite without drift [-].

    References
    ----------
    Elementary; drift adds up in both directions of rotation under a torque of one sense.
    """
    return allowed / uncertainty if uncertainty > 0.0 else math.inf

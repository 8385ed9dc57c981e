"""Rolling bearings, ring and hollow rollers of a solved joint as entries of JSON documents."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from asperity.joint.description import Joint
from asperity.joint.rim_safety import RIM_NAMES, BodyRims
from asperity.results.solved import SolvedJoint

Document = dict[str, Any]


def bearing_entries(solved: SolvedJoint) -> list[Document]:
    """Loads, lives and safeties of the rolling bearings of a joint, ready for :func:`json.dumps`.

    Parameters
    ----------
    solved : SolvedJoint
        One joint.

    Returns
    -------
    list of dict
        One entry for each bearing with ratings; a number that is not known or infinite is None, and
        ``absent_because`` says why.
    """
    joint, entries = solved.joint, []
    for index, (name, rated) in enumerate(zip(joint.bearing_names, joint.rated_bearings, strict=True)):
        if rated is None:
            continue
        found = {key: float(np.asarray(value)[index]) for key, value in vars(solved.bearings).items()}
        entries.append(
            {
                "bearing": name,
                "type": rated.kind,
                "dynamic_rating_N": float(rated.dynamic_rating),
                "static_rating_N": float(rated.static_rating),
                "load_N": _plain(found["load"]),
                "life_hours": _plain(found["life"] / 3600.0),
                "duty_life_hours": _plain(found["duty_life"] / 3600.0) if joint.rolling.duty else None,
                "static_safety": _plain(found["static_safety"]),
                "load_over_dynamic_rating": _plain(found["load_ratio"]),
                "absent_because": _absent_because(joint, found),
            }
        )
    return entries


def _absent_because(joint: Joint, found: dict[str, float]) -> list[str]:
    """Why lives of a bearing are absent."""
    why = []
    duty = found["duty_life"] if joint.rolling.duty else 1.0
    if math.isnan(found["load"]):
        why.append("its load is not known: the joint slips or does not roll")
    elif math.isnan(found["life"]):
        why.append("it stands: no life in hours at this speed, only its static safety counts")
    elif math.isinf(found["life"]):
        why.append("it carries no load: its life is not limited by fatigue")
    if math.isnan(duty):
        why.append(
            "no life, largest P/C and static safety under the duty: the joint slips or does not roll under one of its "
            "loads"
        )
    if math.isinf(duty) and not math.isinf(found["life"]):
        why.append("no load of the duty turns it")
    return why


def rim_entry(rims: BodyRims) -> Document:
    """Stresses and safeties of one body, ready for :func:`json.dumps`."""
    return {
        **{
            f"{name}_Pa": dict(zip(RIM_NAMES, map(_plain, np.asarray(getattr(rims, name))), strict=True))
            for name in ("stress", "stress_at_rest", "mean", "amplitude")
        },
        "yield_safety": _plain(rims.yield_safety),
        "fatigue_safety": _plain(rims.fatigue_safety),
    }


def _plain(value: Any) -> float | None:
    number = float(value)
    return number if math.isfinite(number) else None

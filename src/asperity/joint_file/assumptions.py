"""What a joint file leaves out, and what is assumed instead."""

from __future__ import annotations

from asperity.joint_file.model import Case


def assumptions(case: Case) -> tuple[str, ...]:
    """What a joint file leaves out, and what is taken instead.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    tuple of str
        One sentence each.
    """
    told = []
    if case.bearings is None:
        told.append("no section [bearings]: the bearings have no friction")
    if case.compliance is None:
        told.append("no section [compliance]: pins and shafts are rigid, the planets float")
    else:
        absent = [name for name, value in case.compliance if value is None]
        if absent:
            told.append(f"[compliance] without {', '.join(absent)}: ideal, as their descriptions say")
    if case.play is None:
        told.append("no section [play]: the output has no play")
    if case.compliance is None or case.compliance.ring_bending_stiffness is None:
        told.append(
            "no compliance.ring_bending_stiffness: a rigid housing holds the ring, whose wall only compresses locally"
        )
    for roller in ("planet", "loading_roller"):
        if getattr(case.drive, f"{roller}_length") is None:
            told.append(f"no drive.{roller}_length: as long as the longest contact line on it")
    return tuple(told)

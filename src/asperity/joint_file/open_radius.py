"""The radius that a joint file leaves open, from the speed ratio that it asks for in its place."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from asperity.drive.layout.drive import speed_ratio
from asperity.drive.layout.drive_type import DriveType
from asperity.engine.arrays import xp
from asperity.engine.control import at_once, vectorised
from asperity.errors import InputError, quoted
from asperity.joint_file import limits
from asperity.joint_file.drive_sections import OpenRadius
from asperity.joint_file.model import Case
from asperity.joint_file.section import keys_by_path, models_of
from asperity.types import Document
from asperity.units import format_quantity

_PLACES = 4000
#: In place of a radius that is not found, in tables that are refused.
_ANY = "1 mm"


def radii_of(model: type[Case]) -> tuple[str, ...]:
    """Radii of the section [drive] that make the drive of a type; none where its contacts are listed."""
    return model.drive_type.radii


def fill_in_radius(
    tables: Mapping[str, Any], model: type[Case]
) -> tuple[Document, dict[str, str], OpenRadius | None]:
    """The tables of a joint file with the radius that its ``drive.ratio`` means, without that key; what is refused."""
    drive, radii = tables.get("drive"), radii_of(model)
    if not radii or not isinstance(drive, Mapping) or "ratio" not in drive:
        return dict(tables), {}, None
    without = {name: value for name, value in drive.items() if name != "ratio"}
    missing = [name for name in radii if name not in drive]
    found, filled, refused = None, dict.fromkeys(missing, _ANY), {}
    try:
        ratio = limits.RATIO.read(drive["ratio"]).value
        if len(missing) != 1:
            left = f"{', '.join(missing)} are open: state all but one of them"
            raise InputError(
                f"with it exactly one radius is left open, and {left if missing else 'all are stated: leave one out'}, "
                "or leave ratio out"
            )
        sizes = _sizes(without, model)
        if sizes is not None:
            radius = _radius_of_ratio(model.drive_type, sizes, missing[0], ratio)
            text = f"{1e3 * radius:.12g} mm"
            found = OpenRadius(missing[0], limits.ROLLER_RADIUS.read(text).value, ratio)
            filled = {missing[0]: text}
    except InputError as error:
        refused["drive.ratio"] = f"drive.ratio: {error}"
    return {**tables, "drive": without | filled}, refused, found


def _sizes(drive: Mapping[str, Any], model: type[Case]) -> Document | None:
    """The numbers and words of a section [drive] in SI units; None where one that it needs cannot be read."""
    known = {path.removeprefix("drive."): key for path, key in keys_by_path(model).items()}
    sizes: Document = {}
    for name, value in drive.items():
        if name in known:
            try:
                sizes[name] = known[name].read(value).value
            except InputError:
                return None
    (section,) = models_of(model.model_fields["drive"].annotation)
    needed = {name for name, field in section.model_fields.items() if field.is_required() and name in known}
    if len(needed - set(sizes)) != 1 + ("contact_length" not in sizes and "contact_length" in needed):
        return None
    return sizes | {"output": drive.get("output")}


def _radius_of_ratio(kind: DriveType, drive: Mapping[str, Any], name: str, ratio: float) -> float:
    """The radius [m] at which a drive that can exist has this ratio; raise where there is none, or several."""
    from scipy.optimize import brentq

    stated = [drive[radius] for radius in kind.radii if radius in drive]
    places = np.geomspace(1e-3 * min(stated), 1e3 * max(stated), _PLACES)

    def excess(radius: Any) -> Any:
        """Logarithm of the ratio without slip, from the speeds of the drive, over that which is wanted."""
        made: Any = speed_ratio(kind.drive(dict(drive) | {name: radius}))
        return xp.log(abs(made) / ratio)

    def at(radius: float) -> float:
        return float(at_once(excess, np.asarray(radius)))

    with np.errstate(all="ignore"):  # no drive: nan
        along = vectorised(excess)(places)
    known = along[np.isfinite(along)]
    if known.size and np.ptp(known) < 1e-9:
        raise InputError(
            f"{name} does not move the ratio, which is {ratio * math.exp(known[0]):.6g}: state it"
        )
    with np.errstate(invalid="ignore"):
        crossed = np.flatnonzero(along[:-1] * along[1:] <= 0.0)
    roots = [float(brentq(at, places[k], places[k + 1], xtol=1e-18)) for k in crossed]
    if not roots:
        ends = (
            f"between {ratio * np.exp(known.min()):.4g} and {ratio * np.exp(known.max()):.4g}"
            if known.size
            else "not defined"
        )
        raise InputError(f"no {name} gives {ratio:g}; with the other sizes of the file the ratio is {ends}")
    reasons = {root: _impossible(kind, dict(drive) | {name: root}) for root in dict.fromkeys(roots)}
    possible = [root for root, reason in reasons.items() if not reason]
    texts = [format_quantity(root, "mm", 6) for root in possible]
    if len(possible) > 1:
        raise InputError(f"{name} may be {' or '.join(texts)}; state it in place of the ratio")
    if not possible:
        root, reason = next(iter(reasons.items()))
        raise InputError(
            f"{ratio:g} needs {name} = {format_quantity(root, 'mm', 6)}, and such a drive cannot exist: {reason}"
        )
    return possible[0]


def _impossible(kind: DriveType, drive: Mapping[str, Any]) -> str:
    """Why a drive cannot exist; empty where it can."""
    from asperity.drive.layout.existence import refuse_impossible

    try:
        refuse_impossible(kind.drive(drive))
    except InputError as error:
        return str(error)
    return ""


def refuse_output_speed(case: Case) -> None:
    """Raise if no speed of the input follows from the stated speed of the output."""
    from asperity.drive.layout.existence import refuse_impossible
    from asperity.joint_file.build import joint_from_case

    if case.load.output_speed is None:
        return
    with np.errstate(all="ignore"):  # an output that stands: judged by what it makes
        joint, written = joint_from_case(case), case.load.output_speed.text
    speed = float(joint.input_speed)
    if math.isnan(speed):  # rollers without a place have no ratio
        refuse_impossible(joint.drive)
    if not math.isfinite(speed):
        raise InputError(
            f"load.output_speed: {quoted(written)}: this drive has no finite speed ratio, from which the speed of the "
            "input follows; give sun_speed"
        )
    if not limits.SUN_SPEED.admits(speed):
        raise InputError(
            f"load.output_speed: {quoted(written)} is not allowed: the input turns at {format_quantity(speed, 'rpm')}, "
            f"and its speed must be {limits.SUN_SPEED.allowed}"
        )

"""A solved joint as one JSON document: SI units, the unit at the end of every key."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from asperity.drive.torsional_stiffness import TorsionalStiffness
from asperity.joint.contact_notes import Note
from asperity.joint.limit_check import LimitCheck
from asperity.joint.planar.evaluation import PlanarResult
from asperity.joint.planar.solved import SolvedJoint
from asperity.joint.results import GROUPS, RESULTS, SEVERITIES
from asperity.joint.rolling_document import contact_results
from asperity.units import format_quantity

Document = dict[str, Any]

#: Below this share of the compliance a spring is only the rounding of the others.
NO_SHARE = 1e-12

#: Levels of the torsional stiffness, the fullest model first, in words that are true for every type of drive.
LEVEL_WORDS = (
    ("assembly", "assembled: asperities, bodies, rollers free to move, structure"),
    ("series_with_bulk", "asperities and bodies in series, roller centres held"),
    ("published", "as in Zou et al. 2025: asperities alone, an upper bound"),
)


#: What the shares of the compliance by spring do not show, where the bodies of a joint are elastic rather than springs.
WHOLE_BODIES = (
    "the springs of a contact include how its bodies deform as a whole: a free ring's bending, for example"
)


def has_whole_bodies(document: Document) -> bool:
    """Whether :data:`WHOLE_BODIES` is true for the joint of a document.

    Parameters
    ----------
    document : dict
        As :func:`joint_document` makes it.

    Returns
    -------
    bool
        False where the joint file has springs in place of bodies.
    """
    return (document["input"].get("model") or {}).get("bodies") != "springs"


def diagnostic_documents(checks: tuple[LimitCheck, ...], notes: tuple[Note, ...]) -> list[Document]:
    """All limits of a joint and all notes on it, the most serious first.

    Parameters
    ----------
    checks : tuple of LimitCheck
        Its limits.
    notes : tuple of Note
        What is usual, and what is not.

    Returns
    -------
    list of dict
        One entry each, with the same keys; ``infinite`` tells an infinite value, which is None in a document, from one
        that is not known. ``unit`` is that of value and limit, ``shown`` and ``limit_shown`` are what people read.
    """
    entries = [*map(_limit_document, checks), *map(_note_document, notes)]
    for entry in entries:
        value, unit = entry["value"], entry.pop("display_unit")
        entry["infinite"] = math.isinf(value)
        entry["shown"] = (
            "infinite" if entry["infinite"] else "-" if math.isnan(value) else format_quantity(value, unit)
        )
        entry["limit_shown"] = format_quantity(entry["limit"], unit)
    return sorted(entries, key=lambda entry: SEVERITIES.index(entry["severity"]))


def _limit_document(entry: LimitCheck) -> Document:
    """Value, limit and words of one limit of a joint, kept or crossed."""
    return {
        "name": entry.result.name,
        "label": entry.result.label,
        "contact": entry.contact,
        "value": entry.value,
        "limit": entry.limit,
        "ok": entry.ok,
        "severity": entry.rule.severity,
        "state": "" if entry.ok else entry.rule.state,
        "meaning": entry.meaning,
        "remedy": None if entry.ok else entry.rule.remedy,
        "unit": entry.result.si_unit,
        "display_unit": entry.result.display_unit,
    }


def _note_document(note: Note) -> Document:
    words = dataclasses.asdict(note)
    return words | {"unit": words.pop("dimension").si_unit}


def contact_documents(solved: SolvedJoint) -> Document:
    """Every result of the contacts but their forces, with its unit behind its name; and what the rolling adds.

    Parameters
    ----------
    solved : SolvedJoint
        One joint.

    Returns
    -------
    dict
        Contact → its results.
    """
    columns = {
        f"{name}{_suffix(RESULTS[name].si_unit)}": RESULTS[name].of(solved) for name in GROUPS["contacts"]
    }
    return {
        contact: {
            **{
                name: np.broadcast_to(values, (len(solved.result.contact_names),))[index]
                for name, values in columns.items()
            },
            **contact_results(solved.result.rolling, index),
        }
        for index, contact in enumerate(solved.result.contact_names)
    }


def _suffix(unit: str) -> str:
    """A unit as the end of a key: N*m/rad is _Nm_per_rad."""
    return "" if unit == "1" else "_" + unit.replace("*", "").replace("^", "").replace("/", "_per_")


def torsional_stiffness_document(result: PlanarResult) -> Document:
    """Torsional stiffness on all levels of the model.

    Parameters
    ----------
    result : PlanarResult
        Result of one joint.

    Returns
    -------
    dict
        Level → stiffness at sun and output.
    """
    return {
        "published": _stiffness(result.published),
        "series_with_bulk": _stiffness(result.series_with_bulk),
        "assembly": _stiffness(result.assembly.stiffness),
    }


def input_member(document: Document) -> str:
    """Name of the member that drives, in words.

    Parameters
    ----------
    document : dict
        As :func:`joint_document` or :func:`asperity.joint.planar.document.planar_document` makes it.

    Returns
    -------
    str
        Such as "sun".
    """
    return str(document["geometry"]["input"]).replace("_", " ")


def stiffness_rows(document: Document) -> list[tuple[str, Document]]:
    """Torsional stiffness of a joint, of any type of drive, as rows to show.

    Parameters
    ----------
    document : dict
        As :func:`joint_document` or :func:`asperity.joint.planar.document.planar_document` makes it.

    Returns
    -------
    list of tuple
        Words and stiffness of each level (keys as in :func:`torsional_stiffness_document`), the fullest first; of a
        joint with a loading cam also of the assembly whose cam is held by its friction.
    """
    rows = [(words, document["torsional_stiffness"][level]) for level, words in LEVEL_WORDS]
    cam = document["preload"]["loading_cam"]
    if cam is not None:
        output = cam["held_stiffness_output_Nm_per_rad"]
        squared = document["geometry"]["speed_ratio"] ** 2
        held = {
            "input_Nm_per_rad": None if output is None else output / squared,
            "output_Nm_per_rad": output,
            "output_Nm_per_arcmin": None if output is None else output * math.pi / 10800.0,
        }
        rows.append(("assembled, the loading cam held by its friction", held))
    return rows


def stiffness_unknown_because(result: PlanarResult) -> str | None:
    """Why a joint has no stiffness.

    Parameters
    ----------
    result : PlanarResult
        Result of one joint.

    Returns
    -------
    str or None
        The contacts that are the cause, and what to do; None if there is a stiffness.
    """
    if bool(result.contact_law_holds):
        return None
    normal, elastic = np.asarray(result.forces.normal), np.asarray(result.contacts.normal_stiffness)
    plastic = [
        name for name, force, k in zip(result.contact_names, normal, elastic, strict=True) if force > 0.0 >= k
    ]
    return (
        f"every spot of {', '.join(plastic)} is plastic, where the contact law has no stiffness; real surfaces keep "
        "one, so that no level of the model has a value: raise fractal_dimension or hardness, or lower "
        "fractal_roughness, or use boundary elements"
    )


def _stiffness(stiffness: TorsionalStiffness) -> Document:
    return {
        "input_Nm_per_rad": stiffness.sun,
        "output_Nm_per_rad": stiffness.output,
        "output_Nm_per_arcmin": stiffness.output_per_arcminute,
    }


def stiffness_budget(result: PlanarResult) -> Document:
    """Shares of the assembly's compliance; they add up to 1.

    Parameters
    ----------
    result : PlanarResult
        Result of one joint.

    Returns
    -------
    dict
        Spring → share; springs that only the paper's drive has are left out for other drives.
    """
    shares = vars(result.assembly).items()
    return {
        name: dict(zip(result.contact_names, np.asarray(share), strict=True)) if np.ndim(share) else share
        for name, share in shares
        if name.endswith("_share") and (isinstance(result, PlanarResult) or not RESULTS[name].wedge_only)
    }


def plain_document(document: Document) -> Document:
    """A document of Python numbers, with None for numbers that are not finite.

    Parameters
    ----------
    document : dict
        Nested tables of numbers, arrays and text.

    Returns
    -------
    dict
        Ready for :func:`json.dumps`.
    """
    cleaned: Document = _plain(document)
    return cleaned


def _plain(node: Any) -> Any:
    """Python numbers instead of arrays, None instead of what JSON cannot say."""
    if isinstance(node, dict):
        return {name: _plain(value) for name, value in node.items()}
    if isinstance(node, list):
        return [_plain(value) for value in node]
    if isinstance(node, str | bool | None):
        return node
    number = float(node)
    return number if math.isfinite(number) else None

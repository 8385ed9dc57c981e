"""Rows of the table of results: torsional stiffness on three levels, and where the compliance comes from."""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from asperity.drive.stiffness.loading_cam import held_cam_stiffness
from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.unit_table import Dimension

if TYPE_CHECKING:
    from asperity.standing.windup import StiffnessLevel

#: Levels of the model: where the stiffness is in a result, in words, and what it counts.
_LEVELS: tuple[tuple[StiffnessLevel, str, str, str], ...] = (
    (
        "assembly",
        "assembly.stiffness",
        "assembled",
        "the fullest model: asperities, bodies, rollers free to move, structure",
    ),
    (
        "series_with_bulk",
        "series_with_bulk",
        "bodies in series",
        "asperities and bodies in series, roller centres fixed",
    ),
    ("published", "published", "asperities alone", "the level of Zou et al. 2025: an upper bound"),
)
#: What each level is called.
LEVEL_NAMES: dict[StiffnessLevel, str] = {level: words for level, _, words, _ in _LEVELS}
_GROUPS = {"assembly": "assembly", "series_with_bulk": "series", "published": "published"}


def _rows(level: StiffnessLevel, path: str, words: str, note: str) -> tuple[Result, ...]:
    def stiffness(solved: SolvedJoint) -> Any:
        return operator.attrgetter(path)(solved.result).output

    def row(
        name: str,
        label: str,
        dimension: Dimension,
        value: str | Callable[[SolvedJoint], Any],
        key: str = "",
    ) -> Result:
        said, unit = f"{label}, {words}", dimension.si_unit
        return Result(
            f"{level}_{name}",
            said,
            dimension,
            unit,
            value,
            group=_GROUPS[level],
            level=level,
            note=note,
            gives_way=level == "assembly",
            place=f"torsional_stiffness.{level}.{key}" if key else "",
        )

    torsional = Dimension.TORSIONAL_STIFFNESS
    per_mass, per_volume = Dimension.TORSIONAL_STIFFNESS_PER_MASS, Dimension.TORSIONAL_STIFFNESS_PER_VOLUME
    return (
        row(
            "stiffness_output",
            "torsional stiffness at the output",
            torsional,
            f"result.{path}.output",
            "output_Nm_per_rad",
        ),
        row(
            "stiffness_input",
            "torsional stiffness at the input",
            torsional,
            f"result.{path}.input",
            "input_Nm_per_rad",
        ),
        row(
            "stiffness_per_mass", "output stiffness per mass", per_mass, lambda s: stiffness(s) / s.size.mass
        ),
        row(
            "stiffness_per_volume",
            "output stiffness per volume",
            per_volume,
            lambda s: stiffness(s) / s.size.envelope_volume,
        ),
    )


def _share(name: str, words: str) -> Result:
    of_contacts = name in ("tangential", "normal")
    return Result(
        f"{name}_share",
        f"share of {words} in the compliance",
        Dimension.DIMENSIONLESS,
        "1",
        f"result.assembly.{name}_share",
        axis="contact" if of_contacts else "one",
        group="assembly",
        positive=False,
        place=f"stiffness_budget.{name}_share{'.*' if of_contacts else ''}",
    )


ROWS = (
    *(row for level in _LEVELS for row in _rows(*level)),
    Result(
        "held_cam_output_stiffness",
        "torsional stiffness at the output, assembled, loading cam held",
        Dimension.TORSIONAL_STIFFNESS,
        Dimension.TORSIONAL_STIFFNESS.si_unit,
        lambda solved: held_cam_stiffness(solved.result.assembly),
        group="assembly",
        gives_way=True,
        note="for torques too small to move the cam against the friction of its ramps; without a cam the assembly's",
        place="",
    ),
    _share("tangential", "the contact's tangential spring"),
    _share("normal", "the contact's normal spring (rollers free to move)"),
    _share("ring_bending", "the spring compliance.ring_bending_stiffness"),
    _share("pin", "the carrier pins"),
    _share("planet_support", "the supports of rollers without a pin, the input among them"),
    _share("input_shaft", "the input shaft"),
    _share("output_shaft", "the output shaft"),
    _share("loading_cam", "the loading cam"),
)

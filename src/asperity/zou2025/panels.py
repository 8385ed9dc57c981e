"""The fourteen panels of Figs. 4–8 as data: what is on each axis, in engineers' units, and the computed curves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from asperity.drive.geometry import CONTACT_NAMES
from asperity.zou2025 import preset
from asperity.zou2025.curves import Curves, JointCurves, PairCurve

_MILLIMETRE = 1e3  # mm per m
_PER_MILLIMETRE = 1e-3  # N/mm per N/m


@dataclass(frozen=True)
class Axis:
    """One axis of a panel.

    Parameters
    ----------
    label : str
        What is shown, with its symbol.
    unit : str
        Its unit, empty for none.
    column : str
        Column name in the CSV file, unit included.
    logarithmic : bool
        Scale of the axis.
    """

    label: str
    unit: str
    column: str
    logarithmic: bool


@dataclass(frozen=True)
class Series:
    """One curve of a panel.

    Parameters
    ----------
    label : str
        Legend entry.
    column : str
        Column name in the CSV file, unit included.
    values : ndarray
        Ordinates in the unit of the panel, shape (n,).
    """

    label: str
    column: str
    values: np.ndarray


@dataclass(frozen=True)
class Panel:
    """One panel of a figure of the paper.

    Parameters
    ----------
    name : str
        Figure and letter, ``4a`` … ``8b``.
    title : str
        What it shows.
    conditions : str
        What is held fixed.
    x, y : Axis
        The axes.
    abscissa : ndarray
        Shape (n,), in the unit of ``x``.
    series : tuple of Series
        The curves.
    legend : str
        Title of the legend; empty where there is one curve.
    kind : {"single", "contacts", "torques"}
        How the curves are coloured.
    mark_peak : bool
        Whether the maximum of each curve is marked.
    inset : {"", "logarithmic", "magnified"}
        A small second view: ``logarithmic`` for curves over many decades, ``magnified`` for almost flat ones.
    note : str
        What a reader of the paper must know; may be empty.
    """

    name: str
    title: str
    conditions: str
    x: Axis
    y: Axis
    abscissa: np.ndarray
    series: tuple[Series, ...]
    legend: str
    kind: str
    mark_peak: bool
    inset: str
    note: str


_QUANTITIES = {
    "normal_force": (Axis("normal load $F_n$", "N", "normal_force_N", False), 1.0),
    "tangential_force": (Axis("tangential load $T$", "N", "tangential_force_N", False), 1.0),
    "fractal_dimension": (Axis("fractal dimension $D$", "", "fractal_dimension", False), 1.0),
    "fractal_roughness": (Axis("fractal roughness $G$", "mm", "fractal_roughness_mm", True), _MILLIMETRE),
    "second_radius": (
        Axis("radius of the second roller $R_2$", "mm", "second_radius_mm", False),
        _MILLIMETRE,
    ),
    "contact_length": (Axis("contact length $B$", "mm", "contact_length_mm", False), _MILLIMETRE),
    "friction_coefficient": (Axis("friction coefficient $\\mu$", "", "friction_coefficient", False), 1.0),
}
_OUTPUT_TORQUE = Axis("output torque", "N·m", "output_torque_Nm", False)
_PAIR_BASE = {
    "normal_force": "$F_n$ = 1000 N",
    "tangential_force": "$T$ = 0",
    "fractal_dimension": "$D$ = 1.4",
    "fractal_roughness": "$G$ = 10$^{-8}$ mm",
    "second_radius": "$R_1/R_2$ = 10/20 mm",
    "contact_length": "$B$ = 5 mm",
}
_SWAPPED = (
    "Table 1 varies the radius in case e and the length in case f; the caption of Fig. 4 has it the other way"
)


def _pair_panel(curve: PairCurve, title: str, *, logarithmic: bool, note: str) -> Panel:
    x, factor = _QUANTITIES[curve.name]
    fixed = {k: v for k, v in _PAIR_BASE.items() if k != curve.name}
    if curve.name == "second_radius":
        fixed["second_radius"] = "$R_1$ = 10 mm"
    return Panel(
        name=f"4{curve.case}",
        title=title,
        conditions=", ".join(fixed.values()),
        x=x,
        y=Axis("tangential stiffness $K_t$", "N/mm", "tangential_stiffness_N_per_mm", logarithmic),
        abscissa=curve.values * factor,
        series=(Series("", "tangential_stiffness_N_per_mm", curve.tangential_stiffness * _PER_MILLIMETRE),),
        legend="",
        kind="single",
        mark_peak=curve.name == "fractal_dimension",
        inset={
            "fractal_dimension": "logarithmic",
            "second_radius": "magnified",
            "contact_length": "magnified",
        }.get(curve.name, ""),
        note=note,
    )


def pair_panels(pairs: dict[str, PairCurve]) -> tuple[Panel, ...]:
    """The six panels of Fig. 4.

    Parameters
    ----------
    pairs : dict
        Case of Table 1 → its curve.

    Returns
    -------
    tuple of Panel
    """
    slip = preset.FRICTION_COEFFICIENT * preset.PAIR_NORMAL_FORCE
    return (
        _pair_panel(pairs["a"], "Normal load", logarithmic=False, note=""),
        _pair_panel(
            pairs["b"], "Tangential load", logarithmic=False, note=f"gross slip from mu F_n = {slip:g} N on"
        ),
        _pair_panel(pairs["c"], "Fractal dimension", logarithmic=False, note=""),
        _pair_panel(pairs["d"], "Roughness parameter", logarithmic=True, note=""),
        _pair_panel(pairs["e"], "Roller radius", logarithmic=False, note=_SWAPPED),
        _pair_panel(pairs["f"], "Contact length", logarithmic=False, note=_SWAPPED),
    )


def _contact_series(prefix: str, unit: str, values: np.ndarray) -> tuple[Series, ...]:
    return tuple(Series(name, f"{prefix}_{name}_{unit}", values[i]) for i, name in enumerate(CONTACT_NAMES))


def force_panels(loads: JointCurves) -> tuple[Panel, Panel]:
    """The two panels of Fig. 5.

    Parameters
    ----------
    loads : JointCurves
        The joint over its output torque.

    Returns
    -------
    tuple of Panel
    """
    common: dict[str, Any] = {
        "conditions": "Table 2, 6000 rpm, $N_0$ = 1000 N",
        "x": _OUTPUT_TORQUE,
        "abscissa": loads.output_torque,
        "legend": "contact",
        "kind": "contacts",
        "mark_peak": False,
        "inset": "",
        "note": "without bearing friction both tangential forces of a loading roller are equal: the curves coincide",
    }
    normal, tangential = loads.normal_force[..., 0], loads.tangential_force[..., 0]
    return (
        Panel(
            name="5a",
            title="Normal loads of the contacts",
            y=Axis("normal force $N$", "N", "normal_force_N", False),
            series=_contact_series("normal_force", "N", normal),
            **{**common, "note": ""},
        ),
        Panel(
            name="5b",
            title="Tangential loads of the contacts",
            y=Axis("tangential force $T$", "N", "tangential_force_N", False),
            series=_contact_series("tangential_force", "N", tangential),
            **common,
        ),
    )


def contact_panels(dimension: JointCurves, roughness: JointCurves) -> tuple[Panel, ...]:
    """The two panels of Fig. 6, at the largest output torque.

    Parameters
    ----------
    dimension, roughness : JointCurves
        The joint over D and over G.

    Returns
    -------
    tuple of Panel
    """
    panels = []
    for name, curves, fixed in (
        ("6a", dimension, "fractal_roughness"),
        ("6b", roughness, "fractal_dimension"),
    ):
        x, factor = _QUANTITIES[curves.name]
        panels.append(
            Panel(
                name=name,
                title=f"Contacts over {x.label.split(' $')[0]}",
                conditions=f"Table 2, {curves.output_torque[-1]:g} N·m, {_PAIR_BASE[fixed]}",
                x=x,
                y=Axis("$K_T$ of each contact at its driven roller", "N·m/rad", "K_T_Nm_per_rad", True),
                abscissa=curves.values * factor,
                series=_contact_series(
                    "torsional_stiffness", "Nm_per_rad", curves.contact_torsional_stiffness[:, -1]
                ),
                legend="contact",
                kind="contacts",
                mark_peak=False,
                inset="",
                note="the paper gives no torque; at the largest, taken here, left and right differ most",
            )
        )
    return tuple(panels)


def _joint_panel(
    name: str, curves: JointCurves, conditions: str, *, logarithmic: bool, from_torque: float, note: str
) -> Panel:
    x, factor = _QUANTITIES[curves.name]
    shown = curves.output_torque >= from_torque
    return Panel(
        name=name,
        title=f"Joint over {x.label.split(' $')[0]}",
        conditions=f"Table 2, {conditions}",
        x=x,
        y=Axis("joint stiffness $K_T$ at the output", "N·m/rad", "K_T_output_Nm_per_rad", logarithmic),
        abscissa=curves.values * factor,
        series=tuple(
            Series(f"{torque:g} N·m", f"torsional_stiffness_at_{torque:g}_Nm_output_Nm_per_rad", values)
            for torque, values in zip(
                curves.output_torque[shown], curves.output_stiffness[shown], strict=True
            )
        ),
        legend="output torque",
        kind="torques",
        mark_peak=curves.name == "fractal_dimension",
        inset="logarithmic" if curves.name == "fractal_dimension" else "",
        note=note,
    )


def joint_panels(curves: Curves) -> tuple[Panel, ...]:
    """The four panels of Figs. 7 and 8.

    Parameters
    ----------
    curves : Curves
        Everything computed.

    Returns
    -------
    tuple of Panel
    """
    d, g, mu = _PAIR_BASE["fractal_dimension"], _PAIR_BASE["fractal_roughness"], "$\\mu$ = 0.12"
    return (
        _joint_panel("7a", curves.dimension, f"{g}, {mu}", logarithmic=False, from_torque=0.0, note=""),
        _joint_panel("7b", curves.roughness, f"{d}, {mu}", logarithmic=True, from_torque=0.0, note=""),
        _joint_panel(
            "8a",
            curves.length,
            f"{d}, {g}, {mu}",
            logarithmic=False,
            from_torque=0.0,
            note="the axis does not start at 0",
        ),
        _joint_panel(
            "8b",
            curves.friction,
            f"{d}, {g}",
            logarithmic=False,
            from_torque=1.0,
            note="0 where a contact slips; the caption of Fig. 8 names a radius, which no panel shows",
        ),
    )


def all_panels(curves: Curves) -> tuple[Panel, ...]:
    """The fourteen panels in the order of the paper.

    Parameters
    ----------
    curves : Curves
        Everything computed.

    Returns
    -------
    tuple of Panel
        4a–4f, 5a, 5b, 6a, 6b, 7a, 7b, 8a, 8b.
    """
    return (
        *pair_panels(curves.pairs),
        *force_panels(curves.loads),
        *contact_panels(curves.dimension, curves.roughness),
        *joint_panels(curves),
    )

"""The fourteen panels of Figs. 4–8 as data: what is on each axis, in engineers' units, and the computed curves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from asperity.zou2025.curves import Curves
from asperity.zou2025.kinematics import CONTACT_NAMES


@dataclass(frozen=True)
class Axis:
    """One axis of a panel: label with its symbol, unit, empty for none, and scale.

    ``column``: column name in the CSV file, unit included; ``{}`` stands for the name of the curve. ``per_si``: numbers
    in this unit per number in SI.
    """

    label: str
    unit: str
    column: str
    per_si: float = 1.0
    logarithmic: bool = False


@dataclass(frozen=True)
class Panel:
    """One panel of a figure of the paper, ``4a`` … ``8b``, with what is held constant.

    ``abscissa``, shape (n,), is in the unit of ``x``; ``curves``: name of the curve (a contact, an output torque in
    N·m, or empty) → ordinates in the unit of ``y``; ``kind`` is what distinguishes them. The note for a reader of the
    paper may be empty.
    """

    name: str
    title: str
    conditions: str
    x: Axis
    y: Axis
    abscissa: np.ndarray
    curves: dict[str, np.ndarray]
    kind: Literal["single", "contacts", "torques"]
    note: str = ""

    @property
    def columns(self) -> dict[str, np.ndarray]:
        """Columns of the CSV file: name with unit → values, shape (n,)."""
        curves = {self.y.column.format(name): values for name, values in self.curves.items()}
        return {self.x.column: self.abscissa, **curves}


_X = {
    "normal_force": Axis("normal load $F_n$", "N", "normal_force_N"),
    "tangential_force": Axis("tangential load $T$", "N", "tangential_force_N"),
    "fractal_dimension": Axis("fractal dimension $D$", "", "fractal_dimension"),
    "fractal_roughness": Axis("fractal roughness $G$", "mm", "fractal_roughness_mm", 1e3, logarithmic=True),
    "second_radius": Axis("radius of the second roller $R_2$", "mm", "second_radius_mm", 1e3),
    "contact_length": Axis("contact length $B$", "mm", "contact_length_mm", 1e3),
    "friction_coefficient": Axis("friction coefficient $\\mu$", "", "friction_coefficient"),
}
_TORQUE = Axis("output torque", "N·m", "output_torque_Nm")
_TABLE_1 = {
    "normal_force": "$F_n$ = 1000 N",
    "tangential_force": "$T$ = 0",
    "fractal_dimension": "$D$ = 1.4",
    "fractal_roughness": "$G$ = 10$^{-8}$ mm",
    "second_radius": "$R_1/R_2$ = 10/20 mm",
    "contact_length": "$B$ = 5 mm",
}
_TABLE_2 = {
    "fractal_dimension": "$D$ = 1.4",
    "fractal_roughness": "$G$ = 10$^{-8}$ mm",
    "friction_coefficient": "$\\mu$ = 0.12",
}
_INTERCHANGED = (
    "Table 1 varies the radius in case e and the length in case f; the caption of Fig. 4 interchanges them"
)
_NOT_FROM_ZERO = "the vertical axis does not start at 0"


def _fixed(conditions: dict[str, str], varied: str) -> str:
    return ", ".join(text for name, text in conditions.items() if name != varied)


def pair_panels(curves: Curves) -> list[Panel]:
    """The six panels of Fig. 4: K_t over the cases of Table 1."""
    titles = {
        "a": "Normal load",
        "b": "Tangential load",
        "c": "Fractal dimension",
        "d": "Roughness parameter",
        "e": "Roller radius",
        "f": "Contact length",
    }
    panels = []
    for case, title in titles.items():
        curve = curves.pairs[case]
        x, conditions = _X[curve.name], _fixed(_TABLE_1, curve.name)
        column = "tangential_stiffness_N_per_mm"
        panels.append(
            Panel(
                name=f"4{case}",
                title=title,
                conditions=conditions + (", $R_1$ = 10 mm" if curve.name == "second_radius" else ""),
                x=x,
                y=Axis("tangential stiffness $K_t$", "N/mm", column, 1e-3, logarithmic=case == "d"),
                abscissa=curve.values * x.per_si,
                curves={"": curve.tangential_stiffness * 1e-3},
                kind="single",
                note=_INTERCHANGED if case in "ef" else "",
            )
        )
    return panels


def force_panels(curves: Curves) -> list[Panel]:
    """The two panels of Fig. 5: contact forces over the output torque."""
    loads = curves.loads
    shown = (
        ("5a", "Normal", "$N$", loads.normal_force, _NOT_FROM_ZERO),
        (
            "5b",
            "Tangential",
            "$T$",
            loads.tangential_force,
            "without bearing friction the two tangential forces of a loading roller are equal: the curves coincide",
        ),
    )
    return [
        Panel(
            name=name,
            title=f"{kind} loads of the contacts",
            conditions="Table 2, 6000 rpm, $N_0$ = 1000 N",
            x=_TORQUE,
            y=Axis(f"{kind.lower()} force {symbol}", "N", f"{kind.lower()}_force_{{}}_N"),
            abscissa=loads.output_torque,
            curves=dict(zip(CONTACT_NAMES, force[..., 0], strict=True)),
            kind="contacts",
            note=note,
        )
        for name, kind, symbol, force, note in shown
    ]


def contact_panels(curves: Curves) -> list[Panel]:
    """The two panels of Fig. 6: stiffness of the contacts over D and G, at the largest output torque."""
    panels = []
    for name, sweep in (("6a", curves.dimension), ("6b", curves.roughness)):
        x = _X[sweep.name]
        fixed = _fixed({k: v for k, v in _TABLE_2.items() if k != "friction_coefficient"}, sweep.name)
        panels.append(
            Panel(
                name=name,
                title=f"Contacts over {x.label.split(' $')[0]}",
                conditions=f"Table 2, {sweep.output_torque[-1]:g} N·m, {fixed}; at the driven roller",
                x=x,
                y=Axis(
                    "$K_T$ of each contact", "N·m/rad", "torsional_stiffness_{}_Nm_per_rad", logarithmic=True
                ),
                abscissa=sweep.values * x.per_si,
                curves=dict(zip(CONTACT_NAMES, sweep.contact_torsional_stiffness[:, -1], strict=True)),
                kind="contacts",
                note="the paper gives no torque; at this one, the largest, left and right differ most",
            )
        )
    return panels


def joint_panels(curves: Curves) -> list[Panel]:
    """The four panels of Figs. 7 and 8: stiffness of the joint for several output torques."""
    slips = "0 where a contact slips; the caption of Fig. 8 names a radius, which no panel shows"
    shown = (
        ("7a", curves.dimension, ""),
        ("7b", curves.roughness, ""),
        ("8a", curves.length, _NOT_FROM_ZERO),
        ("8b", curves.friction, slips),
    )
    panels = []
    for name, sweep, note in shown:
        x = _X[sweep.name]
        column = "torsional_stiffness_at_{}_Nm_output_Nm_per_rad"
        family = dict(zip((f"{t:g}" for t in sweep.output_torque), sweep.output_stiffness, strict=True))
        if name == "8b":
            del family["0"]  # without torque nothing can slip: K_T does not depend on friction
        panels.append(
            Panel(
                name=name,
                title=f"Joint over {x.label.split(' $')[0]}",
                conditions=f"Table 2, {_fixed(_TABLE_2, sweep.name)}",
                x=x,
                y=Axis("$K_T$ at the output", "N·m/rad", column, logarithmic=name == "7b"),
                abscissa=sweep.values * x.per_si,
                curves=family,
                kind="torques",
                note=note,
            )
        )
    return panels


def all_panels(curves: Curves) -> tuple[Panel, ...]:
    """The fourteen panels in the order of the paper."""
    return (*pair_panels(curves), *force_panels(curves), *contact_panels(curves), *joint_panels(curves))

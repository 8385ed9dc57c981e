"""What is exported of a joint: its curves up to a torque, parallel elements that follow them, the sentences above."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

import asperity
from asperity.drive.layout.drive import speed_ratio
from asperity.errors import InputError, one_line
from asperity.joint.description import Joint, contact_values
from asperity.joint.pin_bound import stiffness_bound
from asperity.joint.play import Play
from asperity.joint.solve import Solution
from asperity.made_files import WRITTEN_BY
from asperity.results.windup_document import examined_windup
from asperity.rolling.conditions import ZERO_CELSIUS
from asperity.rolling.document import unknown_because
from asperity.standing.dynamics import Inertias, two_inertias
from asperity.standing.parallel_elements import ParallelElements, fit_error, parallel_elements
from asperity.standing.series_law import SeriesLaw
from asperity.standing.standing import BothSenses, both_senses
from asperity.standing.windup import StiffnessLevel, Windup
from asperity.units import format_quantity


@dataclass(frozen=True)
class MovingParts:
    """Inertias and friction of a joint. SI units.

    Moments of inertia of the two bodies of a simple model, at input and output [kg·m^2]: of the rollers, and of motor
    and load if the joint file has them, as :func:`asperity.standing.dynamics.two_inertias` divides them. ``coupled``:
    whether the joint file has motor and load; ``loss_factor``: of the joint's spring [-]; ``friction``: torque that all
    losses but creep take from the input at the largest torque [N·m], nan where the input stands.
    """

    input: float
    output: float
    loss_factor: float
    coupled: bool
    friction: float


@dataclass(frozen=True)
class ExportContent:
    """Curves of one joint between minus and plus a torque. SI units.

    ``level`` is the stiffness that was integrated into the wind-up, its loading curves and loop at 2n − 1 torques;
    ``curves`` are stiffness and drift at the same torques. ``no_drift_because`` says why there is no steady rolling at
    the largest torque, one sentence each; empty where there is. ``source`` is the name of the joint file.
    ``efficiency`` of steady rolling at the largest torque, nan where it is unknown, and ``traction_capacities``, the
    largest T/N there of each contact by its name, empty without an oil whose traction is known [-].
    """

    source: str
    joint: Joint
    level: StiffnessLevel
    windup: Windup
    curves: BothSenses
    parts: MovingParts
    no_drift_because: tuple[str, ...]
    efficiency: float = float("nan")
    traction_capacities: tuple[tuple[str, float], ...] = ()

    @property
    def name(self) -> str:
        """Name of the joint: that of its file, without the ending, in one printable line."""
        return one_line(Path(self.source).stem)

    @property
    def largest_torque(self) -> float:
        """Torque up to which everything is known, in both directions [N·m]."""
        return float(self.windup.torque[-1])

    @property
    def stiffness(self) -> float:
        """Incremental stiffness at the largest torque, without play [N·m/rad]."""
        return float(getattr(self.curves, self.level)[-1])

    @property
    def drift(self) -> float:
        """Drift per output turn at the largest torque, nan where there is no steady rolling [rad]."""
        return float(self.curves.driving_drift[-1])

    @property
    def speed_ratio(self) -> float:
        """Turns of the input in one turn of the output; negative where they turn opposite ways [-]."""
        return float(np.asarray(speed_ratio(self.joint.drive)))

    @property
    def reduction(self) -> float:
        """Turns of the input in one turn of the output, without sign [-]."""
        return abs(self.speed_ratio)

    @property
    def ends(self) -> tuple[str, str]:
        """Names of the members at the input and at the output."""
        return self.joint.ends

    @property
    def friction(self) -> float:
        """Friction torque at the motor in a model, 0 where it is unknown [N·m]."""
        return self.parts.friction if np.isfinite(self.parts.friction) else 0.0

    @property
    def play(self) -> Play:
        """Play of the joint."""
        return self.joint.play


def export_content(
    joint: Joint,
    *,
    inertias: Inertias | None,
    source: str,
    largest_torque: float | None,
    level: StiffnessLevel,
) -> ExportContent:
    """What is exported of one joint up to a torque [N·m] of either sign, None for the joint's own.

    ``inertias`` are None if the joint file, called ``source``, has none; ``level`` is the stiffness that is integrated
    into the wind-up. An ``InputError`` if the joint cannot exist, or the torque is zero or beyond the capacity of a
    direction; a ``NoSolutionError`` if the force balance does not close.
    """
    curve, (forward, _) = examined_windup(joint, largest_torque=largest_torque, level=level)
    curves = both_senses(joint=joint, torque=curve.torque)
    lost = np.isnan(np.asarray(curves.driving_drift)[-1])
    because = unknown_because(joint, forward.result) if lost else []
    parts = _moving_parts(joint, inertias, forward)
    rolling = forward.result.rolling
    capacities = () if rolling.film is None else np.asarray(rolling.film.traction_capacity).tolist()
    return ExportContent(
        source,
        joint,
        level,
        curve,
        curves,
        parts,
        tuple(because),
        float(np.asarray(rolling.power.efficiency)),
        tuple(zip(joint.contact_names, capacities, strict=True)) if capacities else (),
    )


def _moving_parts(joint: Joint, inertias: Inertias | None, solution: Solution) -> MovingParts:
    entry, moving = two_inertias(joint, inertias, solution)
    loss_factor = 0.0 if inertias is None else float(inertias.loss_factor)
    return MovingParts(entry, moving, loss_factor, inertias is not None, _friction(joint, solution))


def _friction(joint: Joint, solution: Solution) -> float:
    """Torque that all losses but creep, which takes speed, take from the input [N·m]; nan where the input stands."""
    power, speed = solution.result.rolling.power, abs(float(joint.input_speed))
    lost = float(np.asarray(power.loss)) - float(np.sum(np.asarray(power.creep)))
    return lost / speed if speed > 0.0 else float("nan")


def heading(content: ExportContent, *, what: str) -> list[str]:
    """Sentences in ASCII, one line each, at the head of every exported file; ``what`` it is, such as "MuJoCo model"."""
    torque = format_quantity(content.largest_torque, "N*m")
    unlike = content.joint.unlike is not None
    lines = [
        f"{what} of the joint in {one_line(content.source)}, {WRITTEN_BY} {asperity.__version__}",
        "SI units: N*m, rad, kg*m^2, s. Angles and torques are those of the output unless a name says otherwise.",
        f"Stiffness at {torque}, {content.ends[0]} locked, level {content.level}: {content.stiffness:.6g} N*m/rad "
        f"({format_quantity(content.stiffness, 'N*m/arcmin')}){_bound(content)}",
        drift_sentence(content),
        efficiency_sentence(content),
        conditions_sentence(content),
        f"Wind-up at {torque}: {format_quantity(float(content.windup.angle[-1]), 'arcmin')}, at minus this torque "
        f"{format_quantity(float(content.windup.angle[0]), 'arcmin')}; width of the loop at zero torque: "
        f"{format_quantity(float(content.windup.hysteresis), 'arcmin')}",
        play_sentence(content),
        friction_sentence(content),
        *(["Branches: of unlike sizes, as the sections [[branch]] of the joint file state them."] * unlike),
        "Stiffness and drift are two regimes: the wind-up of a joint that stands comes back, the drift of a joint "
        "that turns does not.",
        f"Range: -{torque} to {torque}; beyond it nothing was computed.",
    ]
    return [_ascii(line) for line in lines]


def _bound(content: ExportContent) -> str:
    """What bounds the stiffness, behind it."""
    bound = stiffness_bound(content.joint)
    return f"; {bound}" if bound else ""


def drift_sentence(content: ExportContent) -> str:
    """The drift at the largest torque, or why there is none."""
    torque = format_quantity(content.largest_torque, "N*m")
    if content.no_drift_because:
        return f"Drift per output turn at {torque}: unknown; {content.no_drift_because[0]}"
    return (
        f"Drift per output turn at {torque}, steady rolling: {content.drift:.6g} rad "
        f"({format_quantity(content.drift, 'arcmin')})"
    )


def efficiency_sentence(content: ExportContent) -> str:
    """The efficiency at the largest torque, or that it is unknown."""
    torque = format_quantity(content.largest_torque, "N*m")
    if not np.isfinite(content.efficiency):
        return f"Efficiency at {torque}: unknown."
    return f"Efficiency at {torque}, steady rolling: {100.0 * content.efficiency:.4g} %"


def conditions_sentence(content: ExportContent) -> str:
    """Which friction the numbers of rolling have, and at which speed and temperature of the oil they hold."""
    joint = content.joint
    stated = ", ".join(dict.fromkeys(f"{float(each):.4g}" for each in _frictions(joint)))
    if float(joint.input_speed) == 0.0:
        return f"Drift: of slow rolling, with the stated friction {stated}."
    speed = f"{format_quantity(abs(float(joint.input_speed)), 'rpm')} of the {content.ends[0]}"
    oil = joint.rolling.lubricant
    if oil is None or oil.fluid.traction is None:
        return f"Drift, efficiency and friction at the motor: at {speed}, with the stated friction {stated}."
    warm = format_quantity(float(oil.temperature) - ZERO_CELSIUS, "degC")
    known = [f"{ratio:.4g} at {name}" for name, ratio in content.traction_capacities if np.isfinite(ratio)]
    largest = f" (largest T/N {', '.join(known)})" if known else ""
    return (
        f"Drift, efficiency and friction at the motor: at {speed} and oil of {warm}, by its film and the asperities"
        f"{largest}; other speeds and temperatures have others. The joint that stands has the stated friction {stated}."
    )


def _frictions(joint: Joint) -> np.ndarray:
    """Friction coefficients of the contacts [-]."""
    return np.ravel(np.asarray(contact_values(joint, joint.friction_coefficients), dtype=float))


def play_sentence(content: ExportContent) -> str:
    """The play of the joint."""
    angle, torque = float(content.play.angle), float(content.play.take_up_torque)
    if angle == 0.0:
        return "Play: none."
    taken_up = f"over {format_quantity(torque, 'N*m')}" if torque > 0.0 else "at zero torque"
    return (
        f"Play: {format_quantity(angle, 'arcmin')} from side to side, taken up {taken_up}; it is part of the angles "
        "and not of the stiffness."
    )


def friction_sentence(content: ExportContent) -> str:
    """The friction at the motor, or why it is unknown."""
    friction = content.parts.friction
    if not np.isfinite(friction):
        stands = f"because the {content.ends[0]} stands in the joint file"
        why = content.no_drift_because[0] if content.no_drift_because else stands
        return f"Friction at the motor: unknown, {why}; a model has none."
    if friction == 0.0:
        return "Friction at the motor: none in the joint file."
    return (
        f"Friction at the motor: {format_quantity(friction, 'N*m')}, which bearings, rolling and skew take from it at "
        f"{format_quantity(content.largest_torque, 'N*m')} and the speed of the joint file; constant in a model."
    )


def _ascii(line: str) -> str:
    spelt = str.maketrans({"·": "*", "²": "^2", "µ": "u", "°": " deg", "–": "-", "−": "-", "±": "+-"})
    return line.translate(spelt).encode("ascii", "backslashreplace").decode("ascii")


#: What the loop is worth, for every model that has one.
MASING = (
    "The loop itself is an estimate by Masing's rule, which has an error of its own: for the joint of "
    "Zou et al. 2025 1 to 15 % of the loop's width, up to half of it with a constant pin force."
)
#: Elasto-plastic elements in an exported model.
ELEMENTS = 8


@dataclass(frozen=True)
class FittedElements:
    """A reversible spring and elasto-plastic elements of a joint's wind-up, and how well they follow it, in sentences.

    ``linear_stiffness`` is that of the straight line between both ends of the wind-up [N·m/rad].
    """

    elements: ParallelElements
    linear_stiffness: float
    sentences: tuple[str, ...]


def fitted_elements(content: ExportContent, *, program: str) -> FittedElements:
    """Fit elements to what is exported."""
    if float(content.play.angle) > 0.0:
        raise InputError(
            f"the joint has a play of {format_quantity(float(content.play.angle), 'arcmin')}, in series with its "
            f"springs; the parallel springs of {program} cannot carry it. Remove [play] from the joint file and add "
            "the play in the model, or export to an FMU or a table"
        )
    law = SeriesLaw(content.windup, content.play)
    elements = parallel_elements(law, elements=ELEMENTS)
    error = fit_error(law, elements)
    windup = float(np.max(np.abs(np.asarray(content.windup.angle))))
    width = float(content.windup.hysteresis)
    sentence = (
        f"{elements.stiffness.size} elasto-plastic elements and a spring follow the wind-up within "
        f"{format_quantity(error.angle, 'arcsec', 2)}, {100.0 * error.angle / windup:.2g} % of the wind-up"
    )
    if elements.stiffness.size:
        sentence += (
            f" and {_share(error.angle / width)} the width of its loop at zero torque; the width itself is "
            f"off by up to {100.0 * error.loop_width / width:.2g} %"
        )
    said = [sentence + " (first loading both ways, loops of the largest torque and of half of it).", MASING]
    if error.angle > width > 0.0:
        said.insert(1, "These springs miss the curve by more than its loop is wide; an FMU follows both.")
    ends = np.asarray(content.windup.angle)[[0, -1]]
    return FittedElements(elements, 2.0 * content.largest_torque / float(np.ptp(ends)), tuple(said))


def _share(ratio: float) -> str:
    return f"{100.0 * ratio:.2g} % of" if ratio < 1.0 else f"{ratio:.2g} times"

"""Notes on a joint, compared with what is usual: its contacts and sizes, and the power that it loses when it turns."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from asperity.contact.hertz_line import effective_radius
from asperity.joint.description import Joint
from asperity.joint.diagnostics import Diagnostics
from asperity.joint.evaluation import JointResult
from asperity.results.film_bands import BAND_WORDS, FULL_FILM, film_band, life_with_film
from asperity.rolling.document import losses
from asperity.rolling.inlet_heat import FILM_REMEDY
from asperity.rolling.rolling import RollingResult
from asperity.unit_table import Dimension
from asperity.units import format_quantity

#: How serious it is that a limit is crossed: the joint does not work as it should; it is damaged; the numbers cannot be
#: trusted; the joint is in a state that works, with a consequence that has to be known; the published model is used
#: outside its range, which is so for most joints.
Severity = Literal["function", "damage", "accuracy", "state", "model"]

#: Severities, the most serious first.
SEVERITIES: tuple[Severity, ...] = ("function", "damage", "accuracy", "state", "model")

#: Friction coefficients above are those of dry or tacky surfaces; traction fluids end near 0.12 [-].
FRICTION_LIMIT = 0.3
#: Contact length over the smaller roller's diameter above which a roller skews rather than bears evenly [-].
SLENDERNESS_LIMIT = 3.0
#: Width over loaded length of a crowned contact above which its slices err by more than 2 % in the peak pressure [-].
WIDTH_OVER_LENGTH_LIMIT = 0.25
#: The paper's pairs of rollers, Tables 1 and 2: effective radius and contact length [m].
PAPER_EFFECTIVE_RADII = (3.0e-3, 8.4e-3)
PAPER_CONTACT_LENGTHS = (5e-3, 30e-3)
#: Share of the power that enters above which a loss decides about the drive [-].
LOSS_LIMIT = 1.0 / 3.0

#: Each cause of a loss in words, and what makes it smaller.
_CAUSES = {
    "creep": ("the creep of the contacts", "raise the preload, or lower the torque"),
    "skew": ("the skew of the rollers", "align their axes"),
    "hysteresis": (
        "the hysteresis of the bodies",
        "choose materials of a smaller loss factor, or less preload",
    ),
    "oil": (
        "the oil at the inlet of the contacts",
        "choose a thinner oil, a lower speed or shorter contact lines, or use the drive for more torque",
    ),
    "bearings": ("bearings and pins", "choose bearings of less friction"),
}


@dataclass(frozen=True, slots=True)
class Note:
    """One comparison with what is usual, for a contact, or for the whole drive (None).

    ``name`` is for machines, ``label`` for people; value and limit are in SI units, with the unit to display. ``ok``:
    whether the value is on the good side of its limit; ``severity``, ``meaning`` and ``remedy`` are for where it is
    not; ``state``: in which state the contact is, in a few words, where that has a consequence; ``used``: what the
    share of the limit that is used is called, as of a :class:`~asperity.results.result.Result`; ``upper``: whether the
    limit is an upper one also of a state.
    """

    name: str
    label: str
    contact: str | None
    value: float
    limit: float
    ok: bool
    severity: Severity
    meaning: str
    remedy: str | None
    dimension: Dimension = Dimension.DIMENSIONLESS
    display_unit: str = "1"
    state: str = ""
    used: tuple[str, str] | tuple[()] = ()
    upper: bool = False


def contact_notes(
    name: str,
    *,
    friction_coefficient: float,
    contact_length: float,
    smaller_radius: float,
    effective_radius: float,
    film_ratio: float,
    with_film: bool = False,
    life_factor: float | None = None,
    contact_factor_model: str,
) -> list[Note]:
    """Notes on the friction, length, oil film and size of one contact of any drive.

    ``with_film``: whether creep and capacity follow from the film; ``life_factor``: that of the rating life for the
    film [-], nan where the film is too thin for one, None where lives have none.
    """
    notes = [
        _note(
            "friction_coefficient",
            "friction coefficient",
            name,
            friction_coefficient,
            FRICTION_LIMIT,
            ("a usual friction coefficient", "traction fluids reach 0.12, clean dry steel 0.3"),
            "measure a coefficient this high before you rely on it",
        ),
        _note(
            "contact_length_over_diameter",
            "contact length over diameter",
            name,
            contact_length / (2.0 * smaller_radius),
            SLENDERNESS_LIMIT,
            (
                "a usual length of a contact line",
                "the contact line is long for its roller: a slight skew or bending loads one end, and the line load is "
                "not even as in the model",
            ),
            "shorten it, or crown the rollers",
        ),
    ]
    if math.isfinite(film_ratio):
        notes.append(_film(name, film_ratio, with_film, life_factor))
    if contact_factor_model != "unity":
        notes.append(_size(contact_factor_model, name, effective_radius, contact_length))
    return notes


def crown_notes(name: str, diagnostics: Diagnostics, index: int) -> list[Note]:
    """Whether a crowned contact of any drive is long enough for its slices, and whether its ends are free."""
    ratio = float(np.asarray(diagnostics.loaded_length_over_width)[index])
    if math.isnan(ratio):
        return []
    share, end, peak = (
        float(np.asarray(getattr(diagnostics, attribute))[index])
        for attribute in ("loaded_length_share", "end_line_load_ratio", "peak_line_load_ratio")
    )
    return [
        _note(
            "contact_width_over_length",
            "contact width over loaded length",
            name,
            1.0 / ratio,
            WIDTH_OVER_LENGTH_LIMIT,
            (
                "the contact is long enough for its slices: the peak pressure is within 2 % of Hertz's",
                "the contact is short for its slices: the peak pressure is 2 to 5 % too high, the creep up to 11 %"
                " too high",
            ),
            "choose a larger crown radius",
        ),
        _note(
            "crowned_end_load",
            "line load at the ends over mean line load",
            name,
            end,
            0.0,
            (
                f"the ends are free: {100.0 * share:.3g} % of the contact length is loaded, with {peak:.3g} times the "
                "mean line load in the middle",
                "the load reaches the ends of the rollers, whose edges raise the stress; this is not computed",
            ),
            "choose a smaller crown radius or a shorter contact line, or relieve and round the ends",
        ),
    ]


def _note(
    name: str, label: str, contact: str, value: float, limit: float, words: tuple[str, str], remedy: str
) -> Note:
    ok = value <= limit
    meaning = words[0] if ok else words[1]
    return Note(name, label, contact, value, limit, ok, "accuracy", meaning, None if ok else remedy)


def _film(contact: str, ratio: float, with_film: bool, life_factor: float | None) -> Note:
    """The lubrication of a contact: a state with a consequence, never a limit that is kept.

    Equally serious in every band, so that a thicker film never counts for less. The thickness of the oil itself is no
    advice: a thicker film lengthens the life and lowers the friction, and a thicker oil raises its loss. Smoother
    surfaces cost neither, and :func:`loss_notes` asks for them before a thinner oil. ``with_film`` and ``life_factor``
    as for :func:`contact_notes`.
    """
    band, life = film_band(ratio), life_with_film(life_factor)
    dry = "friction, creep, drift and capacity are computed for surfaces that touch, not for the oil"
    load = BAND_WORDS[band]
    full = (load, dry) if life_factor is None else (load, life, dry)
    told = {"boundary": (load, life), "mixed": (load, life, dry), "full": full}[band]
    meaning = "; ".join(part for part in told if not (with_film and part == dry))
    measure = "enter the friction coefficient measured with this oil at this film"
    smoother = (
        "make the surfaces smoother for a longer life; a thicker film also lowers the friction coefficient"
    )
    if with_film:
        smoother, measure = "make the surfaces smoother for a longer life", ""
    factor = "state life.cleanliness, which gives the life its film factor" if life_factor is None else ""
    remedy = {"boundary": (factor, smoother), "mixed": (measure, factor, smoother), "full": (measure,)}[band]
    remedies = "; ".join(part for part in remedy if part)
    return Note(
        "film_ratio",
        "film ratio λ (oil film over roughness)",
        contact,
        ratio,
        FULL_FILM,
        False,
        "state",
        meaning,
        remedies or None,
        state=f"{band} lubrication",
    )


def _size(model: str, contact: str, radius: float, length: float) -> Note:
    """Whether a pair of rollers is of the paper's sizes; told by whichever of radius and length is farther outside."""
    ranges = ((radius, PAPER_EFFECTIVE_RADII), (length, PAPER_CONTACT_LENGTHS))
    value, (low, high) = max(ranges, key=lambda entry: max(entry[1][0] / entry[0], entry[0] / entry[1][1]))
    ok = low <= value <= high
    inside = "the sizes are those for which the paper uses lambda"
    mm = [format_quantity(bound, "mm", 2) for bound in (*PAPER_EFFECTIVE_RADII, *PAPER_CONTACT_LENGTHS)]
    outside = (
        f'contact_factor = "{model}" contains a length in mm, so that it depends on the size of the drive: the paper '
        f"uses it for effective radii of {mm[0]} to {mm[1]} and contact lengths of {mm[2]} to {mm[3]}. By this alone "
        'the published stiffness of the paper\'s joint would gain 28 % at ten times its size ("printed"), and lose '
        "93 % at a tenth"
    )
    return Note(
        "contact_factor_size",
        "size of the contact",
        contact,
        value,
        low if value < low else high,
        ok,
        "model",
        inside if ok else outside,
        None if ok else 'use contact_factor = "unity", which has no such scale',
        Dimension.LENGTH,
        "mm",
    )


def plausibility(joint: Joint, result: JointResult) -> tuple[Note, ...]:
    """Notes on friction, lengths, oil film, crowns, and the sizes for which the contact factor was made."""
    drive, crowns = joint.drive, joint.crown_curvatures
    first, second = (np.asarray(radii, dtype=float) for radii in (drive.first_radius, drive.second_radius))
    frictions, lengths = (
        np.broadcast_to(np.asarray(values, dtype=float), first.shape)
        for values in (joint.friction_coefficients, joint.contact_lengths)
    )
    films, factors = np.asarray(result.rolling.film_ratio), np.asarray(result.rolling.life_factor)
    notes: list[Note] = []
    for index, name in enumerate(result.contact_names):
        notes += contact_notes(
            name,
            friction_coefficient=float(frictions[index]),
            contact_length=float(lengths[index]),
            smaller_radius=min(float(first[index]), float(second[index])),
            effective_radius=float(
                effective_radius(
                    radius_1=float(first[index]),
                    radius_2=float(second[index]),
                    sign=-1.0 if drive.contacts[index].internal else 1.0,
                )
            ),
            film_ratio=float(films[index]),
            with_film=result.rolling.film is not None,
            life_factor=None if joint.rolling.cleanliness is None else float(factors[index]),
            contact_factor_model=joint.contact_factor_model,
        )
        if crowns is not None and float(crowns[index]) > 0.0:
            notes += crown_notes(name, result.diagnostics, index)
    return tuple(notes)


def rolling_notes(joint: Joint, capacity: float, no_film: str | None = None) -> tuple[Note, ...]:
    """Whether a joint whose input turns rolls under its torque, up to a capacity [N·m], which may be less than at rest.

    Nothing without a torque. ``no_film``: why no oil film of it can be computed, None where it can.
    """
    torque = abs(float(joint.output_torque))
    if not (float(joint.input_speed) > 0.0 and torque > 0.0):
        return ()
    ratio = math.inf if capacity <= 0.0 else torque / capacity
    ok = ratio < 1.0
    beyond = (
        "the joint does not roll under its torque: a contact slips as a whole or lifts off, or the load is beyond "
        "what is computed"
    )
    remedy = "lower the torque, or raise the preload or the friction coefficient"
    if no_film is not None:
        beyond, remedy = f"no steady rolling can be computed: {no_film}", FILM_REMEDY
    return (
        Note(
            "rolling_torque_ratio",
            "torque over rolling capacity",
            None,
            ratio,
            1.0,
            ok,
            "function",
            "the joint rolls under its torque without gross slip" if ok else beyond,
            None if ok else remedy,
            used=("torque", "rolling capacity"),
        ),
    )


def loss_notes(rolling: RollingResult, contacts: tuple[str, ...]) -> tuple[Note, ...]:
    """Whether a drive under load loses more than a third of its power."""
    power = rolling.power
    entering, leaving = float(np.asarray(power.input)), float(np.asarray(power.output))
    if not (entering > 0.0 and leaving > 0.0):
        return ()
    share = 1.0 - leaving / entering
    ok = share <= LOSS_LIMIT
    by_cause = {name: float(np.asarray(value)) for name, value in losses(rolling).items() if name in _CAUSES}
    cause = max(by_cause, key=lambda name: np.nan_to_num(by_cause[name]))
    words, remedy = _CAUSES[cause]
    if cause == "oil":
        remedy = _less_oil_loss(np.asarray(rolling.film_ratio), remedy)
    where = ""
    if cause != "bearings":
        by_contact = np.asarray(getattr(power, cause))
        where = f", most at {contacts[int(np.argmax(by_contact))]}"
    of, all_of = format_quantity(by_cause[cause], "W"), format_quantity(entering, "W")
    return (
        Note(
            "loss_share",
            "share of the input power lost",
            None,
            share,
            LOSS_LIMIT,
            ok,
            "state",
            "most of the power reaches the output"
            if ok
            else f"{format_quantity(entering - leaving, 'W')} of the {all_of} input power are lost, {of} of them by "
            f"{words}{where}",
            None if ok else remedy,
            state="" if ok else "large losses",
            upper=True,
        ),
    )


def _less_oil_loss(film_ratios: np.ndarray, remedy: str) -> str:
    """What makes the loss of the oil smaller without costing life, by the ratios of the films to the roughness."""
    known = film_ratios[np.isfinite(film_ratios)]
    if not known.size:
        return remedy
    least = float(known.min())
    if film_band(least) == "full":
        return f"{remedy}; keep λ above {FULL_FILM:g}, below which the life falls"
    return (
        "use the drive for more torque, or make the surfaces smoother and only then the oil thinner: at "
        f"λ {format_quantity(least, '1', 2)} a thinner oil or a lower speed shortens the life"
    )


def skew_notes(rolling: RollingResult, contacts: tuple[str, ...]) -> tuple[Note, ...]:
    """Whether skewed axes leave every contact the friction for its traction."""
    ratios, lost = np.asarray(rolling.slip_ratio), np.asarray(rolling.capacity_loss)
    # where skew alone takes all friction, the contact slips whatever its traction
    ratios = np.where(lost >= 1.0, np.inf, ratios)
    if not np.any(lost > 0.0) or np.any(np.isnan(ratios)):
        return ()
    worst = int(np.argmax(ratios))
    ok = bool(ratios[worst] < 1.0)
    return (
        Note(
            "slip_ratio_with_skew",
            "traction over the friction left by skew, in rolling",
            contacts[worst],
            float(ratios[worst]),
            1.0,
            ok,
            "function",
            "skew leaves enough friction for the traction"
            if ok
            else "skew uses so much friction that the contact slips as a whole: under torque the drift is far larger",
            None if ok else "align the axes, raise the preload, or lower the torque",
        ),
    )

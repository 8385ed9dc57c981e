"""Notes on a drive that turns: how much of its power is lost, and whether skew leaves it enough friction."""

from __future__ import annotations

import numpy as np

from asperity.results.contact_notes import Note
from asperity.rolling.document import losses
from asperity.rolling.rolling import RollingResult
from asperity.units import format_quantity

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


def loss_notes(found: RollingResult, contacts: tuple[str, ...]) -> tuple[Note, ...]:
    """Whether a drive under load loses more than a third of its power."""
    power = found.power
    entering, leaving = float(np.asarray(power.input)), float(np.asarray(power.output))
    if not (entering > 0.0 and leaving > 0.0):
        return ()
    share = 1.0 - leaving / entering
    ok = share <= LOSS_LIMIT
    by_cause = {name: float(np.asarray(value)) for name, value in losses(found).items() if name in _CAUSES}
    cause = max(by_cause, key=lambda name: np.nan_to_num(by_cause[name]))
    words, remedy = _CAUSES[cause]
    where = ""
    if cause != "bearings":
        each = np.asarray(getattr(power, cause))
        where = f", most at {contacts[int(np.argmax(each))]}"
    of, all_of = format_quantity(by_cause[cause], "W"), format_quantity(entering, "W")
    return (
        Note(
            "loss_share",
            "share of the power that is lost",
            None,
            share,
            LOSS_LIMIT,
            ok,
            "function",
            "most of the power reaches the output"
            if ok
            else f"of {all_of} that enter, {format_quantity(entering - leaving, 'W')} are lost, {of} of them by {words}"
            f"{where}",
            None if ok else remedy,
        ),
    )


def skew_notes(found: RollingResult, contacts: tuple[str, ...]) -> tuple[Note, ...]:
    """Whether skewed axes leave every contact the friction for its traction."""
    ratios, lost = np.asarray(found.slip_ratio), np.asarray(found.capacity_loss)
    # where skew alone takes all friction, the contact slips whatever its traction
    ratios = np.where(lost >= 1.0, np.inf, ratios)
    if not np.any(lost > 0.0) or np.any(np.isnan(ratios)):
        return ()
    worst = int(np.argmax(ratios))
    ok = bool(ratios[worst] < 1.0)
    return (
        Note(
            "slip_ratio_with_skew",
            "traction over the friction that skew leaves, in rolling",
            contacts[worst],
            float(ratios[worst]),
            1.0,
            ok,
            "function",
            "friction remains beside what skew takes"
            if ok
            else "skew takes so much friction that the contact slips as a whole: under a torque it drifts far more",
            None if ok else "align the axes, raise the preload, or lower the torque",
        ),
    )

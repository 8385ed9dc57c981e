"""A calibration in a script: estimates with intervals and units, the calibrated joint, a picture."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity
from asperity.api.shown import Shown, displayed, frame
from asperity.errors import InputError
from asperity.results import LEVELS, known_result
from asperity.standing.windup import StiffnessLevel
from asperity.study.calibration.calibrate import (
    MODEL_ERROR,
    Calibration,
    bound_words,
    calibrate_files,
    calibrated_text,
)
from asperity.study.calibration.calibration_plot import calibration_figure
from asperity.study.calibration.posterior import posterior, require_numpyro
from asperity.study.calibration.torque_history import History
from asperity.study.calibration.unknowns import dimension_of, unit_of
from asperity.units import from_si
from asperity.views.blocks import Block
from asperity.views.calibration import calibration as calibration_shown

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

    from asperity.study.calibration.posterior import Posterior


def calibrate(
    joint: DescribedJoint,
    data: str | Path | Sequence[str | Path],
    unknowns: Sequence[str],
    *,
    level: StiffnessLevel = "assembly",
    history: History = "virgin",
    starts: int = 4,
    seed: int = 1,
    model_error: float = MODEL_ERROR,
) -> CalibratedJoint:
    """Fit numbers of a joint to a measured curve, or to a curve at rest and a drift curve together.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`; its numbers are the first guess.
    data : str, Path or sequence of them
        CSV file with columns torque and one of angle, stiffness, drift, speed loss or speed ratio, with units in the
        header; or two such files.
    unknowns : sequence of str
        Numbers of the file, or offset, drift, offset of drift; with bounds as ``"load.preload=500 N:2000 N"``.
    level : {"assembly", "series_with_bulk", "published"}, optional
        Stiffness that is fitted.
    history : {"virgin", "cycled"}, optional
        Joint before the first row: never loaded, or cycled to the largest torque.
    starts : int, optional
        Starts of the search.
    seed : int, optional
        Of the starts.
    model_error : float, optional
        Standard deviation of the relative error of the joint's compliance, 0 for the scatter of the data alone [-].

    Returns
    -------
    CalibratedJoint
        Estimates with 95 % intervals; ``joint`` is the calibrated joint.

    Raises
    ------
    InputError
        If data or unknowns cannot be read or make no sense.
    NoSolutionError
        If no start of the search ends at a fit.
    """
    require_joint(joint)
    known_result(level, among=LEVELS, what="level of the stiffness")
    known_result(history, among=("virgin", "cycled"), what="history")
    if isinstance(unknowns, str):
        raise InputError(f"the unknowns are a list, e.g. ['{unknowns}']")
    files = [data] if isinstance(data, str | Path) else list(data)
    if not files:
        raise InputError("no data: name at least one CSV file")
    options = {"level": level, "history": history, "starts": starts, "seed": seed, "model_error": model_error}
    return CalibratedJoint(joint, calibrate_files(joint.case, files, unknowns, **options))


class CalibratedJoint(Shown):
    """The outcome of a calibration: ``found["load.preload"]`` is an estimate with its unit.

    Parameters
    ----------
    start : DescribedJoint
        The joint before.
    calibration : Calibration
        The fit, in SI units.
    """

    def __init__(self, start: DescribedJoint, calibration: Calibration) -> None:
        self.start, self.calibration = start, calibration
        self._estimates = {estimate.path: estimate for estimate in calibration.estimates}

    @property
    def joint(self) -> DescribedJoint:
        """The joint with the estimates in place of its numbers."""
        return self.start.edited(calibrated_text(self.calibration, self.start.case, comment=""))

    def __getitem__(self, name: str) -> NamedQuantity:
        """One estimate; an ``InputError`` where the search ended at a bound, which is no fitted value."""
        path = known_result(name, among=tuple(self._estimates), what="unknown")
        if path in (ended := bound_words(self.calibration)):
            raise InputError(ended[path])
        return self._quantities()[path]

    def keys(self) -> list[str]:
        """Names of the unknowns."""
        return list(self._estimates)

    def _quantities(self) -> dict[str, NamedQuantity]:
        quantities = {}
        for path, estimate in self._estimates.items():
            quantities[path] = NamedQuantity(path, path, estimate.value, dimension_of(path), unit_of(path))
        return quantities

    def to_frame(self) -> pandas.DataFrame:
        """The estimates as a pandas data frame: value, ends of the 95 % interval and unit, and whether determined.

        Where the search ended at a bound, ``bound`` has it and ``value`` is nan.
        """
        estimates, units = list(self._estimates.values()), [unit_of(path) for path in self._estimates]
        columns: dict[str, list[object]] = {
            title: [from_si(getattr(e, title), unit) for e, unit in zip(estimates, units, strict=True)]
            for title in ("value", "lower", "upper")
        }
        ended = [bool(estimate.at_bound) for estimate in estimates]
        columns["bound"] = [v if end else math.nan for v, end in zip(columns["value"], ended, strict=True)]
        columns["value"] = [math.nan if end else v for v, end in zip(columns["value"], ended, strict=True)]
        columns["unit"] = list(units)
        columns["determined"] = [estimate.determined for estimate in estimates]
        return frame(columns, index=list(self._estimates), index_name="unknown")

    def posterior(self, draws: int, *, seed: int = 1) -> Posterior:
        """Draws from the posterior of the unknowns; needs the extra ``bayes`` and takes minutes.

        Parameters
        ----------
        draws : int
            Draws of each of four chains.
        seed : int, optional
            Of the draws.
        """
        require_numpyro()
        return posterior(self.calibration, draws=draws, seed=seed)

    def plot(self) -> Figure:
        """Draw data, fit and residuals; a notebook shows the figure, elsewhere call its ``savefig``."""
        return displayed(calibration_figure(self.calibration))

    def blocks(self) -> list[Block]:
        """What ``asperity calibrate`` prints."""
        return list(calibration_shown(self.calibration))

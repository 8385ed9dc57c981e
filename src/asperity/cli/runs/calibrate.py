"""What the command of :mod:`asperity.cli.calibrate` does."""

from __future__ import annotations

import math
from dataclasses import asdict

from asperity.cli.joint_input import FELT_UNDER_TORQUE, read_case_of_branches
from asperity.cli.options import read_option
from asperity.cli.progress import progress_bar
from asperity.cli.terminal import about, print_json, save_image, say_written, show_blocks
from asperity.errors import InputError
from asperity.made_files import CALIBRATED_BY, MADE_JOINT
from asperity.standing.windup import StiffnessLevel
from asperity.study.calibration.calibrate import Calibration, Estimate, calibrate_files, calibrated_text
from asperity.study.calibration.calibration_plot import calibration_figure, posterior_figure
from asperity.study.calibration.fitted_curve import FittedCurve
from asperity.study.calibration.posterior import Posterior, posterior, require_numpyro
from asperity.study.calibration.torque_history import History
from asperity.study.calibration.unknowns import si_unit_of
from asperity.unit_table import Dimension
from asperity.views.calibration import calibration as fit_blocks
from asperity.views.calibration import posterior as drawn_blocks
from asperity.views.calibration import quantiles
from asperity.writing import check_apart, check_file, check_image, write_text


def calibrate(
    file: str,
    data: tuple[str, ...],
    unknowns: tuple[str, ...],
    level: StiffnessLevel,
    history: History,
    model_error: str,
    starts: int,
    seed: int,
    out: str | None,
    plot: str | None,
    draws: int | None,
    plot_posterior: str | None,
    as_json: bool,
) -> None:
    """What ``asperity calibrate`` does; its options stand in :mod:`asperity.cli.calibrate`."""
    check_apart(out=out, plot=plot, plot_posterior=plot_posterior)
    check_image(plot, file, *data)
    check_image(plot_posterior, file, *data)
    check_file(out, file, *data, kind=MADE_JOINT)
    if plot_posterior is not None and draws is None:
        raise InputError("--plot-posterior needs --posterior DRAWS, e.g. --posterior 1000")
    error_of_model = read_option("model-error", model_error, Dimension.DIMENSIONLESS)
    case = read_case_of_branches(file)
    if draws is not None:
        require_numpyro()
    with progress_bar("starts") as report, about(file, *data):
        calibration = calibrate_files(
            case,
            data,
            unknowns,
            level=level,
            history=history,
            model_error=error_of_model,
            starts=starts,
            seed=seed,
            progress=report,
        )
    drawn = None
    if draws is not None:
        with progress_bar("steps of the posterior") as report, about(file, *data):
            drawn = posterior(calibration, draws=draws, seed=seed, progress=report)
    if out is not None:  # files first: whoever reads the tables may close the pipe
        measured = [curve.measurement for curve in calibration.curves]
        fitted = [f"{level} stiffness" if curve.drift is None else "drift" for curve in measured]
        comment = f"{CALIBRATED_BY}: {file} from {' and '.join(data)}, {' and '.join(fitted)}."
        write_text(calibrated_text(calibration, case, comment=comment), out, kind=MADE_JOINT)
        say_written(out)
    if plot is not None:
        save_image(calibration_figure(calibration), plot)
    if plot_posterior is not None and drawn is not None:
        save_image(posterior_figure(calibration, drawn), plot_posterior)
    if as_json:
        felt = {"assumptions": [FELT_UNDER_TORQUE]} if case.measured and case.measured.heights else {}
        print_json(_document(calibration, drawn) | felt)
    else:
        show_blocks(*fit_blocks(calibration), *([] if drawn is None else drawn_blocks(drawn, calibration)))


def _document(calibration: Calibration, drawn: Posterior | None) -> dict[str, object]:
    """Everything that a calibration has found, in SI units."""
    document: dict[str, object] = {
        "estimates": [_estimate(estimate) for estimate in calibration.estimates],
        "directions": [
            {**asdict(direction), "standard_deviation": min(direction.standard_deviation, 1e300)}
            for direction in calibration.directions
        ],
        "model_error": calibration.model_error,
        "alternatives": [asdict(alternative) for alternative in calibration.alternatives],
        "covariance_of_scaled_values": calibration.covariance.tolist(),
        "curves": [_curve(curve) for curve in calibration.curves],
        "relative_rms_of_starts": [float(rms) for rms in calibration.starts],
    }
    return document if drawn is None else document | _posterior(calibration, drawn)


def _estimate(estimate: Estimate) -> dict[str, object]:
    """One unknown; null for what is not finite, and for the value of one that ends at a bound."""
    stated = {
        **asdict(estimate),
        "value": math.nan if estimate.at_bound else estimate.value,
        "bound": estimate.value if estimate.at_bound else math.nan,
        "unit": si_unit_of(estimate.path),
    }
    return {
        name: None if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in stated.items()
    }


def _curve(curve: FittedCurve) -> dict[str, object]:
    """How one measured curve is met."""
    unit = curve.measurement.quantity.si_unit
    scatter = curve.scatter
    return {
        "source": curve.measurement.source,
        "quantity": curve.measurement.quantity.name,
        "rows": curve.residual.size,
        "residual_standard_deviation": {"value": curve.standard_deviation, "unit": unit},
        "durbin_watson": curve.durbin_watson,
        "own_scatter": None
        if scatter is None
        else {"value": scatter.deviation, "degrees_of_freedom": scatter.freedom, "unit": unit},
        "misfit_beyond_scatter": {
            "value": curve.misfit,
            "of_curve": curve.misfit / curve.size if curve.misfit else 0.0,
            "unit": unit,
        },
    }


def _posterior(calibration: Calibration, drawn: Posterior) -> dict[str, object]:
    """What the draws say of each unknown and of the errors, and how well they have mixed."""
    return {
        "posterior": {
            unknown.path: {
                "quantiles": quantiles(unknown.from_unit(drawn.scaled_values[:, i])),
                "unit": si_unit_of(unknown.path),
                "note": drawn.note(i),
                "r_hat": float(drawn.r_hat[i]),
                "effective_draws": float(drawn.effective_draws[i]),
            }
            for i, unknown in enumerate(calibration.unknowns)
        },
        "posterior_standard_deviation_of_errors": {
            "quantiles": quantiles(drawn.standard_deviation),
            "unit": calibration.curves[0].measurement.quantity.si_unit,
            "r_hat": float(drawn.r_hat[-1]),
            "effective_draws": float(drawn.effective_draws[-1]),
        },
        "posterior_draws": len(drawn.scaled_values),
        "posterior_divergences": drawn.divergences,
        "posterior_acceptance": drawn.acceptance,
    }

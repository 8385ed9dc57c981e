"""``asperity calibrate``: unknowns of a joint from measured curves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import (
    FELT_UNDER_TORQUE,
    json_option,
    prepare_computation,
    print_json,
    read_option,
    save_image,
    say_written,
    show_blocks,
)
from asperity.made_files import CALIBRATED_BY, MADE_JOINT
from asperity.unit_table import Dimension
from asperity.writing import check_apart, check_file, check_image, write_text

if TYPE_CHECKING:
    from asperity.study.calibration.calibrate import Calibration
    from asperity.study.calibration.posterior import Posterior


@click.command()
@click.argument("file", type=click.Path())
@click.argument("data", type=click.Path(), nargs=-1, required=True)
@click.option("-u", "--unknown", "unknowns", multiple=True, required=True, metavar="KEY[=LOWER:UPPER]",
              help="A number of FILE, for example play.angle, or offset, drift; repeat for several.")  # fmt: skip
@click.option("--level", default="assembly", show_default=True,
              type=click.Choice(["published", "series_with_bulk", "assembly"]),
              help="Stiffness that is fitted.")  # fmt: skip
@click.option("--history", default="virgin", show_default=True, type=click.Choice(["virgin", "cycled"]),
              help="Joint before the first row: never loaded, or cycled to the largest torque.")  # fmt: skip
@click.option("--model-error", default="5 %", show_default=True,
              help="Standard deviation of the joint's compliance by the model; 0 for the scatter alone.")  # fmt: skip
@click.option(
    "--starts", default=4, show_default=True, type=click.IntRange(1, 1000), help="Starts of the search."
)
@click.option("--seed", default=1, show_default=True, type=click.IntRange(0), help="Of starts and draws.")
@click.option("--out", type=click.Path(), help="Write the calibrated joint as a joint file.")
@click.option("--plot", type=click.Path(), help="Draw data, fit and residuals (.png, .svg, .pdf).")
@click.option("--posterior", "draws", type=click.IntRange(50, 100000), metavar="DRAWS",
              help="Also draw from the posterior, this number from each of four chains (extra 'bayes').")  # fmt: skip
@click.option("--plot-posterior", type=click.Path(), help="Draw the posterior (.png, .svg, .pdf).")
@json_option()
def calibrate(
    file: str,
    data: tuple[str, ...],
    unknowns: tuple[str, ...],
    level: Any,
    history: Any,
    model_error: str,
    starts: int,
    seed: int,
    out: str | None,
    plot: str | None,
    draws: int | None,
    plot_posterior: str | None,
    as_json: bool,
) -> None:
    """Fit numbers of the joint file FILE to the measured curve DATA, or to two curves together.

    DATA is a CSV file with a column torque and one of angle, stiffness, drift (angle lost per output turn), speed loss
    or speed ratio (input over output), if wanted time and repetition; units in the header, e.g. 'torque [N*m]',
    'angle [arcmin]', 'drift [arcmin/turn]', 'speed loss [%]'. Rows in the order of time: the hysteresis of a
    torque-angle curve follows the history. A curve of the joint at rest and a drift curve can be fitted together:
    give both files; 'offset of drift' is then the offset of the drift curve.

    A misfit beyond the curve's own scatter, and an unknown that ends at a bound, are said; a fit that leaves a quarter
    of the curve unexplained ends with exit code 3.
    """
    from asperity.cli.terminal import about, progress_bar, read_case_of_branches
    from asperity.errors import InputError

    check_apart(out=out, plot=plot, plot_posterior=plot_posterior)
    check_image(plot, file, *data)
    check_image(plot_posterior, file, *data)
    check_file(out, file, *data, kind=MADE_JOINT)
    if plot_posterior is not None and draws is None:
        raise InputError("--plot-posterior needs --posterior DRAWS, e.g. --posterior 1000")
    error_of_model = read_option("model-error", model_error, Dimension.DIMENSIONLESS)
    case = read_case_of_branches(file)
    prepare_computation()
    from asperity.study.calibration.calibrate import calibrate_files, calibrated_text
    from asperity.study.calibration.posterior import posterior, require_numpyro

    if draws is not None:
        require_numpyro()
    options = {"level": level, "history": history, "starts": starts, "seed": seed}
    with progress_bar("starts") as report, about(file, *data):
        calibration = calibrate_files(
            case, data, unknowns, **options, model_error=error_of_model, progress=report
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
    from asperity.study.calibration.calibration_plot import calibration_figure, posterior_figure

    if plot is not None:
        save_image(calibration_figure(calibration), plot)
    if plot_posterior is not None and drawn is not None:
        save_image(posterior_figure(calibration, drawn), plot_posterior)
    if as_json:
        felt = {"assumptions": [FELT_UNDER_TORQUE]} if case.measured and case.measured.heights else {}
        print_json(_document(calibration, drawn) | felt)
    else:
        from asperity.views.calibration import calibration as fit_blocks
        from asperity.views.calibration import posterior as drawn_blocks

        show_blocks(*fit_blocks(calibration), *([] if drawn is None else drawn_blocks(drawn, calibration)))


def _document(calibration: Calibration, drawn: Posterior | None) -> dict[str, Any]:
    import math
    from dataclasses import asdict

    from asperity.study.calibration.unknowns import si_unit_of
    from asperity.views.calibration import quantiles

    document: dict[str, Any] = {
        "estimates": [
            {
                k: (None if isinstance(v, float) and not math.isfinite(v) else v)
                for k, v in {
                    **asdict(estimate),
                    "value": math.nan if estimate.at_bound else estimate.value,
                    "bound": estimate.value if estimate.at_bound else math.nan,
                    "unit": si_unit_of(estimate.path),
                }.items()
            }
            for estimate in calibration.estimates
        ],
        "directions": [
            {**asdict(direction), "standard_deviation": min(direction.standard_deviation, 1e300)}
            for direction in calibration.directions
        ],
        "model_error": calibration.model_error,
        "alternatives": [asdict(alternative) for alternative in calibration.alternatives],
        "covariance_of_scaled_values": calibration.covariance.tolist(),
        "curves": [
            {
                "source": curve.measurement.source,
                "quantity": curve.measurement.quantity.name,
                "rows": curve.residual.size,
                "residual_standard_deviation": {
                    "value": curve.standard_deviation,
                    "unit": curve.measurement.quantity.si_unit,
                },
                "durbin_watson": curve.durbin_watson,
                "own_scatter": None
                if curve.scatter is None
                else {
                    "value": curve.scatter.deviation,
                    "degrees_of_freedom": curve.scatter.freedom,
                    "unit": curve.measurement.quantity.si_unit,
                },
                "misfit_beyond_scatter": {
                    "value": curve.misfit,
                    "of_curve": curve.misfit / curve.size if curve.misfit else 0.0,
                    "unit": curve.measurement.quantity.si_unit,
                },
            }
            for curve in calibration.curves
        ],
        "relative_rms_of_starts": [float(rms) for rms in calibration.starts],
    }
    if drawn is not None:
        document["posterior"] = {
            unknown.path: {
                "quantiles": quantiles(unknown.from_unit(drawn.scaled_values[:, i])),
                "unit": si_unit_of(unknown.path),
                "note": drawn.note(i),
                "r_hat": float(drawn.r_hat[i]),
                "effective_draws": float(drawn.effective_draws[i]),
            }
            for i, unknown in enumerate(calibration.unknowns)
        }
        document["posterior_standard_deviation_of_errors"] = {
            "quantiles": quantiles(drawn.standard_deviation),
            "unit": calibration.curves[0].measurement.quantity.si_unit,
            "r_hat": float(drawn.r_hat[-1]),
            "effective_draws": float(drawn.effective_draws[-1]),
        }
        document["posterior_draws"] = len(drawn.scaled_values)
        document["posterior_divergences"] = drawn.divergences
        document["posterior_acceptance"] = drawn.acceptance
    return document

"""The posterior against a linear model whose posterior is known, and against sums over a grid for the real joint."""

import json
from dataclasses import replace

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import logsumexp

from asperity.cli.calibrate import _document, _show
from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.reader import read_case
from asperity.study.calibration.calibrate import calibrate
from asperity.study.calibration.calibration_plot import posterior_figure
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.posterior import Posterior, posterior, sample
from asperity.study.calibration.unknowns import read_unknowns

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")
SHARES = (0.025, 0.16, 0.5, 0.84, 0.975)

DESIGN = np.stack([np.ones(60), np.linspace(-1.0, 1.0, 60)], axis=1)
DATA = DESIGN @ np.array([0.5, 0.4]) + 0.05 * np.random.default_rng(0).standard_normal(60)
FIT, *_ = np.linalg.lstsq(DESIGN, DATA, rcond=None)
DEVIATION = float(np.sqrt(np.sum((DATA - DESIGN @ FIT) ** 2) / 58))
COVARIANCE = DEVIATION**2 * np.linalg.inv(DESIGN.T @ DESIGN)


def sampled(shift, draws):
    """Draws for the linear model with a surrogate that is shifted."""
    pytest.importorskip("numpyro")
    return sample(
        predict=lambda places: places @ DESIGN.T,
        surrogate=lambda fitted, places: jnp.asarray(DESIGN) @ (places + fitted),
        fit=lambda centre, covariance: jnp.asarray(shift),
        data=DATA,
        first=FIT,
        covariance=COVARIANCE,
        first_deviation=DEVIATION,
        draws=draws,
        warmup=200,
        chains=4,
        seed=0,
    )


def test_linear_model():
    found = sampled(np.zeros(2), draws=300)
    expected = np.sqrt(np.diag(COVARIANCE))  # t with 58 degrees of freedom, nearly
    assert found.places.shape == (1200, 2)
    assert found.places.mean(axis=0) == pytest.approx(FIT, abs=0.15 * expected.max())
    assert found.places.std(axis=0) == pytest.approx(expected, rel=0.15)
    # with a prior uniform in ln s, (n − 2) s0²/s² has the chi-square law of n − 2 degrees of freedom
    assert np.median(found.standard_deviation) == pytest.approx(DEVIATION, rel=0.03)
    assert found.standard_deviation.std() == pytest.approx(DEVIATION / np.sqrt(2 * 58), rel=0.15)
    assert np.all(found.r_hat < 1.05)
    assert found.divergences == 0
    assert found.acceptance == 1.0


def test_hopeless_surrogate_is_refused():
    with pytest.raises(NoSolutionError, match="have not converged"):
        sampled(np.array([0.2, 0.0]), draws=50)


def quantiles(values, log_density):
    """Quantiles of a density on an even grid."""
    weight = np.exp(log_density - log_density.max())
    cumulative = np.concatenate([[0.0], np.cumsum(0.5 * (weight[1:] + weight[:-1]))])
    return np.interp(SHARES, cumulative / cumulative[-1], values)


def log_posterior(squares, rows, deviation):
    """Logarithm of the posterior after the size of the errors, uniform in its logarithm, is summed over."""
    log_s = np.log(deviation) + np.linspace(-np.log(10.0), np.log(10.0), 81)
    return logsumexp(-rows * log_s - 0.5 * squares[..., None] * np.exp(-2.0 * log_s), axis=-1)


def calibrated(zou_file, torque, angle, texts):
    data = Measurement(torque, angle, None, None, np.zeros(torque.size), "synthetic")
    case = read_case(zou_file)
    unknowns = read_unknowns(texts, case=case, measurement=data)
    return calibrate(
        case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin", starts=1, seed=0
    )


@pytest.fixture(scope="module")
def cut_joint(zou_file):
    """Preload just above its lower bound, with play over a torque that few rows resolve."""
    torque = np.array([0.3, 1.0, 2.0, 4.0, 6.0, 8.0, 9.0, 5.0, 1.0, 0.5, -0.5, -3.0, -7.0, -9.0, -2.0, 0.4])
    texts = ("load.preload=940 N:3000 N", "play=0 arcmin:1 arcmin", "play_torque=0.1 N*m:5 N*m")
    angle = np.linspace(1e-5, 2e-5, torque.size)
    model: CurveModel = calibrated(zou_file, torque, angle, texts).model
    angle = model(np.array([model.unknowns[0].to_unit(945.0), 0.1, 0.3]))[0]
    angle = angle + 3e-6 * np.random.default_rng(4).standard_normal(torque.size)
    return calibrated(zou_file, torque, angle, texts)


@pytest.fixture(scope="module")
def drawn(cut_joint):
    pytest.importorskip("numpyro")
    seen = []
    found = posterior(cut_joint, draws=300, seed=1, progress=lambda done, total: seen.append((done, total)))
    assert seen[-1][0] == seen[-1][1] == len(seen)
    return found


def test_joint_cut_by_bounds(cut_joint, drawn):
    model, data = cut_joint.model, cut_joint.model.measurement
    preload, play, width = np.linspace(0.0, 0.4, 41), np.linspace(0.0, 0.3, 76), np.linspace(0.0, 1.0, 51)
    side = np.tanh(data.torque / (0.1 * 50.0 ** width[:, None]))
    added = 0.5 * np.pi / 180.0 / 60.0 * play[:, None, None] * side
    density = np.empty((preload.size, play.size, width.size))
    for index, place in enumerate(preload):
        squares = np.sum((model(np.array([place, 0.0, 0.5]))[0] + added - data.angle) ** 2, axis=-1)
        density[index] = log_posterior(squares, data.torque.size, cut_joint.standard_deviation)
    found = np.quantile(drawn.places, SHARES, axis=0).T
    for index, grid in enumerate((preload, play, width)):
        others = tuple(axis for axis in range(3) if axis != index)
        expected = quantiles(grid, logsumexp(density, axis=others))
        assert found[index] == pytest.approx(expected, abs=0.2 * (expected[3] - expected[1]))
    assert drawn.note(0) == "cut by lower bound"
    assert "lower bound" in drawn.note(2)
    assert drawn.note(1) == ""
    assert drawn.acceptance > 0.95


def test_figure(cut_joint, drawn):
    figure = posterior_figure(cut_joint, drawn)
    panels = figure.axes
    assert len(panels) == 9
    assert panels[6].get_xlabel() == "load,\npreload [N]"
    assert panels[7].get_xlabel() == "play [arcmin]"


def test_document_and_tables(cut_joint, drawn, capsys):
    # 940 N and 0.1 N·m are the lower bounds
    document = json.loads(json.dumps(_document(cut_joint, drawn), allow_nan=False))
    preload, width = document["posterior"]["load.preload"], document["posterior"]["play_torque"]
    assert (preload["unit"], width["unit"]) == ("N", "N*m")
    assert 940.0 < preload["quantiles"]["0.025"] < preload["quantiles"]["0.975"] < 1500.0
    assert 0.1 < width["quantiles"]["0.025"] < 0.2
    assert document["estimates"][1]["unit"] == "rad"
    errors = document["posterior_standard_deviation_of_errors"]
    assert errors["unit"] == "rad"
    assert errors["quantiles"]["0.025"] < 3e-6 < errors["quantiles"]["0.975"]
    _show(cut_joint, drawn)
    assert "load.preload: cut by lower bound" in capsys.readouterr().out


def test_exact_data_have_no_posterior(cut_joint):
    with pytest.raises(InputError, match="say nothing about errors"):
        posterior(replace(cut_joint, standard_deviation=0.0), draws=50, seed=0)


def test_unknown_that_the_data_do_not_tell_fills_its_bounds():
    rng = np.random.default_rng(0)
    places = np.stack([rng.random(4000), 0.5 + 0.01 * rng.standard_normal(4000)], axis=1)
    nothing = np.ones(3)
    found = Posterior(places, np.ones(4000), nothing, nothing, 0, 1.0)
    assert found.note(0) == "fills its bounds"
    assert found.note(1) == ""

"""The posterior against a linear model whose posterior is known, and against sums over a grid for the real joint."""

import dataclasses
import json
from dataclasses import replace
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest
from calibrated import calibrated
from scipy.special import logsumexp
from scipy.stats import chi2, norm

from asperity.cli.runs.calibrate import _document
from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.reader import read_case
from asperity.study.calibration import posterior as module
from asperity.study.calibration.calibration_plot import posterior_figure
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.posterior import (
    CUT_SHARE,
    Posterior,
    _begins,
    _capped,
    _where_likely,
    posterior,
    sample,
    shifted,
)
from asperity.views.calibration import posterior as posterior_blocks

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")
SHARES = (0.025, 0.16, 0.5, 0.84, 0.975)
#: By so much the sums over the grid move a share.
GRID_ERROR = 0.01

DESIGN = np.stack([np.ones(60), np.linspace(-1.0, 1.0, 60)], axis=1)
DATA = DESIGN @ np.array([0.5, 0.4]) + 0.05 * np.random.default_rng(0).standard_normal(60)
FIT, *_ = np.linalg.lstsq(DESIGN, DATA, rcond=None)
DEVIATION = float(np.sqrt(np.sum((DATA - DESIGN @ FIT) ** 2) / 58))
COVARIANCE = DEVIATION**2 * np.linalg.inv(DESIGN.T @ DESIGN)


def sampled(shift, draws):
    """Draws for the linear model with a surrogate that is shifted."""
    pytest.importorskip("numpyro")
    return sample(
        predict=lambda scaled_values: scaled_values @ DESIGN.T,
        surrogate=lambda fitted, scaled_values: jnp.asarray(DESIGN) @ (scaled_values + fitted),
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


@pytest.mark.long
def test_linear_model():
    found = sampled(np.zeros(2), draws=300)
    expected = np.sqrt(np.diag(COVARIANCE))  # t with 58 degrees of freedom, nearly
    assert found.scaled_values.shape == (1200, 2)
    effective = found.effective_draws[:2]
    standard_error = expected / np.sqrt(effective)
    assert np.all(np.abs(found.scaled_values.mean(axis=0) - FIT) < 4.0 * standard_error)
    # a standard deviation of n independent normal draws has the relative error 1/sqrt(2 n); squares mix more slowly
    assert np.all(np.abs(found.scaled_values.std(axis=0) / expected - 1.0) < 4.0 * np.sqrt(1.0 / effective))
    # with a prior uniform in ln s, (n − 2) s0²/s² has the chi-square law of n − 2 degrees of freedom
    exact = DEVIATION * np.sqrt(58 / chi2(58).median())
    for share, scaled_value in ((0.5, exact), (0.16, DEVIATION * np.sqrt(58 / chi2(58).ppf(0.84)))):
        below = found.standard_deviation < scaled_value
        assert np.mean(below) == pytest.approx(share, abs=4.0 * found.share_error(below))
    assert np.all(found.r_hat < 1.05)
    assert found.divergences == 0
    assert found.acceptance == 1.0


def test_error_of_the_model_moves_draws_within_their_bounds():
    """Far from the bounds, draws of one point scatter by the shift alone; next to one, by half of its normal law."""
    found = shifted(np.tile([0.5, 0.3, 0.6], (40_000, 1)), np.array([0.03, 0.0, -0.06]), seed=1)
    assert np.all(found[:, 1] == 0.3)
    np.testing.assert_allclose(found[:, 2] - 0.6, -2.0 * (found[:, 0] - 0.5), atol=1e-14)
    assert found[:, 0].mean() == pytest.approx(0.5, abs=4.0 * 0.03 / 200.0)
    assert found[:, 0].std() == pytest.approx(0.03, rel=4.0 / np.sqrt(80_000))
    half = shifted(np.tile([0.5, 1.0], (40_000, 1)), np.array([0.03, 0.06]), seed=1)
    assert half[:, 1].max() <= 1.0
    assert half[:, 0].mean() == pytest.approx(0.5 - 0.03 * np.sqrt(2.0 / np.pi), rel=1e-3)
    kept = np.array([[0.2, 1.0], [0.0, 0.4]])
    assert np.array_equal(shifted(kept, np.zeros(2), seed=1), kept)


def test_a_posterior_holds_the_error_of_its_calibration(monkeypatch):
    """Draws of one point scatter by what an error of one standard deviation moves."""
    same = Posterior(np.full((4000, 2), 0.5), np.ones(4000), np.ones(3), np.ones(3), 0, 1.0, 4)
    monkeypatch.setattr(module, "sample", lambda **_: same)
    monkeypatch.setattr(module, "surrogate_prediction", lambda model: None)
    curve = SimpleNamespace(
        model=SimpleNamespace(predictions=None),
        measurement=SimpleNamespace(measured=np.ones(3)),
        standard_deviation=0.1,
    )
    fitted = SimpleNamespace(
        curves=(curve,), scaled_values=None, covariance=None, model_shifts=np.array([[0.02], [0.0]])
    )
    found = posterior(fitted, draws=1000, seed=3).scaled_values
    assert found[:, 0].std() == pytest.approx(0.02, rel=4.0 / np.sqrt(8000))
    assert np.all(found[:, 1] == 0.5)


@pytest.mark.long
def test_hopeless_surrogate_is_refused():
    with pytest.raises(NoSolutionError, match="have not converged"):
        sampled(np.array([0.2, 0.0]), draws=50)


def quantiles(values, log_density, shares=SHARES):
    """Quantiles of a density on an even grid."""
    weight = np.exp(log_density - log_density.max())
    cumulative = np.concatenate([[0.0], np.cumsum(0.5 * (weight[1:] + weight[:-1]))])
    return np.interp(shares, cumulative / cumulative[-1], values)


def log_posterior(squares, rows, deviation):
    """Logarithm of the posterior after the size of the errors, uniform in its logarithm, is summed over."""
    log_s = np.log(deviation) + np.linspace(-np.log(10.0), np.log(10.0), 81)
    return logsumexp(-rows * log_s - 0.5 * squares[..., None] * np.exp(-2.0 * log_s), axis=-1)


def measured(torque, angle):
    return Measurement(torque, angle, None, None, np.zeros(torque.size), "synthetic")


@pytest.fixture(scope="module")
def cut_joint(zou_file):
    """Preload just above its lower bound, with play over a torque that few rows resolve."""
    torque = np.array([0.3, 1.0, 2.0, 4.0, 6.0, 8.0, 9.0, 5.0, 1.0, 0.5, -0.5, -3.0, -7.0, -9.0, -2.0, 0.4])
    texts = ("load.preload=940 N:3000 N", "play.angle=0 arcmin:1 arcmin", "play.take_up_torque=0.1 N*m:5 N*m")
    angle = np.linspace(1e-5, 2e-5, torque.size)
    case = read_case(zou_file)
    model: CurveModel = calibrated(case, (measured(torque, angle),), texts).curves[0].model
    angle = model(np.array([model.unknowns[0].to_unit(945.0), 0.1, 0.3]))[0]
    angle = angle + 3e-6 * np.random.default_rng(4).standard_normal(torque.size)
    return calibrated(case, (measured(torque, angle),), texts)


@pytest.fixture(scope="module")
def drawn(cut_joint):
    pytest.importorskip("numpyro")
    seen = []
    found = posterior(cut_joint, draws=300, seed=1, progress=lambda done, total: seen.append((done, total)))
    assert seen[-1][0] == seen[-1][1] == len(seen)
    return found


def assert_cut_as_the_density_says(drawn, index, grid, logarithm):
    """The note on a bound follows from the exact share of the posterior beside it, unless that is near the limit."""
    values = quantiles(grid, logarithm, np.linspace(0.0005, 0.9995, 1000))
    spread, note = float(np.std(values)), drawn.note(index)
    for side, near in (("lower", values < 0.1 * spread), ("upper", values > 1.0 - 0.1 * spread)):
        share = float(np.mean(near))
        error = np.sqrt(max(share, CUT_SHARE) / drawn.effective_draws[index])
        if share > CUT_SHARE + 8.0 * error:
            assert f"cut by {side}" in note
            assert "possibly" not in note
        elif share < CUT_SHARE - 8.0 * error:
            assert side not in note


class Independent:
    """Chains that step to independent draws around the fit, and accept a share of them."""

    accepts = 1.0

    def __init__(self, *, surrogate, exact, size, warmup, seed):
        self.surrogate, self.exact, self.random = surrogate, exact, np.random.default_rng(seed)
        self.starts, self.divergences = [], 0
        made.append(self)

    def start(self, given, begin, spread):
        self.starts.append((given, begin, spread))
        self.position = begin

    def forget(self):
        self.accepted = self.proposed = 0

    def warm_up(self):
        pass

    def begin_exactly(self):
        self.log_exact = self.exact(self.position)
        self.forget()

    def step(self):
        proposed = np.append(FIT, 0.5) + 0.01 * self.random.standard_normal(self.position.shape)
        found = self.exact(proposed)
        self.position, self.log_exact = proposed, found
        self.proposed += len(found)
        self.accepted += self.accepts * len(found)
        return proposed, found


made = []


def independent(monkeypatch, *, accepts=1.0, warmup=7):
    pytest.importorskip("numpyro")
    monkeypatch.setattr(module, "Chains", Independent)
    monkeypatch.setattr(Independent, "accepts", accepts)
    told = []
    found = sample(
        predict=lambda scaled_values: scaled_values @ DESIGN.T,
        surrogate=lambda fitted, scaled_values: jnp.asarray(DESIGN) @ (scaled_values + fitted),
        fit=lambda centre, covariance: np.array([0.02, 0.0]),
        data=DATA,
        first=FIT,
        covariance=COVARIANCE,
        first_deviation=DEVIATION,
        draws=100,
        warmup=warmup,
        chains=4,
        seed=0,
        progress=lambda done, total: told.append((done, total)),
    )
    return found, made[-1], told


def test_likelihood_is_that_of_normal_errors_of_any_size(monkeypatch):
    """The last coordinate is ln s from a tenth of the first standard deviation to ten times it."""
    found, chains, told = independent(monkeypatch)
    points = np.array([[*FIT, 0.5], [FIT[0] + 0.01, FIT[1], 0.3], [0.4, 0.6, 1.0]])

    def normal(shift):
        sizes = DEVIATION * 10.0 ** (2.0 * points[:, 2:] - 1.0)
        return norm.logpdf(DATA, (points[:, :2] + shift) @ DESIGN.T, sizes).sum(axis=1)

    np.testing.assert_allclose(np.diff(chains.exact(points)), np.diff(normal(0.0)), rtol=1e-10)
    given, begin, spread = chains.starts[0]
    ours = [float(chains.surrogate(given, jnp.asarray(point))) for point in points]
    np.testing.assert_allclose(np.diff(ours), np.diff(normal(np.array([0.02, 0.0]))), rtol=1e-10)
    # where they begin: ln s of n normal errors has the standard deviation 1/sqrt(2 n), here over 2 ln 10
    assert begin.shape == (4, 3)
    np.testing.assert_allclose(spread[:2, :2], COVARIANCE, rtol=1e-12)
    assert spread[2, 2] ** 0.5 == pytest.approx(1.0 / np.sqrt(120.0) / (2.0 * np.log(10.0)), rel=1e-12)
    assert len(chains.starts) == 1
    assert found.acceptance == 1.0
    assert told[-1] == (7 + module.PILOT + 100,) * 2
    assert len(told) == told[-1][0]
    assert found.scaled_values.shape == (400, 2)
    np.testing.assert_allclose(found.scaled_values.mean(axis=0), FIT, atol=0.003)
    assert np.log10(found.standard_deviation / DEVIATION).std() == pytest.approx(0.02, rel=0.2)


def test_a_surrogate_that_is_often_rejected_is_fitted_anew_where_the_joint_is_likely(monkeypatch):
    found, chains, told = independent(monkeypatch, accepts=0.7)
    assert len(chains.starts) == 1 + module.REFITS
    assert told[-1] == ((7 + module.PILOT) * (1 + module.REFITS) + 100,) * 2
    assert found.acceptance == pytest.approx(0.7)
    assert len(independent(monkeypatch, accepts=0.81)[1].starts) == 1


def test_the_likelier_half_says_where_to_go_on():
    points = np.array([[0.1, 0.2], [0.3, 0.1], [0.2, 0.4], [0.5, 0.6], [0.9, 0.9], [0.8, 0.7]])
    logarithm = np.array([-1.0, -2.0, -3.0, -4.0, -50.0, -np.inf])

    class Moving:
        position, log_exact = np.array([[0.15, 0.25], [0.7, 0.7]]), np.array([-2.5, -np.inf])

    centre, spread, begin = _where_likely([(points, logarithm)], Moving(), np.array([0.5, 0.5]), np.eye(2))
    half = np.array([[0.1, 0.2], [0.3, 0.1], [0.15, 0.25], [0.2, 0.4]])
    np.testing.assert_allclose(centre, half.mean(axis=0), rtol=1e-12)
    np.testing.assert_allclose(spread, np.cov(half.T), rtol=1e-12)
    assert begin.tolist() == [[0.15, 0.25], [0.5, 0.5]]
    few = _where_likely([(points[4:], logarithm[4:])], Moving(), np.array([0.5, 0.4]), np.eye(2))
    assert (few[0].tolist(), few[1].tolist()) == ([0.5, 0.4], [[0.25, 0.0], [0.0, 0.25]])


def test_no_direction_is_wider_than_the_bounds():
    """A uniform law from 0 to 1 has the standard deviation 1/sqrt(12)."""
    turned = np.array([[0.6, -0.8], [0.8, 0.6]])
    wide = turned @ np.diag([9.0, 0.01]) @ turned.T
    found = _capped(wide, 3.0)
    np.testing.assert_allclose(found[:2, :2], turned @ np.diag([1.0 / 12.0, 0.01]) @ turned.T, rtol=1e-12)
    assert found[2, 2] == pytest.approx(1.0 / 12.0)
    assert _capped(wide, 0.1)[2, 2] == pytest.approx(0.01)


def test_chains_begin_within_the_bounds_and_where_the_joint_exists():
    """A hundredth of the way from a bound to the fit at least; the closer to it, the fewer joints exist."""
    centre, spread = np.array([0.02, 0.9]), np.diag([1.0, 1.0])
    begin = _begins(lambda points: np.zeros(len(points)), centre, spread, 400, 0)
    assert begin.shape == (400, 2)
    assert begin.min(axis=0) == pytest.approx([2e-4, 9e-3], rel=1e-12)
    assert begin.max(axis=0) == pytest.approx([1.0 - 0.0098, 0.999], rel=1e-12)
    near = lambda points: np.where(np.abs(points - centre).max(axis=1) < 0.05, 0.0, -np.inf)  # noqa: E731
    assert np.abs(_begins(near, centre, spread, 8, 0) - centre).max() < 0.05
    with pytest.raises(NoSolutionError, match="no solution around the best fit"):
        _begins(lambda points: np.full(len(points), -np.inf), centre, spread, 4, 0)


def test_error_of_a_share_counts_the_effective_draws():
    """Of independent draws sqrt(p (1 - p)/n); where all agree that of one draw in the effective number."""
    pytest.importorskip("numpyro")
    made = Posterior(np.zeros((4000, 1)), np.ones(4000), np.ones(2), np.array([500.0, 800.0]), 0, 1.0, 4)
    inside = np.random.default_rng(2).random(4000) < 0.2
    assert made.share_error(inside) == pytest.approx(np.sqrt(0.16 / 4000.0), rel=0.1)
    assert made.share_error(np.ones(4000, bool)) == pytest.approx(1.0 / 500.0)
    assert made.share_error(np.zeros(4000, bool)) == pytest.approx(1.0 / 500.0)


def test_note_on_a_bound_is_certain_only_with_enough_draws():
    scaled_values = np.full((4000, 1), 0.5)
    scaled_values[:, 0] += 0.2 * np.sin(np.arange(4000))
    few, many = scaled_values.copy(), scaled_values.copy()
    few[::80], many[::10] = 1e-4, 1e-4  # 1.25 and 10 % of the draws at the lower bound; the limit is 1 %
    made = {
        "standard_deviation": np.ones(4000),
        "r_hat": np.ones(2),
        "effective_draws": np.full(2, 4000.0),
        "divergences": 0,
        "acceptance": 1.0,
        "chains": 4,
    }
    assert Posterior(scaled_values=scaled_values, **made).note(0) == ""
    assert Posterior(scaled_values=few, **made).note(0) == "possibly cut by lower bound: take more draws"
    assert Posterior(scaled_values=many, **made).note(0) == "cut by lower bound"


@pytest.mark.long
def test_joint_cut_by_bounds(cut_joint, drawn):
    model, data = cut_joint.curves[0].model, cut_joint.curves[0].model.measurement
    preload, play, width = np.linspace(0.0, 0.4, 41), np.linspace(0.0, 0.3, 76), np.linspace(0.0, 1.0, 51)
    side = np.tanh(data.torque / (0.1 * 50.0 ** width[:, None]))
    added = 0.5 * np.pi / 180.0 / 60.0 * play[:, None, None] * side
    density = np.empty((preload.size, play.size, width.size))
    for index, scaled_value in enumerate(preload):
        squares = np.sum((model(np.array([scaled_value, 0.0, 0.5]))[0] + added - data.angle) ** 2, axis=-1)
        density[index] = log_posterior(squares, data.torque.size, cut_joint.curves[0].standard_deviation)
    for index, grid in enumerate((preload, play, width)):
        others = tuple(axis for axis in range(3) if axis != index)
        logarithm = logsumexp(density, axis=others)
        # the share of draws below the true quantile is known but for its standard error, whatever CPU or seed
        for share, scaled_value in zip(SHARES, quantiles(grid, logarithm), strict=True):
            below = drawn.scaled_values[:, index] < scaled_value
            assert np.mean(below) == pytest.approx(share, abs=4.0 * drawn.share_error(below) + GRID_ERROR)
        assert_cut_as_the_density_says(drawn, index, grid, logarithm)
    assert drawn.acceptance > 0.95


@pytest.mark.long
def test_figure(cut_joint, drawn):
    figure = posterior_figure(cut_joint, drawn)
    panels = figure.axes
    assert len(panels) == 9
    assert panels[6].get_xlabel() == "load,\npreload [N]"
    assert panels[7].get_xlabel() == "play,\nangle [arcmin]"


@pytest.mark.long
def test_document_and_tables(cut_joint, drawn):
    # 940 N and 0.1 N·m are the lower bounds
    document = json.loads(json.dumps(_document(cut_joint, drawn), allow_nan=False))
    preload, width = document["posterior"]["load.preload"], document["posterior"]["play.take_up_torque"]
    assert (preload["unit"], width["unit"]) == ("N", "N*m")
    assert 940.0 < preload["quantiles"]["0.025"] < preload["quantiles"]["0.975"] < 1500.0
    assert 0.1 < width["quantiles"]["0.025"] < 0.2
    assert document["estimates"][1]["unit"] == "rad"
    errors = document["posterior_standard_deviation_of_errors"]
    assert errors["unit"] == "rad"
    assert errors["quantiles"]["0.025"] < 3e-6 < errors["quantiles"]["0.975"]
    at_bound = drawn.scaled_values.copy()
    at_bound[::3, 0] = 1e-4
    table, *notes, share = posterior_blocks(dataclasses.replace(drawn, scaled_values=at_bound), cut_joint)
    assert [row[0] for row in table.rows] == [*(each.path for each in cut_joint.unknowns), "size of errors"]
    middle = document["posterior"]["load.preload"]["quantiles"]["0.5"]
    untouched = next(iter(posterior_blocks(drawn, cut_joint)))
    assert untouched.rows[0][2] == f"{middle:.4g} N"
    (said,) = (note.text for note in notes)
    assert said.startswith("load.preload: cut by lower bound")
    assert "% of the proposals" in share.text


@pytest.mark.long
def test_exact_data_have_no_posterior(cut_joint):
    (curve,) = cut_joint.curves
    exact = replace(cut_joint, curves=(replace(curve, standard_deviation=0.0),))
    with pytest.raises(InputError, match="contain no information about errors"):
        posterior(exact, draws=50, seed=0)


@pytest.mark.slow
def test_unknown_that_the_data_do_not_tell_fills_its_bounds():
    rng = np.random.default_rng(0)
    scaled_values = np.stack([rng.random(4000), 0.5 + 0.01 * rng.standard_normal(4000)], axis=1)
    found = Posterior(scaled_values, np.ones(4000), np.ones(3), np.full(3, 4000.0), 0, 1.0, 4)
    assert found.note(0) == "fills its bounds"
    assert found.note(1) == ""

"""The polynomial against the model that it stands in for."""

from math import comb
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import NoSolutionError
from asperity.joint_file.reader import read_case
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.curve_surrogate import (
    _box,
    _scaled_inside,
    exponents,
    fit_surrogate,
    surrogate_prediction,
)
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns

UNKNOWNS = ("load.preload=300 N:3000 N", "load.friction_coefficient=0.09:0.4",
            "play.angle=0 arcmin:1 arcmin", "play.take_up_torque=0.1 N*m:2 N*m", "offset=-1 arcmin:1 arcmin",
            "drift=-1e-6 rad/s:1e-6 rad/s")  # fmt: skip


@pytest.fixture(scope="module")
def model(zou_file):
    torque = np.concatenate([np.linspace(0.0, 8.0, 6), np.linspace(6.0, -8.0, 8)])
    time = np.arange(float(torque.size))
    data = Measurement(torque, np.zeros(torque.size), None, time, np.zeros(torque.size), "synthetic")
    case = read_case(zou_file)
    unknowns = read_unknowns(UNKNOWNS, case=case, measurements=(data,))
    return CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")


@pytest.mark.long
def test_prediction(model):
    centre = np.array([model.unknowns[0].to_unit(900.0), model.unknowns[1].to_unit(0.14), 0.3, 0.4, 0.5, 0.6])
    spread = 0.01 * np.eye(6)[:, :6]
    fitted = fit_surrogate(model, centre, spread**2, seed=0)
    predict = surrogate_prediction(model)
    rng = np.random.default_rng(1)
    for _ in range(3):
        scaled_values = centre + 0.02 * rng.uniform(-1.0, 1.0, 6)
        expected, _ = model(scaled_values)
        assert np.asarray(predict(fitted, np.asarray(scaled_values))) == pytest.approx(expected, rel=1e-4)
    # beyond the box it goes on without turning: a lower preload never makes the joint stiffer
    lower = [
        np.asarray(predict(fitted, np.asarray(centre - [s, 0, 0, 0, 0, 0])))[5] for s in (0.0, 0.06, 0.2, 0.3)
    ]
    assert np.all(np.diff(lower) > 0.0)


@pytest.mark.long
def test_joint_that_hardly_exists(model):
    slips = np.array([0.0, 0.0, 0.3, 0.4, 0.5, 0.6])  # 300 N and mu = 0.09
    assert np.all(np.isnan(model.predictions(slips[None])))
    with pytest.raises(NoSolutionError, match="have no solution"):
        fit_surrogate(model, slips, 1e-10 * np.eye(6), seed=0)


class PowerLaw:
    """A joint of two unknowns whose compliances are e to a polynomial, in series with an offset of the curve."""

    in_joint, in_curve = [0, 1], [2]
    unknowns = tuple(
        SimpleNamespace(path=name, from_unit=lambda place: 2.0 * place) for name in ("a", "b", "offset")
    )

    def __init__(self, weights=None, exists=lambda places: np.ones(len(places), bool)):
        self.weights, self._exists = weights, exists

    def compliances(self, places):
        a, b = places[:, :1], places[:, 1:2]
        found = np.array([1.0, 3.0, 9.0]) * np.exp(0.8 * a - 0.5 * b + 0.7 * a * b - 0.4 * b**2)
        return np.where(self._exists(places)[:, None], found, np.nan)

    def curve_part(self, point, tanh):
        return point["offset"]


CENTRE, SPREAD = np.array([0.4, 0.6, 0.5]), np.diag([0.02, 0.03, 0.1]) ** 2
NEAR = np.array([0.43, 0.55, 0.7])


@pytest.mark.slow
def test_an_exponential_of_a_polynomial_is_found_as_it_is():
    known = PowerLaw().compliances(NEAR[None])[0]
    stiff, summed = PowerLaw(), PowerLaw(weights=np.array([[1.0, 2.0, 0.0], [0.0, 0.5, 1.0]]))
    fitted = fit_surrogate(stiff, CENTRE, SPREAD, seed=3)
    np.testing.assert_allclose(surrogate_prediction(stiff)(fitted, np.asarray(NEAR)), 1.0 / known, rtol=1e-5)
    angle = [known[0] + 2.0 * known[1] + 1.4, 0.5 * known[1] + known[2] + 1.4]
    np.testing.assert_allclose(surrogate_prediction(summed)(fitted, np.asarray(NEAR)), angle, rtol=1e-5)


@pytest.mark.slow
def test_the_box_shrinks_until_most_joints_in_it_exist():
    model = PowerLaw(exists=lambda places: np.abs(places[:, 0] - CENTRE[0]) < 0.03)
    fitted = fit_surrogate(model, CENTRE, SPREAD, seed=3)
    whole = fit_surrogate(PowerLaw(), CENTRE, SPREAD, seed=3)
    widths = [np.sort(each["high"] - each["low"]) for each in (fitted, whole)]
    assert np.all(widths[0] < widths[1])
    near = np.add(CENTRE, [0.01, -0.01, 0.2])
    found = 1.0 / surrogate_prediction(model)(fitted, np.asarray(near))
    np.testing.assert_allclose(found, PowerLaw().compliances(near[None])[0], rtol=1e-5)
    with pytest.raises(NoSolutionError, match="have no solution"):
        fit_surrogate(PowerLaw(exists=lambda places: np.zeros(len(places), bool)), CENTRE, SPREAD, seed=3)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_beyond_its_box_the_logarithm_goes_on_straight():
    model = PowerLaw()
    fitted = fit_surrogate(model, CENTRE, SPREAD, seed=3)
    predict = surrogate_prediction(model)
    for end in ("low", "high"):
        edge = 0.5 * (fitted["low"] + fitted["high"])
        half = fitted[end] - edge
        beyond = [
            np.log(predict(fitted, jnp.append(fitted["middle"] + fitted["axes"] @ (edge + way * half), 0.5)))
            for way in (1.01, 1.02, 1.03, 1.5)
        ]
        slope = beyond[1] - beyond[0]
        assert np.abs(slope).min() > 1e-4
        np.testing.assert_allclose(beyond[2] - beyond[1], slope, rtol=1e-9)
        np.testing.assert_allclose(beyond[3] - beyond[0], 49.0 * slope, rtol=1e-9)


def test_the_box_ends_at_the_farthest_corner_of_the_cube_or_at_its_reach():
    middle, angle = np.array([0.9, 0.4, 0.5]), 0.6
    axes = np.array(
        [[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]]
    )
    corners = np.array(np.meshgrid([0.0, 1.0], [0.0, 1.0], [0.0, 1.0])).reshape(3, -1).T
    along = (corners - middle) @ axes
    low, high = _box(middle, axes, np.full(3, 10.0))
    np.testing.assert_allclose([low, high], [along.min(axis=0), along.max(axis=0)], rtol=1e-12)
    low, high = _box(middle, axes, np.full(3, 0.2))
    np.testing.assert_allclose([low, high], [np.full(3, -0.2), np.full(3, 0.2)])


@pytest.mark.parametrize(("unknowns", "degree"), [(0, 10), (1, 10), (2, 10), (3, 9), (6, 4), (30, 1)])
def test_number_of_terms(unknowns, degree):
    found = exponents(unknowns)
    assert found.shape == (comb(unknowns + degree, degree), unknowns)
    assert len({tuple(row) for row in found}) == len(found)
    if unknowns:
        assert np.array_equal(found[1 : 1 + unknowns], np.eye(unknowns))


@pytest.mark.parametrize("turn", [0.0, np.pi / 4.0])
def test_sampled_joints_lie_between_the_bounds(turn):
    """A box of unlike sides about a point near a corner: of the straight one nothing is left out."""
    middle, low, high = np.array([0.2, 0.7]), np.array([-0.19, -0.6]), np.array([0.79, 0.29])
    axes = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    found = _scaled_inside(np.random.default_rng(5), middle, axes, low, high, 200)
    assert found.shape == (200, 2)
    values = middle + (low + 0.5 * (found + 1.0) * (high - low)) @ axes.T
    assert np.all((values >= 0.0) & (values <= 1.0))
    every = np.cos(np.pi * np.random.default_rng(5).random((800, 2)))
    kept = len(np.intersect1d(found[:, 0], every[:200, 0]))
    assert (kept == 200) == (turn == 0.0)

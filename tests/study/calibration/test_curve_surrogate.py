"""The polynomial against the model that it stands in for."""

from math import comb

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import NoSolutionError
from asperity.joint_file.reader import read_case
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.curve_surrogate import exponents, fit_surrogate, surrogate_prediction
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
        assert np.asarray(predict(fitted, jnp.asarray(scaled_values))) == pytest.approx(expected, rel=1e-4)
    # beyond the box it goes on without turning: a lower preload never makes the joint stiffer
    lower = [
        np.asarray(predict(fitted, jnp.asarray(centre - [s, 0, 0, 0, 0, 0])))[5]
        for s in (0.0, 0.06, 0.2, 0.3)
    ]
    assert np.all(np.diff(lower) > 0.0)


@pytest.mark.long
def test_joint_that_hardly_exists(model):
    slips = np.array([0.0, 0.0, 0.3, 0.4, 0.5, 0.6])  # 300 N and mu = 0.09
    assert np.all(np.isnan(model.predictions(slips[None])))
    with pytest.raises(NoSolutionError, match="have no solution"):
        fit_surrogate(model, slips, 1e-10 * np.eye(6), seed=0)


@pytest.mark.parametrize(("unknowns", "degree"), [(0, 10), (1, 10), (2, 10), (3, 9), (6, 4), (30, 1)])
def test_number_of_terms(unknowns, degree):
    found = exponents(unknowns)
    assert found.shape == (comb(unknowns + degree, degree), unknowns)
    assert len({tuple(row) for row in found}) == len(found)
    if unknowns:
        assert np.array_equal(found[1 : 1 + unknowns], np.eye(unknowns))

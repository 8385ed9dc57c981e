"""Two curves fitted together: their errors and intervals on synthetic data, what one alone cannot tell, refusals."""

from types import SimpleNamespace

import numpy as np
import pytest
from calibrated import calibrated
from scipy.stats import binom, chi2

from asperity.errors import InputError
from asperity.joint_file.reader import read_case
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.fitted_curve import FittedCurve, JoinedCurves, residual_sentences
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.posterior import posterior
from asperity.study.calibration.unknowns import OFFSET_OF_DRIFT, read_unknowns

ARCMIN = np.pi / 10800.0
TEXTS = (
    "load.preload=300 N:3000 N",
    "load.friction_coefficient=0.09:0.4",
    "surface.fractal_roughness=1e-9 mm:1e-7 mm",
    "offset=-5 arcmin:5 arcmin",
    f"{OFFSET_OF_DRIFT}=-5 arcmin:5 arcmin",
)
TRUTH = np.array([900.0, 0.14, 1e-11, 0.1 * ARCMIN, 0.5 * ARCMIN])
LOOP = np.concatenate([np.linspace(1.0, 9.0, 5), np.linspace(6.0, -9.0, 6), np.linspace(-6.0, 9.0, 6)])
TURNING = np.array([-9.0, -6.0, -3.0, -1.0, 1.0, 2.0, 4.0, 6.0, 8.0, 9.0])
SCATTERS = np.array([0.003 * ARCMIN, 0.2 * ARCMIN])


def both(angle=None, drift=None):
    angle = np.linspace(-1.0, 1.0, LOOP.size) * ARCMIN if angle is None else angle
    drift = np.linspace(-30.0, 30.0, TURNING.size) * ARCMIN if drift is None else drift
    zeros = np.zeros(LOOP.size)
    return (
        Measurement(LOOP, angle, None, None, zeros, "standing.csv"),
        Measurement(TURNING, None, None, None, np.zeros(TURNING.size), "turning.csv", drift),
    )


def test_residuals_in_words():
    def curve(measurement, deviation, durbin_watson, rows=100):
        return FittedCurve(
            model=SimpleNamespace(measurement=measurement),
            prediction=np.zeros(rows),
            residual=np.zeros(rows),
            standard_deviation=deviation,
            freedom=rows - 1.0,
            durbin_watson=durbin_watson,
            scatter=None,
        )

    standing, turning = both()
    alone = residual_sentences([curve(standing, 0.5 * ARCMIN / 60.0, 1.51)])
    assert alone == ["residual: 0.5 arcsec (standard deviation)"]
    first, alike, second = residual_sentences(
        [curve(standing, 0.5 * ARCMIN / 60.0, 1.49), curve(turning, 2.0 * ARCMIN / 60.0, 2.4)]
    )
    assert first.startswith("residual of the angle: 0.5 arcsec")
    assert alike.startswith("Neighbouring residuals of the angle are correlated (Durbin–Watson 1.49,")
    assert second.startswith("residual of the drift per output turn: 2 arcsec")
    for rows, statistic in ((2, 0.0), (3, 0.0), (5, 0.0), (8, 0.9), (15, 1.2)):  # as chance makes them
        assert len(residual_sentences([curve(standing, 1e-6, statistic, rows)])) == 1, rows
    for rows, statistic in ((8, 0.7), (15, 1.0)):
        assert len(residual_sentences([curve(standing, 1e-6, statistic, rows)])) == 2, rows


@pytest.fixture(scope="module")
def case(zou_file):
    return read_case(zou_file)


@pytest.fixture(scope="module")
def exact(case):
    """Angles and drifts of the true joint, each from the model of its curve alone."""
    curves = both()
    found = []
    for data, own in zip(curves, (3, 4), strict=True):
        texts, values = [*TEXTS[:3], "offset=-5 arcmin:5 arcmin"], [*TRUTH[:3], TRUTH[own]]
        unknowns = read_unknowns(texts, case=case, measurements=(data,))
        model = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
        found.append(model(np.array([u.to_unit(v) for u, v in zip(unknowns, values, strict=True)]))[0])
    return found


@pytest.mark.long
def test_each_curve_is_seen_by_its_own_unknowns(case, exact):
    curves = both(*exact)
    unknowns = read_unknowns(TEXTS, case=case, measurements=curves)
    joined = JoinedCurves(
        case=case, measurements=curves, unknowns=unknowns, level="assembly", history="virgin"
    )
    true = np.array([u.to_unit(v) for u, v in zip(unknowns, TRUTH, strict=True)])
    scales = (1e-5, 1e-3)
    assert np.abs(joined.residual(true, scales)).max() < 1e-9
    slopes = joined.slopes(true, scales)
    steps = 1e-5 * np.eye(len(unknowns))
    expected = [
        (joined.residual(true + step, scales) - joined.residual(true - step, scales)) / 2e-5 for step in steps
    ]
    np.testing.assert_allclose(slopes, np.transpose(expected), rtol=1e-5, atol=1e-5 * np.abs(slopes).max())
    assert np.all(slopes[LOOP.size :, 3] == 0.0)
    assert np.all(slopes[: LOOP.size, 4] == 0.0)
    assert np.all(slopes[:, 0] != 0.0)


@pytest.mark.long
def test_intervals_and_errors_hold_as_often_as_they_say(case, exact):
    """Forty pairs of curves: the counts of five binomial variables, and the errors of each curve by chi-squared."""
    count, rng = 40, np.random.default_rng(11)
    ends, sizes = [], []
    for _ in range(count):
        noisy = [
            curve + scatter * rng.standard_normal(curve.size)
            for curve, scatter in zip(exact, SCATTERS, strict=True)
        ]
        found = calibrated(case, both(*noisy), TEXTS)
        ends.append([(each.lower, each.upper) for each in found.estimates])
        sizes.append([each.standard_deviation for each in found.curves])
    table = np.array(ends)
    held = np.sum((table[..., 0] < TRUTH) & (table[..., 1] > TRUTH), axis=0)
    assert np.all(held >= binom.ppf(1e-4, count, 0.95)), held
    points = LOOP.size + TURNING.size
    for size, scatter, rows in zip(np.transpose(sizes), SCATTERS, (LOOP.size, TURNING.size), strict=True):
        freedom = count * rows * (1.0 - len(TEXTS) / points)
        # how many of the five unknowns a curve bears is shared by rows, which may be off by two of them
        low, high = chi2.ppf([1e-4, 1.0 - 1e-4], freedom) / freedom
        off = 2.0 * count / freedom
        assert low - off < np.mean(size**2) / scatter**2 < high + off


@pytest.mark.long
def test_together_they_tell_what_neither_tells_alone(case, exact):
    """The roughness raises the creep as a lower preload does; the torque–angle curve knows the preload."""
    rng = np.random.default_rng(5)
    noisy = [
        curve + scatter * rng.standard_normal(curve.size)
        for curve, scatter in zip(exact, SCATTERS, strict=True)
    ]
    curves = both(*noisy)
    together = {each.path: each for each in calibrated(case, curves, TEXTS).estimates}
    turning = {
        each.path: each
        for each in calibrated(case, curves[1:], (*TEXTS[:3], "offset=-5 arcmin:5 arcmin")).estimates
    }
    for path in ("load.preload", "surface.fractal_roughness"):
        joint, alone = together[path], turning[path]
        assert joint.determined, path
        assert not alone.determined or joint.upper / joint.lower < (alone.upper / alone.lower) ** 0.5, path


@pytest.mark.long
def test_exact_curves_give_exact_values(case, exact):
    for each, true in zip(calibrated(case, both(*exact), TEXTS).estimates, TRUTH, strict=True):
        assert each.value == pytest.approx(true, rel=1e-4, abs=0.0), each.path


@pytest.mark.long
def test_what_cannot_be_fitted_together(case, exact):
    standing, turning = both(*exact)
    with pytest.raises(
        InputError, match=r"turning\.csv, turning\.csv: both are curves of a joint that turns; .*one"
    ):
        read_unknowns(TEXTS[:1], case=case, measurements=(turning, turning))
    with pytest.raises(InputError, match=r"both are curves of a joint that is at rest"):
        read_unknowns(TEXTS[:1], case=case, measurements=(standing, standing))
    with pytest.raises(InputError, match=r"at most one torque-angle or stiffness curve and one drift curve"):
        read_unknowns(TEXTS[:1], case=case, measurements=(standing, turning, turning))
    with pytest.raises(InputError, match=r"'offset of drift' belongs to a drift curve beside another one"):
        read_unknowns([OFFSET_OF_DRIFT], case=case, measurements=(turning,))
    with pytest.raises(InputError, match=r"a posterior is drawn from one curve"):
        posterior(calibrated(case, (standing, turning), TEXTS[:2]), draws=50, seed=0)

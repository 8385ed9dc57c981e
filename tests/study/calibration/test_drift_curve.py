"""Unknowns of a joint from its drift: the model against creep by hand, coverage of the intervals, and refusals."""

import dataclasses
from pathlib import Path

import jax.numpy as jnp
import numpy as np
import pytest
from curve_slopes import differences
from scipy.optimize import brentq
from scipy.stats import binom, chi2

from asperity.errors import InputError, NoSolutionError
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.study.calibration.calibrate import calibrate
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.curve_surrogate import fit_surrogate, surrogate_prediction
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns

TEXTS = ("load.preload=300 N:3000 N", "load.friction_coefficient=0.09:0.4", "offset=-5 arcmin:5 arcmin")
ARCMIN = np.pi / 10800.0
TRUTH = np.array([900.0, 0.14, 0.5 * ARCMIN])
TORQUE = np.array([-9.0, -6.0, -3.0, -1.0, 0.0, 1.0, 2.0, 4.0, 6.0, 8.0, 10.0])


def data_of(torque, drift=None):
    drift = np.linspace(-0.03, 0.03, torque.size) if drift is None else drift
    return Measurement(torque, None, None, None, np.zeros(torque.size), "synthetic", drift)


def model_of(case, data, texts=TEXTS):
    unknowns = read_unknowns(texts, case=case, measurements=(data,))
    return CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")


def fitted(case, data, texts=TEXTS, **options):
    given = {"level": "assembly", "history": "virgin", "starts": 1, "seed": 0} | options
    unknowns = read_unknowns(texts, case=case, measurements=(data,))
    return calibrate(case=case, measurements=(data,), unknowns=unknowns, **given)


def scaled(model, values=TRUTH):
    return np.array([u.to_unit(v) for u, v in zip(model.unknowns, values, strict=True)])


@pytest.fixture(scope="module")
def case(zou_file):
    return read_case(zou_file)


@pytest.fixture(scope="module")
def model(case):
    return model_of(case, data_of(TORQUE))


def creep_by_hand(normal, sun_force, friction):
    """Creepages of Carter's contacts from sun to ring, with equal creep on both sides; the paper's radii and steel."""
    modulus = 206e9 / (1.0 - 0.3**2) / 2.0
    sun, planet, roller, ring = 4e-3, 13.5e-3, 5e-3, 40e-3
    radius = [sun * planet / (sun + planet)] + [planet * roller / (planet + roller)] * 2
    radius += [roller * ring / (ring - roller)] * 2

    def creepage(k, force):
        width = np.sqrt(4.0 * normal[k] * radius[k] / (np.pi * 5e-3 * modulus))
        q = abs(force) / (friction * normal[k])
        return np.sign(force) * friction * width / radius[k] * (1.0 - np.sqrt(max(1.0 - q, 0.0)))

    def difference(right):
        return sum(creepage(k, right) for k in (1, 3)) - sum(creepage(k, sun_force - right) for k in (2, 4))

    right = brentq(difference, 0.3 * sun_force, 0.7 * sun_force, xtol=1e-12)
    return creepage(0, sun_force) + creepage(1, right) + creepage(3, right)


@pytest.mark.slow
@pytest.mark.parametrize("torque", [-8.0, -2.0, 3.0, 7.0])
def test_model_is_carters_creep_by_hand(zou_file, tmp_path, torque):
    """Surfaces so smooth that their layer adds nothing; only the normal forces are the joint's."""
    text = Path(zou_file).read_text()
    (line,) = [line for line in text.splitlines() if line.startswith("fractal_roughness")]
    file = tmp_path / "smooth.toml"
    file.write_text(
        text.replace(line, 'fractal_roughness = "1e-16 mm"').replace(
            "fractal_dimension = 1.4", "fractal_dimension = 1.7"
        )
    )
    smooth = read_case(file)
    model = model_of(smooth, data_of(np.array([torque, 1.0])), TEXTS[:2])
    found = model(scaled(model, TRUTH[:2]))[0][0]
    joint = dataclasses.replace(
        joint_from_case(smooth), output_torque=torque, friction_coefficients=(0.14,), preload=900.0
    )
    normal = np.asarray(solve_joint(joint).result.rolling.normal)
    summed = creep_by_hand(normal, torque / 9.0 / 3.0 / 4e-3, 0.14)
    passed = np.exp(-summed)  # of the surface speed, to third order of the creepage
    loss = 1.0 - passed * 36.0 / (40.0 - 4.0 * passed)
    assert found == pytest.approx(2.0 * np.pi * loss / (1.0 - loss), rel=2e-3)


@pytest.mark.slow
def test_slopes_are_those_of_the_prediction(model):
    place = scaled(model)
    _, slopes = model(place)
    np.testing.assert_allclose(slopes, differences(model, place), rtol=2e-5, atol=1e-10)


@pytest.mark.slow
def test_offset_is_added_and_no_torque_has_no_drift(model):
    with_offset, without = (model(scaled(model, [900.0, 0.14, offset]))[0] for offset in (1e-4, 0.0))
    np.testing.assert_allclose(with_offset - without, 1e-4, rtol=1e-9)
    assert without[TORQUE == 0.0] == 0.0
    assert np.all(np.sign(without) == np.sign(TORQUE))


@pytest.mark.long
def test_many_sets_are_as_one_by_one_and_slip_has_no_prediction(model):
    sets = np.array([scaled(model), scaled(model, [1500.0, 0.2, 0.0])])
    np.testing.assert_allclose(model.predictions(sets), [model(each)[0] for each in sets], rtol=1e-10)
    slips = scaled(model, [500.0, 0.1, 0.0])[None]
    assert np.isnan(model.predictions(slips)).all()
    assert np.isfinite(model(slips[0])[0]).all(), "the search is led back"


@pytest.mark.long
def test_play_of_the_joint_file_is_no_drift(zou_file, tmp_path, model):
    file = tmp_path / "play.toml"
    file.write_text(Path(zou_file).read_text() + '\n[play]\nangle = "10 arcmin"\ntake_up_torque = "0 N*m"\n')
    loose = model_of(read_case(file), data_of(TORQUE))
    np.testing.assert_array_equal(loose(scaled(loose))[0], model(scaled(model))[0])


@pytest.mark.slow
def test_exact_data_give_exact_values(case, model):
    found = fitted(case, data_of(TORQUE, model(scaled(model))[0]))
    for each, true in zip(found.estimates, TRUTH, strict=True):
        assert each.determined
        assert each.value == pytest.approx(true, rel=1e-5), each.path


@pytest.mark.long
def test_intervals_hold_the_truth_as_often_as_they_say(case, model):
    """Forty curves: the counts of three binomial variables, and the scatter of the estimates by chi-squared."""
    count, scatter = 40, 0.2 * ARCMIN
    exact, rng = model(scaled(model))[0], np.random.default_rng(7)
    rows = []
    for _ in range(count):
        found = fitted(case, data_of(TORQUE, exact + scatter * rng.standard_normal(TORQUE.size)))
        rows.append(
            [
                (each.lower, each.value, each.upper, found.curves[0].standard_deviation)
                for each in found.estimates
            ]
        )
    table = np.array(rows)
    held = np.sum((table[..., 0] < TRUTH) & (table[..., 2] > TRUTH), axis=0)
    assert np.all(held >= binom.ppf(1e-4, count, 0.95)), held
    # residuals: 8 degrees of freedom in each curve
    freedom = count * (TORQUE.size - len(TEXTS))
    low, high = chi2.ppf([1e-4, 1.0 - 1e-4], freedom) / freedom
    assert low < np.mean(table[:, 0, 3] ** 2) / scatter**2 < high
    # estimates scatter as the covariance says
    stated = 0.5 * np.mean(table[..., 2] - table[..., 0], axis=0) / 2.306  # Student's t of 8
    low, high = np.sqrt(chi2.ppf([1e-4, 1.0 - 1e-4], count - 1) / (count - 1))
    actual = np.std(table[..., 1], axis=0, ddof=1)
    assert np.all((0.95 * low < actual / stated) & (actual / stated < 1.05 * high)), actual / stated


@pytest.mark.slow
def test_what_cannot_be_told_apart_is_named(case):
    """At small torques the drift is proportional to the torque: one number for two unknowns."""
    model = model_of(case, data_of(0.02 * TORQUE), TEXTS[:2])
    exact = model(scaled(model, TRUTH[:2]))[0]
    noise = 1e-3 * np.abs(exact).max() * np.random.default_rng(3).standard_normal(exact.size)
    found = fitted(case, data_of(0.02 * TORQUE, exact + noise), TEXTS[:2])
    assert not found.directions[0].determined
    assert "load.friction_coefficient" in found.directions[0].words
    assert "NOT identifiable" in found.directions[0].words


@pytest.mark.long
def test_polynomial_of_the_posterior(case, model):
    centre = scaled(model)
    fit = fit_surrogate(model, centre, (0.01 * np.eye(3)) ** 2, seed=0)
    predict, near = surrogate_prediction(model), centre + np.array([0.015, -0.01, 0.02])
    np.testing.assert_allclose(predict(fit, jnp.asarray(near)), model(near)[0], rtol=1e-4, atol=1e-12)


@pytest.mark.slow
def test_a_drift_past_gross_slip_is_refused(case):
    torque = np.array([2.0, 6.0, 10.0, 14.0, 18.0])
    with pytest.raises(NoSolutionError, match=r"does not roll steadily at|slips at the largest"):
        fitted(case, data_of(torque, 1e-2 * torque), ("load.preload=700 N:900 N",))


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        (
            ("play.angle",),
            "'play.angle' can be fitted to measured angles only; the data are those of the drift per",
        ),
        (("drift",), "'drift' can be fitted to measured angles only"),
    ],
)
def test_unknowns_that_a_drift_does_not_have(case, texts, said):
    with pytest.raises(InputError, match=said):
        read_unknowns(texts, case=case, measurements=(data_of(TORQUE),))


def test_radii_cannot_be_found_from_the_ratio_that_they_set(case):
    data = dataclasses.replace(data_of(TORQUE), unloaded_ratio=-9.0)
    with pytest.raises(InputError, match=r"'drive.sun_radius' sets the speed ratio without creep"):
        read_unknowns(("drive.sun_radius",), case=case, measurements=(data,))
    assert len(read_unknowns(("drive.planet_radius", "offset"), case=case, measurements=(data,))) == 2


def test_what_a_drift_curve_must_be(case):
    with pytest.raises(InputError, match="a drift curve has no history"):
        fitted(case, data_of(TORQUE), history="cycled")
    with pytest.raises(InputError, match="all torques are zero"):
        fitted(case, data_of(np.zeros(5)))
    with pytest.raises(InputError, match="of 1001 different torques; at most 1000 are solved"):
        fitted(case, data_of(np.linspace(1.0, 2.0, 1001)))

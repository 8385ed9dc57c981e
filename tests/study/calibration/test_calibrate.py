"""Calibration recovers known values from synthetic curves, and says what is not identifiable."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import chi2, norm
from scipy.stats import f as f_law
from scipy.stats import t as student

from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.reader import parse_case, read_case
from asperity.study.calibration.calibrate import _conclude, calibrate
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.directions import known_within
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns
from asperity.study.design.design_problem import Variable

PLAY, DRIFT, OFFSETS = 2e-5, 3e-9, (1e-5, -2e-5)


@pytest.fixture(scope="module")
def case(zou_file):
    return read_case(zou_file)


def history():
    up, loop = np.linspace(0.2, 10.0, 15), np.linspace(10.0, -10.0, 31)[1:]
    return np.concatenate([up, loop, -loop])


def blank(torque, repetition=None):
    return Measurement(
        torque=torque,
        angle=np.zeros(torque.size),
        stiffness=None,
        time=10.0 * np.arange(torque.size),
        repetition=np.zeros(torque.size) if repetition is None else repetition,
        source="synthetic",
    )


def predicted(case, data, texts, values):
    """The curve of known values of the unknowns."""
    unknowns = read_unknowns([f"{text}" for text in texts], case=case, measurements=(data,))
    model = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
    return model(np.array([u.to_unit(v) for u, v in zip(unknowns, values, strict=True)]))[0]


@pytest.fixture(scope="module")
def curve(case):
    """Joint of 900 N and mu = 0.14 with play, drift and two repetitions of different zero."""
    torque = np.concatenate([history(), history()])
    repetition = np.repeat([1.0, 2.0], torque.size // 2)
    data = blank(torque, repetition)
    joint = predicted(case, data, ["load.preload", "load.friction_coefficient"], [900.0, 0.14])
    extras = 0.5 * PLAY * np.sign(torque) + DRIFT * data.time + np.where(repetition == 1.0, *OFFSETS)
    return data, joint + extras


UNKNOWNS = ("load.preload", "load.friction_coefficient", "play.angle=0 arcmin:0.5 arcmin",
            "drift=-1e-7 rad/s:1e-7 rad/s",
            "offset=-1 arcmin:1 arcmin")  # fmt: skip
TRUTH = (900.0, 0.14, PLAY, DRIFT, *OFFSETS)


def fitted(case, data, angle, texts=UNKNOWNS, starts=1):
    data = Measurement(**{**vars(data), "angle": angle})
    return calibrate(
        case=case,
        measurements=(data,),
        unknowns=read_unknowns(texts, case=case, measurements=(data,)),
        level="assembly",
        history="virgin",
        starts=starts,
        seed=0,
    )


@pytest.mark.slow
def test_exact_data_give_exact_values(case, curve):
    found = fitted(case, *curve)
    assert [each.path for each in found.estimates][-2:] == ["offset 1", "offset 2"]
    for each, true in zip(found.estimates, TRUTH, strict=True):
        assert each.value == pytest.approx(true, rel=1e-5), each.path
        assert each.determined


@pytest.mark.slow
def test_noisy_data_give_values_within_their_intervals(case, curve):
    data, angle = curve
    scatter = 5e-7
    noise = scatter * np.random.default_rng(3).standard_normal(angle.size)
    found = fitted(case, data, angle + noise)
    rows, freedom = angle.size, angle.size - len(TRUTH)
    # laws of independent normal errors; each bound is missed once in ten thousand samples
    low, high = chi2(freedom).ppf([5e-5, 1.0 - 5e-5])
    assert low < freedom * (found.curves[0].standard_deviation / scatter) ** 2 < high
    assert found.curves[0].durbin_watson == pytest.approx(2.0, abs=norm.ppf(1.0 - 5e-5) * 2.0 / np.sqrt(rows))
    values = np.array([each.value for each in found.estimates])
    steps = 1e-4 * values
    texts = [text.split("=")[0] for text in UNKNOWNS[:2]]
    jacobian = np.zeros((rows, len(TRUTH)))
    for index in range(2):  # by differences of the curve; of play, drift and offsets by hand
        ahead, behind = (
            predicted(case, data, texts, [values[k] + sense * steps[k] * (k == index) for k in range(2)])
            for sense in (1.0, -1.0)
        )
        jacobian[:, index] = (ahead - behind) / (2.0 * steps[index])
    jacobian[:, 2], jacobian[:, 3] = 0.5 * np.sign(data.torque), data.time
    jacobian[:, 4], jacobian[:, 5] = data.repetition == 1.0, data.repetition == 2.0
    size = np.abs(jacobian).max(axis=0)
    normal = (jacobian / size).T @ (jacobian / size)
    half = (
        student(freedom).ppf(0.975)
        * found.curves[0].standard_deviation
        * np.sqrt(np.diag(np.linalg.inv(normal)))
        / size
    )
    # not to rounding: those of preload and friction are symmetric in the logarithm
    assert [0.5 * (each.upper - each.lower) for each in found.estimates] == pytest.approx(half, rel=0.01)
    deviation = size * (values - TRUTH)
    distance = deviation @ normal @ deviation / (len(TRUTH) * found.curves[0].standard_deviation ** 2)
    assert distance < f_law(len(TRUTH), freedom).ppf(1.0 - 1e-4)


@pytest.mark.long
def test_misfit_shows_in_the_residuals(case, curve):
    """Neither play nor drift is among the unknowns, but both are in the data."""
    texts = ("load.preload", "load.friction_coefficient", "offset=-1 arcmin:1 arcmin")
    found = fitted(case, *curve, texts=texts)
    assert found.curves[0].durbin_watson < 1.0


@pytest.mark.parametrize(
    ("unknown", "half_width", "words"),
    [
        (
            Variable("load.preload", 100.0, 10000.0, True),
            0.25,
            "weakly identifiable, load.preload to a factor of 3.16",
        ),  # 10^(1/2)
        (
            Variable("load.preload", 100.0, 10000.0, True),
            0.0021610686,
            "identifiable, load.preload to ±1 %",
        ),  # lg 1.01 / 2
        (Variable("drift", -2e-7, 2e-7, False), 0.125, "identifiable, drift to ±5e-08 rad/s"),
    ],
)
def test_how_well_an_unknown_is_known(unknown, half_width, words):
    assert known_within(unknown, half_width) == words


@pytest.mark.long
def test_what_cannot_be_told_apart_is_named(case, curve):
    # smooth surfaces are a thousand times stiffer than the bodies below them, so their roughness leaves no trace
    data, _ = curve
    roughness = "surface.fractal_roughness=1e-10 mm:1e-9 mm"
    angle = predicted(case, data, ["load.preload", roughness], [900.0, 3e-13])
    noise = 2e-5 * np.random.default_rng(3).standard_normal(angle.size)
    found = fitted(
        case,
        data,
        angle + noise,
        texts=("load.preload", roughness),
    )
    by_name = {each.path: each for each in found.estimates}
    assert by_name["load.preload"].determined
    assert not by_name["surface.fractal_roughness"].determined
    assert np.isnan(by_name["surface.fractal_roughness"].upper)
    assert "surface.fractal_roughness" in found.directions[0].words
    assert "NOT identifiable" in found.directions[0].words


@pytest.mark.parametrize(("exponent", "determined"), [(0.5, True), (0.1, False)])
def test_the_error_of_the_model_does_not_average_out(exponent, determined):
    """A straight line c torque with c in proportion to 100^(-2 exponent x/2): 5 % of c are 0.05/exponent of x."""
    line = 1e3 * np.linspace(1.0, 2.0, 40)

    class Line:
        unknowns = (Variable("load.preload", 100.0, 1e4, True),)

        def refuse_no_joint(self, scaled_values):
            pass

        def fitted(self, scaled_values):
            measured = SimpleNamespace(measured=line)
            return (SimpleNamespace(standard_deviation=1.0, residual=np.ones(40), measurement=measured),)

        def slopes(self, scaled_values, scales):
            return -exponent * line[:, None]

        def of_joint(self, scaled_values, scales):
            return line[:, None]

    found = _conclude(Line(), np.array([0.5]), (1.0,), 0.05, Line())
    (preload,) = found.estimates
    assert preload.determined == determined
    scatter = student(39).ppf(0.975) / (exponent * np.linalg.norm(line))
    half = np.hypot(scatter, norm.ppf(0.975) * 0.05 / exponent)
    expected = (
        [1e3 * 100.0**step for step in (-half, half, -scatter, scatter)] if determined else [np.nan] * 4
    )
    ends = [preload.lower, preload.upper, preload.scatter_lower, preload.scatter_upper]
    assert ends == pytest.approx(expected, rel=1e-6, nan_ok=True)


def test_the_bounds_limit_what_a_small_share_in_something_not_identifiable_adds():
    """5 % of the preload in a direction that leaves no trace: its standard deviation is 5 % of that of the bounds."""
    lost = np.array([0.05, np.sqrt(1.0 - 0.05**2)])
    known = np.array([lost[1], -lost[0]])
    torque = np.linspace(1.0, 2.0, 40)
    slopes = np.outer(torque, 1e3 * known)

    class Curves:
        unknowns = (Variable("load.preload", 100.0, 1e4, True), Variable("offset", -1.0, 1.0, False))

        def refuse_no_joint(self, scaled_values):
            pass

        def fitted(self, scaled_values):
            curve = SimpleNamespace(
                standard_deviation=1.0, residual=np.ones(40), measurement=SimpleNamespace(measured=torque)
            )
            return (curve,)

        def slopes(self, scaled_values, scales):
            return slopes

        def of_joint(self, scaled_values, scales):
            return slopes[:, :1]

    found = _conclude(Curves(), np.array([0.5, 0.5]), (1.0,), 0.0, Curves())
    preload, offset = found.estimates
    assert (preload.determined, offset.determined) == (True, False)
    known = 1.0 / (1e3 * np.linalg.norm(torque))
    half = student(38).ppf(0.975) * np.hypot(0.05 / np.sqrt(12.0), known * np.sqrt(1.0 - 0.05**2))
    assert (preload.lower, preload.upper) == pytest.approx((1e3 * 100.0**-half, 1e3 * 100.0**half), rel=1e-9)


@pytest.mark.long
@pytest.mark.filterwarnings("error")
def test_no_play_says_nothing_about_its_torque(case):
    # the estimate of the play is exactly 0, so that the slope by play_torque is too
    torque = np.array([0.2, 0.6, 1.0, 2.0, 3.0, 2.0, 1.0, 0.5, 0.0, -0.5, -1.0, -2.0, -3.0, -1.0, 0.5, 2.0])
    texts = ("play.angle=0 arcmin:1 arcmin", "play.take_up_torque=0.1 N*m:5 N*m")
    angle = predicted(case, blank(torque), ["load.preload"], [1000.0])
    found = fitted(
        case, blank(torque), 0.99 * angle, texts
    )  # stiffer than the joint of the file, so no play is left
    assert found.estimates[0].at_bound == "lower"
    assert not found.estimates[1].determined
    assert np.all(np.isfinite(found.covariance))


@pytest.mark.long
def test_slopes_of_the_model(case, curve):
    data, _ = curve
    unknowns = read_unknowns(
        (*UNKNOWNS, "play.take_up_torque=0.1 N*m:2 N*m"), case=case, measurements=(data,)
    )
    model = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="cycled")
    scaled_values = np.array([0.45, 0.6, 0.3, 0.5, 0.5, 0.4, 0.5])
    _, slopes = model(scaled_values)
    for index in range(scaled_values.size):
        step = np.zeros(scaled_values.size)
        step[index] = 1e-5
        difference = (model(scaled_values + step)[0] - model(scaled_values - step)[0]) / 2e-5
        assert slopes[:, index] == pytest.approx(difference, rel=1e-4, abs=1e-7 * np.abs(difference).max())


@pytest.mark.slow
def test_stiffness_data(case):
    torque = np.linspace(0.0, 9.0, 12)
    data = Measurement(torque, None, np.ones(torque.size), None, np.zeros(torque.size), "synthetic")
    true = predicted(case, data, ["load.preload"], [1300.0])
    data = Measurement(torque, None, true, None, np.zeros(torque.size), "synthetic")
    found = calibrate(
        case=case,
        measurements=(data,),
        unknowns=read_unknowns(["load.preload"], case=case, measurements=(data,)),
        level="assembly",
        history="virgin",
        starts=1,
        seed=0,
    )
    assert found.estimates[0].value == pytest.approx(1300.0, rel=1e-6)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("load.prelode", "did you mean 'load.preload'"),
        ("load.preload=500 N", "KEY=LOWER:UPPER"),
        ("load.preload=500 N:100 N", "must be below"),
        ("load.preload=500:900", "bare number"),
        ("load.output_torque", "is measured here"),
        ("drive.planets", "whole number"),
        ("compliance.pin_stiffness", "state bounds"),
        ("play.take_up_torque", "needs the unknown 'play.angle'"),
    ],
)
def test_bad_unknowns(case, text, message):
    with pytest.raises(InputError, match=message):
        read_unknowns([text], case=case, measurements=(blank(history()),))


@pytest.mark.long
def test_a_curve_past_slip_is_refused(case):
    # 20 N·m is beyond the capacity of 13.2 N·m: the fit would end where the preload just carries it, with an interval
    # of no width since the slope is infinite there
    torque, angle = np.array([1.0, 20.0, 3.0]), np.array([3e-5, 6e-4, 1.2e-3])
    with pytest.raises(NoSolutionError, match="slips at the largest measured torque, 20 N"):
        fitted(case, blank(torque), angle, texts=("load.preload",))


def test_a_joint_whose_rollers_do_not_fit_is_refused(joint_text):
    crowded = parse_case(joint_text.replace("planets = 3\n", "planets = 30\n"), source="crowded.toml")
    with pytest.raises(InputError, match="neighbours of planet overlap by 23"):
        calibrate(
            case=crowded,
            measurements=(blank(history()),),
            unknowns=(),
            level="assembly",
            history="virgin",
            starts=1,
            seed=0,
        )


def test_more_unknowns_than_data(case):
    with pytest.raises(InputError, match="more rows than unknowns"):
        fitted(case, blank(np.array([1.0, 2.0])), np.array([1e-5, 2e-5]), texts=("load.preload", "offset"))


def test_one_of_two_curves_with_as_few_rows_as_unknowns(case):
    """Its errors, estimated from residuals that the fit makes zero, would make the intervals falsely certain."""
    long, short = blank(np.linspace(0.5, 8.0, 30)), blank(np.array([2.0, 4.0]))
    short = Measurement(**{**vars(short), "angle": None, "drift": np.full(2, 1e-3)})
    unknowns = read_unknowns(
        ["load.preload", "load.friction_coefficient"], case=case, measurements=(long, short)
    )
    with pytest.raises(InputError, match="synthetic: 2 rows beside 2 unknowns"):
        calibrate(
            case=case,
            measurements=(long, short),
            unknowns=unknowns,
            level="assembly",
            history="virgin",
            starts=1,
            seed=0,
        )

"""What measured curves say against themselves: signs, turns, their own scatter; by hand, by chance, on a file."""

import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from scipy.stats import binom

from asperity.cli.commands import asperity
from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.reader import read_case
from asperity.study.calibration.calibrate import calibrate, calibrated_text
from asperity.study.calibration.curve_checks import own_scatter, refuse_turns, refuse_wrong_signs
from asperity.study.calibration.fitted_curve import CHANCE, FittedCurve, residual_sentences
from asperity.study.calibration.measurement import Measurement, read_measurement
from asperity.study.calibration.unknowns import read_unknowns

DEGREE = np.pi / 180.0
ARCSEC = DEGREE / 3600.0
FILE = Path(__file__).with_name("torque_ok.csv")
LOOP = np.concatenate([np.linspace(0, 5, 11), np.linspace(4.5, -5, 20), np.linspace(-4.5, 5, 20)])


def curve(torque, angle=None, *, drift=None, stiffness=None, time=None, repetition=None):
    repetition = np.zeros(len(torque)) if repetition is None else np.asarray(repetition, float)
    sides = (None if side is None else np.asarray(side, float) for side in (angle, stiffness, time))
    drift = None if drift is None else np.asarray(drift, float)
    return Measurement(np.asarray(torque, float), *sides, repetition, "curve.csv", drift)


@pytest.mark.parametrize(
    ("measured", "message"),
    [
        # 1 arcmin of 10 N·m of a straight line
        (
            curve(LOOP, -LOOP * 6.0 * ARCSEC),
            r"curve\.csv: the angle falls as the torque rises, by 1 arcmin from -5 N·m to 5 N·m; change the sign of "
            "one column",
        ),
        (curve([1.0, 2.0], [2e-4, 1e-4]), "angle falls"),
        (curve(LOOP, drift=-LOOP * 1e-3 + 5e-3), "the drift falls as the torque rises"),
        # each repetition has a zero of its own, which would hide the fall
        (
            curve([0, 1, 2, 3, 4, 5], [3e-4, 2e-4, 1e-4, 13e-4, 12e-4, 11e-4], repetition=[1, 1, 1, 2, 2, 2]),
            "angle falls",
        ),
        # and a sensor that warms up, too
        (curve(LOOP, -LOOP * 1e-5 + 1e-4 * np.arange(51), time=np.arange(51)), "angle falls"),
    ],
)
def test_a_sensor_on_the_other_side_is_refused(measured, message):
    with pytest.raises(InputError, match=message):
        refuse_wrong_signs(measured)


@pytest.mark.parametrize(
    "measured",
    [
        curve(LOOP, LOOP * 1e-5),
        # a sensor that warms up faster than the joint winds up, over most of the time unloading
        curve(LOOP[5:31], LOOP[5:31] * 1e-5 + 1e-4 * np.arange(26), time=np.arange(26)),
        curve([0.0, 1.0, 2.0, 1.0], [0.0, 1e-5, 1e-5, 2e-5], time=[0, 1, 2, 3]),
        curve([1.0, 2.0, 3.0], stiffness=[3e5, 2e5, 1e5]),
        curve([2.0, 2.0, 2.0, 2.0], [1e-5, 2e-5, 0.0, 1e-5], repetition=[1, 1, 2, 2]),
    ],
)
def test_curves_that_rise_or_say_nothing_are_not_refused(measured):
    refuse_wrong_signs(measured)


def test_noise_without_a_slope_is_no_wrong_sign():
    random = np.random.default_rng(0)
    refused = 0
    for _ in range(400):
        try:
            refuse_wrong_signs(curve(LOOP, random.standard_normal(LOOP.size)))
        except InputError:
            refused += 1
    # three standard errors to one side: 0.13 % of normal errors
    assert refused <= binom(400, 0.0025).ppf(0.9999)


@pytest.mark.parametrize(
    ("angle", "message"),
    [
        ([359.9, 359.95, 0.0, 0.05], r"from row 2 to row 3 the angle jumps by -359\.95 deg, a turn: .*"
         "add 360 deg to the rows from there on"),
        ([0.05, 0.0, 359.95, 359.9], "by 359.95 deg, a turn: .*take 360 deg from the rows"),
        ([0.0, 719.9, 719.8, 719.7], "2 turns: .*take 720 deg from"),
        ([0.0, 0.1, 260.0, 260.1], r"by 259\.9 deg, which no joint does; check these rows and the unit"),
    ],
)  # fmt: skip
def test_a_jump_of_a_turn_is_refused_with_its_row(angle, message):
    with pytest.raises(InputError, match=message):
        refuse_turns(curve([1.0, 2.0, 3.0, 4.0], DEGREE * np.array(angle)))


def test_a_new_zero_of_a_repetition_is_no_jump():
    refuse_turns(curve([0, 1, 0, 1], [0.0, 1e-5, 6.3, 6.3 + 1e-5], repetition=[1, 1, 2, 2]))
    refuse_turns(curve([0, 1], drift=[0.0, 6.3]))


def test_scatter_by_hand():
    # evenly spaced 0, 1, 0, 1, 0, 1: each row misses the line between its neighbours by 1; 1/(1/4 + 1/4 + 1) = 2/3
    given = {"torque": np.arange(6.0), "repetition": np.zeros(6), "in_order": True}
    found = own_scatter(values=np.array([0.0, 1.0, 0.0, 1.0, 0.0, 1.0]), **given)
    assert (found.deviation, found.freedom) == pytest.approx((np.sqrt(2.0 / 3.0), 4 * 18 / 35), rel=1e-15)
    # unevenly: 1 stands at 3/4 of the way from 0 to 4: weights 3/4 of the nearer
    torque = np.array([0.0, 3.0, 4.0, 7.0, 8.0, 11.0])
    values = np.array([0.0, 1.0, 0.0, 0.0, 0.0, 0.0])
    found = own_scatter(values=values, torque=torque, repetition=np.zeros(6), in_order=True)
    terms = [1.0 / (1 / 16 + 9 / 16 + 1), (3 / 4) ** 2 / (9 / 16 + 1 / 16 + 1), 0.0, 0.0]
    assert found.deviation == pytest.approx(np.sqrt(np.mean(terms)), rel=1e-14)


def test_scatter_is_that_of_the_errors_and_not_of_a_straight_branch():
    random, sizes = np.random.default_rng(1), []
    steps = np.diff(LOOP, prepend=0.0)
    straight = np.cumsum(
        np.where(np.arange(LOOP.size) <= 10, 3e-5, 2.5e-5) * steps
    )  # the branches back are stiffer
    for _ in range(300):
        values = straight + 1e-6 * random.standard_normal(LOOP.size)
        sizes.append(own_scatter(values=values, torque=LOOP, repetition=0 * LOOP, in_order=True))
    deviations = np.array([found.deviation for found in sizes])
    assert np.mean(deviations**2) == pytest.approx(1e-12, rel=4.0 * np.sqrt(2.0 / sizes[0].freedom / 300.0))
    # and the degrees of freedom are those of its own scatter: var(s^2) = 2 sigma^4 over them
    assert np.var(deviations**2 / 1e-12) == pytest.approx(2.0 / sizes[0].freedom, rel=0.35)


def test_rows_in_any_order_where_the_order_says_nothing():
    torque = np.array([3.0, 1.0, 5.0, 2.0, 6.0, 4.0])
    values = np.array([1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
    by_torque = own_scatter(values=values, torque=torque, repetition=np.zeros(6), in_order=False)
    assert by_torque.deviation == pytest.approx(np.sqrt(2.0 / 3.0), rel=1e-15)
    assert own_scatter(values=values, torque=torque, repetition=np.zeros(6), in_order=True) is None
    assert own_scatter(values=values, torque=torque, repetition=np.arange(6.0), in_order=False) is None


def fitted(measured, prediction, unknowns=1):
    """A curve with what was fitted to it, without a joint."""
    from types import SimpleNamespace

    residual = measured.measured - prediction
    freedom = residual.size - unknowns
    return FittedCurve(
        model=SimpleNamespace(measurement=measured),
        prediction=prediction,
        residual=residual,
        standard_deviation=float(np.sqrt(np.sum(residual**2) / freedom)),
        freedom=freedom,
        durbin_watson=2.0,
        scatter=own_scatter(
            values=residual, torque=measured.torque, repetition=measured.repetition, in_order=True
        ),
    )


def test_chance_is_no_misfit():
    random, said = np.random.default_rng(2), 0
    for _ in range(2000):
        measured = curve(LOOP, 1e-5 * LOOP + 1e-7 * random.standard_normal(LOOP.size))
        slope = measured.torque @ measured.measured / (measured.torque @ measured.torque)
        said += fitted(measured, slope * LOOP).misfit > 0.0
    assert said <= binom(2000, CHANCE).ppf(0.9999)


def test_a_misfit_is_said_with_its_size_in_the_scatter():
    """A line through a curve that bends by a tenth of its size: 30 arcsec at 5 N·m, errors of 0.01 arcsec."""
    random = np.random.default_rng(3)
    bent = (6.0 * LOOP + 0.12 * LOOP * np.abs(LOOP)) * ARCSEC
    errors = 0.01 * ARCSEC * random.standard_normal(LOOP.size)
    slope = LOOP @ bent / (LOOP @ LOOP)
    left = np.sqrt(np.mean((bent - slope * LOOP) ** 2))
    one = fitted(curve(LOOP, bent + errors), slope * LOOP)
    assert one.misfit == pytest.approx(left, rel=0.05)
    *_, sentence = residual_sentences([one])
    times = float(sentence.split("is ")[1].split(" times")[0])
    # the bend itself adds 0.12 * 0.5^2 / 2 arcsec of curvature to a second difference: 0.015, 0.01 in quadrature
    assert times == pytest.approx(left / (ARCSEC * np.hypot(0.01, 0.03 * np.sqrt(2 / 3))), rel=0.25)
    assert "MISFIT: the residual is" in sentence
    assert "second differences" in sentence


@pytest.fixture(scope="module")
def case(zou_file):
    return read_case(zou_file)


def found_in(case, measured, texts, starts=1):
    unknowns = read_unknowns(texts, case=case, measurements=(measured,))
    return calibrate(
        case=case, measurements=(measured,), unknowns=unknowns, level="assembly", history="virgin",
        starts=starts, seed=1,
    )  # fmt: skip


@pytest.mark.slow
def test_an_unknown_at_its_bound_is_no_estimate(case):
    """The file has 964 N; bounds that leave it out are said, and the file that is written says so too."""
    texts = ("load.preload=500 N:900 N", "load.friction_coefficient", "offset")
    found = found_in(case, read_measurement(FILE), texts)
    preload = found.estimates[0]
    assert (preload.at_bound, preload.determined, preload.value) == ("upper", False, pytest.approx(900.0))
    assert np.isnan([preload.lower, preload.upper, preload.scatter_lower]).all()
    head = calibrated_text(found, case, comment="Calibrated.").split("\n")[0]
    assert head.startswith(
        "# Calibrated. load.preload ended at its upper bound, 900 N: this is no fitted value, the curve asks for more"
    )


def test_a_curve_that_no_joint_explains_is_refused(case):
    """Seconds of arc in the column of minutes, as if divided by 60: no bound holds its preload."""
    measured = read_measurement(FILE)
    small = curve(measured.torque, measured.angle / 60.0)
    with pytest.raises(NoSolutionError, match=r"curve\.csv: the best fit misses .* beyond its scatter, .* check "
                       "columns and units, or widen the bounds"):  # fmt: skip
        found_in(case, small, ("load.preload", "offset"))


def test_the_command_says_all_of_it(tmp_path, zou_file):
    rows = FILE.read_text().split("\n")
    turned = tmp_path / "sign.csv"
    turned.write_text("\n".join([rows[0], *(row.replace(",", ",-").replace("--", "") for row in rows[1:])]))

    def invoke(file, *options):
        arguments = [zou_file, file, "-u", "offset", "--starts", "1", *options]
        return CliRunner().invoke(asperity, ["calibrate", *map(str, arguments)])

    refused = invoke(turned, "-u", "load.preload").exception
    assert "the angle falls as the torque rises" in str(refused)
    assert "change the sign of one column" in str(refused)
    text = " ".join(invoke(FILE, "-u", "load.preload=500 N:900 N").stdout.split())
    assert "at its upper bound, 900 N" in text
    assert "load.preload ended at its upper bound, 900 N: this is no fitted value" in text
    assert "MISFIT" in text
    document = json.loads(invoke(FILE, "-u", "load.preload=500 N:900 N", "--json").stdout)
    preload = next(one for one in document["estimates"] if one["path"] == "load.preload")
    assert (preload["value"], preload["bound"], preload["lower"]) == (None, pytest.approx(900.0), None)
    (said,) = document["curves"]
    # 5 digits of an arcminute are 0.0003 arcsec of rounding; what the curve was made with is not known
    assert 0.0 < said["own_scatter"]["value"] < 0.05 * ARCSEC
    assert said["misfit_beyond_scatter"]["value"] > said["own_scatter"]["value"]

"""The curve of a joint with given unknowns: slopes, many sets at once, and no prediction where no joint exists."""

import math
from pathlib import Path

import numpy as np
import pytest
from curve_slopes import differences

from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case, read_case
from asperity.standing.windup import windup
from asperity.study.calibration import curve_model
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.joint_points import JointPoints
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns

TORQUE = np.array([0.5, 3.0, 6.0, 2.0, -4.0, 1.0])
TIME = 10.0 * np.arange(TORQUE.size)
TEXTS = (
    "load.preload=800 N:1600 N",
    "play.angle=0 arcmin:1 arcmin",
    "play.take_up_torque=0.1 N*m:2 N*m",
    "drift",
    "offset",
)


@pytest.fixture(scope="module")
def model(zou_file):
    data = Measurement(
        TORQUE, np.linspace(-1e-4, 1e-4, TORQUE.size), None, TIME, np.zeros(TORQUE.size), "synthetic"
    )
    case = read_case(zou_file)
    unknowns = read_unknowns(TEXTS, case=case, measurements=(data,))
    return CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")


PLACE = np.array([0.4, 0.3, 0.6, 0.7, 0.45])


@pytest.mark.slow
def test_slopes_are_those_of_the_prediction(model):
    _, slopes = model(PLACE)
    np.testing.assert_allclose(slopes, differences(model, PLACE), rtol=1e-5, atol=1e-12)


@pytest.mark.slow
def test_the_unknowns_of_the_curve_add_what_they_say(model):
    """Play taken up as play/2 tanh(T/T_p), a drift since the first row, an offset."""
    nothing = model.unknowns[3].to_unit(0.0), model.unknowns[4].to_unit(0.0)
    bare = model(np.array([0.4, 0.0, 0.6, *nothing]))[0]
    point = model.point(PLACE)
    added = (
        0.5 * point["play.angle"] * np.tanh(TORQUE / point["play.take_up_torque"])
        + point["drift"] * TIME
        + point["offset"]
    )
    np.testing.assert_allclose(model(PLACE)[0], bare + added, rtol=1e-10, atol=1e-16)


@pytest.mark.long
def test_a_measured_stiffness_is_that_of_the_joint_in_series_with_its_play(zou_file):
    """1/K = 1/K_joint + d/dT [play/2 tanh(T/T_p)]."""
    play, take_up = 3e-4, 0.4
    section = f'[play]\nangle = "{play} rad"\ntake_up_torque = "{take_up} N*m"\n\n[model]'
    case = parse_case(zou_file.read_text(encoding="utf-8").replace("[model]", section), source="loose.toml")
    data = Measurement(TORQUE, None, np.full(TORQUE.size, 3e4), TIME, np.zeros(TORQUE.size), "synthetic")
    unknowns = read_unknowns(TEXTS[:1], case=case, measurements=(data,))
    loose = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
    preload = np.array([0.4])
    stiffness = 1.0 / loose.compliances(preload[None])[0]
    opened = 0.5 * play / take_up / np.cosh(TORQUE / take_up) ** 2
    np.testing.assert_allclose(1.0 / loose(preload)[0], 1.0 / stiffness + opened, rtol=1e-9)


@pytest.mark.slow
def test_many_sets_are_as_one_by_one(model):
    scaled_values = np.array([PLACE, PLACE[::-1] * 0.5, np.full(5, 0.2)])
    np.testing.assert_allclose(
        model.predictions(scaled_values),
        [model(scaled_value)[0] for scaled_value in scaled_values],
        rtol=1e-10,
    )


@pytest.mark.slow
def test_a_joint_that_slips_below_the_largest_torque_has_no_prediction(zou_file):
    torque = np.array([1.0, 8.0])
    data = Measurement(torque, np.array([0.0, 1e-4]), None, None, np.zeros(2), "synthetic")
    case = read_case(zou_file)
    unknowns = read_unknowns(("load.preload=100 N:2000 N",), case=case, measurements=(data,))
    curve = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
    weak, strong = (curve.unknowns[0].to_unit(preload) for preload in (300.0, 1500.0))
    found = curve.predictions(np.array([[weak], [strong]]))
    assert np.isnan(found[0]).all()  # 13 N·m at 1000 N are 4 at 300
    assert np.isfinite(found[1]).all()
    assert np.isfinite(curve(np.array([weak]))[0]).all()  # the search is led back, by the least stiffness


@pytest.mark.long
@pytest.mark.parametrize(
    "change",
    [
        ('closure = "elastic"', 'closure = "constant_pin_force"'),
        ('left_push_angle = "0 deg"', 'left_push_angle = "15 deg"'),
        ("sun_speed", "sun_speed"),
    ],
)
def test_the_curve_is_that_of_the_wind_up(zou_file, tmp_path, change):
    """First loading in both directions and a whole loop, with play: two integrations of one joint."""
    text = Path(zou_file).read_text()
    assert change[0] in text
    file = tmp_path / "joint.toml"
    play = '[play]\nangle = "0.1 arcmin"\ntake_up_torque = "0.3 N*m"\n'
    bearings = (
        '[bearings]\nsun_torque = "1 N*mm"\nloading_roller_torque = "1 N*mm"\ncarrier_torque = "1 N*mm"\n'
        'pin_friction_coefficient = 0.01\npin_diameter = "4 mm"\n'
    )
    file.write_text(text.replace(*change) + play + bearings)
    case = read_case(file)
    curve = windup(joint_from_case(case), largest_torque=10.0, level="assembly", stage_shares=(1 / 3, 2 / 3))
    torque = np.asarray(curve.torque)
    down, half = torque[::-1], torque > 0.0

    def predicted(sequence):
        data = Measurement(
            sequence,
            np.linspace(-1e-4, 1e-4, sequence.size),
            None,
            None,
            np.zeros(sequence.size),
            "synthetic",
        )
        unknowns = read_unknowns(("load.preload=500 N:1600 N",), case=case, measurements=(data,))
        model = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
        return model(np.array([unknowns[0].to_unit(1000.0)]))[0]

    close = {"rtol": 1e-6, "atol": 1e-6 * float(curve.angle[-1])}
    np.testing.assert_allclose(predicted(torque[half]), np.asarray(curve.angle)[half], **close)
    np.testing.assert_allclose(predicted(-torque[half]), np.asarray(curve.angle)[::-1][half], **close)
    loop = predicted(np.concatenate([torque[half], down[1:], torque[1:]]))[half.sum() :]
    np.testing.assert_allclose(loop[: down.size - 1], np.asarray(curve.unloading_angle)[::-1][1:], **close)
    np.testing.assert_allclose(loop[down.size - 1 :], np.asarray(curve.reloading_angle)[1:], **close)


@pytest.fixture
def made_up(zou_file, monkeypatch):
    """A joint of 20 kN·m/rad, or 1 urad of drift per N·m, that slips at 13 N·m: all this at 1000 N."""

    def points(values, paths, sets, *, torque, slips, shown, slopes):
        preload, size = sets, np.abs(torque)
        bent = 1.0 - 0.02 * size
        if shown == "drift":
            value, slope = 1e-3 * torque / preload / bent, -1e-3 * torque / preload**2 / bent
        else:
            value, slope = 20.0 * preload * bent, 20.0 * bent * np.ones_like(preload)
        slip = size / (0.013 * preload)
        return JointPoints(value, slope[..., None], slip, slip < 1.0)

    def of(texts, play="", **measured):
        monkeypatch.setattr(curve_model, "joint_points", points)
        text = zou_file.read_text(encoding="utf-8").replace("[model]", f"{play}\n[model]")
        case = parse_case(text, source="made_up.toml")
        rows = measured.pop("torque", TORQUE)
        given = {"angle": None, "stiffness": None, "drift": None} | measured
        data = Measurement(
            rows, given["angle"], given["stiffness"], None, np.zeros(rows.size), "synthetic", given["drift"]
        )
        unknowns = read_unknowns(texts, case=case, measurements=(data,))
        return CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")

    return of


PRELOAD = ("load.preload=800 N:3200 N",)  # 1600 N in the middle of the logarithm


def test_a_stiffness_is_in_series_with_the_play_of_the_file(made_up):
    """1/K = 1/(20 P (1 - 0.02 |T|)) + play/(2 T_p) sech^2(T/T_p), for one set and for many."""
    play = '[play]\nangle = "3e-4 rad"\ntake_up_torque = "0.4 N*m"\n'
    model = made_up(PRELOAD, play, stiffness=np.full(TORQUE.size, 3e4))
    joint = 1.0 / (20.0 * 1600.0 * (1.0 - 0.02 * np.abs(TORQUE)))
    expected = 1.0 / (joint + 0.5 * 3e-4 / 0.4 / np.cosh(TORQUE / 0.4) ** 2)
    found, slopes = model(np.array([0.5]))
    np.testing.assert_allclose(found, expected, rtol=1e-9)
    np.testing.assert_allclose(model.predictions(np.array([[0.5], [0.5]])), [expected] * 2, rtol=1e-9)
    # dK/dP = K^2/K_joint^2 K_joint/P, and P grows by its logarithm over the bounds
    np.testing.assert_allclose(slopes[:, 0], expected**2 * joint * math.log(4.0), rtol=1e-9)


def test_a_drift_is_its_sum_at_the_torques_and_has_its_slopes(made_up):
    torque = np.array([0.0, 2.0, -5.0, 2.0])
    model = made_up(PRELOAD, torque=torque, drift=np.array([0.0, 1e-6, -3e-6, 1e-6]))
    expected = 1e-3 * torque / 1600.0 / (1.0 - 0.02 * np.abs(torque))
    found, slopes = model(np.array([0.5]))
    np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-20)
    np.testing.assert_allclose(model.predictions(np.array([[0.5]]))[0], expected, rtol=1e-12, atol=1e-20)
    np.testing.assert_allclose(slopes[:, 0], -expected * math.log(4.0), rtol=1e-9, atol=1e-20)


def test_a_joint_that_slips_at_the_very_largest_torque_has_no_prediction(made_up):
    """Slips at 13 mm times the preload; the quadrature itself ends at 0.991 of the largest torque or before."""
    model = made_up(PRELOAD, torque=np.array([4.0, 10.41]), angle=np.array([0.0, 1e-4]))
    place = [[model.unknowns[0].to_unit(10.41 / 0.013 * share)] for share in (0.9995, 1.0005)]
    found = model.predictions(np.array(place))
    assert np.max(np.abs(model.torque)) < 0.9995 * 10.41
    assert np.isnan(found[0]).all()
    assert np.isfinite(found[1]).all()


def test_a_search_begins_with_the_file_and_an_offset_in_the_middle(made_up):
    """What the file does not state begins in the middle, too, and a play near its lower bound of none."""
    model = made_up((*PRELOAD, "offset=1 arcmin:3 arcmin", *TEXTS[1:3]), angle=np.linspace(0.0, 1e-4, 6))
    stated = math.log(1000.0 / 800.0) / math.log(4.0)
    assert model.first == pytest.approx([stated, 0.5, 0.01, 0.5], rel=1e-9)


def test_a_drift_curve_of_too_many_torques_is_refused(made_up, monkeypatch):
    monkeypatch.setattr(curve_model, "MOST_DRIFT_TORQUES", 3)
    rows = np.arange(5.0)
    made_up(PRELOAD, torque=rows[:4], drift=rows[:4])  # three besides zero
    with pytest.raises(InputError, match="4 different torques; at most 3"):
        made_up(PRELOAD, torque=rows, drift=rows)

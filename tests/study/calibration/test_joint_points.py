"""Curves of joints with other drives than the paper's: its solutions, its wind-up, and known numbers found again."""

import dataclasses

import numpy as np
import pytest
from calibrated import calibrated
from scipy.stats import binom, chi2

from asperity.errors import NoSolutionError
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.standing.windup import windup
from asperity.study.calibration import joint_points as module
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.joint_points import joint_points
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns

PATHS = ("load.interference", "load.friction_coefficient", "surface.fractal_roughness")
KNOWN = np.array([27e-6, 0.092, 1.3e-10])  # the roughness is that of the file
TEXTS = ("load.interference", "load.friction_coefficient", "offset")
OFFSET = 3e-6
TORQUE = np.array([-11.0, -8.0, -5.0, -2.0, 1.0, 3.0, 4.0, 6.0, 7.0, 9.0, 10.0, 12.0])


@pytest.fixture(scope="module")
def case(planar_case):
    """Without oil, whose drag makes a drift without torque."""
    return planar_case("planetary", replaced={'[lubrication]\nviscosity = "30 mPa*s"\n': ""})


def points(case, torque, shown, *, numbers=KNOWN, slips=True, slopes=False):
    torque = np.asarray(torque, dtype=float)
    return joint_points(
        si_values(case),
        PATHS,
        np.atleast_2d(numbers),
        torque=torque,
        slips=np.full(torque.size, slips),
        shown=shown,
        slopes=slopes,
    )


@pytest.mark.parametrize("shown", ["assembly", "drift"])
def test_each_torque__is_solved_once(case, monkeypatch, shown):
    """Repeated torques share a state; with slip or without, or, of a drift, forwards or backwards."""
    over = []

    def solved(function, options, torque, *given):
        over.append(torque)
        both = np.stack([10.0 + torque, 100.0 + torque], axis=1)
        slip = np.stack([0.1 * np.abs(torque), 0.0 * torque], axis=1)
        holds = torque != 5.0
        return {shown: both, "slip_ratio": slip, "solved": holds}, 2.0 * both

    monkeypatch.setattr(module, "_over", solved)
    found = joint_points(
        si_values(case),
        PATHS[:1],
        KNOWN[None, :1],
        torque=np.array([3.0, -2.0, 3.0, 5.0]),
        slips=np.array([True, True, False, False]),
        shown=shown,
        slopes=True,
    )
    np.testing.assert_array_equal(over, [[-2.0, 3.0, 5.0]])
    value = [13.0, 98.0, 13.0, 15.0] if shown == "drift" else [13.0, 8.0, 103.0, np.nan]
    np.testing.assert_array_equal(found.value[0], value)
    np.testing.assert_allclose(found.slip_ratio[0], [0.3, 0.2, 0.3, 1.0])
    slope = [26.0, 196.0, 26.0, 30.0] if shown == "drift" else [26.0, 16.0, 206.0, 210.0]
    np.testing.assert_array_equal(found.slopes[0, :, 0], slope)
    assert found.exists[0].tolist() == [True, True, True, shown == "drift"]


def known_joint(case):
    return joint_from_values(replace_values(si_values(case), dict(zip(PATHS, KNOWN, strict=True))))


@pytest.mark.long
def test_values_are_those_of_the_joint_solved_there(case):
    joint, torques = known_joint(case), (9.0, -6.0)
    stiffness, drift = (points(case, torques, shown) for shown in ("assembly", "drift"))
    for k, torque in enumerate(torques):
        result = solve_joint(dataclasses.replace(joint, output_torque=torque)).result
        assert stiffness.value[0, k] == pytest.approx(float(result.assembly.stiffness.output), rel=1e-8)
        assert drift.value[0, k] == pytest.approx(float(result.rolling.drift_per_output_turn), rel=1e-8)
        assert stiffness.slip_ratio[0, k] == pytest.approx(
            float(result.diagnostics.slip_ratio.max()), rel=1e-8
        )
    assert stiffness.exists.all()
    assert drift.exists.all()


@pytest.mark.long
@pytest.mark.parametrize(
    ("shown", "slips"), [("assembly", True), ("series_with_bulk", False), ("drift", True)]
)
def test_slopes_are_those_of_the_values(case, shown, slips):
    torque = [-7.0, 2.0, 10.0]
    found = points(case, torque, shown, slips=slips, slopes=True).slopes[0]
    for index in range(len(PATHS)):
        step = np.zeros(len(PATHS))
        step[index] = 1e-5 * KNOWN[index]
        ahead, behind = points(case, torque, shown, numbers=[KNOWN + step, KNOWN - step], slips=slips).value
        difference = (ahead - behind) / (2.0 * step[index])
        np.testing.assert_allclose(
            found[:, index], difference, rtol=1e-4, atol=1e-9 + 1e-6 * np.abs(difference).max()
        )


@pytest.mark.long
def test_beyond_the_torque_capacity_there_is_no_joint(case):
    found = points(case, [10.0, 60.0], "assembly")
    assert found.exists.tolist() == [[True, False]]
    assert found.slip_ratio[0, 0] < 1.0 <= found.slip_ratio[0, 1]
    assert points(case, [10.0, 60.0], "drift").exists.tolist() == [[True, False]]


def measured(torque, *, angle=None, drift=None):
    return Measurement(torque, angle, None, None, np.zeros(torque.size), "synthetic", drift)


def predicted(case, data, texts, values):
    unknowns = read_unknowns(texts, case=case, measurements=(data,))
    model = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
    return model(np.array([u.to_unit(v) for u, v in zip(unknowns, values, strict=True)]))[0]


@pytest.fixture(scope="module")
def loop(case):
    """First loading and a whole loop of the known joint, from its wind-up."""
    curve = windup(known_joint(case), largest_torque=12.0, level="assembly", stage_shares=(1 / 3, 2 / 3))
    torque, half = np.asarray(curve.torque), np.asarray(curve.torque) > 0.0
    angle = [np.asarray(curve.angle)[half], np.asarray(curve.unloading_angle)[::-1][1:]]
    angle += [np.asarray(curve.reloading_angle)[1:]]
    return np.concatenate([torque[half], torque[::-1][1:], torque[1:]]), np.concatenate(angle)


@pytest.mark.long
def test_the_curve_is_that_of_the_wind_up(case, loop):
    torque, angle = loop
    data = measured(torque, angle=angle)
    found = predicted(case, data, [f"{path}={low}:{high}" for path, low, high in (
        ("load.interference", "20 um", "40 um"),
        ("load.friction_coefficient", "0.05", "0.2"),
        ("surface.fractal_roughness", "1e-8 mm", "1e-6 mm"),
    )], KNOWN)  # fmt: skip
    np.testing.assert_allclose(found, angle, rtol=0.0, atol=1e-5 * np.abs(angle).max())


@pytest.mark.long
def test_a_noisy_loop_gives_the_known_numbers_back(case, loop):
    """Errors of a thousandth of the angle; each estimate is missed by four standard deviations once in ten thousand."""
    torque, angle = loop
    scatter = 1e-3 * np.abs(angle).max()
    noise = scatter * np.random.default_rng(5).standard_normal(angle.size)
    texts = (*TEXTS[:2], "offset=-1 arcmin:1 arcmin")
    found = calibrated(case, (measured(torque, angle=angle + noise + OFFSET),), texts)
    low, high = chi2.ppf([1e-4, 1.0 - 1e-4], angle.size - 3) / (angle.size - 3)
    assert low < (found.curves[0].standard_deviation / scatter) ** 2 < high
    for each, true in zip(found.estimates, (*KNOWN[:2], OFFSET), strict=True):
        assert each.determined
        assert abs(each.value - true) < 2.0 * (each.upper - each.lower), each.path


@pytest.mark.long
def test_intervals_hold_the_truth_as_often_as_they_say(case):
    """Forty drift curves: the counts of three binomial variables, and the size of the errors by chi-squared."""
    count, scatter, truth = 40, 1e-4, np.array([*KNOWN[:2], OFFSET])
    data = measured(TORQUE, drift=np.linspace(-1e-2, 1e-2, TORQUE.size))
    texts = (*TEXTS[:2], "offset=-0.01 rad:0.01 rad")
    exact, rng = predicted(case, data, texts, truth), np.random.default_rng(11)
    rows = []
    for _ in range(count):
        noisy = measured(TORQUE, drift=exact + scatter * rng.standard_normal(TORQUE.size))
        found = calibrated(case, (noisy,), texts)
        size = found.curves[0].standard_deviation
        rows.append([(each.lower, each.value, each.upper, size) for each in found.estimates])
    table = np.array(rows)
    held = np.sum((table[..., 0] < truth) & (table[..., 2] > truth), axis=0)
    assert np.all(held >= binom.ppf(1e-4, count, 0.95)), held
    freedom = count * (TORQUE.size - len(texts))
    low, high = chi2.ppf([1e-4, 1.0 - 1e-4], freedom) / freedom
    assert low < np.mean(table[:, 0, 3] ** 2) / scatter**2 < high


@pytest.mark.long
def test_what_cannot_be_told_apart_is_named(case):
    """At small torques the drift is proportional to the torque: one number for two unknowns."""
    torque = 0.01 * TORQUE
    texts = TEXTS[:2]
    exact = predicted(case, measured(torque, drift=0.0 * torque), texts, KNOWN[:2])
    noise = 1e-3 * np.abs(exact).max() * np.random.default_rng(3).standard_normal(torque.size)
    found = calibrated(case, (measured(torque, drift=exact + noise),), texts)
    assert not found.directions[0].determined
    assert "NOT identifiable" in found.directions[0].words


@pytest.mark.long
def test_a_curve_past_gross_slip_is_refused(case):
    torque = np.array([1.0, 20.0, 60.0])
    for data in (measured(torque, angle=2e-6 * torque), measured(torque, drift=1e-3 * torque)):
        with pytest.raises(NoSolutionError, match=r"slips at the largest measured torque, 60 N"):
            calibrated(case, (data,), ("load.interference=29 um:31 um",))

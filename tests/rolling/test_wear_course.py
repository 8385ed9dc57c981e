"""The course of wear and its two ends, against an independent program and against differential equations."""

import functools

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.support.worn import EXAMPLES, check_case, worn_joint

from asperity.joint.solve import joint_state
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.rolling import wear_course
from asperity.rolling.wear import at_times
from asperity.rolling.wear_capacity import capacities
from asperity.rolling.wear_course import states_at, worn_course
from asperity.rolling.wear_rates import WearLoad, Worn, felt_interference, unworn

#: Torques [N·m] → interference where the first contact slides [µm] and k t [s/Pa]; the same where nothing is left.
ENDS = {
    2.0: (2.4600, 1.74347e-9, 2.2889, 1.75351e-9),
    5.0: (5.7166, 1.95500e-10, 5.3211, 2.01376e-10),
    8.0: (8.7910, 4.34089e-11, 8.1846, 4.78600e-11),
}
_TORQUE = 'output_torque = "5 N*m"'


@functools.cache
def course(torque=5.0, more="", interference="12.9043 um"):
    changes = {_TORQUE: f'output_torque = "{torque} N*m"', '"12.9043 um"': f'"{interference}"'}
    wearing, loads = worn_joint(check_case(changes, more))
    return wearing, loads, worn_course(wearing, loads)


@pytest.mark.parametrize("torque", ENDS)
def test_both_ends_of_an_independent_program(torque):
    _, _, found = course(torque)
    first, last = found.ends
    slides, time, nothing, whole = ENDS[torque]
    assert (first.kind, first.contact) == ("gross_slip", 4)
    assert (last.kind, last.contact) == ("gross_slip", 0)
    assert first.interference * 1e6 == pytest.approx(slides, rel=0.01)
    assert first.coefficient_time == pytest.approx(time, rel=5e-3)
    assert last.interference * 1e6 == pytest.approx(nothing, rel=0.01)
    assert last.coefficient_time == pytest.approx(whole, rel=5e-3)
    assert not found.carries_on


def test_duty_of_an_independent_program():
    duty = "".join(
        f'\n[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "6000 rpm"\nshare = {share}\n'
        for torque, share in ((8.0, 0.2), (4.0, 0.5), (1.5, 0.3))
    )
    _, loads, found = course(5.0, duty)
    assert loads.share.tolist() == [0.2, 0.5, 0.3]
    assert [end.coefficient_time for end in found.ends] == pytest.approx([1.38589e-10, 1.53754e-10], rel=5e-3)
    assert [end.load for end in found.ends] == [0, 0]


@pytest.mark.parametrize(("preload", "time"), [("700 N", 8.7661e-11), ("1500 N", 4.3413e-10)])
def test_other_preloads_of_an_independent_program(preload, time):
    made = joint_state(joint_from_case(check_case({'interference = "12.9043 um"': f'preload = "{preload}"'})))
    _, _, found = course(5.0, interference=f"{1e6 * float(made.interference)} um")
    assert found.ends[-1].coefficient_time == pytest.approx(time, rel=5e-3)


@pytest.mark.parametrize(("interference", "hours"), [(24.80, 11055.0), (133.1, 60778.0)])
def test_a_ring_that_gives_way_lasts_longer(interference, hours):
    """Six equal loads on a free ring, whose bending takes what the rigid ring does not: 10 and 4 mm of wall."""
    spring = 546.83 / (interference - 12.9043)  # of the force of a ring's contact, N/µm
    changes = {'"12.9043 um"': f'"{interference} um"'}
    wearing, loads = worn_joint(
        check_case(changes, f'\n[compliance]\nring_bending_stiffness = "{spring} N/um"\n')
    )
    found = worn_course(wearing, loads)
    assert found.ends[-1].coefficient_time / 1e-17 / 3600.0 == pytest.approx(hours, rel=5e-3)


#: Share of k t to nothing left → interference [µm], preload [N], torque of the first slide [N·m], drift [arcmin].
COURSE = {
    0.0: (12.904, 1000.0, 12.184, 35.29),
    0.25: (11.420, 874.6, 10.656, 38.48),
    0.5: (9.779, 737.9, 8.990, 43.24),
    0.75: (7.882, 582.8, 7.100, 51.86),
    0.9: (6.506, 472.7, 5.758, 63.36),
}


def test_course_of_an_independent_program():
    wearing, loads, found = course()
    stage = found.stages[0]
    worn = at_times(stage, np.array(list(COURSE)) * found.ends[-1].coefficient_time)
    state = states_at(wearing, worn, loads)
    interference, preload, torque, drift = np.array(list(COURSE.values())).T
    assert state.interference[:, 0] * 1e6 == pytest.approx(interference, rel=2e-3)
    assert state.preload[:, 0] == pytest.approx(preload, rel=2e-3)
    lost = 2.0 * np.pi * state.speed_loss[:, 0] / (1.0 - state.speed_loss[:, 0])
    assert lost * 10800.0 / np.pi == pytest.approx(drift, rel=0.01)
    load = WearLoad(*(leaf[0] for leaf in loads))
    slides = capacities(wearing, worn, load, guess=torque * 1.1)
    assert slides == pytest.approx(torque, rel=5e-3)


def test_a_tenth_of_the_interference():
    _, _, found = course()
    stage = found.stages[0]
    time = np.interp(0.1 * 12.9043e-6, stage.lost, stage.coefficient_time)
    assert time == pytest.approx(4.40266e-11, rel=5e-3)


def by_differential_equations(wearing, loads, end):
    """k t and depths where the same interference is lost, by a solver of initial-value problems."""
    felt, start = felt_interference(wearing.machine), unworn(wearing)
    contacts, crowned = start.interference.shape[1], start.curvature is not None
    scale = np.array(
        [1e-6] * contacts + [1e-3] * contacts * crowned + [1e-9]
    )  # of metres, curvatures and k t

    def worn(numbers):
        numbers = numbers * scale
        return Worn(numbers[None, :contacts], numbers[None, contacts : 2 * contacts] if crowned else None)

    def slopes(_, numbers):
        state = states_at(wearing, worn(numbers), loads)
        rates = [felt @ state.rates.interference[0, 0]]
        rates += [state.rates.curvature[0, 0]] if crowned else []
        return np.concatenate([*rates, [1.0]]) / state.drive_rate[0, 0] / scale

    found = solve_ivp(slopes, (0.0, end), np.zeros(scale.size), rtol=1e-5, atol=1e-7)
    assert found.success
    return found.y[-1, -1] * scale[-1], worn(found.y[:, -1])


@pytest.mark.parametrize(
    "which",
    [
        "stepped",
        pytest.param("crowned", marks=pytest.mark.slow),
        pytest.param("branches", marks=pytest.mark.slow),
    ],
)
def test_several_numbers_by_differential_equations(which):
    """Several self-stresses, crowns, or unlike branches: nine tenths of the first stage."""
    if which == "branches":
        deviation = '\n[[branch]]\nplanet_deviation = "0.4 um"\n[[branch]]\n[[branch]]\n'
        case = check_case(more=deviation)
    elif which == "stepped":
        case = read_case(EXAMPLES / "stepped_planet.toml")
    else:
        case = check_case({'contact_length = "5 mm"': 'contact_length = "5 mm"\nplanet_crown_radius = "5 m"'})
    wearing, loads = worn_joint(case)
    stage = worn_course(wearing, loads).stages[0]
    lost = 0.9 * stage.lost[-1]
    time, worn = by_differential_equations(wearing, loads, lost)
    assert np.interp(lost, stage.lost, stage.coefficient_time) == pytest.approx(time, rel=1e-4)
    at = at_times(stage, np.array([np.interp(lost, stage.lost, stage.coefficient_time)]))
    assert at.interference[0] == pytest.approx(worn.interference[0], rel=3e-4, abs=1e-10)
    if which == "crowned":
        assert at.curvature[0] == pytest.approx(worn.curvature[0], rel=3e-4, abs=1e-6)
        assert np.all(at.curvature[0] < np.asarray(wearing.machine.contacts.crown_curvature) + 1e-12)


def test_twice_the_speed_is_half_the_time():
    _, _, slow = course()
    wearing, loads = worn_joint(check_case({'sun_speed = "6000 rpm"': 'sun_speed = "12000 rpm"'}))
    fast = worn_course(wearing, loads)
    assert fast.ends[0].coefficient_time == pytest.approx(0.5 * slow.ends[0].coefficient_time, rel=1e-4)


@pytest.mark.slow
def test_equal_branches_by_themselves_last_as_long():
    wearing, loads = worn_joint(check_case(more=3 * "\n[[branch]]\n"))
    found, (_, _, known) = worn_course(wearing, loads), course()
    assert found.ends[0].coefficient_time == pytest.approx(known.ends[0].coefficient_time, rel=1e-3)
    assert found.ends[0].contact in (4, 9, 14)


@pytest.mark.slow
def test_a_stage_in_parts_ends_where_the_whole_does(monkeypatch):
    """What does not settle in a few passes is followed in parts."""
    wearing, loads = worn_joint(read_case(EXAMPLES / "stepped_planet.toml"))
    known = worn_course(wearing, loads)
    monkeypatch.setattr(wear_course, "_PASSES", 5)
    found = worn_course(wearing, loads)
    assert len(known.stages) == len(known.ends) == len(found.ends) == 1
    assert len(found.stages) > 1
    assert found.ends[0].coefficient_time == pytest.approx(known.ends[0].coefficient_time, rel=1e-5)
    assert found.stages[-1].depth[-1] == pytest.approx(known.stages[-1].depth[-1], rel=1e-5)


@pytest.mark.slow
def test_with_skew_only_the_first_end_is_known():
    wearing, loads = worn_joint(check_case(more='\n[rolling]\nskew = "0.2 mrad"\n'))
    found = worn_course(wearing, loads)
    assert found.carries_on
    assert [end.kind for end in found.ends] == ["gross_slip"]
    assert found.ends[0].coefficient_time < course()[2].ends[0].coefficient_time

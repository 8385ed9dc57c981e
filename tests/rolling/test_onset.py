"""From wind-up to drift: limits, and the work of the contacts by boundary elements."""

import dataclasses

import numpy as np
import pytest
from rolling_strip import rolling_strip

from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.joint_file.solved_document import solve_case
from asperity.rolling.onset import contacts_in_series, creep_lag, rolling_onset, swing_drift
from asperity.show.windup_figure import windup_figure
from asperity.zou2025.kinematics import CONTACT_NAMES

WINDUP = 1.6e-4  # rad
CELLS, PIXEL, STEPS = 200, 0.01, 500


def onset_of(joint, share=0.05):
    return rolling_onset(joint=joint, result=solve_joint(joint).result, windup=WINDUP, creep_share=share)


@pytest.fixture(scope="module")
def joint(paper_joint):
    return paper_joint()


@pytest.fixture(scope="module")
def onset(joint):
    return onset_of(joint)


@pytest.mark.slow
def test_begins_at_the_static_angle_with_half_the_drift(joint, onset):
    drift = float(solve_joint(joint).result.rolling.drift_per_output_turn) / (2.0 * np.pi)
    assert float(onset.lag[0]) == WINDUP
    step = 1e-3 * float(onset.steady_angle)
    assert float(creep_lag(contacts=onset.contacts, angle=step)) / step == pytest.approx(
        0.5 * drift, rel=2e-3
    )


def test_ends_on_the_drift_line_of_steady_rolling(joint, onset):
    drift = float(solve_joint(joint).result.rolling.drift_per_output_turn)
    turns = 2.0 * np.pi * np.array([1.0, 2.0])
    behind = np.asarray(creep_lag(contacts=onset.contacts, angle=turns))
    assert np.diff(behind)[0] == pytest.approx(drift, rel=1e-12)
    assert behind[0] == pytest.approx(drift - float(onset.missing_angle), rel=1e-12)
    tail = np.asarray(onset.angle) > 2.5 * float(onset.steady_angle)
    line = WINDUP - float(onset.missing_angle) + drift / (2.0 * np.pi) * np.asarray(onset.angle)
    np.testing.assert_allclose(np.asarray(onset.lag)[tail], line[tail], rtol=1e-12)


@pytest.fixture(scope="module")
def shifts():
    """Shift of a smooth contact over rolled distance since the start, both over the half-width, by its forces."""
    shift = rolling_strip(CELLS, STEPS)

    def run(slip_ratio, steps):
        found = shift(slip_ratio, steps)
        return found - found[0]

    return run


def work_over_torque(joint, shifts, steps):
    """Distances rolled, and the work of all contacts over the output torque; only the forces are the joint's."""
    found = solve_joint(joint).result.rolling
    modulus = 206e9 / (1.0 - 0.3**2) / 2.0
    sun, planet, roller, ring = 4e-3, 13.5e-3, 5e-3, 40e-3
    assert float(joint.drive.second_radius[-1]) == ring
    radii = [1.0 / (1.0 / sun + 1.0 / planet)] + [1.0 / (1.0 / planet + 1.0 / roller)] * 2
    radii += [1.0 / (1.0 / roller - 1.0 / ring)] * 2
    rolled = np.linspace(0.0, 2.6e-4, 261)
    work = np.zeros(rolled.size)
    for k, radius in enumerate(radii):
        normal, tangential = float(found.normal[k]), float(found.tangential[k])
        width = np.sqrt(4.0 * normal * radius / (np.pi * 5e-3 * modulus))
        shift = float(found.layer_creepage_factor[k]) * shifts(tangential / (0.12 * normal), steps)
        distance = np.abs(np.r_[0, np.cumsum(steps)]) * PIXEL * width
        work += 3.0 * tangential * 0.12 * width**2 / radius * np.interp(rolled, distance, shift)
    return rolled, work / float(joint.output_torque)


@pytest.mark.slow
def test_lag_is_the_work_of_the_contacts_over_the_torque(joint, onset, shifts):
    """Energy: what the output loses under its torque is what all contacts take up, each by boundary elements."""
    rolled, expected = work_over_torque(joint, shifts, np.ones(STEPS, dtype=int))
    angle = rolled / 40e-3  # seen from the carrier, the ring passes R_o per angle of the output
    found = np.asarray(creep_lag(contacts=onset.contacts, angle=angle))
    # 0.02 of creepage times half-width in each of the three contacts in series, and 0.5 % of the solver
    tolerance = 0.02 * float(np.max(onset.contacts.half_width)) * 1.9e-3 / 36e-3
    np.testing.assert_allclose(found, expected, rtol=5e-3, atol=tolerance)
    assert found[-1] > 40.0 * tolerance


def test_the_static_curve_holds_until_creep_has_its_share(joint, onset):
    for share in (0.01, 0.05, 0.3):
        found = onset_of(joint, share)
        lag = float(creep_lag(contacts=found.contacts, angle=found.static_angle))
        assert lag == pytest.approx(share * WINDUP, rel=1e-9)
    assert float(onset.static_angle) < float(np.max(onset.angle))


def test_each_contact_rolls_its_width(joint, onset):
    result = solve_joint(joint).result
    at_rest = 2.0 * np.asarray(result.diagnostics.hertz_half_width)
    np.testing.assert_allclose(
        2.0 * onset.contacts.half_width, at_rest, rtol=0.01
    )  # the forces differ a little
    # from the carrier the ring passes R_o for each angle of the output, and every contact nearly as much
    np.testing.assert_allclose(onset.width_angle, 2.0 * onset.contacts.half_width / 40e-3, rtol=2e-3)
    assert float(onset.steady_angle) == float(np.max(onset.width_angle))
    assert float(onset.contacts.input_angle) == pytest.approx(9.0, rel=3e-3)


def test_shares_of_the_drift(joint, onset):
    """The output loses power by the creep of each contact."""
    lost = np.asarray(solve_joint(joint).result.rolling.power.creep)
    np.testing.assert_allclose(onset.contacts.share, lost / lost.sum(), rtol=1e-9)


def test_both_senses_of_the_torque_are_mirrored(paper_joint, onset):
    other = onset_of(paper_joint(output_torque=-5.0))
    mirrored = [CONTACT_NAMES.index(name) for name in ("sp", "pwl", "pwr", "wlo", "wro")]
    for name in ("lag", "angle", "swing_drift", "static_angle", "missing_angle", "still_angle"):
        np.testing.assert_allclose(getattr(other, name), getattr(onset, name), rtol=1e-7, err_msg=name)
    np.testing.assert_allclose(np.asarray(other.width_angle)[mirrored], onset.width_angle, rtol=1e-7)


def test_swings(joint, onset, shifts):
    """Short ones come to rest; what longer ones lose is the work of the contacts."""
    drift = float(onset.contacts.drift_per_output_turn) / (2.0 * np.pi)
    still = float(onset.still_angle)
    assert float(swing_drift(contacts=onset.contacts, angle=still)) < 2e-3 * drift * still
    long = 1e4 * still
    assert float(swing_drift(contacts=onset.contacts, angle=long)) == pytest.approx(
        2.0 * drift * long, rel=1e-3
    )
    assert np.all(np.asarray(onset.swing_drift) <= 2.0 * drift * np.asarray(onset.angle))


def test_no_steady_rolling_no_onset(joint):
    result = solve_joint(joint).result
    torn = dataclasses.replace(
        result, rolling=dataclasses.replace(result.rolling, residual=np.asarray(np.nan))
    )
    assert rolling_onset(joint=joint, result=torn, windup=WINDUP, creep_share=0.05) is None


@pytest.mark.parametrize("share", [0.0, -0.1, np.nan, np.inf])
def test_a_share_that_is_none_is_refused(joint, share):
    with pytest.raises(InputError, match=r"creep share .* must be positive, e\.g\. 0\.05"):
        onset_of(joint, share)


@pytest.mark.slow
def test_the_picture_has_two_more_panels(joint, onset):
    from asperity.standing.windup import windup

    curve = windup(joint, largest_torque=5.0, level="assembly", stage_shares=(0.3, 0.6))
    *_, beyond, swing = windup_figure(curve, onset, title="joint").axes
    assert beyond.get_xlabel() == "angle turned by the input [°]"
    assert "behind" in beyond.get_ylabel()
    assert "swing" in swing.get_ylabel()


WIDTH = 1e-4 * np.arange(1.0, 6.0)  # m


@pytest.mark.slow
def test_the_papers_drive_shares_its_drift_by_force_and_creepage(solved_paper):
    """The output loses T s of each contact; 9 turns of the sun for one of the carrier, less 0.2 % of creep.

    Each contact passes on (1 - xi/2)/(1 + xi/2) of the speed of the surface before it, and rolls at the mean of both.
    """
    joint, solution = solved_paper
    rolling = solution.result.rolling
    found = contacts_in_series(drive=joint.drive, rolling=rolling, half_width=WIDTH)
    creepage = np.asarray(rolling.creepage)
    passed = (1.0 - creepage / 2.0) / (1.0 + creepage / 2.0)
    before = np.array([1.0, passed[0], passed[0], passed[0] * passed[1], passed[0] * passed[2]])
    work = creepage * np.asarray(rolling.tangential) * before * (1.0 + passed) / 2.0
    assert np.asarray(found.share) == pytest.approx(work / work.sum(), rel=1e-6)
    assert float(found.input_angle) == pytest.approx(9.0 / (1.0 - float(rolling.speed_loss)), rel=1e-9)
    assert float(found.drift_per_output_turn) == pytest.approx(
        float(rolling.drift_per_output_turn), rel=1e-12
    )
    assert found.half_width is WIDTH
    # seen from the carrier, the ring's 40 mm roll past for each radian, and all contacts pass what the ring does
    assert np.asarray(found.distance) == pytest.approx(np.full(5, 40e-3), rel=3e-3)


@pytest.mark.slow
@pytest.mark.parametrize("torque", ["10 N*m", "-10 N*m"])
def test_another_drive_shares_its_drift_by_the_power_that_its_contacts_lose(planar_case, torque):
    """With a torque that resists the rotation, and with one that drives it."""
    case = planar_case("planetary", replaced={'output_torque = "10 N*m"': f'output_torque = "{torque}"'})
    solved = solve_case(case).solved
    rolling = solved.solution.result.rolling
    found = contacts_in_series(drive=solved.joint.drive, rolling=rolling, half_width=WIDTH[:2])
    lost = np.asarray(rolling.power.creep)
    # a torque that drives is answered with the rotation that it resists: other speeds by the speed that is lost
    resisted = torque.startswith("1")
    apart = 1e-9 if resisted else abs(float(rolling.speed_loss))
    assert np.asarray(found.share) == pytest.approx(lost / lost.sum(), rel=apart)
    # ring fixed: the sun turns 1 + 50/10 times as far, less what creeps
    assert float(found.input_angle) == pytest.approx(6.0, rel=5e-3)
    assert abs(float(found.drift_per_output_turn)) == pytest.approx(
        abs(float(rolling.drift_per_output_turn)), rel=0.01
    )
    # each planet rolls 50 mm of the ring for each radian of the carrier, and as much of the sun
    assert np.asarray(found.distance) == pytest.approx(np.full(2, 50e-3), rel=5e-3)

"""What the creep of each contact adds to the angle that a joint loses."""

import numpy as np
import pytest

from asperity.joint_file.solved_document import solve_case
from asperity.rolling.contacts_in_series import contacts_in_series

WIDTH = 1e-4 * np.arange(1.0, 6.0)  # m


@pytest.mark.slow
def test_the_papers_drive_shares_its_drift_by_force_and_creepage(solved_paper):
    """The output loses T s of each contact; 9 turns of the sun for one of the carrier, less 0.2 % of creep."""
    joint, solution = solved_paper
    rolling = solution.result.rolling
    found = contacts_in_series(drive=joint.drive, rolling=rolling, half_width=WIDTH)
    work = np.asarray(rolling.creepage * rolling.tangential)
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

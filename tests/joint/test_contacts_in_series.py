"""What the creep of each contact adds to the angle that a joint loses."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.contacts_in_series import (
    ContactsInSeries,
    contacts_in_series,
    contacts_of_planar_drive,
    side_by_side,
)
from asperity.joint.planar.solve import solve_planar
from asperity.joint_file.solved_document import solve_case

WIDTH = 1e-4 * np.arange(1.0, 6.0)  # m


@pytest.mark.slow
def test_the_papers_drive_shares_its_drift_by_force_and_creepage(paper_joint):
    """The output loses T s of each contact; 9 turns of the sun for one of the carrier, less 0.2 % of creep."""
    joint = paper_joint()
    rolling = solve_planar(joint).result.rolling
    found = contacts_in_series(geometry=joint.geometry, rolling=rolling, half_width=WIDTH)
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
    found = contacts_of_planar_drive(drive=solved.joint.drive, rolling=rolling, half_width=WIDTH[:2])
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


def test_branches_side_by_side_count_by_their_torque():
    """Two branches, three quarters and a quarter of the torque: every number by hand, contacts branch by branch."""
    each = ContactsInSeries(
        half_width=jnp.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]),
        slip_ratio=jnp.array([[0.1, 0.2], [0.3, 0.4], [0.5, 0.6]]),
        share=jnp.array([[0.5, 0.2], [0.25, 0.2], [0.25, 0.6]]),
        distance=jnp.array([[7.0, 8.0], [9.0, 10.0], [11.0, 12.0]]),
        input_angle=jnp.array([9.0, 10.0]),
        drift_per_output_turn=jnp.array([0.01, 0.03]),
    )
    found = side_by_side(each, jnp.array([0.75, 0.25]))
    assert np.asarray(found.half_width).tolist() == [1.0, 3.0, 5.0, 2.0, 4.0, 6.0]
    assert np.asarray(found.slip_ratio).tolist() == [0.1, 0.3, 0.5, 0.2, 0.4, 0.6]
    assert np.asarray(found.distance).tolist() == [7.0, 9.0, 11.0, 8.0, 10.0, 12.0]
    assert np.asarray(found.share) == pytest.approx([0.375, 0.1875, 0.1875, 0.05, 0.05, 0.15], rel=1e-15)
    assert float(found.input_angle) == pytest.approx(9.25, rel=1e-15)
    assert float(found.drift_per_output_turn) == pytest.approx(0.015, rel=1e-15)

"""Shares of unequal branches, and the contact that slips first."""

import numpy as np
import pytest

from asperity.branches.results import BranchCapacity, BranchState


@pytest.mark.parametrize(
    ("torque", "share"), [([3.0, 2.0, 0.0], [0.6, 0.4, 0.0]), ([-1.0, -1.0, -2.0], [0.25, 0.25, 0.5])]
)
def test_shares_are_of_the_whole_torque_in_either_sense(torque, share):
    one = np.ones(3)
    state = BranchState(one, np.array(torque), one, np.zeros(2), np.zeros(2))
    np.testing.assert_allclose(state.share, share, rtol=1e-15)


def test_without_a_torque_there_are_no_shares():
    one = np.ones(3)
    state = BranchState(one, np.zeros(3), one, np.zeros(2), np.zeros(2))
    with np.errstate(all="raise"):
        assert np.isnan(state.share).all()


def test_names_of_contacts_in_the_order_of_the_branch():
    names = [BranchCapacity(1.0, 0, contact, 1.0, 1.0).contact_name for contact in (0, 1, 2, 3, 4, None)]
    assert names == ["sp", "pwr", "pwl", "wro", "wlo", ""]

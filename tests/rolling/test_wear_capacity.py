"""Torque capacities of worn joints, against the search of one joint at a time."""

import numpy as np
import pytest
from tests.support.worn import check_case, worn_joint

from asperity.engine.control import at_once
from asperity.joint.assembled import assembled
from asperity.joint.capacity import torque_capacities
from asperity.rolling.wear_capacity import capacities
from asperity.rolling.wear_rates import WearLoad, Worn, worn_machine


@pytest.mark.parametrize("torque", [5.0, -5.0])
@pytest.mark.parametrize("off", [0.5, 1.0, 2.5])
def test_side_by_side_as_one_joint_at_a_time(torque, off):
    """Also from a guess far off, and for a torque that drives."""
    wearing, loads = worn_joint(check_case())
    lost = np.array([0.0, 4e-6, 8e-6])
    worn = Worn(lost[:, None] * np.asarray(wearing.machine.joint.pattern))
    load = WearLoad(*(leaf[0] for leaf in loads))._replace(output_torque=np.asarray(torque))
    known = []
    for each in worn.interference:
        machine = worn_machine(wearing.machine, Worn(each))
        rolling = torque_capacities(machine, at_once(assembled, machine)).rolling
        known.append(float(rolling.output_torque[int(torque < 0.0)]))
    found = capacities(wearing, worn, load, guess=off * np.array(known))
    assert found == pytest.approx(known, rel=1e-5)

"""Sectors by themselves have crowns and skew like those of the joint with equal sectors."""

import numpy as np
import pytest

from asperity.joint.planar.branches import BranchedPlanarJoint
from asperity.joint.planar.solve import solve_planar
from asperity.joint_file.planar_build import deviations_of, planar_joint_from_case
from asperity.joint_file.si_tables import si_values


@pytest.mark.long
def test_equal_sectors_with_crowned_and_skewed_rollers_are_the_joint(planar_case):
    case = planar_case(
        "planetary",
        replaced={
            'bodies = "exact"': 'bodies = "springs"',
            'ring_support = "free" ': 'ring_support = "rigid_housing" ',
            "[load]": 'planet_crown_radius = "4 m"\n\n[load]',
            "[model]": '[rolling]\nskew = { sp = "0.1 mrad", pr = "0.2 mrad" }\n\n[model]',
        },
    )
    joint = planar_joint_from_case(case)
    solution = solve_planar(joint)
    found = BranchedPlanarJoint(joint, solution).branches(deviations_of(si_values(case)))
    result = solution.result
    np.testing.assert_allclose(found.preload, float(result.preload), rtol=1e-10)
    assert found.stiffness == pytest.approx(float(result.assembly.stiffness.output), rel=1e-9)
    np.testing.assert_allclose(found.rolling.slip_ratio, np.max(result.rolling.slip_ratio), rtol=1e-9)
    life = float(result.rolling.life_hours.drive)
    np.testing.assert_allclose(found.rolling.limits["life_hours"], life, rtol=1e-9)
    assert found.capacity.first_slip == pytest.approx(float(solution.first_slip.output_torque), rel=1e-8)
    assert found.rolling_capacity.first_slip == pytest.approx(
        float(solution.rolling_capacity.output_torque), rel=1e-6
    )

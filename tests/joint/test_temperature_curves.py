"""A joint over its working temperature."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.interference import joint_preload
from asperity.joint.solve import solve
from asperity.joint.temperature_curves import temperature_curves
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case


def test_a_force_has_no_curve(paper_joint):
    with pytest.raises(InputError, match="does not depend on temperature"):
        temperature_curves(paper_joint())


@pytest.mark.slow
def test_the_curve_goes_through_the_solved_joint(joint_text):
    text = joint_text.replace('preload = "1000 N"', 'interference = "13 um"').replace('"steel"', '"52100"')
    text = text.replace('ring = "52100"', 'ring = "6061-T6"').replace(
        'bodies = "exact"', 'bodies = "springs"'
    )
    text = text.replace("[model]", '[temperature]\nassembly = "20 °C"\nworking = "32 °C"\n\n[model]')
    joint = joint_from_case(parse_case(text, source="x"))
    curves = temperature_curves(joint)
    solution = solve(joint)

    def at_work(values):
        return float(np.interp(32.0, np.asarray(curves.temperature), np.asarray(values)))

    assert at_work(curves.preload) == pytest.approx(float(joint.preload), rel=2e-3)
    assert at_work(curves.torque_capacity) == pytest.approx(float(solution.capacity.output_torque), rel=2e-3)
    stiffness = float(solution.result.assembly.stiffness.output)
    assert at_work(curves.stiffness) == pytest.approx(stiffness, rel=2e-3)
    middle = np.asarray(joint_preload(joint, joint.fit.interference))
    assert float(
        np.interp(20.0, np.asarray(curves.temperature), np.asarray(curves.preload))
    ) == pytest.approx(float(middle), rel=2e-3)
    loose = np.asarray(curves.preload) == 0.0
    assert np.any(loose)
    assert np.all(np.isnan(np.asarray(curves.torque_capacity)[loose]))

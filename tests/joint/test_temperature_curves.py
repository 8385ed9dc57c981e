"""A joint over its working temperature."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.fit import Fit
from asperity.joint.solve import solution_of, solve_joint
from asperity.joint.temperature import at_temperature, temperature_curves
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case


def test_a_force_has_no_curve(paper_joint):
    with pytest.raises(InputError, match="does not depend on temperature"):
        temperature_curves(paper_joint(), None)


@pytest.mark.parametrize(("torque", "limit"), [(5.0, 5.5), (-5.0, 6.5)])
def test_there_is_stiffness_below_their_capacity(torque, limit):
    """Capacity falls by 0.1 N·m a kelvin from 7 and 8 N·m at 25 °C; a contact opens above 55 °C."""

    def solved(temperature):
        away = temperature - 25.0
        result = SimpleNamespace(
            rest=SimpleNamespace(normal=np.array([1000.0 - 10.0 * away, 30.0 - away]), residual=1e-14),
            solved=True,
            assembly=SimpleNamespace(stiffness=SimpleNamespace(output=3e4)),
        )
        limits = [SimpleNamespace(output_torque=limit - 0.1 * away) for limit in (7.0, 8.0)]
        return SimpleNamespace(
            result=result, standing_capacity=limits[0], reverse_standing_capacity=limits[1]
        )

    joint = SimpleNamespace(fit=Fit(0.0, 0.0, 20.0, 40.0), output_torque=torque, unlike=None)
    found = temperature_curves(joint, solved)
    temperature = np.asarray(found.temperature)
    np.testing.assert_allclose(temperature[[0, -1]], [0.0, 60.0])
    closed = temperature < 55.0
    np.testing.assert_allclose(found.preload, np.where(closed, 1250.0 - 10.0 * temperature, 0.0))
    own = (7.0 if torque > 0.0 else 8.0) - 0.1 * (temperature - 25.0)
    np.testing.assert_allclose(found.standing_torque_capacity, np.where(closed, own, np.nan))
    np.testing.assert_array_equal(found.stiffness, np.where(closed & (own > 5.0), 3e4, np.nan))
    assert np.interp(40.0, temperature, np.asarray(found.standing_torque_capacity)) == pytest.approx(limit)


@pytest.mark.long
def test_the_curve_goes_through_the_solved_joint(joint_text):
    text = joint_text.replace('preload = "1000 N"', 'interference = "13 um"').replace('"steel"', '"52100"')
    text = text.replace('ring = "52100"', 'ring = "6061-T6"').replace(
        'bodies = "exact"', 'bodies = "springs"'
    )
    text = text.replace("[model]", '[temperature]\nassembly = "20 °C"\nworking = "32 °C"\n\n[model]')
    joint = joint_from_case(parse_case(text, source="x"))
    curves = temperature_curves(joint, lambda each: solution_of(at_temperature(joint, each)))
    solution = solve_joint(joint)

    def at_work(values):
        return float(np.interp(32.0, np.asarray(curves.temperature), np.asarray(values)))

    assert at_work(curves.preload) == pytest.approx(float(solution.result.preload), rel=2e-3)
    assert at_work(curves.standing_torque_capacity) == pytest.approx(
        float(solution.standing_capacity.output_torque), rel=2e-3
    )
    stiffness = float(solution.result.assembly.stiffness.output)
    assert at_work(curves.stiffness) == pytest.approx(stiffness, rel=2e-3)
    cool = dataclasses.replace(joint.fit, working_temperature=joint.fit.assembly_temperature)
    middle = float(solve_joint(dataclasses.replace(joint, fit=cool)).result.preload)
    assert np.interp(20.0, curves.temperature, curves.preload) == pytest.approx(middle, rel=2e-3)
    loose = np.asarray(curves.preload) == 0.0
    assert np.any(loose)
    assert np.all(np.isnan(np.asarray(curves.standing_torque_capacity)[loose]))

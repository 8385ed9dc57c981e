"""Creep curves of the contacts of every drive: through the working points, and of smooth bodies Carter's."""

import math

import numpy as np
import pytest

from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case, read_case
from asperity.rolling.curves import creep_curves


@pytest.fixture(scope="module")
def planetary(zou_file):
    joint = joint_from_case(read_case(zou_file.with_name("planetary.toml")))
    return joint, solve_joint(joint).result


@pytest.mark.slow
def test_the_working_points_of_a_planetary_lie_on_its_curves(planetary):
    joint, result = planetary
    found, rolling = creep_curves(joint, result), result.rolling
    assert found.traction.shape == found.creepage.shape == (2, 60)
    for k in range(2):
        here = np.interp(rolling.traction_coefficient[k], found.traction[k], found.creepage[k])
        # the joint keeps the layer's factor of the standing drive
        assert here == pytest.approx(float(rolling.creepage[k]), rel=5e-3)
    np.testing.assert_allclose(found.traction[:, 0], 0.0, atol=1e-15)
    assert np.all(np.diff(found.creepage, axis=1) > 0.0)
    # friction 0.08 is the end of every curve
    assert np.all((found.traction[:, -1] > 0.95 * 0.08) & (found.traction[:, -1] <= 0.08))


def test_curves_of_smooth_bodies_are_carters(zou_file):
    """xi = mu a/R (1 - sqrt(1 - q)) with Hertz's a, by hand; the sun inside is convex, the ring concave."""
    text = zou_file.with_name("planetary.toml").read_text(encoding="utf-8")
    smooth = text.replace("fractal_dimension = 1.5", "fractal_dimension = 1.9").replace(
        "1.3e-7 mm", "1e-13 mm"
    )
    joint = joint_from_case(parse_case(smooth, source="smooth"))
    result = solve_joint(joint).result
    found = creep_curves(joint, result)
    normal, steel = np.asarray(result.rolling.normal), joint.materials[0]
    radius = np.array([10.0 * 20.0 / 30.0, 20.0 * 50.0 / 30.0]) * 1e-3
    modulus = float(steel.youngs_modulus) / (2.0 * (1.0 - float(steel.poisson_ratio) ** 2))
    width = np.sqrt(4.0 * normal / 10e-3 * radius / (math.pi * modulus))
    share = np.asarray(found.traction) / 0.08
    carter = (0.08 * width / radius)[:, None] * (1.0 - np.sqrt(1.0 - share))
    np.testing.assert_allclose(found.creepage, carter, rtol=1e-2, atol=1e-12)

"""Numbers that move a curve as an unknown does, by columns of slopes made by hand."""

import numpy as np
import pytest

from asperity.joint_file.reader import read_case
from asperity.study.calibration.directions import alternatives, candidates
from asperity.study.design.design_problem import Variable


def variables(*paths):
    return tuple(Variable(path, 0.5, 2.0, True) for path in paths)


def test_an_alternative_moves_the_curve_alike_once_the_other_unknowns_have_followed():
    """All bounds are alike: twice the slope needs half the change; what the offset takes up does not count."""
    rows = np.linspace(0.0, 1.0, 30)
    line, bent, offset = rows, rows**3, np.ones(30)
    names = variables("load.preload", "load.friction_coefficient", "drive.ring_wall_thickness", "play.angle")
    columns = np.column_stack([line, offset, -2.0 * line + 7.0 * offset, bent])
    found = alternatives(names, np.ones(4), columns, 2)[0]
    assert (found.unknown, found.other, found.calibrated) == (
        "load.preload",
        "drive.ring_wall_thickness",
        False,
    )
    assert (found.correlation, found.elasticity) == pytest.approx((1.0, -0.5))
    assert found.words.startswith(
        "load.preload +10 % or drive.ring_wall_thickness -5 %, a number of the file"
    )


def test_two_unknowns_that_are_alike_are_said_once_and_far_fetched_changes_not_at_all():
    line = np.linspace(1.0, 2.0, 30)
    names = variables("load.preload", "load.friction_coefficient", "materials.steel.density")
    (found,) = alternatives(names, np.ones(3), np.column_stack([line, 4.0 * line, 0.01 * line]), 1)
    assert (found.other, found.elasticity) == ("load.friction_coefficient", pytest.approx(0.25))
    (pair,) = alternatives(names[:2], np.ones(2), np.column_stack([line, 4.0 * line]), 2)
    assert pair.calibrated


def test_candidates_are_no_radii_no_loads_and_nothing_that_an_unknown_replaces(zou_file):
    paths = {one.path for one in candidates(read_case(zou_file), variables("load.preload"))}
    assert {"drive.ring_wall_thickness", "load.friction_coefficient", "surface.fractal_roughness"} <= paths
    assert not any(path.endswith("_radius") for path in paths)
    assert not paths & {
        "load.preload",
        "load.interference",
        "load.output_torque",
        "load.sun_speed",
        "drive.planets",
    }

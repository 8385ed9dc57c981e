"""Quantities of a joint and their derivatives, against the independent baseline and finite differences."""

import numpy as np
import pytest

from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import si_values
from asperity.study.quantities import quantities_and_slopes, quantities_at

PATHS = ("surface.fractal_dimension", "load.preload", "drive.planet_radius")
POINT = (1.4, 1000.0, 0.0135)


@pytest.fixture(scope="module")
def values(zou_file):
    return si_values(read_case(zou_file))


def changes(point):
    numbers = {path: np.full(2, value) for path, value in zip(PATHS, point, strict=True)}
    return {**numbers, "load.output_torque": np.array([1e-6, 5.0]), "load.sun_speed": np.zeros(2)}


def test_levels_of_stiffness(values):
    # the baseline in SciPy of benchmarks/, at a small torque: 5.0413e6, 3.1710e5 and 3.0892e4 N·m/rad
    found = quantities_at(values, {**changes(POINT), "drive.ring_wall_thickness": np.full(2, 0.06)})
    assert found["stiffness.published"][0, 0] == pytest.approx(5.0413e6, rel=2e-4)
    assert found["stiffness.series_with_bulk"][0, 0] == pytest.approx(3.1710e5, rel=2e-3)
    assert found["stiffness.assembly"][0, 0] == pytest.approx(3.0892e4, rel=2e-3)
    assert found["slip_ratio"].shape == (5, 2)
    mass = found["mass"][0, 0]
    assert found["stiffness_per_mass.assembly"][0, 0] == pytest.approx(
        found["stiffness.assembly"][0, 0] / mass
    )


def test_slopes_are_the_derivatives(values):
    found, slopes = quantities_and_slopes(values, changes(POINT), PATHS)
    for index, value in enumerate(POINT):
        step = 1e-6 * value
        ends = []
        for sign in (1.0, -1.0):
            moved = list(POINT)
            moved[index] += sign * step
            ends.append(quantities_at(values, changes(moved)))
        names = ("stiffness.assembly", "stiffness.published", "slip_ratio", "pressure_over_first_yield")
        for name in (*names, "clearance", "mass", "stiffness_per_volume.assembly", "normal_over_rest"):
            difference = (ends[0][name] - ends[1][name]) / (2.0 * step)
            scale = np.abs(found[name]).max() / value
            assert slopes[name][..., index] == pytest.approx(difference, rel=1e-5, abs=1e-7 * scale), name

import numpy as np
import pytest

import asperity
from asperity.errors import InputError

pytest.importorskip("xarray")


@pytest.fixture(scope="module")
def grid(joint):
    over = {"load.preload": ["800 N", "2 kN", "1000 N"], "surface.fractal_dimension": np.array([1.4, 1.5])}
    return asperity.sweep(joint, over, results="stiffness")


@pytest.mark.slow
def test_points_are_those_of_single_joints(joint, grid, solution):
    assert grid["load.preload"].values.tolist() == [800.0, 2000.0, 1000.0]
    assert grid["load.preload"].attrs == {"units": "N", "long_name": "preload"}
    assert grid["assembly_stiffness_output"].attrs["units"] == "N*m/rad"
    assert (grid["status"] == 0).all()
    found = grid["assembly_stiffness_output"].sel({"load.preload": 1000.0, "surface.fractal_dimension": 1.4})
    assert float(found) == pytest.approx(solution["stiffness"].si, rel=1e-9)
    other = joint.with_values({"load.preload": "2 kN", "surface.fractal_dimension": 1.5}).solve()
    found = grid["assembly_stiffness_output"].sel({"load.preload": 2000.0, "surface.fractal_dimension": 1.5})
    assert float(found) == pytest.approx(other["stiffness"].si, rel=1e-9)


def test_ways_to_write_an_axis(joint):
    from asperity.api.studies import _axis

    for written in (
        "0.5 kN:2 kN:4",
        (np.linspace(500, 2000, 4), "N"),
        ["500 N", "1000 N", "1.5 kN", "2000 N"],
    ):
        np.testing.assert_allclose(_axis("load.preload", written).values, [500, 1000, 1500, 2000], rtol=1e-15)
    assert _axis("load.preload", (joint["load.preload"],)).values.tolist() == [1000.0]


@pytest.mark.slow
def test_a_sweep_is_drawn(grid):
    assert asperity.plot(grid, result="published_stiffness_output").axes
    with pytest.raises(InputError, match="cannot draw 'int'"):
        asperity.plot(3)


def test_a_solution_is_drawn(solution):
    assert len(asperity.plot(solution).axes) == 2


@pytest.mark.parametrize(
    ("over", "says"),
    [
        ({"load.preload": [500, 600]}, r"^load.preload: expected a force with its unit .* bare number 500"),
        ({"load.preload": ["500 N", "500 N"]}, r"the value 500 N is listed twice"),
        ({"load.preload": []}, r"the count must be at least 1, got 0"),
        ({"load.preload": ([500.0], "mm")}, r"^load.preload: expected a force .* got a length"),
        ({"load.preload": 7}, r"expected a list of values with their units, got 7"),
        ({"load.preload": ["-5 N"]}, r"load.preload: -5 N is not allowed"),
        ({"load.prelod": ["5 N"]}, r"did you mean 'load.preload'"),
        ({}, r"expected axes such as"),
    ],
)
def test_wrong_axes_are_refused(joint, over, says):
    with pytest.raises(InputError, match=says):
        asperity.sweep(joint, over)

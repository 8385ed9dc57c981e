import numpy as np
import pytest

import asperity
from asperity.errors import InputError

pytest.importorskip("xarray")


@pytest.fixture(scope="module")
def grid(joint):
    over = {"load.preload": ["800 N", "2 kN", "1000 N"], "surface.fractal_dimension": np.array([1.4, 1.5])}
    return asperity.sweep(joint, over, results="stiffness")


@pytest.mark.long
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


@pytest.mark.long
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


@pytest.mark.slow
def test_units_that_are_asked_for(joint, grid):
    over = {"load.preload": ["800 N", "2 kN", "1000 N"], "surface.fractal_dimension": np.array([1.4, 1.5])}
    asked = asperity.sweep(joint, over, results="stiffness", units=["kN", "N*m/arcmin"])
    assert asked["load.preload"].values.tolist() == [0.8, 2.0, 1.0]
    assert asked["load.preload"].attrs["units"] == "kN"
    one, other = asked["published_stiffness_output"], grid["published_stiffness_output"]
    assert one.attrs["units"] == "N*m/arcmin"
    np.testing.assert_allclose(one, np.asarray(other) * np.pi / 180.0 / 60.0, rtol=1e-14)
    pictures = [asperity.plot(data, result="published_stiffness_output") for data in (asked, grid)]
    drawn = [[line.get_xydata() for line in picture.axes[0].lines] for picture in pictures]
    assert drawn[0]
    np.testing.assert_allclose(*drawn, rtol=1e-12)
    warm = {"temperature.working": ["20 degC", "40 degC"]}
    with pytest.raises(InputError, match="'K' measures nothing here"):  # kelvins count from another zero
        asperity.sweep(joint, warm, results="stiffness", units=["K"])
    for unit, message in (("kg", "'kg' measures nothing here"), ("foo", "unknown unit 'foo'")):
        with pytest.raises(InputError, match=message):
            asperity.sweep(joint, over, results="stiffness", units=[unit])


@pytest.mark.long
def test_an_elasticity_is_a_small_change_of_the_file(joint):
    """By two joints whose preload differs by a thousandth."""
    found = asperity.sensitivity(joint, ["assembly_stiffness_output"])
    one, other = (
        joint.with_values({"load.preload": f"{force} N"}).solve()["stiffness"].si for force in (999.5, 1000.5)
    )
    elasticity = float(found["elasticity"].sel(input="load.preload").squeeze())
    assert elasticity == pytest.approx((other - one) / (0.5 * (one + other)) * 1000.0, rel=1e-4)
    assert asperity.plot(found).axes
    with pytest.raises(InputError, match="there is no result 'mass'"):
        asperity.plot(found, result="mass")


@pytest.mark.long
def test_uncertainties_are_those_of_the_command(printed, zou_file):
    file = zou_file.with_name("tutorial_joint.toml")
    found = asperity.uncertainty(
        asperity.load(file), ["stiffness"], distribution="uniform", samples=256, seed=3
    )
    document = printed(
        "uncertainty",
        file,
        "--results",
        "stiffness",
        "--distribution",
        "uniform",
        "--samples",
        256,
        "--seed",
        3,
    )
    mean = float(found["mean"].sel(result="assembly_stiffness_output"))
    assert document["results"]["assembly_stiffness_output"]["mean"] == mean
    assert asperity.plot(found, result="published_stiffness_output").axes

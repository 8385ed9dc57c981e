"""Plots of sweeps against datasets that are written out here: places, units, failed points, logarithms."""

import functools
import json
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import si_values
from asperity.study.datasets import coordinate, dataset
from asperity.study.parameters import parse_axis
from asperity.study.sweep.sweep_plan import PLAN
from asperity.study.sweep.sweep_plot import _spread, _with_margin, sweep_figure

ROOT = Path(__file__).parents[3]
TORQUE, PRELOAD, SPEED = "load.output_torque", "load.preload", "load.sun_speed"


@functools.cache
def results_of_example(name):
    return results_of(si_values(read_case(ROOT / "examples" / f"{name}.toml")))


def swept(found, *specifications, failed=(), drive="zou2025"):
    axes = [parse_axis(each) for each in specifications]
    status = np.zeros(tuple(axis.values.size for axis in axes), dtype=np.int8)
    for place in failed:
        status[place] = 11
    return dataset(
        dimensions=tuple(axis.path for axis in axes),
        coordinates={axis.path: coordinate(axis) for axis in axes},
        status=status,
        result_values=found,
        table=results_of_example(drive),
        attributes={},
    )


def lines(axes):
    return {line.get_label(): line.get_xydata() for line in axes.get_lines()}


def test_levels_of_stiffness_are_curves_over_one_axis_and_failed_points_are_shaded():
    """0, 2, 4, 6 N·m; no result at the last, whose shade begins half-way from its neighbour."""
    assembled = np.array([10.0, 20.0, 30.0, np.nan])
    data = swept(
        {"published_stiffness_output": 2.0 * assembled, "assembly_stiffness_output": assembled},
        f"{TORQUE}=0 N*m:6 N*m:4",
        failed=[3],
    )
    figure = sweep_figure(data)
    (axes,) = figure.axes
    drawn = lines(axes)
    assert set(drawn) == {"assembly", "published"}
    np.testing.assert_allclose(drawn["published"].T, [[0.0, 2.0, 4.0, 6.0], [20.0, 40.0, 60.0, np.nan]])
    (shade,) = (patch for patch in axes.patches if patch.get_width())
    assert (shade.get_x(), shade.get_width()) == pytest.approx((5.0, 1.0))
    assert axes.get_xlim() == pytest.approx((-0.12, 6.12))
    assert axes.get_xlabel().endswith("[N·m]")
    assert axes.get_ylabel() == "torsional stiffness at the output [N·m/rad]"
    assert (axes.get_xscale(), axes.get_yscale()) == ("linear", "linear")
    assert figure.get_suptitle() == "4 points, 1 not solved"


def test_an_axis_even_in_its_logarithm_and_a_result_over_thirty_are_logarithmic():
    data = swept({"mass": np.array([1.0, 4.0, 31.0])}, f"{PRELOAD}=10 N:1000 N:3:log")
    (axes,) = sweep_figure(data).axes
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
    # 2 % of the two decades on either side
    assert axes.get_xlim() == pytest.approx((10.0 / 100**0.02, 1000.0 * 100**0.02))
    narrow = swept({"mass": np.array([1.0, 4.0, 29.0])}, f"{PRELOAD}=10 N:1000 N:3:log")
    assert sweep_figure(narrow).axes[0].get_yscale() == "linear"


def test_two_axes_are_a_map_with_the_first_to_the_right():
    values = np.add.outer(10.0 * np.arange(8), np.arange(7))
    data = swept({"mass": values}, f"{TORQUE}=0 N*m:7 N*m:8", f"{PRELOAD}=100 N:700 N:7")
    figure = sweep_figure(data)
    axes = figure.axes[0]
    mesh = axes.collections[0]  # below the contours
    np.testing.assert_allclose(mesh.get_array(), values.T)
    assert axes.get_xlim() == pytest.approx((0.0, 7.0))
    assert axes.get_ylim() == pytest.approx((100.0, 700.0))
    assert (axes.get_xlabel()[-5:], axes.get_ylabel()[-3:]) == ("[N·m]", "[N]")


@pytest.mark.parametrize(
    ("stated", "marked"),
    [
        ({"output_torque": 3.0, "preload": 250.0}, [(3.0, 250.0)]),
        ({"output_torque": 0.0, "preload": 700.0}, [(0.0, 700.0)]),
        ({"output_torque": 3.0, "preload": 750.0}, []),
        ({"output_torque": 3.0}, []),
        (None, []),
    ],
)
def test_a_map_marks_the_joint_of_the_file_where_it_holds_it(stated, marked):
    values = np.add.outer(10.0 * np.arange(8), np.arange(7))
    data = swept({"mass": values}, f"{TORQUE}=0 N*m:7 N*m:8", f"{PRELOAD}=100 N:700 N:7")
    if stated is not None:
        data.attrs[PLAN] = json.dumps({"joint": {"load": stated}})
    figure = sweep_figure(data)
    points = [tuple(line.get_xydata()[0]) for line in figure.axes[0].lines]
    assert points == [pytest.approx(point) for point in marked]
    told = [text.get_text() for legend in figure.legends for text in legend.get_texts()]
    assert told.count("the joint of the file") == len(marked)


def test_few_values_of_the_second_axis_are_curves_and_the_third_panels():
    """Largest of the contacts: the last, 0.5 + 0.01 torque + 0.1 preload + 0.2 speed by their places."""
    places = np.indices((4, 2, 2))
    value = 0.01 * places[0] + 0.1 * places[1] + 0.2 * places[2]
    slip = np.stack([0.1 * k + value for k in range(1, 6)])
    data = swept(
        {"slip_ratio": slip},
        f"{TORQUE}=0 N*m:6 N*m:4",
        f"{PRELOAD}=500 N:900 N:2",
        f"{SPEED}=1000 rpm:3000 rpm:2",
    )
    figure = sweep_figure(data)
    assert [axes.get_title()[-11:] for axes in figure.axes] == ["[rpm]: 1000", "[rpm]: 3000"]
    drawn = lines(figure.axes[1])
    assert set(drawn) == {"500 (largest of the contacts)", "900 (largest of the contacts)"}
    np.testing.assert_allclose(
        drawn["900 (largest of the contacts)"].T,
        [[0.0, 2.0, 4.0, 6.0], 0.5 + 0.1 + 0.2 + 0.01 * np.arange(4)],
    )


def test_axes_have_the_words_of_the_drive_that_was_swept():
    """The input need not be a sun; a planetary has two contacts."""
    name = "assembly_stiffness_input"
    data = swept({name: np.array([1.0, 2.0, 3.0])}, f"{TORQUE}=0 N*m:2 N*m:3", drive="planetary")
    (axes,) = sweep_figure(data, result=name).axes
    assert (
        axes.get_ylabel() == "torsional stiffness at the input, assembled (upper bound: pins rigid) [N·m/rad]"
    )
    slip = swept({"slip_ratio": np.ones((2, 3))}, f"{TORQUE}=0 N*m:2 N*m:3", drive="planetary")
    assert set(lines(sweep_figure(slip).axes[0])) == {"sp", "pr"}


def test_a_result_that_was_not_computed_is_refused():
    data = swept({"mass": np.ones(3)}, f"{TORQUE}=0 N*m:6 N*m:3")
    with pytest.raises(InputError, match="no result 'preload'; it has status, mass"):
        sweep_figure(data, result="preload")


def test_margins_and_thinning():
    assert _with_margin(np.array([2.0, 2.0]), log=False) == pytest.approx((1.0, 3.0))
    assert _spread(5, 10).tolist() == [0, 1, 2, 3, 4]
    assert _spread(9, 3).tolist() == [0, 4, 8]


def test_a_result_that_exists_beyond_the_capacity_is_not_shaded():
    data = swept({"torque_capacity": np.array([4.0, 5.0, 6.0])}, f"{PRELOAD}=100 N:300 N:3", failed=[0])
    figure = sweep_figure(data)
    assert not [patch for patch in figure.axes[0].patches if patch.get_width()]
    assert figure.get_suptitle().endswith("3 points, 1 not solved")

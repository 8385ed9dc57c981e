"""What the pictures of designs show is what the results say."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.study.design import design_evaluation
from asperity.study.design.design_plot import design_figure, pareto_figure
from asperity.study.design.design_problem import Constraint, DesignProblem, Objective, Variable, WorstCase

xarray = pytest.importorskip("xarray")
ARCMINUTE = np.pi / 180.0 / 60.0


def smallest_preload(case, *limits):
    """The design with the smallest preload between 100 and 1600 N that is at least 400 N, and within further limits."""
    problem = DesignProblem(
        case=case,
        joint_file="zou2025.toml",
        level="published",
        variables=(Variable("load.preload", 100.0, 1600.0, True),),
        objectives=(Objective("preload", 1.0),),
        constraints=(Constraint("preload", False, 400.0, (0,)), *limits),
        worst_case=WorstCase((), "none", 0, 0),
        starts=1,
        seed=0,
    )
    return SimpleNamespace(
        problem=problem, point={"load.preload": 400.0}, objective_after=400.0, feasible=True
    )


@pytest.fixture(scope="module")
def preload_figure(case):
    """Smallest preload between 100 and 1600 N that is at least 400 N: a case that is known without a search."""
    with (
        pytest.MonkeyPatch.context() as patch
    ):  # the chain has nothing to say here, and takes seconds to compile
        patch.setattr(
            design_evaluation,
            "derivatives_at",
            lambda values, changes, results, *, block: (None, {"preload": changes["load.preload"][None]}, {}),
        )
        return design_figure(smallest_preload(case))


def test_one_panel_a_variable_with_the_margin_below_it(preload_figure):
    above, below = preload_figure.axes
    assert below.get_xlabel() == "load.preload [N]"
    assert above.get_ylabel().endswith("[N]")
    assert below.get_ylabel() == "smallest margin\nof the limits [%]"
    assert above.get_xscale() == "log"
    assert [text.get_text() for text in above.get_legend().get_texts()] == [
        "a limit is violated",
        "limits of the design met",
        "design: limits of the design met",
        "no joint exists",
    ]
    assert (
        preload_figure.get_suptitle()
        == "smallest normal force of the first contact in the assembled drive, at its worst scenario"
    )


def test_the_objective_is_drawn_where_it_is_and_bold_where_the_limits_hold(preload_figure):
    above, below = preload_figure.axes
    everywhere, allowed, design = above.get_lines()
    x, y = everywhere.get_data()
    np.testing.assert_allclose(y, x, rtol=1e-12)  # the preload over the preload
    assert (x.min(), x.max()) == pytest.approx((100.0, 1600.0), rel=1e-12)
    np.testing.assert_array_equal(np.isfinite(allowed.get_ydata()), x >= 400.0 * (1.0 - 1e-9))
    assert design.get_xydata().tolist() == [[400.0, 400.0]]
    margin = below.get_lines()[0].get_ydata()
    np.testing.assert_allclose(
        margin, 100.0 * np.log(x / 400.0), atol=1e-9
    )  # margins are logarithms of ratios


def test_an_axis_of_one_decade_is_marked_at_more_than_one_place(preload_figure):
    preload_figure.savefig("/dev/null", format="png")
    _, below = preload_figure.axes
    low, high = below.get_xlim()
    shown = [
        label.get_text()
        for place, label in zip(below.get_xticks(), below.get_xticklabels(), strict=True)
        if low <= place <= high
    ]
    assert shown == ["100", "200", "500", "1000"]


def test_an_optimum_in_a_corner_of_the_limits_is_drawn_as_the_search_judged_it(case, monkeypatch):
    """One point alone meets both limits; beyond 800 N there is no joint, and nothing is drawn."""
    limits = Constraint("preload", True, 400.0, (0,)), Constraint("slip_ratio", True, 0.9, (0,))

    def known(values, changes, results, *, block):
        preload = changes["load.preload"][None]
        return None, {"preload": preload, "slip_ratio": preload / 800.0}, {}

    monkeypatch.setattr(design_evaluation, "derivatives_at", known)
    above, below = design_figure(smallest_preload(case, *limits)).axes
    everywhere, allowed, design = above.get_lines()
    x, y = everywhere.get_data()
    np.testing.assert_array_equal(np.isfinite(y), x < 800.0)
    assert np.isfinite(below.get_lines()[0].get_ydata()).tolist() == (x < 800.0).tolist()
    assert x[np.isfinite(allowed.get_ydata())].tolist() == pytest.approx([400.0])
    assert design.get_label() == "design: limits of the design met"
    assert above.patches  # grey where no joint exists
    assert min(patch.get_x() for patch in above.patches) == pytest.approx(800.0, rel=0.1)


@pytest.fixture
def front():
    data = {
        "assembly_stiffness_output": [2e4, 3e4, 4e4],
        "preload": [500.0, 900.0, 1500.0],
        "envelope_diameter": [0.10, 0.11, 0.12],
        "load.preload": [500.0, 900.0, 1500.0],
        "drive.planet_radius": [0.0134, 0.0135, 0.0136],
        "margin": [0.1, 0.2, 0.0],
    }
    words = {"envelope_diameter": "outer diameter of the largest body"}
    variables = {
        name: ("design", np.array(values), {"long_name": words.get(name, name)})
        for name, values in data.items()
    }
    return xarray.Dataset(variables, attrs={"level": "assembly"})


def test_a_front_of_two_objectives(front):
    figure = pareto_figure(front.drop_vars("envelope_diameter"), ("assembly_stiffness_output", "preload"))
    axes, preload, radius = figure.axes
    assert "3 designs" in axes.get_title()
    assert axes.get_ylabel().endswith("[N]")
    (points,) = axes.collections
    shown = np.asarray(points.get_offsets())
    per_unit = {"N·m/rad": 1.0, "N·m/arcmin": ARCMINUTE}
    unit = radius.get_xlabel().rsplit("[", 1)[1].rstrip("]")
    np.testing.assert_allclose(shown[:, 0], np.array([2e4, 3e4, 4e4]) * per_unit[unit], rtol=1e-12)
    np.testing.assert_array_equal(shown[:, 1], [500.0, 900.0, 1500.0])
    np.testing.assert_allclose(radius.get_lines()[0].get_ydata(), [13.4, 13.5, 13.6], rtol=1e-12)
    assert radius.get_ylabel() == "planet\nradius\n[mm]"
    assert preload.get_ylabel() == "preload\n[N]"


def test_the_third_objective_is_the_colour(front):
    figure = pareto_figure(front, ("assembly_stiffness_output", "preload", "envelope_diameter"))
    (points,) = figure.axes[0].collections
    np.testing.assert_allclose(points.get_array(), [100.0, 110.0, 120.0], rtol=1e-12)
    assert "outer diameter of the largest body [mm]" in [axes.get_ylabel() for axes in figure.axes]

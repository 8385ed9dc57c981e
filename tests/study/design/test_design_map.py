"""The map of a design: a case that is known without a search, lines of its limits, and the side of their ticks."""

import dataclasses
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.reader import read_case
from asperity.study.design import design_evaluation
from asperity.study.design.design_map import design_map, limit_text, mapped_variables
from asperity.study.design.design_problem import Constraint, DesignProblem, Objective, Variable, WorstCase

ROOT = Path(__file__).parents[3]


@pytest.fixture
def result(case, monkeypatch):
    """Preload from 100 to 1600 N, at least 400 N; contact length from 2 to 10 mm; slip ratio 250 N over preload."""
    problem = DesignProblem(
        case=case,
        joint_file="zou2025.toml",
        level="published",
        variables=(
            Variable("load.preload", 100.0, 1600.0, True),
            Variable("drive.contact_length", 2e-3, 10e-3, False),
            Variable("drive.planet_radius", 13e-3, 14e-3, False),
        ),
        objectives=(Objective("preload", 1.0),),
        constraints=(
            Constraint("preload", False, 400.0, (0,)),
            Constraint("mass", True, 1.0, (0,)),
            Constraint("slip_ratio", True, 1.0, (0,), implied=True),
        ),
        worst_case=WorstCase((), "none", 0, 0),
        starts=1,
        seed=0,
    )

    def known(values, changes, results, *, block):
        preload = changes["load.preload"][None]
        mass = changes["drive.contact_length"][None] / 6e-3
        return None, {"preload": preload, "mass": mass, "slip_ratio": 250.0 / preload}, {}

    monkeypatch.setattr(design_evaluation, "derivatives_at", known)
    point = {"load.preload": 400.0, "drive.contact_length": 4e-3, "drive.planet_radius": 13.5e-3}
    return SimpleNamespace(problem=problem, point=point, objective_after=400.0, feasible=True)


def lines_at_zero(axes):
    """Vertices of the lines of the limits, by colour."""
    from matplotlib.colors import to_hex

    found = {}
    for drawn in axes.collections:
        if len(drawn.get_paths()) == 1 and len(drawn.get_edgecolor()) and drawn.get_linewidth()[0] == 2.0:
            found[to_hex(drawn.get_edgecolor()[0])] = drawn.get_paths()[0].vertices
    return list(found.values())


def test_lines_lie_where_the_limits_are(result):
    figure = design_map(result)
    (axes,) = figure.axes
    preload, mass, slip = lines_at_zero(axes)
    np.testing.assert_allclose(preload[:, 0], 400.0, rtol=0.01)
    np.testing.assert_allclose(mass[:, 1], 6.0, rtol=0.01)  # mm
    np.testing.assert_allclose(slip[:, 0], 250.0, rtol=0.01)
    assert mass[:, 0].min() > 240.0  # ends where no joint exists
    labels = [text.get_text() for text in figure.legends[0].get_texts()]
    assert {
        "normal force of the first contact in the assembled drive ≥ 400 N",
        "mass of the rolling parts ≤ 1 kg",
    } <= set(labels)
    assert {
        "no joint exists",
        "limits of the design met",
        "design: limits of the design met",
        "slip ratio T/(mu N) ≤ 1",
    } <= set(labels)
    design = axes.lines[0].get_xydata()
    np.testing.assert_allclose(design, [[400.0, 4.0]])
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "linear")
    assert axes.get_ylabel() == "drive.contact_length [mm]"


def test_ticks_point_where_the_limit_is_violated(result):
    """Drawn alone, the line of the mass (upper limit 6 mm) has more ink above than below it."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    figure = design_map(result)
    (axes,) = figure.axes
    for artist in [*axes.texts, *axes.lines, *axes.collections]:
        vertices = (
            artist.get_paths()[0].vertices if hasattr(artist, "get_paths") and artist.get_paths() else None
        )
        mass = vertices is not None and len(vertices) > 1 and np.allclose(vertices[:, 1], 6.0, rtol=0.01)
        artist.set_visible(bool(mass))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    ink = 255.0 - np.asarray(canvas.buffer_rgba())[..., 0].astype(float)
    x, y = axes.transData.transform((800.0, 6.0)).astype(int)
    row = ink.shape[0] - y
    window = ink[row - 12 : row + 13, x - 60 : x + 60] - np.median(ink[row - 30 : row - 20, x - 60 : x + 60])
    assert window[:9].sum() > 5.0 * abs(window[16:].sum())


def test_variables_are_chosen_by_their_names(result):
    problem = result.problem
    assert mapped_variables(problem, None) == (0, 1)
    assert mapped_variables(problem, ("drive.planet_radius", "load.preload")) == (2, 0)
    with pytest.raises(InputError, match=r"'load.x' is not a variable.* are load\.preload, drive"):
        mapped_variables(problem, ("load.x", "load.preload"))
    with pytest.raises(InputError, match="two different"):
        mapped_variables(problem, ("load.preload", "load.preload"))


def test_a_design_of_one_variable_has_no_map(result):
    one = SimpleNamespace(variables=result.problem.variables[:1])
    with pytest.raises(InputError, match="needs two variables"):
        mapped_variables(one, None)


def test_limits_in_words(result):
    problem = result.problem
    assert limit_text(problem.constraints[1], problem.table) == "mass of the rolling parts ≤ 1 kg"


def test_the_map_of_another_drive_has_its_words(result):
    """The case that is known without a search, with the words of a planetary."""
    planetary = read_case(ROOT / "examples" / "planetary.toml")
    result.problem = dataclasses.replace(result.problem, case=planetary)
    figure = design_map(result)
    labels = [text.get_text() for text in figure.legends[0].get_texts()]
    assert "normal force of the first contact in the assembled drive ≥ 400 N" in labels
    assert (
        "normal force of the first contact in the assembled drive [N]" in labels
    )  # contours of the objective
    assert figure.get_suptitle().startswith("smallest normal force of the first contact")
    assert not any("sun" in label for label in labels)

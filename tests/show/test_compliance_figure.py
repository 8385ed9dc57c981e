import itertools
import types

import pytest

from asperity.drive.wedge.geometry import CONTACT_NAMES
from asperity.results.solved import SolvedJoint
from asperity.show.compliance_figure import compliance_figure, compliance_shares

SHARES = {
    "tangential_share": [0.1, 0.0, 0.0, 0.0, 0.0],
    "normal_share": [0.0, 0.2, 0.3, 0.0, 0.0],
    "ring_bending_share": 0.4,
    "pin_share": 0.0,
    "planet_support_share": 0.0,
    "input_shaft_share": 0.0,
    "output_shaft_share": 0.0,
    "loading_cam_share": 0.0,
}


@pytest.fixture
def solved():
    def level(output):
        return types.SimpleNamespace(output=output)

    result = types.SimpleNamespace(
        assembly=types.SimpleNamespace(stiffness=level(1e3), **SHARES),
        series_with_bulk=level(2e4),
        published=level(3e5),
        contact_names=CONTACT_NAMES,
    )
    return SolvedJoint(types.SimpleNamespace(body_model="exact"), result, None)


def test_springs_in_words_the_largest_first(solved):
    assert compliance_shares(solved) == {
        "ring bending": 0.4, "pwl normal": 0.3, "pwr normal": 0.2, "sp tangential": 0.1,
    }  # fmt: skip


def test_figure_is_in_percent_and_newton_metres_an_arcminute(solved):
    budget, levels = compliance_figure(solved, title="a joint").axes
    assert [bar.get_width() for bar in budget.patches] == pytest.approx([40.0, 30.0, 20.0, 10.0])
    (line,) = levels.lines
    assert line.get_xdata() == pytest.approx(
        [0.2908882, 5.817764, 87.26646], rel=1e-6
    )  # 1 arcmin is pi/10800


@pytest.mark.parametrize(("bodies", "said"), [("exact", True), ("springs", False)])
def test_the_budget_says_that_springs_of_contacts_include_the_bending_of_bodies(solved, bodies, said):
    solved.joint.body_model = bodies
    budget, _ = compliance_figure(solved, title="a joint").axes
    assert ("a free ring's bending" in " ".join(budget.get_xlabel().split())) is said


def test_a_level_without_stiffness_has_no_point(solved):
    solved.result.published.output = 0.0
    _, levels = compliance_figure(solved, title="a joint").axes
    assert levels.lines[0].get_xdata()[:2] == pytest.approx([0.2908882, 5.817764], rel=1e-6)
    assert levels.lines[0].get_xdata()[2] != levels.lines[0].get_xdata()[2]  # nan
    assert "no value" in [text.get_text() for text in levels.texts]


def test_levels_close_to_each_other_have_more_than_one_tick(solved):
    solved.result.series_with_bulk.output, solved.result.published.output = 1.1e3, 1.5e3
    figure = compliance_figure(solved, title="a joint")
    figure.savefig("/dev/null", format="png")
    _, levels = figure.axes
    low, high = levels.get_xlim()
    assert sum(low <= tick <= high for tick in levels.get_xticks()) >= 2


@pytest.mark.parametrize("ratio", [1.5, 30.0, 94.0, 1e3])
def test_tick_labels_of_the_levels_do_not_run_together(solved, ratio):
    """A planetary drive's published stiffness may be a hundred times that of its assembly."""
    solved.result.assembly.stiffness.output = 742450.0
    solved.result.series_with_bulk.output, solved.result.published.output = 1.5e6, 742450.0 * ratio
    figure = compliance_figure(solved, title="a joint")
    figure.savefig("/dev/null", format="png")
    _, levels = figure.axes
    low, high = levels.get_xlim()
    labels = [
        label
        for place, label in zip(levels.get_xticks(), levels.get_xticklabels(), strict=True)
        if low <= place <= high
    ]
    assert len(labels) >= 2
    ends = [label.get_window_extent() for label in labels]
    assert all(one.x1 < other.x0 for one, other in itertools.pairwise(ends))

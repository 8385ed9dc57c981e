"""Charts: what a request may ask, and numbers that are those of single joints."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.page.chart import chart_answer, chart_request, chart_results, result_rows
from asperity.page.joint_request import JointRequest
from asperity.page.requests import MOST_POINTS

CHART = {
    "over": "load.preload",
    "from": "500 N",
    "to": "2 kN",
    "points": 4,
    "result": "published_stiffness_output",
}


@pytest.fixture(scope="module")
def asked(joint_text):
    def ask(**entries):
        return chart_request({"toml": joint_text, "name": "my.toml", "chart": {**CHART, **entries}})

    return ask


@pytest.mark.slow
def test_a_chart_says_what_single_joints_say(asked, joint_text, described_as):
    """Over a number whose joints differ, up to one that slips; the points are solved one by one for comparison."""
    found = chart_answer(asked(over="load.output_torque", **{"from": "2 N*m", "to": "14 N*m"}))
    case = parse_case(joint_text, source="my.toml")
    assert found["x"] == pytest.approx([2.0, 6.0, 10.0, 14.0])
    for x, y in zip(found["x"][:3], found["curves"][0]["y"], strict=False):
        values = replace_values(si_values(case), {"load.output_torque": x})
        one = solve_joint(joint_from_values(values))
        assert y == pytest.approx(float(one.result.published.output), rel=1e-9)
    # the capacity of this joint is 13.16 N·m: beyond it there is no result, and the chart says why
    assert found["curves"][0]["y"][3] is None
    assert found["curves"][0]["status"][:3] == [0, 0, 0]
    (reason,) = found["reasons"].values()
    assert "beyond the standing torque capacity" in reason
    here = solve_joint(joint_from_case(case))
    assert found["joint"]["x"] == 5.0
    assert found["joint"]["y"] == pytest.approx(float(here.result.published.output), rel=1e-9)
    shown = here.result.published.output_per_arcminute
    assert found["joint"]["y_shown"] == pytest.approx(float(shown), rel=1e-9)
    assert described_as("Chart", found) == set()


def test_charts_of_files_with_branches_vary_what_is_asked_alone(joint_text, monkeypatch):
    """There are as many planets as sections: they cannot vary with the rest."""
    branches = "\n[[branch]]\nplanet_deviation = '1 um'\n" + 2 * "\n[[branch]]\n"
    text = joint_text.replace('preload = "1000 N"', 'interference = "13 um"') + branches
    seen = {}

    def evaluated(values, columns, results, **options):
        seen.update(columns)
        return np.zeros(5, dtype=int), {results[0]: np.ones(5)}

    monkeypatch.setattr("asperity.page.chart.evaluate_points", evaluated)
    over = {"over": "load.output_torque", "from": "1 N*m", "to": "4 N*m"}
    chart_answer(chart_request({"toml": text, "name": "my.toml", "chart": CHART | over}))
    assert set(seen) == {"load.output_torque"}


@pytest.mark.slow
def test_a_family_is_one_curve_for_each_value(asked):
    """The same program, whatever varies; a curve of the family is the chart of the joint with that value."""
    family = {"over": "load.output_torque", "values": ["5 N*m", "8000 N*mm"]}
    found = chart_answer(asked(family=family))
    single = chart_answer(asked())
    assert [curve["value"] for curve in found["curves"]] == [5.0, 8.0]
    assert found["curves"][0]["y"] == pytest.approx(single["curves"][0]["y"], rel=1e-12)
    assert found["curves"][1]["y"][-1] != pytest.approx(single["curves"][0]["y"][-1], rel=1e-6)
    assert found["joint"] is None


@pytest.mark.slow
def test_whole_numbers_take_whole_steps(asked):
    found = chart_answer(asked(over="drive.planets", **{"from": "2", "to": "4.5"}))
    assert found["x"] == [2.0, 3.0, 4.0]


def test_results_are_those_of_the_table(joint_text):
    request = JointRequest("my.toml", joint_text)
    rows = chart_results(request)
    names = [each["name"] for each in rows]
    assert {"assembly_stiffness_output", "slip_ratio_sp", "torque_capacity"} <= set(names)
    assert not any("limiting" in name for name in names)  # a category is no curve
    assert names == list(result_rows(results_of(si_values(request.case()))))


def test_results_of_another_drive_are_its_own(zou_file):
    text = zou_file.with_name("stepped_planet.toml").read_text(encoding="utf-8")
    rows = {each["name"]: each for each in chart_results(JointRequest("s.toml", text))}
    assert {"slip_ratio_sp", "slip_ratio_pr1", "slip_ratio_pr2"} <= set(rows)
    assert not any("pwr" in name or "loading_roller" in name for name in rows)
    assert rows["body_life_held_ring"]["label"] == "rating life of one body, held ring"
    assert rows["published_stiffness_input"]["label"] == "torsional stiffness at the input, asperities alone"


@pytest.mark.long
def test_a_chart_of_another_drive_says_what_single_joints_say(zou_file):
    """Over a wall that only such a file has, up to one that makes too little preload for the torque."""
    text = zou_file.with_name("planetary.toml").read_text(encoding="utf-8")
    chart = {
        "over": "drive.ring_wall_thickness", "from": "4 mm", "to": "10 mm", "points": 4,
        "result": "published_stiffness_output",
    }  # fmt: skip
    found = chart_answer(chart_request({"toml": text, "name": "p.toml", "chart": chart}))
    assert found["x_shown"] == pytest.approx([4.0, 6.0, 8.0, 10.0])
    for k, wall in ((2, 8.0), (3, 10.0)):
        case = parse_case(text.replace('"8 mm"', f'"{wall} mm"'), source="p")
        one = float(solve_joint(joint_from_case(case)).result.published.output)
        assert found["curves"][0]["y"][k] == pytest.approx(one, rel=1e-8)
    assert found["curves"][0]["y"][0] is None
    assert found["joint"]["y"] == pytest.approx(found["curves"][0]["y"][2], rel=1e-9)
    assert any("torque capacity" in reason for reason in found["reasons"].values())
    with pytest.raises(InputError, match=r"type planetary has no number 'drive\.loading_roller_radius'"):
        chart_answer(
            chart_request(
                {"toml": text, "name": "p", "chart": chart | {"over": "drive.loading_roller_radius"}}
            )
        )


@pytest.mark.parametrize(
    ("entries", "said"),
    [
        ({"points": 1}, "chart.points"),
        ({"points": MOST_POINTS + 1}, f"2 to {MOST_POINTS}"),
        ({"points": True}, "chart.points"),
        ({"scale": "square"}, "chart.scale: 'square' is not one of linear, log"),
        ({"from": 3}, "chart.from"),
        ({"what": 1}, "unknown entry 'what'"),
        ({"family": []}, "chart.family"),
        ({"family": {"over": "load.preload", "values": []}}, "a list of 1 to 5 entries is needed, got 0"),
        ({"family": {"over": "load.preload", "values": ["1 N"] * 6}}, "1 to 5 entries is needed, got 6"),
        ({"family": {"over": "load.preload", "values": [1]}}, "chart.family.values"),
    ],
)
def test_requests_that_make_no_sense(asked, entries, said):
    with pytest.raises(InputError, match=said):
        asked(**entries)


@pytest.mark.parametrize(
    ("entries", "said"),
    [
        ({"from": "5 mm"}, "load.preload: the start of the chart: expected a force"),
        ({"to": "500 N"}, "start and stop must differ"),
        ({"from": "-1 N"}, "load.preload"),
        ({"from": "0 N", "scale": "log"}, "above 0"),
        ({"over": "load.weight"}, "no number 'load.weight'"),
        (
            {"over": "compliance.pin_stiffness", "from": "1 N/um", "to": "2 N/um"},
            "does not state this number",
        ),
        ({"over": "drive.planets", "from": "1", "to": "300"}, "whole numbers"),
        ({"result": "stifness"}, "there is no result 'stifness'"),
        ({"family": {"over": "load.preload", "values": ["1 N"]}}, "two axes for the same number"),
    ],
)
def test_charts_that_cannot_be_drawn(asked, entries, said):
    with pytest.raises(InputError, match=said):
        chart_answer(asked(**entries))

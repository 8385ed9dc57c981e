"""A body is what its model says, or the first mistake is named with what is needed there."""

import pytest

from asperity.errors import InputError
from asperity.page.requests import (
    ChartRequest,
    CompareRequest,
    JobRequest,
    MeasurementQuery,
    Request,
    checked,
)

CHART = {"over": "load.preload", "from": "1 N", "to": "2 N", "result": "mass"}


def test_what_is_left_out_has_its_default():
    chart = checked(ChartRequest, {"toml": "x", "chart": CHART}).chart
    assert (chart.start, chart.stop, chart.points, chart.scale, chart.family) == (
        "1 N",
        "2 N",
        41,
        "linear",
        None,
    )
    job = checked(JobRequest, {"toml": "x", "job": {"kind": "uncertainty"}}).job
    assert (job.samples, job.seed, job.distribution) == (1000, 0, "")


def test_numbers_stay_what_they_are():
    """A whole number is no decimal one: texts of files and names of contents differ."""
    changes = checked(Request, {"toml": "x", "changes": {"a": 3, "b": 3.5, "c": "3 N"}}).changes
    assert [type(value) for value in changes.values()] == [int, float, str]


@pytest.mark.parametrize(
    ("model", "body", "said"),
    [
        (Request, None, "the body: a JSON object with 'toml', .*'name' is needed, got None"),
        (Request, {"toml": 3}, "toml: text is needed, got 3"),
        (Request, {"toml": "x", "changes": {"a.b": "1" * 201}}, "a.b: text .* got 201 characters"),
        (ChartRequest, {"toml": "x"}, "chart: a JSON object with 'over', .* it is missing"),
        (ChartRequest, {"toml": "x", "chart": CHART | {"points": 202}}, "chart.points: .* from 2 to 201 "),
        (
            ChartRequest,
            {"toml": "x", "chart": CHART | {"family": {"over": "a", "values": ["1", 1]}}},
            "chart.family.values.2: text of 1 to 200 characters is needed, got 1",
        ),
        (JobRequest, {"toml": "x", "job": {}}, "job.kind: None is not one of accuracy, design, film, "),
        (JobRequest, {"toml": "x", "job": {"kind": "design"}}, "job.design: text is needed, it is missing"),
        (CompareRequest, {"one": {}, "other": {}}, "one: give the joint either as 'toml'"),
        (MeasurementQuery, {"lay": "up"}, "lay: 'up' is not one of rolling, axis, isotropic"),
        (MeasurementQuery, {"no_data": "x" * 41}, "no_data: text of at most 40 .* got 41 characters"),
    ],
)
def test_a_mistake_is_said_with_what_is_needed(model, body, said):
    with pytest.raises(InputError, match=f"^{said}"):
        checked(model, body)

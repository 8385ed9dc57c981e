"""Maps of two axes: contours, limits, and why a region has no result."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.status import ALL_PLASTIC, SLIPS, flag_attributes
from asperity.study.sweep.sweep_map import MapLimit, _levels, limits_of_the_model, parse_limit
from asperity.study.sweep.sweep_plot import sweep_figure

xarray = pytest.importorskip("xarray", reason="the extra 'study' is not installed")
AXES = ("load.preload", "surface.fractal_roughness")


@pytest.fixture
def swept():
    """Stiffness in N·m/rad is the preload in N; the slip ratio of the first contact is 400 over it."""
    preload, roughness = np.linspace(500.0, 3000.0, 26), np.geomspace(1e-13, 1e-10, 31)
    force, g = np.meshgrid(preload, roughness, indexing="ij")
    status = np.where(force < 900.0, SLIPS, np.where(g > 5e-11, ALL_PLASTIC, 0)).astype(np.int8)
    stiffness = np.where(status == 0, force, np.nan)
    slip = np.stack([share * 400.0 / force for share in (1.0, 0.5, 0.5, 0.5, 0.5)])
    return xarray.Dataset(
        {
            "status": (AXES, status, flag_attributes()),
            "assembly_stiffness_output": (AXES, stiffness, {"long_name": "stiffness"}),
            "slip_ratio": (("contact", *AXES), slip, {"long_name": "friction used"}),
        },
        coords={AXES[0]: preload, AXES[1]: roughness},
    )


def legend(figure):
    return [text.get_text() for each in figure.legends for text in each.get_texts()]


def test_contours_have_round_labels_where_they_belong(swept):
    figure = sweep_figure(swept)
    panel = figure.axes[0]
    labels = {text.get_text(): text.get_position() for text in panel.texts}
    assert {"1000", "2000"} <= labels.keys()
    for label, (x, _) in labels.items():
        assert x == pytest.approx(float(label), rel=0.02)  # the stiffness is the preload
    assert panel.get_yscale() == "log"


def test_each_reason_of_failure_has_its_hatch_and_sentence(swept):
    figure = sweep_figure(swept)
    said = legend(figure)
    assert said[:2] == [
        "no solution: the output torque is beyond the standing torque capacity: a contact slips",
        "no solution: every spot of a loaded contact is plastic, where the contact law gives it no stiffness",
    ]
    hatches = [each.hatches for each in figure.axes[0].collections if getattr(each, "hatches", [None])[0]]
    assert len(hatches) == 2
    assert hatches[0] != hatches[1]


def test_a_limit_is_a_line_where_the_largest_contact_reaches_it(swept):
    figure = sweep_figure(swept, limits=[parse_limit("slip_ratio<0.2"), parse_limit("slip_ratio>=0.9")])
    assert legend(figure)[2:] == ["friction used ≤ 0.2"]  # the other is not crossed
    line = figure.axes[0].collections[-1]
    x = np.concatenate([path.vertices[:, 0] for path in line.get_paths()])
    assert x == pytest.approx(2000.0, rel=2e-3)


def test_limits_of_the_model_are_those_of_function_and_damage(swept):
    assert limits_of_the_model(swept) == (MapLimit("slip_ratio", True, 1.0),)


def test_a_result_that_is_the_same_everywhere_says_so(swept):
    swept["assembly_stiffness_output"] = swept["assembly_stiffness_output"] * 0.0 + 5.0
    assert "5 throughout" in sweep_figure(swept).axes[0].get_title()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("slip_ratio=0.8", "a limit is NAME<=VALUE"),
        ("slip_ratoi<=0.8", "did you mean 'slip_ratio'"),
        ("mass<=1.2 N", "limit of mass: .*expected a mass"),
        ("mass<=", "a limit is NAME<=VALUE"),
    ],
)
def test_what_is_no_limit_is_refused(text, message):
    with pytest.raises(InputError, match=message):
        parse_limit(text)


def test_limits_have_units():
    assert parse_limit(" mass >= 1200 g ") == MapLimit("mass", False, pytest.approx(1.2))


def test_a_limit_has_the_words_of_the_drive_that_was_swept(swept):
    assert parse_limit("slip_ratio<0.2").text_of(swept) == "friction used ≤ 0.2"
    assert parse_limit("slip_ratio>=0.2").text_of(swept) == "friction used ≥ 0.2"


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (1.5, 800.0, [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0]),
        (1.5, 8e8, [1.0, *(step * 10.0**k for k in range(9) for step in (3.0, 10.0))]),
        (1.5, 8e14, [10.0**k for k in range(16)]),
        (100.0, 2500.0, None),  # even steps: not thirty times as much
    ],
)
def test_levels_are_round_and_enclose_all_values(low, high, expected):
    """Steps of 1, 2, 5, or 1, 3, or 1 of each decade, so that there are at most 18 between the ends."""
    found = _levels(np.array([low, high, 0.5 * (low + high)]))
    if expected is not None:
        assert found == pytest.approx(expected, rel=1e-12)
    assert found[0] <= low
    assert found[1] > low
    assert found[-1] >= high
    assert found[-2] < high
    assert np.all(np.diff(found, 2) == 0.0) == (expected is None)

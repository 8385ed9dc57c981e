"""What the pictures of a joint that turns show: data, units and ticks, of made-up curves."""

import itertools
import math
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from asperity.rolling.curves import RollingCurves
from asperity.show.rolling_figure import rolling_figure

TORQUE = np.linspace(0.0, 12.0, 13)
SPEED = np.array([50.0, 100.0, 150.0])


def sheet(width=10.0, *, standing=False, lives=1e4 - 100.0 * TORQUE):
    traction = np.linspace(0.0, 0.1, 11)
    none = np.full(13, np.nan)
    curves = RollingCurves(
        torque_capacity=np.asarray(12.0),
        contact_traction=np.tile(traction, (5, 1)),
        contact_creepage=np.arange(1.0, 6.0)[:, None] * 1e-2 * traction,
        torque=TORQUE,
        drift_per_output_turn=1e-3 * TORQUE,
        life_turns=1e4 * lives,
        life_hours=none if standing else lives,
        map_torque=TORQUE[1:],
        map_speed=SPEED[:0] if standing else SPEED,
        efficiency=np.zeros((0, 12)) if standing else np.linspace(0.8, 0.99, 36).reshape(3, 12),
    )
    rolling = SimpleNamespace(
        creepage=np.full(5, 1e-3),
        traction_coefficient=np.array([0.1, 0.05, 0.04, 0.03, 0.02]),
        drift_per_output_turn=6e-3,
        life_hours=SimpleNamespace(drive=math.nan if standing else lives[6]),
        life_turns=SimpleNamespace(drive=1e4 * lives[6]),
    )
    joint = SimpleNamespace(
        contact_names=("sp", "pwr", "pwl", "wro", "wlo"),
        friction_coefficients=(0.12,),
        output_torque=6.0,
        input_speed=0.0 if standing else 100.0,
    )
    figure = rolling_figure(curves, rolling, joint=joint, title="a joint", width=width)
    figure.savefig("/dev/null", format="png")
    return figure


def data(axes):
    return [np.column_stack(line.get_data()) for line in axes.lines]


def panels(figure):
    return [axes for axes in figure.axes if axes.get_title()]


def test_creep_curves_working_points_and_limit():
    creep = panels(sheet())[0]
    lines = data(creep)
    for k in range(5):
        np.testing.assert_allclose(lines[2 * k][-1], [(k + 1.0), 0.1])  # 10^-3
        np.testing.assert_allclose(lines[2 * k + 1], [[1.0, [0.1, 0.05, 0.04, 0.03, 0.02][k]]])
    np.testing.assert_allclose(lines[10][:, 1], 0.12)
    assert [text.get_text() for text in creep.get_legend().get_texts()] == ["sp", "pwr", "pwl", "wro", "wlo"]
    assert creep.texts[0].get_text() == "gross slip at T/N = 0.12"


def test_drift_and_life_over_torque():
    _, _, drift, life = panels(sheet())
    arcminutes = 60.0 * 180.0 / math.pi
    curve, here, capacity = data(drift)
    np.testing.assert_allclose(curve, np.column_stack([TORQUE, arcminutes * 1e-3 * TORQUE]))
    np.testing.assert_allclose(here, [[6.0, arcminutes * 6e-3]])
    np.testing.assert_allclose(capacity[:, 0], 12.0)
    curve, here, _ = data(life)
    np.testing.assert_allclose(curve, np.column_stack([TORQUE, 1e4 - 100.0 * TORQUE]))
    np.testing.assert_allclose(here, [[6.0, 9400.0]])
    assert life.get_yscale() == "linear"


def test_map_over_torque_and_speed():
    figure = sheet()
    shown = panels(figure)[1]
    np.testing.assert_allclose(data(shown)[0], [[6.0, 100.0 * 30.0 / math.pi]])
    assert shown.get_ylim() == pytest.approx((50.0 * 30.0 / math.pi, 150.0 * 30.0 / math.pi))
    bar = next(axes for axes in figure.axes if axes.get_ylabel() == "efficiency [%]")
    assert bar.get_ylim()[0] <= 80.0
    assert 99.0 <= bar.get_ylim()[1] <= 100.0


def test_a_standing_sun_has_lives_in_turns_and_no_map():
    _, none, _, life = panels(sheet(standing=True))
    assert none.texts[0].get_text() == "no map: the input stands,\nno power is passed"
    assert life.get_ylabel() == "life [million output turns]"
    np.testing.assert_allclose(data(life)[1], [[6.0, 94.0]])


def test_lives_of_many_decades_are_on_a_logarithmic_axis():
    life = panels(sheet(lives=10.0 ** (9.0 - 0.3 * TORQUE)))[3]
    assert life.get_yscale() == "log"
    assert life.get_ylim() == (1e5, 1e9)


@pytest.mark.slow
@pytest.mark.parametrize("width", [6.5, 10.0])
def test_every_axis_has_its_unit_and_three_ticks_and_nothing_overlaps(width):
    figure = sheet(width)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    renderer = canvas.get_renderer()
    boxes = []
    for axes in panels(figure):
        for axis in (axes.xaxis, axes.yaxis):
            assert "[" in axis.get_label_text()
            low, high = sorted(axis.get_view_interval())
            labels = [
                label
                for tick, label in zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
                if low <= tick <= high
            ]
            assert len(labels) >= 3
            extents = [label.get_window_extent(renderer) for label in labels]
            assert not any(a.overlaps(b) for a, b in itertools.pairwise(extents))
        boxes.append(axes.get_tightbbox(renderer))
    assert not any(a.overlaps(b) for i, a in enumerate(boxes) for b in boxes[i + 1 :])

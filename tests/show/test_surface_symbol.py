"""Surface symbols: arms at 60 degrees on an extension line of the track, nothing where nothing is stated."""

import math

import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.stated_parts import stated_parts
from asperity.show.box import box_of
from asperity.show.part_sheets import part_sheets
from asperity.show.sheet import Line, Text
from asperity.show.surface_symbol import surface_symbol, symbols_of_tracks
from asperity.show.title_block import Title

AVERAGE = {'fractal_roughness = "1.3e-7 mm"': 'roughness_average = "0.2 um"'}


@pytest.mark.parametrize("scale", [0.5, 1.0, 5.0])
def test_the_symbol_has_the_shape_of_the_standard(scale):
    arms, text = surface_symbol(["Ra 0.2"], (10.0, 20.0), scale)
    short, foot, long, end = arms.points
    assert foot == (10.0, 20.0)
    for arm, side in ((short, -1.0), (long, 1.0)):
        across, up = (scale * (arm[axis] - foot[axis]) for axis in (0, 1))
        assert math.degrees(math.atan2(up, side * across)) == pytest.approx(60.0)
    assert scale * (short[1] - 20.0) == pytest.approx(3.5)
    assert scale * (long[1] - 20.0) >= 7.5
    assert end[1] == long[1]
    box = box_of(text, scale)
    assert box.high <= long[1]
    assert long[0] < text.at[0] < box.right - 0.8 / scale <= end[0]


def test_two_limits_stand_below_each_other():
    _, upper, lower = surface_symbol(["U Ra 0.25", "L Ra 0.15"], (0.0, 0.0), 1.0)
    assert (upper.text, lower.text) == ("U Ra 0.25", "L Ra 0.15")
    assert upper.at[1] - lower.at[1] > 2.5
    assert lower.at[1] > 0.0


def test_symbols_stand_outside_the_part():
    tracks = [(20.0, 0.0, 10.0, ("Ra 0.2",)), (15.0, 11.0, 21.0, ("Ra 0.2",))]
    items = symbols_of_tracks(tracks, 1.0)
    boxes = [box_of(item, 1.0) for item in items]
    assert all(box.right <= 0.0 for box in boxes[:3])
    assert all(box.left >= 21.0 for box in boxes[3:])
    assert [item.points[0] for item in items if isinstance(item, Line) and item.style == "thin"] == [
        (0.0, 20.0),
        (21.0, 15.0),
    ]
    assert symbols_of_tracks([(20.0, 0.0, 10.0, ())], 1.0) == []


@pytest.mark.parametrize(
    ("written", "symbol"),
    [
        ('roughness_average = "0.2 um"', ["Ra 0.2"]),
        ('roughness_average = "0.2 um +- 0.05 um"', ["U Ra 0.25", "L Ra 0.15"]),
        ('mean_roughness_depth = "1.6 um"', ["Rz 1.6"]),
        ('roughness_average = "0.2 um"\npartner_roughness_average = "0.1 um"', []),  # which body is which?
        ('fractal_roughness = "1.3e-7 mm"', []),
    ],
)
def test_every_part_has_the_symbol_that_the_file_states(planar_case, written, symbol):
    case = planar_case("planetary", replaced={'fractal_roughness = "1.3e-7 mm"': written})
    joint = joint_from_case(case)
    for name, sheet in part_sheets(
        joint, name="a", stated=stated_parts(case, joint), title=Title(), interference=None
    ).items():
        found = [text for text in sheet.texts if text.startswith(("Ra ", "Rz ", "U ", "L "))]
        assert found == symbol, name


def test_the_symbol_of_a_ring_stands_on_its_bore_and_that_of_a_roller_on_its_outside(planar_case):
    case = planar_case("planetary", replaced=AVERAGE)
    joint = joint_from_case(case)
    sheets = part_sheets(joint, name="a", stated=stated_parts(case, joint), title=Title(), interference=None)
    for name, height in (("sun", 10.0), ("planet", 20.0), ("ring", -50.0)):
        items = sheets[name].items
        text = next(item for item in items if isinstance(item, Text) and item.text == "Ra 0.2")
        arms = items[items.index(text) - 1]
        assert arms.points[1][1] == pytest.approx(height)

"""Every sheet of every example: nothing on anything else, filled, at the largest scale that fits."""

import functools
import math
from itertools import combinations, pairwise

import numpy as np
import pytest

from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.stated_parts import stated_parts
from asperity.show.box import Box, text_box
from asperity.show.drive_sheet import drive_sheet
from asperity.show.part_sheets import part_sheets
from asperity.show.sheet import Circle, Line, Text
from asperity.show.title_block import Title

NAMES = ("zou2025", "planetary", "multiroller", "stepped_planet", "planar", "wheel_pair")
#: ISO 5455.
SCALES = sorted(
    [50, 20, 10, 5, 2, 1, *(1.0 / (step * 10**power) for power in range(4) for step in (2, 5, 10))]
)
TITLE = Title(project="Wrist 30 N·m", part="W-100", revision="B", date="2026-11-26")
MARGIN = 10.0


@pytest.fixture(scope="module")
def sheets(planar_case):
    """Sheets of an example by their names: the drive, with its forces, and the parts."""

    @functools.cache
    def draw(name):
        case = planar_case(name)
        joint = joint_from_case(case)
        stated = stated_parts(case, joint)
        common = {"name": f"{name}.toml", "stated": stated, "title": TITLE, "interference": 13e-6}
        forces = solve_joint(joint).result
        return {
            "drive": drive_sheet(joint, section=True, **common),
            "forces": drive_sheet(joint, section=True, result=forces, **common),
            **part_sheets(joint, **common),
        }

    return draw


@pytest.fixture(params=NAMES)
def drawn(request, sheets):
    return sheets(request.param)


def ink(text, scale):
    """The box of a text without the room that it keeps free and without what is below its base line."""
    box, margin = text_box(text, scale), 0.8 / scale
    return Box(box.left + margin, box.right - margin, text.at[1], box.high - margin)


def texts_of(sheet):
    return [
        (item, ink(item, sheet.scale)) for item in sheet.items if isinstance(item, Text) and item.text.strip()
    ]


def test_no_text_covers_another_or_the_frame(drawn):
    for name, sheet in drawn.items():
        left, right, low, high = sheet.window
        edge = MARGIN / sheet.scale
        inside = Box(left + edge, right - edge, low + edge, high - edge)
        found = texts_of(sheet)
        for text, box in found:
            assert box.is_inside(inside), (name, text)
        for (one, box), (other, area) in combinations(found, 2):
            assert not box.meets(area), (name, one, other)


def test_no_text_covers_an_arrow_a_dimension_line_or_an_edge(drawn):
    for name, sheet in drawn.items():
        lines = [item for item in sheet.items if isinstance(item, Line) and item.style != "axis"]
        for text, box in texts_of(sheet):
            for line in lines:
                crossed = any(box.is_crossed_by(*ends) for ends in pairwise(line.points))
                assert not crossed, (name, text, line)


def test_the_frame_is_nowhere_crossed(drawn):
    for name, sheet in drawn.items():
        left, right, low, high = sheet.window
        edge = MARGIN / sheet.scale - 1e-9
        for item in sheet.items:
            points = item.points if isinstance(item, Line) else []
            if isinstance(item, Circle):
                points = [(item.centre[0] + u * item.radius, item.centre[1] + v * item.radius)
                          for u, v in ((1, 0), (-1, 0), (0, 1), (0, -1))]  # fmt: skip
            for x, y in points:
                assert left + edge <= x <= right - edge, (name, item)
                assert low + edge <= y <= high - edge, (name, item)


def test_more_than_a_third_of_every_sheet_is_drawn_on(drawn):
    """Points of a grid of 1 mm within the boxes of views, notes and title block, in which all texts are."""
    for name, sheet in drawn.items():
        x, y = np.meshgrid(np.arange(0.5, sheet.width), np.arange(0.5, sheet.height))
        covered = np.zeros(x.shape, dtype=bool)
        for left, right, low, high in sheet.areas:
            covered |= (left < x) & (x < right) & (low < y) & (y < high)
        assert covered.mean() >= 0.35, name
        for text, _ in texts_of(sheet):
            at = [origin + sheet.scale * place for origin, place in zip(sheet.origin, text.at, strict=True)]
            assert any(
                left <= at[0] <= right and low <= at[1] <= high for left, right, low, high in sheet.areas
            ), (name, text)


def test_the_scale_is_of_the_standard_and_the_next_larger_one_does_not_fit(drawn):
    """Views grow with the scale, their texts do not; beside them is the title block, and the notes are somewhere."""
    for name, sheet in drawn.items():
        step = next(n for n, scale in enumerate(SCALES) if scale == pytest.approx(sheet.scale, rel=1e-12))
        growth = SCALES[step + 1] / sheet.scale
        *views, _, _ = sheet.areas
        front = [each for each in sheet.items if isinstance(each, Circle) and in_area(sheet, each, views[0])]
        lows, highs = zip(*((c.centre[1] - c.radius, c.centre[1] + c.radius) for c in front), strict=True)
        lefts, rights = zip(*((c.centre[0] - c.radius, c.centre[0] + c.radius) for c in front), strict=True)
        high = growth * sheet.scale * (max(highs) - min(lows))
        wide = growth * sheet.scale * (max(rights) - min(lefts))
        beside = (
            sum(right - left for left, right, _, _ in views) - wide / growth
        )  # section, forces, dimensions
        room_wide, room_high = sheet.width - 2.0 * MARGIN, sheet.height - 2.0 * MARGIN
        above_the_block = high + 38.0 <= room_high and wide + beside <= room_wide
        beside_the_block = high <= room_high and wide + beside + 93.0 <= room_wide
        assert not above_the_block, (name, growth, high, wide, beside)
        assert not beside_the_block, (name, growth, high, wide, beside)


def in_area(sheet, circle, area):
    """Whether the centre of a circle lies in an area of the paper."""
    x, y = (origin + sheet.scale * place for origin, place in zip(sheet.origin, circle.centre, strict=True))
    left, right, low, high = area
    return left < x < right and low < y < high


def test_every_arrow_of_a_force_has_its_letter_at_its_free_end(sheets):
    for name in NAMES:
        sheet = sheets(name)["forces"]
        arrows = [item.points for item in sheet.items if isinstance(item, Line) and item.style == "force"]
        letters = [
            (item, ink(item, sheet.scale)) for item, _ in texts_of(sheet) if item.text in ("N", "T", "F")
        ]
        assert len(arrows) == len(letters) > 0
        for arrow in arrows:
            near = min(
                math.hypot(max(box.left - x, x - box.right, 0.0), max(box.low - y, y - box.high, 0.0))
                for x, y in arrow
                for _, box in letters
            )
            assert near * sheet.scale < 3.5, (name, arrow)

"""Which sheet a drawing has: nothing overlaps, the largest scale, the smallest format, refusals."""

from itertools import combinations

import pytest

from asperity.errors import InputError
from asperity.show.arrangement import LEAST_DRAWN, Room, arrange, largest_on
from asperity.show.box import Box
from asperity.show.paper import FORMATS, SCALES

NOTES = [f"note {number}" for number in range(12)]


def square(size, around=10.0):
    """A view of a square [mm] with room for dimensions on each side."""
    return lambda scale: [
        Room(Box(*([-0.5 * scale * size - around, 0.5 * scale * size + around] * 2)), (scale * size,) * 2)
    ]


def three(scale):
    """A flat section, a view, and forces, which need not be level."""
    return [
        Room(Box(-5.0, 5.0 * scale + 30.0, -60.0 * scale, 60.0 * scale + 6.0), (5.0 * scale, 120.0 * scale)),
        Room(
            Box(-60.0 * scale - 20.0, 60.0 * scale + 40.0, -60.0 * scale - 10.0, 60.0 * scale),
            (120.0 * scale,) * 2,
        ),
        Room(Box(-40.0, 40.0, -20.0, 50.0), level=False),
    ]


def arranged(views, lines=NOTES, origin=0, size=100.0):
    return arrange(views, lines, origin=origin, what="the drive", size=size)


@pytest.mark.parametrize("views", [square(30.0), square(122.0), square(500.0), three])
def test_nothing_overlaps_and_all_is_inside_the_frame(views):
    found = arranged(views)
    paper = found.paper
    inside = Box(10.0, paper.width - 10.0, 10.0, paper.height - 10.0)
    notes = [Box(x, x + 20.0, y, y + 2.5) for (x, y), _ in found.notes]
    boxes = [*found.boxes, *notes, paper.title_box]
    assert all(box.is_inside(inside) for box in boxes)
    assert not [pair for pair in combinations(boxes, 2) if pair[0].meets(pair[1])]
    assert [line for _, line in found.notes if line.strip()] == NOTES
    assert paper.middle == found.origins[0]
    for room, (x, y), box in zip(views(paper.scale), found.origins, found.boxes, strict=True):
        left, right, low, high = room.box
        assert box == pytest.approx((x + left, x + right, y + low, y + high))
    assert len({y for room, (_, y) in zip(views(paper.scale), found.origins, strict=True) if room.level}) == 1


@pytest.mark.parametrize(
    ("size", "scale"), [(122.0, 1.0), (60.0, 2.0), (30.0, 5.0), (8.0, 20.0), (250.0, 0.5), (1300.0, 0.1)]
)
def test_the_scale_is_the_largest_whose_view_fits_between_the_frames(size, scale):
    """The frame is 20 mm less than the paper; the next larger scale has no room beside the notes or above them."""
    found = arranged(square(size), size=size)
    assert found.paper.scale == scale
    larger = SCALES[SCALES.index(scale) - 1] * size + 20.0
    paper = found.paper
    assert larger > paper.height - 20.0 or larger > paper.width - 20.0 - 95.0
    assert larger > paper.height - 20.0 - 38.0


@pytest.mark.parametrize("size", [8.0, 30.0, 60.0, 122.0, 250.0, 500.0, 1300.0])
def test_the_sheet_is_the_smallest_that_the_drawing_fills(size):
    found = arranged(square(size), size=size)
    assert found.drawn >= LEAST_DRAWN
    here = next(n for n, form in enumerate(FORMATS) if (form.width, form.height) == found.paper[:2])
    for form in FORMATS[:here]:
        other = largest_on(form, square(size), NOTES, 0)
        assert other is None or other.drawn < LEAST_DRAWN or other.outlined < other.least_outlined


def test_what_fills_no_sheet_has_one_of_its_size():
    """A flat bar of 400 mm by 20 mm: not enlarged on A0."""

    def bar(scale):
        wide, high = 400.0 * scale, 20.0 * scale
        return [
            Room(
                Box(-0.5 * wide - 10.0, 0.5 * wide + 10.0, -0.5 * high - 10.0, 0.5 * high + 10.0),
                (wide, high),
            )
        ]

    found = arranged(bar, size=400.0)
    assert found.paper.scale <= 1.0 or found.paper.width <= 420.0
    shares = [one.outlined for form in FORMATS[:4] if (one := largest_on(form, bar, NOTES, 0))]
    assert found.outlined == max(shares)


def test_large_diagrams_of_forces_beside_a_small_drive_have_a_sheet():
    """Forces of 201 mm by 238 mm beside a drive of 96 mm, for which A3 has no room and A2 would enlarge it."""
    forces = Room(Box(-100.5, 100.5, -119.0, 119.0), level=False)
    found = arranged(lambda scale: [*square(96.0)(scale), forces], lines=NOTES * 4, size=96.0)
    assert found.paper.scale <= 1.0 or found.paper.width <= 420.0


def test_the_share_that_is_drawn_is_that_of_the_boxes():
    found = arranged(square(122.0))
    (view,) = found.boxes
    assert view.width * view.height + 95.0 * 38.0 < found.drawn * found.paper.width * found.paper.height
    assert found.outlined * found.paper.width * found.paper.height == pytest.approx(
        (122.0 * found.paper.scale) ** 2
    )


@pytest.mark.parametrize(
    ("size", "needed"),
    [(2e7, "1:50000"), (1e9, "1:2000000"), (0.04, "2000:1"), (2e-3, "50000:1")],
)
def test_what_no_sheet_can_show_is_refused_with_the_scale_that_it_would_need(size, needed):
    with pytest.raises(InputError) as told:
        arranged(square(size), size=size)
    said = str(told.value)
    assert said.startswith(f"the drive is {size:.4g} mm across")
    assert f"scale of {needed}" in said
    assert "check the units" in said
    assert "\n" not in said


def test_many_notes_have_more_columns_or_a_larger_sheet_and_never_smaller_letters():
    lines = [f"line {number} of a long list of notes" for number in range(150)]
    found = arranged(square(100.0), lines=lines)
    assert {item.height for item in found.note_items()} == {2.5}
    assert len({x for (x, _), _ in found.notes}) > 1

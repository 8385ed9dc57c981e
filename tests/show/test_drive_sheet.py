"""The sheet of a drive: everything on the paper, the scale, the words, and hostile names."""

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from asperity.joint.solve import solve
from asperity.show.drive_sheet import drive_sheet
from asperity.show.sheet_figure import sheet_figure


@pytest.mark.parametrize("forces", [False, True])
@pytest.mark.parametrize("name", ["zou2025", pytest.param("tutorial_joint", marks=pytest.mark.slow)])
def test_every_text_is_inside_the_frame_and_covers_no_other(joint_of, name, forces):
    joint = joint_of(name)
    found = solve(joint).result.forces if forces else None
    figure = sheet_figure(drive_sheet(joint, name="x" * 300, forces=found))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    boxes = [
        (text.get_text(), text.get_window_extent(canvas.get_renderer())) for text in figure.axes[0].texts
    ]
    margin = 10.0 / 25.4 * figure.dpi
    for text, box in boxes:
        if text:
            assert margin < box.x0 < box.x1 < figure.bbox.width - margin, text
            assert margin < box.y0 < box.y1 < figure.bbox.height - margin, text
    for index, (text, box) in enumerate(boxes):
        assert not [other for other, area in boxes[index + 1 :] if text and other and box.overlaps(area)], (
            text
        )


def test_words_of_the_sheet(joint_of):
    sheet = drive_sheet(joint_of(), name="examples/zou2025.toml")
    assert (sheet.width, sheet.height, sheet.scale) == (297.0, 210.0, 1.0)
    texts = " | ".join(sheet.texts)
    assert "ring: inside ⌀80, wall 60, outside ⌀200 | the wall is broken off at the wavy line" in texts
    assert "A  neighbouring planets 3.311" in texts
    assert "Scale 1:1   dimensions in mm" in texts
    assert "axes only" in texts


def test_overlap_is_said(joint_of):
    sheet = drive_sheet(joint_of(drive__planets=4.0), name="a")  # 4 planets of 27 mm do not fit around 8 mm
    assert any("neighbouring planets -2.25" in text and "OVERLAP" in text for text in sheet.texts)


def test_a_hostile_name_is_one_harmless_line(joint_of):
    sheet = drive_sheet(joint_of(), name="a\x1b[31m\n0\nSECTION$x$")
    assert all(text.isprintable() for text in sheet.texts)

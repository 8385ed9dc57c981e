"""The sheet of a drive: everything on the paper, the scale, the words, and hostile names."""

import types

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from asperity.joint.solve import solve
from asperity.show.drive_sheet import drive_sheet, forces_sheet
from asperity.show.sheet_figure import sheet_figure


def boxes_of(sheet):
    """Every text with the place that it takes on a figure, and the figure."""
    figure = sheet_figure(sheet)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    texts = figure.axes[0].texts
    return figure, [
        (text.get_text(), text.get_window_extent(canvas.get_renderer())) for text in texts if text.get_text()
    ]


@pytest.mark.parametrize("forces", [False, True])
@pytest.mark.parametrize("name", ["zou2025", pytest.param("tutorial_joint", marks=pytest.mark.slow)])
def test_every_text_is_inside_the_frame_and_covers_no_other(joint_of, name, forces):
    joint = joint_of(name)
    found = solve(joint).result.forces if forces else None
    figure, boxes = boxes_of(drive_sheet(joint, name="x" * 300, forces=found, interference=13.57e-6))
    margin = 10.0 / 25.4 * figure.dpi
    for text, box in boxes:
        assert margin < box.x0 < box.x1 < figure.bbox.width - margin, text
        assert margin < box.y0 < box.y1 < figure.bbox.height - margin, text
    for index, (text, box) in enumerate(boxes):
        assert not [other for other, area in boxes[index + 1 :] if box.overlaps(area)], text


@pytest.mark.parametrize(
    "sizes",
    [(4.0, 13.5, 5.0, 40.0), (5.0, 13.0, 5.0, 39.0), (3.0, 15.0, 9.0, 40.0), (20.0, 8.0, 9.0, 48.0)],
)
@pytest.mark.parametrize("alone", [False, True])
def test_forces_of_other_sizes_stay_inside_the_frame(joint_of, sizes, alone):
    """Radii of sun, planet, loading roller and ring in mm; the last drive has its rollers beside the planet."""
    names = ("sun_radius", "planet_radius", "loading_roller_radius", "ring_radius")
    joint = joint_of(
        drive__planets=2.0,
        **{f"drive__{name}": 1e-3 * size for name, size in zip(names, sizes, strict=True)},
    )
    forces = types.SimpleNamespace(
        normal=np.full(5, 1234.5),
        tangential=np.full(5, 123.45),
        pin_right=123.45,
        pin_left=-123.45,
        input_torque=0.5,
        output_torque=5.0,
    )
    sheet = forces_sheet(joint, forces) if alone else drive_sheet(joint, name="a", forces=forces)
    figure, boxes = boxes_of(sheet)
    margin = 0.0 if alone else 10.0 / 25.4 * figure.dpi
    for index, (text, box) in enumerate(boxes):
        assert margin < box.x0 < box.x1 < figure.bbox.width - margin, text
        assert margin < box.y0 < box.y1 < figure.bbox.height - margin, text
        assert not any(box.overlaps(other) for _, other in boxes[index + 1 :]), text


def test_words_of_the_sheet(joint_of):
    sheet = drive_sheet(joint_of(), name="examples/zou2025.toml")
    assert (sheet.width, sheet.height, sheet.scale) == (297.0, 210.0, 1.0)
    texts = " | ".join(sheet.texts)
    assert "   outside ⌀200 | the wall is broken off at the wavy line" in texts
    assert "A  neighbouring planets 3.311" in texts
    assert "Scale 1:1   dimensions in mm" in texts
    assert "axes only" in texts
    assert sheet.texts.count("⌀80 less 2 × interference") == 1
    assert "interference on the radius not known" in texts


def test_the_ring_is_drawn_with_the_bore_that_is_made(joint_of):
    """A ring of 94 mm, as it was drawn, has no preload: 47 µm on the radius make it 93.906 mm."""
    joint = joint_of(drive__ring_radius=47e-3, drive__planet_radius=17e-3)
    sheet = drive_sheet(joint, name="a", interference=47e-6)
    texts = " | ".join(sheet.texts)
    assert "⌀93.906" in sheet.texts
    assert "⌀94" not in sheet.texts
    assert "ring: made bore ⌀93.906, | " in texts
    assert "interference 47 µm on the radius |    (all just touch in ⌀94)" in texts


def test_overlap_is_said(joint_of):
    sheet = drive_sheet(joint_of(drive__planets=4.0), name="a")  # 4 planets of 27 mm do not fit around 8 mm
    assert any("neighbouring planets -2.25" in text and "OVERLAP" in text for text in sheet.texts)


def test_a_hostile_name_is_one_harmless_line(joint_of):
    sheet = drive_sheet(joint_of(), name="a\x1b[31m\n0\nSECTION$x$")
    assert all(text.isprintable() for text in sheet.texts)

"""The picture of the README."""

import numpy as np
import pytest


@pytest.mark.slow
def test_levels_are_ordered_and_the_published_one_peaks_near_1_85(load_example, tmp_path, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    example = load_example("stiffness_picture")
    dimension = np.linspace(1.3, 1.95, 66)
    levels = example.stiffness_levels(dimension)
    published, series, assembled = levels.values()
    assert np.all((published > series) & (series > assembled))
    assert dimension[np.argmax(published)] == pytest.approx(1.85, abs=0.02)  # claim C9 of the paper
    figure = example.draw(dimension, levels)
    figure.savefig(tmp_path / "levels.png")
    drive, panel = figure.axes
    assert "ring, inner radius 40 mm, wall 60 mm" in [t.get_text() for t in drive.get_legend().get_texts()]
    assert panel.get_yscale() == "log"
    assert panel.get_ylabel() == "stiffness at the output [N·m/rad]"
    for line, values in zip(panel.lines, levels.values(), strict=True):
        np.testing.assert_array_equal(line.get_ydata(), values)
    words = [text.get_text() for text in panel.texts]
    assert [next(w for w in ("published", "series", "assembled") if w in text) for text in words] == [
        "published",
        "series",
        "assembled",
    ]

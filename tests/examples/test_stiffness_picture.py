"""The picture of the README."""

import numpy as np
import pytest


def test_levels_are_ordered_and_the_published_one_peaks_near_1_85(load_example, tmp_path, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    example = load_example("stiffness_picture")
    dimension = np.linspace(1.3, 1.95, 66)
    levels = example.stiffness_levels(dimension)
    published, series, assembled = levels.values()
    assert np.all((published > series) & (series > assembled))
    assert dimension[np.argmax(published)] == pytest.approx(1.85, abs=0.02)  # claim C9 of the paper
    example.draw(dimension, levels).savefig(tmp_path / "levels.png")
    assert (tmp_path / "levels.png").stat().st_size > 20_000

"""The drift curve of the documentation is what its script writes, and its intervals are counted rightly."""

from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def example(load_example, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    return load_example("calibrate_drift")


@pytest.mark.slow
def test_the_file_is_that_of_the_model(example, tmp_path):
    example.main(str(tmp_path / "drift.csv"))
    written, expected = (
        np.loadtxt(folder / name, delimiter=",", skiprows=2)
        for folder, name in ((tmp_path, "drift.csv"), (EXAMPLES, "calibrate_drift.csv"))
    )
    np.testing.assert_allclose(written, expected, atol=0.1)  # arcmin; the file has errors of 0.2


@pytest.mark.long
def test_coverage(example):
    found = example.coverage(5)
    assert list(found) == ["load.preload", "load.friction_coefficient", "offset"]
    for held, width, spread in found.values():
        assert held >= 3  # of five intervals of 95 %
        assert 0.0 < spread < 2.0 * width

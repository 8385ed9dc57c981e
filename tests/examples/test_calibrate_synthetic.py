"""The torque–angle curve of the documentation is that of today's model, within the errors that it has anyway."""

from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.slow
def test_the_file_is_that_of_the_model(load_example, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    example = load_example("calibrate_synthetic")
    data = example.synthetic(seed=1)
    written = np.loadtxt(EXAMPLES / "calibrate_curve.csv", delimiter=",", skiprows=2)
    np.testing.assert_allclose(written[:, 3], data.angle / example.ARCMIN, atol=2e-3)
    np.testing.assert_allclose(written[:, 2], data.torque, atol=1e-9)

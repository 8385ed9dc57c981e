"""The table of swings is what its script computes."""

import numpy as np
import pytest


@pytest.mark.slow
def test_an_entry_of_the_table(load_example, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    example = load_example("rolling_swing")
    from asperity.contact.rolling_in import SLIP_RATIOS, STROKES, swing_drift_share

    row, column = 5, 8
    q, stroke = SLIP_RATIOS[row], STROKES[column] * (1.0 - SLIP_RATIOS[row])
    found = example.drift_share(q, round(stroke / example.PIXEL))
    assert found == pytest.approx(0.633, abs=2e-3)
    assert float(swing_drift_share(stroke=stroke, half_width=1.0, slip_ratio=q)) == pytest.approx(
        found, abs=2e-3
    )
    assert np.all(np.diff(STROKES) > 0.0)

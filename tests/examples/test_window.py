"""The example closes where the housing lets its ring go, by hand."""

import numpy as np
import pytest

#: Expansion of the aluminium less that of the steel [1/K]; seat of the ring: its bore of 50 mm and a wall of 20 mm.
APART, SEAT = 23.6e-6 - 12.6e-6, 2.0 * 0.070


@pytest.mark.slow
def test_no_torque_is_allowed_from_where_the_seat_is_lost(load_example, tmp_path):
    found = load_example("window").main(tmp_path / "window.png")
    lost = 20.0 + 60e-6 / (SEAT * APART)
    closed = found.window.regions[0].capacity.torque == 0.0
    assert np.array_equal(closed, found.window.at > lost)
    assert found.inside
    assert (tmp_path / "window.png").stat().st_size > 10_000

"""The map of preload and torque."""

import re

import numpy as np


def test_the_map_ends_at_the_capacity(load_example, monkeypatch, tmp_path, saved_figures):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    # the capacity at 1000 N is 13.2 N·m by bisection (asperity windup): 13 is the last step of 1 N·m below it
    assert load_example("sweep_preload").main(tmp_path / "map.png") == 13.0
    (figure,) = saved_figures
    panel, bar = figure.axes
    assert (panel.get_xlabel(), panel.get_ylabel()) == ("output torque [N·m]", "preload [N]")
    assert bar.get_ylabel() == "torsional stiffness at the output [N·m/rad]"
    stiffness = np.ma.masked_invalid(panel.collections[0].get_array()).reshape(26, 41)
    # no colour where a contact slips, and more torque with more preload
    failed = int(re.search(r"1066 points, (\d+) without a result", figure.get_suptitle())[1])
    assert stiffness.count() == 1066 - failed
    assert np.all(np.diff(stiffness.count(axis=1)) >= 0)

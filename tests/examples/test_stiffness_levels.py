"""The three levels of the paper's joint, against the independent assembly in benchmarks/baseline_assembly.py."""

import pytest


def test_levels_of_the_papers_joint(load_example, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    result = load_example("stiffness_levels").main()
    # printed by benchmarks/baseline_assembly.py for a solid ring at 0 N·m and 0 rpm; 60 mm of wall is within 1e-3 of it
    assert float(result.published.output) == pytest.approx(5.0413e6, rel=2e-5)
    assert float(result.series_with_bulk.output) == pytest.approx(3.1710e5, rel=1e-3)
    assert float(result.assembly.stiffness.output) == pytest.approx(3.0892e4, rel=1e-3)

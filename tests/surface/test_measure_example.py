"""The example finds the D it put in."""

import importlib.util
from pathlib import Path


def test_example():
    path = Path(__file__).parents[2] / "examples" / "measure_surface.py"
    spec = importlib.util.spec_from_file_location("measure_surface", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    low, high = module.main().dimension_interval(confidence=0.999)
    assert low < 1.5 < high
    assert high - low < 0.05

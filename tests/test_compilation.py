import numpy as np

from asperity import compilation
from asperity.compilation import compile_fast


def _twice(numbers):
    return {name: 2.0 * value for name, value in numbers.items()}


def test_a_compiled_function_computes_the_same_and_is_kept():
    numbers = {"a": np.float64(1.5), "b": np.arange(3.0)}
    compiled = compile_fast(_twice, numbers)
    np.testing.assert_array_equal(compiled(numbers)["b"], [0.0, 2.0, 4.0])
    assert compile_fast(_twice, {"a": np.float64(7.0), "b": np.zeros(3)}) is compiled
    assert compile_fast(_twice, {"a": np.float64(7.0), "b": np.zeros(4)}) is not compiled


def test_a_compiler_without_the_options_is_no_obstacle(monkeypatch):
    monkeypatch.setattr(compilation, "_COMPILE_FAST", {"xla_option_of_another_release": True})
    assert compile_fast(_twice, {"c": np.float64(2.0)})({"c": np.float64(2.0)})["c"] == 4.0

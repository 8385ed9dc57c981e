"""Programs of JAX for the points of studies: one for each function and shape, compiled where signals do not wait."""

import threading

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity import compilation
from asperity.compilation import program_for_few, program_for_many
from asperity.linear import solve_in_turn


def _times(factor, table):
    return float(factor) * table


def test_a_program_serves_all_arrays_of_one_shape():
    program = program_for_few(_times, np.arange(3.0), options=("2",))
    np.testing.assert_array_equal(program(np.arange(3.0)), [0.0, 2.0, 4.0])
    assert program_for_few(_times, np.zeros(3), options=("2",)) is program
    for others in ((np.zeros(4), ("2",)), (np.zeros(3), ("3",))):
        assert program_for_few(_times, others[0], options=others[1]) is not program
    often = program_for_few(_times, np.zeros(3), options=("2",), often=True)
    np.testing.assert_array_equal(often(np.arange(3.0)), [0.0, 2.0, 4.0])


@pytest.mark.parametrize("which", ["_FOR_FEW", "_FOR_MANY"])
def test_a_compiler_without_an_option_is_no_obstacle(monkeypatch, which):
    monkeypatch.setattr(compilation, which, {"xla_option_of_another_release": True})
    table = np.arange(3000.0).reshape(1000, 3)

    def squares(table):
        return jnp.sum(table * table, axis=1)

    for program in (program_for_few(squares, table), program_for_many(squares, table)):
        np.testing.assert_array_equal(program(table), (table**2).sum(axis=1))


@pytest.mark.parametrize("compiled", [program_for_few, program_for_many])
def test_no_signal_waits_for_a_program(monkeypatch, compiled):
    """A signal reaches the main thread only between two steps of Python, of which XLA makes none while it compiles."""
    compiled_in, submit = [], compilation._compilers().submit

    def noting(function):
        return submit(lambda: compiled_in.append(threading.current_thread()) or function())

    monkeypatch.setattr(compilation._compilers(), "submit", noting)
    compiled(lambda table: 2.0 * table, np.arange(3.0))
    assert len(compiled_in) == 1
    assert compiled_in != [threading.main_thread()]


def test_elimination_is_written_out_for_processors_only(monkeypatch):
    shapes = [jax.ShapeDtypeStruct(shape, np.float64) for shape in ((4, 3, 3), (4, 3))]

    def solutions(matrices, right_sides):
        return jax.vmap(solve_in_turn)(matrices, right_sides)

    assert "lapack" not in program_for_many(solutions, *shapes).as_text()
    monkeypatch.setattr(jax, "default_backend", lambda: "gpu")
    assert "lapack" in program_for_many(lambda *given: solutions(*given), *shapes).as_text()

import hashlib
import json
import os
import threading
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity import compilation, kept_programs
from asperity.compilation import call_compiled, called_programs, compile_fast, compile_for_many
from asperity.linear import solve_in_turn


def _twice(numbers):
    return {name: 2.0 * value for name, value in numbers.items()}


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """A compilation cache of this test's own, which keeps the functions of this module."""
    monkeypatch.setattr(kept_programs, "_PACKAGE", __name__.partition(".")[0])
    before = jax.config.jax_compilation_cache_dir
    jax.config.update("jax_compilation_cache_dir", str(tmp_path))
    compilation._compiled.cache_clear()
    yield tmp_path
    jax.config.update("jax_compilation_cache_dir", before)
    compilation._compiled.cache_clear()


def test_a_compiled_function_computes_the_same_and_is_kept():
    numbers = {"a": np.float64(1.5), "b": np.arange(3.0)}
    compiled = compile_fast(_twice, numbers)
    np.testing.assert_array_equal(compiled(numbers)["b"], [0.0, 2.0, 4.0])
    assert compile_fast(_twice, {"a": np.float64(7.0), "b": np.zeros(3)}) is compiled
    longer = {"a": np.float64(7.0), "b": np.zeros(4)}
    assert compile_fast(_twice, longer) is not compiled
    assert compile_fast(_twice, longer)(longer)["b"].shape == (4,)


def test_programs_are_forgotten_where_they_fill_the_memory(cache, monkeypatch):
    """As many as :data:`_FEWEST` at least; what is called next is read again and computes the same."""
    monkeypatch.setattr(compilation, "_FEWEST", 2)
    monkeypatch.setattr(compilation, "_resident", lambda: 0)
    shapes = [{"e": np.arange(float(length))} for length in (2, 3, 4, 5)]
    kept = [compile_fast(_twice, numbers) for numbers in shapes[:3]]
    assert [compile_fast(_twice, numbers) for numbers in shapes[:3]] == kept
    monkeypatch.setattr(compilation, "_resident", lambda: compilation._MOST_MEMORY + 1)
    last = compile_fast(_twice, shapes[3])
    again = compile_fast(_twice, shapes[0])
    assert again is not kept[0]
    assert compile_fast(_twice, shapes[3]) is last
    np.testing.assert_array_equal(again(shapes[0])["e"], kept[0](shapes[0])["e"])


@pytest.mark.skipif(
    not Path("/proc/self/statm").exists(), reason="the system does not tell the memory of a process"
)
def test_the_memory_of_this_process_is_known():
    before = compilation._resident()
    filled = np.ones(50_000_000)
    assert 0.9 * filled.nbytes < compilation._resident() - before < 1.3 * filled.nbytes


def test_a_compiler_without_the_options_is_no_obstacle(monkeypatch):
    monkeypatch.setattr(compilation, "_COMPILE_FAST", ({"xla_option_of_another_release": True}, {}))
    assert compile_fast(_twice, {"c": np.float64(2.0)})({"c": np.float64(2.0)})["c"] == 4.0


def test_a_program_of_many_points_needs_none_of_its_options(monkeypatch):
    def squares(table):
        return jnp.sum(table * table, axis=1)

    table = np.arange(3000.0).reshape(1000, 3)
    np.testing.assert_array_equal(compile_for_many(squares, table)(table), (table**2).sum(axis=1))
    monkeypatch.setattr(compilation, "_FOR_MANY", ({"xla_option_of_another_release": True}, {}))
    np.testing.assert_array_equal(compile_for_many(squares, table)(table), (table**2).sum(axis=1))


def test_no_signal_waits_for_a_program_of_many_points(monkeypatch):
    """A signal reaches the main thread only between two steps of Python, of which XLA makes none while it compiles."""
    compiled_in, before = [], compilation._compiled_with

    def compiled_with(*given):
        compiled_in.append(threading.current_thread())
        return before(*given)

    monkeypatch.setattr(compilation, "_compiled_with", compiled_with)
    compile_for_many(lambda table: 2.0 * table, np.arange(3.0))
    assert compiled_in != [threading.main_thread()]
    assert len(compiled_in) == 1


def test_elimination_is_written_out_for_processors_only(monkeypatch):
    shapes = [jax.ShapeDtypeStruct(shape, np.float64) for shape in ((4, 3, 3), (4, 3))]

    def solutions(matrices, right_sides):
        return jax.vmap(solve_in_turn)(matrices, right_sides)

    assert "lapack" not in compile_for_many(solutions, *shapes).as_text()
    monkeypatch.setattr(jax, "default_backend", lambda: "gpu")
    assert "lapack" in compile_for_many(lambda *given: solutions(*given), *shapes).as_text()


def _programs(folder):
    return [path for path in folder.iterdir() if path.suffix == ".program"]


def test_a_program_is_kept_on_disk_and_found_again(cache, monkeypatch):
    numbers = {"d": np.arange(2.0)}
    np.testing.assert_array_equal(compile_fast(_twice, numbers)(numbers)["d"], [0.0, 2.0])
    assert len(_programs(cache)) == 1
    compilation._compiled.cache_clear()  # as in a new process

    def never(*arguments):
        raise AssertionError("it was followed again instead of being read")

    monkeypatch.setattr(compilation, "_traced", never)
    np.testing.assert_array_equal(compile_fast(_twice, numbers)(numbers)["d"], [0.0, 2.0])


def test_a_damaged_program_is_made_again(cache):
    numbers = {"e": np.float64(2.0)}
    compile_fast(_twice, numbers)(numbers)
    (file,) = _programs(cache)
    file.write_bytes(b"damaged")
    compilation._compiled.cache_clear()
    assert compile_fast(_twice, numbers)(numbers)["e"] == 4.0
    assert file.stat().st_size > 100


def test_a_program_that_cannot_be_loaded_is_made_again(cache, monkeypatch):
    numbers = {"e": np.float64(2.0)}
    compile_fast(_twice, numbers)(numbers)
    compilation._compiled.cache_clear()

    def of_another_machine(known):
        raise RuntimeError("unknown instruction")

    monkeypatch.setattr(compilation.KeptProgram, "load", of_another_machine)
    assert compile_fast(_twice, numbers)(numbers)["e"] == 4.0


def _rewritten(file, change):
    """A program with another head or machine code, and the digest of what it now is."""
    head, _, machine_code = file.read_bytes()[32:].partition(b"\n")
    head, machine_code = change(json.loads(head), machine_code)
    content = json.dumps(head).encode() + b"\n" + machine_code
    file.write_bytes(hashlib.sha256(content).digest() + content)


@pytest.mark.parametrize(
    "kinds", [[[[10**9], "float64"]], [[[4], "float64"]], [[[3], "float32"]], [[[], "float64"]]]
)
def test_a_program_with_other_shapes_than_its_machine_code_is_made_again(cache, kinds):
    """Programs that take its results are made before its machine code is loaded."""
    numbers = {"e": np.arange(3.0)}
    compile_fast(_twice, numbers)(numbers)
    (file,) = _programs(cache)
    _rewritten(file, lambda head, machine_code: (head | {"kinds": kinds}, machine_code))
    compilation._compiled.cache_clear()
    program = compile_fast(_twice, numbers)
    following = compile_fast(_twice, program.results)
    np.testing.assert_array_equal(following(program(numbers))["e"], [0.0, 4.0, 8.0])
    compilation._compiled.cache_clear()
    assert kept_programs.kept(program._request, compilation._COMPILE_FAST).is_as_stated  # it was made good


def _thrice(numbers):
    return {name: 3.0 * value for name, value in numbers.items()}


def test_machine_code_of_another_program_with_the_same_shapes_is_not_used(cache):
    numbers = {"e": np.arange(3.0)}
    compile_fast(_twice, numbers)(numbers)
    (file,) = _programs(cache)
    compile_fast(_thrice, numbers)(numbers)
    (other,) = set(_programs(cache)) - {file}
    _, _, foreign = other.read_bytes()[32:].partition(b"\n")
    _rewritten(file, lambda head, machine_code: (head, foreign))
    compilation._compiled.cache_clear()
    np.testing.assert_array_equal(compile_fast(_twice, numbers)(numbers)["e"], [0.0, 2.0, 4.0])


def test_closures_of_one_name_never_share_a_program(cache):
    """A closure's name does not say what it computes; keeping its program gave one study the numbers of another."""

    def times(factor):
        return lambda numbers: {"f": factor * numbers["f"]}

    numbers = {"f": np.float64(5.0)}
    assert compile_fast(times(2.0), numbers)(numbers)["f"] == 10.0
    compilation._compiled.cache_clear()  # as in a new process
    assert compile_fast(times(3.0), numbers)(numbers)["f"] == 15.0
    assert not _programs(cache)


def test_a_closure_in_the_cache_of_jax_is_never_taken_for_a_program_that_is_kept(cache):
    """What JAX reads from its own cache cannot be stored: the next process would find a program without its code."""
    numbers = {"l": np.arange(3.0)}
    for _ in range(2):
        compile_fast(lambda given: _twice(given), numbers)(numbers)
    for _ in range(2):
        np.testing.assert_array_equal(compile_fast(_twice, numbers)(numbers)["l"], [0.0, 2.0, 4.0])
        compilation._compiled.cache_clear()  # as in a new process


def test_the_cache_of_jax_has_no_program_that_is_kept(cache):
    numbers = {"m": np.arange(3.0)}
    program = compile_fast(_twice, numbers)
    np.testing.assert_array_equal(program(numbers)["m"], [0.0, 2.0, 4.0])
    assert len(_programs(cache)) == 1
    # JAX stays with the folder that it has found first
    folders = (cache, Path(os.environ["ASPERITY_CACHE_DIR"]))
    assert not [file for folder in folders for file in folder.glob(f"jit_{program._request.name}*")]


def _scaled(names, factor, numbers):
    return {name: float(factor) * numbers[name] for name in names}


def test_options_say_what_to_compute_and_are_part_of_the_programs_name(cache):
    numbers = {"g": np.float64(5.0), "h": np.float64(7.0)}
    for options in ((("g",), "2"), (("h",), "2"), (("g", "h"), "3")):
        names, factor = options
        expected = {name: float(factor) * numbers[name] for name in names}
        for _ in range(2):
            assert compile_fast(_scaled, numbers, options=options)(numbers) == expected
            compilation._compiled.cache_clear()  # as in a new process
    assert len(_programs(cache)) == 3


def test_a_call_is_compiled_where_the_numbers_are_known():
    called = call_compiled(_twice, {"e": 1.5})
    assert isinstance(called["e"], np.ndarray)
    assert called["e"] == 3.0
    assert jax.grad(lambda x: call_compiled(_twice, {"e": x})["e"])(1.5) == 2.0


def test_a_program_compiled_again_computes_the_same_and_serves_the_calls_that_follow():
    numbers = {"i": np.linspace(0.0, 3.0, 7)}
    program = compile_fast(_twice, numbers)
    before = program(numbers)["i"]
    program.compile_again()
    assert program._again is not None
    np.testing.assert_array_equal(program(numbers)["i"], 2.0 * numbers["i"])  # doubling is exact
    np.testing.assert_array_equal(before, 2.0 * numbers["i"])
    again = program._again
    program.compile_again()
    assert program._again is again


def test_the_programs_called_in_a_block_are_known():
    one, other = compile_fast(_twice, {"j": np.zeros(2)}), compile_fast(_twice, {"j": np.zeros(3)})
    with called_programs() as called:
        one({"j": np.zeros(2)})
        one({"j": np.ones(2)})
    other({"j": np.zeros(3)})
    assert called == {one}


def test_what_is_read_from_the_cache_is_compiled_again_once_for_all_processes(cache, monkeypatch):
    numbers = {"k": np.arange(3.0)}
    compile_fast(_twice, numbers)(numbers)
    traced = []
    trace = compilation._traced
    monkeypatch.setattr(compilation, "_traced", lambda request: traced.append(request) or trace(request))
    for _ in range(2):
        compilation._compiled.cache_clear()  # as in a new process
        program = compile_fast(_twice, numbers)
        program.compile_again()
        np.testing.assert_array_equal(program(numbers)["k"], [0.0, 2.0, 4.0])
    assert len(traced) == 1
    assert len(_programs(cache)) == 2

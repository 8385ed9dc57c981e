"""Compilation of a function that runs once or a few times: fast to compile rather than fast to run.

Most of the run time of a command is spent by JAX tracing the Python code and by XLA compiling the result. XLA's
expensive optimisations are switched off. If a compilation cache is set
(:func:`asperity.precision.use_compilation_cache`), the machine code is kept under a name formed from the source code
and the versions that it depends on (:mod:`asperity.kept_programs`). The next process skips both steps.

XLA compiles in threads of its own while Python goes on: the next program is traced meanwhile, and a call of one that
is not ready waits for it.

A process that calls the same programs again and again can have them compiled a second time, with the optimisations
(:meth:`Program.compile_again`): they then run two to four times as fast.
"""

from __future__ import annotations

import contextlib
import ctypes
import functools
import gc
import os
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextvars import ContextVar
from pathlib import Path
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from asperity.engine.elimination import optimised
from asperity.kept_programs import Choices, KeptProgram, Request, keep, kept, without_the_cache_of_jax

_IN_ONE_PART = {
    "xla_backend_optimization_level": 0,
    "xla_cpu_parallel_codegen_split_count": 1,  # in parts, the whole costs a quarter more
    "xla_disable_hlo_passes": "while-loop-invariant-code-motion",  # costs a third more, for nested loops
}
#: XLA's CPU compiler spends four fifths of its time on fusions and optimisations that pay off in millions of points.
#: The first of these that the installed release of XLA knows.
_COMPILE_FAST: Choices = (
    {**_IN_ONE_PART, "xla_cpu_use_fusion_emitters": False},
    _IN_ONE_PART,
    {"xla_backend_optimization_level": 0},
    {},
)

#: The same with the optimisations of the machine code: two to four times as long to compile, and as much faster.
_RUN_FAST: Choices = (
    *({**options, "xla_backend_optimization_level": 1} for options in _COMPILE_FAST[:-1]),
    {},
)

#: For many points: without threads of XLA's own, which take more time than they save, and without the sums and products
#: of YNNPACK, which take longer than XLA's own where arrays are small.
_FOR_MANY: Choices = (
    {"xla_cpu_multi_thread_eigen": False, "xla_cpu_experimental_ynn_fusion_type": ""},
    {"xla_cpu_multi_thread_eigen": False},
    {},
)


class Program:
    """A function of modules of numbers that is compiled, or about to be: the request, and what XLA makes or made of it.

    ``compiled`` is a function of the list of the leaves; ``results`` what it returns, each leaf with its ``shape`` and
    ``dtype``; ``traced`` what XLA is given, None if this process has not traced it.
    """

    def __init__(
        self, request: Request, compiled: Future[Callable[..., Any]], results: Any, traced: Any = None
    ) -> None:
        self.results = results
        self._request, self._compiled, self._traced = request, compiled, traced
        self._again: Callable[..., Any] | None = None

    def compile_again(self) -> None:
        """Compile it once more, to run faster, and let later calls use that; nothing where this was done before.

        Notes
        -----
        XLA rounds differently in what it optimises: results change in their last digits.
        """
        if self._again is None:
            traced, self._traced = self._traced, None
            self._again = _ready(self._request, _RUN_FAST, kept(self._request, _RUN_FAST), traced)

    def __call__(self, *arguments: Any) -> Any:
        """The results for arguments of the structure and shapes that it was compiled for."""
        return self._call(jax.tree.leaves(arguments))

    def with_first(self, *first: Any) -> Callable[..., Any]:
        """A function of the last arguments alone, for many calls with the same first ones."""
        given = [jnp.asarray(leaf) for leaf in jax.tree.leaves(first)]
        return lambda *last: self._call([*given, *jax.tree.leaves(last)])

    def _call(self, leaves: list[Any]) -> Any:
        called = _CALLED.get()
        if called is not None:
            called.add(self)
        call = self._again or self._compiled.result()
        return jax.tree.unflatten(jax.tree.structure(self.results), call(leaves))


#: The programs that are called in a block of :func:`called_programs`.
_CALLED: ContextVar[set[Program] | None] = ContextVar("called programs", default=None)


@contextlib.contextmanager
def called_programs() -> Iterator[set[Program]]:
    """The programs that this thread calls within a block, filled as they are called."""
    called: set[Program] = set()
    before = _CALLED.set(called)
    try:
        yield called
    finally:
        _CALLED.reset(before)


def compile_fast(function: Callable[..., Any], *arguments: Any, options: tuple[Any, ...] = ()) -> Program:
    """Compile a function quickly, for one use or a few; XLA's part goes on after this returns.

    The pure function of modules of numbers is kept between runs only if it is a function of a module of this package,
    known by its name; a closure is compiled anew in every process. ``arguments`` have leaves of the shapes that the
    function will be called with, or know these shapes as the ``results`` of another program do. ``options`` are its
    leading arguments that select what to compute and are not numbers: texts and tuples of texts, which their ``repr``
    identifies completely. The program is the function without them; the same object on a repeated call.
    """
    leaves, structure = jax.tree.flatten(arguments)
    return _compiled(function, options, structure, tuple(map(_kind, leaves)))


def compile_for_many(function: Callable[..., Any], *arguments: Any) -> Any:
    """Compile a function of many points at once, with all optimisations; threads may call it side by side."""
    if jax.default_backend() != "cpu":  # it has kernels of its own, and threads for one program
        return jax.jit(function).lower(*arguments).compile()
    with optimised():
        lowered = jax.jit(function).lower(*arguments)
    # no signal reaches a thread while XLA compiles in it: an interruption would wait for the end
    return _compilers().submit(_compiled_with, lowered, _FOR_MANY).result()


def _kind(leaf: Any) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Shape and type of a number; of a NumPy array at once, because JAX takes its time for that."""
    if isinstance(leaf, jax.ShapeDtypeStruct) or (isinstance(leaf, np.ndarray) and leaf.dtype == np.float64):
        return leaf.shape, leaf.dtype
    return jnp.shape(leaf), jnp.result_type(leaf)


def call_compiled(function: Callable[..., Any], *arguments: Any) -> Any:
    """Call a pure function of modules of numbers: compiled where they are known, inside a program as a part of it.

    Leaves of the result are NumPy arrays where it was compiled.
    """
    if any(isinstance(leaf, jax.core.Tracer) for leaf in jax.tree.leaves(arguments)):
        return function(*arguments)
    numbers = jax.tree.map(np.asarray, arguments)
    return jax.tree.map(np.asarray, compile_fast(function, *numbers)(*numbers))


@functools.cache
def _compilers() -> ThreadPoolExecutor:
    """Threads in which XLA compiles."""
    return ThreadPoolExecutor(2, thread_name_prefix="compile")


#: Resident memory above which all programs are forgotten, if there are so many [byte]; one has 25 MB of machine code.
_MOST_MEMORY, _FEWEST = 2 * 1024**3, 16


@functools.lru_cache(maxsize=64)
def _compiled(function: Callable[..., Any], options: tuple[Any, ...], structure: Any, kinds: Any) -> Program:
    if _compiled.cache_info().currsize >= _FEWEST and _resident() > _MOST_MEMORY:
        _compiled.cache_clear()
        gc.collect()
        with contextlib.suppress(OSError, AttributeError):  # only glibc keeps what is freed, and is told so
            ctypes.CDLL(None).malloc_trim(0)
    request = Request(function, options, structure, kinds)
    known = kept(request, _COMPILE_FAST)
    if known is not None and not known.is_as_stated:
        known = None
    traced = _traced(request) if known is None else None
    compiled = _compilers().submit(_ready, request, _COMPILE_FAST, known, traced)
    outcome = known or traced
    assert outcome is not None
    return Program(request, compiled, outcome.results, traced)


def _resident() -> int:
    """Resident memory of this process [byte]; 0 where the system does not tell (others than Linux)."""
    with contextlib.suppress(OSError):
        return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    return 0


class _Traced(NamedTuple):
    """What XLA is given, and what comes of it, each leaf with its shape and type."""

    lowered: Any
    results: Any


def _traced(request: Request) -> _Traced:
    """The program of the list of the leaves."""
    structures = []

    def flat(leaves: list[Any]) -> list[Any]:
        result = request.function(*request.options, *jax.tree.unflatten(request.structure, leaves))
        result_leaves, structure = jax.tree.flatten(result)
        structures.append(structure)
        return result_leaves

    flat.__name__ = request.name
    with _without_garbage_collection():
        lowered = jax.jit(flat).lower([jax.ShapeDtypeStruct(shape, dtype) for shape, dtype in request.kinds])
    shapes = [jax.ShapeDtypeStruct(out.shape, out.dtype) for out in lowered.out_info]
    return _Traced(lowered, jax.tree.unflatten(structures[0], shapes))


@contextlib.contextmanager
def _without_garbage_collection() -> Iterator[None]:
    """Tracing makes many objects and hardly any garbage; looking through them takes a fifth of its time."""
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def _ready(
    request: Request, choices: Choices, known: KeptProgram | None, traced: _Traced | None
) -> Callable[..., Any]:
    """What XLA makes of a program, read if it is known from an earlier process; traced now if it was not before."""
    if known is not None:
        with contextlib.suppress(Exception):  # it cannot be loaded: a result must never depend on the cache
            return known.load()
    traced = traced or _traced(request)
    if not request.known_by_name:
        return _compiled_with(traced.lowered, choices)
    with without_the_cache_of_jax():
        compiled = _compiled_with(traced.lowered, choices)
    keep(request, choices, compiled, traced.results)
    return compiled


def _compiled_with(lowered: Any, choices: Choices) -> Any:
    """With the first of some options that this release of XLA knows."""
    *preferred, last = choices
    for options in preferred:
        try:
            return lowered.compile(compiler_options=options)
        except jax.errors.JaxRuntimeError:  # a release of XLA without one of these options
            continue
    return lowered.compile(compiler_options=last)

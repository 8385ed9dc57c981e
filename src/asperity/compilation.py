"""Compilation of a function that runs once or a few times: fast to compile rather than fast to run.

Most of the run time of a command is spent by JAX tracing the Python code and by XLA compiling the result. XLA's
expensive optimisations are switched off. If a compilation cache is set
(:func:`asperity.precision.use_compilation_cache`), the traced program is stored in addition to XLA's machine code. Its
name is formed from the source code and the versions that it depends on. The next process skips both steps.

XLA compiles in threads of its own while Python goes on: the next program is traced meanwhile, and a call of one that
is not ready waits for it.

A process that calls the same programs again and again can have them compiled a second time, with the optimisations
(:meth:`Program.compile_again`): they then run two to four times as fast.
"""

from __future__ import annotations

import contextlib
import functools
import gc
import hashlib
import importlib.util
import os
import pickle
import platform
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextvars import ContextVar
from importlib.metadata import version
from pathlib import Path
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

_IN_ONE_PART = {
    "xla_backend_optimization_level": 0,
    "xla_cpu_parallel_codegen_split_count": 1,  # in parts, the whole costs a quarter more
    "xla_disable_hlo_passes": "while-loop-invariant-code-motion",  # costs a third more, for nested loops
}
#: XLA's CPU compiler spends four fifths of its time on fusions and optimisations that pay off in millions of points.
#: The first of these that the installed release of XLA knows.
_COMPILE_FAST: tuple[dict[str, Any], ...] = (
    {**_IN_ONE_PART, "xla_cpu_use_fusion_emitters": False},
    _IN_ONE_PART,
    {"xla_backend_optimization_level": 0},
    {},
)

#: The same with the optimisations of the machine code: two to four times as long to compile, and as much faster.
_RUN_FAST = (*({**options, "xla_backend_optimization_level": 1} for options in _COMPILE_FAST[:-1]), {})

_Kinds = tuple[tuple[tuple[int, ...], np.dtype[Any]], ...]


class Program:
    """A function of modules of numbers that is compiled, or about to be.

    Parameters
    ----------
    compiled : Future
        What XLA makes of it.
    lowered : object
        What XLA is given.
    results : object
        What it returns, each leaf with its ``shape`` and ``dtype``.
    flat : bool
        Whether the compiled function takes the list of the leaves, and returns those of ``results``.
    """

    def __init__(
        self, compiled: Future[Callable[..., Any]], lowered: Any, results: Any, *, flat: bool
    ) -> None:
        self.results = results
        self._compiled, self._lowered, self._flat = compiled, lowered, flat
        self._again: Callable[..., Any] | None = None

    def compile_again(self) -> None:
        """Compile it once more, to run faster, and let later calls use that; nothing where this was done before.

        Notes
        -----
        XLA rounds differently in what it optimises: results change in their last digits.
        """
        lowered, self._lowered = self._lowered, None
        if lowered is not None:
            self._again = _built(lowered, _RUN_FAST)

    def __call__(self, *arguments: Any) -> Any:
        """The results for arguments of the structure and shapes that it was compiled for."""
        called = _CALLED.get()
        if called is not None:
            called.add(self)
        call = self._again or self._compiled.result()
        if not self._flat:
            return call(*arguments)
        return jax.tree.unflatten(jax.tree.structure(self.results), call(jax.tree.leaves(arguments)))


#: The programs that are called in a block of :func:`called_programs`.
_CALLED: ContextVar[set[Program] | None] = ContextVar("called programs", default=None)


@contextlib.contextmanager
def called_programs() -> Iterator[set[Program]]:
    """The programs that this thread calls within a block.

    Yields
    ------
    set of Program
        Filled as they are called.

    Examples
    --------
    >>> with called_programs() as called:
    ...     four = call_compiled(jnp.square, 2.0)
    >>> len(called)
    1
    """
    called: set[Program] = set()
    before = _CALLED.set(called)
    try:
        yield called
    finally:
        _CALLED.reset(before)


def compile_fast(function: Callable[..., Any], *arguments: Any, options: tuple[Any, ...] = ()) -> Program:
    """Compile a function quickly, for one use or a few; XLA's part goes on after this returns.

    Parameters
    ----------
    function : callable
        A pure function of modules of numbers. Its program is kept between runs only if it is a function of a module
        of this package, known by its name; a closure is compiled anew in every process.
    *arguments
        Modules whose leaves are arrays of the shapes that the function will be called with, or know these shapes as the
        ``results`` of another program do.
    options : tuple, optional
        Leading arguments that select what to compute and are not numbers: texts and tuples of texts, which their
        ``repr`` identifies completely.

    Returns
    -------
    Program
        The function without the options, for arguments of the same structure and shapes; the same object on a
        repeated call.
    """
    leaves, structure = jax.tree.flatten(arguments)
    return _compiled(function, options, structure, tuple(map(_kind, leaves)))


def _kind(leaf: Any) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Shape and type of a number; of a NumPy array at once, because JAX takes its time for that."""
    if isinstance(leaf, jax.ShapeDtypeStruct) or (isinstance(leaf, np.ndarray) and leaf.dtype == np.float64):
        return leaf.shape, leaf.dtype
    return jnp.shape(leaf), jnp.result_type(leaf)


def call_compiled(function: Callable[..., Any], *arguments: Any) -> Any:
    """Call a function of modules of numbers: compiled where the numbers are known, inside a program as a part of it.

    Parameters
    ----------
    function : callable
        A pure function, as for :func:`compile_fast`.
    *arguments
        Modules of numbers.

    Returns
    -------
    object
        What the function returns, with leaves as NumPy arrays where it was compiled.
    """
    if any(isinstance(leaf, jax.core.Tracer) for leaf in jax.tree.leaves(arguments)):
        return function(*arguments)
    numbers = jax.tree.map(np.asarray, arguments)
    return jax.tree.map(np.asarray, compile_fast(function, *numbers)(*numbers))


@functools.cache
def _compilers() -> ThreadPoolExecutor:
    """Threads in which XLA compiles."""
    return ThreadPoolExecutor(2, thread_name_prefix="compile")


@functools.lru_cache(maxsize=64)
def _compiled(
    function: Callable[..., Any], options: tuple[Any, ...], structure: Any, kinds: _Kinds
) -> Program:
    shapes = [jax.ShapeDtypeStruct(shape, dtype) for shape, dtype in kinds]
    with _without_garbage_collection():
        kept = _kept_program(function, options, structure, kinds)
        if kept is None:
            arguments = jax.tree.unflatten(structure, shapes)
            lowered = jax.jit(functools.partial(function, *options)).lower(*arguments)
            results = jax.tree.map(lambda out: jax.ShapeDtypeStruct(out.shape, out.dtype), lowered.out_info)
        else:
            program, results = kept
            lowered = jax.jit(program).lower(shapes)
    compiled = _compilers().submit(_built, lowered, _COMPILE_FAST)
    return Program(compiled, lowered, results, flat=kept is not None)


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


def _built(lowered: Any, choices: tuple[dict[str, Any], ...]) -> Callable[..., Any]:
    """Compiled with the first of some options that this release of XLA knows."""
    *preferred, last = choices
    for options in preferred:
        try:
            return lowered.compile(compiler_options=options)
        except jax.errors.JaxRuntimeError:  # a release of XLA without one of these options
            continue
    return lowered.compile(compiler_options=last)


def _kept_program(
    function: Callable[..., Any], options: tuple[Any, ...], structure: Any, kinds: _Kinds
) -> tuple[Callable[..., Any], Any] | None:
    """The program of a function of flat leaves and its results, read from the cache or stored there, or None."""
    folder = jax.config.jax_compilation_cache_dir  # type: ignore[attr-defined]
    if not folder or importlib.util.find_spec("flatbuffers") is None:  # the file format of jax.export
        return None
    if not _known_by_name(function):
        return None
    from jax import export

    file = Path(folder) / f"asperity-{_fingerprint(function, options, structure, kinds)}.program"
    try:
        # a pickle, as trustworthy as the machine code that XLA keeps in the same folder of the user
        stored, skeleton = pickle.loads(file.read_bytes())
        return _with_results(export.deserialize(bytearray(stored)), jax.tree.structure(skeleton))
    except Exception:  # absent or damaged: a result must never depend on the cache
        pass
    result_structures = []

    def flat(leaves: list[Any]) -> list[Any]:
        result = function(*options, *jax.tree.unflatten(structure, leaves))
        result_leaves, result_structure = jax.tree.flatten(result)
        result_structures.append(result_structure)
        return result_leaves

    exported = export.export(jax.jit(flat))([jax.ShapeDtypeStruct(shape, dtype) for shape, dtype in kinds])
    (result_structure,) = result_structures
    skeleton = jax.tree.unflatten(result_structure, [0] * len(exported.out_avals))
    _keep(file, pickle.dumps((bytes(exported.serialize()), skeleton)))
    return _with_results(exported, result_structure)


def _with_results(exported: Any, structure: Any) -> tuple[Callable[..., Any], Any]:
    shapes = [jax.ShapeDtypeStruct(out.shape, out.dtype) for out in exported.out_avals]
    return exported.call, jax.tree.unflatten(structure, shapes)


def _known_by_name(function: Callable[..., Any]) -> bool:
    """Whether the function's name identifies it: a closure of the same name may compute something else."""
    module = sys.modules.get(function.__module__)
    return getattr(module, getattr(function, "__qualname__", ""), None) is function


def _keep(file: Path, content: bytes) -> None:
    part = file.with_name(f"{file.name}.{os.getpid()}.part")
    try:
        part.write_bytes(content)
        part.replace(file)
    except OSError:  # a full or read-only disk only costs time at the next start
        part.unlink(missing_ok=True)


def _fingerprint(
    function: Callable[..., Any], options: tuple[Any, ...], structure: Any, kinds: _Kinds
) -> str:
    """Everything a program depends on: this package's source, the versions of its dependencies, and the request."""
    name = (function.__module__, function.__qualname__)
    asked = (*name, options, str(structure), kinds, jax.default_backend())
    below = (platform.python_version(), *(version(name) for name in ("jax", "jaxlib", "equinox", "numpy")))
    digest = hashlib.sha256(repr((asked, below)).encode())
    digest.update(_source_digest())
    return digest.hexdigest()[:32]


@functools.cache
def _source_digest() -> bytes:
    """One for all files of this package."""
    digest = hashlib.sha256()
    package = Path(__file__).parent
    for source in sorted(package.rglob("*.py")):
        digest.update(str(source.relative_to(package)).encode())
        digest.update(source.read_bytes())
    return digest.digest()

"""Programs of JAX that are compiled for what is computed many times: the points of a study.

XLA compiles in a thread of its own, so that the main thread can be interrupted meanwhile. Programs go through JAX's
compilation cache (:func:`asperity.precision.use_compilation_cache`), which finds them again in another process.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import jax

from asperity.engine.elimination import optimised
from asperity.types import Tree

#: For a few thousand points: without the optimisations that take longer than what they save.
_FOR_FEW: dict[str, Tree] = {"xla_backend_optimization_level": 0}
#: For what is called again and again.
_FOR_OFTEN: dict[str, Tree] = {"xla_backend_optimization_level": 1}
#: For many points: without threads of XLA's own, which take more time than they save, and without the sums and products
#: of YNNPACK, which take longer than XLA's own where arrays are small.
_FOR_MANY: dict[str, Tree] = {"xla_cpu_multi_thread_eigen": False, "xla_cpu_experimental_ynn_fusion_type": ""}

Kinds = tuple[tuple[tuple[int, ...], Tree], ...]


def program_for_few(
    function: Callable[..., Tree], *modules: Tree, options: tuple[Tree, ...] = (), often: bool = False
) -> Callable[..., Tree]:
    """A function of modules of arrays, compiled for arrays of these shapes; the same program on a repeated call.

    ``options`` are its leading arguments that select what to compute, no numbers of the program but values that can be
    hashed; the program is the function without them. ``often``: it is called thousands of times.
    """
    arrays, structure = jax.tree.flatten(modules)
    return _for_few(function, options, structure, tuple((each.shape, each.dtype) for each in arrays), often)


@functools.lru_cache(maxsize=16)
def _for_few(
    function: Callable[..., Tree], options: tuple[Tree, ...], structure: Tree, kinds: Kinds, often: bool
) -> Callable[..., Tree]:
    shapes = jax.tree.unflatten(structure, [jax.ShapeDtypeStruct(*kind) for kind in kinds])
    lowered = jax.jit(functools.partial(function, *options)).lower(*shapes)
    return _compiled(lowered, _FOR_OFTEN if often else _FOR_FEW)


def program_for_many(function: Callable[..., Tree], *arguments: Tree) -> Callable[..., Tree]:
    """A function of many points at once, compiled with all optimisations; threads may call it side by side."""
    if jax.default_backend() != "cpu":  # it has kernels of its own, and threads for one program
        return _compiled(jax.jit(function).lower(*arguments), {})
    with optimised():
        lowered = jax.jit(function).lower(*arguments)
    return _compiled(lowered, _FOR_MANY)


def _compiled(lowered: Tree, options: dict[str, Tree]) -> Callable[..., Tree]:
    """What XLA makes of a program; without options that this release of XLA does not know."""

    def compiled() -> Tree:
        try:
            return lowered.compile(compiler_options=options)
        except jax.errors.JaxRuntimeError:
            return lowered.compile()

    program: Callable[..., Tree] = _compilers().submit(compiled).result()
    return program


@functools.cache
def _compilers() -> ThreadPoolExecutor:
    """Threads in which XLA compiles: no signal reaches a thread meanwhile."""
    return ThreadPoolExecutor(2, thread_name_prefix="compile")

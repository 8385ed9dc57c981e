"""Compiling a function that runs once or a few times: quick to build, not quick to run."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

#: XLA's CPU compiler spends four fifths of its time on fusions and optimisations that pay off in millions of points.
_COMPILE_FAST: dict[str, Any] = {"xla_backend_optimization_level": 0, "xla_cpu_use_fusion_emitters": False}


def compile_fast(function: Callable[..., Any], *arguments: Any) -> Callable[..., Any]:
    """Compile a function quickly, for one use or a few.

    Parameters
    ----------
    function : callable
        A pure function of modules of numbers, known by its name (no lambda: the result is kept for the next call).
    *arguments
        Modules whose leaves are arrays, of the shapes that the function will be called with.

    Returns
    -------
    callable
        The compiled function, for arguments of the same structure and shapes; the same one if asked again.
    """
    leaves, structure = jax.tree.flatten(arguments)
    return _compiled(function, structure, tuple((jnp.shape(leaf), jnp.result_type(leaf)) for leaf in leaves))


@functools.lru_cache(maxsize=16)
def _compiled(
    function: Callable[..., Any], structure: Any, kinds: tuple[tuple[tuple[int, ...], np.dtype[Any]], ...]
) -> Callable[..., Any]:
    arguments = jax.tree.unflatten(structure, [jax.ShapeDtypeStruct(shape, dtype) for shape, dtype in kinds])
    lowered = jax.jit(function).lower(*arguments)
    try:
        return lowered.compile(compiler_options=_COMPILE_FAST)
    except (
        jax.errors.JaxRuntimeError
    ):  # a release of XLA without these options: the same program, built slowly
        return lowered.compile()

"""Double precision and the compilation cache: the only module that touches JAX's global configuration.

Critical spot areas span more than a hundred decades, so single precision is not an option. The command line
and the examples call :func:`use_double_precision`; a library user calls it once. Solvers call
:func:`require_double_precision` and raise an error otherwise, instead of switching it on without notice.
"""

import functools
import logging
import os
import threading
from pathlib import Path
from typing import Any

from asperity.engine.jax_import import when_jax_is_imported
from asperity.errors import PrecisionError, printable


def use_double_precision() -> None:
    """Switch JAX to 64-bit floats for this process, as soon as it is imported; call it before the first computation."""
    when_jax_is_imported(_switch)


def _switch() -> None:
    import jax

    jax.config.update("jax_enable_x64", True)


def require_double_precision() -> None:
    """Raise unless JAX computes in 64-bit floats.

    Raises
    ------
    PrecisionError
        If ``jax_enable_x64`` is off.
    """
    import jax

    if not jax.config.read("jax_enable_x64"):
        raise PrecisionError(
            "JAX is set to single precision (32-bit floats), in which the contact law cannot be solved; call "
            "asperity.precision.use_double_precision() first, or set the environment variable JAX_ENABLE_X64=1"
        )


def use_compilation_cache() -> None:
    """Keep compiled programs in the user's cache directory, so that later runs start in a fraction of the time.

    Set ``ASPERITY_CACHE_DIR`` to choose another folder, or to an empty string to switch the cache off.
    If the folder cannot be written, the cache stays off; results never depend on it. It also stays off, and a note says
    so, if others can write to the folder: a compiled program is code that runs.
    """
    when_jax_is_imported(_use_compilation_cache)


def cache_folder() -> Path | None:
    """The folder in which this package keeps what it computes; None where nothing is kept."""
    import platformdirs

    from asperity.own_folder import NotOwnError, foreign_files, own_folder

    folder = os.environ.get("ASPERITY_CACHE_DIR")
    if folder == "":
        return None
    try:
        path = Path(
            folder or Path(platformdirs.user_cache_dir("asperity", appauthor=False)) / "jax"
        ).expanduser()
        cache = own_folder(path)
        foreign = foreign_files(cache, "-cache")
        if foreign:
            raise NotOwnError(f"{cache / foreign[0]} may be by another user; empty the folder")
    except NotOwnError as error:
        note_once(f"compiled programs are not kept: {error}")
        return None
    except (OSError, RuntimeError, ValueError):  # no place, no home, or no valid name
        return None
    return cache


def _use_compilation_cache() -> None:
    import jax

    cache = cache_folder()
    if cache is None:
        return
    # programs that are kept need not say where in the source each of their operations stands: a quarter of their size
    jax.config.update("jax_traceback_in_locations_limit", 0)
    jax.config.update("jax_compilation_cache_dir", str(cache))
    jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.0)
    jax.config.update("jax_persistent_cache_min_entry_size_bytes", -1)
    _write_whole_files()


@functools.cache
def _write_whole_files() -> None:
    """Let JAX write a program completely or not at all.

    It writes in place: another process reads half of a program, and what a full disk leaves is complained of for ever.
    """
    try:
        from jax._src.lru_cache import _CACHE_SUFFIX, LRUCache
    except ImportError:  # another release, which may do without
        return

    in_place = LRUCache.put

    def put(cache: Any, key: str, value: bytes) -> None:
        if cache.eviction_enabled:  # behind a lock
            in_place(cache, key, value)
            return
        whole = cache.path / f"{key}{_CACHE_SUFFIX}"
        part = cache.path / f"{key}.{os.getpid()}.{threading.get_ident()}"
        if not whole.exists():
            try:
                part.write_bytes(value)
                part.replace(whole)
            finally:
                part.unlink(missing_ok=True)

    LRUCache.put = put  # type: ignore[assignment, method-assign]


@functools.cache
def note_once(text: str) -> None:
    """Say something once; a program that uses this package may direct it elsewhere."""
    logging.getLogger(__name__).warning("asperity: note: %s", printable(text))

"""Machine code of programs, kept between processes in the folder of JAX's compilation cache.

JAX's own cache keeps what XLA makes of a program, but has to trace the program to find it. Here the name of a file says
what a program depends on: the function, what it is asked for, the source of this package, and the releases below it.

A program that JAX has read from its own cache cannot be stored again: its code is missing, which shows when it is
called. Programs of this module therefore stay out of that cache: they have names of their own, and JAX stores nothing
while they are compiled.

A program is code that runs. Nothing of a file is looked at, therefore, unless this user alone can have written it
(:mod:`asperity.own_folder`); the digest tells damage, not intent. JAX reads the machine code as a pickle, which is
refused before if it names anything but classes of JAX.
"""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import hashlib
import json
import os
import platform
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import equinox
import jax
import jaxlib
import numpy as np

from asperity.machine_code import check_names, said
from asperity.own_folder import read_own, write_own

_PACKAGE = __name__.partition(".")[0]
_PREFIX = "asperity-"
_DIGEST_SIZE = 32
#: Time after which a program that is no longer used is removed [s].
_KEPT_FOR = 90 * 24 * 3600.0
#: Time after which nobody writes a half-written file on any more [s]: its process has been ended.
_WRITTEN_WITHIN = 3600.0
_PART = ".part"
#: Options of XLA, the preferred ones first.
Choices = tuple[dict[str, Any], ...]
_PLAIN = (str, int, float, bool, type(None))


@dataclasses.dataclass(frozen=True)
class Request:
    """What is compiled: a pure function of modules of numbers, and its leading ``options`` that are not numbers.

    Their ``repr`` identifies the options completely. ``structure`` is that of the other arguments, ``kinds`` the shape
    and type of each of their leaves.
    """

    function: Callable[..., Any]
    options: tuple[Any, ...]
    structure: Any
    kinds: tuple[tuple[tuple[int, ...], np.dtype[Any]], ...]

    @property
    def known_by_name(self) -> bool:
        """Whether its name and the source of this package say what the function computes.

        A closure of the same name may compute something else, and so may a function of the user after a change.
        """
        if self.function.__module__.partition(".")[0] != _PACKAGE:
            return False
        module = sys.modules.get(self.function.__module__)
        return getattr(module, getattr(self.function, "__qualname__", ""), None) is self.function

    @functools.cached_property
    def fingerprint(self) -> str:
        """40 hexadecimal digits for everything that the program depends on."""
        asked = (
            self.function.__module__,
            self.function.__qualname__,
            self.options,
            str(self.structure),
            self.kinds,
        )
        settings = [jax.config.read(name) for name in ("jax_enable_x64", "jax_disable_most_optimizations")]
        digest = hashlib.sha256(repr((asked, settings)).encode())
        digest.update(_surroundings())
        return digest.hexdigest()[:40]

    @property
    def name(self) -> str:
        """A name of its own, if the function is known by its name; short, as XLA makes it part of every symbol."""
        return f"p{self.fingerprint[:8]}" if self.known_by_name else "closure"


@dataclasses.dataclass(frozen=True)
class KeptProgram:
    """A program that an earlier process has compiled, in the file format of JAX.

    ``name`` is that of its request; ``results``, what it returns, each leaf with its ``shape`` and ``dtype``;
    ``argument_count``, the number of leaves of its arguments; ``needs_lapack``, whether it may call functions of linear
    algebra.
    """

    name: str
    results: Any
    machine_code: bytes
    argument_count: int
    needs_lapack: bool

    @functools.cached_property
    def is_as_stated(self) -> bool:
        """Whether the machine code is that of the program of this name, with results of these shapes and types.

        Other programs are traced for these results before the machine code is loaded, which takes a hundred times as
        long as to look at what it says.
        """
        code = said(self.machine_code)
        return (
            code is not None
            and self.name in code.name
            and code.kinds == _kinds(jax.tree.leaves(self.results))
        )

    def load(self) -> Callable[..., Any]:
        """The program as a function of the list of the leaves, which returns the list of the leaves of the results."""
        from jax.experimental import serialize_executable

        check_names(self.machine_code)
        if self.needs_lapack:
            _load_lapack()
        arguments = jax.tree.structure((([0] * self.argument_count,), {}))
        results = jax.tree.structure([0] * len(jax.tree.leaves(self.results)))
        program = serialize_executable.deserialize_and_load(self.machine_code, arguments, results)
        if _kinds(jax.tree.leaves(program.out_info)) != _kinds(jax.tree.leaves(self.results)):
            raise ValueError("the machine code is that of another program")
        return program


@functools.cache
def _load_lapack() -> None:
    """Let JAX take LAPACK from SciPy, as it does when it lowers a program that needs it; without, a call crashes."""
    jax.jit(jax.lax.linalg.lu).lower(jax.ShapeDtypeStruct((1, 1), float))


def kept(request: Request, choices: Choices) -> KeptProgram | None:
    """The machine code of a program, if an earlier process has kept it."""
    file = _file(request, choices)
    if file is None:
        return None
    content = _read(file)
    if content is None:
        return None
    head, _, machine_code = content.partition(b"\n")
    try:
        known = json.loads(head)
        if known["file"] != file.name:
            return None
        results = [
            jax.ShapeDtypeStruct(tuple(map(int, shape)), np.dtype(kind)) for shape, kind in known["kinds"]
        ]
        tree = jax.tree.unflatten(jax.tree.structure(of_outline(known["results"])), results)
        return KeptProgram(request.name, tree, machine_code, len(request.kinds), bool(known["needs_lapack"]))
    except (ValueError, TypeError, LookupError, AttributeError, RecursionError):  # not written by this module
        return None


def keep(request: Request, choices: Choices, compiled: Any, results: Any) -> None:
    """Keep the machine code of a program for the next process."""
    file = _file(request, choices)
    if file is None:
        return
    from jax.experimental import serialize_executable

    try:
        machine_code, _, _ = serialize_executable.serialize(compiled)
    except (ValueError, NotImplementedError, jax.errors.JaxRuntimeError):
        return
    leaves, structure = jax.tree.flatten(results)
    try:
        stated = outline(results)
        again: Any = jax.tree.structure(of_outline(stated))
        if again != structure:
            return
    except ValueError:
        return
    if said(machine_code) is None:  # it would never be used
        return
    known = {
        "file": file.name,
        "results": stated,
        "kinds": _kinds(leaves),
        "needs_lapack": "scipy.linalg" in sys.modules,  # which JAX imports when it lowers a program that does
    }
    _write(file, json.dumps(known).encode() + b"\n" + machine_code)


def _write(file: Path, content: bytes) -> None:
    """Write a file of the folder with its digest, at once; remove those that nobody has used for long."""
    part = file.with_name(f"{file.name}.{os.getpid()}.{threading.get_ident()}{_PART}")
    try:
        write_own(part, hashlib.sha256(content).digest() + content)
        part.replace(file)
        _remove_unused(file.parent)
    except OSError:  # a full or read-only disk only costs time at the next start
        part.unlink(missing_ok=True)


def _read(file: Path) -> bytes | None:
    """Content of a file of the folder; None without one, and if it is damaged."""
    try:
        stored = read_own(file)
    except OSError:
        return None
    digest, content = stored[:_DIGEST_SIZE], stored[_DIGEST_SIZE:]
    if hashlib.sha256(content).digest() != digest:  # a result must never depend on the cache
        return None
    return content


def kept_numbers(asked: bytes) -> Any:
    """The JSON document of numbers that an earlier process has kept; None if there is none.

    Parameters
    ----------
    asked : bytes
        All that the numbers depend on besides this package, the releases below it and the machine.
    """
    file = _numbers_file(asked)
    content = None if file is None else _read(file)
    try:
        return None if content is None else json.loads(content)
    except (ValueError, RecursionError):  # not written by this module
        return None


def keep_numbers(asked: bytes, document: Any) -> None:
    """Keep a JSON document of numbers for :func:`kept_numbers`."""
    file = _numbers_file(asked)
    if file is not None:
        _write(file, json.dumps(document).encode())


def _numbers_file(asked: bytes) -> Path | None:
    folder = jax.config.jax_compilation_cache_dir  # type: ignore[attr-defined]
    digest = hashlib.sha256(_surroundings() + asked).hexdigest()[:40]
    return Path(folder) / f"{_PREFIX}{digest}.numbers" if folder else None


def _kinds(leaves: list[Any]) -> list[tuple[list[int], str]]:
    """Shape and type of each, as JSON states them."""
    return [(list(leaf.shape), str(leaf.dtype)) for leaf in leaves]


def _file(request: Request, choices: Choices) -> Path | None:
    folder = jax.config.jax_compilation_cache_dir  # type: ignore[attr-defined]
    if not folder or not request.known_by_name:
        return None
    options = hashlib.sha256(repr(choices).encode()).hexdigest()[:8]
    return Path(folder) / f"{_PREFIX}{request.fingerprint}-{options}.program"


def _remove_unused(folder: Path) -> None:
    """Programs of earlier releases, of joints that nobody asks for any more, and what an ended process left behind."""
    for file in folder.glob(f"{_PREFIX}*"):
        longest = _WRITTEN_WITHIN if file.suffix == _PART else _KEPT_FOR
        if time.time() - file.stat().st_mtime > longest:
            file.unlink(missing_ok=True)


_LOCK = threading.Lock()
#: JAX's setting before the first block that is open: one entry for each of them.
_SETTING_BEFORE: list[float] = []


@contextlib.contextmanager
def without_the_cache_of_jax() -> Iterator[None]:
    """Let JAX keep nothing of what is compiled in a block, in whatever thread."""
    name = "jax_persistent_cache_min_compile_time_secs"
    with _LOCK:
        _SETTING_BEFORE.append(_SETTING_BEFORE[0] if _SETTING_BEFORE else getattr(jax.config, name))
        jax.config.update(name, float("inf"))
    try:
        yield
    finally:
        with _LOCK:
            before = _SETTING_BEFORE.pop()
            if not _SETTING_BEFORE:
                jax.config.update(name, before)


@functools.cache
def _surroundings() -> bytes:
    """A digest of this package's source, of the releases below it, and of the machine."""
    releases = (platform.python_version(), *(module.__version__ for module in (jax, jaxlib, equinox, np)))
    machine = (jax.default_backend(), _processor(), os.environ.get("XLA_FLAGS"))
    digest = hashlib.sha256(repr((releases, machine)).encode())
    package = Path(__file__).parent
    for source in sorted(package.rglob("*.py")):
        digest.update(str(source.relative_to(package)).encode())
        digest.update(source.read_bytes())
    return digest.digest()


def _processor() -> str:
    """What the processor can do, as far as the system says: a folder of the user may serve several machines."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return f"{platform.machine()} {platform.processor()}"
    return next((line for line in lines if line.startswith(("flags", "Features"))), platform.machine())


def outline(tree: Any) -> Any:
    """Nested results (modules, tuples, lists, dictionaries) as lists, texts and numbers, for :func:`of_outline`."""
    if tree is None:
        return ["none"]
    if isinstance(tree, equinox.Module):
        is_static = {field.name: field.metadata.get("static", False) for field in dataclasses.fields(tree)}
        parts = [
            [name, "static" if static else "part", (_plain if static else outline)(getattr(tree, name))]
            for name, static in is_static.items()
        ]
        return ["module", *_named(type(tree)), parts]
    if isinstance(tree, dict):
        return ["dict", [[_plain(name), outline(part)] for name, part in tree.items()]]
    if isinstance(tree, tuple) and hasattr(tree, "_fields"):
        return ["named", *_named(type(tree)), [outline(part) for part in tree]]
    if isinstance(tree, tuple | list):
        return ["tuple" if isinstance(tree, tuple) else "list", [outline(part) for part in tree]]
    return ["number"]


def of_outline(stated: Any) -> Any:
    """Nested results with zeros for their numbers; ValueError for no outline or what is no class of results."""
    match stated:
        case ["none"]:
            return None
        case ["number"]:
            return 0
        case ["tuple", [*parts]]:
            return tuple(of_outline(part) for part in parts)
        case ["list", [*parts]]:
            return [of_outline(part) for part in parts]
        case ["dict", [*parts]]:
            return {_of_plain(name): of_outline(part) for name, part in parts}
        case ["named", str(room), str(name), [*parts]]:
            made = _class(room, name, tuple)
            return made._make(of_outline(part) for part in parts)
        case ["module", str(room), str(name), [*parts]]:
            empty = object.__new__(_class(room, name, equinox.Module))
            for field, kind, part in parts:
                object.__setattr__(empty, field, (_of_plain if kind == "static" else of_outline)(part))
            return empty
    raise ValueError("this is no outline of results")


def _plain(value: Any) -> Any:
    """A value that is no number of the results: a text, or a tuple of texts, also a named one."""
    if isinstance(value, tuple) and hasattr(value, "_fields"):
        return ["named", *_named(type(value)), [_plain(item) for item in value]]
    if type(value) is tuple:
        return ["tuple", [_plain(item) for item in value]]
    if type(value) not in _PLAIN:
        raise ValueError(f"{type(value).__name__} is no plain value")
    return value


def _of_plain(stated: Any) -> Any:
    match stated:
        case ["tuple", [*parts]]:
            return tuple(_of_plain(part) for part in parts)
        case ["named", str(room), str(name), [*parts]]:
            return _class(room, name, tuple)._make(_of_plain(part) for part in parts)
        case str() | int() | float() | None:
            return stated
    raise ValueError("this is no plain value")


def _named(kind: type) -> tuple[str, str]:
    return kind.__module__, kind.__qualname__


def _class(room: str, name: str, above: type) -> Any:
    """A class of a module that is loaded."""
    candidate = getattr(sys.modules.get(room), name, None)
    if not (isinstance(candidate, type) and issubclass(candidate, above)) or _named(candidate) != (
        room,
        name,
    ):
        raise ValueError(f"{room}.{name} is no class of results")
    return candidate

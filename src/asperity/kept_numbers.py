"""Numbers that are found once and kept between processes, as JSON in the folder of JAX's compilation cache.

Nothing of a file is looked at unless this user alone can have written it (:mod:`asperity.own_folder`); the digest tells
damage, not intent. The name of a file says what its numbers depend on: what is asked for, the source of this package,
the releases below it, and the machine.
"""

from __future__ import annotations

import functools
import hashlib
import json
import os
import platform
import threading
import time
from importlib.metadata import version
from pathlib import Path
from typing import Any

from asperity.own_folder import read_own, write_own
from asperity.precision import cache_folder

_PREFIX, _SUFFIX, _PART = "asperity-", ".numbers", ".part"
_DIGEST_SIZE = 32
#: Time after which numbers that are no longer used are removed [s].
_KEPT_FOR = 90 * 24 * 3600.0
#: Time after which nobody writes a half-written file on any more [s]: its process has been ended.
_WRITTEN_WITHIN = 3600.0


def kept_numbers(asked: bytes) -> Any:
    """The JSON document of numbers that an earlier process has kept; None if there is none.

    Parameters
    ----------
    asked : bytes
        All that the numbers depend on besides this package, the releases below it and the machine.
    """
    file = _file(asked)
    content = None if file is None else _read(file)
    try:
        return None if content is None else json.loads(content)
    except (ValueError, RecursionError):  # not written by this module
        return None


def keep_numbers(asked: bytes, document: Any) -> None:
    """Keep a JSON document of numbers for :func:`kept_numbers`."""
    file = _file(asked)
    if file is not None:
        _write(file, json.dumps(document).encode())


def _file(asked: bytes) -> Path | None:
    folder = cache_folder()
    digest = hashlib.sha256(_surroundings() + asked).hexdigest()[:40]
    return folder / f"{_PREFIX}{digest}{_SUFFIX}" if folder else None


def _write(file: Path, content: bytes) -> None:
    """Write a file of the folder with its digest, at once; remove those that nobody has used for long."""
    part = file.with_name(f"{file.name}.{os.getpid()}.{threading.get_ident()}{_PART}")
    try:
        write_own(part, hashlib.sha256(content).digest() + content)
        part.replace(file)
        _remove_unused(file.parent)
    except OSError:  # a full or read-only disk only costs time the next time
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


def _remove_unused(folder: Path) -> None:
    """Numbers of earlier releases, those that nobody asks for any more, and what an ended process left behind."""
    for file in folder.glob(f"{_PREFIX}*"):
        longest = _WRITTEN_WITHIN if file.suffix == _PART else _KEPT_FOR
        if time.time() - file.stat().st_mtime > longest:
            file.unlink(missing_ok=True)


@functools.cache
def _surroundings() -> bytes:
    """A digest of this package's source, of the releases below it, and of the machine."""
    releases = (platform.python_version(), *map(version, ("jax", "jaxlib", "numpy", "scipy")))
    digest = hashlib.sha256(repr((releases, platform.machine(), os.environ.get("XLA_FLAGS"))).encode())
    package = Path(__file__).parent
    for source in sorted(package.rglob("*.py")):
        digest.update(str(source.relative_to(package)).encode())
        digest.update(source.read_bytes())
    return digest.digest()

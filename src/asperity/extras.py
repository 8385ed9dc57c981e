"""Optional packages: how to install them where this package came from."""

from __future__ import annotations

import importlib
import json
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from types import ModuleType
from urllib.parse import urlparse
from urllib.request import url2pathname

from asperity.errors import MissingExtraError


def optional_module(name: str, *, extra: str, needs: str, otherwise: str = "") -> ModuleType:
    """A module of an optional package, or a ``MissingExtraError`` with the command that installs it.

    ``extra`` is the group of ``pyproject.toml`` that brings it; ``needs`` says what needs it, with the verb: "a PDF
    needs"; ``otherwise`` what is possible without it.
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise MissingExtraError(
            f"{needs} the package '{error.name or name}', which is not installed; run: {install_command(extra)}"
            + (f"; {otherwise}" if otherwise else "")
        ) from None


def install_command(extra: str) -> str:
    """The command that adds an optional group of packages to this installation, from an index or its own source."""
    source = _source_folder()
    if source is None:
        return f"pip install 'asperity[{extra}]'"
    return f"pip install '.[{extra}]' in the folder {source}"


def _source_folder() -> Path | None:
    """Folder that the package was installed from; None for a package index."""
    try:
        origin = distribution("asperity").read_text("direct_url.json")
    except PackageNotFoundError:  # used from its source without an installation
        source = Path(__file__).parents[2]
        return source if (source / "pyproject.toml").is_file() else None
    url = json.loads(origin)["url"] if origin else ""
    return Path(url2pathname(urlparse(url).path)) if url.startswith("file:") else None

"""How a command comes to what it does, which is imported only when it runs."""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable

from asperity.precision import use_compilation_cache, use_double_precision


def run_by_name(described: Callable[[], None]) -> Callable[..., object]:
    """The callback of a command that its options and its docstring describe.

    It calls the function of the same name in the module of the same name in :mod:`asperity.cli.runs`, with the options
    as arguments, and returns what that returns. It computes in double precision, and keeps compiled programs.
    """
    module = f"asperity.cli.runs.{described.__module__.rpartition('.')[2]}"

    @functools.wraps(described)
    def run(**options: object) -> object:
        use_double_precision()
        use_compilation_cache()
        return getattr(importlib.import_module(module), described.__name__)(**options)

    return run

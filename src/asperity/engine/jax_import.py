"""What is done as soon as somebody imports JAX: one joint by NumPy does without it, and never waits for it."""

from __future__ import annotations

import importlib.abc
import sys
from collections.abc import Callable, Sequence
from importlib.machinery import ModuleSpec
from types import ModuleType

_ACTIONS: list[Callable[[], None]] = []


def when_jax_is_imported(action: Callable[[], None]) -> None:
    """Do something once JAX is imported; now if it is."""
    if _is_imported():
        action()
        return
    _ACTIONS.append(action)
    if not any(isinstance(finder, _Finder) for finder in sys.meta_path):
        sys.meta_path.insert(0, _Finder())


def _is_imported() -> bool:
    """Whether JAX is imported, and not just being imported."""
    jax = sys.modules.get("jax")
    return jax is not None and not getattr(jax.__spec__, "_initializing", False)


class _Finder(importlib.abc.MetaPathFinder):
    """Finds JAX as everybody else does, and has its loader do what is waiting."""

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """The spec of JAX; None for every other package."""
        if name != "jax":
            return None
        others = (finder for finder in sys.meta_path if finder is not self)
        spec = next(filter(None, (finder.find_spec(name, path, target) for finder in others)), None)
        if spec is None or spec.loader is None:
            return spec
        load = spec.loader.exec_module

        def load_and_act(module: ModuleType) -> None:
            load(module)
            if self in sys.meta_path:
                sys.meta_path.remove(self)
            while _ACTIONS:
                _ACTIONS.pop(0)()

        spec.loader.exec_module = load_and_act  # type: ignore[method-assign]
        return spec

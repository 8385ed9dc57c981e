"""The types of drives, one file each; :data:`TYPES` finds them.

A file states one :class:`asperity.drive.layout.drive_type.DriveType`. A type that leaves out what every type must
state, or whose parts do not fit together, is a ``TypeError`` with the name of its file as soon as this is imported.
"""

from __future__ import annotations

import importlib
import pkgutil

from asperity.drive.layout.drive_type import DriveType


def _type_in(module: str) -> DriveType:
    """The type of drive that a module of this folder states."""
    file = f"drive/types/{module}.py"
    try:
        content = vars(importlib.import_module(f"{__name__}.{module}"))
    except TypeError as error:
        raise TypeError(f"{file}: {error}") from error
    stated = [value for value in content.values() if isinstance(value, DriveType)]
    if len(stated) != 1:
        raise TypeError(f"{file}: a file of this folder states one DriveType, this one {len(stated)}")
    return stated[0]


def _all_types() -> dict[str, DriveType]:
    """The types of all files of this folder by their names, in the order of lists."""
    stated = [_type_in(module.name) for module in pkgutil.iter_modules(__path__)]
    return {kind.name: kind for kind in sorted(stated, key=lambda kind: (kind.rank, kind.name))}


#: The types of drives by the word behind ``type =``.
TYPES = _all_types()
#: That of a file without a type.
(DEFAULT_TYPE,) = (kind.name for kind in TYPES.values() if kind.default_type)
#: Names that types had → their names now.
FORMER_NAMES = {former: kind.name for kind in TYPES.values() for former in kind.former_names}

"""Numbers of a joint file that stay as they are written and that no study varies: an Rz, the share of a load."""

from __future__ import annotations

import functools

from asperity.joint_file.key_paths import keys_by_path
from asperity.joint_file.model import Case
from asperity.joint_file.quantity_key import Key, Quantity
from asperity.joint_file.reader import model_of_type
from asperity.joint_file.section import leaves


@functools.lru_cache(maxsize=1024)
def entered_key_at(path: str, kind: str) -> Key | None:
    """What a dotted path means where such a number stands.

    Parameters
    ----------
    path : str
        For example ``surface.mean_roughness_depth``.
    kind : str
        Type of the drive.

    Returns
    -------
    Key or None
        Dimension, range, unit for display; None where the path is that of another key.
    """
    known, parts = keys_by_path(model_of_type(kind), numbers="entered"), path.split(".")
    generic = [".".join([*parts[:i], "*", *parts[i + 1 :]]) for i in range(1, len(parts) - 1)]
    return next((known[each] for each in (path, *generic) if each in known), None)


def entered_values(case: Case) -> dict[str, tuple[Key, Quantity]]:
    """Every such number that a joint file states."""
    kind = case.type
    return {
        path: (key, key.read(written))
        for path, written in leaves(case, (str, float))
        if (key := entered_key_at(path, kind)) is not None
    }

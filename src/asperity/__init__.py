"""asperity: from a measured rough surface to the torsional stiffness of a traction-drive robot joint.

The package computes in SI units and double precision. ``import asperity`` itself loads nothing heavy;
import the room that you need (``asperity.contact``, ``asperity.drive``, ``asperity.joint.evaluation`` ...), and call
:func:`asperity.precision.use_double_precision` once before the first computation.
"""

from typing import Any

__all__ = ["__version__"]


def __getattr__(name: str) -> Any:
    """Look the version up when it is asked for: reading package metadata costs more than the rest of the import."""
    if name != "__version__":
        raise AttributeError(f"module 'asperity' has no attribute '{name}'")
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("asperity")
    except PackageNotFoundError:  # a source tree that is not installed
        return "0+unknown"

"""asperity: from a measured rough surface to the torsional stiffness of a traction-drive robot joint.

The package computes in SI units and double precision. ``import asperity`` itself loads nothing heavy;
import the room that you need (``asperity.contact``, ``asperity.drive``, ``asperity.joint`` ...), and call
:func:`asperity.precision.use_double_precision` once before the first computation.
"""

from importlib.metadata import PackageNotFoundError, version

try:
    __version__ = version("asperity")
except PackageNotFoundError:  # running from a source tree that is not installed
    __version__ = "0+unknown"

__all__ = ["__version__"]

"""asperity: from a measured rough surface to the torsional stiffness of a traction-drive robot joint.

``asperity.load("joint.toml").solve()`` is the shortest way to an answer; what else a script or a notebook needs is in
``asperity.__all__``, and is imported only when it is used. Input carries its units as text, results carry theirs, and
everything is computed in SI units and double precision. The rooms below (``asperity.contact``, ``asperity.drive``,
``asperity.joint`` ...) are pure functions of arrays; who calls those directly calls
:func:`asperity.precision.use_double_precision` first.
"""

import functools
import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from asperity import errors
    from asperity.api.accuracy import accuracy
    from asperity.api.calibration import calibrate
    from asperity.api.comparison import compare
    from asperity.api.design import design
    from asperity.api.documents import draw, write_report
    from asperity.api.export import export_joint
    from asperity.api.film import film
    from asperity.api.joint import load
    from asperity.api.rolling import roll
    from asperity.api.structure import dynamics, loads
    from asperity.api.studies import plot, sensitivity, sweep, uncertainty
    from asperity.api.surface import measure_surface
    from asperity.api.wear import wear
    from asperity.api.window import window
    from asperity.api.windup import windup

#: Where the functions for scripts are; the names stand here so that importing the package loads none of them.
_OFFERED = {
    "accuracy": "asperity.api.accuracy",
    "calibrate": "asperity.api.calibration",
    "compare": "asperity.api.comparison",
    "design": "asperity.api.design",
    "draw": "asperity.api.documents",
    "dynamics": "asperity.api.structure",
    "export_joint": "asperity.api.export",
    "film": "asperity.api.film",
    "load": "asperity.api.joint",
    "loads": "asperity.api.structure",
    "measure_surface": "asperity.api.surface",
    "plot": "asperity.api.studies",
    "roll": "asperity.api.rolling",
    "sensitivity": "asperity.api.studies",
    "sweep": "asperity.api.studies",
    "uncertainty": "asperity.api.studies",
    "wear": "asperity.api.wear",
    "window": "asperity.api.window",
    "windup": "asperity.api.windup",
    "write_report": "asperity.api.documents",
}

__all__ = [
    "accuracy",
    "calibrate",
    "compare",
    "design",
    "draw",
    "dynamics",
    "errors",
    "export_joint",
    "film",
    "load",
    "loads",
    "measure_surface",
    "plot",
    "roll",
    "sensitivity",
    "sweep",
    "uncertainty",
    "wear",
    "window",
    "windup",
    "write_report",
]


def __getattr__(name: str) -> Any:
    """What is offered, and the version: imported or read when it is asked for."""
    if name in _OFFERED:
        return getattr(importlib.import_module(_OFFERED[name]), name)
    if name == "errors":
        return importlib.import_module("asperity.errors")
    if name != "__version__":
        raise AttributeError(f"module 'asperity' has no attribute '{name}'")
    return _version()


@functools.cache
def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("asperity")
    except PackageNotFoundError:  # a source tree that is not installed
        return "0+unknown"


def __dir__() -> list[str]:
    return [*__all__, "__version__"]

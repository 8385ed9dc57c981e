"""All checks on the installed version, as one document."""

from __future__ import annotations

import hashlib
import platform
from collections.abc import Callable, Iterator
from importlib.metadata import version
from pathlib import Path
from typing import Any

import asperity
from asperity.precision import require_double_precision
from asperity.types import Document
from asperity.validation import (
    contact_checks,
    drive_checks,
    element_checks,
    film_checks,
    heat_checks,
    lay_checks,
    machine_checks,
    paper_checks,
    roller_checks,
    standing_checks,
    turn_checks,
    wear_checks,
)
from asperity.validation.check import Check, failed

#: Name of a group of checks → what computes it.
GROUPS: dict[str, Callable[[], Iterator[Check]]] = {
    "units": paper_checks.units,
    "roughness": paper_checks.roughness,
    "contact law": contact_checks.contact_law,
    "Hertz": contact_checks.hertz,
    "creep": contact_checks.creep,
    "onset of rolling": contact_checks.onset,
    "crowned rollers": roller_checks.crowns,
    "tilted rollers": roller_checks.tilted,
    "skewed rollers": roller_checks.skewed,
    "asperities in rolling": machine_checks.layers,
    "lay": lay_checks.lay,
    "running in": lay_checks.running_in,
    "oil": machine_checks.oil,
    "oil films and shares": film_checks.films,
    "creep with oil": film_checks.creep,
    "heat": heat_checks.heat,
    "wear": wear_checks.wear,
    "stresses": contact_checks.stresses,
    "fatigue": contact_checks.fatigue,
    "discs": element_checks.discs,
    "rings": element_checks.rings,
    "fits and temperature": machine_checks.fits,
    "cam and pins": machine_checks.structure,
    "kinematics": drive_checks.ratios,
    "drive": drive_checks.states,
    "unlike branches": drive_checks.unlike,
    "form errors over a turn": turn_checks.turns,
    "rolling bearings": roller_checks.bearings,
    "wind-up and its models": standing_checks.windup,
    "vibrations": standing_checks.vibrations,
    "half-space": element_checks.half_space,
    "partial slip": element_checks.sliding,
    "rolling": element_checks.rolling,
    "the paper's figures": paper_checks.figures,
}


def run_checks(report: Callable[[int, int], Any] = lambda done, total: None) -> list[Check]:
    """Every check, one group after the other."""
    require_double_precision()
    checks: list[Check] = []
    for done, (name, group) in enumerate(GROUPS.items()):
        report(done, len(GROUPS))
        try:
            checks += list(group())
        except Exception as error:  # whatever is broken in this installation is a finding, not an end
            checks.append(failed(name, error))
    report(len(GROUPS), len(GROUPS))
    return checks


def source_checksum() -> str:
    """Checksum of the installed package's source and data."""
    digest = hashlib.sha256()
    folder = Path(asperity.__file__).parent
    for file in sorted(path for path in folder.rglob("*") if path.suffix in {".py", ".csv", ".toml"}):
        digest.update(file.relative_to(folder).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def validation_document(checks: list[Check]) -> Document:
    """The checks with what they were computed on, ready for :func:`json.dumps`."""
    return {
        "asperity_version": asperity.__version__,
        "source_sha256": source_checksum(),
        "python": platform.python_version(),
        "packages": {name: version(name) for name in ("jax", "jaxlib", "numpy", "scipy")},
        "platform": f"{platform.system()} {platform.machine()}",
        "checks": [check.as_dict() for check in checks],
        "passed": sum(check.passed for check in checks),
        "failed": sum(not check.passed for check in checks),
        "valid": all(check.passed for check in checks),
    }

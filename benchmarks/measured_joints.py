"""Every measured surface of a folder in one joint: what its contacts feel, and how stiff the joint is.

    python benchmarks/measured_joints.py FOLDER [--joint examples/planetary.toml]

FOLDER has the measured files of the tests (``ASPERITY_SHARED_DATA``), with units, gaps and lay as stated below. Prints
a line for each file: D if it has one, the rms of the heights of the narrowest contact with its 95 % interval, K_n
there, the stiffness at the output with the interval of law and measurement, and what is said about its validity.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from asperity.errors import AsperityError
from asperity.precision import use_double_precision

ROLLERS = {"position_unit": "mm", "height_unit": "um", "lay": "rolling"}
#: Folder or file → what it does not say of itself. The lay of profiles of unknown origin is made up.
STATED: dict[str, dict[str, Any]] = {
    "bearing_roller_profiles": ROLLERS,
    "csafe_bullet_land_x3p": {"missing": "interpolate"},
    "surfacetopography_examples": {"missing": "interpolate"},
    "dektak-1.csv": {"lay": "isotropic"},
    "hfm-1.hfm": {"lay": "isotropic"},
    "opdx-3.opdx": {"lay": "isotropic"},
    "opdx-3.txt": {"lay": "isotropic", "position_unit": "m", "height_unit": "m"},
    "tmd-1.tmd": {"height_unit": "um"},
}
OPTIONS: dict[str, Any] = {
    **dict.fromkeys(("position_unit", "height_unit", "spacing", "start", "stop", "form", "degree", "lay")),
    **dict.fromkeys(("outlier_threshold", "short_cutoff", "long_cutoff", "shortest_wavelength")),
    "longest_wavelength": None,
    "decimal": "auto",
    "column": None,
    "no_data": None,
    "any_size": False,
    "missing": "refuse",
    "direction": "x",
    "estimator": "automatic",
    "frequency_ratio": 1.5,
}


def line(file: Path, case: Any) -> str:
    """What the joint with one surface is, or the message."""
    from asperity.joint.solve import solve_joint
    from asperity.joint_file.build import joint_from_case
    from asperity.joint_file.measured_surface import case_with_surface
    from asperity.surface.measure_files import measured_files

    options = OPTIONS | STATED.get(file.parent.name, {}) | STATED.get(file.name, {})
    try:
        measured = measured_files([file], **options)
        made = case_with_surface(case, measured.roughness)
        result = solve_joint(joint_from_case(made)).result
        interval = made.measured.interval(made, joint_from_case(made))["assembly"]
    except AsperityError as error:
        return f"{file.name}: {error}"
    power = "no D, G" if isinstance(measured.fit, str) else f"D {measured.fit.fractal_dimension:.2f}"
    contact = int(np.argmin(result.diagnostics.hertz_half_width))
    low, middle, high = list(made.measured.heights.values())[contact]
    validity = [
        note.split(": ", 1)[1].split(";")[0] for note in made.measured.assumed if "nothing is known" in note
    ]
    validity += [note.split(": ", 1)[1].split(":")[0] for note in made.measured.assumed if "octave" in note]
    stiffness = float(result.assembly.stiffness.output)
    return (
        f"{file.name:16} {power:8} h {1e6 * middle:7.4f} ({1e6 * low:.4f} to {1e6 * high:.4f}) um  "
        f"K_n {1e-6 * float(result.contacts.normal_stiffness[contact]):9.0f} N/um  K {stiffness:9.0f} "
        f"({interval['low_Nm_per_rad']:.0f} to {interval['high_Nm_per_rad']:.0f}) N m/rad  {'; '.join(validity)}"
    )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument(
        "--joint", type=Path, default=Path(__file__).parents[1] / "examples" / "planetary.toml"
    )
    asked = parser.parse_args()
    use_double_precision()
    from asperity.joint_file.reader import read_case

    case = read_case(str(asked.joint))
    folders = [asked.folder / name for name in STATED if (asked.folder / name).is_dir()]
    files = sorted(file for folder in folders for file in folder.iterdir() if file.name != "SOURCE.txt")
    for file in files:
        print(line(file, case), flush=True)
    print(f"{len(files)} files")


if __name__ == "__main__":
    main()

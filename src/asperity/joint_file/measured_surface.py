"""A joint file whose surfaces are replaced by a measured one."""

from __future__ import annotations

from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.model import Case
from asperity.surface.measurement import SurfaceMeasurement


def with_measured_surface(case: Case, measurement: SurfaceMeasurement) -> Case:
    """The joint file with its surfaces replaced by a measured one, at every contact.

    Parameters
    ----------
    case : Case
        A joint file.
    measurement : SurfaceMeasurement
        What was measured.

    Returns
    -------
    Case
        The same joint with the measured D, G and gamma.

    Raises
    ------
    InputError
        If the measured values are outside what a joint file allows.
    """
    entry = {
        "fractal_dimension": float(measurement.fractal_dimension),
        "fractal_roughness": f"{float(measurement.fractal_roughness)!r} m",
        "frequency_ratio": float(measurement.frequency_ratio),
    }
    return case.model_copy(update={"surface": SurfaceEntry.model_validate(entry)}).with_text("")

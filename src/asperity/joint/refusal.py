"""What makes a joint impossible, in words: unknown variants, numbers out of range, bodies that do not fit."""

from __future__ import annotations

import numpy as np

from asperity.errors import InputError
from asperity.joint.evaluation import JointResult
from asperity.units import format_quantity


def refuse_short_contacts(result: JointResult) -> None:
    """Refuse crowned contacts that are too short for their width."""
    holds = result.diagnostics.slices_hold
    if holds is None or np.all(np.asarray(holds)):
        return
    first = int(np.argmin(np.asarray(holds)))
    width = 2.0 * float(np.asarray(result.diagnostics.hertz_half_width)[first])
    ratio = float(np.asarray(result.diagnostics.loaded_length_over_width)[first])
    length, across = (format_quantity(each, "mm", 3) for each in (ratio * width, width))
    raise InputError(
        f"the crowned rollers touch at {result.contact_names[first]} over a length of {length} and a width of "
        f"{across}: the slices need a contact at least twice as long as wide; choose a larger crown radius"
    )

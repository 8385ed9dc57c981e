"""What a section [heat] may not say beside the other sections of a joint file."""

from __future__ import annotations

from asperity.errors import InputError
from asperity.joint_file.sections import HeatEntry


def refuse_heat_of_nothing(heat: HeatEntry, *, duty: bool) -> None:
    """Refuse a cold start above the ambient, and the time of a duty that the file does not state."""
    cold, time = heat.cold_start, heat.duty_time
    if cold is not None and cold.value > heat.ambient.value:
        raise InputError(
            f"heat.cold_start = '{cold.text}' is above heat.ambient = '{heat.ambient.text}', at which the drive starts "
            "anyhow; state the lowest temperature of a start, or leave it out"
        )
    if time is not None and not duty:
        raise InputError(
            f"heat.duty_time = '{time.text}': the file states no loads that it is the time of; give sections [[duty]], "
            "or leave it out"
        )

"""The sections [[form]] of joint files: runout and roundness of the parts."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import BeforeValidator, Field, model_validator

from asperity.errors import InputError, quoted
from asperity.joint_file import limits
from asperity.joint_file.drive_sections import PartName
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import Section

#: The most waves round a part; contacts that are wide against a wave refuse it before.
MOST_WAVES = 999


def _waves(written: object) -> str:
    """The number of waves of a harmonic, a key of the table."""
    text = str(written).strip()
    if not text.isdecimal() or int(text) > MOST_WAVES:
        raise InputError(
            f"the harmonics of a part have whole numbers from 1 to {MOST_WAVES}, the waves round it, such as "
            f'harmonics = {{ 2 = "0.5 um", 3 = "1 um" }}, got {quoted(text)}'
        )
    if int(text) == 0:
        raise InputError(
            "harmonic 0 is a size, no form: use [[branch]] for parts of unlike sizes, or load.interference for all"
        )
    return str(int(text))


class FormEntry(Section):
    """Form errors of one part; write [[form]] above each."""

    part: PartName
    """Name of a roller or ring, or of one track of a stepped roller."""
    sector: Annotated[int, Field(strict=True, ge=1, le=1000)] | None = None
    """Sector of the part, counted from 1 counter-clockwise; all sectors, each with this error, if absent. Not for parts
    on the axis."""
    runout: Annotated[Quantity, limits.RUNOUT] | None = None
    """Full reading of an indicator in one turn about journal or bore: twice the eccentricity."""
    harmonics: (
        dict[Annotated[str, BeforeValidator(_waves)], Annotated[Quantity, limits.FORM_AMPLITUDE]] | None
    ) = None
    """Table of the waves round the part: their number and their amplitude, half of the height from valley to crest."""
    phase: Annotated[Quantity, limits.FORM_PHASE] | None = None
    """Phase of these waves where the part has not turned: a crest of n waves is at minus the phase over n from the x
    axis, counter-clockwise. Not known if absent: the worst and the mean of all phases count."""

    @model_validator(mode="after")
    def _some_error(self) -> Self:
        if self.runout is None and not self.harmonics:
            raise InputError("runout, harmonics: one of both must be given; state the form error of the part")
        if self.runout is not None and "1" in (self.harmonics or {}):
            raise InputError(
                "runout, harmonics.1: both are the eccentricity of the part, the runout twice the amplitude; leave one "
                "of them out"
            )
        return self

"""Runout and roundness that a drawing may allow, as they are shown."""

from __future__ import annotations

import math
from collections.abc import Iterator

from asperity.study.tolerances.runout import AllowedForms
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import number, quantity, words

_ARCSECONDS = 648000.0 / math.pi


def allowed_form_errors(allowed: AllowedForms) -> Iterator[Block]:
    """What is allowed of every harmonic that moves the limited results."""
    rows = [
        (
            words(form.part) + (f" (each of {form.sectors})" if form.sectors > 1 else ""),
            "runout" if form.harmonic == 1 else f"roundness, {form.harmonic} waves",
            quantity(form.reading, "um", 3),
            quantity(form.amplitude, "um", 3),
            f"{number(form.influence, 100.0, 3)} %/µm",
        )
        for form in allowed.forms
    ]
    head = ("part", "what", "full reading", "amplitude", "influence")
    yield Table("Allowed form errors", head, rows, words=(0, 1))
    yield Paragraph(
        f"All together they keep {' and '.join(allowed.limits)}: the transmission error is at worst "
        f"{number(allowed.transmission_error, _ARCSECONDS)} arcsec, its rms "
        f"{number(allowed.transmission_error_rms, _ARCSECONDS)} arcsec, over all phases. The full reading of an "
        "indicator is twice the amplitude. Influence: share of the limit that 1 µm of amplitude uses, of all such "
        "parts together."
    )
    if allowed.without_influence:
        names = ", ".join(words(name) for name in allowed.without_influence)
        yield Paragraph(f"No influence, by the symmetry of the drive: {names}.")

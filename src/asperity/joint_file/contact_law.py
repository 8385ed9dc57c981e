"""The contact law of a joint file: the one it states, or the one that its surfaces suggest."""

from __future__ import annotations

from collections.abc import Collection
from typing import Literal

from asperity.errors import InputError

ContactLaw = Literal["zou_2025", "exponential"]


def contact_law_of(keys: Collection[str], *, stated: str | None) -> ContactLaw:
    """The law of the asperities of a contact.

    Parameters
    ----------
    keys : collection of str
        The keys that its surface states.
    stated : str or None
        ``model.contact_law``; None where the file leaves it out.

    Returns
    -------
    str
        ``"zou_2025"``, the published law of D and G, or ``"exponential"``, that of the rms of the heights,
        :func:`asperity.contact.exponential.random_contact`. Without a statement ``rms_height`` has the latter.

    Raises
    ------
    InputError
        If the surface does not state what the law needs.
    """
    if "rms_height" in keys:
        if stated == "zou_2025":
            raise InputError(
                'model.contact_law = "zou_2025" needs D and G, of which rms_height says nothing: leave contact_law '
                "out, or give fractal_dimension, fractal_roughness and frequency_ratio in place of rms_height"
            )
        return "exponential"
    if stated == "exponential" and "fractal_roughness" in keys:
        raise InputError(
            'model.contact_law = "exponential" needs the rms of the heights, which D and G alone do not fix: give '
            "rms_height or roughness_average in place of fractal_roughness, or leave contact_law out"
        )
    return "exponential" if stated == "exponential" else "zou_2025"

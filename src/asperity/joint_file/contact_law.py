"""The contact law of a joint file: the one it states, or the one that its surfaces suggest."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Literal

from asperity.errors import InputError

ContactLaw = Literal["zou_2025", "exponential", "persson_2007", "measured"]
#: Laws that take the decay length of every contact → what they need of a measurement beside the file.
BY_DECAY_LENGTH = {
    "measured": 'a measured map that was pressed with a hardness, such as "7 GPa" (asperity surface measure)',
    "persson_2007": "the spectrum of a measured surface (asperity surface measure), which neither Ra nor D and G fix,",
}


def contact_law_of(surfaces: Iterable[Collection[str]], *, stated: str | None) -> ContactLaw:
    """The law of the asperities of all contacts, from the keys that each surface states and ``model.contact_law``.

    ``"zou_2025"``, the published law of D and G, or ``"exponential"``, that of the rms of the heights,
    :func:`asperity.contact.exponential.random_contact`. Without a statement surfaces by their ``rms_height`` have the
    latter, and so have finishes with their Ra, where no surface states G. ``"measured"`` and ``"persson_2007"``, the
    same with the decay length by boundary elements on a measured map or by Persson's theory, for surfaces by their
    ``decay_length``; the former without a statement. An ``InputError`` is raised if a surface does not state what the
    law needs.
    """
    stated_keys = list(surfaces)
    by_height = any("rms_height" in keys for keys in stated_keys)
    fractal = any("fractal_roughness" in keys for keys in stated_keys)
    measured = ["decay_length" in keys for keys in stated_keys]
    if all(measured) and stated in (None, *BY_DECAY_LENGTH):
        return "persson_2007" if stated == "persson_2007" else "measured"
    if any(measured):
        raise InputError(
            'decay_length belongs to model.contact_law = "measured" or "persson_2007": leave contact_law out, and give '
            "the decay_length of all contacts or of none"
        )
    if stated in BY_DECAY_LENGTH:
        raise InputError(
            f'model.contact_law = "{stated}" needs {BY_DECAY_LENGTH[stated]} beside the file, or surface.decay_length '
            "in it"
        )
    if by_height and stated == "zou_2025":
        raise InputError(
            'model.contact_law = "zou_2025" needs D and G, of which rms_height says nothing: leave contact_law '
            "out, or give fractal_dimension, fractal_roughness and frequency_ratio in place of rms_height"
        )
    if by_height and fractal:
        raise InputError(
            "one contact law for all contacts: some surfaces have rms_height, others D and G; give all in one way"
        )
    if stated == "exponential" and fractal:
        raise InputError(
            'model.contact_law = "exponential" needs the rms of the heights, which D and G alone do not fix: give '
            "rms_height or roughness_average in place of fractal_roughness, or leave contact_law out"
        )
    of_finishes = stated is None and not fractal and all("finish" in keys for keys in stated_keys)
    return "exponential" if by_height or of_finishes or stated == "exponential" else "zou_2025"

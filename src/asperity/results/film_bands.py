"""Lubrication of contacts by the ratio of their oil film to the roughness: its bands, and what they mean."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

#: Oil film over roughness above which the film carries a part of the load, and all of it [-]; Tallian 1967.
MIXED_FILM, FULL_FILM = 1.0, 3.0
#: What each band of the lubrication means.
BAND_WORDS = {
    "boundary": "the asperities carry the load and wear",
    "mixed": "the oil film carries part of the load",
    "full": "the oil film carries the load",
}
#: The same in a sentence, with the ratios between them.
BANDS = (
    f"Lubrication (Tallian): boundary below λ {MIXED_FILM:g}, {BAND_WORDS['boundary']}; mixed to {FULL_FILM:g}, "
    f"{BAND_WORDS['mixed']}; full above, {BAND_WORDS['full']}."
)


def surface_rows(
    contacts: Mapping[str, Any],
) -> list[tuple[str, float | None, float | None, float | None, str]]:
    """Flash temperature [K], smallest oil film [µm], film over roughness and lubrication of the contacts in rolling.

    From a document of a joint; no rows where nothing of it is known.
    """
    rows = []
    for name, contact in contacts.items():
        rise, film, ratio = (
            contact[key] for key in ("flash_temperature_K", "film_thickness_m", "film_ratio")
        )
        thick, band = None if film is None else 1e6 * film, "" if ratio is None else film_band(ratio)
        rows.append((name, rise, thick, ratio, band))
    return rows if any(number is not None for row in rows for number in row[1:4]) else []


def film_band(ratio: float) -> str:
    """Who carries the load at an oil film over roughness: the asperities, both, or the film; empty for nan.

    References
    ----------
    T. E. Tallian, ASLE Trans. 10 (1967) 418.
    """
    if math.isnan(ratio):
        return ""
    return "boundary" if ratio < MIXED_FILM else "mixed" if ratio < FULL_FILM else "full"


def life_with_film(factor: float | None) -> str:
    """What the film does to the rating life of a contact."""
    if factor is None:
        return "the rating life has no film factor, and may be too long"
    if math.isnan(factor):
        return "there is no rating life with so thin a film, κ = λ^1.3 below 0.1"
    return "the rating life has its film factor a_ISO"

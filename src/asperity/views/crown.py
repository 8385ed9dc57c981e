"""Which crown takes up a tilt of the rollers."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import number, quantity, words

_NOTES = (
    "Drops are those of both bodies together; crowns of both add as 1/R. A crown on a roller acts in all its contacts: "
    "take the smallest radius. Pressures are those of slices. Edge: an end carries load; in theory the pressure of its "
    "sharp edge has no bound, which is why the recommended drops z leave the ends free. The logarithmic profile drops "
    "by A ln(1/(1 - (1 - exp(-z/A))(2y/B)^2)) at y from the middle of its length B; those of Lundberg and of ISO/TS "
    "16281 by A ln(1/(1 - (2y/B)^2)), without bound at the very ends, which no load then reaches.",
    "ISO/TS 16281 profiles the roller alone: A is 0.00035 times the diameter of the smaller body, for lengths up to "
    "2.5 times that diameter.",
    "The tilt is the angle between the axes in the plane through both, by which a line opens at one end; rolling.skew "
    "is the angle across it, which moves rollers along their axes and loads no end.",
)
#: Columns of the tables: what is shown, and in how many of these units a metre, a pascal or a share is.
_COLUMNS = {
    "drop at ends\nµm": ("end_drop_m", 1e6),
    "radius\nmm": ("crown_radius_m", 1e3),
    "A\nµm": ("coefficient_m", 1e6),
    "peak pressure\nMPa": ("peak_pressure_Pa", 1e-6),
    "peak over mean\n-": ("peak_over_mean", 1.0),
    "end over mean\n-": ("end_over_mean", 1.0),
}
_NAMES = {"iso_16281": "ISO/TS 16281", "lundberg": "Lundberg"}
_SHARES = {None: "", 0.5: ", half", 1.0: ", recommended", 2.0: ", double"}


def crown(document: Document) -> Iterator[Block]:
    """The profiles of each contact of a document of crowns, and what they leave out."""
    tilt = quantity(document["tilt_rad"], "mrad")
    for name, contact in document["contacts"].items():
        if not contact["profiles"]:
            yield Paragraph(f"{words(name)}: carries no force.")
            continue
        rows = [
            (
                _NAMES.get(entry["profile"], words(entry["profile"]))
                + _SHARES[entry["share_of_recommended"]],
                *(
                    "edge" if key == "peak_pressure_Pa" and entry["edge"] else number(entry[key], factor)
                    for key, factor in _COLUMNS.values()
                ),
            )
            for entry in contact["profiles"]
        ]
        force, length = quantity(contact["normal_force_N"], "N"), quantity(contact["contact_length_m"], "mm")
        yield Table(f"{words(name)}: {force} on {length}, tilt {tilt}", ("profile", *_COLUMNS), rows)
    for note in _NOTES:
        yield Paragraph(note)

"""Crowns for a tilt, as they are shown: drops in micrometres, radii in millimetres."""

import pytest
from shown_blocks import cells, four, sentences, tables

from asperity.results.crown_document import crown_document
from asperity.views.crown import crown

HEADS = [
    "profile",
    "drop at ends µm",
    "radius mm",
    "A µm",
    "peak pressure MPa",
    "peak over mean -",
    "end over mean -",
]


@pytest.fixture(scope="module")
def document(planetary_view):
    return crown_document(planetary_view.solved, 0.5e-3)


def test_every_contact_has_a_table(document):
    shown = tables(crown(document))
    titles = [
        f"{name}: {contact['normal_force_N']:.4g} N on 10 mm, tilt 0.5 mrad"
        for name, contact in document["contacts"].items()
    ]
    assert list(shown) == titles
    for table in shown.values():
        assert [head.replace("\n", " ") for head in table.head] == HEADS


def test_the_recommended_circle_by_its_drop(document):
    """A circle of radius R drops by L²/(8 R) at the ends of a line of 10 mm."""
    for contact, table in zip(document["contacts"].values(), tables(crown(document)).values(), strict=True):
        rows = cells(table)
        assert list(rows) == [
            "as stated",
            *(
                f"{kind}, {share}"
                for kind in ("circular", "logarithmic", "Lundberg")
                for share in ("half", "recommended", "double")
            ),
            "ISO/TS 16281",
        ]
        drop, radius, coefficient, peak, _, end = rows["circular, recommended"]
        assert float(drop) == four(1e3 * 10.0**2 / (8.0 * float(radius)))
        assert (coefficient, end) == ("–", "0")
        assert float(peak) == four(1e-6 * contact["profiles"][2]["peak_pressure_Pa"])
        assert float(rows["circular, double"][0]) == four(2.0 * float(drop))
        assert rows["logarithmic, recommended"][1] == "–"
        assert float(rows["logarithmic, recommended"][2]) == four(
            1e6 * contact["profiles"][5]["coefficient_m"]
        )
        assert rows["as stated"][0] == "0"
        assert (rows["as stated"][3], rows["circular, half"][3]) == ("edge", "edge")


def test_a_contact_without_a_force_has_no_table_and_notes_are_told(document):
    sp = document["contacts"]["sp"]
    blocks = list(crown(document | {"contacts": {"left_pair": sp | {"profiles": []}}}))
    assert tables(blocks) == {}
    said = sentences(blocks)
    assert said[0] == "left pair: carries no force."
    assert "crowns of both add as 1/R" in said[1]
    assert "loads no end" in said[3]

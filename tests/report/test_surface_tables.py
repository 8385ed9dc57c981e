"""Tables of a report about the surfaces."""

from asperity.report import surface_tables
from asperity.report.content import Paragraph, Table

LEVELS = ("assembly", "series_with_bulk", "published")
INTERVAL = {
    **{level: {"low_Nm_per_rad": 7000.0, "high_Nm_per_rad": None} for level in LEVELS},
    "drift": {"low_rad_per_output_turn": 0.0029088820866572, "high_rad_per_output_turn": None},
    "words": "D from 1.15 to 1.5.",
}


def test_an_interval_over_ra_with_its_drift():
    table, drift, words = surface_tables.drawn_stiffness(INTERVAL)
    assert isinstance(table, Table)
    assert [row[1:] for row in table.rows] == [("7000", "–")] * 3
    assert drift == Paragraph("Drift from 10 arcmin to – per output turn.")
    assert words == Paragraph("D from 1.15 to 1.5.")
    assert list(surface_tables.drawn_stiffness(None)) == []


def test_the_ra_of_every_surface():
    entry = {
        "contacts": ["sp", "pwr"],
        "fractal_dimension": 1.4,
        "fractal_roughness_m": 1e-11,
        "roughness_average_m": 0.2e-6,
        "roughness_average_low_m": 0.15e-6,
        "roughness_average_high_m": 0.25e-6,
        "cut_off_m": 0.8e-3,
    }
    (row,) = surface_tables.averages({"surfaces": [entry]}).rows
    assert row == ("sp, pwr", "1.4", "1e-8", "0.8", "0.2", "0.15 to 0.25")

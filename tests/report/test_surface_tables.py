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
    (row,) = surface_tables.averages(
        {"surfaces": [entry], "standing": {"contacts": dict.fromkeys("abcde")}}
    ).rows
    assert row == ("sp, pwr", "1.4", "1e-8", "0.8", "0.2", "0.15 to 0.25")
    # a drive with two contacts has these on all
    (row,) = surface_tables.averages(
        {"surfaces": [entry], "standing": {"contacts": {"sp": 0, "pwr": 0}}}
    ).rows
    assert row[0] == "all"


def test_interval_of_a_measured_surface_says_which_draws_are_left_out():
    ends = {"low_Nm_per_rad": 2e4, "high_Nm_per_rad": 3e4}
    interval = dict.fromkeys(("assembly", "series_with_bulk", "published"), ends)
    interval["drift"] = INTERVAL["drift"]
    interval |= {"confidence": 0.95, "draws": 200, "outside": 1, "unsolved": 2, "all_plastic": 3}
    measured = {"fractal_dimension": 1.5, "fractal_roughness_m": 1e-9}
    table, drift, said = surface_tables.measured_stiffness(measured, interval)
    assert table.title == "95 % interval from the measured surface, D = 1.5, G = 1e-6 mm"
    assert [tuple(row[1:]) for row in table.rows] == [("20000", "30000")] * 3
    assert drift.text.startswith("Drift from 10 arcmin")
    assert said.text.startswith(
        "Of 200 draws of D and G, 1 had a D outside 1 to 2, 2 had no solution and 3 had plastic"
    )
    none = interval | {"outside": 0, "unsolved": 0, "all_plastic": 0}
    assert len(list(surface_tables.measured_stiffness(measured, none))) == 2

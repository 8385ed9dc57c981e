"""The oil over speed as it is shown: tables at each temperature, dashes and a word where the joint slips."""

from pathlib import Path

import pytest
from shown_blocks import sentences, tables

import asperity
from asperity.joint_file.film import joint_film
from asperity.results.film_document import film_document
from asperity.views.film import film

OIL = Path(__file__).parents[2] / "examples" / "oil.toml"


@pytest.fixture(scope="module")
def document():
    return film_document(joint_film(asperity.load(OIL).case, temperatures=(80.0,), points=40))


def test_the_speed_of_the_file_comes_first(document):
    title, table = next(iter(tables(film(document)).items()))
    assert title == "Oil in the contacts at 1500 rpm, 10 N·m and 40 °C"
    assert [row[0] for row in table.rows] == ["sp", "pr"]
    assert table.rows[0][4] == "mixed"


def test_a_table_has_some_speeds_both_ends_and_that_of_the_file(document):
    rows = tables(film(document))["Contact sp over speed, oil at 80 °C"].rows
    speeds = [row[0] for row in rows]
    assert len(rows) <= 15
    assert (speeds[0], speeds[-1]) == ("1.5", "3000")
    assert "1500" in speeds


def test_slip_is_a_dash_with_a_word(document):
    shown = tables(film(document))
    first, *_, last = shown["Contact pr over speed, oil at 80 °C"].rows
    assert first[4] == "boundary"
    assert last[1:] == ("–", "–", "–", "slips", "–", "–", "–", "–")
    last = shown["The joint over speed, oil at 80 °C"].rows[-1]
    assert last[1:] == ("–", "–", "no steady rolling")


def test_notes(document):
    said = " ".join(sentences(film(document)))
    assert "uncertain by a factor of 1.6" in said
    assert "does not roll steadily" in said
    assert "Only the oil has the temperatures shown" in said
    # Santotrac 50 was measured from 80 degC on, and the file has 40
    assert "Below 80 °C, the lowest temperature of its data" in said

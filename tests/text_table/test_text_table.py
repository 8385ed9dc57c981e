"""One table of numbers in a text: where it stands, its headings, what other lines state."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.text_table.decoding import decoded, looks_like_text, refuse_unmarked_utf_16
from asperity.text_table.entries import entries, plain_key
from asperity.text_table.headings import Heading, factor_and_unit, heading_of, is_counted, is_unit
from asperity.text_table.layout import Dialect, Line
from asperity.text_table.numbers import field_value, is_missing, is_missing_word, number_in
from asperity.text_table.text_table import text_table


@pytest.mark.parametrize(
    ("field", "point", "comma"),
    [
        ("12", 12.0, 12.0),
        ("-1.5", -1.5, None),
        ("-1,5", None, -1.5),
        (".5", 0.5, None),
        (",5", None, 0.5),
        ("2.", 2.0, None),
        ("+1e-3", 1e-3, 1e-3),
        ("1.5E+02", 150.0, None),
        ("1_0", None, None),
        ("0x1f", None, None),
        ("१", None, None),
        ("", None, None),
        ("1,234.5", None, None),
    ],
)
def test_numbers_of_both_decimal_signs(field, point, comma):
    assert number_in(field, comma=False) == point
    assert number_in(field, comma=True) == comma


def test_marks_of_missing_values():
    for word in ("nan", "NaN", "BAD", "Bad", "#N/A", "n/a", "NULL", "NoData", "1.#QNAN"):
        assert is_missing_word(word)
        assert is_missing(word)
        assert np.isnan(field_value(word, comma=False))
    for stroke in ("", "-", "--", "---", "*", "***", "?"):
        assert is_missing(stroke)
        assert not is_missing_word(stroke)
    for other in ("x", "----", "0", "nano", "-a"):
        assert not is_missing(other)
    assert field_value("x", comma=False) is None


@pytest.mark.parametrize(
    ("text", "factor", "unit"),
    [
        ("nm", 1.0, "nm"),
        ("0.1 nm", 0.1, "nm"),
        ("x10 nm", 10.0, "nm"),
        ("×10nm", 10.0, "nm"),
        ("1e-9 m", 1e-9, "m"),
        ("10^-6 m", 1e-6, "m"),
        ("10**-6 m", 1e-6, "m"),
        ("10⁻⁶ m", 1e-6, "m"),
        ("2 x um", 2.0, "um"),
        ("Micrometers", 1.0, "micrometers"),
        ("NM", 1.0, "NM"),
        ("10^999999 m", 1.0, "10^999999 m"),
    ],
)
def test_numbers_before_a_unit(text, factor, unit):
    found, named = factor_and_unit(text)
    assert found == pytest.approx(factor, rel=1e-12)
    assert named == unit


def test_units_and_counts():
    for unit in ("mm", "N*m", "%", "deg", "V", "mV", "0.1 nm", "dB", "arcmin/rev"):
        assert is_unit(unit), unit
    for other in ("counts", "px", "-", "1", "", "raw", "MM", "xyz"):
        assert not is_unit(other), other
    for counted in ("counts", "Counts", "px", "-", "LSB"):
        assert is_counted(counted)


@pytest.mark.parametrize(
    ("field", "name", "unit"),
    [
        ("z [um]", "z", "um"),
        ("Height (nm) filtered", "Height filtered", "nm"),
        ("z/nm", "z", "nm"),
        ("height in um", "height", "um"),
        ("Raw Micrometers", "Raw", "Micrometers"),
        ("angle_deg", "angle", "deg"),
        ("Z min", "Z min", None),
        ("z (raw)", "z (raw)".replace(" (raw)", ""), None),
        ("z [nm x 10]", "z", "nm x 10"),
        ("z [counts]", "z", None),
        ("", "", None),
    ],
)
def test_a_heading_has_a_name_and_a_unit(field, name, unit):
    found = heading_of(field)
    assert (found.name, found.unit) == (name, unit)
    assert found.text == field


def test_units_in_brackets_come_before_others_and_later_lines_before_earlier_ones():
    table = text_table("a [mm],b [mm]\na [um],b nm\nx,y\n1,2.5\n2,3\n3,4\n", source="t")
    assert [(h.name, h.unit) for h in table.headings] == [("x", "um"), ("y", "mm")]
    assert str(Heading(text="x [um]")) == "'x [um]'"


@pytest.mark.parametrize(
    ("line", "key", "number", "unit", "text"),
    [
        ("# x-length = 24000", "xlength", 24000.0, "", "24000"),
        ("Tip radius: 2 um", "tipradius", 2.0, "um", "2 um"),
        ('"Pitch","0.5","um"', "pitch", 0.5, "um", "0.5 um"),
        ("Spacing;0,5;um", "spacing", 0.5, "um", "0,5 um"),
        ("dx [um] = 1.5", "dx", 1.5, "um", "1.5"),
        ("height conversion factor (-> m) = 1e-9", "heightconversionfactor", 1e-9, "m", "1e-9"),
        ("cellsize 0.5", "cellsize", 0.5, "", "0.5"),
        ("# Value units: m", "valueunits", None, "", "m"),
        ("Resolution,0.156 um/sample", "resolution", 0.156, "um/sample", "0.156 um/sample"),
    ],
)
def test_lines_state_values(line, key, number, unit, text):
    (entry,) = entries([Line(3, line)])
    assert (entry.key, entry.number, entry.unit, entry.text) == (key, number, unit, text)
    assert str(entry).startswith("line 3, '")
    assert plain_key("X-Pixels_2") == "xpixels2"


@pytest.mark.parametrize("line", ["2:15 pm", "Scan Data", "800", ""])
def test_other_lines_state_nothing(line):
    assert entries([Line(1, line)]) == ()


@pytest.mark.parametrize(
    ("text", "separator", "comma"),
    [
        ("1.5\t2\n2\t3\n3\t4\n", "\t", False),
        ("1,5\t2\n2\t3\n3\t4\n", "\t", True),
        ("1.5;2\n2;3\n3;4\n", ";", False),
        ("1,5;2\n2;3\n3;4\n", ";", True),
        ("1.5,2\n2,3\n3,4.5\n", ",", False),
        ("1.5 2\n2 3\n3  4\n", None, False),
        ("1,5 2\n2 3\n3  4\n", None, True),
    ],
)
def test_separators_and_decimal_signs_are_found(text, separator, comma):
    table = text_table(text, source="t")
    assert table.dialect == Dialect(separator, comma)
    np.testing.assert_array_equal(table.values[1:, 0], [2.0, 3.0])
    assert table.values[0, 0] == 1.5


def test_line_numbers_comments_and_gaps():
    text = "head\n\n1.5 2\n# pause\n2 3\n\n3 4\n4 5\n# end\n"
    table = text_table(text, source="t")
    assert list(table.line_numbers) == [3, 5, 7, 8]
    assert [str(line) for line in table.inside] == ["line 4, '# pause'"]
    assert table.first_gap == 6
    assert text_table("1 2\n2 3\n\n3 4\n4 5\n", source="t").first_gap == 3
    assert text_table("1 2\n\n2 3\n\n3 4\n\n4 5\n", source="t").first_gap == 0
    assert table.row_words == "4 rows of 2 columns"


def test_numbers_that_stand_alone_above_a_table_are_no_rows():
    """Single rows of other files' headings, with as many numbers as the table has columns."""
    table = text_table("0 0 12\nname of the part\n0 1 2.5\n1 1 3.5\n2 1 4.5\n3 1 5.5\n", source="t")
    assert table.values.shape == (4, 3)
    assert [line.number for line in table.unused] == [1, 2]


def test_the_decimal_sign_may_be_stated():
    text = "1,5\n2,5\n3,5\n"
    with pytest.raises(InputError, match="may be one number with a decimal comma or two whole numbers"):
        text_table(text, source="t")
    assert text_table(text, source="t", decimal="comma").values.tolist() == [[1.5], [2.5], [3.5]]
    assert text_table(text, source="t", decimal="point").values.tolist() == [
        [1.0, 5.0],
        [2.0, 5.0],
        [3.0, 5.0],
    ]
    assert text_table("a [mm],b [um]\n" + text, source="t").values.shape == (3, 2)
    with pytest.raises(InputError, match="must be 'auto', 'point' or 'comma', not 'dot'"):
        text_table(text, source="t", decimal="dot")


def test_encodings():
    text = "x [µm]\n1\n"
    for encoding in ("utf-8", "utf-8-sig", "utf-16", "latin-1"):
        assert decoded(text.encode(encoding), source="t") == text
        assert looks_like_text(text.encode(encoding))
    with pytest.raises(InputError, match="begins as text in UTF-16 and is not"):
        decoded(b"\xff\xfe\x00\xd8", source="t")
    assert not looks_like_text(b"\x89PNG\r\n\x1a\n\0\0")
    assert not looks_like_text(b"")
    refuse_unmarked_utf_16(np.arange(3000, dtype="<i2").tobytes(), source="t")
    for encoding in ("utf-16-le", "utf-16-be"):
        with pytest.raises(InputError, match="save it as text in UTF-8"):
            refuse_unmarked_utf_16(("x [um] z [um]\n" * 9).encode(encoding), source="t")

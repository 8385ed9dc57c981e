"""CSV tables of roller pairs against the reference quadrature, and everything that can be wrong with them."""

import csv
import re
from pathlib import Path

import pytest

from asperity.errors import InputError
from asperity.joint_file import contact_table
from asperity.joint_file.contact_table import INPUT_COLUMNS, OUTPUT_COLUMNS, convert_contact_table
from asperity.validation.contact_checks import CONTACT_LAW_TABLE

#: 40 cases by direct quadrature of the definitions at 20 and more digits, see CONTACT_LAW_TABLE.
REFERENCE = CONTACT_LAW_TABLE
INPUT = [*INPUT_COLUMNS, "lambda"]


def reference_rows() -> list[dict[str, str]]:
    with open(REFERENCE, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def write(path: Path, rows: list[dict[str, str]], columns: list[str] = INPUT) -> Path:
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, columns, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)
    return path


def convert(source: Path, target: Path):
    return convert_contact_table(source, target, frequency_ratio=1.5, asperity_base="majumdar_bhushan_1991")


def read(path: Path) -> list[dict[str, str]]:
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def assert_agrees(made: list[dict[str, str]], reference: list[dict[str, str]]) -> None:
    for ours, theirs in zip(made, reference, strict=True):
        plastic = float(theirs["a_l_mm2"]) <= float(theirs["a_c_mm2"])
        for name in OUTPUT_COLUMNS:
            if plastic and name in ("Kt_N_per_mm", "Kn_N_per_mm"):
                assert (ours[name], theirs[name]) == ("nan", "0.0"), name
            else:
                assert float(ours[name]) == pytest.approx(float(theirs[name]), rel=1e-10, abs=0.0), name


def test_results_stand_behind_the_input_and_agree_with_the_reference(tmp_path):
    rows = reference_rows()
    summary = convert(write(tmp_path / "in.csv", rows), tmp_path / "out.csv")
    made = read(tmp_path / "out.csv")
    assert (summary.rows, summary.replaced_columns, summary.plastic_rows) == (len(rows), (), 3)
    assert list(made[0]) == list(rows[0])
    assert [[row[name] for name in INPUT] for row in made] == [[row[name] for name in INPUT] for row in rows]
    assert_agrees(made, rows)


def test_chunks_give_the_same_rows_in_the_same_order(tmp_path, monkeypatch):
    monkeypatch.setattr(contact_table, "ROWS_AT_ONCE", 16)
    done = []
    convert_contact_table(
        write(tmp_path / "in.csv", reference_rows()),
        tmp_path / "out.csv",
        frequency_ratio=1.5,
        asperity_base="majumdar_bhushan_1991",
        progress=done.append,
    )
    assert done == [16, 32, 40]
    assert_agrees(read(tmp_path / "out.csv"), reference_rows())


def test_result_columns_are_replaced_and_others_carried_along(tmp_path):
    rows = [{**row, "label": f"pair {i}", "psi": "0"} for i, row in enumerate(reference_rows()[:3])]
    columns = ["label", *INPUT, "psi"]
    summary = convert(write(tmp_path / "t.csv", rows, columns), tmp_path / "out.csv")
    made = read(tmp_path / "out.csv")
    assert summary.replaced_columns == ("psi",)
    assert list(made[0]) == ["label", *INPUT, *OUTPUT_COLUMNS]
    assert made[2]["label"] == "pair 2"
    assert_agrees(made, reference_rows()[:3])


def test_a_table_without_rows_gives_a_table_without_rows(tmp_path):
    assert convert(write(tmp_path / "in.csv", []), tmp_path / "out.csv").rows == 0
    assert (tmp_path / "out.csv").read_text() == ",".join([*INPUT, *OUTPUT_COLUMNS]) + "\n"


@pytest.mark.parametrize(
    ("column", "value", "said"),
    [
        ("D", "2.0", "line 3, column D: 2.0 is not allowed; it must be above 1 and below 2"),
        ("D", "x", "line 3, column D: 'x' is not a number"),
        ("D", "", "line 3, column D: '' is not a number"),
        ("D", "nan", "line 3, column D: 'nan' is not a number"),
        ("F_N", "-1", "line 3, column F_N: -1 N is not allowed; it must be above 0 N"),
        ("F_N", "inf", "line 3, column F_N: inf N is not allowed"),
        (
            "F_N",
            "1.02e9",
            "line 3, column F_N: 1.02e9 N is not allowed; it must be above 0 N and at most 1e9 N",
        ),
        ("T_N", "-1", "line 3, column T_N: -1 N is not allowed"),
        ("T_N", "1.02e9", "line 3, column T_N: 1.02e9 N is not allowed"),
        ("E2_MPa", "1.02e7", "line 3, column E2_MPa: 1.02e7 MPa is not allowed"),
        ("E2_MPa", "0.098", "line 3, column E2_MPa: 0.098 MPa is not allowed"),
        ("mu", "0", "line 3, column mu: 0 is not allowed"),
        ("R1_mm", "1e99", "line 3, column R1_mm: 1e99 mm is not allowed"),
        ("sign", "0", "line 3, column sign: 0 is not allowed; it must be 1 or -1"),
        ("sign", "0.5", "line 3, column sign: 0.5 is not allowed"),
        ("nu1", "0.6", "line 3, column nu1: 0.6 is not allowed"),
        ("E1_MPa", "0", "line 3, column E1_MPa: 0 MPa is not allowed"),
        ("H_MPa", "-5", "line 3, column H_MPa: -5 MPa is not allowed"),
        ("lambda", "printd", "line 3, column lambda: 'printd' is not one of printed, hertz_area, unity"),
    ],
)
def test_a_bad_cell_is_told_with_line_and_column_and_nothing_is_written(tmp_path, column, value, said):
    rows = reference_rows()[:3]
    rows[1][column] = value
    with pytest.raises(InputError, match=re.escape(said)) as refused:
        convert(write(tmp_path / "in.csv", rows), tmp_path / "out.csv")
    assert "nothing was written" in str(refused.value)
    assert [path.name for path in tmp_path.iterdir()] == ["in.csv"]


def test_several_bad_cells_are_listed_by_line(tmp_path):
    rows = reference_rows()[:20]
    for row in rows[2:]:
        row["mu"] = "-1"
    rows[0]["R1_mm"] = rows[0]["R2_mm"] = "5"
    rows[0]["sign"] = "-1"
    with pytest.raises(InputError) as refused:
        convert(write(tmp_path / "in.csv", rows), tmp_path / "out.csv")
    message = str(refused.value).splitlines()
    assert message[0].endswith("19 bad cells, nothing was written")
    assert "line 2, column R2_mm: an inner contact (sign -1) needs two different radii" in message[1]
    assert "line 4, column mu" in message[2]
    assert message[-1].strip() == "and 7 more"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "empty"),
        ("D,G_mm\n", "missing columns: F_N"),
        (",".join(INPUT).replace("F_N", "FN") + "\n", "missing columns: F_N; did you mean 'FN'?"),
        (",".join([*INPUT, "D"]) + "\n", "there is more than one column 'D'"),
        (",".join(INPUT) + "\n1.4,2\n", "line 2: 2 cells, but the header has 15 columns"),
        (",".join(INPUT) + '\n"1.4\n', "not a CSV table"),
    ],
)
def test_tables_of_another_form(tmp_path, text, said):
    (tmp_path / "in.csv").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=re.escape(said)):
        convert(tmp_path / "in.csv", tmp_path / "out.csv")
    assert not (tmp_path / "out.csv").exists()


def test_files_that_cannot_be(tmp_path):
    source = write(tmp_path / "in.csv", reference_rows()[:1])
    with pytest.raises(InputError, match=r"absent\.csv: there is no such file"):
        convert(tmp_path / "absent.csv", tmp_path / "out.csv")
    with pytest.raises(InputError, match="is not a regular file; give another name"):
        convert(source, tmp_path)
    with pytest.raises(InputError, match="there is no folder"):
        convert(source, tmp_path / "nowhere" / "out.csv")
    (tmp_path / "bytes.csv").write_bytes(b"D,\xff\n")
    with pytest.raises(InputError, match="not a text file in UTF-8"):
        convert(tmp_path / "bytes.csv", tmp_path / "out.csv")


def test_the_table_that_is_read_is_not_written_over(tmp_path):
    table = write(tmp_path / "t.csv", reference_rows()[:1])
    before = table.read_bytes()
    (tmp_path / "link.csv").symlink_to(table)
    for target in (table, tmp_path / "link.csv"):
        with pytest.raises(InputError, match="this is the file that is read; give another name"):
            convert(table, target)
    assert table.read_bytes() == before


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("a" * 2_000_000, "a row has more than 1000000 characters; this is not a table"),
        ('"a\n' + "b\n" * 600_000, "field larger than field limit"),
        ('"\n",' * 400_000, "a row has more than 1000000 characters"),
        (",".join(f"c{i}" for i in range(100_000)), "line 1: missing columns: D, G_mm"),
        (",".join(["D"] * 100_000), "line 1: there is more than one column 'D'"),
        ("\x1b[2J,\x1b[2J", r"line 1: there is more than one column '\\x1b\[2J'"),
    ],
)
def test_tables_without_end_are_refused_soon(tmp_path, content, reason):
    import time

    (tmp_path / "in.csv").write_text(content)
    start = time.perf_counter()
    with pytest.raises(InputError, match=reason) as refused:
        convert(tmp_path / "in.csv", tmp_path / "out.csv")
    assert time.perf_counter() - start < 5.0
    assert str(refused.value).isprintable()
    assert not (tmp_path / "out.csv").exists()


def test_rows_are_handed_on_before_they_fill_the_memory(tmp_path, monkeypatch):
    monkeypatch.setattr(contact_table, "CHARACTERS_AT_ONCE", 300)
    done = []
    convert_contact_table(
        write(tmp_path / "in.csv", reference_rows()[:6]),
        tmp_path / "out.csv",
        frequency_ratio=1.5,
        asperity_base="majumdar_bhushan_1991",
        progress=done.append,
    )
    assert done[-1] == 6
    assert len(done) > 1
    assert_agrees(read(tmp_path / "out.csv"), reference_rows()[:6])

"""``asperity contact``: a table in, a table out."""

from asperity.validation.contact_checks import CONTACT_LAW_TABLE

REFERENCE = CONTACT_LAW_TABLE


def test_a_table_is_written_and_said(call, tmp_path):
    outcome = call("contact", "--table", REFERENCE, "--out", tmp_path / "out.csv")
    assert outcome.code == 0
    assert outcome.out == ""
    assert "wrote" in outcome.err
    assert "40 roller pairs" in outcome.err
    assert "replaced the columns psi, lam" in outcome.err
    assert "Kt and Kn are nan in 3 of them: every spot is plastic" in " ".join(outcome.err.split())
    assert (tmp_path / "out.csv").read_text().count("\n") == 41


def test_a_bad_row_is_exit_code_2_and_nothing_is_written(call, tmp_path):
    lines = REFERENCE.read_text().splitlines()
    lines[4] = lines[4].replace(",", ",x", 1)
    (tmp_path / "in.csv").write_text("\n".join(lines))
    outcome = call("contact", "--table", tmp_path / "in.csv", "--out", tmp_path / "out.csv")
    assert outcome.code == 2
    assert "line 5, column G_mm" in outcome.err
    assert "nothing was written" in outcome.err
    assert not (tmp_path / "out.csv").exists()


def test_a_frequency_ratio_out_of_range(call, tmp_path):
    outcome = call("contact", "--table", REFERENCE, "--out", tmp_path / "out.csv", "--gamma", "1")
    assert outcome.code == 2
    assert "--gamma: 1 is not allowed; it must be above 1 and at most 100" in outcome.err

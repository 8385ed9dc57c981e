"""``asperity.export_joint`` from a script."""

import pytest

import asperity
from asperity.errors import InputError


@pytest.mark.slow
def test_file_and_sentences(joint, tmp_path):
    made = asperity.export_joint(joint, to="table", out=tmp_path / "joint.csv", torque="4 N*m")
    assert made.path.read_text().count("\n") > 80
    assert "Drift per output turn at 4 N*m" in repr(made)
    assert "Stiffness at 4 N*m" in made._repr_html_()


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"to": "adams"}, "there is no export to 'adams'"),
        ({"to": "table", "out": "a.txt"}, "must end in"),
        ({"to": "table", "torque": 5.0}, "torque"),
        ({"to": "table", "level": "best"}, "level of the stiffness"),
    ],
)
def test_refusals(joint, tmp_path, monkeypatch, options, said):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=said):
        asperity.export_joint(joint, **({"out": "a.csv"} | options))


def test_only_joints(tmp_path):
    with pytest.raises(InputError, match="expected a joint"):
        asperity.export_joint("joint.toml", to="table", out=tmp_path / "a.csv")

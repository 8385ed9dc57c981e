"""Targets by name, endings of files, refusals; whatever the name of the joint file, other programs read the file."""

import dataclasses
import io
import re
import zipfile
from xml.etree import ElementTree

import numpy as np
import pytest
from scipy.io import loadmat

from asperity.errors import InputError
from asperity.export.targets import (
    SUFFIXES,
    Exported,
    check_target,
    csv_file,
    exported,
    mat_file,
    table_columns,
    write_exported,
)


@pytest.mark.parametrize(
    ("to", "name", "said"),
    [
        ("adams", "a.csv", "there is no export to 'adams'; known are table, mujoco, fmu, modelica"),
        ("table", "a.txt", "the name of a file for 'table' must end in .csv or .mat"),
        ("table", "nowhere/a.csv", "there is no folder"),
        ("table", "joint.csv", "this is the file that is read"),
    ],
)
def test_refusals(tmp_path, monkeypatch, to, name, said):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "joint.csv").write_text("")
    with pytest.raises(InputError, match=said):
        check_target(to, name, "joint.csv")


def test_every_target_writes_every_ending(content, tmp_path):
    for to, suffixes in SUFFIXES.items():
        for suffix in suffixes:
            file = tmp_path / f"{to}{suffix.upper()}"
            check_target(to, file)
            made = exported(content, to=to, suffix=file.suffix)
            for _ in range(2):  # the second one replaces the first
                write_exported(made, file)
            assert file.read_bytes() == made.data == exported(content, to=to, suffix=suffix).data


def test_what_cannot_be_written(tmp_path):
    with pytest.raises(InputError, match="there is no folder"):
        write_exported(Exported(b""), tmp_path / "nowhere" / "a.csv")


def loop(closed_form, torque, skewness, sign):
    """Masing's rule by hand: the branch that comes from plus (1) or minus (-1) the largest torque."""
    turned = sign * (
        closed_form.slip_angle(closed_form.LARGEST)
        - 2.0 * closed_form.slip_angle(0.5 * (closed_form.LARGEST - sign * torque))
    )
    return closed_form.reversible_angle(torque, skewness) + turned


@pytest.mark.parametrize("skewness", [0.0, 0.01])
def test_columns_are_the_closed_forms(made_content, closed_form, skewness):
    found = table_columns(made_content(skewness=skewness))
    torque = found["torque_Nm"]
    assert (torque[0], torque[-1]) == (-closed_form.LARGEST, closed_form.LARGEST)
    expected = {
        "loading_rad": closed_form.reversible_angle(torque, skewness) + closed_form.slip_angle(torque),
        "unloading_rad": loop(closed_form, torque, skewness, 1.0),
        "reloading_rad": loop(closed_form, torque, skewness, -1.0),
        "slip_rad": closed_form.slip_angle(torque),
    }
    for name, angle in expected.items():
        np.testing.assert_allclose(found[name], angle, rtol=0.0, atol=1e-12 * 1.7e-4, err_msg=name)


def test_csv_has_units_in_its_head_and_reads_back(content, read_table):
    data = csv_file(content)
    assert all(
        name.rsplit("_", 1)[-1] in ("Nm", "rad", "turn", "ratio", "efficiency") for name in read_table(data)
    )
    for name, values in read_table(data).items():
        np.testing.assert_array_equal(values, table_columns(content)[name])
    comments = [line for line in data.decode().splitlines() if line.startswith("#")]
    assert any("Stiffness at 5 N*m" in line for line in comments)
    assert any("Drift per output turn at 5 N*m" in line for line in comments)


def test_mat_file_reads_back_and_has_no_date(content):
    data = mat_file(content)
    found = loadmat(io.BytesIO(data))
    for name, values in table_columns(content).items():
        np.testing.assert_array_equal(found[name][:, 0], values)
    assert "Stiffness at 5 N*m" in "\n".join(cell[0] for cell in found["about"][:, 0])
    assert data == mat_file(content)
    assert data[:19] == b"MATLAB 5.0 MAT-file"


#: What a file may be called: not UTF-8, with control characters, with what formats give a meaning, or without letters.
NAMES = [
    "we\x07lle\udcfc.toml",
    "a\n  9,9,9\u202e\ufffe]]>--y*\"q'%c$z{b}<&$E\\.toml",
    "größe–\u2028.toml",
    "\x1b.toml",
]


@pytest.mark.parametrize("name", NAMES)
def test_whatever_its_name_the_file_is_read(content, read_table, name):
    named = dataclasses.replace(content, source=name)
    plain = table_columns(content)
    assert read_table(csv_file(named)).keys() == plain.keys()
    table = loadmat(io.BytesIO(mat_file(named)))
    np.testing.assert_array_equal(table["torque_Nm"].ravel(), plain["torque_Nm"])
    assert mat_file(named)[:116].decode("ascii").isprintable()

    model = ElementTree.fromstring(exported(named, to="mujoco", suffix=".xml").data)
    with zipfile.ZipFile(io.BytesIO(exported(named, to="fmu", suffix=".fmu").data)) as fmu:
        description = ElementTree.fromstring(fmu.read("modelDescription.xml"))
        header = fmu.read("sources/joint_data.h").decode("ascii")
    assert model.get("model") == description.get("modelName") == named.name
    assert named.name.isprintable()
    identifier = description.find("CoSimulation").get("modelIdentifier")
    assert re.fullmatch(r"[A-Za-z]\w*", identifier, flags=re.ASCII)
    comment, _, rest = header.partition("*/")
    assert comment.startswith("/*")
    assert rest.startswith("\n#define GUID")

    lines = exported(named, to="modelica", suffix=".mo").data.decode("ascii").splitlines()
    (package,) = (line for line in lines if line.startswith("package "))
    assert all(line.startswith("//") for line in lines[: lines.index(package)])
    assert lines[-1] == f"end {package.split()[1]};"

"""``asperity calibrate`` from the command line."""

import dataclasses
import json
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity
from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.study.calibration.curve_model import CurveModel
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns

ARCMIN = np.pi / 10800.0
DRIFT = Path(__file__).parents[2] / "examples" / "calibrate_drift.csv"


@pytest.fixture
def folder(tmp_path):
    joint = tmp_path / "joint.toml"
    joint.write_text(files("asperity.joint_file").joinpath("zou2025.toml").read_text())
    torque = np.concatenate(
        [np.linspace(0.0, 8.0, 9), np.linspace(7.0, -8.0, 16), np.linspace(-7.0, 8.0, 16)]
    )
    data = Measurement(torque, np.zeros(torque.size), None, None, np.zeros(torque.size), "")
    case = read_case(joint)
    unknowns = read_unknowns(["load.preload"], case=case, measurements=(data,))
    model = CurveModel(case=case, measurement=data, unknowns=unknowns, level="assembly", history="virgin")
    angle = model(np.array([unknowns[0].to_unit(1250.0)]))[0]
    angle += 1e-7 * np.random.default_rng(0).standard_normal(angle.size)
    rows = "".join(f"{t},{1e3 * a}\n" for t, a in zip(torque, angle, strict=True))
    (tmp_path / "data.csv").write_text("torque [N*m],angle [mrad]\n" + rows)
    return tmp_path


def invoke(*arguments):
    return CliRunner().invoke(asperity, ["calibrate", *map(str, arguments)])


@pytest.mark.slow
def test_preload_is_recovered_and_written(folder):
    out, plot = folder / "out.toml", folder / "fit.png"
    result = invoke(folder / "joint.toml", folder / "data.csv", "-u", "load.preload", "--starts", 1,
                    "--json", "--out", out, "--plot", plot)  # fmt: skip
    assert result.exit_code == 0, result.output
    (found,) = json.loads(result.stdout)["estimates"]
    assert found["lower"] < 1250.0 < found["upper"]
    assert found["value"] == pytest.approx(1250.0, rel=0.01)
    assert read_case(out).load.preload.value == pytest.approx(found["value"], rel=1e-15)
    assert plot.stat().st_size > 10_000
    table = invoke(folder / "joint.toml", folder / "data.csv", "-u", "load.preload", "--starts", 1)
    # symmetric in the logarithm: what the table says of the one unknown is its interval in the document
    share = 100.0 * (found["scatter_upper"] / found["value"] - 1.0)
    assert found["upper"] > found["scatter_upper"]
    assert "an error of the model: 5 % of the joint's compliance" in " ".join(table.stdout.split())
    assert f": identifiable, load.preload to ±{share:.2g} % (95 %)" in " ".join(table.stdout.split())


@pytest.mark.long
def test_a_drift_curve(folder):
    """Written with 900 N and 0.14; the table, the document, the picture and the joint file say the same."""
    names = ("load.preload", "load.friction_coefficient", "offset")
    wanted = [word for name in names for word in ("-u", name)]
    out, plot = folder / "out.toml", folder / "fit.png"
    result = invoke(
        folder / "joint.toml", DRIFT, *wanted, "--starts", 1, "--json", "--out", out, "--plot", plot
    )
    assert result.exit_code == 0, result.output
    document = json.loads(result.stdout)
    for found, true in zip(document["estimates"], (900.0, 0.14, 0.5 * ARCMIN), strict=True):
        assert found["lower"] < true < found["upper"]
    (curve,) = document["curves"]
    residual = curve["residual_standard_deviation"]
    assert residual["unit"] == "rad"
    assert residual["value"] == pytest.approx(0.2 * ARCMIN, rel=0.3)
    assert "calibrate_drift.csv, drift." in out.read_text()
    assert plot.stat().st_size > 10_000
    table = invoke(folder / "joint.toml", DRIFT, *wanted, "--starts", 1)
    assert "arcsec (standard deviation)" in table.stdout


@pytest.mark.long
def test_columns_for_the_same_drift_give_the_same_preload(folder):
    torque, drift = np.loadtxt(DRIFT, delimiter=",", skiprows=2).T
    lost = drift * ARCMIN / (2.0 * np.pi)
    found = []
    for header, values in (
        ("drift [arcmin/turn]", drift),
        ("speed loss [%]", 100.0 * lost / (1.0 + lost)),
        ("speed ratio", -9.0 * (1.0 + lost)),
    ):
        rows = "".join(f"{t},{v!r}\n" for t, v in zip(torque.tolist(), values.tolist(), strict=True))
        (folder / "other.csv").write_text(f"torque [N*m],{header}\n{rows}")
        result = invoke(
            folder / "joint.toml", folder / "other.csv", "-u", "load.preload", "--starts", 1, "--json"
        )
        found.append(json.loads(result.stdout)["estimates"][0]["value"])
    assert found[1:] == pytest.approx([found[0]] * 2, rel=1e-7)


def test_bad_input(tmp_path, zou_file):
    data = tmp_path / "data.csv"
    data.write_text("torque [N*m],angle [mrad]\n1,0.1\n2,0.2\n3,0.3\n")
    for arguments in (
        (tmp_path / "none.toml", data, "-u", "load.preload"),
        (zou_file, tmp_path / "none.csv", "-u", "load.preload"),
        (zou_file, data, "-u", "drift"),
        (zou_file, data, "-u", "load.preload", "--plot-posterior", "x.png"),
    ):
        assert isinstance(invoke(*arguments).exception, InputError)


def test_a_drive_of_another_type_is_compared_with_its_own_ratio(tmp_path):
    data = tmp_path / "ratio.csv"
    data.write_text("torque [N*m],speed ratio\n1,0.1\n2,0.101\n")
    refused = invoke(DRIFT.with_name("planetary.toml"), data, "-u", "load.interference").exception
    assert "far from 6, that of the joint file without creep" in str(refused)


@pytest.mark.long
def test_a_drive_of_another_type_and_its_new_joint_file(tmp_path):
    """The drift of the example itself, by its solution at three torques: the friction is found again."""
    file, data, out = DRIFT.with_name("planetary.toml"), tmp_path / "drift.csv", tmp_path / "out.toml"
    joint = joint_from_case(read_case(file))
    rows = []
    for torque in (2.0, 8.0, 11.0):
        result = solve_joint(dataclasses.replace(joint, output_torque=torque)).result
        rows.append((torque, float(result.rolling.drift_per_output_turn) / ARCMIN))
    data.write_text("torque [N*m],drift [arcmin/turn]\n" + "".join(f"{t!r},{d!r}\n" for t, d in rows))
    result = invoke(
        file, data, "-u", "load.friction_coefficient=0.05:0.2", "--starts", 1, "--json", "--out", out
    )
    assert result.exit_code == 0, result.output
    (found,) = json.loads(result.stdout)["estimates"]
    assert found["value"] == pytest.approx(0.08, rel=1e-6)
    assert read_case(out).load.friction_coefficient.value == pytest.approx(found["value"], rel=1e-15)


@pytest.mark.parametrize(
    ("stated", "says"),
    [
        ("-5 %", "the error of the model must be from 0 to 1, got -0.05 (option --model-error)"),
        ("5 mm", "--model-error: expected a dimensionless number (e.g. '0.12'), got a length 'mm' in '5 mm'"),
    ],
)
def test_a_wrong_error_of_the_model_is_named_by_its_option(call, tmp_path, joint_file, stated, says):
    data = tmp_path / "data.csv"
    data.write_text("torque [N*m],angle [mrad]\n0,0\n1,1\n2,2\n")
    told = call("calibrate", joint_file(), data, "-u", "load.preload", "--model-error", stated)
    assert (told.code, told.out) == (2, "")
    assert says in told.err


def test_an_option_with_another_dash_has_a_near_name(call, joint_file):
    told = call("calibrate", joint_file(), "data.csv", "-u", "load.preload", "--model_error", "5 %")
    assert told.code == 2
    assert "--model-error" in told.err.splitlines()[-1]

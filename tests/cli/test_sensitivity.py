"""``asperity sensitivity``: elasticities that follow from scaling, and the order of the table."""

import json
import math
from pathlib import Path

import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity
from asperity.cli.sensitivity import _show
from asperity.errors import InputError

FILE = str(Path(__file__).parents[2] / "examples" / "zou2025.toml")


@pytest.fixture(autouse=True)
def _no_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    monkeypatch.chdir(tmp_path)


def run(*arguments):
    return CliRunner().invoke(asperity, list(arguments), catch_exceptions=False)


@pytest.mark.slow
def test_sensitivity_document_and_table(tmp_path, monkeypatch):
    from asperity.joint_file.reader import read_case
    from asperity.study.tolerances import sensitivity as module

    whole = module.sensitivity(read_case(FILE))

    def asked_for(case, results):  # compiled once for all commands
        rows = [row for row in whole["result"].values.tolist() if row.startswith(tuple(results))]
        return whole.sel(result=rows)

    monkeypatch.setattr(module, "sensitivity", asked_for)
    document = json.loads(run("sensitivity", FILE, "--json", "--plot").stdout)
    elasticity = document["results"]["standing_torque_capacity"]["elasticity"]
    assert elasticity["drive.planets"] == pytest.approx(1.0, abs=1e-9)
    assert document["inputs"]["drive.sun_radius"] == {"value": 0.004, "unit": "m", "finished_part": False}
    assert (tmp_path / "sensitivity.png").stat().st_size > 10_000
    assert "slip_ratio_sp" in document["results"]
    pictured = run(
        "sensitivity", FILE, "--result", "standing_torque_capacity", "--plot", str(tmp_path / "t.png")
    )
    assert (tmp_path / "t.png").stat().st_size > 10_000
    assert "drive.ring_radius" in pictured.output
    table = run("sensitivity", FILE, "--result", "standing_torque_capacity").output.splitlines()
    ranks = [line.split()[0] for line in table if line.startswith((" drive.", " load.", "drive.", "load."))]
    assert ranks[0] == "drive.ring_radius"
    assert set(ranks[1:4]) == {"load.friction_coefficient", "load.preload", "drive.planets"}
    with pytest.raises(InputError, match="there is no result 'weight'; the page 'Results'"):
        run("sensitivity", FILE, "--result", "weight")


def test_the_table_has_the_units_of_the_result_and_of_the_file(capsys):
    """An angle of 10 arcmin that falls by 2 arcmin a millimetre; in SI the slope would be some 0.58 rad/m."""
    xarray = pytest.importorskip("xarray")
    arcminute = math.pi / 10800.0
    ranked = xarray.Dataset(
        {
            "value": ("input", [0.02, 7800.0, 0.02]),
            "elasticity": ("input", [-4.0, 0.0, 30.0]),
            "derivative": ("input", [-2.0 * arcminute / 1e-3, 0.0, 15.0 * arcminute / 1e-3]),
            "result_value": 10.0 * arcminute,
            "result_name": "drift of the output",
        },
        coords={
            "input": [
                "drive.planet_radius",
                "materials.steel.density",
                "drive.planet_radius (finished part)",
            ],
            "result": "drift",
        },
    )
    _show(ranked)
    text = capsys.readouterr().out
    assert "drift of the output: 10 arcmin" in text
    assert "derivative [arcmin]" in text
    rows, _, others = text.rstrip().partition("no effect: ")
    (planet,) = (line for line in rows.splitlines() if "drive.planet_radius  " in line)
    assert planet.rstrip().endswith("-2 per mm")
    (part,) = (line for line in rows.splitlines() if "drive.planet_radius (finished part)" in line)
    assert part.rstrip().endswith("15 per mm")
    assert "Those of finished parts deviate while all other parts stay as they are" in " ".join(rows.split())
    assert others == "materials.steel.density"

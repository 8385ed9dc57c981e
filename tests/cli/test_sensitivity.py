"""``asperity sensitivity``: elasticities that follow from scaling, and the order of the table."""

import json
from pathlib import Path

import pytest
from commands import run

from asperity.errors import InputError

FILE = str(Path(__file__).parents[2] / "examples" / "zou2025.toml")


pytestmark = pytest.mark.usefixtures("own_folder")


@pytest.mark.slow
def test_sensitivity_document_and_table(tmp_path, monkeypatch):
    from asperity.joint_file.reader import read_case
    from asperity.study.tolerances.sensitivity import sensitivity

    whole = sensitivity(read_case(FILE))

    def asked_for(case, results):  # compiled once for all commands
        rows = [row for row in whole["result"].values.tolist() if row.startswith(tuple(results))]
        return whole.sel(result=rows)

    monkeypatch.setattr("asperity.study.tolerances.sensitivity.sensitivity", asked_for)
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

"""The commands for studies: what they print and write, and how they refuse."""

import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from asperity.cli import asperity
from asperity.errors import InputError

FILE = str(Path(__file__).parents[2] / "examples" / "zou2025.toml")
TORQUE = ["--over", "load.output_torque=0 N*m:20 N*m:3"]


@pytest.fixture(autouse=True)
def _no_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    monkeypatch.chdir(tmp_path)


def run(*arguments):
    return CliRunner().invoke(asperity, list(arguments), catch_exceptions=False)


def test_small_sweep_is_printed_drawn_and_written(tmp_path):
    done = run("sweep", FILE, *TORQUE, "--results", "published", "--out", "s.csv", "--plot")
    assert done.exit_code == 0
    assert "3 points, 2 solved" in done.output
    assert "beyond the torque capacity" in done.output
    rows = (tmp_path / "s.csv").read_text().splitlines()
    assert rows[0].startswith(
        "load.output_torque [N*m],status,status_meaning,published_stiffness_output [N*m/rad]"
    )
    assert [row.split(",")[0] for row in rows[1:]] == ["0.0", "10.0", "20.0"]
    # 5.04e6 N*m/rad without torque: the guide value for the published model at this joint
    assert float(rows[1].split(",")[3]) == pytest.approx(5.04e6, rel=2e-3)
    assert (tmp_path / "sweep.png").stat().st_size > 10_000
    with pytest.raises(InputError, match="exists already"):
        run("sweep", FILE, *TORQUE, "--out", "s.csv")
    shown = run("sweep", FILE, *TORQUE, "--results", "published")
    assert "beyond torque" in shown.output
    assert "published" in shown.output


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--over", "load.torque=0 N*m:1 N*m:2"], "did you mean"),
        ([*TORQUE, "--out", "s.xlsx"], "ending must be"),
        ([*TORQUE, "--workers", "2"], r"need an --out of type \.zarr"),
        ([*TORQUE, "--plot", "s.bmp"], r"\.png, \.svg or \.pdf"),
        ([*TORQUE, "--results", "everything"], "no result 'everything'"),
        ([*TORQUE, "--plot", "--plot-result", "nope"], "no result 'nope'"),
        (
            [*TORQUE, "--plot", "--results", "published", "--plot-result", "slip_ratio"],
            "'slip_ratio' is not among",
        ),
        ([*TORQUE, "--plot-result", "slip_ratio"], "--plot-result needs --plot"),
    ],
)
def test_refusals_come_first(arguments, told, monkeypatch):
    monkeypatch.setattr(
        "asperity.study.sweep.sweep.block_results", lambda *_, **__: pytest.fail("computed before checking")
    )
    with pytest.raises(InputError, match=told):
        run("sweep", FILE, *arguments)


def test_help_shows_its_examples_line_by_line():
    shown = run("sweep", "--help").output
    assert "\\b" not in shown
    assert '\n  asperity sweep joint.toml --over "load.output_torque=0 N*m:5 N*m:11" --plot\n' in shown


def test_uncertainty_needs_tolerances_and_distributions(tmp_path):
    with pytest.raises(InputError, match="no tolerances"):
        run("uncertainty", FILE)
    text = Path(FILE).read_text().replace('"13.5 mm"', '"13.5 mm +- 5 um"')
    (tmp_path / "t.toml").write_text(text)
    with pytest.raises(InputError, match="not its distribution"):
        run("uncertainty", "t.toml")
    with pytest.raises(InputError, match="distributed as"):
        run("uncertainty", "t.toml", "--distribution", "gauss")
    arguments = [
        "--distribution",
        "uniform",
        "--samples",
        "500",
        "--results",
        "planet_mass",
        "--json",
        "--plot",
        "u.svg",
    ]
    done = run("uncertainty", "t.toml", *arguments)
    document = json.loads(done.stdout)
    mass = document["results"]["planet_mass"]
    # m = pi rho R^2 B of a solid steel roller
    assert mass["nominal"] == pytest.approx(np.pi * 7850.0 * 0.0135**2 * 0.005, rel=1e-12)
    # a uniform radius of half-width 5 um: relative standard deviation of m is 2 * 5 um / (sqrt(3) * 13.5 mm)
    assert mass["standard_deviation"] / mass["mean"] == pytest.approx(
        2.0 * 5e-6 / (3**0.5 * 13.5e-3), rel=0.1
    )
    assert document["inputs"]["drive.planet_radius"]["distribution"] == "uniform"
    assert (tmp_path / "u.svg").stat().st_size > 5_000


@pytest.mark.slow
def test_sensitivity_document_and_table(tmp_path, monkeypatch):
    from asperity.joint_file.reader import read_case
    from asperity.study.tolerances import sensitivity as module

    found = module.sensitivity(read_case(FILE))
    monkeypatch.setattr(
        module, "sensitivity", lambda case, results: found
    )  # compiled once for three commands
    document = json.loads(run("sensitivity", FILE, "--json", "--plot").stdout)
    elasticity = document["results"]["torque_capacity"]["elasticity"]
    assert elasticity["drive.planets"] == pytest.approx(1.0, abs=1e-9)
    assert document["inputs"]["drive.sun_radius"] == {"value": 0.004, "unit": "m"}
    assert (tmp_path / "sensitivity.png").stat().st_size > 10_000
    table = run("sensitivity", FILE, "--result", "torque_capacity").output.splitlines()
    ranks = [line.split()[0] for line in table if line.startswith((" drive.", " load.", "drive.", "load."))]
    assert ranks[0] == "drive.ring_radius"
    assert set(ranks[1:4]) == {"load.friction_coefficient", "load.preload", "drive.planets"}
    with pytest.raises(InputError, match="there is no result 'weight'; the page 'Results'"):
        run("sensitivity", FILE, "--result", "weight")

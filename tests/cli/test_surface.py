"""The command as a user types it."""

import json

import pytest
from click.testing import CliRunner

from asperity.cli.surface import surface
from asperity.errors import InputError
from asperity.surface.measurement import read_measurement


def run(*arguments):
    return CliRunner().invoke(surface, [str(a) for a in arguments], catch_exceptions=True)


def test_from_synthetic_files_to_one_equivalent_surface(tmp_path):
    documents = []
    for seed in (1, 2):
        file, document, figure = (tmp_path / f"{seed}{end}" for end in (".csv", ".json", ".png"))
        made = run(
            "synthesize", file, "--kind", "self_affine", "-D", 1.5, "-G", "1e-9 m", "--points", 3000,
            "--spacing", "0.1 um", "--seed", seed,
        )  # fmt: skip
        assert made.exit_code == 0, made.output
        got = run("measure", file, "--json", *(["--plot", figure] if seed == 1 else []))
        assert got.exit_code == 0, got.output
        document.write_text(got.stdout)
        measured = read_measurement(path=document)
        low, high = measured.interval(confidence=0.999)["fractal_dimension"]
        assert low < 1.5 < high
        documents.append(document)
    assert (tmp_path / "1.png").stat().st_size > 20_000
    both = run("combine", *documents, "--json")
    assert both.exit_code == 0, both.output
    assert json.loads(both.stdout)["fractal_dimension"] == pytest.approx(1.5, abs=0.06)
    assert "fractal roughness G" in run("combine", *documents).output


def test_text_output_names_units_and_directions(tmp_path):
    file = tmp_path / "map.npy"
    run(
        "synthesize", file, "--kind", "map", "-D", 1.4, "-G", "1e-9 m", "--points", 256, "--spacing", "1 um",
        "--seed", 1,
    )  # fmt: skip
    got = run("measure", file, "--height-unit", "m", "--spacing", "1 um")
    assert got.exit_code == 0, got.output
    for words in (
        "Sq",
        "um",
        "along x (the result)",
        "along y",
        "amplitude along x over along y: ",
        "gamma 1.5",
    ):
        assert words in got.output


def test_bearing_profiles_are_refused_with_the_reason(shared_data):
    file = shared_data / "bearing_roller_profiles" / "81212-RE-1.txt"
    got = run("measure", file, "--position-unit", "mm", "--height-unit", "um", "--json")
    assert got.exit_code == 3
    document = json.loads(got.stdout)
    assert "no power law" in document["refused"]
    assert "quantised in steps of 0.07" in document["refused"]
    assert "fractal_dimension" not in document


def test_a_measured_power_law_is_not_refused(shared_data):
    pytest.importorskip("SurfaceTopography")
    got = run(
        "measure", shared_data / "surfacetopography_examples" / "x3p-2.x3p", "--direction", "y", "--json"
    )
    assert got.exit_code == 0, got.output
    assert 1.6 < json.loads(got.stdout)["fractal_dimension"] < 1.85  # by eye: P falls 2.2 decades in 1.47


def test_wrong_input(tmp_path):
    assert isinstance(run("measure", tmp_path / "none.txt").exception, InputError)
    bad = run(
        "synthesize", tmp_path / "x.npy", "--kind", "weierstrass", "-D", 3, "-G", "1 nm", "--points", 100,
        "--spacing", "1 um", "--seed", 1,
    )  # fmt: skip
    assert isinstance(bad.exception, InputError)

"""The command as a user types it."""

import json
import math
import re

import matplotlib.image
import numpy as np
import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity
from asperity.errors import InputError
from asperity.surface.measurement import measurement_from_document, read_measurement


def run(*arguments):
    return CliRunner().invoke(asperity, ["surface", *map(str, arguments)], catch_exceptions=True)


def test_wrong_lengths_name_their_option(tmp_path):
    np.save(tmp_path / "map.npy", np.random.default_rng(0).standard_normal((20, 20)))
    scale = ("measure", tmp_path / "map.npy", "--height-unit", "nm", "--spacing", "1 um")
    for option, text, said in (
        ("--short-cut-off", "three", "^--short-cut-off: expected a length"),
        ("--hardness", "7 mm", "^--hardness: expected a hardness"),
        (
            "--cut-off",
            "1 mm",
            "^the cut-off is 1 mm; it must lie between .*0.002 mm. and the length .*0.02 mm.$",
        ),
    ):
        refused = run(*scale, option, text).exception
        assert re.search(said, str(refused))
        assert option in str(refused) or option[2:] in refused.options


def test_a_surface_without_a_power_law_has_its_spectrum(tmp_path):
    """A sine of 0.2 µm amplitude and 20 µm length."""
    x = np.arange(4000) * 0.5e-6
    file = tmp_path / "sine.csv"
    np.savetxt(
        file,
        np.column_stack([x, 0.2e-6 * np.sin(2.0 * np.pi * x / 20e-6)]),
        delimiter=",",
        header="x [m],z [m]",
    )
    common = ("measure", file, "--position-unit", "m", "--height-unit", "m")
    got = run(*common)
    assert got.exit_code == 0
    assert "; the joint uses the measured spectrum" in got.output
    assert "a joint needs the lay of a profile: --lay rolling, axis or isotropic" in got.output
    felt = re.search(r"rms height of the waves shorter than: 0.08 mm ([\d.]+) um", got.output).group(1)
    assert float(felt) == pytest.approx(0.2 / math.sqrt(2.0), rel=5e-3)
    (spectrum,) = json.loads(run(*common, "--lay", "axis", "--json").stdout)["spectra"]
    assert spectrum["lay"] == "axis"
    assert sum(map(sum, spectrum["mean_square_height_m2"])) == pytest.approx(0.02e-12, rel=5e-3)


def test_too_few_points_for_anything_are_refused(tmp_path):
    file = tmp_path / "few.csv"
    x = np.arange(12)
    np.savetxt(file, np.column_stack([1e-6 * x, x % 3 * 1e-7]), delimiter=",", header="x [m],z [m]")
    got = run("measure", file)
    assert got.exit_code == 3
    assert "64 or more are needed" in got.output


def test_a_map_shows_its_lay(tmp_path):
    file = tmp_path / "map.npy"
    np.save(file, np.random.default_rng(0).standard_normal((70, 70)) * 1e-7)
    got = run("measure", file, "--height-unit", "m", "--spacing", "1 um", "--lay", "axis")
    assert "a map shows its lay" in str(got.exception)


@pytest.mark.slow
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
    pixels = matplotlib.image.imread(tmp_path / "1.png")
    red = (pixels[..., 0] > 0.7) & (pixels[..., 1] < 0.4)  # the fitted law
    blue = (pixels[..., 2] > 0.6) & (pixels[..., 0] < 0.3)  # the profile
    grey = np.abs(pixels[..., :3] - 0.35).max(axis=-1) < 0.05  # the measured points
    half = pixels.shape[0] // 2
    assert red[half:].sum() > 1000
    assert blue[:half].sum() > 1000
    assert grey[half:].sum() > 1000
    both = run("combine", *documents, "--json")
    assert both.exit_code == 0, both.output
    equivalent = measurement_from_document(document=json.loads(both.stdout))
    low, high = equivalent.interval(confidence=0.999)["fractal_dimension"]
    assert low < 1.5 < high
    assert [each["source"] for each in json.loads(both.stdout)["spectra"]] == ["1.csv", "2.csv"]
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
        "S-F surface (no S-filter, no L-filter): Sa",
        "Sq",
        "Sdr",
        "um",
        "along x (the result)",
        "along y",
        "amplitude along x over along y: ",
        "gamma 1.5",
    ):
        assert words in got.output
    cut = run("measure", file, "--height-unit", "m", "--spacing", "1 um", "--cut-off", "80 um").output
    assert "S-L surface (no S-filter, L-filter 80 um): Sa" in cut


def test_bearing_profiles_have_no_d_and_g_and_the_reason(shared_data):
    file = shared_data / "bearing_roller_profiles" / "81212-RE-1.txt"
    got = run("measure", file, "--position-unit", "mm", "--height-unit", "um", "--json")
    assert got.exit_code == 0
    document = json.loads(got.stdout)
    assert "no power law" in document["no_power_law"]
    assert "quantised in steps of 0.07" in document["no_power_law"]
    assert "fractal_dimension" not in document


@pytest.mark.slow
def test_a_ring_has_its_roughness_behind_a_filter_and_its_form_without(shared_data):
    """A ring of Rq 0.14 um whose form was printed as Ra 25.6 um. NU208 less its chamfers is a crown of 1.7 m."""
    units = ("--position-unit", "mm", "--height-unit", "um")
    folder = shared_data / "bearing_roller_profiles"
    got = run("measure", folder / "NU206-IR-1.txt", *units, "--lay", "rolling").output
    assert "without a filter: Pa 25.5889 um" in got
    assert (
        "behind the cut-off 0.8 mm (the class of ISO 21920-3 for this Ra; no lambda_s, the points lie" in got
    )
    assert float(re.search(r"\bRa ([\d.]+) um", got).group(1)) == pytest.approx(0.108, rel=0.01)
    assert "no circular crown" in got
    section = ("measure", folder / "NU208-IR-1.txt", *units, "--from", "0.7 mm", "--to", "12.3 mm", "--lay")
    got = run(*section, "rolling", "--cut-off", "2.5 mm").output
    assert "(as chosen; lambda_s 8 um), 3 section(s) instead of five, the profile is too short:" in got
    assert '..._crown_radius = "1.73 m"' in got
    assert "_crown_radius" not in run(*section, "axis").output  # measured round the ring
    refused = run(*section, "rolling", "--cut-off", "8 mm").exception
    assert "the cut-off is 8 mm; it must lie between 10 spacings" in str(refused)


def test_a_measured_power_law_is_not_refused(shared_data):
    pytest.importorskip("SurfaceTopography")
    got = run(
        "measure", shared_data / "surfacetopography_examples" / "x3p-2.x3p", "--direction", "y", "--json"
    )
    assert got.exit_code == 0, got.output
    assert 1.6 < json.loads(got.stdout)["fractal_dimension"] < 1.85  # by eye: P falls 2.2 decades in 1.47


def test_tilt_is_removed_by_default_and_refused_otherwise(tmp_path):
    """A slope of 0.1 over 0.5 mm: Pa of the bare profile would be 12.5 um."""
    from asperity.surface.synthesis import self_affine_profile

    z = self_affine_profile(
        points=5000,
        spacing=1e-7,
        fractal_dimension=1.4,
        fractal_roughness=1e-9,
        random=np.random.default_rng(3),
    )
    x = np.arange(5000) * 1e-7
    file = tmp_path / "tilted.npy"
    np.save(file, z + 0.1 * x)
    common = ("measure", file, "--height-unit", "m", "--spacing", "0.1 um")
    got = run(*common, "--json")
    assert got.exit_code == 0, got.output
    document = json.loads(got.stdout)
    low, high = document["fractal_dimension_interval_95"]
    assert low < 1.4 < high
    levelled = z - np.polyval(np.polyfit(x, z, 1), x)
    assert document["files"][0]["Pa_m"] == pytest.approx(np.mean(np.abs(levelled)), rel=1e-6)
    assert document["files"][0]["notes"] == ["form removed: line"]
    for form in ("mean", "none"):
        refused = run(*common, "--form", form)
        assert isinstance(refused.exception, InputError)
        assert "use the form 'line'" in str(refused.exception)
        assert "form" in refused.exception.options  # the command line names the option


def test_output_states_misfit_and_roll_off(tmp_path):
    file = tmp_path / "p.npy"
    n, points = 65536, 8192
    f = np.fft.rfftfreq(n, 1e-7)[1:]
    P = np.concatenate([[0.0], 0.5e-10 * (f**2 + 25e-6**-2) ** -1.0])
    white = np.fft.rfft(np.random.default_rng(0).standard_normal(n))
    np.save(file, np.fft.irfft(white * np.sqrt(P / 2e-7), n=n)[:points])
    got = run("measure", file, "--height-unit", "m", "--spacing", "0.1 um")
    assert got.exit_code == 0, got.output
    assert "chi-square per degree of freedom" in got.output
    assert "misfit beyond sampling scatter" in got.output
    document = json.loads(run("measure", file, "--height-unit", "m", "--spacing", "0.1 um", "--json").stdout)
    assert document["roll_off_wavelength_m"] == pytest.approx(25e-6, rel=0.4)
    assert 0.3 < document["reduced_chi_square"] < 2.0
    assert f"roll-off at {1e6 * document['roll_off_wavelength_m']:.3g} um" in got.output


@pytest.mark.parametrize("length", ["0 um", "-1 um", "5", "1 kg", "1 NM"])
def test_wrong_lengths_are_one_message(tmp_path, length):
    file = tmp_path / "p.npy"
    np.save(file, np.random.default_rng(0).standard_normal(200).cumsum())
    got = run("measure", file, "--height-unit", "nm", "--spacing", "1 um", "--shortest", length)
    assert isinstance(got.exception, InputError)


def test_size_must_be_plausible_unless_confirmed(tmp_path):
    file = tmp_path / "p.npy"
    np.save(file, np.random.default_rng(0).standard_normal(2000).cumsum())
    common = ("measure", file, "--height-unit", "um", "--spacing", "1 mm")
    refused = run(*common).exception
    assert "allow any size" in str(refused)
    assert "any-size" in refused.options
    assert run(*common, "--any-size").exit_code == 0


def test_wrong_input(tmp_path):
    assert isinstance(run("measure", tmp_path / "none.txt").exception, InputError)
    bad = run(
        "synthesize", tmp_path / "x.npy", "--kind", "weierstrass", "-D", 3, "-G", "1 nm", "--points", 100,
        "--spacing", "1 um", "--seed", 1,
    )  # fmt: skip
    assert isinstance(bad.exception, InputError)


def test_formats_are_listed_with_what_to_do_with_others():
    got = run("formats")
    assert got.exit_code == 0
    assert "NanoFocus NMS" in got.output
    assert re.search(r"TIFF\s+\.tif \.tiff\s+grey images, 8 to 32 bit\s+height unit, spacing", got.output)
    assert "Mahr (.pcd .pra .s2p, MarSurf, Perthometer): export the profile as text" in got.output

"""From text files to the document: a sine whose height parameters are known, and self-affine profiles."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.measure import DirectionalFits
from asperity.surface.measure_files import MeasuredFiles, files_document, measured_files, read_surface
from asperity.surface.measurement import measurement_from_document

DEFAULTS = {
    "position_unit": None, "height_unit": None, "spacing": None, "decimal": "auto", "column": None,
    "no_data": None, "any_size": False,
    "start": None, "stop": None, "form": None, "degree": None, "missing": "refuse", "outlier_threshold": None,
    "short_cutoff": None, "long_cutoff": None, "direction": "x", "estimator": "likelihood", "frequency_ratio": 1.5,
    "shortest_wavelength": None, "longest_wavelength": None, "lay": None,
}  # fmt: skip


def written(path, heights, spacing):
    """A text file in um and nm."""
    rows = [f"{1e6 * spacing * i:.9f};{1e9 * z:.9f}" for i, z in enumerate(heights)]
    path.write_text("x [um];z [nm]\n" + "\n".join(rows) + "\n")
    return path


def test_height_parameters_of_a_section_with_whole_waves_of_a_sine(tmp_path):
    """A sine of amplitude A: Pa = 2 A/pi, Pq = A/sqrt(2), Pku = 3/2, Pt = 2 A, PSm = the wavelength.

    Behind the cut-off 0.4 mm, four wavelengths, 1 - 2^-16 of the amplitude is left.
    """
    amplitude, spacing = 3e-7, 1e-6
    wave = amplitude * np.sin(2 * np.pi * (np.arange(4000) + 0.5) / 100)
    wave[:1000] += 1e-5  # outside the section
    file = written(tmp_path / "sine.csv", wave, spacing)
    options = DEFAULTS | {"start": 1.0e-3, "stop": 3.0e-3, "form": "mean", "long_cutoff": 0.4e-3}
    document = files_document(measured_files([file], **options))
    (entry,) = document["files"]
    assert entry["name"] == "sine.csv"
    assert entry["points"] in (2000, 2001)
    assert entry["size_m"] == pytest.approx([2e-3], rel=1e-3)
    assert entry["Pa_m"] == pytest.approx(2 * amplitude / np.pi, rel=1e-3)
    assert entry["Pq_m"] == pytest.approx(amplitude / np.sqrt(2), rel=1e-3)
    rough = entry["roughness"]
    assert (rough["cut_off_m"], rough["short_cut_off_m"], rough["sections"]) == (0.4e-3, None, 4)
    assert rough["Ra_m"] == pytest.approx(2 * amplitude / np.pi, rel=1e-3)
    assert rough["Rz_m"] == pytest.approx(2 * amplitude, rel=1e-3)
    assert rough["Rku"] == pytest.approx(1.5, rel=1e-3)
    assert not entry["crown"]["is_circular"]
    assert entry["Psk"] == pytest.approx(0.0, abs=1e-3)
    assert entry["Pku"] == pytest.approx(1.5, rel=1e-3)
    assert entry["Pt_m"] == pytest.approx(2 * amplitude, rel=1e-3)
    assert entry["PSm_m"] == pytest.approx(1e-4, rel=0.01)
    assert document["no_power_law"]  # one wave is no power law
    assert "fractal_dimension" not in document
    assert document["source"] == "sine.csv"


def test_the_document_of_two_profiles_is_a_measurement_that_can_be_read_again(tmp_path, profile):
    files = [written(tmp_path / f"{seed}.csv", profile(seed).heights, 1e-7) for seed in (1, 2)]
    measured = measured_files(files, **DEFAULTS)
    document = files_document(measured)
    read = measurement_from_document(document=document)
    assert (
        read.fractal_dimension == measured.fit.fractal_dimension == pytest.approx(1.5, abs=0.08)
    )  # made with
    assert (document["source"], measured.fit.profiles) == ("1.csv + 2.csv", 2)
    assert [each.source for each in measured.topographies] == ["1.csv", "2.csv"]
    for key, attribute in (
        ("noise_density_m3", "noise_density"),
        ("height_step_m", "height_step"),
        ("misfit", "misfit"),
        ("reduced_chi_square", "reduced_chi_square"),
        ("roll_off_wavelength_m", "roll_off_wavelength"),
    ):
        assert document[key] == getattr(measured.fit, attribute), key
    assert (document["direction"], document["anisotropy_ratio"]) == ("x", None)


def test_the_direction_chooses_the_fit_and_a_profile_has_one_only(tmp_path, profile):
    fits = DirectionalFits("along x", "along y")
    assert [MeasuredFiles((), fits, direction, None).fit for direction in "xy"] == ["along x", "along y"]
    file = written(tmp_path / "a.csv", profile(1).heights[:300], 1e-7)
    with pytest.raises(InputError, match="a profile has no direction y"):
        measured_files([file], **(DEFAULTS | {"direction": "y"}))


def test_a_map_has_areal_parameters(tmp_path):
    """A square wave of height 2 A: Sa = Sq = A, Sz = 2 A, Ssk = 0, Sku = 1; steps 2 A both ways in every triangle."""
    amplitude = 5e-9
    np.save(tmp_path / "map.npy", 5.0 * (-1.0) ** np.add.outer(np.arange(30), np.arange(40)))
    options = DEFAULTS | {"height_unit": "nm", "spacing": 1e-6}
    (entry,) = files_document(measured_files([tmp_path / "map.npy"], **options))["files"]
    assert (entry["Sa_m"], entry["Sq_m"], entry["Sz_m"]) == pytest.approx(
        (amplitude, amplitude, 2 * amplitude), rel=1e-3
    )
    assert entry["Ssk"] == pytest.approx(0.0, abs=1e-2)
    assert entry["Sku"] == pytest.approx(1.0, rel=1e-2)
    assert (entry["scale_limited"], entry["cut_off_m"]) == ("S-F surface", None)
    assert entry["Sdr"] == pytest.approx(np.sqrt(1.0 + 2.0 * (2.0 * amplitude / 1e-6) ** 2) - 1.0, rel=1e-3)
    (cut,) = files_document(measured_files([tmp_path / "map.npy"], **(options | {"long_cutoff": 10e-6})))[
        "files"
    ]
    assert (cut["scale_limited"], cut["cut_off_m"]) == ("S-L surface", 10e-6)
    assert (entry["size_m"], entry["points"]) == (pytest.approx([40e-6, 30e-6]), 1200)


def test_a_number_that_does_not_exist_is_none_in_the_document(tmp_path):
    np.save(tmp_path / "flat.npy", np.zeros(200))
    options = DEFAULTS | {"height_unit": "nm", "spacing": 1e-6, "form": "mean"}
    (entry,) = files_document(measured_files([tmp_path / "flat.npy"], **options))["files"]
    assert (entry["Pq_m"], entry["Psk"], entry["Pku"]) == (0.0, None, None)
    assert (entry["roughness"]["Ra_m"], entry["roughness"]["Rsk"]) == (0.0, None)
    assert entry["crown"]["radius_m"] is None


def test_folder_absent_and_huge_files(tmp_path):
    with pytest.raises(InputError, match="folder"):
        read_surface(path=tmp_path)
    with pytest.raises(InputError, match="there is no such file"):
        read_surface(path=tmp_path / "no.txt")
    with (tmp_path / "huge.dat").open("wb") as file:
        file.truncate(5 * 1024**3)
    with pytest.raises(InputError, match="4096 MiB"):
        read_surface(path=tmp_path / "huge.dat")


def profile_text(path, unit_x="mm", unit_z="um", rows=40, step=0.001):
    x = np.arange(rows) * step
    path.write_text(f"X [{unit_x}];Z [{unit_z}]\n" + "".join(f"{a:.6f};{np.sin(a):.6f}\n" for a in x))
    return path


def test_a_unit_that_contradicts_the_heading_is_refused(tmp_path):
    file = profile_text(tmp_path / "p.csv")
    assert read_surface(path=file, height_unit="micron").spacing == pytest.approx(1e-6)
    with pytest.raises(InputError, match=r"unit of its heights is um by the heading .*, not nm"):
        read_surface(path=file, height_unit="nm")


@pytest.mark.parametrize(
    ("unit_x", "unit_z", "step", "says"),
    [
        ("m", "um", 0.1, "its size is 4 m"),
        ("nm", "pm", 0.001, "its size is 4e-11 m"),
        ("um", "mm", 0.1, "heights span"),
    ],
)
def test_implausible_sizes_are_refused_unless_confirmed(tmp_path, unit_x, unit_z, step, says):
    file = profile_text(tmp_path / "p.csv", unit_x, unit_z, step=step)
    with pytest.raises(InputError, match=says):
        read_surface(path=file)
    assert read_surface(path=file, any_size=True).heights.shape == (40,)


@pytest.mark.parametrize("value", [1e300, 1e60])
def test_heights_that_overflow_are_refused_even_if_any_size_is_accepted(tmp_path, value):
    np.save(tmp_path / "a.npy", np.array([0.0, value, 1.0, -value]))
    with pytest.raises(InputError, match=r"cannot be evaluated|infinite heights"):
        read_surface(path=tmp_path / "a.npy", height_unit="m", spacing=1e-6, any_size=True)

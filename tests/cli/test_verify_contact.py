"""The command from text to numbers."""

import json

import numpy as np
import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity
from asperity.errors import InputError

SMALL = ["--dimension", "1.6", "--points", "32", "--seeds", "1", "--loads", "2", "--pixels-per-wave", "8"]


@pytest.fixture(autouse=True)
def _no_cache(monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")


@pytest.mark.slow
def test_table_and_picture(tmp_path, saved_figures):
    picture = tmp_path / "validity.png"
    result = CliRunner().invoke(
        asperity, ["verify-contact", *SMALL, "--plot", str(picture)], catch_exceptions=False
    )
    assert result.exit_code == 0
    assert "D = 1.6: rms height" in result.output
    assert "K_n [N/µm]" in result.output
    (figure,) = saved_figures
    assert picture.is_file()
    assert [panel.get_ylabel() for panel in figure.axes] == [
        "normal stiffness $K_n$ [N/m]",
        "tangential stiffness $K_t$ [N/m]",
        "real contact area $A_r$ [m²]",
        *["ratio to boundary elements [-]"] * 3,
    ]
    assert [text.get_text() for text in figure.axes[0].get_legend().get_texts()] == ["D = 1.6"]
    for panel, ratio in zip(figure.axes[:3], figure.axes[3:], strict=True):
        elements, law, theory = (line.get_ydata() for line in panel.lines)  # dots, line, dotted
        assert np.all(elements > 0.0)
        for drawn, method in zip(ratio.lines, (law, theory), strict=False):
            np.testing.assert_allclose(drawn.get_ydata(), method / elements, rtol=1e-12)


@pytest.mark.slow
def test_json_carries_units_and_all_three_routes():
    result = CliRunner().invoke(asperity, ["verify-contact", *SMALL, "--json"], catch_exceptions=False)
    (document,) = json.loads(result.output)
    assert document["sample"]["side"] == 1e-3
    assert len(document["normal_force_N"]) == 2
    assert document["law_normal_stiffness_N_per_m"][0] > 0.0
    assert document["persson_tangential_stiffness_N_per_m"][0][0] > 0.0
    assert document["real_contact_area_m2"][0][1] > document["real_contact_area_m2"][0][0]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "named"),
    [
        (["--roughness", "3 N"], "--roughness"),
        (["--from", "0.5", "--to", "0.1"], "0 < from <= to < 1"),
        (["--dimension", "2.5"], "between 1 and 2"),
    ],
)
def test_bad_input_is_named(change, named):
    with pytest.raises(InputError, match=named):
        CliRunner().invoke(asperity, ["verify-contact", *SMALL, *change], catch_exceptions=False)


def test_a_picture_that_cannot_be_drawn_is_refused_before_anything_is_computed(monkeypatch):
    def compute(*_, **__):
        raise AssertionError("it was computed")

    monkeypatch.setattr("asperity.cli.runs.verify_contact.compare", compute)
    result = CliRunner().invoke(asperity, ["verify-contact", *SMALL, "--plot", "law.xyz"])
    assert isinstance(result.exception, InputError)
    assert "law.xyz: the name of an image must end in .png, .svg or .pdf" in str(result.exception)


@pytest.fixture
def map_file(tmp_path):
    """A self-affine map of 64 by 64 points, rms height 0.1 um."""
    size = np.hypot(*np.meshgrid(np.fft.fftfreq(64), np.fft.fftfreq(64)))
    waves = np.maximum(size, 0.06) ** -1.8 * np.fft.fft2(np.random.default_rng(2).standard_normal((64, 64)))
    waves[(size > 0.2) | (size == 0.0)] = 0.0
    heights = np.fft.ifft2(waves).real
    np.save(tmp_path / "map.npy", heights * 1e-7 / heights.std())
    return str(tmp_path / "map.npy")


@pytest.mark.slow
def test_laws_on_a_measured_map(map_file, tmp_path, saved_figures):
    asked = ["verify-contact", "--surface", map_file, "--spacing", "1 um", "--height-unit", "m"]
    asked += ["--hardness", "5.6 GPa"]
    picture = tmp_path / "map.png"
    text = CliRunner().invoke(asperity, [*asked, "--plot", str(picture)], catch_exceptions=False).stdout
    assert text.startswith("On this surface, at 30 to ")
    assert "four patches of 32 µm x 32 µm" in text
    (figure,) = saved_figures
    assert [panel.get_ylabel() for panel in figure.axes[:3]] == [
        "y [µm]",
        "normal stiffness [MPa/µm]",
        "law over elastic\nboundary elements [-]",
    ]
    document = json.loads(CliRunner().invoke(asperity, [*asked, "--json"], catch_exceptions=False).stdout)
    assert document["verdict"] in text
    heights, pressure = np.array(document["patch_rms_height_m"]), np.array(document["nominal_pressure_Pa"])
    np.testing.assert_allclose(pressure[:3], [1e7, 3e7, 1e8], rtol=1e-6)
    law = np.array(document["laws"]["exponential"]["normal_stiffness_Pa_per_m"])
    np.testing.assert_allclose(law, pressure / (0.48 * heights[:, None]), rtol=1e-6)
    elements = np.array(document["boundary_elements"]["normal_stiffness_Pa_per_m"], dtype=float)
    ratio = np.array(document["laws"]["exponential"]["over_boundary_elements"], dtype=float)
    np.testing.assert_allclose(ratio, np.exp(np.log(law / elements).mean(axis=0)), rtol=1e-6)
    assert 0.5 < ratio[2] < 1.7  # few spots on 32 µm: 100 MPa; on larger ones 0.94 to 1.03
    made = CliRunner().invoke(
        asperity,
        [
            *["surface", "measure", "--spacing"],
            "1 um",
            "--height-unit",
            "m",
            map_file,
            "--hardness",
            "5.6 GPa",
            "--json",
        ],
        catch_exceptions=False,
    )
    (spectrum,) = json.loads(made.stdout)["spectra"]
    table = np.array(spectrum["boundary_elements"]["decay_ratios"][0], dtype=float)
    np.testing.assert_allclose(pressure / (table * heights[:, None]), elements, rtol=1e-4)


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        (
            ["--surface", "map.npy", "--seeds", "2", "--from", "0.1"],
            "--seeds, --from describe known surfaces",
        ),
        (["--missing", "longest"], "--missing need --surface"),
        (["--surface", "map.npy", "--hardness", "5 m"], "--hardness: "),
    ],
)
def test_options_of_the_other_comparison_are_refused(asked, told):
    with pytest.raises(InputError, match=told):
        CliRunner().invoke(asperity, ["verify-contact", *asked], catch_exceptions=False)

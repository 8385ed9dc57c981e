"""The command from text to numbers."""

import json

import numpy as np
import pytest
from click.testing import CliRunner

from asperity.cli import asperity
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

    monkeypatch.setattr("asperity.verify.comparison.compare", compute)
    result = CliRunner().invoke(asperity, ["verify-contact", *SMALL, "--plot", "law.xyz"])
    assert isinstance(result.exception, InputError)
    assert "law.xyz: the name of an image must end in .png, .svg or .pdf" in str(result.exception)

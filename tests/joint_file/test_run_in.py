"""The bound of a run-in joint: its factors by hand, and the joint against one with that decay length."""

import json
import math
import re

import numpy as np
import pytest

from asperity.contact.running_in import run_in_factor
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solve_with_surface

#: A profile of the rolling direction: edges of bins [1/m] and mean squares [m^2]; contacts feel all of them.
EDGES, SQUARES = (1e3, 6e4, 8e4, 1e5), (0.0, 1.5e-15, 0.5e-15)
#: Of the steel of the file.
HARDNESS, MODULUS = 1.26e9, 206e9 / (2.0 * 0.91)


def measurement(factor, lay):
    """The profile with heights that are so many times as large."""
    spectrum = {
        "source": "roller.csv",
        "is_map": False,
        "lay": lay,
        "rolling_frequency_edges_per_m": list(EDGES),
        "axial_frequency_edges_per_m": [0.0, 0.0],
        "mean_square_height_m2": [[factor**2 * square] for square in SQUARES],
        "independent_ordinates": [[100.0] for _ in SQUARES],
    }
    if lay != "axis":  # bins of other profiles lie along the axis
        names = ("rolling_frequency_edges_per_m", "axial_frequency_edges_per_m")
        spectrum |= dict(zip(names, (spectrum[name] for name in reversed(names)), strict=True))
        for name in ("mean_square_height_m2", "independent_ordinates"):
            spectrum[name] = np.transpose(spectrum[name]).tolist()
    return {
        "schema": "asperity-surface-measurement",
        "schema_version": 1,
        "source": "roller.csv",
        "no_power_law": "no power law",
        "spectra": [spectrum],
    }


def slope_by_hand():
    """Of both bodies alike, by the mean square of the frequencies of each bin."""
    square = 0.0
    for low, high, height in zip(EDGES[:-1], EDGES[1:], SQUARES, strict=True):
        square += 2.0 * height * (2.0 * math.pi) ** 2 * (high**3 - low**3) / (3.0 * (high - low))
    return math.sqrt(square)


@pytest.fixture
def solved(tmp_path, example_text):
    """The paper's joint on such a profile, and its document; the same file with another [surface]."""
    plain = re.sub(r"(?ms)^\[surface.*?(?=^\[(?!surface)|\Z)", "", example_text)

    def of(factor=1.0, lay="axis", surface='measurement = "roller.json"'):
        (tmp_path / "roller.json").write_text(json.dumps(measurement(factor, lay)))
        text = f"{plain}\n[surface]\n{surface}\n"
        case = parse_case(text, source="joint.toml", folder=tmp_path)
        return case if "measurement" not in surface else (case, solve_with_surface(case).document)

    return of


@pytest.mark.slow
def test_a_joint_on_grooves_that_ran_in(solved):
    """Its asperities are as many times as stiff as the table says for its slope: a joint with that decay length."""
    _, document = solved()
    found = document["stiffness_interval"]["run_in"]
    ratio = HARDNESS / (MODULUS * slope_by_hand())
    factor = run_in_factor(hardness_ratio=ratio, strips=True, load_share=1.0)
    assert factor > 1.2
    for one in found["contacts"].values():
        assert one["rms_slope"] == pytest.approx(slope_by_hand(), rel=1e-6)
        assert one["hardness_ratio"] == pytest.approx(ratio, rel=1e-6)
        assert one["factor"] == pytest.approx(factor, rel=1e-6)
        assert one["factor_at_half_load"] > one["factor"]
    height = math.sqrt(2.0 * sum(SQUARES))
    length = 0.48 * height / 1.155 / factor
    alike = solved(surface=f'decay_length = "{length!r} m"\nrolling_share = 1')
    result = solve_joint(joint_from_case(alike)).result
    assert found["assembly_Nm_per_rad"] == pytest.approx(float(result.assembly.stiffness.output), rel=1e-6)
    drift = float(result.rolling.drift_per_output_turn)
    assert found["drift_rad_per_output_turn"] == pytest.approx(drift, rel=1e-6)
    assert found["assembly_Nm_per_rad"] > document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    assert found["uncertainty"] == 0.1
    assert found["words"].startswith("Run in at this load, peaks flattened")
    assert "±10 %" in found["words"]


@pytest.mark.slow
def test_a_profile_without_grooves_is_steeper_than_it_shows_and_has_the_other_table(solved):
    _, document = solved(factor=0.5, lay="isotropic")
    (one, *_) = document["stiffness_interval"]["run_in"]["contacts"].values()
    slope = 0.5 * math.sqrt(2.0) * slope_by_hand()
    assert one["rms_slope"] == pytest.approx(slope, rel=1e-6)
    expected = run_in_factor(hardness_ratio=HARDNESS / (MODULUS * slope), strips=False, load_share=1.0)
    assert one["factor"] == pytest.approx(expected, rel=1e-6)


@pytest.mark.slow
def test_beyond_the_table_nothing_is_said_of_the_joint(solved):
    """Smooth surfaces: all else of the interval stays."""
    _, document = solved(factor=0.05, lay="rolling")
    interval = document["stiffness_interval"]
    found = interval["run_in"]
    assert found["assembly_Nm_per_rad"] is None
    assert found["drift_rad_per_output_turn"] is None
    assert {one["factor"] for one in found["contacts"].values()} == {None}
    assert found["words"].startswith("Run in: not known, sp: H/(E h') = ")
    assert interval["assembly"]["low_Nm_per_rad"] < interval["assembly"]["high_Nm_per_rad"]

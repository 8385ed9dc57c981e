"""A joint with measured surfaces: the interval against linear propagation, two bodies, refusals."""

import dataclasses
import json
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity as command
from asperity.contact.laws.zou_2025 import Zou2025
from asperity.errors import InputError
from asperity.joint import measured_surface as module
from asperity.joint.measured_surface import measured_surface, stiffness_interval
from asperity.joint.surface_interval import over_surfaces
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.drawn_surface import with_measured_surface
from asperity.joint_file.reader import parse_case, read_case
from asperity.surface.measurement import SurfaceMeasurement, measurement_document


def measurement(dimension=1.4, roughness=1e-11, deviation=1e-3, log_deviation=0.03, correlation=-0.9):
    mixed = correlation * deviation * log_deviation
    return SurfaceMeasurement(
        fractal_dimension=jnp.asarray(dimension),
        fractal_roughness=jnp.asarray(roughness),
        frequency_ratio=jnp.asarray(1.5),
        covariance=jnp.array([[deviation**2, mixed], [mixed, log_deviation**2]]),
        shortest_wavelength=jnp.asarray(1e-6),
        longest_wavelength=jnp.asarray(1e-4),
        estimator="made up",
        profiles=10,
        source="a test",
    )


@pytest.fixture(scope="module")
def zou_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("joint") / "joint.toml"
    CliRunner().invoke(command, ["init", str(path), "--type", "wedge"], catch_exceptions=False)
    return path


@pytest.fixture
def write(tmp_path):
    def to(name, content):
        path = tmp_path / name
        path.write_text(json.dumps(measurement_document(measurement=content)))
        return path

    return to


@pytest.mark.parametrize("dimension", [1.04, 1.96])
def test_draws_beyond_the_dimensions_of_profiles_are_counted(monkeypatch, dimension):
    """Two standard deviations from a bound: 2.3 % of 2000 draws, which scatter by 7."""
    asked = []
    monkeypatch.setattr(module, "over_surfaces", lambda joint, surfaces, shape: asked.append(surfaces[0]))
    monkeypatch.setattr(module, "result_ends", lambda result, **_: {"unsolved": 0, "all_plastic": 0})
    joint = SimpleNamespace(surfaces=[Zou2025(1.4, 1e-11, 1.5, "circular_spot")])
    outside = stiffness_interval(joint, measurement(dimension, deviation=0.02))["outside"]
    assert outside == pytest.approx(45.5, abs=21.0)
    drawn = np.asarray(asked[0].fractal_dimension)
    assert drawn.size == 2000 - outside
    assert np.all((drawn > 1.0) & (drawn < 2.0))


@pytest.mark.long
def test_a_narrow_interval_is_the_linear_propagation_of_the_covariance(zou_file):
    measured = measurement()
    joint = joint_from_case(with_measured_surface(read_case(zou_file), measured))
    interval = stiffness_interval(joint, measured)

    steps = np.array([[0.0, 0.0], [1e-5, 0.0], [-1e-5, 0.0], [0.0, 1e-4], [0.0, -1e-4]])
    surface = dataclasses.replace(
        joint.surfaces[0],
        fractal_dimension=1.4 + steps[:, 0],
        fractal_roughness=1e-11 * np.exp(steps[:, 1]),
        frequency_ratio=np.full(5, 1.5),
    )
    at = np.asarray(over_surfaces(joint, (surface,), shape=(5,)).published.output)
    slope = np.array([(at[1] - at[2]) / 2e-5, (at[3] - at[4]) / 2e-4])
    deviation = np.sqrt(slope @ np.asarray(measured.covariance) @ slope)
    found = interval["published"]
    # 2000 draws: the ends of the interval scatter by about 3 % of the standard deviation each
    assert found["low_Nm_per_rad"] == pytest.approx(at[0] - 1.96 * deviation, abs=0.2 * deviation)
    assert found["high_Nm_per_rad"] == pytest.approx(at[0] + 1.96 * deviation, abs=0.2 * deviation)
    assert interval["outside"] == interval["unsolved"] == 0


def test_two_bodies_of_equal_dimension_add_their_structure_functions(write):
    one = write("a.json", measurement(roughness=1e-11))
    other = write("b.json", measurement(roughness=3e-11))
    both = measured_surface((one, other)).fractal
    # S ~ G^(2(D-1)) at equal D
    expected = (1e-11**0.8 + 3e-11**0.8) ** (1.0 / 0.8)
    assert float(both.fractal_roughness) == pytest.approx(expected, rel=1e-6, abs=0.0)
    assert float(both.fractal_dimension) == pytest.approx(1.4, abs=1e-9)


@pytest.mark.long
def test_the_command_runs_a_joint_from_two_measured_files(zou_file, write):
    files = [str(write(name, measurement())) for name in ("a.json", "b.json")]
    shown = CliRunner().invoke(
        command,
        ["joint", str(zou_file), "--json", "--surface", files[0], "--surface", files[1]],
        catch_exceptions=False,
    )
    document = json.loads(shown.output)
    assert document["input"]["surface"]["fractal_dimension"] == pytest.approx(1.4, abs=1e-9)
    assert "contact_laws" not in document
    interval = document["stiffness_interval"]["assembly"]
    nominal = document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    assert interval["low_Nm_per_rad"] < nominal < interval["high_Nm_per_rad"]


@pytest.mark.long
def test_the_command_runs_a_joint_from_a_measured_spectrum(zou_file, tmp_path):
    """White noise of 0.1 µm has no power law; its waves, all but a few, are shorter than any contact is wide.

    Both bodies have it.
    """
    heights = 1e-7 * np.random.default_rng(0).standard_normal(4000)
    rows = np.stack([1e-6 * np.arange(4000), heights], 1)
    np.savetxt(tmp_path / "roller.csv", rows, delimiter=",", header="x [m],z [m]")
    common = ("surface", "measure", str(tmp_path / "roller.csv"), "--json")
    for lay in ([], ["--lay", "axis"]):
        shown = CliRunner().invoke(command, [*common, *lay], catch_exceptions=False)
        assert shown.exit_code == 0
        (tmp_path / "m.json").write_text(shown.stdout)
        asked = ["joint", str(zou_file), "--surface", str(tmp_path / "m.json")]
        joint = CliRunner().invoke(command, [*asked, "--json"])
        if not lay:
            assert "measure it again with --lay" in str(joint.exception)
    document = json.loads(joint.stdout)
    for name, contact in document["standing"]["contacts"].items():
        height = document["input"]["surface"][name]["rms_height"]
        assert height == pytest.approx(np.sqrt(2.0) * 1e-7, rel=0.02)
        force = document["standing"]["forces"]["normal_N"][name]
        rigid = force / (0.48 * height)
        ratio = np.pi / 4.0 * 206e9 / 1.82 * 5e-3 / rigid  # u_0 R/a^2
        elastic = rigid * (1.0 + 1.0 / (1.0 + 1.35 * ratio))
        assert contact["asperity_normal_stiffness_N_per_m"] == pytest.approx(elastic, rel=1e-6)
    assert document["measured_surface"]["spectra"][0]["lay"] == "axis"
    assert "no power law" in document["measured_surface"]["no_power_law"]
    assert document["measured_surface"]["measurement_of"] == "body"
    assert set(document["stiffness_interval"]["parts"]) == {"contact_law", "rms_height"}
    exponential, persson = document["contact_laws"]
    assert (exponential["law"], exponential["used"]) == ("exponential", True)
    assert (persson["law"], persson["used"]) == ("persson_2007", False)
    stiffness = document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    assert exponential["assembly_Nm_per_rad"] == pytest.approx(stiffness, rel=1e-9)
    assert persson["assembly_Nm_per_rad"] == pytest.approx(stiffness, rel=0.1)
    text = " ".join(CliRunner().invoke(command, asked, catch_exceptions=False).output.split())
    assert "Interval of the contact law, and of the rms of the heights" in text
    assert "by the error of the law alone" in text
    assert "roller.csv: a profile across its lay, which is stated as axis" in text
    assert "measured surface: each body as measured: roller.csv" in text
    pair = CliRunner().invoke(command, [*asked, "--json", "--measurement-of", "pair"], catch_exceptions=False)
    of_pair = json.loads(pair.stdout)
    assert of_pair["measured_surface"]["measurement_of"] == "pair"
    assert "measured surface: the pair as measured: roller.csv" in of_pair["assumptions"]
    heights = [made["input"]["surface"]["sp"]["rms_height"] for made in (document, of_pair)]
    assert heights[0] / heights[1] == pytest.approx(np.sqrt(2.0), rel=1e-3)


def test_of_what_a_measurement_is_belongs_to_a_measurement(zou_file, write):
    asked = ["joint", str(zou_file), "--measurement-of", "pair"]
    said = str(CliRunner().invoke(command, asked).exception)
    assert said == "--measurement-of belongs to --surface; in the joint file it is surface.measurement_of"
    twice = [part for name in ("a.json", "b.json") for part in ("--surface", str(write(name, measurement())))]
    said = str(CliRunner().invoke(command, [*asked, *twice]).exception)
    assert "two measured surfaces are of one body each" in said
    path = write("a.json", measurement())
    assert measured_surface((path,)).of == "body"
    assert measured_surface((path,), "pair").of == "pair"


def test_more_than_two_bodies_are_refused(write):
    path = write("a.json", measurement())
    with pytest.raises(InputError, match="3 measured surfaces were given; allowed are one"):
        measured_surface((path, path, path))


def test_a_measurement_that_hardly_knows_d_is_refused(zou_file):
    vague = measurement(dimension=1.9, deviation=0.2)
    joint = joint_from_case(with_measured_surface(parse_case(zou_file.read_text(), source="x"), vague))
    with pytest.raises(InputError, match="too uncertain"):
        stiffness_interval(joint, vague)


@pytest.mark.long
def test_draws_without_a_stiffness_leave_no_interval(zou_file):
    """At D = 1.2 every spot is plastic: the interval was 0 to 0."""
    measured = measurement(dimension=1.2)
    joint = joint_from_case(with_measured_surface(read_case(zou_file), measured))
    interval = stiffness_interval(joint, measured)
    assert interval["all_plastic"] == interval["draws"]
    for level in ("published", "series_with_bulk", "assembly"):
        assert interval[level] == {"low_Nm_per_rad": None, "high_Nm_per_rad": None}


@pytest.fixture
def drawn(zou_file, monkeypatch):
    """Interval of draws whose stiffness is their rank over 1000, some of them without a stiffness."""

    def interval(unsolved, plastic):
        def evaluated(joint, surfaces):
            rank = np.arange(np.size(surfaces[0].fractal_dimension))
            level = SimpleNamespace(output=rank / 1000.0)
            return SimpleNamespace(
                solved=rank >= unsolved,
                contact_law_holds=rank < rank.size - plastic,
                published=level,
                series_with_bulk=SimpleNamespace(output=2.0 * level.output),
                assembly=SimpleNamespace(stiffness=level),
                rolling=SimpleNamespace(drift_per_output_turn=rank / 1e6),
            )

        monkeypatch.setattr("asperity.joint.surface_interval._by_program", evaluated)
        measured = measurement()
        return stiffness_interval(
            joint_from_case(with_measured_surface(read_case(zou_file), measured)), measured
        )

    return interval


def test_ends_are_the_quantiles_of_the_draws(drawn):
    found = drawn(0, 0)
    assert found["published"] == pytest.approx({"low_Nm_per_rad": 0.049975, "high_Nm_per_rad": 1.949025})
    assert found["series_with_bulk"]["high_Nm_per_rad"] == pytest.approx(2 * 1.949025)
    assert (found["confidence"], found["draws"]) == (0.95, 2000)


def test_one_draw_in_twenty_may_lack_a_stiffness(drawn):
    found = drawn(60, 40)
    assert (found["unsolved"], found["all_plastic"]) == (60, 40)
    assert found["title"] == "95 % interval from the measured surface, D = 1.400, G = 1e-8 mm"
    assert found["words"].startswith(
        "Of 2000 draws of D and G, 0 had a D outside 1 to 2, 60 had no solution and 40 had plastic spots only"
    )
    assert drawn(0, 0)["words"] == "The interval leaves out the error of the contact law."
    # 60 to 1959: 1900 draws, whose ends are 2.5 % of 1899 steps inside
    expected = {"low_Nm_per_rad": 0.06 + 0.025 * 1.899, "high_Nm_per_rad": 1.959 - 0.025 * 1.899}
    assert found["published"] == pytest.approx(expected)
    assert drawn(60, 41)["published"] == {"low_Nm_per_rad": None, "high_Nm_per_rad": None}


@pytest.mark.long
def test_the_command_says_that_the_law_fails_instead_of_a_number(zou_file, write):
    path = write("a.json", measurement(dimension=1.2))
    shown = CliRunner().invoke(
        command, ["joint", str(zou_file), "--surface", str(path)], catch_exceptions=False
    )
    assert "no value: every spot of sp, pwr, pwl, wro, wlo is plastic" in " ".join(shown.output.split())
    assert "where they are one draw in twenty or more, there is no interval" in " ".join(shown.output.split())

"""Surfaces stated by their Ra: the interval over D and Ra holds the joints at its ends."""

import math
import tomllib
from pathlib import Path

import numpy as np
import pytest
from assumed import assumptions

from asperity.engine.control import at_once, vectorised
from asperity.joint.evaluation import evaluate
from asperity.joint.solve import solve_joint
from asperity.joint_file import drawn_surface as module
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.drawn_surface import _words, drawn_interval, surfaces_by_average
from asperity.joint_file.reader import case_from_tables, parse_case
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.surface.roughness_average import roughness_average, scatter_of_average

EXAMPLES = Path(__file__).parents[2] / "examples"
SURFACE = '[surface]\nfinish = "ground"\nroughness_average = "0.2 um"\n'


@pytest.fixture(scope="module")
def head(example_text):
    """A file with the published law, whose interval D and Ra make."""
    text = example_text[: example_text.index("[surface]")]
    return text.replace("[model]\n", '[model]\ncontact_law = "zou_2025"\n')


@pytest.fixture(scope="module")
def drawn_case(head):
    return parse_case(head + SURFACE, source="a.toml")


@pytest.fixture(scope="module")
def interval(drawn_case):
    return drawn_interval(drawn_case)


@pytest.fixture
def states(head, monkeypatch):
    """The surfaces over which the interval of a file is taken, and what is said of them, without any joint."""
    asked = []
    monkeypatch.setattr(
        module, "over_surfaces", lambda joint, surfaces, shape: asked.append((surfaces, shape))
    )
    monkeypatch.setattr(module, "result_ends", lambda result, **_: {"unsolved": 0, "all_plastic": 0})

    def of(text):
        found = drawn_interval(parse_case(head + text, source="a.toml"))
        ((surface,), shape) = asked.pop()
        dimension, roughness = (
            np.asarray(each).reshape(5, 15) for each in (surface.fractal_dimension, surface.fractal_roughness)
        )
        assert shape == (75,)
        average = [
            [roughness_average(fractal_dimension=d, fractal_roughness=g, cut_off=0.8e-3) for d, g in pairs]
            for pairs in (zip(*rows, strict=True) for rows in zip(dimension, roughness, strict=True))
        ]
        return found, dimension, np.array(average)

    return of


def test_states_of_a_finish_by_hand(states):
    """Every D of ground steel with every Ra within 1.96 times the scatter of one measurement; two bodies alike."""
    found, dimension, average = states(SURFACE)
    by_d = np.linspace(1.15, 1.5, 15)
    np.testing.assert_allclose(dimension, np.tile(by_d, (5, 1)), rtol=1e-12)
    half = 1.959964 * np.array([scatter_of_average(fractal_dimension=d, cut_offs=5) for d in by_d])
    factor = 1.0 + half * np.array([-1.0, -0.5, 0.0, 0.5, 1.0])[:, None]
    np.testing.assert_allclose(average, math.sqrt(2.0) * 0.2e-6 * factor, rtol=1e-6)
    assert found["states"] == 75
    entry = found["surfaces"]["surface"]
    ends = [0.2e-6 * (1.0 - half.max()), 0.2e-6 * (1.0 + half.max())]
    np.testing.assert_allclose(entry["roughness_average_m"], ends, rtol=1e-6)
    assert entry["fractal_dimension"] == pytest.approx([1.15, 1.5])
    assert entry["cut_off_m"] == 0.8e-3
    assert "surface (ground): D from 1.15 to 1.5, Ra of a body from" in found["words"]
    assert "5 of 75 states have no solution or no stiffness: no interval." in _words(
        found | {"unsolved": 2, "all_plastic": 3}
    )
    assert "no interval" not in found["words"]


def test_states_of_a_stated_tolerance_by_hand(states):
    """0.2 um within a quarter; the partner within its own fifth, together with it."""
    text = SURFACE.replace("0.2 um", "0.2 um +- 0.05 um")
    found, _, average = states(text + 'partner_roughness_average = "0.1 um +- 0.02 um"\n')
    along = np.linspace(-1.0, 1.0, 5)[:, None]
    both = np.hypot(0.2e-6 * (1.0 + 0.25 * along), 0.1e-6 * (1.0 + 0.2 * along))
    np.testing.assert_allclose(average, np.tile(both, 15), rtol=1e-6)
    surface = found["surfaces"]["surface"]
    np.testing.assert_allclose(surface["roughness_average_m"], [0.15e-6, 0.25e-6])
    np.testing.assert_allclose(surface["partner_roughness_average_m"], [0.08e-6, 0.12e-6])
    assert "Ra of both bodies from 0.15 µm to 0.25 µm and 0.08 µm to 0.12 µm at the cut-off" in found["words"]


def test_a_smooth_partner_stays_smooth(states):
    found, _, average = states(
        SURFACE.replace("0.2 um", "0.2 um +- 0.05 um") + 'partner_roughness_average = "0 um"\n'
    )
    assert found["surfaces"]["surface"]["partner_roughness_average_m"] == [0.0, 0.0]
    along = np.linspace(-1.0, 1.0, 5)[:, None]
    np.testing.assert_allclose(average, np.tile(0.2e-6 * (1.0 + 0.25 * along), 15), rtol=1e-6)


def test_a_partner_without_a_tolerance_scatters_as_measured_once(states):
    text = SURFACE.replace("0.2 um", "0.2 um +- 0.05 um") + 'partner_roughness_average = "0.1 um"\n'
    ends = states(text)[0]["surfaces"]["surface"]["partner_roughness_average_m"]
    half = 1.959964 * max(scatter_of_average(fractal_dimension=d, cut_offs=5) for d in (1.15, 1.5))
    np.testing.assert_allclose(ends, [0.1e-6 * (1.0 - half), 0.1e-6 * (1.0 + half)], rtol=1e-6)


def test_the_surface_of_the_joint_has_the_ra_of_both_bodies(head):
    text = SURFACE + 'partner_roughness_average = "0.15 um"\n'
    (surface,) = joint_from_case(parse_case(head + text, source="a.toml")).surfaces
    back = roughness_average(
        fractal_dimension=surface.fractal_dimension,
        fractal_roughness=surface.fractal_roughness,
        cut_off=0.8e-3,
    )
    assert back == pytest.approx(0.25e-6)


@pytest.mark.long
def test_joints_at_the_ends_lie_inside(drawn_case, interval):
    half = 1.959964 * np.array([scatter_of_average(fractal_dimension=d, cut_offs=5) for d in (1.15, 1.5)])
    corners = (
        np.array([1.15, 1.15, 1.5, 1.5, 1.325]),
        0.2e-6 * (1.0 + np.array([-half[0], half[0], -half[1], half[1], 0.0])),
    )

    def at(dimension, average):
        changes = {"surface.fractal_dimension": dimension, "surface.roughness_average": average}
        values = replace_values(si_values(drawn_case), changes | {"surface.cut_off": 0.8e-3})
        return evaluate(joint_from_values(values))

    result = at_once(vectorised(at), *corners)
    for name, values, unit in (
        ("assembly", result.assembly.stiffness.output, "Nm_per_rad"),
        ("published", result.published.output, "Nm_per_rad"),
        ("drift", result.rolling.drift_per_output_turn, "rad_per_output_turn"),
    ):
        low, high = interval[name][f"low_{unit}"], interval[name][f"high_{unit}"]
        assert low == pytest.approx(float(np.min(values)), rel=1e-6), name
        assert high == pytest.approx(float(np.max(values)), rel=1e-6), name
        assert low < values[-1] < high
    assert interval["unsolved"] == interval["all_plastic"] == 0


def test_a_file_with_d_and_g_has_no_such_interval(example_case):
    assert surfaces_by_average(example_case) == {}
    assert drawn_interval(example_case) is None


def test_assumptions_name_what_ra_leaves_open(head):
    told = " ".join(
        assumptions(
            parse_case(head + SURFACE.replace("0.2 um", "3.2 um"), source="a.toml"),
        )
    )
    assert "both bodies have the same Ra" in told
    assert "not the upper limit that a drawing states" in told
    assert "3.2 um lies outside the 0.1 um to 1.6 um that are published for ground surfaces" in told
    tolerated = assumptions(
        parse_case(head + SURFACE.replace("0.2 um", "0.2 um +- 0.05 um"), source="a.toml")
    )
    assert not any("upper limit" in each for each in tolerated)


@pytest.mark.parametrize("tolerance", ["", " +- 0.2 um"])
def test_assumptions_name_what_an_rz_leaves_open(head, tolerance):
    text = f'[surface.sp]\nfinish = "ground"\nmean_roughness_depth = "1.6 um{tolerance}"\n'
    others = (SURFACE.replace("surface]", f"surface.{name}]") for name in ("pwr", "pwl", "wro", "wlo"))
    told = " ".join(assumptions(parse_case("\n".join([head + text, *others]), source="a.toml")))
    assert (
        f"surface.sp.mean_roughness_depth: Rz 1.6 um{tolerance} taken of normally distributed heights, Ra "
        in told
    )
    assert "a single scratch raises Rz, and the surface is then smoother than computed" in told
    assert told.count("mean_roughness_depth") == (1 if tolerance else 2)
    assert ("mean_roughness_depth without a tolerance" in told) == (not tolerance)


def test_ra_is_a_number_like_any_other(example_case):
    """A study may vary Ra where the file states G, with the law of a file with Ra unless the file states one.

    The cut-off is then that of the standard for each Ra.
    """
    base = si_values(example_case)
    for average, cut_off in ((0.05e-6, 0.25e-3), (0.2e-6, 0.8e-3)):
        values = replace_values(base, {"surface.roughness_average": average})
        (rough,) = joint_from_values(values).surfaces
        assert float(rough.decay_length) == pytest.approx(0.48 * math.sqrt(math.pi) * average)
        values = replace_values(
            base | {"model": base["model"] | {"contact_law": "zou_2025"}},
            {"surface.roughness_average": average},
        )
        (surface,) = joint_from_values(values).surfaces
        g = surface.fractal_roughness
        back = roughness_average(fractal_dimension=1.4, fractal_roughness=g, cut_off=cut_off)
        assert back == pytest.approx(math.sqrt(2.0) * average)


def test_surfaces_of_other_drives_by_their_ra(planar_case):
    text = (
        "[surface]\nfractal_dimension = 1.5\n"
        'fractal_roughness = "1.3e-7 mm"    # superfinished, towards the rough end\nfrequency_ratio = 1.5'
    )
    known = '[surface.pr]\nfractal_dimension = 1.4\nfractal_roughness = "1e-8 mm"\nfrequency_ratio = 1.5\n\n'
    one = planar_case("planetary", (text, known + SURFACE.replace("[surface]", "[surface.sp]")))
    assert list(surfaces_by_average(one)) == ["surface.sp"]
    assert list(surfaces_by_average(planar_case("planetary", (text, SURFACE)))) == ["surface"]
    assert drawn_interval(planar_case("planetary")) is None


@pytest.mark.long
def test_what_leaves_nothing_open_is_the_joint_of_another_drive(planar_case):
    """D without a tolerance, Ra within a millionth."""
    exact = (
        ('fractal_roughness = "1.3e-7 mm"', 'roughness_average = "0.2 um +- 2e-7 um"'),
        ("[model]", '[model]\ncontact_law = "zou_2025"'),
        ('bodies = "exact"', 'bodies = "springs"'),
        ('ring_support = "free" ', 'ring_support = "rigid_housing" '),
    )
    case = planar_case("planetary", *exact)
    found = drawn_interval(case)
    result = solve_joint(joint_from_case(case)).result
    for level, value in (
        ("published", result.published.output),
        ("assembly", result.assembly.stiffness.output),
    ):
        assert list(found[level].values()) == pytest.approx([float(value)] * 2, rel=1e-5)
    assert found["surfaces"]["surface"]["fractal_dimension"] == [1.5, 1.5]


@pytest.mark.long
@pytest.mark.parametrize("name", ["zou2025", "planetary"])
def test_a_surface_by_its_heights_has_the_interval_of_its_law(name):
    """K_n of 0.48 h in every drive; both ends are the joints with 0.39 and 1.24 of the heights."""

    def joint_file(height):
        tables = tomllib.loads((EXAMPLES / f"{name}.toml").read_text(encoding="utf-8"))
        return case_from_tables(tables | {"surface": {"rms_height": height}}, source="a.toml")

    case = joint_file("0.2 um +- 0.02 um")
    result = solve_joint(joint_from_case(case)).result
    factor = np.asarray(result.contacts.normal_stiffness) / np.asarray(result.forces.normal) * 0.48 * 0.2e-6
    assert np.all((factor > 1.0) & (factor < 2.0))
    interval = drawn_interval(case)
    for end, height in (("low", "0.2728 um"), ("high", "0.0702 um")):
        there = solve_joint(joint_from_case(joint_file(height))).result.assembly.stiffness.output
        assert interval["assembly"][f"{end}_Nm_per_rad"] == pytest.approx(float(there), rel=1e-6)
    told = " ".join(assumptions(case))
    assert "randomly rough elastic surfaces" in told
    assert "not published" not in told

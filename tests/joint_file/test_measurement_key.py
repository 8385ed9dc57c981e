"""A joint file that names its measured surface, ``surface.measurement``."""

import json
import math
import re
import tomllib

import numpy as np
import pytest
from assumed import assumptions

from asperity.errors import InputError
from asperity.joint.measured_surface import measured_surface
from asperity.joint.solve import solve_joint
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.any_joint import with_nominal_sizes
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.felt_heights import felt_at
from asperity.joint_file.measured_surface import case_with_surface
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import si_values, varied_keys
from asperity.joint_file.solved_document import full_document, solve_with_surface
from asperity.study.batch import derivatives_at, evaluate_points
from asperity.study.measured_points import STATE, heights_moved, refuse_derivatives, with_felt_surfaces
from asperity.surface.measured_roughness import roughness_document

#: Edges of the bins along the rolling direction [1/m]: contacts are 0.12 to 0.18 mm wide, in the second bin.
EDGES = (1_000.0, 4_000.0, 9_000.0, 54_000.0)
SQUARES = (4e-14, 2e-14, 1e-14)
RESULTS = ("assembly_stiffness_output", "normal_force", "hertz_half_width")


def document(**changes):
    """A profile in the rolling direction, of three bins, without a power law."""
    spectrum = {
        "source": "roller.csv",
        "is_map": False,
        "lay": "axis",
        "rolling_frequency_edges_per_m": list(EDGES),
        "axial_frequency_edges_per_m": [0.0, 0.0],
        "mean_square_height_m2": [[square] for square in SQUARES],
        "independent_ordinates": [[40.0], [80.0], [160.0]],
    }
    return {
        "schema": "asperity-surface-measurement",
        "schema_version": 1,
        "source": "roller.csv",
        "no_power_law": "no power law",
        "spectra": [spectrum | changes],
    }


def height_by_hand(width):
    """Of both bodies, which are alike: all waves but those below 1/width and 1.5 periods of the profile, by bins."""
    limit, square = max(1.0 / width, 3.0 * EDGES[0]), 0.0
    for low, high, height in zip(EDGES[:-1], EDGES[1:], SQUARES, strict=True):
        square += 2.0 * height * min(max((high - limit) / (high - low), 0.0), 1.0)
    return math.sqrt(square)


@pytest.fixture
def folder(tmp_path, joint_text):
    """A folder with a measurement, and the text of a joint file that names it."""
    (tmp_path / "roller.json").write_text(json.dumps(document()))
    return tmp_path


@pytest.fixture
def named_text(joint_text):
    plain = re.sub(r"(?ms)^\[surface.*?(?=^\[(?!surface)|\Z)", "", joint_text)
    return plain + '\n[surface]\nmeasurement = "roller.json"\n'


@pytest.fixture
def named(folder, named_text):
    (folder / "joint.toml").write_text(named_text)
    return read_case(folder / "joint.toml")


@pytest.mark.slow
def test_each_contact_feels_the_bands_below_its_width(named):
    diagnostics = solve_joint(joint_from_case(named)).result.diagnostics
    for entry, half in zip(named.surface.values(), diagnostics.hertz_half_width, strict=True):
        assert entry.rms_height.value == pytest.approx(height_by_hand(2.0 * float(half)), rel=1e-8)
    assert len({entry.rms_height.value for entry in named.surface.values()}) > 1


@pytest.mark.slow
def test_the_heights_of_many_widths_are_those_of_the_bands(named):
    widths = np.geomspace(2.5e-5, 1e-3, 60).reshape(3, 20)
    heights = felt_at(named.measured.pair.spectra, widths, np.full(widths.shape, 1e-2))
    by_hand = [[height_by_hand(width) for width in row] for row in widths]
    np.testing.assert_allclose(heights, by_hand, rtol=1e-12)
    one_body = felt_at(named.measured.measured.spectra, widths, np.full(widths.shape, 1e-2))
    np.testing.assert_allclose(one_body, np.divide(by_hand, math.sqrt(2.0)), rtol=1e-12)


@pytest.mark.slow
def test_the_file_makes_the_document_of_the_option(folder, named, joint_text):
    plain = parse_case(joint_text, source="joint.toml")
    option = case_with_surface(plain, measured_surface((folder / "roller.json",)))
    made = solve_with_surface(named)
    assert made.document == solve_with_surface(option).document
    assert made.document["stiffness_interval"]["parts"].keys() == {"contact_law", "rms_height"}
    assert made.document["measured_surface"]["source"] == "roller.csv"
    assert full_document(named, made.solved) == made.document


@pytest.mark.slow
def test_one_measurement_is_that_of_both_bodies_unless_it_is_of_the_pair(folder, named, named_text):
    """As an Ra of one body counts for both; the mean squares of two measurements add in any case."""

    def with_surface(section):
        text = named_text.replace('measurement = "roller.json"', section)
        return parse_case(text, source="joint.toml", folder=folder)

    twice = with_surface('measurement = ["roller.json", "roller.json"]')
    pair = with_surface('measurement = "roller.json"\nmeasurement_of = "pair"')
    body = with_surface('measurement = "roller.json"\nmeasurement_of = "body"')
    for name, entry in named.surface.items():
        height = entry.rms_height.value
        assert twice.surface[name].rms_height.value == pytest.approx(height, rel=1e-12)
        assert body.surface[name].rms_height.value == height
        # of half of the squares; the contacts are narrower, and feel a little less
        assert pair.surface[name].rms_height.value == pytest.approx(height / math.sqrt(2.0), rel=1e-3)
    for case, words in (
        (named, "each body as measured: roller.csv"),
        (twice, "the pair as measured: roller.csv + roller.csv"),
        (pair, "the pair as measured: roller.csv"),
    ):
        assert case.measured.assumed[0].startswith(f"measured surface: {words}")
    assert [case.measured.measured.of for case in (named, twice, pair)] == ["body", "pair", "pair"]
    (told,) = [told for told in assumptions(named) if "each body as measured" in told]
    assert 'state measurement_of = "pair"' in told


def test_a_document_says_that_it_is_of_a_pair(folder, named, named_text):
    """What 'asperity surface combine' writes is no body; a file that is written for another folder says so, too."""
    roughness = measured_surface((folder / "roller.json", folder / "roller.json"))
    made = roughness_document(roughness)
    assert made["measurement_of"] == "pair"
    (folder / "roller.json").write_text(json.dumps(made))
    pair = parse_case(named_text, source="joint.toml", folder=folder)
    for name, entry in named.surface.items():
        assert pair.surface[name].rms_height.value == pytest.approx(entry.rms_height.value, rel=1e-12)
    text = joint_file_text(pair, {"load.preload": 1200.0}, comment="")
    assert tomllib.loads(text)["surface"] == {
        "measurement": str(folder / "roller.json"),
        "measurement_of": "pair",
    }
    again = parse_case(text, source="elsewhere.toml")
    assert again.measured.measured.of == "pair"
    bare = joint_file_text(pair.with_text(""), {}, comment="")
    assert tomllib.loads(bare)["surface"]["measurement_of"] == "pair"
    said = named_text.replace('"roller.json"', '"roller.json"\nmeasurement_of = "body"')
    with pytest.raises(InputError, match=r"surface\.measurement: roller\.csv .*document is that of a pair"):
        parse_case(said, source="joint.toml", folder=folder)


def test_every_point_of_a_study_has_both_bodies(named, named_text, folder):
    """The heights at a point, of the document that the tables hold, are those of the joint itself."""
    tables, points, settled = with_felt_surfaces(si_values(named), {}, lambda values, columns: states(named))
    assert settled.all()
    assert tables["surface"].keys() == named.surface.keys()
    for name, entry in named.surface.items():
        assert points[f"surface.{name}.rms_height"][0] == pytest.approx(entry.rms_height.value, rel=1e-6)


def states(case):
    """Widths and pressures of the contacts of a joint, shape (contacts, 1)."""
    diagnostics = solve_joint(joint_from_case(case)).result.diagnostics
    return {name: np.asarray(getattr(diagnostics, name))[:, None] for name in STATE}


@pytest.mark.long
def test_a_sweep_has_the_heights_of_separate_joints(named):
    preload = np.array([400.0, 1000.0, 2500.0])
    status, results = evaluate_points(si_values(named), {"load.preload": preload}, RESULTS)
    assert status.tolist() == [0, 0, 0]
    heights = []
    for point, force in enumerate(preload):
        alone = parse_case(joint_file_text(named, {"load.preload": force}, comment=""), source="alone")
        result = solve_joint(joint_from_case(alone)).result
        heights.append(alone.surface["sp"].rms_height.value)
        assert results["assembly_stiffness_output"][point] == pytest.approx(
            float(result.assembly.stiffness.output), rel=1e-12
        )
        np.testing.assert_allclose(results["normal_force"][:, point], result.forces.normal, rtol=1e-12)
    assert np.all(np.diff(heights) > 0.02 * heights[0])  # wider contacts feel longer waves


@pytest.mark.long
def test_derivatives_move_the_heights(named):
    """Against differences of a sweep, whose every point has heights of its own; length changes the widths only."""
    values = si_values(named)
    changes = {"load.preload": np.array([1000.0]), "drive.contact_length": np.array([0.006])}
    _, _, slopes = derivatives_at(values, changes, RESULTS[:1], tuple(changes))
    for number, (path, middle) in enumerate(changes.items()):
        step = 1e-4 * middle
        points = {name: np.repeat(value, 2) for name, value in changes.items()}
        points[path] = np.concatenate([middle - step, middle + step])
        _, ends = evaluate_points(values, points, RESULTS[:1])
        difference = np.diff(ends[RESULTS[0]]) / (2.0 * step)
        assert slopes[RESULTS[0]][0, 0, number] == pytest.approx(difference[0], rel=1e-4)


@pytest.mark.long
def test_a_size_in_the_file_and_that_of_a_finished_part_move_the_heights_too(folder, named_text):
    """A radius and its nominal one together are another drive, the radius alone is a part that deviates."""
    by_interference = named_text.replace('preload = "1000 N"', 'interference = "13 um"')
    values = si_values(parse_case(by_interference, source="joint.toml", folder=folder))
    path, size = "drive.planet_radius", np.array([13.5e-3])
    around, step = with_nominal_sizes(values), 1e-7
    _, _, slopes = derivatives_at(around, {path: size}, RESULTS[:1], (path,), nominal=(path,))
    for number, tables in enumerate((around, values)):
        ends = evaluate_points(tables, {path: size[0] + np.array([-step, step])}, RESULTS[:1])[1]
        difference = np.diff(ends[RESULTS[0]]) / (2.0 * step)
        assert slopes[RESULTS[0]][0, 0, number] == pytest.approx(difference[0], rel=1e-2), number


def test_heights_and_widths_move_each_other(named):
    """Heights that move with widths, which move with a preload and with all heights, by hand."""
    width, step = 0.15e-3, 1e-8
    by_width = (height_by_hand(width + step) - height_by_hand(width - step)) / (2.0 * step)
    rng = np.random.default_rng(4)
    by_preload = rng.uniform(1e-9, 3e-9, size=5)
    by_heights = rng.uniform(0.02, 0.08, size=(5, 5)) / by_width  # the feedback is .2 to .8 of a change
    slopes = np.column_stack([by_preload, by_heights])[:, None]
    preload = {"load.preload": np.array([1000.0])}
    moved = heights_moved(si_values(named), preload, np.full((5, 1), 0.5 * width), slopes, tuple(preload))
    assert moved.shape == (1, 5, 1)
    one = moved[0, :, 0]
    np.testing.assert_allclose(one, 2.0 * by_width * (by_preload + by_heights @ one), rtol=1e-5)
    assert np.abs(one / (2.0 * by_width * by_preload) - 1.0).max() > 0.1


@pytest.mark.long
def test_a_law_with_a_decay_length_has_it_at_every_point(folder, named_text):
    text = named_text.replace("[model]", '[model]\ncontact_law = "persson_2007"')
    case = parse_case(text, source="joint.toml", folder=folder)
    preload = np.array([600.0, 1500.0])
    _, results = evaluate_points(si_values(case), {"load.preload": preload}, RESULTS[:1])
    for point, force in enumerate(preload):
        alone = parse_case(joint_file_text(case, {"load.preload": force}, comment=""), source="alone")
        stiffness = float(solve_joint(joint_from_case(alone)).result.assembly.stiffness.output)
        assert results[RESULTS[0]][point] == pytest.approx(stiffness, rel=1e-8)
    with pytest.raises(InputError, match="has no derivatives beside"):
        derivatives_at(si_values(case), {"load.preload": preload}, RESULTS[:1], ("load.preload",))


#: A map with more of its waves in the rolling direction: mean squares of bins, the rolling direction first.
MAP = {
    "is_map": True,
    "lay": None,
    "axial_frequency_edges_per_m": list(EDGES),
    "mean_square_height_m2": [[1e-14, 2e-14, 1e-14], [4e-14, 3e-14, 1e-14], [4e-14, 2e-14, 1e-14]],
    "independent_ordinates": [[40.0, 80.0, 160.0]] * 3,
}


def share_by_hand(width, length):
    """Of the waves that a contact feels, by many points in each bin."""
    limits = [max(1.0 / size, 3.0 * EDGES[0]) for size in (width, length)]
    running = total = 0.0
    for i, j in np.ndindex(3, 3):
        first, second = (EDGES[k] + (np.arange(400) + 0.5) / 400 * (EDGES[k + 1] - EDGES[k]) for k in (i, j))
        felt = ~np.logical_and.outer(first < limits[0], second < limits[1])
        share = first[:, None] ** 2 / np.add.outer(first**2, second**2)
        running += MAP["mean_square_height_m2"][i][j] * np.mean(felt * share)
        total += MAP["mean_square_height_m2"][i][j] * np.mean(felt)
    return running / total


@pytest.fixture
def on_map(folder, named_text):
    (folder / "roller.json").write_text(json.dumps(document(**MAP)))
    return parse_case(named_text, source="joint.toml", folder=folder)


@pytest.mark.slow
def test_a_map_states_the_lay_of_each_contact(on_map):
    """At the width that the contact has with it; it stands under Assumed, and the joint has it."""
    joint = joint_from_case(on_map)
    widths = 2.0 * np.asarray(solve_joint(joint).result.diagnostics.hertz_half_width)
    for (name, entry), width, surface in zip(on_map.surface.items(), widths, joint.surfaces, strict=True):
        length = min(5e-3, on_map.measured.pair.spectra[0].cut_off())
        assert entry.rolling_share.value == pytest.approx(share_by_hand(width, length), rel=5e-3)
        assert float(surface.rolling_share) == entry.rolling_share.value
        assert any(f"{name} {entry.rolling_share.value:.3f}" in told for told in on_map.measured.assumed)
    assert len({entry.rolling_share.value for entry in on_map.surface.values()}) > 1


def test_a_profile_states_its_lay(named, folder, named_text):
    """Grooves along the axis: all waves run in the rolling direction. Without grooves nothing is said of them."""
    assert {entry.rolling_share.value for entry in named.surface.values()} == {1.0}
    edges = ("rolling_frequency_edges_per_m", "axial_frequency_edges_per_m")
    turned = {
        edges[0]: [0.0, 0.0],
        edges[1]: list(EDGES),
        "mean_square_height_m2": [list(SQUARES)],
        "independent_ordinates": [[40.0, 80.0, 160.0]],
    }
    for lay, share in (("rolling", 0.0), ("isotropic", None)):
        (folder / "roller.json").write_text(json.dumps(document(lay=lay, **turned)))
        case = parse_case(named_text, source="joint.toml", folder=folder)
        stated = {entry.rolling_share and entry.rolling_share.value for entry in case.surface.values()}
        assert stated == {share}


@pytest.mark.slow
def test_a_sweep_on_a_map_has_the_lay_of_separate_joints_and_its_slopes(on_map):
    """Wider contacts feel other waves; derivatives against differences of a sweep."""
    values, preload = si_values(on_map), np.array([700.0, 999.9, 1000.0, 1000.1])
    status, results = evaluate_points(values, {"load.preload": preload}, ("drift", *RESULTS[:1]))
    assert not status.any()
    for point in (0, 2):
        text = joint_file_text(on_map, {"load.preload": preload[point]}, comment="")
        result = solve_joint(joint_from_case(parse_case(text, source="alone"))).result
        assert results["drift"][point] == pytest.approx(float(result.rolling.drift_per_output_turn), rel=1e-8)
    changes = {"load.preload": preload[2:3]}
    _, _, slopes = derivatives_at(values, changes, ("drift", *RESULTS[:1]), ("load.preload",))
    for name, found in results.items():
        assert slopes[name][0, 0, 0] == pytest.approx((found[3] - found[1]) / 0.2, rel=1e-3)


@pytest.mark.parametrize(
    ("key", "more", "remedy"),
    [
        ("decay_length", {}, 'state model.contact_law = "exponential"'),
        ("rms_height", {"branch": {}}, r"leave \[\[branch\]\] out"),
        (
            "decay_length",
            {"branch": {}},
            r'leave \[\[branch\]\] out and state model.contact_law = "exponential"',
        ),
    ],
)
def test_what_has_no_derivatives_is_refused_with_all_that_helps(key, more, remedy):
    with pytest.raises(InputError, match=rf"a decay length: {remedy}$"):
        refuse_derivatives({"surface": {"sp": {key: 1e-7}}} | more)
    refuse_derivatives({"surface": {"sp": {"rms_height": 1e-7}}})


@pytest.mark.long
def test_beyond_the_capacity_it_is_not_known_what_the_contacts_feel(named):
    """Nor the capacity that follows from it, which had been that of heights at infinite widths."""
    torques = {"load.output_torque": np.array([2.0, 1e3])}
    status, results = evaluate_points(si_values(named), torques, ("standing_torque_capacity", "speed_ratio"))
    assert STATUS_NAMES[status[1]] == "beyond_standing_capacity"
    assert np.isfinite(results["standing_torque_capacity"]).tolist() == [True, False]
    assert np.isfinite(results["speed_ratio"]).all()


@pytest.mark.long
def test_points_without_a_joint_do_not_disturb_the_others(named):
    preload = np.array([1000.0, 1000.0])
    torque = np.array([1.0, 1e5])
    points = {"load.preload": preload, "load.output_torque": torque}
    status, results = evaluate_points(si_values(named), points, RESULTS[:1])
    assert status[0] == 0
    assert status[1] != 0
    assert np.isfinite(results[RESULTS[0]]).tolist() == [True, False]


def test_what_follows_from_the_measurement_is_no_number_of_the_file(named):
    assert not [path for path in varied_keys(named) if path.startswith("surface")]
    with pytest.raises(InputError, match=r"surface\.sp\.rms_height: follows from the measured surface"):
        evaluate_points(si_values(named), {"surface.sp.rms_height": np.array([1e-7])}, RESULTS[:1])


def test_a_changed_file_names_the_measurement_wherever_it_is_written(folder, named):
    text = joint_file_text(named, {"load.preload": 1200.0}, comment="changed")
    assert tomllib.loads(text)["surface"] == {"measurement": str(folder / "roller.json")}
    assert "# ours" in text
    again = parse_case(text, source="elsewhere.toml")
    assert again.load.preload.value == 1200.0
    assert again.measured.measured.source == "roller.csv"
    untold = joint_file_text(named.with_text(""), {}, comment="")
    assert tomllib.loads(untold)["surface"] == {"measurement": str(folder / "roller.json")}


@pytest.mark.parametrize(
    ("section", "said"),
    [
        (
            'measurement = "roller.json"\nrms_height = "0.2 um"',
            "measurement stands alone.*leave rms_height out",
        ),
        ('measurement = "roller.json"\nfractal_dimension = 1.4', "leave fractal_dimension out"),
        ('measurement = "roller.json"\nroughness_average = "0.2 um"', "leave roughness_average out"),
        ('measurement = "absent.json"', "surface.measurement: .*absent.json"),
        ('measurement = "joint.toml"', "surface.measurement: .*joint.toml.*'asperity surface measure'"),
        ('measurement = "."', "surface.measurement: "),
        (
            'measurement = "roller.json"\nmeasurement_of = "both"',
            'surface.measurement_of: expected "body", .* or "pair", .*got \'both\'',
        ),
        ('measurement_of = "pair"\nrms_height = "0.2 um"', "leave measurement_of out"),
        ('measurement_of = "pair"\nroughness_average = "0.2 um"', "measurement_of: only with measurement"),
        (
            'measurement = ["roller.json", "roller.json"]\nmeasurement_of = "pair"',
            "surface.measurement: two measured surfaces are of one body each; leave out of what they are",
        ),
        ("measurement = 3", "surface.measurement: expected the name of the JSON file"),
        ('measurement = ["a", "b", "c"]', "or a list of two"),
        ('sp.measurement = "roller.json"', "sp.measurement: a measured surface is that of all contacts"),
    ],
)
def test_refusals_are_one_message(folder, named_text, section, said):
    text = named_text.replace('measurement = "roller.json"', section)
    (folder / "joint.toml").write_text(text)
    with pytest.raises(InputError, match=said) as refused:
        read_case(folder / "joint.toml")
    assert str(refused.value).startswith(f"{folder / 'joint.toml'}: ")
    assert "\n" not in str(refused.value)


def test_a_measurement_that_does_not_serve_is_refused_with_the_file(folder, named_text):
    (folder / "roller.json").write_text(json.dumps(document(lay=None)))
    with pytest.raises(InputError, match=r"joint.toml: roller.csv: .*measure it again with --lay"):
        parse_case(named_text, source="joint.toml", folder=folder)
    (folder / "roller.json").write_text(json.dumps({"schema": "another"}))
    with pytest.raises(InputError, match=r"joint.toml: surface.measurement: .*roller.json"):
        parse_case(named_text, source="joint.toml", folder=folder)

"""Joints of other types at many points: against solutions of single files, differences, and formulas by hand."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.joint.status import NO_ROOM, SLIPS
from asperity.joint_file.any_joint import evaluated_points, results_of
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.part_names import with_structure
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.results import GROUPS, RESULTS, chosen_results, known_result
from asperity.results.document import joint_document
from asperity.results.solved import solved_with_capacities
from asperity.study.batch import derivatives_at

#: One program for all numbers: stiffness on every level, and one result of every kind of rows.
NAMES = (
    "assembly_stiffness_output",
    "series_with_bulk_stiffness_output",
    "published_stiffness_output",
    "assembly_stiffness_per_mass",
    "slip_ratio",
    "hertz_pressure",
    "preload",
    "speed_loss",
    "drive_life",
    "body_life",
    "mass",
    "envelope_diameter",
    "speed_ratio",
    "clearance",
)
CAPACITIES = ("standing_torque_capacity", "rolling_torque_capacity", "torque_capacity", "torque_safety")
VARIABLES = ("load.output_torque", "drive.planet_radius", "load.interference", "surface.fractal_dimension")
TORQUES = [5.0, 10.0, -10.0, 13.0, 10.0]
PLANETS = [3.0, 3.0, 3.0, 3.0, 5.0]


@pytest.fixture(scope="module")
def values(planar_case):
    return si_values(planar_case("planetary"))


def at_points(values, names):
    changes = {"load.output_torque": np.array(TORQUES), "drive.planets": np.array(PLANETS)}
    changes |= {path: np.full(5, _at(values, path)) for path in VARIABLES[1:]}
    return derivatives_at(values, changes, names, VARIABLES)


@pytest.fixture(scope="module")
def found(values):
    return at_points(values, NAMES)


def _at(values, path):
    section, name = path.split(".")
    return values[section][name]


def single(values, changes):
    return solve_joint(joint_from_values(replace_values(values, changes)))


def numbers_of(solution):
    result = solution.result
    return {
        "assembly_stiffness_output": result.assembly.stiffness.output,
        "series_with_bulk_stiffness_output": result.series_with_bulk.output,
        "published_stiffness_output": result.published.output,
        "slip_ratio": result.diagnostics.slip_ratio,
        "hertz_pressure": result.diagnostics.hertz_pressure,
        "preload": result.preload,
        "speed_loss": result.rolling.speed_loss,
        "drive_life": 3600.0 * result.rolling.life_hours.drive,
        "speed_ratio": result.speed_ratio,
        "standing_torque_capacity": solution.standing_capacity.output_torque,
        "rolling_torque_capacity": solution.rolling_capacity.output_torque,
    }


@pytest.mark.long
def test_points_are_the_solutions_of_their_files(values, found):
    status, numbers, _ = found
    # five planets of 20 mm do not fit around a sun of 10 mm
    assert status.tolist() == [0, 0, 0, SLIPS, NO_ROOM]
    _same_as_single_files(values, numbers)


@pytest.mark.long
def test_capacities_and_their_slopes(values):
    _, numbers, slopes = at_points(values, CAPACITIES)
    _same_as_single_files(values, numbers)
    safety, capacity = numbers["torque_safety"][0], numbers["torque_capacity"][0]
    np.testing.assert_allclose(safety[:2] * TORQUES[:2], capacity[:2], rtol=1e-12)
    # the same both ways: the drive is symmetric
    assert safety[2] == pytest.approx(safety[1], rel=1e-9)
    for where, slope, difference, rounding in _slopes_and_differences(values, slopes):
        np.testing.assert_allclose(slope, difference, rtol=2e-5, atol=rounding, err_msg=where)


def _same_as_single_files(values, numbers):
    for index in (0, 1, 2):
        alone = numbers_of(single(values, {"load.output_torque": TORQUES[index]}))
        for name in alone.keys() & numbers.keys():
            np.testing.assert_allclose(numbers[name][:, index], alone[name], rtol=1e-9, err_msg=name)


@pytest.mark.long
def test_size_and_mass_by_hand(values, found):
    _, numbers, _ = found
    density = values["materials"]["52100"]["density"]
    areas = 10e-3**2 + 3.0 * 20e-3**2 + (58e-3**2 - 50e-3**2)
    mass = density * np.pi * areas * 10e-3
    assert numbers["mass"][0, 0] == pytest.approx(mass, rel=1e-12)
    assert numbers["envelope_diameter"][0, 0] == pytest.approx(2 * 58e-3, rel=1e-12)
    # three planets, or five, on an orbit of 30 mm
    gaps = [60e-3 * np.sin(np.pi / count) - 40e-3 for count in PLANETS]
    np.testing.assert_allclose(numbers["clearance"][0], gaps, rtol=1e-12)
    stiffness = numbers["assembly_stiffness_output"][0, :3]
    np.testing.assert_allclose(numbers["assembly_stiffness_per_mass"][0, :3], stiffness / mass, rtol=1e-12)


@pytest.mark.long
def test_slopes_are_differences_of_solutions(values, found):
    compared = list(_slopes_and_differences(values, found[2]))
    assert len(compared) >= 8 * len(VARIABLES)
    for where, slope, difference, rounding in compared:
        np.testing.assert_allclose(slope, difference, rtol=2e-5, atol=rounding, err_msg=where)


def _slopes_and_differences(values, slopes):
    """Every derivative of the second point, and the difference of two solved joints in its place."""
    middle = numbers_of(single(values, {}))
    for index, path in enumerate(VARIABLES):
        value = _at(values, path)
        step = 1e-5 * value
        up, down = (numbers_of(single(values, {path: value + sign * step})) for sign in (1.0, -1.0))
        for name in up.keys() & slopes.keys():
            difference = (np.asarray(up[name]) - np.asarray(down[name])) / (2.0 * step)
            size = np.max(np.abs(np.asarray(middle[name]))) / value
            yield f"{name} {path}", slopes[name][:, 1, index], difference, 1e-6 * size


@pytest.mark.parametrize(
    ("name", "contacts", "bodies"),
    [
        ("multiroller", ["sf", "fsl", "fsr", "sr"], 4),
        ("stepped_planet", ["sp", "pr1", "pr2"], 4),
        ("planar", ["sp", "pwr", "pwl", "wro", "wlo"], 5),
    ],
)
def test_every_type_has_the_results_of_its_own_parts(planar_case, name, contacts, bodies):
    table = results_of(si_values(planar_case(name)))
    assert list(table["slip_ratio"].row_names) == contacts
    assert len(table["body_life"].row_names) == bodies
    if name == "multiroller":
        pairs = (
            "sun_to_second_row",
            "first_row_to_first_row",
            "second_row_to_second_row",
            "first_row_to_ring",
        )
        assert table["clearance"].row_names == pairs
    assert table["standing_limiting_contact"].categories == (*contacts, "none")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "path"),
    [
        ("multiroller", "drive.first_row_radius"),
        pytest.param("stepped_planet", "drive.driven_ring_wall_thickness", marks=pytest.mark.long),
        pytest.param("planar", "contact.2.first_radius", marks=pytest.mark.long),
    ],
)
def test_every_type_can_be_evaluated_at_points(planar_case, name, path):
    values = with_structure(si_values(planar_case(name)))
    names = tuple(results_of(values))

    def at(column):
        return evaluated_points(replace_values(values, {path: column}), (4,), names)

    status, found = jax.eval_shape(at, jax.ShapeDtypeStruct((4,), jnp.float64))
    assert status.shape == (4,)
    shapes = {each: (*row.row_shape, 4) for each, row in results_of(values).items()}
    assert {each: value.shape for each, value in found.items()} == shapes


#: What a program of studies knows of the rims; the safety without a fatigue strength of the library's steel is nan.
RIMS = ("rim_stress", "rim_stress_at_rest", "rim_stress_amplitude", "rim_yield_safety", "rim_fatigue_safety")
WALL = "drive.ring_wall_thickness"


@pytest.mark.long
def test_rims_of_many_joints_are_those_of_single_ones(planar_case):
    """The document of each file; derivatives are differences of two documents; a stress of a thin ring by hand."""
    values = si_values(planar_case("planetary"))
    walls, step = np.array([8e-3, 10e-3]), 1e-6
    status, found, slopes = derivatives_at(values, {WALL: walls}, (*RIMS, "preload"), (WALL,))
    assert status.tolist() == [0, 0]
    ring = results_of(values)["rim_stress"].row_names.index("ring")
    documents = {wall: _rim_entry(values, wall) for wall in (*walls, 8e-3 + step, 8e-3 - step)}
    for name, (key, pick) in {
        "rim_stress": ("stress_Pa", max),
        "rim_stress_at_rest": ("stress_at_rest_Pa", max),
        "rim_stress_amplitude": ("amplitude_Pa", max),
        "rim_yield_safety": ("yield_safety", None),
    }.items():
        alone = {w: e[key] if pick is None else pick(e[key].values()) for w, e in documents.items()}
        np.testing.assert_allclose(
            found[name][ring], [alone[wall] for wall in walls], rtol=1e-8, err_msg=name
        )
        difference = (alone[8e-3 + step] - alone[8e-3 - step]) / (2.0 * step)
        assert slopes[name][ring, 0, 0] == pytest.approx(difference, rel=1e-4), name
        assert np.all(np.isnan(np.delete(found[name], ring, axis=0)))
    assert np.all(np.isnan(found["rim_fatigue_safety"]))
    # three forces P outwards on a thin ring: moment under each P R/2 (1/a - cot a) and tension P/2 cot a, a = 60
    # degrees, at the outer fibre of a curved beam less by t/3R
    force, radius, wall, angle = found["preload"][0, 0], 54e-3, 8e-3, np.pi / 3.0
    moment = 0.5 * force * radius * (1.0 / angle - 1.0 / np.tan(angle))
    bending = 6.0 * moment / (10e-3 * wall**2) * (1.0 - wall / (3.0 * radius))
    tension = 0.5 * force / np.tan(angle) / (10e-3 * wall)
    assert found["rim_stress_at_rest"][ring, 0] == pytest.approx(bending + tension, rel=0.05)


def _rim_entry(values, wall):
    joint = joint_from_values(replace_values(values, {WALL: wall}))
    return joint_document(solved_with_capacities(joint, solve_joint(joint)), inputs={}, assumptions=())[
        "rims"
    ]["ring"]


def test_results_of_drives_with_wedges_are_refused_by_name(values, planar_case):
    table = results_of(values)
    only = {"wedge_angle", "self_locking_ratio", "direction_angle", "polar_angle"}
    named = {name for name, row in RESULTS.items() if row.needs_wedges}
    assert only <= named
    assert set(table) == set(RESULTS) - named
    assert named <= set(results_of(si_values(planar_case("planar"))))
    assert named <= set(results_of(si_values(planar_case("zou2025"))))
    with pytest.raises(InputError, match="no result 'wedge_angle': only one with wedges between planets"):
        chosen_results(["wedge_angle"], table=table)
    with pytest.raises(InputError, match="no result 'wedge_angle': only one with wedges between planets"):
        known_result("wedge_angle", among=tuple(table))
    with pytest.raises(InputError, match="did you mean 'slip_ratio'"):
        chosen_results(["slip_rato"], table=table)
    assert set(chosen_results(["all"], table=table)) == set(GROUPS["all"]) & set(table)
    assert chosen_results(["forces"], table=table) == tuple(n for n in GROUPS["forces"] if n in table)

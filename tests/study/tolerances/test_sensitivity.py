"""Sensitivities against what dimensions demand, against differences, and against closed forms."""

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.any_joint import with_nominal_sizes
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import numeric_keys, si_values
from asperity.joint_file.solved_document import solve_case
from asperity.study.batch import evaluate_points
from asperity.study.tolerances.sensitivity import DEFAULT_RESULTS, FINISHED_PART, ranking, sensitivity
from asperity.unit_table import Dimension

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def homogeneous(joint_text):
    """The paper's joint with the one contact factor whose units cancel: those of (11) do not."""
    return parse_case(
        joint_text.replace('contact_factor = "printed"', 'contact_factor = "unity"'), source="x"
    )


@pytest.fixture(scope="module")
def found(homogeneous):
    return sensitivity(homogeneous)


@pytest.fixture(scope="module")
def of_the_paper(case):
    """By the program that the command's test has, too."""
    return sensitivity(case)


@pytest.mark.long
@pytest.mark.parametrize("base", range(3), ids=["length", "mass", "time"])
def test_elasticities_obey_the_dimensions(homogeneous, found, base):
    # Euler's theorem: in units of another size every result changes by the power of its dimension
    exponents = np.array(
        [entry.key.dimension.exponents[base] for entry in numeric_keys(homogeneous).values()]
    )
    for name in DEFAULT_RESULTS[:4]:
        dimension = Dimension.TORQUE if name == "standing_torque_capacity" else Dimension.TORSIONAL_STIFFNESS
        total = float(found["elasticity"].sel(result=name).values @ exponents)
        assert total == pytest.approx(dimension.exponents[base], abs=1e-9), name


@pytest.mark.long
def test_ratios_are_pure_numbers(homogeneous, found):
    for base in range(3):
        weights = [e.key.dimension.exponents[base] * e.value for e in numeric_keys(homogeneous).values()]
        change = found["derivative"].values @ np.array(weights)
        ratios = [name not in DEFAULT_RESULTS[:4] for name in found["result"].values]
        assert sum(ratios) == 11
        np.testing.assert_allclose(change[ratios], 0.0, atol=1e-9)


@pytest.mark.long
def test_derivatives_are_limits_of_differences(homogeneous, found):
    inputs, tables = numeric_keys(homogeneous), si_values(homogeneous)
    chosen = [path for path, entry in inputs.items() if not entry.key.integer]
    steps = {path: 1e-5 * (abs(inputs[path].value) or 1.0) for path in chosen}
    count = 2 * len(chosen)
    points = {path: np.full(count, inputs[path].value) for path in chosen}
    for k, path in enumerate(chosen):
        points[path][2 * k] += steps[path]
        points[path][2 * k + 1] -= steps[path]
    names = ("assembly_stiffness_output", "published_stiffness_output", "slip_ratio")
    status, values = evaluate_points(tables, points, names)
    assert not status.any()
    for result, value in (
        ("assembly_stiffness_output", values["assembly_stiffness_output"]),
        ("published_stiffness_output", values["published_stiffness_output"]),
        ("slip_ratio_wlo", values["slip_ratio"][4]),
    ):
        for k, path in enumerate(chosen):
            slope = (value[2 * k] - value[2 * k + 1]) / (2.0 * steps[path])
            one = found.sel(result=result, input=path)
            scale = abs(float(one["result_value"]) / steps[path])
            assert float(one["derivative"]) == pytest.approx(slope, rel=2e-5, abs=2e-11 * scale), path


def test_closed_forms(of_the_paper):
    found = of_the_paper
    # self-locking: tan(beta/2)/mu, so d/d(mu) = -tan(beta/2)/mu^2, with beta = 13.1582 deg and mu = 0.12
    slope = float(found["derivative"].sel(result="self_locking_ratio", input="load.friction_coefficient"))
    assert slope == pytest.approx(-np.tan(np.radians(13.1582) / 2.0) / 0.12**2, rel=1e-5)
    # every branch carries its share: capacity is proportional to the number of planets
    assert float(
        found["elasticity"].sel(result="standing_torque_capacity", input="drive.planets")
    ) == pytest.approx(1.0, abs=1e-9)
    # Hertz: p0 ~ sqrt(N E/(R B)); yield strength enters the first yield pressure alone
    pressure = found.sel(result="pressure_over_first_yield_sp")
    ratio = float(pressure["result_value"])
    derivative = float(pressure["derivative"].sel(input="materials.steel.yield_strength"))
    assert derivative * 450e6 == pytest.approx(-ratio, rel=1e-9)


def test_ranking_is_by_influence(of_the_paper):
    ranked = ranking(of_the_paper, "standing_torque_capacity")
    size = np.abs(ranked["elasticity"].values)
    assert np.all(np.diff(size) <= 0.0)
    assert "surface.fractal_dimension" not in ranked["input"].values[:10]
    with pytest.raises(InputError, match="no result"):
        ranking(of_the_paper, "weight")


@pytest.mark.long
def test_a_joint_that_slips_has_no_sensitivities(joint_text):
    with pytest.raises(InputError, match="beyond the standing torque capacity"):
        sensitivity(
            parse_case(joint_text.replace('"5 N*m"', '"50 N*m"').replace('"printed"', '"unity"'), source="x")
        )


@pytest.mark.long
def test_where_all_spots_are_plastic_only_the_stiffness_has_no_sensitivities(joint_text):
    plastic = parse_case(joint_text.replace("fractal_dimension = 1.4", "fractal_dimension = 1.2"), source="x")
    with pytest.raises(
        NoSolutionError, match=r"every spot of sp, pwr, .* is plastic.* raise fractal_dimension"
    ):
        sensitivity(plastic, ("standing_torque_capacity", "assembly_stiffness_output"))
    found = sensitivity(plastic, ("standing_torque_capacity",))
    share = float(
        found["elasticity"].sel(result="standing_torque_capacity", input="surface.fractal_dimension")
    )
    assert share == 0.0


@pytest.mark.long
def test_any_result_with_derivatives_can_be_asked_for(homogeneous):
    # a reduction of R_o/R_s - 1 = 9: d ratio/d R_o = -1/R_s
    found = sensitivity(homogeneous, ("speed_ratio",))
    slope = float(found["derivative"].sel(result="speed_ratio", input="drive.ring_radius"))
    assert slope == pytest.approx(-1.0 / 4e-3, rel=1e-12)
    with pytest.raises(InputError, match="no differentiable result 'limiting_contact'"):
        sensitivity(homogeneous, ("limiting_contact",))


@pytest.mark.long
def test_a_planetary_by_hand(planar_case):
    found = sensitivity(planar_case("planetary"), ("interference", "speed_ratio", "slip_ratio", "mass"))
    derivative, elasticity = found["derivative"], found["elasticity"]
    # the ring follows the rollers, less the interference
    for name in ("drive.sun_radius", "drive.planet_radius"):
        assert derivative.sel(result="interference", input=name).item() == pytest.approx(0.0, abs=1e-9)
    # finished parts in the ring of its nominal radius
    sun, planet = (f"drive.{body}_radius{FINISHED_PART}" for body in ("sun", "planet"))
    assert derivative.sel(result="interference", input=sun).item() == pytest.approx(1.0)
    assert derivative.sel(result="interference", input=planet).item() == pytest.approx(2.0)
    # i = 2 + 2 R_p/R_s
    assert derivative.sel(result="speed_ratio", input="drive.planet_radius").item() == pytest.approx(200.0)
    assert elasticity.sel(result="slip_ratio_sp", input="load.friction_coefficient").item() == pytest.approx(
        -1.0
    )
    assert elasticity.sel(result="mass", input="materials.52100.density").item() == pytest.approx(1.0)
    assert not any(name.startswith("drive.ring_radius") for name in found["input"].values)


@pytest.fixture(scope="module")
def pressed(planar_case):
    """A file of a drive whose preload is made by interference."""

    def of(name):
        by_force = {} if name == "planetary" else {'preload = "1000 N"': 'interference = "13 um"'}
        return planar_case(name, replaced=by_force)

    return of


@pytest.mark.parametrize(
    ("name", "paths"),
    [
        ("planetary", ("drive.sun_radius", "drive.planet_radius")),
        pytest.param(
            "zou2025", ("drive.planet_radius", "drive.loading_roller_radius"), marks=pytest.mark.long
        ),
        pytest.param("planar", ("contact.1.first_radius",), marks=pytest.mark.long),
    ],
)
def test_a_radius_is_that_of_joint_and_sweep_and_a_finished_part_deviates(pressed, name, paths):
    """Two joints with other numbers in the file, and two drives of parts that deviate from the sizes of the file."""
    case = pressed(name)
    results = ("assembly_stiffness_output", "preload", "standing_torque_capacity", "speed_ratio")
    found = sensitivity(case, results)
    tables, keys = si_values(case), numeric_keys(case)
    for path in paths:
        value, step = keys[path].value, 2e-8
        changes = {path: np.array([value - step, value + step])}
        for values, row in ((tables, path), (with_nominal_sizes(tables), f"{path}{FINISHED_PART}")):
            status, ends = evaluate_points(values, changes, results)
            assert not status.any()
            for result in results:
                slope = float(ends[result][1] - ends[result][0]) / (2.0 * step)
                one = found.sel(result=result, input=row)
                scale = abs(float(one["result_value"])) / value
                assert float(one["derivative"]) == pytest.approx(slope, rel=2e-3, abs=1e-4 * scale), row
                share = float(one["derivative"]) * value / float(one["result_value"])
                assert float(one["elasticity"]) == pytest.approx(share, rel=1e-12, abs=1e-12)
    assert str(found["input_name"].sel(input=row).item()).endswith("(finished part)")


def test_a_preload_by_force_has_no_finished_parts(of_the_paper):
    assert not any(name.endswith(FINISHED_PART) for name in of_the_paper["input"].values)


@pytest.mark.long
def test_what_the_command_states_is_the_difference_of_two_joints(planar_case):
    """The stiffness of the planetary with another sun, and another planet, each solved alone."""
    found = sensitivity(planar_case("planetary"), ("assembly_stiffness_output",))
    for body, size in (("sun", 10.0), ("planet", 20.0)):
        stiffness = []
        for radius in (size - 0.001, size + 0.001):
            replaced = {f'{body}_radius = "{size:.0f} mm"': f'{body}_radius = "{radius} mm"'}
            solved, _ = solve_case(planar_case("planetary", replaced=replaced))
            stiffness.append(float(solved.result.assembly.stiffness.output))
        slope = (stiffness[1] - stiffness[0]) / 2e-6
        one = found["derivative"].sel(result="assembly_stiffness_output", input=f"drive.{body}_radius")
        assert one.item() == pytest.approx(slope, rel=1e-3), body

"""Designs against exhaustive search, bisection and closed forms; infeasible ones with their conflict."""

import re
import tomllib

import numpy as np
import pytest
from scipy.optimize import brentq

from asperity.drive.layout.existence import refuse_impossible
from asperity.errors import NoSolutionError
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values
from asperity.results.solved import solved_with_capacities
from asperity.study.batch import derivatives_at, evaluate_points
from asperity.study.design import design as module
from asperity.study.design import design_evaluation
from asperity.study.design.design import design, nominal_results
from asperity.study.design.design_file import design_from_tables, read_design
from asperity.study.design.design_problem import Constraint, Objective
from asperity.study.design.design_result import conflict, shortcoming

#: The steel of the paper yields under its own preload: its designs need leave to.
ALLOWED = {"pressure_over_first_yield": {"at_most": 10.0}, "shakedown_ratio": {"at_most": 10.0}}


def tables_of(text):
    """Tables of a design file that allows damage as far as it does not limit it itself."""
    tables = tomllib.loads(text)
    return tables | {"constraints": ALLOWED | tables.get("constraints", {})}


def run(zou_file, text):
    return design(design_from_tables(tables_of('joint = "zou2025.toml"\n' + text), folder=zou_file.parent))


def result_at(values, name, changes):
    return derivatives_at(values, changes, (name,))[1][name]


@pytest.fixture(scope="module")
def values(zou_file):
    return si_values(parse_case(zou_file.read_text(), source="test"))


@pytest.mark.long
def test_best_dimension_against_exhaustive_search(zou_file, values):
    found = run(
        zou_file,
        'level = "published"\n[variables]\nsurface.fractal_dimension = { lower = 1.2, upper = 1.95 }\n'
        '[objective]\nmaximise = "stiffness"\n[search]\nstarts = 2',
    )
    grid = np.linspace(1.84, 1.86, 201)  # the paper's peak
    stiffness = result_at(values, "published_stiffness_output", {"surface.fractal_dimension": grid})[0]
    assert 0 < np.argmax(stiffness) < grid.size - 1
    assert found.optimum["surface.fractal_dimension"] == pytest.approx(grid[np.argmax(stiffness)], abs=2e-4)
    assert found.objective_after >= stiffness.max() * (1.0 - 1e-3)
    assert found.feasible
    assert found.optimality_residual < 1e-3


@pytest.mark.long
def test_smallest_preload_against_bisection(zou_file, values):
    found = run(
        zou_file,
        '[variables]\nload.preload = { lower = "100 N", upper = "5000 N" }\n[objective]\nminimise = "preload"\n'
        "[constraints]\nslip_ratio = { at_most = 0.8 }\n[search]\nstarts = 2",
    )

    def excess(preload):
        return result_at(values, "slip_ratio", {"load.preload": np.array([preload])}).max() - 0.8

    assert found.optimum["load.preload"] == pytest.approx(brentq(excess, 300.0, 1000.0, xtol=1e-9), rel=1e-6)
    assert (
        found.optimum["load.preload"] <= found.point["load.preload"] <= 1.001 * found.optimum["load.preload"]
    )
    # without the normal forces' small rise: T_sp/(0.8 mu), T_sp = T_out/(9 * 3 R_s)
    assert found.point["load.preload"] == pytest.approx(5.0 / (9 * 3 * 0.004) / (0.8 * 0.12), rel=0.02)
    slip = next(limit for limit in found.limits if limit.name == "slip_ratio")
    assert (slip.row, slip.active) == ("sp", True)
    assert slip.value == pytest.approx(0.8, rel=1e-3)
    assert slip.value <= 0.8 * (1.0 + 1e-7)
    # relaxing the limit by 1 % lowers the preload by nearly 1 %
    assert slip.multiplier == pytest.approx(1.0, rel=0.1)


@pytest.mark.long
def test_a_safety_factor_is_the_reciprocal_limit(zou_file):
    text = '[variables]\nload.preload = {{ lower = "100 N", upper = "5000 N" }}\n[objective]\nminimise = "preload"\n'
    text += "[constraints]\n{limit}\n[search]\nstarts = 1"
    ratio = run(zou_file, text.format(limit="slip_ratio = { at_most = 0.8 }"))
    safety = run(zou_file, text.format(limit="slip_safety = { at_least = 1.25 }"))
    assert safety.optimum["load.preload"] == pytest.approx(ratio.optimum["load.preload"], rel=1e-7)


@pytest.mark.long
def test_limits_of_speed_ratio_and_pressure_against_closed_forms(zou_file):
    found = run(
        zou_file,
        '[variables]\ndrive.sun_radius = { lower = "3 mm", upper = "4.5 mm" }\n'
        'load.preload = { lower = "300 N", upper = "5000 N" }\n[objective]\nmaximise = "preload"\n[constraints]\n'
        'speed_ratio = { at_most = -9.5 }\nhertz_pressure = { at_most = "1500 MPa", contacts = ["sp"] }\n'
        "[search]\nstarts = 2",
    )
    assert found.feasible
    # omega_s/omega_c = -(R_o - R_s)/R_s: the largest sun, which lowers the pressure, has R_s = 40 mm/10.5
    sun = 40e-3 / 10.5
    assert found.optimum["drive.sun_radius"] == pytest.approx(sun, rel=1e-6)
    # Hertz: p0^2 = N E*/(pi B R), with the normal force that the design itself has
    radius = sun * 13.5e-3 / (sun + 13.5e-3)
    force = 1500e6**2 * np.pi * 5e-3 * radius / (206e9 / (2.0 * (1.0 - 0.3**2)))
    normal = nominal_results(found.joint_text, ("normal_force",))["normal_force"]
    assert normal[0] == pytest.approx(force, rel=2e-3)  # as rounded
    assert found.summary_after["speed_ratio"] == pytest.approx(-9.5, rel=1e-3)
    assert found.summary_after["speed_ratio"] <= -9.5 * (1.0 - 1e-7)
    assert found.summary_before["speed_ratio"] == pytest.approx(-9.0, rel=1e-12)
    assert found.summary_before["hertz_pressure"] == pytest.approx(1.53e9, rel=5e-3)  # the model's own figure


@pytest.mark.long
def test_rounded_designs_against_every_combination_of_the_steps(zou_file, values):
    found = run(
        zou_file,
        '[variables]\ndrive.contact_length = { lower = "3 mm", upper = "15 mm", step = "0.75 mm" }\n'
        'load.preload = { lower = "300 N", upper = "3000 N", step = "150 N" }\n[objective]\nmaximise = "stiffness"\n'
        '[constraints]\nmass = { at_most = "1.5 kg" }\npressure_over_first_yield = { at_most = 1.5 }\n'
        "[search]\nstarts = 2",
    )
    length, preload = np.meshgrid(0.75e-3 * np.arange(4, 21), 150.0 * np.arange(2, 21), indexing="ij")
    changes = {"drive.contact_length": length.ravel(), "load.preload": preload.ravel()}
    names = ("assembly_stiffness_output", "mass", "pressure_over_first_yield", "slip_ratio")
    status, grid, _ = derivatives_at(values, changes, names)
    met = (grid["mass"][0] <= 1.5) & (grid["pressure_over_first_yield"].max(axis=0) <= 1.5) & (status == 0)
    best = np.argmax(np.where(met, grid["assembly_stiffness_output"][0], 0.0))
    assert found.point["drive.contact_length"] == pytest.approx(
        changes["drive.contact_length"][best], rel=1e-9
    )
    assert found.point["load.preload"] == pytest.approx(changes["load.preload"][best], rel=1e-9)
    assert found.feasible
    assert found.objective_after == pytest.approx(grid["assembly_stiffness_output"][0, best], rel=1e-9)
    assert found.objective_unrounded > found.objective_after


@pytest.mark.long
def test_written_file_says_what_the_search_saw(zou_file):
    found = run(
        zou_file,
        "[variables]\nsurface.fractal_dimension = { lower = 1.3, upper = 1.9 }\n"
        'load.preload = { lower = "300 N", upper = "3000 N" }\n[objective]\nmaximise = "stiffness"\n'
        "[constraints]\npressure_over_first_yield = { at_most = 1.6 }\n[search]\nstarts = 1",
    )
    names = ("assembly_stiffness_output", "pressure_over_first_yield")
    again = nominal_results(found.joint_text, names)
    assert again["assembly_stiffness_output"][0] == pytest.approx(found.objective_after, rel=1e-12)
    assert again["pressure_over_first_yield"].max() == pytest.approx(1.6, rel=1e-3)
    assert again["pressure_over_first_yield"].max() <= 1.6 * (1.0 + 1e-7)
    assert (
        "Hertz pressure over first yield 1.6" in found.joint_text.splitlines()[1]
    )  # which the limit of 1.6 allows


@pytest.mark.long
def test_worst_case_over_torques_and_tolerances(tmp_path, zou_file):
    (tmp_path / "zou2025.toml").write_text(zou_file.read_text().replace('"1000 N"', '"1000 N +- 50 N"'))
    text = (
        '[variables]\nload.preload = { lower = "100 N", upper = "5000 N" }\n[objective]\nminimise = "preload"\n'
        "[constraints]\nslip_ratio = { at_most = 0.8 }\n[search]\nstarts = 1\n"
        '[worst_case]\ntolerances = "corners"\ntorque = { lower = "0 N*m", upper = "5 N*m", points = 3 }'
    )
    plain = run(zou_file, text.split("[worst_case]")[0])
    robust = run(tmp_path / "zou2025.toml", text)
    # 50 N less must still do; the objective itself is the larger corner
    assert robust.optimum["load.preload"] == pytest.approx(plain.optimum["load.preload"] + 50.0, rel=1e-7)
    assert robust.objective_after == pytest.approx(robust.point["load.preload"] + 50.0, rel=1e-7)


@pytest.mark.long
def test_conflict_is_named_with_its_size(zou_file, values):
    grid = np.linspace(300.0, 400.0, 3)
    best = result_at(values, "assembly_stiffness_output", {"load.preload": grid})[0].max()
    found = run(
        zou_file,
        '[variables]\nload.preload = { lower = "100 N", upper = "3000 N" }\n[objective]\nminimise = "preload"\n'
        "[constraints]\n"
        'stiffness = { at_least = "100000 N*m/rad" }\nslip_ratio = { at_most = 0.8 }\n'
        'preload = { at_most = "600 N" }\n[search]\nstarts = 2',
    )
    assert best < 1e5
    assert not found.feasible
    missed = {limit.name: limit for limit in found.limits if limit.active}
    assert set(missed) == {"assembly_stiffness_output", "preload"}
    # the least violation shares the burden: both limits are missed by the same factor
    factor = missed["preload"].value / 600.0
    assert missed["assembly_stiffness_output"].value == pytest.approx(1e5 / factor, rel=2e-3)
    # each limit is missed by a share of itself, and the largest share is told
    assert missed["preload"].missed_by == pytest.approx(factor - 1.0, rel=1e-9)
    assert missed["assembly_stiffness_output"].missed_by == pytest.approx(1.0 - 1.0 / factor, rel=1e-2)
    assert found.violation == missed["preload"].missed_by
    assert f"misses a limit by {100.0 * (factor - 1.0):.3g} %" in conflict(found)
    assert "These limits conflict: torsional stiffness at the output" in conflict(found)
    assert sum(limit.multiplier for limit in found.limits) == pytest.approx(1.0, rel=1e-6)


IMPOSSIBLE = """[variables]
load.preload = { lower = "300 N", upper = "5000 N" }
drive.loading_roller_radius = { lower = "4.5 mm", upper = "7 mm" }
[objective]
minimise = "envelope_volume"
[constraints]
"""


@pytest.mark.long
def test_the_least_violation_is_a_joint_that_exists(zou_file):
    # a large wedge, which a small loading roller makes, lowers nothing here so much as rollers that overlap would
    found = run(
        zou_file,
        IMPOSSIBLE + "pressure_over_first_yield = { at_most = 0.3 }\nslip_ratio = { at_most = 0.2 }\n"
        'self_locking_ratio = { at_most = 0.1 }\nclearance = { at_least = "0.3 mm" }\n[search]\nstarts = 2',
    )
    assert not found.feasible
    refuse_impossible(joint_from_case(parse_case(found.joint_text, source="designed")).drive)


@pytest.mark.long
def test_without_any_joint_that_exists_there_is_no_design(zou_file):
    with pytest.raises(NoSolutionError, match=r"no joint was found that exists .* slip ratio .* at 80 N"):
        run(
            zou_file,
            IMPOSSIBLE + 'stiffness = { at_least = "10000 N*m/rad" }\n'
            '[worst_case]\ntorque = { lower = "0 N*m", upper = "80 N*m", points = 2 }\n[search]\nstarts = 2',
        )


@pytest.mark.long
def test_a_surface_of_plastic_spots_only_has_no_design(zou_file, tmp_path):
    """At D = 1.2 the contact law has no stiffness."""
    text = zou_file.read_text()
    plastic = tmp_path / "plastic.toml"
    plastic.write_text(re.sub(r"(?m)^fractal_dimension = .*", "fractal_dimension = 1.2", text))
    problem = (
        'joint = "plastic.toml"\n[variables]\n'
        'drive.contact_length = { lower = "4 mm", upper = "6 mm" }\n[objective]\nminimise = "envelope_volume"\n'
        "[constraints]\nslip_ratio = { at_most = 0.9 }\n"
    )
    with pytest.raises(
        NoSolutionError, match=r"no value of .*assembly_stiffness_output.*: every spot of a contact"
    ):
        design(
            design_from_tables(
                tomllib.loads(problem + 'stiffness = { at_least = "1000 N*m/rad" }\n[search]\nstarts = 1'),
                folder=plastic.parent,
            )
        )
    # nor for the volume alone: without creep it is not known whether the surface flows
    with pytest.raises(NoSolutionError, match="no value of shakedown_ratio: every spot of a contact is"):
        design(design_from_tables(tables_of(problem + "[search]\nstarts = 1"), folder=plastic.parent))


@pytest.mark.long
def test_the_lightest_planetary_is_that_of_an_exhaustive_search(zou_file):
    problem = read_design(zou_file.parent / "design_planetary.toml")
    found = design(problem)
    assert found.feasible
    wall, length = (found.point[f"drive.{name}"] for name in ("ring_wall_thickness", "contact_length"))
    # every pair of 41 walls and 15 lengths; the mass of a drive falls with both
    walls, lengths = np.meshgrid(np.linspace(4e-3, 14e-3, 41), np.linspace(6e-3, 20e-3, 15))
    points = {"drive.ring_wall_thickness": walls.ravel(), "drive.contact_length": lengths.ravel()}
    status, at_points = evaluate_points(
        si_values(problem.case), points, ("mass", "slip_ratio", "hertz_pressure")
    )
    allowed = (
        (status == 0)
        & (at_points["slip_ratio"].max(axis=0) <= 0.8)
        & (at_points["hertz_pressure"].max(axis=0) <= 1.4e9)
    )
    best = np.flatnonzero(allowed)[np.argmin(at_points["mass"][allowed])]
    assert found.objective_after <= at_points["mass"][best] * (1.0 + 1e-3)
    assert (wall, length) == pytest.approx(
        (points["drive.ring_wall_thickness"][best], points["drive.contact_length"][best]), abs=0.25e-3
    )
    limits = {(each.name, each.row): each for each in found.limits}
    assert limits["slip_ratio", "sp"].value == pytest.approx(0.8, rel=1e-3)
    assert limits["clearance", "planet_to_planet"].value == pytest.approx(60e-3 * np.sin(np.pi / 3.0) - 40e-3)


@pytest.mark.long
def test_the_lightest_planetary_whose_ring_has_a_stated_safety(tmp_path, zou_file):
    """Its limit is met exactly, by the wall of a thin ring under three forces."""
    joint = zou_file.with_name("planetary.toml").read_text()
    stated = 'interference = "30 um"'
    assert stated in joint
    (tmp_path / "planetary.toml").write_text(joint.replace(stated, 'preload = "850 N"'))
    text = (
        'joint = "planetary.toml"\n[variables]\n"drive.ring_wall_thickness" = { lower = "1.5 mm", upper = "8 mm" }\n'
        '[objective]\nminimise = "mass"\n[constraints]\nrim_yield_safety = { at_least = 2 }\n[search]\nstarts = 1'
    )
    problem = design_from_tables(tomllib.loads(text), folder=tmp_path)
    found = design(problem)
    assert found.feasible
    limit = next(each for each in found.limits if each.name == "rim_yield_safety")
    assert (limit.row, limit.active) == ("ring", True)
    assert 2.0 * (1.0 - 1e-7) <= limit.value < 2.0 * (1.0 + 1e-3)
    solved = parse_case(found.joint_text, source="designed")
    joint = joint_from_case(solved)
    again = solved_with_capacities(joint, solve_joint(joint)).rims
    assert float(again.yield_safety[2]) == pytest.approx(limit.value, rel=1e-9)
    # moment P R/2 (1/a - cot a) under each force, a = 60 degrees; in plane strain
    wall, force, angle = found.point["drive.ring_wall_thickness"], 850.0, np.pi / 3.0
    radius = 50e-3 + 0.5 * wall
    stress = 3.0 * force * radius * (1.0 / angle - 1.0 / np.tan(angle)) / (10e-3 * wall**2)
    stress = stress * (1.0 - wall / (3.0 * radius)) + 0.5 * force / np.tan(angle) / (10e-3 * wall)
    ring = joint.materials[2]
    mises = stress * np.sqrt(1.0 - ring.poisson_ratio + ring.poisson_ratio**2)
    assert float(ring.yield_strength) / mises == pytest.approx(2.0, rel=0.05)


@pytest.fixture
def known(evaluator, monkeypatch):
    """Designs of least mass of the made-up joint: 100 L, pressure 2 MPa sqrt(P/L), slip 50 M/P; the file has 8 mm."""

    def of(*constraints, torques=(), without_stiffness=False, diagnostics=()):
        made = evaluator((Objective("mass", 1.0),), constraints, torques=torques)
        given = design_evaluation.derivatives_at
        stated = {"load.preload": 1000.0, "drive.contact_length": 8e-3, "load.output_torque": 5.0}

        def filled(values, changes, results, paths=(), *, block=64):
            status, found, slopes = given(
                values,
                {path: np.array(each) for path, each in stated.items()} | changes,
                results,
                paths,
                block=block,
            )
            if without_stiffness:
                found["published_stiffness_output"][:] = np.nan
            return status, found, slopes

        monkeypatch.setattr(design_evaluation, "derivatives_at", filled)
        monkeypatch.setattr(module, "derivatives_at", filled)
        monkeypatch.setattr(module, "DesignEvaluator", lambda problem: made)
        told = {"diagnostics": list(diagnostics), "life_hours": None, "no_result_because": None}
        monkeypatch.setattr(module, "joint_diagnostics", lambda text: told)
        return design(made.problem)

    return of


def test_a_design_between_two_limits_by_hand(known):
    """P >= 250/0.8 N and L >= P/62500 m: 312.5 N and 5 mm. The mass goes as p^-2 and as the reciprocal of the slip."""
    seen = known(
        Constraint("hertz_pressure", True, 5e8, (0, 1)),
        Constraint("slip_ratio", True, 0.8, (0, 1)),
        Constraint("clearance", False, 0.0, (0, 1)),
    )
    assert seen.feasible
    assert seen.optimum == pytest.approx({"load.preload": 312.5, "drive.contact_length": 5e-3}, rel=1e-6)
    # four digits, on the side of the limits
    assert seen.point["load.preload"] in (312.5, 312.6)
    assert seen.point["drive.contact_length"] in (5e-3, pytest.approx(5.001e-3), pytest.approx(5.002e-3))
    assert (seen.objective_before, seen.objective_after) == pytest.approx((0.8, 0.5), rel=1e-3)
    assert seen.at_bound == {}
    pressure, slip, clearance = seen.limits
    assert (pressure.value, slip.value) == pytest.approx((5e8, 0.8), rel=1e-3)
    assert pressure.value <= 5e8 * (1.0 + 1e-7)
    assert slip.value <= 0.8 * (1.0 + 1e-7)
    assert (pressure.row, slip.output_torque) == ("sp", 5.0)
    assert (pressure.missed_by, slip.missed_by) == (0.0, 0.0)
    assert (pressure.active, slip.active, clearance.active) == (True, True, False)
    assert (pressure.multiplier, slip.multiplier) == pytest.approx((2.0, 1.0), rel=1e-3)
    assert clearance.multiplier == pytest.approx(0.0, abs=1e-9)
    assert seen.optimality_residual < 1e-4


def test_limits_that_exclude_each_other_are_missed_by_as_little_as_can_be(known):
    """A slip of 0.1 needs 2500 N, 1600 N are the most: 0.15625, which is 56 % too much."""
    seen = known(Constraint("slip_ratio", True, 0.1, (0, 1)))
    assert not seen.feasible
    (slip,) = seen.limits
    assert slip.value == pytest.approx(0.15625, rel=1e-6)
    assert slip.missed_by == pytest.approx(0.5625, rel=1e-5)
    assert slip.active
    assert seen.at_bound["load.preload"] == "upper"


def test_a_limit_without_a_value_is_not_met_and_the_nearest_value_is_told(known):
    """The stiffness 10 P exists below 1000 N, the file has 1000 N; 2e4 N·m/rad are out of reach: 1e4 is nearest."""
    seen = known(Constraint("published_stiffness_output", False, 2e4, (0,)))
    assert not seen.feasible
    assert seen.joint_text.splitlines()[1].startswith("# NOT all limits are met")
    assert not seen.limits[0].met
    assert 0.9e4 < seen.limits[0].value < 1e4
    assert seen.limits[0].nearest == pytest.approx(seen.limits[0].value, rel=0.05)


def test_a_limit_without_a_value_anywhere_is_not_met_and_says_so(known):
    """A stiffness that no joint within the bounds has."""
    seen = known(Constraint("published_stiffness_output", False, 1.0, (0,)), without_stiffness=True)
    assert not seen.feasible
    assert np.isnan(seen.violation)
    assert "asperities alone at least 1 N·m/rad (no value there; no design has one, at 5 N·m)" in conflict(
        seen
    )
    assert "nan" not in conflict(seen)


def test_an_objective_without_a_value_is_no_design(evaluator, monkeypatch):
    made = evaluator(
        (Objective("published_stiffness_output", -1.0),), (Constraint("preload", False, 1100.0, (0,)),)
    )
    with pytest.raises(NoSolutionError, match="no value of published_stiffness_output"):
        module._refuse_without_result(made, made(np.array([0.9, 0.5])))


def test_a_design_from_which_no_search_converged_is_no_optimum(known, monkeypatch):
    monkeypatch.setattr(module, "local_optimum", lambda made, start, fixed=None: (start, False))
    seen = known(Constraint("slip_ratio", True, 0.8, (0, 1)))
    assert seen.feasible
    assert not seen.converged
    assert "no search converged" in shortcoming(seen)
    assert "no optimum" in seen.joint_text.splitlines()[1]


def test_a_joint_that_cannot_exist_is_no_design(known):
    """At 50 N·m the contact slips up to 2500 N."""
    with pytest.raises(NoSolutionError, match=r"1\.562.* at 50 N·m, allowed is at most 1"):
        known(Constraint("slip_ratio", True, 0.8, (0, 1)), torques=(50.0,))


def test_a_limit_is_missed_by_a_share_of_itself_or_where_it_is_zero_by_what_lacks(evaluator):
    """200 N on 5 mm: 0.4 GPa are twice the limit, the clearance is 0.1 mm below none; 50 M/P = 1.25 keeps 1.5."""
    limits = (("hertz_pressure", True, 2e8), ("clearance", False, 0.0), ("slip_ratio", True, 1.5))
    rows = [Constraint(*limit, (0, 1)) for limit in limits] + [Constraint("preload", True, 160.0, (0,))]
    make = evaluator((Objective("mass", 1.0),), rows)
    found = make(make.scaled({"load.preload": 200.0, "drive.contact_length": 5e-3}))
    reports = module._limits(make, found, np.zeros(len(make.rows)), module._tight(make, found))
    assert [report.missed_by for report in reports] == pytest.approx([1.0, 1e-4, 0.0, 0.25], rel=1e-9)
    assert [report.value for report in reports] == pytest.approx([4e8, -1e-4, 1.25, 200.0], rel=1e-9)
    # what is missed the most holds the design back, and rollers that overlap, which cannot exist
    assert [report.active for report in reports] == [True, True, False, False]


def test_a_design_that_cannot_exist_is_refused_with_what_stands_in_the_way(evaluator):
    """A slip of 50 M/P = 1.25 at 200 N is more than friction has; 0.9 misses its limit, but exists."""
    limits = (Constraint("slip_ratio", True, 0.8, (0, 1)), Constraint("preload", True, 160.0, (0,)))
    make = evaluator((Objective("mass", 1.0),), limits)
    slips, holds = (
        make(make.scaled({"load.preload": preload, "drive.contact_length": 5e-3}))
        for preload in (200.0, 250.0 / 0.9)
    )
    with pytest.raises(
        NoSolutionError, match=r"T/\(mu N\) at sp 1\.25 at 5 N·m, allowed is at most 1; widen"
    ):
        module._refuse_what_cannot_exist(make, slips)
    module._refuse_what_cannot_exist(make, holds)

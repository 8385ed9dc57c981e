"""One evaluator for all studies: its points, its derivatives against differences, and the independent baseline."""

import math
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.drive import speed_ratio
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.si_tables import numeric_keys, replace_values, si_values
from asperity.study import batch
from asperity.study.batch import derivatives_at, evaluate_points, numbers, point_kernel

PATHS = ("surface.fractal_dimension", "load.preload", "drive.planet_radius")
POINT = (1.4, 1000.0, 0.0135)
LEVELS = ("published_stiffness_output", "series_with_bulk_stiffness_output", "assembly_stiffness_output")
#: One program for all tests: stiffnesses, and one result of every kind of rows.
NAMES = (
    *LEVELS,
    "assembly_stiffness_per_mass",
    "assembly_stiffness_per_volume",
    "mass",
    "slip_ratio",
    "slip_safety",
    "yield_safety",
    "pressure_over_first_yield",
    "hertz_pressure",
    "normal_force_over_preload",
    "clearance",
    "speed_ratio",
    "asperity_tangential_stiffness",
    "bulk_tangential_stiffness",
)


@pytest.fixture(scope="module")
def values(case):
    return si_values(case)


def changes(point):
    numbers = {path: np.full(2, value) for path, value in zip(PATHS, point, strict=True)}
    return {**numbers, "load.output_torque": np.array([1e-3, 5.0]), "load.sun_speed": np.zeros(2)}


@pytest.mark.long
@pytest.mark.parametrize(
    "path",
    [
        "load.output_torque",
        "surface.fractal_dimension",
        "surface.sp.fractal_roughness",
        "materials.steel.hardness",
        "compliance.pin_stiffness",
    ],
)
def test_every_number_of_a_joint_file_can_vary_alone(values, path):
    table = results_of(values)
    kernel = point_kernel(values, (path,), tuple(table))
    status, found = jax.eval_shape(kernel, numbers(values), jax.ShapeDtypeStruct((7,), jnp.float64))
    assert status.shape == (7,)
    assert {name: value.shape for name, value in found.items()} == {
        name: (*row.row_shape, 7) for name, row in table.items()
    }


@pytest.mark.long
def test_levels_of_stiffness(values):
    thick = {**changes(POINT), "drive.ring_wall_thickness": np.full(2, 0.06)}
    status, found, _ = derivatives_at(values, thick, NAMES)
    assert status.tolist() == [0, 0]
    assert {name: value.shape for name, value in found.items()} == {
        name: (len(results_of(values)[name].row_names), 2) for name in NAMES
    }
    # asperities alone: the baseline in SciPy of benchmarks/, at a small torque, 5.0413e6 N·m/rad
    assert found["published_stiffness_output"][0, 0] == pytest.approx(5.0413e6, rel=2e-4)
    # (25) with the springs of each contact in series, referred to the output by the square of the ratio
    soft = 1.0 / found["asperity_tangential_stiffness"] + 1.0 / found["bulk_tangential_stiffness"]
    sp, pwr, pwl, wro, wlo = 1.0 / soft
    by_hand = 81.0 * 3.0 * 4e-3**2 / (1.0 / sp + 1.0 / (pwr + pwl) + 1.0 / (wro + wlo))
    np.testing.assert_allclose(found["series_with_bulk_stiffness_output"][0], by_hand, rtol=1e-10)
    assert np.all(found["assembly_stiffness_output"] < 0.2 * found["series_with_bulk_stiffness_output"])


@pytest.mark.slow
def test_derived_results_are_what_their_names_say(values):
    _, found, _ = derivatives_at(values, changes(POINT), NAMES)
    stiffness, mass = found["assembly_stiffness_output"], found["mass"]
    np.testing.assert_allclose(found["assembly_stiffness_per_mass"], stiffness / mass, rtol=1e-14)
    # envelope of the paper's joint: outer diameter 2 (40 + 60) mm, length 5 mm
    volume = np.pi / 4.0 * 0.2**2 * 5e-3
    np.testing.assert_allclose(found["assembly_stiffness_per_volume"], stiffness / volume, rtol=1e-12)
    np.testing.assert_allclose(found["slip_safety"], 1.0 / found["slip_ratio"], rtol=1e-14)
    # first yield at 1.67 times the yield strength of 450 MPa, to the digits of that factor
    np.testing.assert_allclose(found["yield_safety"], 1.67 * 450e6 / found["hertz_pressure"], rtol=3e-3)


@pytest.mark.slow
def test_slopes_are_the_derivatives(values):
    # at so large a torque the rounding of a slip ratio is less than what a difference shows
    torque = {"load.output_torque": np.array([1.0, 5.0])}
    _, found, slopes = derivatives_at(values, changes(POINT) | torque, NAMES, PATHS)
    for index, value in enumerate(POINT):
        step = 1e-6 * value
        ends = []
        for sign in (1.0, -1.0):
            moved = list(POINT)
            moved[index] += sign * step
            ends.append(derivatives_at(values, changes(moved) | torque, NAMES)[1])
        for name in NAMES:
            difference = (ends[0][name] - ends[1][name]) / (2.0 * step)
            scale = np.abs(found[name]).max() / value
            assert slopes[name][..., index] == pytest.approx(difference, rel=1e-5, abs=1e-7 * scale), name


@pytest.mark.long
@pytest.mark.parametrize(
    "results",
    [
        ("assembly_stiffness_output",),
        ("torque_capacity",),
    ],
)
def test_derivatives_in_reverse_are_those_forwards(planar_case, monkeypatch, results):
    case = planar_case("planetary")
    tables, numeric = si_values(case), numeric_keys(case)
    paths = (
        "load.output_torque",
        "drive.ring_wall_thickness",
        "drive.sun_radius",
        "surface.fractal_dimension",
    )
    point = {"load.output_torque": np.array([4.0, 8.0])}
    point |= {path: np.full(2, numeric[path].value) for path in paths[1:]}
    monkeypatch.setattr(batch, "_REVERSE_BLOCKS", 0)
    backwards = derivatives_at(tables, point, results, paths, block=4)
    monkeypatch.setattr(batch, "_REVERSE_BLOCKS", 100)
    forwards = derivatives_at(tables, point, results, paths, block=4)
    for name in results:
        assert backwards[1][name] == pytest.approx(forwards[1][name], rel=1e-12)
        assert backwards[2][name] == pytest.approx(forwards[2][name], rel=1e-9, abs=1e-9)
        assert np.count_nonzero(forwards[2][name]) >= 6


@pytest.mark.long
def test_both_ways_give_the_same_numbers_where_the_joint_exists(values):
    torque = {"load.output_torque": np.array([0.0, 5.0, 20.0])}
    names = ("assembly_stiffness_output", "slip_ratio", "clearance")
    status, found = evaluate_points(values, torque, names)
    again, raw, _ = derivatives_at(values, torque, NAMES)
    assert status.tolist() == again.tolist() == [0, 0, STATUS_NAMES.index("beyond_standing_capacity")]
    assert np.isnan(found["assembly_stiffness_output"][2])
    assert np.isfinite(found["slip_ratio"]).all()  # still meaningful where a contact slips
    for name in names:
        np.testing.assert_allclose(
            np.atleast_2d(found[name])[:, :2], raw[name][:, :2], rtol=1e-9, atol=1e-15, err_msg=name
        )  # without torque the ratio of slip is rounding


@pytest.mark.slow
def test_optimised_points_are_those_of_the_quick_program(values):
    """Where only what varies is an array, and where all numbers are."""
    points = {"load.output_torque": np.array([0.0, 5.0, 20.0])}
    names = ("published_stiffness_output", "normal_force", "slip_ratio")
    quick, optimised = (
        evaluate_points(values, points, names, in_all=count) for count in (3, batch.QUICK_POINTS + 1)
    )
    assert (
        quick[0].tolist() == optimised[0].tolist() == [0, 0, STATUS_NAMES.index("beyond_standing_capacity")]
    )
    for name in names:
        np.testing.assert_allclose(quick[1][name], optimised[1][name], rtol=1e-9, atol=1e-15, err_msg=name)
    assert np.isnan(quick[1]["published_stiffness_output"]).tolist() == [False, False, True]


def test_one_program_serves_any_numbers_of_few_points(values, monkeypatch):
    asked = set()

    def program_of(function, table, options):
        asked.add((function, table.shape, options))
        return lambda table: (np.zeros(table.shape[1], dtype=np.int8), {"mass": table[0]})

    monkeypatch.setattr(batch, "program_for_few", program_of)
    for path, points in (("load.preload", 1), ("drive.planets", 2), ("drive.sun_radius", 64)):
        status, _ = evaluate_points(values, {path: np.full(points, 4.0)}, ("mass",))
        assert status.shape == (points,)
    assert len(asked) == 1


def test_programs_run_one_at_a_time(values, monkeypatch):
    """Two threads of a Dask worker, say; on two cores XLA's LAPACK would wait for itself for ever."""
    running, most, name = [], [], "assembly_stiffness_output"

    def program(table):
        running.append(table)
        most.append(len(running))
        time.sleep(0.02)
        running.pop()
        return np.zeros(table.shape[1], dtype=np.int8), {name: table[preload]}

    preload = numbers(replace_values(values, {"load.preload": 0.5})).index(0.5)
    monkeypatch.setattr(batch, "program_for_few", lambda *_, **__: program)
    points = {"load.preload": np.array([900.0, 1000.0])}
    with ThreadPoolExecutor(2) as pool:
        many = {"in_all": batch.QUICK_POINTS}
        found = list(pool.map(lambda _: evaluate_points(values, points, (name,), **many), range(2)))
    assert max(most) == 1
    np.testing.assert_array_equal(found[1][1][name], [900.0, 1000.0])


def _placed(values, monkeypatch, program, *, size=2, **options):
    """What a program of blocks of points makes of five numbers."""
    monkeypatch.setattr(batch, "_program", lambda *_: program)
    preload = np.array([900.0, 910.0, 920.0, 930.0, 940.0])
    name, options = "assembly_stiffness_output", {"in_all": batch.QUICK_POINTS + 1, "batch": size} | options
    found = evaluate_points(values, {"load.preload": preload}, (name,), **options)
    return preload, found[1][name]


def test_blocks_of_an_optimised_program_run_side_by_side_and_stay_in_order(values, monkeypatch):
    both = threading.Barrier(2, timeout=60.0)  # an error if no second thread comes

    def program(base, column):
        if column[0] < 940.0:
            both.wait()
        return jnp.zeros(column.shape, dtype=jnp.int8), {"assembly_stiffness_output": 2.0 * column}

    done = []
    preload, found = _placed(values, monkeypatch, program, threads=2, report=done.append)
    np.testing.assert_array_equal(found, 2.0 * preload)
    assert done == [2, 2, 1]


def test_one_thread_is_that_of_the_caller(values, monkeypatch):
    def program(base, column):
        assert threading.current_thread() is threading.main_thread()
        return jnp.zeros(column.shape, dtype=jnp.int8), {"assembly_stiffness_output": 2.0 * column}

    preload, found = _placed(values, monkeypatch, program, threads=1)
    np.testing.assert_array_equal(found, 2.0 * preload)


def test_blocks_that_have_not_begun_are_left_out_after_an_interruption(values, monkeypatch):
    begun, interrupted = [], threading.Event()

    def program(base, column):
        begun.append(column[0])
        if len(begun) > 1:
            interrupted.wait(60.0)
        return jnp.zeros(column.shape, dtype=jnp.int8), {"assembly_stiffness_output": column}

    def interrupt(count):
        raise KeyboardInterrupt

    class Pool(ThreadPoolExecutor):
        def shutdown(self, wait=True):
            interrupted.set()
            super().shutdown(wait)

    monkeypatch.setattr(batch, "ThreadPoolExecutor", Pool)
    with pytest.raises(KeyboardInterrupt):
        _placed(values, monkeypatch, program, size=1, threads=2, report=interrupt)
    assert 900.0 in begun
    assert len(begun) <= 3  # of five: the first, and one in each thread


@pytest.mark.parametrize(("asked", "size", "done"), [(None, 8, [5]), (2, 2, [2, 2, 1]), (3, 4, [4, 1])])
def test_points_are_evaluated_in_blocks_of_a_power_of_two(values, monkeypatch, asked, size, done):
    name, sizes, optimised = "assembly_stiffness_output", [], []
    row = numbers(replace_values(values, {"load.preload": 0.5})).index(0.5)

    def quick(function, table, options):
        sizes.append(table.shape[1])
        return lambda table: (np.zeros(table.shape[1], dtype=np.int8), {name: 2.0 * table[row]})

    def optimised_program(structure, paths, results, block):
        optimised.append(block)
        return lambda base, column: (np.zeros(block, dtype=np.int8), {name: column})

    monkeypatch.setattr(batch, "program_for_few", quick)
    monkeypatch.setattr(batch, "_program", optimised_program)
    preload, reported = np.array([900.0, 910.0, 920.0, 930.0, 940.0]), []
    points = {"load.preload": preload}
    monkeypatch.setattr(batch, "_FEWEST", 1)
    status, found = evaluate_points(values, points, (name,), batch=asked, report=reported.append)
    np.testing.assert_array_equal(status, 0)
    np.testing.assert_array_equal(found[name], 2.0 * preload)
    assert (set(sizes), reported, optimised) == ({size}, done, [])
    evaluate_points(values, {"load.preload": np.full(batch.QUICK_POINTS + 1, 900.0)}, (name,))
    assert optimised == [batch.BATCH]


def test_blocks_of_derivatives_are_put_together(monkeypatch):
    """Five points in blocks of two: the last one is filled up, and what fills it up is left out."""
    blocks = []

    def run(function, *tables, options):
        blocks.append([table.shape for table in tables])
        return lambda *given: (3.0 * given[0][0], given[1])

    monkeypatch.setattr(batch, "program_for_few", run)
    table, directions = np.arange(5.0)[None], np.arange(10.0).reshape(2, 5)
    first, second = batch._blockwise(None, (), 2, table, directions)
    np.testing.assert_array_equal(first, 3.0 * np.arange(5.0))
    np.testing.assert_array_equal(second, directions)
    assert blocks == 3 * [[(1, 2), (2, 2)]]


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "roller"),
    [
        ("planetary", "planet"),
        ("multiroller", "second_row"),
    ],
)
def test_bending_of_pins_by_the_balance_of_the_carrier(planar_case, name, roller):
    """Pins carry what output and input leave to the carrier, and bend by F (2 l - b)/8."""
    pins = '[bearings]\npin_diameter = "4 mm"\npin_length = "24 mm"\n\n[model]'
    case = planar_case(name, replaced={"[model]": pins})
    joint = joint_from_case(case)
    drive, ratio = joint.drive, float(speed_ratio(joint.drive))
    torque = 10.0 if drive.output == "carrier" else 10.0 * abs(1.0 - 1.0 / ratio)
    (body,) = drive.pinned
    force = torque / (float(drive.sectors) * math.hypot(*drive.centres[body]))
    length, lines = 24e-3, {"planet": 10e-3, "second_row": 20e-3}[roller]
    point = {"bearings.pin_length": np.array([length, 0.9 * lines]), "load.sun_speed": np.zeros(2)}
    moments, variables = ("pin_bending_moment", "pin_bending_stress"), ("bearings.pin_length",)
    status, found, slopes = derivatives_at(si_values(case), point, moments, variables)
    assert [STATUS_NAMES[each] for each in status] == ["solved", "pin_too_short"]
    expected = force * (2.0 * length - lines) / 8.0
    assert found["pin_bending_moment"][0, 0] == pytest.approx(expected, rel=1e-3)
    assert slopes["pin_bending_moment"][0, 0, 0] == pytest.approx(force / 4.0, rel=1e-3)
    assert found["pin_bending_stress"][0, 0] == pytest.approx(expected * 32.0 / (math.pi * 4e-3**3), rel=1e-3)


@pytest.mark.parametrize(
    ("platform", "memory", "points"),
    [
        ("cpu", None, 1024),
        ("gpu", {"bytes_limit": 80 * 2**30}, 2**19),
        ("gpu", {"bytes_limit": 8 * 2**30}, 2**17),
        ("gpu", {"bytes_limit": 2**20}, 1024),
        ("gpu", None, 1024),
    ],
)
def test_the_points_of_a_call_follow_the_device_and_its_memory(platform, memory, points):
    """64 KiB a point; what a device does not say about its memory is not assumed."""
    device = SimpleNamespace(platform=platform, memory_stats=lambda: memory)
    assert batch.points_at_once(device) == points


def test_points_are_sent_to_a_device_as_many_as_it_takes(values, monkeypatch):
    sizes = []

    def program(structure, paths, results, block):
        sizes.append(block)
        return lambda base, column: (np.zeros(block, dtype=np.int8), {"assembly_stiffness_output": column})

    monkeypatch.setattr(batch, "_program", program)
    monkeypatch.setattr(batch, "points_at_once", lambda: 2**15)
    preload = np.linspace(900.0, 1100.0, batch.QUICK_POINTS + 20_000)
    _, found = evaluate_points(values, {"load.preload": preload}, ("assembly_stiffness_output",), threads=1)
    assert sizes == [2**15]
    np.testing.assert_array_equal(found["assembly_stiffness_output"], preload)

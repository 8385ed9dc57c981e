"""The window of a joint: where it ends, whether loads lie inside, and parts within their tolerances."""

from pathlib import Path

import numpy as np
import pytest
import windows

import asperity
from asperity.joint_file.window import joint_window
from asperity.results.limit_torques import LIMITS
from asperity.results.torque_capacity import torque_capacity_document
from asperity.results.window import stretches

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def wheels():
    return asperity.load(EXAMPLES / "wheel_pair.toml")


@pytest.fixture(scope="module")
def judged(wheels):
    """A drive with a duty in both directions, a load that stands, a housing, and tolerances of its planets."""
    joint = wheels.edited(windows.housed(radius="20 mm +- 1 um", duty=windows.DUTY))
    return joint, joint_window(joint.case, start=40.0, stop=60.0, points=3)


def test_stretches_are_runs_of_what_holds():
    assert stretches(np.array([True, True, False, True, False])) == [(0, 1), (3, 3)]
    assert stretches(np.array([False, False])) == []


def test_loads_lie_inside_below_the_border(wheels):
    """2 N·m of the file, which a force of about 635 N passes."""
    window = joint_window(wheels.case, start=500.0, stop=1000.0, points=3)
    (load,), (region,) = window.loads, window.regions
    assert np.array_equal(load.inside, region.capacity.torque > 2.0)
    ((first, last),) = window.allowed()
    assert last == window.at.size - 1
    # a straight line, as the capacity of these wheels is one, between the places asked for
    ends = np.interp(2.0, region.capacity.torque[window.asked], window.at[window.asked])
    assert window.at[first - 1] <= ends <= window.at[first]
    assert window.at[first] - window.at[first - 1] < 500.0 / 2 / 50


@pytest.mark.slow
def test_both_borders_agree_where_another_limit_governs():
    """Of the paper's drive first slip, then yield: at the place between, both torques are nearly the same."""
    joint = asperity.load(EXAMPLES / "zou2025.toml")
    window = joint_window(joint.case, start=200.0, stop=260.0, points=7)
    capacity = window.regions[0].capacity
    codes = [LIMITS[code] for code in capacity.limit]
    change = codes.index("pressure_over_first_yield")
    assert codes[change - 1] == "rolling_gross_slip"
    assert window.at[change] - window.at[change - 1] < 0.2
    slope = capacity.torque[change - 1] / window.at[change - 1]
    assert capacity.torque[change] == pytest.approx(capacity.torque[change - 1], abs=5.0 * slope)
    assert np.all(np.diff(capacity.torque[:change]) > 0.0)
    assert np.all(np.diff(capacity.torque[change:]) <= 0.0)


@pytest.mark.slow
def test_a_window_closes_where_the_joint_loses_what_holds_it(judged):
    """The seat is lost at the temperature that the solved joint states; by another search."""
    joint, window = judged
    (seat,) = [limit for limit in joint.solve()._solved.temperature_limits if limit.lost == "seat"]
    for region in window.regions:
        closed = region.capacity.torque == 0.0
        assert window.at[closed][0] < seat.temperature + 0.5
        assert np.all(closed[window.at > seat.temperature])


@pytest.mark.slow
def test_a_reverse_load_has_a_region_of_its_own(judged):
    joint, window = judged
    assert [region.sign for region in window.regions] == [1.0, -1.0]
    assert [load.load.name for load in window.loads] == [
        "output torque of the file",
        *(f"load {number} of the duty" for number in (1, 2, 3)),
    ]
    # at its own speed: the capacity of the joint of a file with that torque and speed
    backwards = {"load.output_torque": "-9 N*m", "load.sun_speed": "600 rpm"}
    alone = torque_capacity_document(joint.with_values(backwards).solve()._solved)["reverse"]
    found = window.loads[2].capacity.torque[window.working]
    assert found == pytest.approx(alone["output_torque_Nm"], rel=1e-12)


@pytest.mark.slow
def test_a_load_that_stands_has_no_limits_of_rolling(judged):
    _, window = judged
    names = {LIMITS[code] for code in window.loads[3].capacity.limit}
    assert not any(name.startswith("rolling_") or name == "shakedown_ratio" for name in names)


def test_tolerances_are_the_windows_of_both_ends(wheels):
    """A force of 1000 N +- 50 N: the least capacity is that of 950 N, the greatest that of 1050 N."""
    text = (EXAMPLES / "wheel_pair.toml").read_text().replace('"1000 N"', '"1000 N +- 50 N"')
    window = joint_window(wheels.edited(text).case, start=1000.0, stop=1100.0, points=2)
    ends = joint_window(wheels.case, start=950.0, stop=1050.0, points=2)
    (region,) = window.regions
    assert region.least is not None
    of = ends.regions[0].capacity.torque
    assert region.least[window.working] == pytest.approx(of[ends.at == 950.0][0], rel=1e-12)
    assert region.greatest[window.working] == pytest.approx(of[ends.at == 1050.0][0], rel=1e-12)


@pytest.mark.slow
def test_larger_planets_press_more_and_pass_more(judged):
    """A micrometre of every planet, as large as files may state it: the joint of a file that is finished so."""
    _, window = judged
    region = window.regions[0]
    slips = np.array([LIMITS[code].endswith("gross_slip") for code in region.capacity.limit])
    assert slips.any()
    assert np.all(region.least[slips] < region.capacity.torque[slips])
    assert np.all(region.greatest[slips] >= region.capacity.torque[slips])
    assert np.all(window.loads[0].surely_inside <= window.loads[0].inside)

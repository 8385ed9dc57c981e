"""The torque capacity: below it every limit of function and damage is kept, beyond it one is not, whatever it is."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.errors import AsperityError
from asperity.joint_file.si_tables import si_values
from asperity.joint_file.solved_document import document_of, solved_case
from asperity.results import RESULTS
from asperity.results.all_limits import further_checks
from asperity.results.margins import margins
from asperity.results.solved import SolvedJoint
from asperity.results.torque_capacity import (
    CAPACITY_LIMITS,
    FOUND_BY_SEARCH,
    JUDGED,
    JUDGED_ROWS,
    OF_TEMPERATURE,
    JointCapacity,
    capacity_of_direction,
    capacity_words,
    excesses_of_rows,
    place_names,
    torque_capacities,
    torque_capacity_document,
    torque_safety,
)
from asperity.study.batch import derivatives_at, evaluate_points

pytestmark = pytest.mark.slow  # whole joints, solved at several torques

#: Sizes of the planetary example as a drive of 153 mm, pressed together by a loading cam.
SCALE, CAM, PRELOAD = 1.32, 60.0, 300.0
OF_153_MM = {
    'sun_radius = "10 mm"': 'sun_radius = "13.2 mm"',
    'planet_radius = "20 mm"': 'planet_radius = "26.4 mm"',
    'ring_wall_thickness = "8 mm"': 'ring_wall_thickness = "10.56 mm"',
    'contact_length = "10 mm"': 'contact_length = "13.2 mm"',
    'interference = "30 um"': f'preload = "{PRELOAD:g} N"\ncam_force_per_torque = "{CAM:g} N/Nm"',
}
#: The same held by a housing, so that a contact yields first; and of a steel that yields before it breaks by fatigue.
HELD = OF_153_MM | {'ring_support = "free"': 'ring_support = "rigid_housing"'}
THIN_RING = OF_153_MM | {
    'ring_wall_thickness = "8 mm"': 'ring_wall_thickness = "7 mm"',
    'ring = "52100"': 'ring = "17-4PH"',
}
RATED = '\n[pin_bearing]\ntype = "roller"\ndynamic_rating = "8 kN"\nstatic_rating = "100 N"\ncount = 1\n[compliance]'
DUTY = '\n[[duty]]\noutput_torque = "11 N*m"\nsun_speed = "1500 rpm"\nshare = 1.0\n'


@pytest.fixture(scope="module")
def cam_case(planar_case):
    return planar_case("planetary", replaced=HELD)


@pytest.fixture(scope="module")
def with_cam(cam_case):
    return solved_case(cam_case)


@pytest.fixture(scope="module")
def bending(planar_case):
    """The same with a ring that carries itself."""
    return solved_case(planar_case("planetary", replaced=OF_153_MM))


def test_the_capacity_of_a_loading_cam_ends_where_a_contact_yields(with_cam):
    """Hertz by hand: p_0 = sqrt(N E*/(pi L R)) is first yield under 39 kN at the sun, that is 0.6 kN·m from the cam.

    The contacts never slip: the search for slip goes on to three times that torque, where the wall is too thin for it.
    """
    modulus = 203e9 / (2.0 * (1.0 - 0.29**2))
    radius = 1.0 / (1.0 / 13.2e-3 + 1.0 / 26.4e-3)
    force = math.pi * 13.2e-3 * radius * (1.67 * 2034e6) ** 2 / modulus
    by_hand = (force - PRELOAD) / CAM
    for reverse in (False, True):
        found = torque_capacity_document(with_cam)
        found = found["reverse"] if reverse else found
        assert found["output_torque_Nm"] == pytest.approx(by_hand, rel=2e-3)
        assert (found["limit"], found["limiting_place"]) == ("pressure_over_first_yield", "sp")
        assert found["meaning"] == "contact sp beyond first yield, standing"
        assert not found["is_lower_bound"]
    assert float(with_cam.standing_capacity.output_torque) > 3.0 * by_hand


def test_a_ring_that_carries_itself_ends_it_before(bending):
    """Bent by three forces it breaks by fatigue; its safety falls with the force, which the torque makes."""
    found = torque_capacity_document(bending)
    assert (found["limit"], found["limiting_place"]) == ("rim_fatigue_safety", "ring")
    assert found["meaning"] == "ring breaks by fatigue at a rim, in rolling"
    torque, safety = float(bending.joint.output_torque), float(np.asarray(bending.rims.fatigue_safety)[-1])
    by_hand = (safety * (PRELOAD + CAM * torque) - PRELOAD) / CAM
    assert found["output_torque_Nm"] == pytest.approx(by_hand, rel=0.02)


def kept(case, torque):
    """Whether a joint under a torque keeps every limit of function and damage; not where it has no solution."""
    stated = dataclasses.replace(case.load.output_torque, value=torque, text=f"{torque!r} N*m")
    load = case.load.model_copy(update={"output_torque": stated})
    try:
        solved = solved_case(case.model_copy(update={"load": load}))
    except AsperityError:
        return False
    judged = [each for each in margins(solved) if each.severity in JUDGED]
    return all(each.passes for each in judged if each.result.name not in ("torque_safety", "loss_share"))


@pytest.mark.parametrize(
    ("name", "replaced", "limits"),
    [
        ("planetary", HELD, ("pressure_over_first_yield",) * 2),
        ("planetary", OF_153_MM, ("rim_fatigue_safety",) * 2),
        ("planetary", THIN_RING, ("rim_yield_safety",) * 2),
        ("planetary", {}, ("rolling_gross_slip", "gross_slip")),
        ("planar", {}, ("gross_slip",) * 2),
        pytest.param("multiroller", {}, ("rolling_gross_slip", "gross_slip"), marks=pytest.mark.long),
    ],
)
def test_below_it_every_limit_is_kept_and_beyond_it_one_is_not(planar_case, name, replaced, limits):
    case = planar_case(name, replaced=replaced)
    both = torque_capacities(solved_case(case))
    assert tuple(CAPACITY_LIMITS[int(code)] for code in both.limit) == limits
    for sign, capacity in zip((1.0, -1.0), both.output_torque, strict=True):
        assert kept(case, sign * float(capacity) * (1.0 - 1e-6))
        assert not kept(case, sign * float(capacity) * (1.0 + 1e-6))


def test_a_limit_that_is_crossed_without_torque_leaves_no_capacity(solved_example):
    """The paper's joint: p_0 = 1530 MPa under its preload, first yield of its steel 1.67 times 450 MPa = 752 MPa."""
    found = torque_capacity_document(solved_example)
    assert found["output_torque_Nm"] == found["reverse"]["output_torque_Nm"] == 0.0
    assert found["meaning"] == "contact sp beyond first yield without torque"
    assert float(torque_safety(solved_example)) == 0.0
    # what it passes all the same is a result of its own
    assert float(solved_example.standing_capacity.output_torque) == pytest.approx(12.96, rel=0.05)


def test_a_bearing_limits_the_torque_but_its_duty_does_not(planar_case):
    """The planet's pin carries 2 T/(n orbit), as the ring's contact passes half of it: 100 N at 9 N·m."""
    rated = {"# Springs of the structure": RATED.removesuffix("[compliance]") + "# Springs of the structure"}
    by_hand = 100.0 * 3.0 * 0.03
    for duty in ("", DUTY):
        replaced = rated | {"[lubrication]": f"{duty}[lubrication]"}
        solved = solved_case(planar_case("planetary", replaced=replaced | {'"10 N*m"': '"8 N*m"'}))
        found = torque_capacity_document(solved)
        assert found["output_torque_Nm"] == pytest.approx(by_hand, rel=1e-6)
        assert found["meaning"] == "bearing planet pin beyond its static rating, in rolling"
        assert found["limiting_place"] == "planet_pin_bearing"


def test_every_judged_result_limits_the_capacity_or_says_why_not():
    """A new limit of function or damage is in the capacity without being listed anywhere."""
    judged = {row.name for row in RESULTS.values() if row.limit and row.limit.severity in JUDGED}
    assert judged == {row.name for row in JUDGED_ROWS} | set(FOUND_BY_SEARCH) | set(OF_TEMPERATURE)
    assert set(FOUND_BY_SEARCH.values()) <= set(CAPACITY_LIMITS)


@pytest.mark.parametrize("name", ["duty_life", "drive_life"])
def test_what_is_judged_beside_the_rows_is_no_matter_of_the_largest_torque(name, planetary, planar_case):
    """Lives count the hours under a load, and the loads of a duty are their own; the table has no other limits."""
    changed = {"# required_life": "required_life", "# [rolling]": "[rolling]"}
    changed |= {"[lubrication]": f"{DUTY}[lubrication]"} if name == "duty_life" else {}
    solved = solved_case(planar_case("planetary", replaced=changed))
    beside = {check.result.name for check in further_checks(solved)}
    assert f"required_{name}" in beside
    assert all(check.startswith(("required_", "duty_")) for check in beside)


def test_the_document_has_both_capacities(planetary, planar_case):
    case = planar_case("planetary")
    solved = solved_case(case)
    document = document_of(case, solved)
    capacity, standing = document["torque_capacity"], document["standing_torque_capacity"]
    assert capacity["output_torque_Nm"] == document["rolling"]["torque_capacity_Nm"]
    assert (capacity["limit"], capacity["state"]) == ("rolling_gross_slip", "in rolling")
    assert capacity["meaning"] == "contact sp slips, in rolling"
    assert standing["limit"] == "gross_slip"
    assert standing["output_torque_Nm"] > capacity["output_torque_Nm"]
    assert capacity["reverse"]["meaning"] == "contact sp slips, standing"


def test_places_have_names_of_their_own(with_cam):
    names = place_names(with_cam)
    assert len(set(names)) == len(names)
    assert names[:2] == with_cam.result.contact_names
    assert names[-1] == "none"
    assert RESULTS["limiting_place"].categories[-1] == "none"


@pytest.mark.parametrize(
    ("limit", "torque", "said"),
    [
        ("none", math.inf, "no limit is reached at any torque"),
        ("lift_off", 3.0, "contact pr lifts off, standing"),
        ("rolling_lift_off", 3.0, "contact pr lifts off, in rolling"),
        ("rolling_gross_slip", 0.0, "contact pr slips without torque"),
        ("rolling_no_solution", 3.0, "no steady rolling is found"),
        ("rolling_no_solution", 0.0, "no steady rolling is found without torque"),
        ("shakedown_ratio", 3.0, "contact pr above its shakedown limit, in rolling"),
    ],
)
def test_every_limit_has_words(with_cam, limit, torque, said):
    capacity = JointCapacity(np.asarray(torque), np.asarray(CAPACITY_LIMITS.index(limit)), np.asarray(1))
    assert capacity_words(with_cam, capacity) == said


def test_by_how_much_rows_exceed_their_limits(bending):
    """The pressure at both contacts and shakedown as ratios, the ring's safeties inverse."""
    found = excesses_of_rows(bending)
    diagnostics = np.asarray(bending.result.diagnostics.pressure_over_first_yield)
    np.testing.assert_allclose(found[:2], diagnostics - 1.0, rtol=1e-12)
    safeties = [np.asarray(getattr(bending.rims, name))[-1] for name in ("yield_safety", "fatigue_safety")]
    assert found[-2:] == pytest.approx([1.0 / safety - 1.0 for safety in safeties], rel=1e-12)
    assert not np.any(found >= 0.0)


def test_the_safety_of_the_torque_is_that_in_its_direction(with_cam):
    capacity = capacity_of_direction(with_cam)
    torque = float(with_cam.joint.output_torque)
    assert torque_safety(with_cam) == pytest.approx(float(capacity.output_torque) / torque, rel=1e-12)


def test_a_joint_without_judged_rows_slips(monkeypatch, with_cam):
    """Where no row is judged the capacity is that of the search, whose lower bound is said to be one."""
    from asperity.results import torque_capacity as module

    monkeypatch.setattr(module, "_rows_of", lambda solved, rows: [])
    bare = SolvedJoint(with_cam.joint, with_cam.result, with_cam.laws)
    bare.solution = with_cam.solution
    found = torque_capacity_document(bare)
    assert found["is_lower_bound"]
    assert found["limit"] in ("wall_too_thin", "contact_too_wide")
    assert found["meaning"].endswith("standing; the joint may carry more")


def test_in_a_batch_it_is_that_of_single_joints(cam_case, with_cam):
    """Cam forces of 60 and of 5 N per N·m, the latter too weak to keep the contacts from slip, and without torque."""
    changes = {
        "load.cam_force_per_torque": np.array([CAM, 5.0, CAM]),
        "load.output_torque": np.array([10.0, -9.0, 0.0]),
    }
    names = (
        "torque_capacity",
        "reverse_torque_capacity",
        "capacity_limit",
        "limiting_place",
        "torque_safety",
    )
    _, found = evaluate_points(si_values(cam_case), changes, names)
    expected = torque_capacities(with_cam)
    for k in (0, 2):
        np.testing.assert_allclose(found["torque_capacity"][k], expected.output_torque[0], rtol=1e-9)
        np.testing.assert_allclose(found["reverse_torque_capacity"][k], expected.output_torque[1], rtol=1e-9)
        assert (found["capacity_limit"][k], found["limiting_place"][k]) == (
            expected.limit[0],
            expected.place[0],
        )
    # backwards 3 planets on an orbit of 39.6 mm slip standing: mu N = T/(6 orbit), N = N_0 + 5 T
    by_hand = 0.08 * PRELOAD / (1.0 / (6.0 * 39.6e-3) - 0.08 * 5.0)
    assert found["reverse_torque_capacity"][1] == pytest.approx(by_hand, rel=0.03)
    # forwards it slips in rolling, where the oil takes a part of it
    assert CAPACITY_LIMITS[int(found["capacity_limit"][1])] == "rolling_gross_slip"
    assert found["torque_capacity"][1] < found["reverse_torque_capacity"][1]
    safety = found["torque_safety"]
    assert safety[0] == pytest.approx(found["torque_capacity"][0] / 10.0, rel=1e-12)
    assert safety[1] == pytest.approx(found["reverse_torque_capacity"][1] / 9.0, rel=1e-12)
    assert safety[2] == math.inf


@pytest.mark.long
def test_its_derivative_is_that_of_the_limit(cam_case):
    """From T = (N_yield − N_0)/c with N_yield proportional to the contact length: dT/dc = −T/c, dT/dN_0 = −1/c."""
    names = ("load.cam_force_per_torque", "load.preload", "drive.contact_length")
    given = {"load.output_torque": np.array([10.0])}
    _, values, slopes = derivatives_at(si_values(cam_case), given, ("torque_capacity",), names)
    torque, (slope,) = float(values["torque_capacity"][0, 0]), slopes["torque_capacity"][0]
    by_hand = [-torque / CAM, -1.0 / CAM, (torque + PRELOAD / CAM) / 13.2e-3]
    np.testing.assert_allclose(slope, by_hand, rtol=5e-3)

"""Studies of a file with sections [[branch]]: the results are those of its branches, as the wind-up's are."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import si_values
from asperity.study.batch import derivatives_at, evaluate_points

BRANCHES = '[[branch]]\nplanet_deviation = "{} um"\n\n[[branch]]\n\n[[branch]]\nplanet_deviation = "-2 um"\n\n[model]'
RESULTS = ("normal_force", "assembly_stiffness_output", "drift")


@pytest.fixture
def unlike(planar_case):
    """A planetary whose planets differ, the first by so many micrometres."""
    return lambda first: planar_case("planetary", replaced={"[model]": BRANCHES.format(first)})


def test_contacts_have_the_number_of_their_branch(unlike):
    table = results_of(si_values(unlike(3)))
    assert table["normal_force"].row_names == tuple(f"{name}_{k}" for k in (1, 2, 3) for name in ("sp", "pr"))


def test_the_number_of_planets_cannot_vary_beside_their_sections(unlike):
    values = si_values(unlike(3))
    with pytest.raises(
        InputError, match=r"drive.planets cannot vary: the file has 3 sections \[\[branch\]\]"
    ):
        evaluate_points(values, {"drive.planets": np.array([3.0, 4.0])}, ("normal_force",))
    with pytest.raises(InputError, match="leave them out"):
        derivatives_at(values, {"drive.planets": np.array([3.0])}, ("normal_force",), ("drive.planets",))


@pytest.mark.long
def test_forces_stiffness_and_drift_are_those_of_the_branches(unlike, planar_case):
    """Planets that are all 2 um larger are an interference of 4 um more; of others, derivatives are differences."""
    first, step = "branch.1.planet_deviation", 1e-9
    sizes = {
        first: np.array([3e-6, 3e-6 - step, 3e-6 + step, 2e-6]),
        "branch.2.planet_deviation": np.array([0.0, 0.0, 0.0, 2e-6]),
        "branch.3.planet_deviation": np.array([-2e-6, -2e-6, -2e-6, 2e-6]),
    }
    text = BRANCHES.replace("[[branch]]\n\n", '[[branch]]\nplanet_deviation = "0 um"\n\n').format(3)
    values = si_values(planar_case("planetary", replaced={"[model]": text}))
    status, results, slopes = derivatives_at(values, sizes, RESULTS, (first,))
    assert not np.any(status)
    equal = planar_case("planetary", replaced={'interference = "30 um"': 'interference = "34 um"'})
    _, alike = evaluate_points(si_values(equal), {"load.interference": np.array([34e-6])}, RESULTS)
    for name in RESULTS:
        expected = np.resize(alike[name], len(results[name]))
        np.testing.assert_allclose(results[name][:, 3], expected, rtol=1e-8, err_msg=name)
        difference = (results[name][:, 2] - results[name][:, 1]) / (2.0 * step)
        np.testing.assert_allclose(slopes[name][:, 0, 0], difference, rtol=1e-4, err_msg=name)


@pytest.mark.long
def test_bearings_of_the_sun_carry_what_unlike_planets_leave_unbalanced(planar_case):
    """Without torque the planets press the sun along their directions, 120 degrees apart."""
    rated = '[input_bearing]\ntype = "ball"\ndynamic_rating = "9 kN"\nstatic_rating = "9 kN"\n'
    rated += 'outside_force = "50 N"\n\n'
    changed = {
        "[model]": rated + BRANCHES.format(3),
        'output_torque = "10 N*m"': 'output_torque = "0 N*m"',
        'sun_speed = "1500 rpm"': 'sun_speed = "0 rpm"',
    }
    values = si_values(planar_case("planetary", replaced=changed))
    point = {"load.interference": np.array([30e-6])}
    _, found = evaluate_points(values, point, ("normal_force", "bearing_load", "bearing_static_safety"))
    sun = results_of(values)["bearing_load"].row_names.index("sun")
    pressed = found["normal_force"][::2, 0]
    load = 50.0 + abs(np.sum(pressed * np.exp(2j * np.pi / 3.0 * np.arange(3))))
    assert load > 100.0
    assert found["bearing_load"][sun, 0] == pytest.approx(load, rel=1e-9)
    assert found["bearing_static_safety"][sun, 0] == pytest.approx(9e3 / load, rel=1e-9)

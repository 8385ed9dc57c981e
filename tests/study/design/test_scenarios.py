"""States in which a design must hold, counted and written out by hand."""

import itertools
import tomllib

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.design import scenarios as module
from asperity.study.design.design_file import design_from_tables
from asperity.study.design.scenarios import scenarios

TEXT = """joint = "joint.toml"
[variables]
load.preload = { lower = "100 N", upper = "5000 N" }
[objective]
minimise = "preload"
[constraints]
slip_ratio = { at_most = 0.8 }
[worst_case]
"""


@pytest.fixture
def states(tmp_path, joint_text):
    """Of a joint under 5 N·m with tolerances of the preload, a variable, and of the planet's radius, none."""
    text = joint_text.replace('"1000 N"', '"1000 N +- 50 N"').replace('"13.5 mm"', '"13.5 mm +- 0.1 mm"')
    (tmp_path / "joint.toml").write_text(text)

    def of(worst_case):
        return scenarios(design_from_tables(tomllib.loads(TEXT + worst_case), folder=tmp_path))

    return of


def rows(found):
    """Torque and deviations of every state."""
    deviations = (found.deviations[path] for path in ("load.preload", "drive.planet_radius"))
    return [tuple(row) for row in np.stack([found.torques, *deviations], axis=1).round(12).tolist()]


def test_corners_and_the_nominal_state_at_every_torque(states):
    found = states('tolerances = "corners"\ntorque = { lower = "0 N*m", upper = "5 N*m", points = 3 }')
    corners = [(0.0, 0.0), *itertools.product((-50.0, 50.0), (-1e-4, 1e-4))]
    expected = {(torque, *corner) for torque in (0.0, 2.5, 5.0) for corner in corners}
    assert (len(rows(found)), set(rows(found))) == (15, expected)
    assert rows(found)[0] == (5.0, 0.0, 0.0)
    assert found.counted.all()


def test_numbers_of_a_design_in_every_state(states):
    found = states('tolerances = "corners"')
    numbers = found.changes({"load.preload": 700.0})
    assert set(numbers) == {"load.preload", "drive.planet_radius", "load.output_torque"}
    pairs = (
        np.stack([numbers["load.preload"], 1e3 * numbers["drive.planet_radius"]], axis=1).round(9).tolist()
    )
    assert pairs[0] == [700.0, 13.5]
    assert sorted(pairs[1:]) == [[650.0, 13.4], [650.0, 13.6], [750.0, 13.4], [750.0, 13.6]]
    np.testing.assert_array_equal(numbers["load.output_torque"], 5.0)
    # each number has the deviation that its state is reported with
    np.testing.assert_allclose(numbers["load.preload"], 700.0 + found.deviations["load.preload"])
    np.testing.assert_allclose(
        numbers["drive.planet_radius"], 13.5e-3 + found.deviations["drive.planet_radius"]
    )
    two = found.changes({"load.preload": np.array([[700.0], [900.0]])})["load.preload"]
    np.testing.assert_allclose(two - numbers["load.preload"], [[0.0] * 5, [200.0] * 5], atol=1e-9)


def test_a_nominal_torque_outside_the_range_is_evaluated_but_does_not_count(states):
    found = states('torque = { lower = "6 N*m", upper = "8 N*m", points = 2 }')
    assert found.torques.tolist() == [5.0, 6.0, 8.0]
    assert found.counted.tolist() == [False, True, True]
    assert found.deviations == {}


def test_samples_fill_the_tolerance_evenly(states):
    """A Latin hypercube: one sample in each of forty equal parts of either tolerance."""
    found = states('tolerances = "samples"\nsamples = 40')
    assert rows(found)[0] == (5.0, 0.0, 0.0)
    for path, tolerance in (("load.preload", 50.0), ("drive.planet_radius", 1e-4)):
        part = np.floor((found.deviations[path][1:] / tolerance + 1.0) / 2.0 * 40)
        assert sorted(part) == list(range(40))


def test_overlapping_names_are_refused(states, tmp_path, joint_text):
    text = joint_text.replace('contact_length = "5 mm"', 'contact_length = "5 mm +- 0.1 mm"')
    (tmp_path / "joint.toml").write_text(text)
    task = TEXT.replace(
        "load.preload = {", 'drive.contact_length.sp = { lower = "3 mm", upper = "6 mm" }\nload.preload = {'
    )
    with pytest.raises(InputError, match=r"overlaps the tolerance of drive\.contact_length"):
        scenarios(design_from_tables(tomllib.loads(task + 'tolerances = "corners"'), folder=tmp_path))


def test_too_many_corners_are_refused_with_their_number(states, tmp_path, joint_text, monkeypatch):
    """Three numbers have eight corners; the torque scatters with its own tolerance."""
    text = joint_text.replace('"1000 N"', '"1000 N +- 50 N"').replace('"13.5 mm"', '"13.5 mm +- 0.1 mm"')
    (tmp_path / "joint.toml").write_text(text.replace('"5 N*m"', '"5 N*m +- 1 N*m"'))
    problem = design_from_tables(tomllib.loads(TEXT + 'tolerances = "corners"'), folder=tmp_path)
    found = scenarios(problem)
    torque = found.changes({"load.preload": 700.0})["load.output_torque"]
    np.testing.assert_allclose(torque, 5.0 + found.deviations["load.output_torque"])
    assert sorted(torque) == [4.0] * 4 + [5.0] + [6.0] * 4
    monkeypatch.setattr(module, "MOST_CORNERED", 2)
    with pytest.raises(InputError, match="3 toleranced numbers have 8 corners; at most 2 numbers"):
        scenarios(problem)

"""The oil in the contacts of a joint file over speed: against one joint at a time, its trends, and what is refused."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.joint.solve import joint_state
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.film import joint_film
from asperity.joint_file.reader import read_case
from asperity.rolling.conditions import ZERO_CELSIUS

EXAMPLES = Path(__file__).parents[2] / "examples"
OIL = (EXAMPLES / "oil.toml").read_text()
RPM = np.pi / 30.0


def case_of(tmp_path, *changes):
    text = OIL
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = tmp_path / "joint.toml"
    path.write_text(text)
    return read_case(path)


@pytest.fixture(scope="module")
def case():
    return read_case(EXAMPLES / "oil.toml")


@pytest.fixture(scope="module")
def cold_and_warm(case):
    return joint_film(case, temperatures=(20.0, 40.0), points=9)


def test_the_axis_of_the_file(cold_and_warm):
    speed = cold_and_warm.curves[0].input_speed
    assert (speed[0], speed[-1]) == pytest.approx((1.5 * RPM, 3000.0 * RPM), rel=1e-12)
    assert np.count_nonzero(speed == 1500.0 * RPM) == 1
    assert speed.size == 10
    steps = np.diff(np.log(speed[speed != 1500.0 * RPM]))
    assert steps == pytest.approx(np.full(8, steps[0]))


@pytest.mark.parametrize(("number", "temperature"), [(0, 20.0), (1, 40.0)])
def test_side_by_side_as_one_joint_at_a_time(case, cold_and_warm, number, temperature):
    curves, joint = cold_and_warm.curves[number], joint_from_case(case)
    at = 4
    alone = dataclasses.replace(
        joint,
        input_speed=float(curves.input_speed[at]),
        rolling=joint.rolling.with_oil_at(temperature + ZERO_CELSIUS),
    )
    rolling = joint_state(alone).rolling
    for shown, known in (
        (curves.central_film, rolling.film.central_film),
        (curves.minimum_film, rolling.film_thickness),
        (curves.film_ratio, rolling.film_ratio),
        (curves.asperity_share, rolling.film.asperity_share),
        (curves.rival_asperity_share, rolling.film.rival_share),
        (curves.traction_capacity, rolling.film.traction_capacity),
        (curves.creepage, rolling.creepage),
    ):
        assert shown[:, at] == pytest.approx(np.asarray(known), rel=1e-9)
    assert curves.drift_per_output_turn[at] == pytest.approx(float(rolling.drift_per_output_turn), rel=1e-9)
    assert curves.efficiency[at] == pytest.approx(float(rolling.power.efficiency), rel=1e-9)


def test_trends_over_speed(cold_and_warm):
    for curves in cold_and_warm.curves:
        assert curves.rolls.all()
        assert np.all(np.diff(curves.asperity_share) < 0.0)
        assert np.all(np.diff(curves.rival_asperity_share) < 0.0)
        assert np.all(np.diff(curves.film_ratio) > 0.0)
        assert np.all(np.diff(curves.minimum_film) > 0.0)


def test_warm_oil_leaves_more_to_the_asperities(cold_and_warm):
    cold, warm = cold_and_warm.curves
    assert np.all(warm.asperity_share > cold.asperity_share)
    assert np.all(warm.film_ratio < cold.film_ratio)


def test_slow_contacts_have_the_friction_of_the_boundary(case):
    slow = joint_film(case, start=1e-6 * RPM, stop=1e-5 * RPM, points=2).curves[0]
    assert slow.asperity_share == pytest.approx(np.ones((2, 2)), abs=1e-4)
    assert slow.traction_capacity == pytest.approx(np.full((2, 2), 0.12), rel=1e-4)


def test_a_joint_that_slips_at_speed_has_gaps(case):
    # the warm film of a traction fluid flows before it holds: capacity falls below the traction that the torque needs
    curves = joint_film(case, temperatures=(80.0,), points=5).curves[0]
    assert curves.rolls[0]
    assert not curves.rolls[-1]
    for values in (curves.creepage, curves.traction_capacity, curves.asperity_share):
        assert np.array_equal(np.isnan(values).any(axis=0), ~curves.rolls)
    assert np.array_equal(np.isnan(curves.drift_per_output_turn), ~curves.rolls)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"points": 1}, "number of points must be from 2 to 500, got 1"),
        ({"start": 400.0}, "from 3820 rpm to 3000 rpm they do not; choose a start below the end"),
        ({"start": 0.0}, "must rise from above 0"),
        ({"stop": -1.0}, "load.sun_speed: "),
        ({"temperatures": (2000.0,)}, "temperature of the oil: 2000 degC is not allowed"),
        ({"temperatures": tuple(range(20, 27))}, "at most 6 temperatures are compared, got 7"),
    ],
)
def test_what_is_refused(case, given, said):
    with pytest.raises(InputError, match=said):
        joint_film(case, **given)


def test_a_file_without_oil_is_refused():
    with pytest.raises(InputError, match=r"names no oil whose traction is known.*asperity materials"):
        joint_film(read_case(EXAMPLES / "planetary.toml"))


def test_an_oil_without_traction_is_refused(tmp_path):
    mine = '[fluids.mine]\nviscosity_40 = "32 mm^2/s"\nviscosity_100 = "5.3 mm^2/s"\ndensity = "880 kg/m^3"\n'
    case = case_of(
        tmp_path, ('fluid = "Santotrac 50"', 'fluid = "mine"'), ("[model]\n", f"{mine}\n[model]\n")
    )
    with pytest.raises(InputError, match=r"no traction is known.*limiting_traction"):
        joint_film(case)


def test_an_input_that_stands(tmp_path):
    case = case_of(tmp_path, ('sun_speed = "1500 rpm"', 'sun_speed = "0 rpm"'))
    with pytest.raises(InputError, match="the input of the file stands"):
        joint_film(case)
    film = joint_film(case, start=1.0, stop=10.0, points=2)
    assert film.curves[0].rolls.all()
    assert np.isnan(film.here.asperity_share).all()


def test_a_torque_that_never_rolls(tmp_path):
    case = case_of(tmp_path, ('output_torque = "10 N*m"', 'output_torque = "60 N*m"'))
    with pytest.raises(NoSolutionError, match=r"no steady rolling under 60 N\S?m at any of these speeds"):
        joint_film(case, points=3)

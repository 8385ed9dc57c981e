"""Lives with a factor for the oil film, of every type of drive: by hand from the lives without one."""

import dataclasses
import re

import numpy as np
import pytest

from asperity.contact.life_factor import life_modification_factor
from asperity.joint.solve import joint_state
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.own_branches import branches_of
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.study.batch import derivatives_at, evaluate_points

SLOPE = 10.0 / 9.0
OIL = '\n[lubrication]\nviscosity = "30 mPa*s"\npressure_coefficient = "20 1/GPa"\nroughness = "{} um"\n'
CLEAN = "\n[life]\ncleanliness = 0.5\n"
SKEW = '\n[rolling]\nskew = { sp = "0.2 mrad", pr = "0.1 mrad" }\n'
LOADS = "".join(
    f'\n[[duty]]\noutput_torque = "{torque}"\nsun_speed = "{speed}"\nshare = {share}\n'
    for torque, speed, share in (
        ("2 N*m", "1500 rpm", 0.3),
        ("4 N*m", "3000 rpm", 0.5),
        ("1 N*m", "0 rpm", 0.2),
    )
)


def text_of(zou_file, name, *more):
    """An example without its oil and rolling, with other sections at the end."""
    text = zou_file.with_name(f"{name}.toml").read_text(encoding="utf-8")
    for section in ("lubrication", "rolling", "temperature"):
        text = re.sub(rf"(?ms)^\[{section}\].*?(?=^\[|\Z)", "", text)
    text = re.sub(r"(?m)^(\s*)yield_strength = .*", r'\1yield_strength = "2 GPa"', text)
    return text + "".join(more)


def rolled(text):
    case = parse_case(text, source="mine.toml")
    branches = branches_of(case)
    return joint_state(joint_from_case(case) if branches is None else branches.joint)


def by_hand(rolling):
    """Factor of each contact from its pressure and film."""
    return life_modification_factor(
        viscosity_ratio=np.asarray(rolling.film_ratio) ** 1.3,
        cleanliness=0.5,
        fatigue_load_ratio=(1.5e9 / np.asarray(rolling.hertz_pressure)) ** 2,
    )


NAMES = ("planetary", "zou2025", "multiroller", "stepped_planet", "wheel_pair", "planar", "planetary_hollow")


@pytest.mark.parametrize(
    "name", [NAMES[0], *(pytest.param(name, marks=pytest.mark.slow) for name in NAMES[1:])]
)
def test_every_drive_lives_its_factors_longer(zou_file, name):
    """Contacts by hand, and the drive from its contacts: their rates of failure add."""
    oil = OIL.format(1.0 if name == "wheel_pair" else 0.3)
    plain, clean = (rolled(text_of(zou_file, name, oil, life)) for life in ("", CLEAN))
    factors = by_hand(clean.rolling)
    assert np.all(np.isfinite(factors))
    assert np.any(factors < 40.0)
    np.testing.assert_allclose(clean.rolling.life_factor, factors, rtol=1e-9)
    assert np.all(np.isnan(plain.rolling.life_factor))
    before, after = (np.asarray(each.rolling.life_turns.contact) for each in (plain, clean))
    np.testing.assert_allclose(after, before * factors, rtol=1e-9)
    rates = np.sum(before**-SLOPE), np.sum(after**-SLOPE)
    lives = (float(each.rolling.life_turns.drive) for each in (plain, clean))
    one, other = lives
    assert other / one == pytest.approx((rates[0] / rates[1]) ** (1.0 / SLOPE), rel=1e-9)


def test_skewed_rollers_have_the_factor_too(zou_file):
    """With an oil whose traction is known."""
    text = zou_file.with_name("oil.toml").read_text(encoding="utf-8").replace('"0.2 um"', '"0.3 um"')
    found = rolled(text + SKEW).rolling
    np.testing.assert_allclose(found.life_factor, by_hand(found), rtol=1e-9)
    assert np.all(np.asarray(found.capacity_loss) > 0.0)


@pytest.mark.slow
def test_crowned_rollers_live_by_their_slices(zou_file):
    """The middle is pressed most and tires most; the slices beside it have longer lives and larger factors."""
    crown = 'sun_crown_radius = "2 m"\nplanet_crown_radius = "3 m"\n\n[load]'
    text = text_of(zou_file, "planetary", OIL.format(0.3), CLEAN).replace("[load]", crown, 1)
    found = rolled(text).rolling
    factor, middle = np.asarray(found.life_factor), np.asarray(by_hand(found))
    assert 1.001 * middle[0] < factor[0] < 2.0 * middle[0]
    assert middle[0] < 10.0


@pytest.mark.slow
def test_unlike_branches_have_films_of_their_own(zou_file):
    branches = '\n[[branch]]\nplanet_deviation = "1 um"\n\n[[branch]]\n\n[[branch]]\n'
    found = rolled(text_of(zou_file, "planetary", OIL.format(0.3), CLEAN, branches)).rolling
    assert np.asarray(found.life_factor).size == 6
    np.testing.assert_allclose(found.life_factor, by_hand(found), rtol=1e-9)
    assert np.ptp(np.asarray(found.life_factor)) > 1e-3


def test_a_duty_lives_by_the_films_of_its_loads(zou_file):
    """Damage of both loads that turn, each with its own films; the one at rest does none."""
    text = text_of(zou_file, "planetary", OIL.format(0.3), CLEAN)
    whole = rolled(text + LOADS).rolling
    rates = []
    for torque, speed in (("2 N*m", 1500), ("4 N*m", 3000)):
        one = re.sub(r"(?m)^output_torque = .*", f'output_torque = "{torque}"', text, count=1)
        one = re.sub(r"(?m)^sun_speed = .*", f'sun_speed = "{speed} rpm"', one, count=1)
        rolling = rolled(one).rolling
        per_hour = float(rolling.output_speed) / (2.0 * np.pi) * 3600.0
        rates.append(np.asarray(rolling.cycles_per_turn) * per_hour / np.asarray(rolling.cycles))
    tracks = 1.0 / (0.3 * rates[0] + 0.5 * rates[1])
    assert np.all(np.isfinite(tracks))
    sun, planet = tracks[0, 0], (tracks[1, 0], tracks[0, 1])
    ring = tracks[1, 1]
    damage = 3.0 * np.sum(np.array(planet) ** -SLOPE) + np.sum((np.array([sun, ring]) / 3.0) ** -SLOPE)
    assert float(whole.duty_life_hours) == pytest.approx(damage ** (-1.0 / SLOPE), rel=1e-9)
    assert float(np.asarray(whole.duty_damage_shares)[2]) == 0.0
    films = np.asarray(whole.duty_film_ratios)
    assert films[1] > films[0]  # it turns twice as fast
    assert np.isnan(films[2])


def test_a_film_too_thin_for_a_factor_leaves_no_life(zou_file):
    """At one thousandth of the speed lambda falls by 1000^0.7; standing there is no film."""
    text = text_of(zou_file, "planetary", OIL.format(0.3), CLEAN)
    values = si_values(parse_case(text, source="mine.toml"))
    speed = values["load"]["sun_speed"]
    for slower in (1e-3 * speed, 0.0):
        joint = joint_from_values(replace_values(values, {"load.sun_speed": slower}))
        rolling = joint_state(joint).rolling
        assert np.isnan(float(rolling.life_turns.drive))
        plain = dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, cleanliness=None))
        assert np.isfinite(float(joint_state(plain).rolling.life_turns.drive))


def test_batches_have_the_same_lives_and_their_slopes(zou_file):
    """Against single joints, and derivatives against differences of them."""
    path = "life.cleanliness"
    values = si_values(parse_case(text_of(zou_file, "planetary", OIL.format(0.3), CLEAN), source="mine.toml"))

    def alone(cleanliness):
        return joint_state(joint_from_values(replace_values(values, {path: cleanliness}))).rolling

    cleanliness = np.array([0.1, 0.35])
    _, found = evaluate_points(values, {path: cleanliness}, ("life_turns", "life_factor"))
    singles = [alone(each) for each in cleanliness]
    np.testing.assert_allclose(
        found["life_turns"], [float(each.life_turns.drive) for each in singles], rtol=1e-8
    )
    np.testing.assert_allclose(
        found["life_factor"], np.transpose([np.asarray(each.life_factor) for each in singles]), rtol=1e-8
    )
    _, _, slopes = derivatives_at(values, {path: cleanliness}, ("life_turns",), (path,))
    step = 1e-5
    for number, each in enumerate(cleanliness):
        rise = float(alone(each + step).life_turns.drive) - float(alone(each - step).life_turns.drive)
        assert slopes["life_turns"][0, number, 0] == pytest.approx(rise / (2.0 * step), rel=1e-5)

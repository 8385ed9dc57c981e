"""The life under a duty, from lives that are made up: Palmgren and Miner by hand."""

import numpy as np
import pytest
from rolled_joint import Lives, Rolled

from asperity.drive.state.state import BodiesOfContacts
from asperity.engine.arrays import xp
from asperity.rolling.conditions import PLAIN_ROLLING, DutyPoint, RollingConditions
from asperity.rolling.duty import duty_life

#: The paper's drive.
WEDGE_DRIVE = BodiesOfContacts(
    names=("sun", "planet", "right", "left", "ring"),
    shared=(True, False, False, False, True),
    driving=(0, 1, 1, 2, 3),
    driven=(1, 2, 3, 4, 4),
)
SLOPE = 10.0 / 9.0
CYCLES = 1e9  # that a track lives at a torque of 1 N·m; the life falls with the cube of the torque


def conditions(*loads, **stated):
    points = tuple(DutyPoint(*map(np.asarray, load)) for load in loads)
    return RollingConditions(**(vars(PLAIN_ROLLING) | {"duty": points} | stated))


def rolled(torque, speed):
    """Ten tracks alike, a stress cycle by each contact in a turn of the output, at a tenth of the sun's speed."""
    carrier = speed / 10.0
    cycles = CYCLES / torque**3 * np.ones((2, 5))
    hours = _drive(cycles) / (carrier / (2.0 * np.pi)) / 3600.0
    return Rolled(
        cycles=cycles,
        cycles_per_turn=np.ones((2, 5)),
        output_speed=carrier,
        life_hours=Lives(hours),
        shakedown_ratio=torque * np.array([0.1, 0.3, 0.2, 0.1, 0.1]),
        slip_ratio=torque * np.array([0.2, 0.1, 0.2, 0.4, 0.1]),
        film_ratio=carrier / np.pi * np.array([2.0, 1.0, 0.5, 1.0, 3.0]),
    )


def _drive(cycles, planets=3.0):
    """Life of a drive of ten tracks alike: three once, with the damage of all planets, the others in each branch."""
    return cycles[0, 0] * (3 * planets**SLOPE + 7 * planets) ** (-1.0 / SLOPE)


def found(*loads, **options):
    return duty_life(
        conditions=conditions(*loads, **options), bodies=WEDGE_DRIVE, branches=3.0, rolled=rolled
    )


@pytest.mark.slow
def test_one_load_is_that_load():
    life = found((2.0, 20.0 * np.pi, 1.0))
    # sun contact's first track and both of the ring are there once, and three planets pass over them
    turns = CYCLES / 8.0 * (3.0 * 3.0**SLOPE + 21.0) ** (-1.0 / SLOPE)
    assert float(life.turns) == pytest.approx(turns, rel=1e-12)
    assert float(life.hours) == pytest.approx(turns / 3600.0, rel=1e-12)  # one turn a second
    np.testing.assert_allclose(life.damage_shares, [1.0], rtol=1e-12)
    np.testing.assert_allclose(life.load_hours, [life.hours], rtol=1e-12)


def test_damage_adds_up_over_time():
    """At twice the speed a load does twice the damage in its time, at twice the torque eight times."""
    life = found((1.0, 20.0 * np.pi, 0.5), (2.0, 20.0 * np.pi, 0.3), (1.0, 40.0 * np.pi, 0.2))
    damage = np.array([0.5, 0.3 * 8.0, 0.2 * 2.0])
    alone = float(found((1.0, 20.0 * np.pi, 1.0)).hours)
    assert float(life.hours) == pytest.approx(alone / damage.sum(), rel=1e-12)
    np.testing.assert_allclose(life.damage_shares, damage / damage.sum(), rtol=1e-12)
    np.testing.assert_allclose(life.load_hours, alone / np.array([1.0, 8.0, 2.0]), rtol=1e-12)
    np.testing.assert_allclose(life.shakedown_ratios, [0.3, 0.6, 0.3], rtol=1e-12)  # of the worst contact
    np.testing.assert_allclose(life.slip_ratios, [0.4, 0.8, 0.4], rtol=1e-12)
    np.testing.assert_allclose(life.film_ratios, [1.0, 1.0, 2.0], rtol=1e-12)  # of the thinnest film
    assert float(life.turns / life.hours) == pytest.approx(3600.0 * 1.2, rel=1e-12)


def test_more_certainty_is_less_life():
    """Weibull: life at survival S is (ln(1/S) / ln(1/0.9))^(1/e) of that at 90 %."""
    loads = ((1.0, 20.0 * np.pi, 0.6), (2.0, 20.0 * np.pi, 0.4))
    factor = (np.log(1.0 / 0.99) / np.log(1.0 / 0.9)) ** (1.0 / SLOPE)
    assert float(found(*loads, reliability=0.99).hours / found(*loads).hours) == pytest.approx(
        factor, rel=1e-12
    )


def test_a_duty_that_only_stands_lasts():
    life = found((1.0, 0.0, 1.0))
    assert np.isinf(life.hours)


def test_a_load_that_stands_needs_no_film():
    """With a factor for the film a load at rest has no life, and none of its cycles count; slipping, it is unknown."""
    turns, stands = (1.0, 20.0 * np.pi, 0.5), (2.0, 0.0, 0.5)

    def without_film(torque, speed):
        known = rolled(torque, speed)
        return known._replace(cycles=xp.where(speed > 0.0, known.cycles, np.nan))

    def life(*loads, rolled=without_film, **stated):
        return duty_life(
            conditions=conditions(*loads, **stated), bodies=WEDGE_DRIVE, branches=3.0, rolled=rolled
        )

    alone = float(life((*turns[:2], 1.0)).hours)
    together = life(turns, stands, cleanliness=0.5)
    assert float(together.hours) == pytest.approx(2.0 * alone, rel=1e-12)
    np.testing.assert_allclose(together.damage_shares, [1.0, 0.0], atol=1e-15)
    assert np.isnan(life(turns, stands).hours)
    assert np.isnan(life(turns, (3.0, 0.0, 0.5), cleanliness=0.5).hours)  # its slip ratio is 1.2

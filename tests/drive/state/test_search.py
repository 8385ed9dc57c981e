"""Contacts that slide keep their friction: two planets of one sector side by side, by hand, and the wedge drive."""

import jax
import numpy as np
import pytest
from steel_laws import steel_laws

from asperity.drive.layout.drive import CARRIER, Body, Contact, Drive, incidence
from asperity.drive.normal_springs import NormalSprings
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.loads import member_moments
from asperity.drive.state.search import newton
from asperity.drive.state.state import STATE_TOLERANCE, ContactLaws, DriveLoad
from asperity.drive.state.states import loaded_state, state_at_rest
from asperity.engine.arrays import xp
from asperity.engine.control import at_once, in_one, traced_once, vectorised
from asperity.engine.derivatives import jacobian, value_and_slope

SUN, PLANET, ORBIT, COUNT = 20e-3, 10e-3, 30e-3, 3
NORMAL, COMPLIANCE = 1000.0, (4e-9, 6e-9)  # of the contacts with sun and ring [m/N]
WEAK, STRONG = 0.06, 0.1  # friction of the two planets
PATH = COUNT * 2.0 * ORBIT  # output torque over the tangential force of one planet at sun and ring [m]
FIRST = 2.0 * PATH * WEAK * NORMAL  # both planets are equally stiff, and share the torque until one slides
WHOLE = PATH * (WEAK + STRONG) * NORMAL
STIFFNESS = (
    PATH**2 / COUNT / sum(COMPLIANCE)
)  # of one planet: the carrier turns by the slips over twice the orbit


@pytest.fixture(scope="module")
def pair():
    """Two planets of one size in each sector, on rigid pins."""
    angle = np.array([np.pi / 2.0, np.pi / 6.0])
    places = ORBIT * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    axis = np.zeros((1, 2))
    return Drive(
        bodies=(Body("sun", "axis"), Body("one", "pin"), Body("two", "pin"), Body("ring", "axis")),
        contacts=(
            Contact("s1", "sun", "one"),
            Contact("r1", "one", "ring", internal=True),
            Contact("s2", "sun", "two"),
            Contact("r2", "two", "ring", internal=True),
        ),
        centres=np.concatenate([axis, places, axis]),
        first_radius=np.array([SUN, PLANET] * 2),
        second_radius=np.array([PLANET, SUN + 2.0 * PLANET] * 2),
        push_angles=np.zeros(2),
        sectors=COUNT,
        input="sun",
        output=CARRIER,
        grounded="ring",
    )


@pytest.fixture(scope="module")
def standing(pair):
    """States under torques, with the friction of both planets."""

    @traced_once
    def states(torques, weak, strong):
        compliance = np.array(COMPLIANCE * 2)
        laws = ContactLaws(
            springs=NormalSprings(compliance, compliance),
            reference_force=np.full(4, NORMAL),
            creep=CreepLaw(xp.stack([weak, weak, strong, strong]), np.full(4, 3e-5)),
        )
        rest = state_at_rest(drive=pair, laws=laws, pattern=np.array([0.0, 1.0, 0.0, 1.0]), preload=NORMAL)

        def at(torque):
            return loaded_state(drive=pair, laws=laws, rest=rest, load=DriveLoad(torque), rolls=False)

        return vectorised(at)(torques) if xp.ndim(torques) else at(torques)

    return lambda torques, weak=WEAK, strong=STRONG: states(torques, weak, strong)


def test_a_planet_that_slides_keeps_its_friction_and_the_other_carries_the_rest(standing):
    torques = np.array([0.5, 1.0 - 1e-9, 1.2, 1.3]) * FIRST
    found = standing(torques)
    assert np.all(np.asarray(found.residual) < STATE_TOLERANCE)
    weak = np.minimum(torques / (2.0 * PATH), WEAK * NORMAL)
    strong = torques / PATH - weak
    expected = np.stack([weak, weak, strong, strong], axis=1)
    np.testing.assert_allclose(np.abs(found.tangential), expected, rtol=1e-9)
    np.testing.assert_array_equal(np.any(np.asarray(found.slides) != 0.0, axis=1), [False, False, True, True])


def test_the_carrier_turns_by_the_planets_that_hold(standing):
    """Half as stiff from the first slip on, and the same in both directions."""
    torques = np.array([0.5, 1.2, -1.2]) * FIRST
    turned = np.abs(np.asarray(standing(torques).rotation)[:, -1])
    beyond = FIRST / (2.0 * STIFFNESS) + 0.2 * FIRST / STIFFNESS
    np.testing.assert_allclose(turned, [0.5 * FIRST / (2.0 * STIFFNESS), beyond, beyond], rtol=1e-9)


def test_no_state_beyond_the_friction_of_both(standing):
    found = standing(np.array([1.0 - 1e-9, 1.0 + 1e-9, 1.5]) * WHOLE)
    np.testing.assert_array_equal(np.asarray(found.residual) < STATE_TOLERANCE, [True, False, False])
    # one contact holds more than its friction there: the planet that slides is known, and the other limits
    assert np.all(np.asarray(found.worst) < STATE_TOLERANCE)
    used = np.abs(found.tangential) / (np.array([WEAK, WEAK, STRONG, STRONG]) * np.asarray(found.normal))
    assert np.all(used[1:].max(axis=1) > 1.0)
    assert set(np.argmax(used[1:], axis=1)) <= {2, 3}


def test_equal_planets_slide_together(standing):
    """No rest is left to carry: the first slip is the end."""
    both = 2.0 * PATH * STRONG * NORMAL
    found = standing(np.array([1.0 - 1e-9, 1.0 + 1e-9]) * both, STRONG, STRONG)
    np.testing.assert_array_equal(np.asarray(found.residual) < STATE_TOLERANCE, [True, False])


def slopes_by_numpy(function, at):
    return [value_and_slope(function, at, tuple(along))[1] for along in np.eye(len(at))]


def slopes_by_jax(function, at):
    return jax.jit(jax.grad(function, argnums=tuple(range(len(at)))))(*at)


@pytest.mark.parametrize("slopes", [slopes_by_numpy, pytest.param(slopes_by_jax, marks=pytest.mark.slow)])
def test_derivatives_are_those_of_what_holds(standing, slopes):
    """Beyond the first slip the strong planet alone turns the carrier: by the torque less the friction of the weak."""

    def turned(torque, weak):
        return abs(standing(torque, weak).rotation[-1])

    by_torque, by_friction = slopes(turned, (np.asarray(1.2 * FIRST), np.asarray(WEAK)))
    assert float(by_torque) == pytest.approx(1.0 / STIFFNESS, rel=1e-9)
    assert float(by_friction) == pytest.approx(-PATH * NORMAL / STIFFNESS, rel=1e-9)


def test_the_wedge_drive_balances_with_a_roller_that_slides(drives):
    """Forces and moments from the contacts; the sliding one follows its normal force, and slips beyond its law."""
    drive = drives["wedge"]

    def states(torques):
        laws = steel_laws(drive=drive)
        rest = state_at_rest(
            drive=drive, laws=laws, pattern=np.array([0.0, 0.0, 0.0, 1.0, 1.0]), preload=1000.0
        )
        return vectorised(
            lambda torque: loaded_state(
                drive=drive, laws=laws, rest=rest, load=DriveLoad(torque), rolls=False
            )
        )(torques)

    torques = np.array([8.0, 11.0, 12.5, -12.5, 14.0])
    found = at_once(states, torques)
    holds = np.asarray(found.residual) < STATE_TOLERANCE
    np.testing.assert_array_equal(holds, [True, True, True, True, False])
    slides = np.asarray(found.slides)
    assert np.array_equal(np.abs(slides)[1:3], [[0.0, 0.0, 0.0, 0.0, 1.0]] * 2)
    assert np.array_equal(np.abs(slides)[3], [0.0, 0.0, 0.0, 1.0, 0.0])  # the mirror image
    matrices = incidence(drive)
    for k, torque in enumerate(torques[:4]):
        normal, tangential = found.normal[k], found.tangential[k]
        force = matrices.approach.T @ normal + matrices.sliding.T @ tangential
        np.testing.assert_allclose(force + matrices.pins.T @ found.pin_force[k], 0.0, atol=1e-8)
        moments = member_moments(drive, matrices, tangential, found.pin_force[k])
        np.testing.assert_allclose(moments[1:4], 0.0, atol=1e-11)
        assert abs(float(moments[-1])) == pytest.approx(abs(torque), rel=1e-9)
        used = np.abs(np.asarray(tangential)) / (0.12 * np.asarray(normal))
        assert np.all(used <= 1.0 + 1e-12)
        np.testing.assert_allclose(used[slides[k] != 0.0], 1.0, rtol=1e-12)


def step_of(equations):
    """Newton steps with the slopes of forward differentiation."""

    def step_at(x):
        flat, apart = in_one(x)

        def residual(at):
            return in_one(equations(apart(at)))[0]

        return apart(np.linalg.solve(jacobian(residual, flat), residual(flat)))

    return step_at


def test_circle_and_hyperbola():
    """x^2 + y^2 = 5 and x y = 2 meet at (2, 1), beside (1, 2) and both negatives."""

    def equations(x):
        return {"a": x["a"] ** 2 + x["b"] ** 2 - 5.0, "b": x["a"] * x["b"] - 2.0}

    found, last = newton(step_of(equations), {"a": np.asarray(3.0), "b": np.asarray(0.5)}, positive=2)
    assert float(last) < 1e-6
    assert (float(found["a"]), float(found["b"])) == pytest.approx((2.0, 1.0), rel=1e-12)


def test_positive_unknowns_stay_positive():
    """ln x = -3 from 1: the whole first step would lead to -2, where the logarithm has no value."""
    found, _ = newton(step_of(lambda x: xp.log(x) + 3.0), np.array([1.0]), positive=1)
    assert float(found[0]) == pytest.approx(np.exp(-3.0), rel=1e-12)


def test_a_step_keeps_a_fifth_of_a_positive_unknown():
    """x = -3 has no positive root: steps that each keep a fifth, until hardly anything is left, 0.2^21 < 1e-14."""
    found, last = newton(step_of(lambda x: x + 3.0), np.array([1.0]), positive=1)
    assert float(last) == pytest.approx(3.0)
    assert np.log(found[0]) == pytest.approx(21.0 * np.log(0.2), rel=1e-12)


def test_a_search_whose_steps_do_not_become_shorter_is_given_up():
    """Steps of 1 for ever lead nowhere; a root at the end of some steps of equal size is found."""
    taken = []

    def step(x):
        taken.append(float(x[0]))
        return -np.ones(1)

    _, last = newton(step, np.array([0.7]), positive=1)
    assert float(last) == 1.0
    assert len(taken) == 21
    # steps of 1 towards 18.5, of which only the last one is shorter
    found, last = newton(lambda x: xp.clip(x - 18.5, -1.0, 1.0), np.array([0.7]), positive=1)
    assert (float(found[0]), float(last)) == (18.5, 0.0)


def test_a_search_for_unknowns_that_are_not_determined_is_given_up():
    """x + y = 1 and x + y = 2 have no root; the first step is as long as rounding makes it."""
    _, last = newton(
        step_of(lambda x: xp.stack([x[0] + x[1] - 1.0, (1.0 + 1e-14) * x[0] + x[1] - 2.0])),
        np.ones(2),
        positive=1,
        longest=1e4,
    )
    assert not float(last) < 1e4


@pytest.mark.parametrize(
    ("equation", "start", "steps"),
    [
        # x^2 = 2: after 1e-4 a step of 1e-8/(2 sqrt 2), and the next one would be 4e-18
        (lambda x: x * x - 2.0, 2.0**0.5 + 1e-4, 2),
        # x^2 = 0: every step is half as long as the one before, until a quarter of one is below 1e-13
        (lambda x: x * x, 1.0, 42),
    ],
)
def test_a_search_ends_where_the_next_step_would_be_rounding(equation, start, steps):
    count = []

    def step_at(x):
        count.append(1)
        return step_of(equation)(x)

    x, _ = newton(step_at, np.array([start]), positive=1)
    assert len(count) == steps
    assert abs(float(equation(x[0]))) < 1e-15

"""The rolling joint: published and independently computed numbers, energy, symmetry, skew, life, gradients, batches."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.contact.carter import creepage
from asperity.joint.evaluation import evaluate
from asperity.joint.solve import solve_joint
from asperity.rolling.conditions import PLAIN_ROLLING, DutyPoint, RollingConditions

TURN = 2.0 * math.pi
RADII = np.array([4 * 13.5 / 17.5, 13.5 * 5 / 18.5, 13.5 * 5 / 18.5, 5 * 40 / 35, 5 * 40 / 35]) * 1e-3
BODIES = ("sun", "planet", "right_loading_roller", "left_loading_roller", "ring")
SMOOTH = {
    "fractal_dimension": 1.9,
    "fractal_roughness": 1e-16,
}  # asperities a thousand times stiffer than the bodies


#: A steel that stays elastic, so that the joint has a life [Pa].
HARD = {"yield_strength": 1.2e9}


@pytest.fixture(scope="module")
def rolled(paper_joint):
    def result(conditions=PLAIN_ROLLING, **changes):
        return solve_joint(dataclasses.replace(paper_joint(**changes), rolling=conditions)).result.rolling

    return result


@pytest.fixture(scope="module")
def traced(paper_joint):
    """As ``rolled``, as a part of a program that asks for derivatives."""

    def result(conditions, **changes):
        joint = dataclasses.replace(paper_joint(**HARD), rolling=conditions)
        return evaluate(dataclasses.replace(jax.tree.map(jnp.asarray, joint), **changes)).rolling

    return result


def conditions(*, skew=(0.0,) * 5, duty=(), reliability=0.9):
    """Everything given, in few structures, each of which is compiled once."""
    return RollingConditions(skew, 0.01, 0.0305, 2e-8, reliability, duty)


def test_smooth_bodies_fall_behind_by_35_arcminutes(rolled):
    """Carter's creep in both branches, computed independently: 0.589 degrees an output turn at 5 N·m."""
    found = rolled(ring_wall_thickness=60e-3, sun_speed=0.0, **SMOOTH)
    assert float(np.max(found.layer_ratio)) < 2e-3
    assert math.degrees(float(found.drift_per_output_turn)) == pytest.approx(0.589, rel=3e-3)
    assert float(found.speed_loss) == pytest.approx(1.63529e-3, rel=3e-3)


def test_asperities_add_a_sixth_to_the_creep(rolled):
    """By an independent solver of strips with springs: each contact at its forces, and the whole state again."""
    found = rolled()
    for contact, factor in enumerate((1.131, 1.171, 1.230, 1.159, 1.217)):
        assert float(found.layer_creepage_factor[contact]) == pytest.approx(factor, rel=5e-3)
    assert math.degrees(float(found.drift_per_output_turn)) * 60.0 == pytest.approx(41.12, rel=3e-3)
    np.testing.assert_allclose(found.tangential[1:3], [25.94, 20.36], rtol=3e-3)


def test_asperities_widen_the_contacts_and_lower_their_peaks(rolled):
    """Mean square of the load's places a^2/4 + u_0 R; the peak falls by 10 to 17 %."""
    found = rolled()
    normal, ratio = np.asarray(found.normal), np.asarray(found.layer_ratio)
    assert 0.11 <= ratio.min() < ratio.max() <= 0.21
    width = np.sqrt(4.0 * normal / 5e-3 * RADII / (math.pi * 206e9 / 1.82))
    np.testing.assert_allclose(found.rough_half_width, width * np.sqrt(1.0 + 4.0 * ratio), rtol=1e-12)
    lowered = np.asarray(found.rough_peak_pressure) / (2.0 * normal / (math.pi * 5e-3 * width))
    assert 0.82 < lowered.min() < lowered.max() < 0.905
    rough = rolled(**HARD)
    smooth = rolled(ring_wall_thickness=60e-3, **SMOOTH, **HARD)  # life takes the smooth contact's pressure
    np.testing.assert_allclose(rough.cycles[0, 0] / smooth.cycles[0, 0], 1.0, rtol=0.02)


def test_above_shakedown_there_is_no_life(rolled):
    """Coy's law holds for tracks that stay elastic; sp, pwr are above shakedown, the others below."""
    found = rolled()
    np.testing.assert_array_equal(np.asarray(found.shakedown_ratio) >= 1.0, [True, True, False, False, False])
    np.testing.assert_array_equal(
        np.isnan(np.asarray(found.life_turns.body)), [True, True, True, False, False]
    )
    assert np.isnan(float(found.life_turns.drive))


@pytest.mark.parametrize(("torque", "minutes"), [(2.0, 15.18), (10.0, 102.1)])
def test_drift_of_the_rough_joint_at_other_torques(rolled, torque, minutes):
    """By the same independent solver, the whole rolling state solved again."""
    drift = math.degrees(float(rolled(output_torque=torque).drift_per_output_turn)) * 60.0
    assert drift == pytest.approx(minutes, rel=4e-3)


@pytest.mark.slow
@pytest.mark.parametrize("torque", [5.0, 12.0])
def test_rolling_takes_its_own_forces(rolled, torque):
    """At rest the closures share the traction differently, by up to 30 %; in rolling the creep decides."""
    equal, springs = (
        rolled(output_torque=torque, traction_split=split) for split in ("equal_coefficients", "springs")
    )
    np.testing.assert_allclose(springs.tangential, equal.tangential, rtol=1e-5)
    np.testing.assert_allclose(springs.layer_creepage_factor, equal.layer_creepage_factor, rtol=1e-4)
    assert float(springs.speed_loss) == pytest.approx(float(equal.speed_loss), rel=1e-5)


def test_creep_of_every_contact_is_carters_times_its_factor(rolled):
    found = rolled()
    normal, tangential = np.asarray(found.normal), np.asarray(found.tangential)
    width = np.sqrt(4 * normal / 5e-3 * RADII / (math.pi * 206e9 / 1.82))
    carter = creepage(slip_ratio=tangential / (0.12 * normal), gross_slip_creepage=0.12 * width / RADII)
    # the creepage is by the law around the forces of the pass before
    np.testing.assert_allclose(found.creepage / carter, found.layer_creepage_factor, rtol=1e-7)
    np.testing.assert_allclose(
        found.creepage[1] + found.creepage[3], found.creepage[2] + found.creepage[4], rtol=2e-3
    )
    np.testing.assert_allclose(found.stick_fraction, np.sqrt(1 - tangential / (0.12 * normal)), rtol=1e-12)


@pytest.mark.long
def test_skew_takes_from_the_zone_that_sticks(rolled):
    """The whole traction counts, the axial part with the tangential one; where it is all of friction nothing sticks."""
    found = rolled(conditions(skew=(1e-3, 5e-4, -3e-4, 8e-4, -1e-3)))
    limit = 0.12 * np.asarray(found.normal)
    used = np.hypot(found.tangential, found.axial_force) / limit
    np.testing.assert_allclose(found.stick_fraction, np.sqrt(1.0 - used), rtol=1e-9)
    sliding = rolled(conditions(skew=(2e-2, 0.0, 0.0, 0.0, 0.0)), output_torque=0.1)
    assert float(sliding.stick_fraction[0]) == 0.0
    assert np.all(np.asarray(sliding.stick_fraction[1:]) > 0.9)


def balance(found, torque, sun_speed, sun_torque, roller_torque, carrier_torque):
    """Creep and bearing power, and what is missing at the output, by going from body to body."""
    sun, ring, count = 4e-3, 40e-3, 3
    carrier = sun_speed * sun / (ring - sun) * (1.0 - float(found.speed_loss))
    lost = 0.0

    def passed(speed, k):
        nonlocal lost
        xi = float(found.creepage[k])
        slower = speed * (2.0 - xi) / (2.0 + xi)
        lost += count * float(found.tangential[k]) * (speed - slower)
        return slower

    outside = passed(sun * (sun_speed + carrier), 0)
    for near, far in ((1, 3), (2, 4)):
        surface = passed(outside, near)
        lost += count * float(found.tangential[near] - found.tangential[far]) * surface
        assert passed(surface, far) == pytest.approx(ring * carrier, rel=1e-9)
    lost += 2.0 * sun_torque * sun_speed + 2.0 * carrier_torque * carrier
    power_in = (2.0 * sun_torque + count * sun * float(found.tangential[0])) * sun_speed
    return lost, power_in - torque * carrier, power_in


@pytest.mark.long
@pytest.mark.parametrize("torque", [0.7, 5.0, -3.0])
def test_creep_and_bearings_are_what_is_missing_at_the_output(rolled, torque):
    friction = {"sun_torque": 0.01, "loading_roller_torque": 0.003, "carrier_torque": 0.02}
    found = rolled(output_torque=torque, pin_friction_coefficient=0.002, pin_diameter=4e-3, **friction)
    speed = 600 * math.pi / 3 * 1.0
    lost, missing, power_in = balance(found, torque, speed, 0.01, 0.003, 0.02)
    power = found.power
    ours = float(np.sum(power.creep) + power.bearings)
    assert ours == pytest.approx(lost, rel=1e-9)
    assert ours == pytest.approx(missing, rel=1e-9)
    assert float(power.loss) == pytest.approx(ours, rel=1e-13)
    if torque > 0.0:
        output = torque * float(found.output_speed)
        assert float(power.efficiency) == pytest.approx(output / (output + lost), rel=1e-9)
        assert output + lost == pytest.approx(power_in, rel=0.1)
    else:  # the output drives: what leaves at the sun over what enters at the carrier
        entering = -torque * float(found.output_speed)
        assert float(power.efficiency) == pytest.approx((entering - lost) / entering, rel=1e-9)


@pytest.mark.long
def test_a_torque_that_drives_less_than_the_losses_has_no_efficiency(rolled):
    found = rolled(output_torque=-0.02, sun_torque=0.05)
    assert np.isnan(float(found.power.efficiency))
    assert np.isnan(float(found.power.output))
    assert float(found.power.input) > 0.0


def test_turning_back_under_the_same_torque_goes_on_drifting(rolled):
    """One turn with the torque and one against it: the first loses angle, the second gains speed, both slip away."""
    there, back = rolled(output_torque=2.0), rolled(output_torque=-2.0)
    # seen in the direction of each rotation; turning back reverses it, so that both drifts have the sign of the torque
    total = float(there.drift_per_output_turn) - float(back.drift_per_output_turn)
    assert total == pytest.approx(2.0 * float(there.drift_per_output_turn), rel=5e-3)
    np.testing.assert_allclose(back.creepage, -there.creepage[[0, 2, 1, 4, 3]], rtol=1e-10)


@pytest.mark.long
def test_hysteresis_and_oil_of_the_check_case(rolled):
    """Their sizes scale from T1: hysteresis with N a/R, the oil's as 1.47 U^(3/4) E' R where bodies deform."""
    found = rolled(conditions(), sun_speed=100.0)
    speed = 4e-3 * (100.0 + 100.0 / 9.0 * (1.0 - float(found.speed_loss)))
    speed *= 1.0 - 0.5 * float(found.creepage[0])
    radius, width = 4e-3 * 13.5 / 17.5, 0.1667e-3 / 2.0
    hysteresis = 3 * 0.01 * float(found.normal[0]) * 2 * width * speed / (3 * math.pi * radius)
    assert float(found.power.hysteresis[0]) == pytest.approx(hysteresis, rel=1e-3)
    scale = 2 * 113.187e9 * radius
    oil = 3 * 2 * 5e-3 * speed * 1.47 * (2 * 0.0305 * speed / scale) ** 0.75 * scale
    assert float(found.power.oil[0]) == pytest.approx(oil, rel=3e-3)
    # creep and oil are what enters at the sun, by its moment, and does not leave
    drag = float(found.drag[0])
    assert drag == pytest.approx(oil / (3 * 2 * speed), rel=3e-3)
    entered = 3 * 4e-3 * (float(found.tangential[0]) + drag) * 100.0
    lost = float(np.sum(found.power.creep) + np.sum(found.power.oil))
    assert entered - 5.0 * float(found.output_speed) == pytest.approx(lost, rel=1e-9)
    for part in ("hysteresis", "oil"):
        assert np.all(np.isnan(getattr(rolled().power, part)))
    causes = [float(np.sum(getattr(found.power, part))) for part in ("creep", "skew", "hysteresis", "oil")]
    assert float(found.power.loss) == pytest.approx(sum(causes) + float(found.power.bearings), rel=1e-12)
    assert float(found.power.efficiency) == pytest.approx(float(found.power.output / found.power.input))


@pytest.mark.long
def test_skew_of_the_sun_contact(rolled):
    """1 mrad takes 39 % of mu N sideways from smooth bodies without torque (46 N at 1000 N)."""
    angles = (1e-3, 0.0, 0.0, 0.0, 0.0)
    free = rolled(conditions(skew=angles), output_torque=0.0, sun_speed=100.0, **SMOOTH)
    assert float(free.axial_force[0]) == pytest.approx(46.6, rel=0.01)
    found, straight = rolled(conditions(skew=angles)), rolled()
    assert float(found.skew_creepage_factor[0]) > 1.04
    np.testing.assert_allclose(found.skew_creepage_factor[1:], 1.0, rtol=1e-14)
    assert 0.0 < float(found.capacity_loss[0]) < 0.1
    assert float(found.speed_loss) > float(straight.speed_loss)
    thrust = dict(zip(BODIES, np.asarray(found.axial_thrust), strict=True))
    assert thrust["sun"] == pytest.approx(-3.0 * float(found.axial_force[0]))
    assert thrust["planet"] == pytest.approx(float(found.axial_force[0]))
    assert float(found.power.skew[0]) == pytest.approx(
        3.0
        * float(found.axial_force[0])
        * 1e-3
        * float(found.power.creep[0])
        / (3.0 * float(found.tangential[0] * found.creepage[0]))
    )
    opposite = rolled(conditions(skew=tuple(-angle for angle in angles)))
    np.testing.assert_allclose(opposite.axial_force, -found.axial_force, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(opposite.creepage, found.creepage, rtol=1e-12)


@pytest.mark.slow
def test_thrusts_balance(rolled):
    found = rolled(conditions(skew=(1e-3, 5e-4, -3e-4, 8e-4, -1e-3)))
    times = np.array([1.0, 3.0, 3.0, 3.0, 1.0])
    assert np.sum(times * np.asarray(found.axial_thrust)) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.long
def test_no_skew_is_skew_zero(rolled):
    plain, zero = rolled(conditions(skew=None)), rolled(conditions())
    np.testing.assert_allclose(zero.creepage, plain.creepage, rtol=1e-9)
    np.testing.assert_array_equal(zero.axial_force, 0.0)


def lives_by_hand(found, reliability):
    """Coy, Loewenthal and Zaretsky for every track, cycles counted on the kinematics without creep, in output turns."""
    sun, planet, roller, ring, count = 4e-3, 13.5e-3, 5e-3, 40e-3, 3
    normal = np.asarray(found.normal)
    turns = {"s": ring / sun, "p": ring / planet, "r": ring / roller, "l": ring / roller, "o": 1.0}
    radius = {"s": sun, "p": planet, "r": roller, "l": roller, "o": ring}
    rate = {"s": 0.0, "p": 0.0, "r": 0.0, "l": 0.0, "o": 0.0}
    e = 10 / 9
    for load, one, two in zip(normal, "spprl", "prloo", strict=True):
        internal = two == "o"
        effective = (
            radius[one] * radius[two] / (radius[two] - radius[one] if internal else radius[one] + radius[two])
        )
        a = math.sqrt(4 * load / 5e-3 * effective / (math.pi * 206e9 / 1.82))
        p0 = 2 * load / 5e-3 / (math.pi * a)
        for body in (one, two):
            volume = 5e-3 * a / 2 * TURN * radius[body]
            cycles = 1e6 * (1.430e95 * (a / 2) ** (7 / 3) / ((p0 / 4) ** (31 / 3) * volume)) ** (1 / e)
            passes = count if body in "so" else 1
            rate[body] += (turns[body] * passes / cycles) ** e
    weight = {"s": 1, "p": 3, "r": 3, "l": 3, "o": 1}
    factor = (math.log(1 / reliability) / math.log(1 / 0.9)) ** (1 / e)
    body = {name: factor * value ** (-1 / e) for name, value in rate.items()}
    drive = factor * sum(weight[name] * value for name, value in rate.items()) ** (-1 / e)
    return body, drive


@pytest.mark.slow
@pytest.mark.parametrize("reliability", [0.9, 0.99])
def test_life_of_bodies_and_drive(rolled, reliability):
    found = rolled(conditions(reliability=reliability), sun_speed=100.0, **HARD)
    body, drive = lives_by_hand(found, reliability)
    # the sun turns a little more often than without creep
    np.testing.assert_allclose(found.life_turns.body, list(body.values()), rtol=4e-3)
    assert float(found.life_turns.drive) == pytest.approx(drive, rel=4e-3)
    again = (3.0 * np.sum(np.asarray(found.life_turns.contact) ** (-10 / 9))) ** (-9 / 10)
    assert float(found.life_turns.drive) == pytest.approx(again, rel=1e-12)
    speed = 100.0 / 9.0 * (1.0 - float(found.speed_loss))
    hours = float(found.life_turns.drive) * TURN / speed / 3600.0
    assert float(found.life_hours.drive) == pytest.approx(hours, rel=1e-9)


@pytest.mark.long
def test_duty_of_one_load_is_that_load(rolled):
    duty = (DutyPoint(5.0, 100.0, 0.25), DutyPoint(5.0, 100.0, 0.7), DutyPoint(5.0, 100.0, 0.05))
    found = rolled(conditions(duty=duty), sun_speed=100.0, **HARD)
    assert float(found.duty_life_hours) == pytest.approx(float(found.life_hours.drive), rel=1e-9)
    assert float(found.duty_life_turns) == pytest.approx(float(found.life_turns.drive), rel=1e-9)


@pytest.mark.long
def test_miners_sum_over_a_duty(rolled):
    """A load that leaves the standing drive unharmed half of the time doubles the hours; braking counts too."""
    loads = [(8.0, 100.0, 0.3), (-2.0, 50.0, 0.2), (3.0, 0.0, 0.5)]
    found = rolled(conditions(duty=tuple(DutyPoint(*load) for load in loads)), sun_speed=100.0, **HARD)
    damage = 0.0
    for torque, speed, share in loads:
        if speed > 0.0:
            alone = rolled(conditions(), output_torque=torque, sun_speed=speed, **HARD)
            # every track by itself: Miner's sum is linear
            seconds = alone.cycles / (alone.cycles_per_turn * alone.output_speed / TURN)
            damage = damage + share / np.asarray(seconds)
    tracks = damage * 3600.0
    times = np.array([[1, 3, 3, 3, 3], [3, 3, 3, 1, 1]])
    times[0, 0] = 1
    rate = 0.0
    for body, places in enumerate(
        [[(0, 0)], [(1, 0), (0, 1), (0, 2)], [(1, 1), (0, 3)], [(1, 2), (0, 4)], [(1, 3), (1, 4)]]
    ):
        rate += (1 if body in (0, 4) else 3) * sum(tracks[place] ** (10 / 9) for place in places)
    assert float(found.duty_life_hours) == pytest.approx(rate ** (-9 / 10), rel=1e-9)
    slipping = rolled(
        conditions(duty=tuple(DutyPoint(torque, 100.0, 0.3) for torque in (1.0, 2.0, 30.0))), **HARD
    )
    assert np.isnan(float(slipping.duty_life_hours))
    assert np.isnan(float(rolled(**HARD).duty_life_hours))


@pytest.mark.long
def test_damage_of_a_load_is_what_its_duration_takes_from_the_life(rolled):
    """D_j = -d ln(life)/d ln(time at load j), by differences; a drive that stands is not damaged."""

    def found(*factors):
        loads = [(8.0, 100.0, 0.1), (3.0, 200.0, 0.5), (1.0, 0.0, 0.4)]
        points = tuple(DutyPoint(t, n, s * f) for (t, n, s), f in zip(loads, factors, strict=True))
        return rolled(conditions(duty=points), sun_speed=100.0, **HARD)

    whole = found(1.0, 1.0, 1.0)
    shares = np.asarray(whole.duty_damage_shares)
    assert shares.sum() == pytest.approx(1.0, rel=1e-12)
    assert shares[2] == 0.0
    assert 0.0 < shares[0] < 1.0
    for load in range(2):
        life = [
            float(found(*(factor if load == k else 1.0 for k in range(3))).duty_life_hours)
            for factor in (0.999, 1.001)
        ]
        slope = math.log(life[1] / life[0]) / math.log(1.001 / 0.999)
        assert shares[load] == pytest.approx(-slope, rel=1e-5)
    alone = rolled(conditions(), output_torque=8.0, sun_speed=100.0, **HARD).life_hours.drive
    assert float(whole.duty_load_hours[0]) == pytest.approx(float(alone), rel=1e-9)
    assert np.isnan(float(whole.duty_load_hours[2]))
    assert rolled().duty_damage_shares.shape == (0,)


@pytest.mark.slow
def test_slip_ratio_in_rolling_counts_what_skew_takes(rolled):
    parallel, skewed = rolled(), rolled(conditions(skew=(1e-3,) * 5))
    expected = np.asarray(parallel.tangential) / (0.12 * np.asarray(parallel.normal))
    np.testing.assert_allclose(parallel.slip_ratio, expected, rtol=1e-12)
    left = 1.0 - np.asarray(skewed.capacity_loss)
    assert np.all(left < 0.99)
    expected = np.asarray(skewed.tangential) / (0.12 * left * np.asarray(skewed.normal))
    np.testing.assert_allclose(skewed.slip_ratio, expected, rtol=1e-12)


def test_shakedown_ratio(rolled):
    """Friction of 0.05 at 3.772 k; the paper's steel has k = 450/sqrt(3) MPa."""
    found = rolled()
    pressure = 1529e6
    table = np.interp(float(found.traction_coefficient[0]), [0.02, 0.05], [3.906, 3.772])
    expected = pressure / (table * 450e6 / math.sqrt(3.0))
    assert float(found.shakedown_ratio[0]) == pytest.approx(expected, rel=2e-3)


@pytest.mark.slow
def test_at_rest_only_what_needs_no_time_is_there(rolled):
    found = rolled(conditions(), sun_speed=0.0, **HARD)
    for there in (found.drift_per_output_turn, found.life_turns.drive, found.creepage, found.cycles_per_turn):
        assert np.all(np.isfinite(there))
    absent = (found.drift_rate, found.life_hours.drive, found.power.loss, found.power.efficiency)
    assert all(np.isnan(float(value)) for value in absent)


@pytest.mark.long
def test_nothing_is_said_of_a_contact_that_slips_or_has_no_stiffness(paper_joint, evaluated_together):
    joint = paper_joint(output_torque=np.array([30.0, 5.0]), fractal_dimension=np.array([1.4, 1.1]))
    assert all(np.all(np.isnan(leaf)) for leaf in jax.tree.leaves(evaluated_together(joint).rolling))


@pytest.mark.long
@pytest.mark.parametrize("speed", [0.0, 100.0])
def test_gradients_are_finite_and_right(traced, speed):
    given = conditions(skew=(5e-4,) * 5)

    @jax.jit
    def numbers(torque):
        found = traced(given, output_torque=torque, input_speed=speed)
        timed = found.power.efficiency if speed else found.drift_per_output_turn
        return jnp.stack([found.speed_loss, jnp.log(found.life_turns.drive), found.axial_force[0], timed])

    slopes = jax.jit(jax.jacfwd(numbers))
    expected = (numbers(4.0 + 1e-4) - numbers(4.0 - 1e-4)) / 2e-4
    np.testing.assert_allclose(slopes(4.0), expected, rtol=2e-5)
    assert np.all(np.isfinite(slopes(0.0)))


def test_conditions_are_pytrees_without_leaves_where_nothing_is_given():
    assert len(jax.tree.leaves(PLAIN_ROLLING)) == 1
    assert isinstance(PLAIN_ROLLING, RollingConditions)

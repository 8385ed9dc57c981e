"""Wind-up: closed forms for a Mindlin spring, an independent quadrature for the joint, and refusals."""

import dataclasses

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.play import NO_PLAY, Play
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.show.windup_figure import windup_figure
from asperity.standing.windup import is_symmetric, windup, windup_of

STAGES = (1.0 / 3.0, 2.0 / 3.0)
K0, LIMIT, LARGEST = 2.0e4, 10.0, 8.0


def mindlin_compliances(torque):
    """With slip and without."""
    return (1.0 - jnp.abs(torque) / LIMIT) ** (-1.0 / 3.0) / K0, jnp.full_like(torque, 1.0 / K0)


def mindlin_angle(torque):
    """The integral of 1/K in closed form."""
    return 1.5 * LIMIT / K0 * (1.0 - (1.0 - torque / LIMIT) ** (2.0 / 3.0))


@pytest.fixture(scope="module")
def mindlin():
    return windup_of(mindlin_compliances, largest_torque=LARGEST, stage_shares=STAGES, play=NO_PLAY)


def test_loading_curve_of_a_mindlin_spring(mindlin):
    torque = np.asarray(mindlin.torque)
    expected = np.sign(torque) * mindlin_angle(np.abs(torque))
    np.testing.assert_allclose(mindlin.angle, expected, rtol=1e-10, atol=1e-18)


def test_unloading_follows_masing(mindlin):
    torque = np.asarray(mindlin.torque)
    expected = mindlin_angle(LARGEST) - 2.0 * mindlin_angle((LARGEST - torque) / 2.0)
    # where the branch crosses zero, an error over the angle itself has no meaning
    near_zero = 1e-10 * mindlin_angle(LARGEST)
    np.testing.assert_allclose(mindlin.unloading_angle, expected, rtol=1e-9, atol=near_zero)
    np.testing.assert_allclose(mindlin.reloading_angle, -expected[::-1], rtol=1e-9, atol=near_zero)
    np.testing.assert_allclose(torque, -torque[::-1], atol=1e-9)


@pytest.mark.parametrize("share", [0.5, 0.9, 0.99, 0.999])
def test_loops_up_to_nearly_the_capacity_are_exact(share):
    """Four nodes in every panel err by 2e-4 at 99.9 %."""
    largest = share * LIMIT
    found = windup_of(mindlin_compliances, largest_torque=largest, stage_shares=STAGES, play=NO_PLAY)
    half = mindlin_angle(largest) - 2.0 * mindlin_angle(largest / 2.0)
    assert float(found.hysteresis) == pytest.approx(2.0 * half, rel=1e-6)
    assert float(found.angle[-1]) == pytest.approx(mindlin_angle(largest), rel=1e-7)


def test_figures_of_the_loop_of_a_mindlin_spring(mindlin):
    def unloading(torque):
        return mindlin_angle(LARGEST) - 2.0 * mindlin_angle((LARGEST - torque) / 2.0)

    assert float(mindlin.hysteresis) == pytest.approx(2.0 * unloading(0.0), rel=1e-9)
    lost = unloading(0.03 * LARGEST) - unloading(-0.03 * LARGEST)
    assert float(mindlin.lost_motion) == pytest.approx(lost, rel=1e-9)
    loop = np.linspace(-LARGEST, LARGEST, 20001)
    area = np.trapezoid(unloading(loop) + unloading(-loop), loop)
    assert float(mindlin.dissipated_energy) == pytest.approx(area, rel=1e-6)


def test_stages_are_secants_of_the_loading_curve(mindlin):
    bounds = np.array([0.0, *STAGES, 1.0]) * LARGEST
    expected = np.diff(bounds) / np.diff(mindlin_angle(bounds))
    np.testing.assert_allclose(mindlin.stage_stiffness, expected, rtol=1e-9)
    np.testing.assert_allclose(mindlin.stage_torque, bounds, rtol=1e-12)


def constant_compliance(torque):
    return jnp.full_like(torque, 1.0 / K0), jnp.full_like(torque, 1.0 / K0)


def test_a_linear_spring_loses_nothing():
    curve = windup_of(constant_compliance, largest_torque=5.0, stage_shares=STAGES, play=NO_PLAY)
    assert abs(float(curve.hysteresis)) < 1e-15
    assert abs(float(curve.dissipated_energy)) < 1e-14
    assert float(curve.lost_motion) == pytest.approx(2.0 * 0.03 * 5.0 / K0, rel=1e-9)


@pytest.fixture(scope="module")
def joint_curve(paper_joint):
    return windup(
        paper_joint(ring_wall_thickness=60e-3), largest_torque=12.0, level="assembly", stage_shares=STAGES
    )


@pytest.mark.slow
def test_the_joint_agrees_with_a_trapezoidal_integration_of_its_own_stiffness(joint_curve):
    """A second quadrature rule on the tabulated stiffness; its error is the trapezoid's."""
    half = joint_curve.torque >= 0.0
    torque, stiffness = np.asarray(joint_curve.torque)[half], np.asarray(joint_curve.stiffness)[half]
    coarse = np.trapezoid(1.0 / stiffness, torque)
    assert float(joint_curve.angle[-1]) == pytest.approx(coarse, rel=1e-4)
    assert np.all(np.diff(stiffness) < 0.0)
    assert float(joint_curve.hysteresis) > 0.0


@pytest.mark.slow
def test_past_the_capacity_is_refused_with_the_torque(paper_joint):
    with pytest.raises(
        InputError, match=r"14 N·m is beyond the standing torque capacity: contact sp slips at 1[34]"
    ):
        windup(
            paper_joint(ring_wall_thickness=60e-3),
            largest_torque=14.0,
            level="published",
            stage_shares=STAGES,
        )


@pytest.mark.parametrize("stages", [(0.5, 0.4), (0.0, 0.5), (0.5, 1.0)])
def test_stages_out_of_order_are_refused(stages):
    with pytest.raises(InputError, match="out of order"):
        windup_of(mindlin_compliances, largest_torque=LARGEST, stage_shares=stages, play=NO_PLAY)


@pytest.mark.parametrize("torque", [0.0, -1.0, float("nan"), float("inf")])
def test_a_torque_that_is_no_torque_is_refused(torque):
    with pytest.raises(InputError, match="must be positive and finite"):
        windup_of(mindlin_compliances, largest_torque=torque, stage_shares=STAGES, play=NO_PLAY)


def test_a_spring_that_hardens_without_slip_has_no_loop():
    """Normal forces that change with the torque are reversible: 1/K = (1 + T/8)/K0 in both directions, no slip."""

    def compliances(torque):
        return (1.0 + torque / 8.0) / K0, (1.0 + torque / 8.0) / K0

    curve = windup_of(compliances, largest_torque=6.0, stage_shares=STAGES, play=NO_PLAY)
    torque = np.asarray(curve.torque)
    expected = (torque + torque**2 / 16.0) / K0
    for branch in (curve.angle, curve.unloading_angle, curve.reloading_angle):
        np.testing.assert_allclose(branch, expected, rtol=1e-12, atol=1e-17)
    assert float(curve.hysteresis) == float(curve.dissipated_energy) == 0.0
    bounds = np.array([0.0, 2.0, 4.0, 6.0])
    np.testing.assert_allclose(
        curve.stage_stiffness, 2.0 * K0 / np.diff(bounds + bounds**2 / 16.0), rtol=1e-12
    )
    np.testing.assert_allclose(
        curve.reverse_stage_stiffness, 2.0 * K0 / np.diff(bounds - bounds**2 / 16.0), rtol=1e-12
    )


def test_slip_that_differs_between_the_directions_closes_its_loop():
    """Quadratic slip angles 3 c T² and c T² on a spring: Masing's rule of their mean, 2 c T², in closed form."""
    c, largest = 1e-7, 5.0

    def compliances(torque):
        slip = jnp.where(torque > 0.0, 6.0 * c * torque, -2.0 * c * torque)
        return 1.0 / K0 + slip, jnp.full_like(torque, 1.0 / K0)

    curve = windup_of(compliances, largest_torque=largest, stage_shares=STAGES, play=NO_PLAY)
    ends = np.asarray(curve.angle)[[0, -1]]
    np.testing.assert_allclose(ends, [-largest / K0 - c * 25.0, largest / K0 + 3.0 * c * 25.0], rtol=1e-12)
    for branch in (curve.unloading_angle, curve.reloading_angle):
        np.testing.assert_allclose(np.asarray(branch)[[0, -1]], ends, rtol=1e-12)
    # width: 2 [g(Tm) − 2 g(Tm/2)] = 2 c Tm²; area of both branches: 4 (2 ∫ T dg − Tm g(Tm)) = 4 (8/3 − 2) c Tm³
    assert float(curve.hysteresis) == pytest.approx(2.0 * c * 25.0, rel=1e-9)
    assert float(curve.dissipated_energy) == pytest.approx(4.0 * 2.0 / 3.0 * c * 125.0, rel=1e-9)


@pytest.mark.parametrize("width", [0.0, 0.5])
def test_play_is_part_of_every_curve(width):
    """A spring with 0.01 rad of play: every figure by hand."""
    play = Play(angle=0.01, take_up_torque=width)
    curve = windup_of(constant_compliance, largest_torque=6.0, stage_shares=STAGES, play=play)
    torque = np.asarray(curve.torque)
    taken = np.sign(torque) if width == 0.0 else np.tanh(torque / width)
    for branch in (curve.angle, curve.unloading_angle, curve.reloading_angle):
        np.testing.assert_allclose(branch, torque / K0 + 0.005 * taken, rtol=1e-9, atol=1e-15)
    at = np.array([0.0, 2.0, 4.0, 6.0])
    there = at / K0 + 0.005 * (np.sign(at) if width == 0.0 else np.tanh(at / width))
    np.testing.assert_allclose(curve.stage_stiffness, 2.0 / np.diff(there), rtol=1e-9)
    small = 0.18
    lost = 2.0 * (small / K0 + 0.005 * (1.0 if width == 0.0 else np.tanh(small / width)))
    assert float(curve.lost_motion) == pytest.approx(lost, rel=1e-9)
    assert float(curve.hysteresis) == pytest.approx(0.0, abs=1e-15)
    inside = np.argmin(np.abs(torque - 0.3))
    slope = 0.0 if width == 0.0 else 0.01 / (2 * width) / np.cosh(torque[inside] / width) ** 2
    assert float(curve.stiffness[inside]) == pytest.approx(1.0 / (1.0 / K0 + slope), rel=1e-9)


@pytest.mark.slow
def test_without_slip_the_joint_has_no_loop(paper_joint):
    joint = paper_joint(friction_coefficient=1e6)
    for level in ("published", "assembly"):
        curve = windup(joint, largest_torque=12.0, level=level, stage_shares=STAGES)
        assert abs(float(curve.hysteresis)) < 1e-7 * float(curve.angle[-1])
        assert abs(float(curve.dissipated_energy)) < 1e-7 * 12.0 * float(curve.angle[-1])


def directions(joint):
    curve = windup(joint, largest_torque=10.0, level="assembly")
    np.testing.assert_allclose(curve.stage_torque, np.array([0.0, 1.0, 2.0, 3.0]) * 10.0 / 3.0, rtol=1e-12)
    return curve, np.asarray(curve.angle), -np.asarray(curve.angle)[::-1]


@pytest.mark.long
@pytest.mark.parametrize("speed", [0.0, 600.0])
def test_a_symmetric_joint_is_mirrored(paper_joint, speed):
    """With friction in every bearing, turning or not."""
    friction = {"loading_roller_torque": 1e-3, "carrier_torque": 1e-3, "sun_torque": 1e-3}
    pins = {"pin_friction_coefficient": 0.01, "pin_diameter": 4e-3}
    curve, forward, reverse = directions(paper_joint(sun_speed=speed, **friction, **pins))
    np.testing.assert_allclose(forward, reverse, rtol=1e-12, atol=1e-18)
    np.testing.assert_allclose(curve.stage_stiffness, curve.reverse_stage_stiffness, rtol=1e-12)


@pytest.mark.long
@pytest.mark.parametrize(
    "changes", [{"closure": "constant_pin_force"}, {"left_push_angle": 0.3, "right_push_angle": -0.1}]
)
def test_an_asymmetric_joint_has_two_directions_that_swap_with_its_sides(paper_joint, changes):
    curve, forward, reverse = directions(paper_joint(**changes))
    assert np.max(np.abs(forward - reverse)) > 1e-3 * forward[-1]
    if "left_push_angle" in changes:
        swapped = {"left_push_angle": -0.1, "right_push_angle": 0.3}
        other, other_forward, _ = directions(paper_joint(**swapped))
        np.testing.assert_allclose(other_forward, reverse, rtol=1e-10, atol=1e-16)
        assert float(other.hysteresis) == pytest.approx(float(curve.hysteresis), rel=1e-9)


@pytest.mark.long
def test_stiffness_of_both_directions_is_that_of_the_solver(paper_joint):
    """With a constant pin force the paper's joint is stiffer at plus than at minus 8 N·m."""
    curve = windup(
        paper_joint(closure="constant_pin_force"), largest_torque=10.0, level="assembly", stage_shares=STAGES
    )
    at = {torque: int(np.argmin(np.abs(np.asarray(curve.torque) - torque))) for torque in (-8.0, 8.0)}
    for torque, index in at.items():
        solved = solve_joint(paper_joint(closure="constant_pin_force", output_torque=torque)).result
        assert float(curve.stiffness[index]) == pytest.approx(
            float(solved.assembly.stiffness.output), rel=1e-9
        )


def test_figure_names_its_axes_with_units(mindlin):
    loop, deviation, stiffness = windup_figure(mindlin, title="spring").axes
    assert " ".join(deviation.get_ylabel().split()) == "angle less a straight line [arcsec]"
    assert "arcmin" in loop.get_xlabel()
    assert "N·m" in loop.get_ylabel()
    assert "N·m/arcmin" in stiffness.get_ylabel()


def test_sectors_that_are_their_own_mirror_images(planar_case):
    """Loading rollers are images of each other; a multiroller's second row lies midway between the first."""
    for name, expected in (
        ("planetary", True),
        ("stepped_planet", True),
        ("multiroller", True),
        ("planar", True),
    ):
        assert is_symmetric(joint_from_case(planar_case(name))) is expected
    joint = joint_from_case(planar_case("planetary"))
    pushed = dataclasses.replace(joint.drive, push_angles=np.array([0.1]))
    assert not is_symmetric(dataclasses.replace(joint, drive=pushed))
    listed = joint_from_case(planar_case("planar"))
    lengths = tuple(0.01 if name == "wlo" else 0.02 for name in listed.contact_names)
    assert not is_symmetric(dataclasses.replace(listed, contact_lengths=lengths))
    left = [body.name for body in listed.drive.bodies].index("left")
    softer = dataclasses.replace(listed.materials[left], youngs_modulus=np.asarray(1e11))
    materials = (*listed.materials[:left], softer, *listed.materials[left + 1 :])
    assert not is_symmetric(dataclasses.replace(listed, materials=materials))
    multiroller = joint_from_case(planar_case("multiroller"))
    names = multiroller.contact_names
    for uneven, expected in (("fsl", False), ("sf", True)):
        friction = tuple(0.05 if name == uneven else 0.08 for name in names)
        assert is_symmetric(dataclasses.replace(multiroller, friction_coefficients=friction)) is expected


def test_which_joints_are_symmetric(paper_joint):
    joint = paper_joint()
    assert is_symmetric(joint)
    assert not is_symmetric(paper_joint(closure="constant_pin_force"))
    assert not is_symmetric(paper_joint(left_push_angle=0.1))
    for values, expected in (((0.1, 0.2, 0.2, 0.3, 0.3), True), ((0.1, 0.2, 0.2, 0.3, 0.4), False)):
        assert is_symmetric(dataclasses.replace(joint, friction_coefficients=values)) is expected
    (surface,) = joint.surfaces
    other = dataclasses.replace(surface, fractal_dimension=np.asarray(1.5))
    assert is_symmetric(dataclasses.replace(joint, surfaces=(other, surface, surface, surface, surface)))
    assert not is_symmetric(dataclasses.replace(joint, surfaces=(surface, other, surface, surface, surface)))


def test_fewer_steps_are_the_same_curve():
    """Mindlin's law to 90 % of its friction, with half the steps."""
    fine, coarse = (
        windup_of(
            mindlin_compliances, largest_torque=0.9 * LARGEST, stage_shares=STAGES, play=NO_PLAY, steps=steps
        )
        for steps in (40, 20)
    )
    shown = np.isin(np.round(fine.torque, 9), np.round(coarse.torque, 9))
    assert coarse.torque.size < 0.6 * fine.torque.size
    for name in ("angle", "unloading_angle", "reloading_angle"):
        np.testing.assert_allclose(
            np.asarray(getattr(fine, name))[shown], getattr(coarse, name), rtol=1e-6, atol=1e-12
        )
    assert float(coarse.hysteresis) == pytest.approx(float(fine.hysteresis), rel=1e-5)

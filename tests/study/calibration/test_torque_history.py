"""Torque histories against Masing loops written out by hand for a cubic loading curve."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.calibration.torque_history import curve_operator, cycled_before

A, B = 1e-5, 2e-8


def phi(torque):
    return A * torque + B * torque**3


def angles(torques, history="virgin", symmetric=True):
    """All of the curve's curvature is slip."""
    operator = curve_operator(np.asarray(torques, float), history, symmetric=symmetric)
    return operator.weights @ (A + np.where(operator.slips, 3.0 * B * operator.torque**2, 0.0))


def test_loading_curve_and_mirror_image():
    assert angles([0.0, 3.0, 10.0]) == pytest.approx([0.0, phi(3.0), phi(10.0)], rel=1e-13)
    assert angles([-2.0, -10.0]) == pytest.approx([-phi(2.0), -phi(10.0)], rel=1e-13)


def test_unloading_is_twice_the_loading_curve():
    expected = [phi(10.0), phi(10.0) - 2 * phi(3.0), phi(10.0) - 2 * phi(5.0), -phi(10.0)]
    assert angles([10.0, 4.0, 0.0, -10.0]) == pytest.approx(expected, rel=1e-12, abs=1e-18)


def test_loop_closes_and_goes_on_along_the_loading_curve():
    found = angles([10.0, -10.0, 0.0, 10.0, 12.0])
    assert found[2] == pytest.approx(-(phi(10.0) - 2 * phi(5.0)), rel=1e-12)
    assert found[3:] == pytest.approx([phi(10.0), phi(12.0)], rel=1e-12)


def test_inner_loop_is_forgotten_when_it_closes():
    with_inner = angles([10.0, 2.0, 6.0, 2.0, -3.0])
    assert with_inner[3] == pytest.approx(with_inner[1], rel=1e-12)
    assert with_inner[4] == pytest.approx(angles([10.0, -3.0])[1], rel=1e-12)


def test_cycled_joint_starts_on_the_loop():
    assert angles([-10.0, 0.0, 10.0], "cycled") == pytest.approx(
        [-phi(10.0), -(phi(10.0) - 2 * phi(5.0)), phi(10.0)], rel=1e-12
    )


def test_tiny_reversals_hardly_matter():
    rng = np.random.default_rng(0)
    smooth = np.concatenate([np.linspace(0, 10, 200), np.linspace(10, -10, 400)])
    noisy = smooth + 1e-4 * rng.standard_normal(smooth.size)
    assert angles(noisy) == pytest.approx(angles(smooth), abs=4e-4 * (A + 3 * B * 100))


def test_no_torque_is_refused():
    with pytest.raises(InputError, match="all measured torques are zero"):
        curve_operator(np.zeros(3), "virgin", symmetric=True)


def test_full_loops_of_a_mindlin_spring_near_its_capacity():
    """K = K0 (1 - T/Tc)^(1/3) in closed form; the error of the fixed panels grows towards the capacity."""
    stiffness, capacity = 2.0e4, 13.17

    def loading(torque):
        return 1.5 * capacity / stiffness * (1.0 - (1.0 - torque / capacity) ** (2.0 / 3.0))

    for largest, allowed in ((5.0, 2e-10), (10.0, 1e-7), (12.0, 5e-6)):
        down = np.linspace(largest, -largest, 41)
        operator = curve_operator(np.concatenate([[largest], down[1:]]), "virgin", symmetric=True)
        slip = np.where(operator.slips, (1.0 - operator.torque / capacity) ** (-1.0 / 3.0), 1.0)
        found = operator.weights @ slip / stiffness
        expected = loading(largest) - 2.0 * loading((largest - down) / 2.0)
        assert np.max(np.abs(found - expected)) < allowed * loading(largest)


C, D = 3e-7, 1e-7  # a reversible softening by the torque, and a slip that differs between the directions


def reversible(torque):
    return A * torque + 0.5 * C * torque**2


def slip(torque):
    return (B + D) * torque**3 if torque > 0.0 else (B - D) * torque**3


def asymmetric(torques, history="virgin"):
    operator = curve_operator(np.asarray(torques, float), history, symmetric=False)
    t = operator.torque
    slipping = 3.0 * np.where(t > 0.0, B + D, B - D) * t**2
    return operator, operator.weights @ (A + C * t + np.where(operator.slips, slipping, 0.0))


def test_two_directions_and_what_is_reversible():
    """Both virgin curves are their own; a closed loop is Masing's rule of the mean slip, 2 B T³, on what is left."""
    loading = [1.0, 6.0]
    _, found = asymmetric(loading)
    assert found == pytest.approx([reversible(t) + slip(t) for t in loading], rel=1e-12)
    _, found = asymmetric([-1.0, -6.0])
    assert found == pytest.approx([reversible(-t) + slip(-t) for t in loading], rel=1e-12)
    _, found = asymmetric([6.0, 0.0, -6.0, 0.0, 6.0])
    rest = np.array([reversible(t) + slip(t) - B * t**3 for t in (6.0, 0.0, -6.0, 0.0, 6.0)])
    hysteretic = np.array(
        [B * 216.0, B * 216.0 - 2 * B * 27.0, -B * 216.0, -B * 216.0 + 2 * B * 27.0, B * 216.0]
    )
    assert found == pytest.approx(rest + hysteretic, rel=1e-11)
    assert found[2] == pytest.approx(reversible(-6.0) + slip(-6.0), rel=1e-11)


def test_a_history_of_one_direction_asks_nothing_of_the_other():
    operator, found = asymmetric([6.0, 2.0, 6.0])
    assert np.all(operator.torque > 0.0)
    assert found[1] == pytest.approx(reversible(2.0) + slip(6.0) - 2.0 * slip(2.0), rel=1e-11)
    assert asymmetric([1.0, 6.0])[0].slips.all()  # no reversal: the curve without slip is not needed


@pytest.mark.parametrize(
    ("torques", "before"),
    [([], []), ([1.0, 3.0, -2.0], [3.0, -3.0]), ([3.0, 3.0, 1.0], [-3.0, 3.0]), ([2.0], [2.0, -2.0])],
)
def test_a_cycled_history_begins_on_the_branch_that_leads_on(torques, before):
    """A curve that first rises comes from the negative end, one that first falls from the positive one."""
    assert cycled_before(np.array(torques)) == before

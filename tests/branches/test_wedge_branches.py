"""Branches of unequal sizes of the paper's drive against published numbers and balances."""

import math

import numpy as np
import pytest

from asperity.branches.results import unequal_branches
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solved_case

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def branches(joint_text):
    """Planets with deviations in micrometres, and what holds the sun; bodies as springs."""

    def of(sizes, support=None):
        text = joint_text.replace('preload = "1000 N"', 'interference = "12.904 um"')
        text = text.replace('bodies = "exact"', 'bodies = "springs"').replace(
            'ring_support = "rigid_housing"', ""
        )
        text = text.replace(
            'yield_strength = "450 MPa"', 'yield_strength = "1200 MPa"'
        )  # stays elastic: has a life
        if support is not None:
            text = text.replace("[model]", f'[compliance]\nsun_support_stiffness = "{support}"\n\n[model]')
        text += "".join(f'\n[[branch]]\nplanet_deviation = "{size} um"\n' for size in sizes)
        solved = solved_case(parse_case(text, source="x"))
        return unequal_branches(solved.branches, solved.solution.states), solved.result

    return of


def test_five_micrometres_by_the_published_numbers(branches):
    """±5 um on a planet make 218 and 1854 N, computed independently; the pressure of a line grows as the root."""
    found, result = branches([5.0, 0.0, -5.0])
    assert found.preload == pytest.approx([1854.0, 1000.0, 218.0], abs=1.0)
    pressure, force = (
        np.reshape(values, (3, 5)) for values in (result.diagnostics.hertz_pressure, result.forces.normal)
    )
    assert pressure / pressure[1] == pytest.approx(np.sqrt(force / force[1]), rel=1e-6)
    shakedown = np.reshape(result.rolling.shakedown_ratio, (3, 5))[:, 0]
    assert shakedown[0] / shakedown[1] == pytest.approx(math.sqrt(1.854), rel=0.02)
    # Lundberg and Palmgren: the life of a line falls with the fourth power of its force
    lives = np.array(
        [np.asarray(result.rolling.life_hours.body)[names(result, f"planet_{k}")] for k in (1, 2)]
    )
    assert lives[0] / lives[1] == pytest.approx((1000.0 / 1854.0) ** 4, rel=0.05)


def names(result, body):
    return result.body_names.index(body)


@pytest.mark.long
@pytest.mark.parametrize("support", [None, "50 N/um"])
def test_nothing_acts_from_outside_on_sun_carrier_and_ring_together(branches, support):
    found, result = branches([2.0, 0.0, -2.0], support)
    for state in (found.rest, found.standing, found.rolling):
        total = state.central_force + sum(state.centre_forces.values())
        assert total == pytest.approx(np.zeros(2), abs=0.05)
        assert np.hypot(*state.centre_forces["ring"]) > 10.0
    # the torque of each branch at its pins, on the circle of the loading rollers
    turned = np.abs(np.reshape(result.forces.pins, (3, 2)).sum(axis=1)) * 35e-3
    assert turned == pytest.approx(found.standing.torque, rel=1e-6)
    shares = {name: np.sum(share) for name, share in vars(result.assembly).items() if name.endswith("_share")}
    assert sum(shares.values()) == pytest.approx(1.0, abs=1e-11)
    assert (shares["planet_support_share"] > 1e-9) == (support is not None)
    if support is not None:
        assert found.standing.central_force == pytest.approx(
            5e7 * found.standing.central_displacement, abs=0.05
        )


@pytest.mark.long
def test_a_floating_sun_presses_three_planets_alike(branches):
    """Its three forces balance only if they are equal."""
    found, _ = branches([3.0, 0.0, -1.0], "0 N/um")
    assert found.rest.central_force == pytest.approx(np.zeros(2), abs=1e-2)
    assert found.preload == pytest.approx(np.full(3, found.preload.mean()), rel=1e-3)
    assert np.hypot(*found.rest.central_displacement) > 1e-6

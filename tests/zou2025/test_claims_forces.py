"""C7 and C8 on made-up forces and stiffnesses, met and not met."""

import numpy as np
import pytest

from asperity.zou2025.claims_forces import contact_forces, contact_stiffnesses

TORQUE = np.linspace(0.0, 5.0, 11)


def verdicts(claim):
    return [statement.met for statement in claim.statements]


@pytest.fixture
def forces(made_up):
    def judged(normal_slopes, tangential_slopes):
        loads = {
            "output_torque": TORQUE,
            "normal_force": 500.0 + np.outer(normal_slopes, TORQUE)[..., None],
            "tangential_force": np.outer(tangential_slopes, TORQUE)[..., None],
        }
        return verdicts(contact_forces(made_up(loads=loads)))

    return judged


def test_contact_forces(forces):
    assert forces([0.5, 20, -20, 20, -20], [9, 5, 4, 5, 4]) == [True] * 4
    assert forces([-0.5, 20, -20, 20, -20], [9, 5, 4, 5, 4]) == [False, True, True, True]
    assert forces([0.5, 20, -20, 20, 20], [9, 5, 4, 5, 4]) == [True, False, True, True]
    assert forces([0.5, 20, -20, 20, -20], [9, 5, -4, 5, 4]) == [True, True, False, True]
    assert forces([0.5, 20, -20, 20, -20], [9, 4, 5, 5, 4]) == [True, True, True, False]


@pytest.fixture
def contacts(made_up):
    def claim(levels, split):
        """Left contacts are lower than right ones by ``split`` at full torque, in proportion to the torque."""
        base = np.array(levels)
        left = np.array([0.0, 0.0, 1.0, 0.0, 1.0])
        at_full = base * (1.0 - split * left)
        over_torque = base[:, None] * (1.0 - split * left[:, None] * TORQUE / 5.0)
        rising = np.linspace(1.0, 2.0, 21)
        return contact_stiffnesses(
            made_up(
                loads={"output_torque": TORQUE, "contact_torsional_stiffness": over_torque[..., None]},
                dimension={"contact_torsional_stiffness": np.outer(at_full, rising)[:, None]},
                roughness={"contact_torsional_stiffness": np.outer(at_full, rising[::-1])[:, None]},
            )
        )

    return claim


def test_contact_stiffnesses_that_agree(contacts):
    assert verdicts(contacts([9, 1, 1, 1, 1], 0.05)) == [True] * 5


def test_torque_up_to_which_left_and_right_agree(contacts):
    claim = contacts([9, 1, 1, 1, 1], 0.25)
    assert verdicts(claim) == [False, False, True, True, True]
    assert claim.statements[0].numbers["torque_up_to_which_nearly_the_same_Nm"] == 2.0
    assert abs(claim.statements[0].numbers["largest_difference"] - 0.25) < 1e-12


def test_sun_contact_must_be_significantly_stiffer(contacts):
    claim = contacts([1.1, 1, 1, 1, 1], 0.05)
    assert verdicts(claim) == [True, True, False, True, True]
    # the largest ratio, 1.1, with the sun's radius of 4 mm instead of the planet's of 13.5 mm
    ratio = claim.statements[2].numbers["largest_ratio_with_sun_radius"]
    assert ratio == pytest.approx(1.1 * (4.0 / 13.5) ** 2)

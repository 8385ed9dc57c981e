"""C7 and C8 on made-up forces and stiffnesses, both ways."""

import numpy as np

from asperity.zou2025.claims_forces import contact_claim, load_claim
from asperity.zou2025.verdict import Claim

TORQUE = np.linspace(0.0, 5.0, 11)


def verdicts(claim: Claim) -> list[bool]:
    return [statement.met for statement in claim.statements]


def forces(normal_slopes: list[float], tangential_slopes: list[float]) -> Claim:
    return load_claim(
        output_torque=TORQUE,
        normal_force=500.0 + np.outer(normal_slopes, TORQUE),
        tangential_force=np.outer(tangential_slopes, TORQUE),
    )


def test_c7() -> None:
    assert verdicts(forces([0.5, 20, -20, 20, -20], [9, 5, 4, 5, 4])) == [True] * 4
    assert verdicts(forces([-0.5, 20, -20, 20, -20], [9, 5, 4, 5, 4])) == [False, True, True, True]
    assert verdicts(forces([0.5, 20, -20, 20, 20], [9, 5, 4, 5, 4])) == [True, False, True, True]
    assert verdicts(forces([0.5, 20, -20, 20, -20], [9, 5, -4, 5, 4])) == [True, True, False, True]
    assert verdicts(forces([0.5, 20, -20, 20, -20], [9, 4, 5, 5, 4])) == [True, True, True, False]


def contacts(levels: list[float], split: float) -> Claim:
    """Left contacts are lower than right by ``split`` at full torque, in proportion to the torque."""
    base = np.array(levels)
    left = np.array([0.0, 0.0, 1.0, 0.0, 1.0])
    at_full = base * (1.0 - split * left)
    rising, falling = np.linspace(1.0, 2.0, 21), np.linspace(2.0, 1.0, 21)
    return contact_claim(
        output_torque=TORQUE,
        over_torque=base[:, None] * (1.0 - split * left[:, None] * TORQUE / 5.0),
        over_dimension=np.outer(at_full, rising),
        over_roughness=np.outer(at_full, falling),
        sun_over_planet_radius=0.3,
    )


def test_c8_met() -> None:
    assert verdicts(contacts([9, 1, 1, 1, 1], 0.05)) == [True] * 5


def test_c8_tells_the_torque_up_to_which_left_and_right_agree() -> None:
    claim = contacts([9, 1, 1, 1, 1], 0.25)
    assert verdicts(claim) == [False, False, True, True, True]
    assert claim.statements[0].numbers["torque_up_to_which_nearly_the_same_Nm"] == 2.0
    assert abs(claim.statements[0].numbers["largest_difference"] - 0.25) < 1e-12


def test_c8_wants_the_sun_contact_well_above() -> None:
    assert verdicts(contacts([1.1, 1, 1, 1, 1], 0.05)) == [True, True, False, True, True]

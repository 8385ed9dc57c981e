"""C9–C13 and the design window on made-up curves, both ways."""

from collections.abc import Callable

import numpy as np

from asperity.zou2025 import claims_joint
from asperity.zou2025.verdict import Claim

TORQUE = np.arange(3.0)
DIMENSION = np.linspace(1.3, 1.95, 261)


def verdicts(claim: Claim) -> list[bool]:
    return [statement.met for statement in claim.statements]


def bells(places: list[float], width: float) -> np.ndarray:
    return np.exp(-(((DIMENSION - np.array(places)[:, None]) / width) ** 2))


def test_c9_wants_every_torque() -> None:
    def claim(places: list[float]) -> Claim:
        return claims_joint.peak_claim(
            output_torque=TORQUE, dimension=DIMENSION, stiffness=bells(places, 0.1), stated=1.85
        )

    assert claim([1.85, 1.86, 1.84]).met
    assert not claim([1.85, 1.86, 1.80]).met


def test_c10() -> None:
    roughness = np.geomspace(1e-13, 1e-11, 9)
    rows = np.ones((3, 1))
    falling = claims_joint.roughness_claim(
        output_torque=TORQUE, roughness=roughness, stiffness=rows / roughness
    )
    assert falling.met
    assert not claims_joint.roughness_claim(
        output_torque=TORQUE, roughness=roughness, stiffness=rows * roughness
    ).met


def test_c11() -> None:
    def claim(per_torque: float) -> Claim:
        return claims_joint.torque_claim(
            output_torque=TORQUE, stiffness={"7a": np.outer(1.0 + per_torque * TORQUE, np.ones(4))}
        )

    assert verdicts(claim(-0.05)) == [True, True]
    assert verdicts(claim(-0.30)) == [True, False]
    assert verdicts(claim(+0.05)) == [False, True]
    assert "does not fall" in claim(+0.05).statements[0].evidence


def test_c12() -> None:
    def claim(gain: float, radius_power: float) -> Claim:
        length, scale = np.linspace(5e-3, 30e-3, 6), np.linspace(1.0, 2.0, 5)
        rows = np.ones((3, 1))
        return claims_joint.size_claim(
            output_torque=TORQUE,
            length=length,
            stiffness=rows * (1.0 + gain * (length - length[0]) / 25e-3),
            radius_scale=scale,
            radius_stiffness=rows * scale**radius_power,
        )

    assert verdicts(claim(0.5, 2.0)) == [True, True, True]
    assert verdicts(claim(0.03, 2.0)) == [True, False, True]
    assert verdicts(claim(-0.5, 0.1)) == [False, False, False]


def test_c13() -> None:
    friction = np.linspace(0.04, 0.3, 131)
    high = 0.3 * np.array([1.0, 2.0, 4.0])

    def claim(curve: Callable[[np.ndarray], np.ndarray]) -> Claim:
        return claims_joint.friction_claim(
            output_torque=np.array([5.0]),
            friction=friction,
            stiffness=curve(friction)[None],
            high_friction=high,
            high_stiffness=curve(high)[None],
        )

    def saturating(mu: np.ndarray) -> np.ndarray:
        return np.cbrt(np.clip(1.0 - 0.045 / mu, 0.0, None))

    assert verdicts(claim(saturating)) == [True, True, False]
    assert abs(claim(saturating).statements[0].numbers["friction_from_which_all_stick"] - 0.046) < 1e-9
    assert verdicts(claim(lambda mu: 1.0 + mu)) == [True, False, False]
    # a steep start alone is no saturation: these keep growing
    assert verdicts(claim(lambda mu: np.cbrt(mu - 0.0399))) == [True, False, False]
    assert verdicts(claim(lambda mu: np.log(mu / 0.0399))) == [True, False, False]
    humped = verdicts(claim(lambda mu: 1.0 - (mu - 0.2) ** 2))
    assert (humped[0], humped[2]) == (False, True)


def test_design_window() -> None:
    def claim(place: float, width: float) -> Claim:
        return claims_joint.window_claim(
            output_torque=TORQUE,
            dimension=DIMENSION,
            stiffness=bells([place] * 3, width),
            window=(1.7, 1.85),
        )

    assert verdicts(claim(1.78, 0.5)) == [True, True]
    assert verdicts(claim(1.86, 0.1)) == [True, False]
    assert verdicts(claim(1.5, 1.5)) == [False, True]

"""C1–C6 on made-up curves, both ways."""

import numpy as np

from asperity.zou2025 import claims_pair
from asperity.zou2025.verdict import Claim

FORCE = np.linspace(0.0, 1000.0, 51)
DIMENSION = np.linspace(1.3, 1.95, 261)


def verdicts(claim: Claim) -> list[bool]:
    return [statement.met for statement in claim.statements]


def test_c1() -> None:
    assert verdicts(claims_pair.normal_force_claim(normal_force=FORCE, stiffness=FORCE**0.8)) == [True, True]
    assert verdicts(claims_pair.normal_force_claim(normal_force=FORCE, stiffness=FORCE)) == [True, False]
    falling = claims_pair.normal_force_claim(normal_force=FORCE, stiffness=2e6 - FORCE**2)
    assert verdicts(falling) == [False, True]


def test_c2() -> None:
    force = np.linspace(0.0, 130.0, 131)
    left = np.clip(1.0 - force / 120.0, 0.0, None)
    good = claims_pair.tangential_force_claim(
        tangential_force=force, stiffness=np.cbrt(left), slip_force=120.0
    )
    assert verdicts(good) == [True, True, True]
    straight = claims_pair.tangential_force_claim(tangential_force=force, stiffness=left, slip_force=120.0)
    assert verdicts(straight) == [True, False, True]
    holding = claims_pair.tangential_force_claim(
        tangential_force=force, stiffness=np.cbrt(left) + 0.1, slip_force=120.0
    )
    assert verdicts(holding) == [True, True, False]
    short = claims_pair.tangential_force_claim(
        tangential_force=force[:100], stiffness=np.cbrt(left)[:100], slip_force=120.0
    )
    assert not short.statements[2].met  # nothing was computed beyond slip, so nothing is shown


def test_c3() -> None:
    def claim(place: float) -> Claim:
        return claims_pair.dimension_claim(
            dimension=DIMENSION, stiffness=np.exp(-((DIMENSION - place) ** 2)), stated=1.85
        )

    assert claim(1.86).met
    assert not claim(1.80).met
    assert abs(claim(1.80).statements[0].numbers["peak_fractal_dimension"] - 1.80) < 1e-5
    rising = claims_pair.dimension_claim(dimension=DIMENSION, stiffness=DIMENSION, stated=1.95)
    assert not rising.met  # a maximum at the end of the range is not a peak


def test_c4() -> None:
    roughness = np.geomspace(1e-13, 1e-11, 11)
    falling = claims_pair.roughness_claim(roughness=roughness, stiffness=roughness**-0.5)
    assert falling.met
    assert abs(falling.statements[0].numbers["exponent"] + 0.5) < 1e-12
    assert not claims_pair.roughness_claim(roughness=roughness, stiffness=roughness).met


def test_c5_and_c6() -> None:
    size = np.linspace(5e-3, 30e-3, 26)
    flat = np.ones_like(size)

    def of(claim, stiffness):  # type: ignore[no-untyped-def]
        name = "length" if claim is claims_pair.length_claim else "radius"
        return claim(**{name: size}, stiffness=stiffness, low_stiffness=flat, low_dimension=1.3)

    for claim in (claims_pair.length_claim, claims_pair.radius_claim):
        assert verdicts(of(claim, 1.0 + 0.1 * np.log(size / size[0]))) == [True, True, True]
        assert verdicts(of(claim, np.sqrt(size))) == [True, False, True]
        assert verdicts(of(claim, 1.0 - size)) == [False, True, False]

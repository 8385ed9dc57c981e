"""C9–C13 and the design window on made-up curves, met and not met."""

import numpy as np

from asperity.zou2025 import claims_joint

TORQUE = np.arange(3.0)
DIMENSION = np.linspace(1.3, 1.95, 261)
ROWS = np.ones((3, 1))


def verdicts(claim):
    return [statement.met for statement in claim.statements]


def sweep(values, stiffness, torque=TORQUE):
    return {"output_torque": torque, "values": values, "output_stiffness": stiffness}


def bells(places, width):
    return np.exp(-(((DIMENSION - np.array(places)[:, None]) / width) ** 2))


def test_fractal_dimension_at_every_torque(made_up):
    def claim(places):
        return claims_joint.fractal_dimension(made_up(dimension=sweep(DIMENSION, bells(places, 0.1))))

    assert claim([1.85, 1.86, 1.84]).met
    assert not claim([1.85, 1.86, 1.80]).met


def test_fractal_roughness(made_up):
    roughness = np.geomspace(1e-13, 1e-11, 9)

    def claim(stiffness):
        return claims_joint.fractal_roughness(made_up(roughness=sweep(roughness, stiffness)))

    assert claim(ROWS / roughness).met
    assert not claim(ROWS * roughness).met


def test_output_torque(made_up):
    def claim(*slopes):
        panels = [sweep(np.ones(4), np.outer(1.0 + slope * TORQUE, np.ones(4))) for slope in slopes]
        return claims_joint.output_torque(
            made_up(**dict(zip(("dimension", "roughness", "length"), panels, strict=True)))
        )

    assert verdicts(claim(-0.05, -0.05, -0.05)) == [True, True]
    assert verdicts(claim(-0.05, -0.30, -0.05)) == [True, False]
    rising = claim(-0.05, -0.05, 0.05)
    assert verdicts(rising) == [False, True]
    assert "not at every step" in rising.statements[0].evidence


def test_size(made_up):
    length, scale = np.linspace(5e-3, 30e-3, 6), np.linspace(1.0, 2.0, 5)

    def judged(gain, radius_power):
        over_length = ROWS * (1.0 + gain * (length - length[0]) / 25e-3)
        curves = made_up(length=sweep(length, over_length), radius=sweep(scale, ROWS * scale**radius_power))
        return verdicts(claims_joint.size(curves))

    assert judged(0.5, 2.0) == [True, True, True]
    assert judged(0.03, 2.0) == [True, False, True]
    assert judged(-0.5, 0.1) == [False, False, False]


def test_friction(made_up):
    friction, high, torque = (
        np.linspace(0.04, 0.3, 131),
        0.3 * np.array([1.0, 2.0, 4.0]),
        np.array([0.0, 5.0]),
    )

    def claim(curve):
        # the row without torque is flat, which does not count
        return claims_joint.friction(
            made_up(
                friction=sweep(friction, np.stack([np.ones_like(friction), curve(friction)]), torque),
                high_friction=sweep(high, np.stack([np.ones_like(high), curve(high)]), torque),
            )
        )

    def saturating(mu):
        return np.cbrt(np.clip(1.0 - 0.045 / mu, 0.0, None))

    assert verdicts(claim(saturating)) == [True, True, False]
    assert abs(claim(saturating).statements[0].numbers["friction_from_which_all_stick"] - 0.046) < 1e-9
    assert verdicts(claim(lambda mu: 1.0 + mu)) == [True, False, False]
    # a steep start alone is no saturation: these keep increasing
    assert verdicts(claim(lambda mu: np.cbrt(mu - 0.0399))) == [True, False, False]
    assert verdicts(claim(lambda mu: np.log(mu / 0.0399))) == [True, False, False]
    humped = verdicts(claim(lambda mu: 1.0 - (mu - 0.2) ** 2))
    assert (humped[0], humped[2]) == (False, True)


def test_design_window(made_up):
    def judged(place, width):
        curves = made_up(dimension=sweep(DIMENSION, bells([place] * 3, width)))
        return verdicts(claims_joint.design_window(curves))

    assert judged(1.78, 0.5) == [True, True]
    assert judged(1.86, 0.1) == [True, False]
    assert judged(1.5, 1.5) == [False, True]

"""C1–C6 on made-up curves, met and not met."""

import numpy as np

from asperity.zou2025 import claims_pair

FORCE = np.linspace(0.0, 1000.0, 51)
DIMENSION = np.linspace(1.3, 1.95, 261)


def verdicts(claim):
    return [statement.met for statement in claim.statements]


def test_normal_force(made_up):
    def judged(stiffness):
        return verdicts(claims_pair.normal_force(made_up(pairs={"a": (FORCE, stiffness)})))

    assert judged(FORCE**0.8) == [True, True]
    assert judged(FORCE) == [True, False]
    assert judged(2e6 - FORCE**2) == [False, True]


def test_tangential_force(made_up):
    force = np.linspace(0.0, 130.0, 131)  # gross slip at 0.12 times 1000 N
    left = np.clip(1.0 - force / 120.0, 0.0, None)

    def judged(stiffness, points=131):
        curves = made_up(pairs={"b": (force[:points], stiffness[:points])})
        return verdicts(claims_pair.tangential_force(curves))

    assert judged(np.cbrt(left)) == [True, True, True]
    assert judged(left) == [True, False, True]
    assert judged(np.cbrt(left) + 0.1) == [True, True, False]
    assert not judged(np.cbrt(left), points=100)[2]  # without a point beyond slip nothing is shown


def test_fractal_dimension(made_up):
    def claim(place, dimension=DIMENSION):
        stiffness = np.exp(-((dimension - place) ** 2))
        return claims_pair.fractal_dimension(made_up(pairs={"c": (dimension, stiffness)}))

    assert claim(1.86).met
    assert not claim(1.80).met
    assert abs(claim(1.80).statements[0].numbers["peak_fractal_dimension"] - 1.80) < 1e-5
    assert not claim(1.95, dimension=np.linspace(1.3, 1.86, 57)).met  # the end of the range is no maximum


def test_fractal_roughness(made_up):
    roughness = np.geomspace(1e-13, 1e-11, 11)

    def claim(stiffness):
        return claims_pair.fractal_roughness(made_up(pairs={"d": (roughness, stiffness)}))

    assert claim(roughness**-0.5).met
    assert abs(claim(roughness**-0.5).statements[0].numbers["exponent"] + 0.5) < 1e-12
    assert not claim(roughness).met


def test_contact_length_and_roller_radius(made_up):
    size = np.linspace(5e-3, 30e-3, 26)
    for claim, case in ((claims_pair.contact_length, "f"), (claims_pair.roller_radius, "e")):

        def judged(stiffness, claim=claim, case=case):
            low = (size, 1.0 - 10.0 * size)  # is reported, and does not change the verdict
            return verdicts(claim(made_up(pairs={case: (size, stiffness), f"{case}_low": low})))

        assert judged(1.0 + 0.1 * np.log(size / size[0])) == [True, True, True]
        assert judged(np.sqrt(size)) == [True, False, True]
        assert judged(1.0 - size) == [False, True, False]

"""Unlike rollers against CONTACT (the problem of Bentall and Johnson)."""

import numpy as np
import pytest

from asperity.bem import ElasticPair, FreeHalfSpace, coupled_steady_rolling, elastic_pair
from asperity.errors import NoSolutionError

#: Deck bentall of CONTACT's examples (Vollebregt, Kalker; Apache-2.0): an aluminium roller on a steel roller, both of
# radius 50 mm: friction coefficient, force over sliding force, creepage and peak pressure [MPa] as printed. Rolling
# is towards negative x there, so the force changes sign here.
BENTALL = [
    (1e-4, 0.0, 5.260e-4, 103.1),
    (10.0, 0.0, 3.591e-4, 103.8),
    (0.05, 0.0, 4.294e-4, 103.6),
    (0.05, -0.75, 2.108e-4, 103.2),
    (0.05, 0.75, 5.392e-4, 103.3),
]


@pytest.mark.long
@pytest.mark.parametrize(("friction", "q", "creepage", "peak"), BENTALL)
def test_unlike_rollers_creep_without_torque(friction, q, creepage, peak):
    pair = elastic_pair(
        youngs_modulus_1=2.0 * 23e9 * 1.31,
        youngs_modulus_2=2.0 * 82e9 * 1.28,
        poisson_ratio_1=0.31,
        poisson_ratio_2=0.28,
    )
    x = (np.arange(216) - 107.5) * 1e-6
    strip = FreeHalfSpace(pair, shape=(216,), pixel_size=(1e-6,), reference_distance=1.0)
    found = coupled_steady_rolling(
        strip,
        -(x**2) / (2.0 * 25e-3),
        normal_force=16201.9,
        friction_coefficient=friction,
        layer_compliance=0.0,
        longitudinal_force=q * friction * 16201.9,
        lateral_creepage=0.0,
    )
    assert float(found.rolling.creepage[0]) == pytest.approx(creepage, rel=5e-4)
    assert float(found.contact.pressure.max()) == pytest.approx(peak * 1e6, rel=1e-3)
    assert float(found.contact.normal_force) == pytest.approx(16201.9, rel=1e-9)
    mirrored = elastic_pair(
        youngs_modulus_2=2.0 * 23e9 * 1.31,
        youngs_modulus_1=2.0 * 82e9 * 1.28,
        poisson_ratio_2=0.31,
        poisson_ratio_1=0.28,
    )
    assert mirrored.dundurs_constant == pytest.approx(-pair.dundurs_constant, rel=1e-12)


@pytest.mark.long
def test_alternations_that_do_not_settle_are_an_error():
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.2)
    strip = FreeHalfSpace(pair, shape=(64,), pixel_size=(0.04,), reference_distance=10.0)
    x = (np.arange(64) - 31.5) * 0.04
    with pytest.raises(NoSolutionError, match="after 1 alternations"):
        coupled_steady_rolling(
            strip,
            -0.5 * x**2,
            normal_force=1.0,
            friction_coefficient=0.3,
            layer_compliance=0.0,
            longitudinal_force=0.1,
            lateral_creepage=0.0,
            max_alternations=1,
        )

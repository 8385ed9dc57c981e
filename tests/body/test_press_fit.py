"""A ring pressed into a housing, against Lamé's fields of both fitted to each other."""

import jax
import numpy as np
import pytest

from asperity.body.press_fit import press_fit, rim_compliance
from asperity.materials import Material

STEEL = Material(206e9, 0.3, 7850.0, 450e6, 1260e6)
ALUMINIUM = Material(69e9, 0.33, 2700.0, 276e6, 900e6)


def _fields(ring, housing, a, b, c, interference):
    """u = A r + B/r in both, plane stress: free at a and c, one pressure and a jump of the displacement at b."""

    def displacement(r):
        return [r, 1.0 / r]

    def radial(material, r):
        e, nu = material.youngs_modulus, material.poisson_ratio
        return [e / (1.0 - nu), -e / (1.0 + nu) / r**2]

    def hoop(material, r):
        e, nu = material.youngs_modulus, material.poisson_ratio
        return [e / (1.0 - nu), e / (1.0 + nu) / r**2]

    none = [0.0, 0.0]
    rows = np.array(
        [
            radial(ring, a) + none,
            none + radial(housing, c),
            radial(ring, b) + [-value for value in radial(housing, b)],
            [-value for value in displacement(b)] + displacement(b),
        ]
    )
    of_ring, of_housing = np.linalg.solve(
        rows / 1e9 ** np.array([[1], [1], [1], [0]]), [0, 0, 0, interference / 2]
    ).reshape(2, 2)
    return {
        "pressure": -np.dot(radial(ring, b), of_ring),
        "bore_change": -2.0 * np.dot(displacement(a), of_ring),
        "at_bore": np.dot(hoop(ring, a), of_ring),
        "at_seat": np.dot(hoop(ring, b), of_ring),
        "housing": np.dot(hoop(housing, b), of_housing),
    }


@pytest.mark.parametrize(("ring", "housing"), [(STEEL, STEEL), (STEEL, ALUMINIUM), (ALUMINIUM, STEEL)])
@pytest.mark.parametrize(("a", "b", "c"), [(0.04, 0.05, 0.06), (0.05, 0.058, 0.2), (0.001, 0.058, 0.0585)])
def test_lames_fields_of_both(ring, housing, a, b, c):
    fit = press_fit(
        ring=ring, housing=housing, bore_radius=a, seat_radius=b, outer_radius=c, interference=40e-6
    )
    expected = _fields(ring, housing, a, b, c, 40e-6)
    computed = [fit.pressure, fit.bore_change, *fit.ring_hoop, fit.housing_hoop]
    np.testing.assert_allclose(np.array(computed), list(expected.values()), rtol=1e-9)


def test_a_gap_presses_nothing_and_a_housing_inside_its_ring_is_nan():
    sizes = {"ring": STEEL, "housing": STEEL, "bore_radius": 0.04, "seat_radius": 0.05}
    assert float(press_fit(**sizes, outer_radius=0.06, interference=-1e-6).pressure) == 0.0
    assert np.isnan(press_fit(**sizes, outer_radius=0.045, interference=1e-6).pressure)


def test_a_thin_ring_is_a_hoop():
    """u = p R^2/(E t), of either rim."""
    for rim, other in ((1.0, 1.001), (1.0, 0.999)):
        thin = rim_compliance(rim=rim, other=other, youngs_modulus=206e9, poisson_ratio=0.3)
        assert thin == pytest.approx(1.0 / (206e9 * 1e-3), rel=2e-3)


def test_twice_the_interference_twice_everything():
    def of(interference):
        sizes = {"bore_radius": 0.04, "seat_radius": 0.05, "outer_radius": 0.07}
        return press_fit(ring=STEEL, housing=ALUMINIUM, **sizes, interference=interference)

    for one, two in zip(jax.tree.leaves(of(20e-6)), jax.tree.leaves(of(40e-6)), strict=True):
        assert float(two) == pytest.approx(2.0 * float(one))

"""The pair's two moduli: against the closed forms of Johnson and the package's own materials."""

import pytest

from asperity.bem import elastic_pair
from asperity.errors import InputError
from asperity.materials import tangential_contact_modulus

STEEL_ON_ALUMINIUM = {
    "youngs_modulus_1": 206e9,
    "youngs_modulus_2": 70e9,
    "poisson_ratio_1": 0.30,
    "poisson_ratio_2": 0.33,
}


def test_like_bodies_shear_like_their_own_poisson_ratio():
    pair = elastic_pair(
        youngs_modulus_1=1e9, youngs_modulus_2=1e9, poisson_ratio_1=0.42, poisson_ratio_2=0.42
    )
    assert pair.poisson_ratio == pytest.approx(0.42, rel=1e-12)


def test_the_tangential_modulus_is_that_of_the_materials_module():
    pair = elastic_pair(**STEEL_ON_ALUMINIUM)
    assert pair.tangential_contact_modulus == pytest.approx(
        tangential_contact_modulus(**STEEL_ON_ALUMINIUM), rel=1e-12
    )


def test_a_rigid_partner_leaves_the_other_body_alone():
    pair = elastic_pair(
        youngs_modulus_1=2e9, youngs_modulus_2=float("inf"), poisson_ratio_1=0.25, poisson_ratio_2=0.3
    )
    assert pair.contact_modulus == pytest.approx(2e9 / (1.0 - 0.25**2), rel=1e-12)
    assert pair.antiplane_modulus == pytest.approx(2e9 / 2.5, rel=1e-12)


def test_dundurs_second_constant():
    """CONTACT prints 0.1002 for these rollers: Kalker's K, which is beta times G/E; zero for like bodies."""
    pair = elastic_pair(
        youngs_modulus_1=2.0 * 23e9 * 1.31,
        youngs_modulus_2=2.0 * 82e9 * 1.28,
        poisson_ratio_1=0.31,
        poisson_ratio_2=0.28,
    )
    mean_shear_modulus = 2.0 / (1.0 / 23e9 + 1.0 / 82e9)
    kalker = pair.dundurs_constant * mean_shear_modulus / pair.contact_modulus
    assert kalker == pytest.approx(0.1002, abs=5e-5)
    like = elastic_pair(youngs_modulus_1=2e9, youngs_modulus_2=2e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3)
    assert like.dundurs_constant == 0.0


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"youngs_modulus_1": 0.0}, "youngs_modulus_1 = 0 Pa"),
        ({"poisson_ratio_2": 0.6}, "poisson_ratio_2 = 0.6.*at most 0.5"),
        ({"youngs_modulus_1": float("inf"), "youngs_modulus_2": float("inf")}, "two rigid bodies"),
        ({"youngs_modulus_2": float("nan")}, "youngs_modulus_2 = nan"),
    ],
)
def test_impossible_bodies_are_named(change, named):
    with pytest.raises(InputError, match=named):
        elastic_pair(**(STEEL_ON_ALUMINIUM | change))

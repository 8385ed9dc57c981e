"""Table 1 case c against the values of the model reference (independent quadrature, four digits)."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.zou2025.preset import table_1_pair
from asperity.zou2025.roller_pair import pair_contact

# K_t in N/mm: R1/R2 = 10/20 mm, B = 5 mm, F_n = 1000 N, T = 0, G = 1e-8 mm, printed contact factor
REFERENCE = {
    1.3: 1.017e5,
    1.4: 3.904e6,
    1.5: 5.584e7,
    1.6: 4.135e8,
    1.7: 1.379e9,
    1.8: 2.537e9,
    1.85: 2.825e9,
    1.9: 2.650e9,
    1.95: 1.786e9,
}


def test_case_c_agrees_with_the_reference() -> None:
    contact = pair_contact(table_1_pair(fractal_dimension=jnp.array(list(REFERENCE))))
    np.testing.assert_allclose(
        np.asarray(contact.tangential_stiffness) * 1e-3, list(REFERENCE.values()), rtol=6e-4
    )


def test_highest_of_the_reference_points_is_at_1_85() -> None:
    dimensions = list(REFERENCE)
    contact = pair_contact(table_1_pair(fractal_dimension=jnp.array(dimensions)))
    assert dimensions[int(np.argmax(np.asarray(contact.tangential_stiffness)))] == 1.85


def test_no_load_means_no_contact() -> None:
    contact = pair_contact(table_1_pair(normal_force=0.0))
    assert float(contact.tangential_stiffness) == 0.0
    assert float(contact.real_contact_area) == 0.0


def test_gross_slip_means_no_stiffness_but_contact() -> None:
    contact = pair_contact(table_1_pair(tangential_force=120.0))
    assert float(contact.tangential_stiffness) == 0.0
    assert float(contact.largest_area) > 0.0


@pytest.mark.parametrize("share", [0.0, 0.5, 0.992])
def test_tangential_force_enters_as_the_cube_root_of_what_friction_has_left(share: float) -> None:
    free = float(pair_contact(table_1_pair()).tangential_stiffness)
    loaded = float(pair_contact(table_1_pair(tangential_force=120.0 * share)).tangential_stiffness)
    assert loaded == pytest.approx(free * (1.0 - share) ** (1.0 / 3.0), rel=1e-12)

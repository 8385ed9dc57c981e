"""Table 1 case c against the values of the model reference (independent quadrature, four digits)."""

import equinox as eqx
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.contact.fractal import FractalContact
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


SLIP = 120.0  # N, mu F_n = 0.12 times 1000 N
SHARES = (0.5, 0.992)
# (D, F_n, T): the reference's points, no load, gross slip, the common point and two tangential loads on it
POINTS = [
    *((d, 1000.0, 0.0) for d in REFERENCE),
    (1.4, 0.0, 0.0),
    (1.4, 1000.0, SLIP),
    (1.4, 1000.0, 0.0),
    *((1.4, 1000.0, SLIP * share) for share in SHARES),
]
NO_LOAD, SLIPPING, FREE = (len(REFERENCE) + i for i in range(3))


@pytest.fixture(scope="module")
def contact() -> FractalContact:
    dimension, normal, tangential = jnp.array(POINTS).T
    solved: FractalContact = eqx.filter_jit(pair_contact)(
        fractal_dimension=dimension, normal_force=normal, tangential_force=tangential
    )
    return solved


def test_case_c_agrees_with_the_reference(contact: FractalContact) -> None:
    stiffness = np.asarray(contact.tangential_stiffness)[: len(REFERENCE)] * 1e-3
    np.testing.assert_allclose(stiffness, list(REFERENCE.values()), rtol=6e-4)


def test_highest_of_the_reference_points_is_at_1_85(contact: FractalContact) -> None:
    top = int(np.argmax(np.asarray(contact.tangential_stiffness)[: len(REFERENCE)]))
    assert list(REFERENCE)[top] == 1.85


def test_no_load_means_no_contact(contact: FractalContact) -> None:
    assert float(contact.tangential_stiffness[NO_LOAD]) == 0.0
    assert float(contact.real_contact_area[NO_LOAD]) == 0.0


def test_gross_slip_means_no_stiffness_but_contact(contact: FractalContact) -> None:
    assert float(contact.tangential_stiffness[SLIPPING]) == 0.0
    assert float(contact.largest_area[SLIPPING]) > 0.0


def test_tangential_force_enters_as_the_cube_root_of_what_friction_has_left(contact: FractalContact) -> None:
    stiffness = np.asarray(contact.tangential_stiffness)[FREE:]
    np.testing.assert_allclose(stiffness[1:], stiffness[0] * np.cbrt(1.0 - np.array(SHARES)), rtol=1e-12)

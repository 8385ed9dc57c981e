import jax.numpy as jnp
import pytest

from asperity.compilation import compile_fast
from asperity.contact.fractal import Surface
from asperity.contact.roller_pairs import CONTACT_FACTOR_MODELS, RollerPairs, roller_pair_contacts


def pairs(models):
    def rows(value):
        return jnp.full(len(models), value)

    return RollerPairs(
        surface=Surface(rows(1.85), rows(1e-11), rows(1.5), "majumdar_bhushan_1991"),
        normal_force=rows(1000.0),
        tangential_force=rows(0.0),
        friction_coefficient=rows(0.1),
        radius_1=rows(10e-3),
        radius_2=rows(20e-3),
        sign=rows(1.0),
        contact_length=rows(5e-3),
        youngs_modulus_1=rows(206e9),
        youngs_modulus_2=rows(206e9),
        poisson_ratio_1=rows(0.3),
        poisson_ratio_2=rows(0.3),
        hardness=rows(1260e6),
        contact_factor_model=jnp.asarray(models),
    )


def test_each_row_uses_its_own_model():
    """K_t at the paper's peak, D = 1.85: 2.825e9 N/mm with the printed lambda (table of the issue's model page)."""
    printed, unity = CONTACT_FACTOR_MODELS.index("printed"), CONTACT_FACTOR_MODELS.index("unity")
    rows = pairs([printed, unity, printed, 7])
    contacts = compile_fast(roller_pair_contacts, rows)(rows)
    assert contacts.tangential_stiffness[0] == pytest.approx(2.825e12, rel=2e-4)
    assert contacts.tangential_stiffness[2] == contacts.tangential_stiffness[0]
    assert contacts.contact_factor[1] == 1.0
    assert jnp.isnan(contacts.tangential_stiffness[3])  # there is no model 7

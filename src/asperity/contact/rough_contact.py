"""What a law of rough contact says about one, whichever law it is."""

from __future__ import annotations

import equinox as eqx
from jax import Array


class RoughContact(eqx.Module):
    """The state of one rough contact under load; arrays of one broadcast shape, SI units.

    Parameters
    ----------
    largest_area, critical_area : Array
        Largest spot a_l and critical spot a_c [m^2]; nan for a law without spots.
    real_contact_area : Array
        Real area of contact A_r [m^2]; nan for a law without spots.
    elastic_load, plastic_load : Array
        Shares F_e and F_p of the normal force carried by elastic and by plastic spots [N].
    tangential_stiffness, normal_stiffness : Array
        K_t and K_n of all elastic spots together [N/m].
    domain_extension_factor, contact_factor : Array
        psi and lambda [-]; nan for a law without spots.
    """

    largest_area: Array
    critical_area: Array
    real_contact_area: Array
    elastic_load: Array
    plastic_load: Array
    tangential_stiffness: Array
    normal_stiffness: Array
    domain_extension_factor: Array
    contact_factor: Array

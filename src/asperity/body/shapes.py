r"""Bodies: a solid disc loaded on its rim, an annulus loaded on one rim and free or supported on the other."""

from __future__ import annotations

from typing import Literal, get_args

from asperity.engine.module import Module, static
from asperity.errors import InputError
from asperity.types import Real

#: No strain along the axis (long bodies), or no stress along it (thin discs).
PlaneState = Literal["plane_strain", "plane_stress"]
#: Rim that carries the contacts.
LoadedRim = Literal["inner", "outer"]


def kolosov_constant(*, poisson_ratio: Real, plane_state: PlaneState) -> Real:
    r"""Kolosov's constant of plane elasticity.

    .. math::
        \kappa = 3 - 4\nu \;\text{(plane strain)}, \qquad \kappa = \frac{3-\nu}{1+\nu} \;\text{(plane stress)}

    Parameters
    ----------
    poisson_ratio : Real
        Poisson's ratio [-].
    plane_state : {"plane_strain", "plane_stress"}
        Long body or thin disc.

    Returns
    -------
    Real
        Constant [-].

    Raises
    ------
    InputError
        If the plane state is neither of the two.

    References
    ----------
    N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, 1953, section 32.

    Examples
    --------
    >>> round(kolosov_constant(poisson_ratio=0.3, plane_state="plane_strain"), 3)
    1.8
    """
    if plane_state not in get_args(PlaneState):
        raise InputError(f"plane state {plane_state!r} is not known; choose from {get_args(PlaneState)}")
    if plane_state == "plane_strain":
        return 3.0 - 4.0 * poisson_ratio
    return (3.0 - poisson_ratio) / (1.0 + poisson_ratio)


class Disc(Module):
    """A solid disc or roller with contacts on its rim, SI units.

    Parameters
    ----------
    radius : Real
        Radius [m].
    length : Real
        Axial length [m]; a contact loads all of it evenly.
    youngs_modulus : Real
        Young's modulus [Pa].
    poisson_ratio : Real
        Poisson's ratio [-].
    plane_state : {"plane_strain", "plane_stress"}
        Long body or thin disc.
    """

    radius: Real
    length: Real
    youngs_modulus: Real
    poisson_ratio: Real
    plane_state: PlaneState = static()


class Annulus(Module):
    """A ring or a hollow roller with contacts on one rim, SI units.

    The other rim is free, or supported by springs: traction = stiffness per area times displacement. Both
    stiffnesses ``math.inf``: no displacement, as in a rigid housing or on a rigid pin. Both 0: free.

    Parameters
    ----------
    inner_radius, outer_radius : Real
        Radii [m].
    length : Real
        Axial length [m]; a contact loads all of it evenly.
    youngs_modulus : Real
        Young's modulus [Pa].
    poisson_ratio : Real
        Poisson's ratio [-].
    radial_support_stiffness, tangential_support_stiffness : Real
        Of the support of the rim without contacts, per area [N/m^3].
    loaded_rim : {"inner", "outer"}
        Rim with the contacts: the inner one of a ring, the outer one of a hollow roller.
    plane_state : {"plane_strain", "plane_stress"}
        Long body or thin ring.
    """

    inner_radius: Real
    outer_radius: Real
    length: Real
    youngs_modulus: Real
    poisson_ratio: Real
    radial_support_stiffness: Real
    tangential_support_stiffness: Real
    loaded_rim: LoadedRim = static()
    plane_state: PlaneState = static()

    def __post_init__(self) -> None:
        """Raise if the rim is neither of the two."""
        if self.loaded_rim not in get_args(LoadedRim):
            raise InputError(
                f"loaded rim {self.loaded_rim!r} is not known; choose from {get_args(LoadedRim)}"
            )

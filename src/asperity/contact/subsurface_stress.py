"""Plane-strain stresses under a smooth line contact that carries pressure and shear traction, in closed form."""

from __future__ import annotations

from asperity.contact.carter import stick_centre, stick_half_width
from asperity.engine.arrays import complex_number, xp
from asperity.engine.module import Module
from asperity.types import Array, Real


class PlaneStress(Module):
    """In-plane stresses at points of a body in plane strain; tension is positive.

    Parameters
    ----------
    longitudinal : Array
        Normal stress in the rolling direction sigma_x [Pa].
    normal : Array
        Normal stress across the surface sigma_z [Pa].
    shear : Array
        Shear stress tau_xz [Pa].
    """

    longitudinal: Array
    normal: Array
    shear: Array


class _Potential(Module):
    """Real and imaginary parts of W and of z dW/dx."""

    real: Array
    imag: Array
    slope_real: Array
    slope_imag: Array


def _potential(position: Real, depth: Real, centre: Real, half_width: Real) -> _Potential:
    """Potential W = s - sqrt(s^2 - 1) of an ellipse, s = (x - centre + i z)/half_width; 0 where it has no width."""
    position, depth, centre, half_width = xp.broadcast_arrays(
        *(xp.asarray(v, dtype=float) for v in (position, depth, centre, half_width))
    )
    some = half_width > 0.0
    width = xp.where(some, half_width, 1.0)
    across, down = (position - centre) / width, depth / width
    at_edge = (xp.abs(across) == 1.0) & (down == 0.0)  # the root has no derivative there
    place = complex_number(across, xp.where(at_edge, 1.0, down))
    root = xp.sqrt(place - 1.0) * xp.sqrt(place + 1.0)  # the branch that is s at infinity
    value, slope = place - root, 1.0 - place / root
    return _Potential(
        real=xp.where(some, xp.where(at_edge, across, value.real), 0.0),
        imag=xp.where(some & ~at_edge, value.imag, 0.0),
        slope_real=xp.where(some & ~at_edge, down * slope.real, 0.0),
        slope_imag=xp.where(some & ~at_edge, down * slope.imag, 0.0),
    )


def pressure_stress(*, position: Real, depth: Real, half_width: Real, peak_pressure: Real) -> PlaneStress:
    r"""Stresses under the elliptic pressure of a line contact.

    .. math::
        \sigma_x = p_0\,(\mathrm{Im}\,W + z\,\mathrm{Re}\,W'), \qquad
        \sigma_z = p_0\,(\mathrm{Im}\,W - z\,\mathrm{Re}\,W'), \qquad
        \tau_{xz} = -p_0\,z\,\mathrm{Im}\,W'

    with :math:`W = s - \sqrt{s^2 - 1}`, :math:`s = (x + i z)/a` and :math:`W' = dW/dx`.

    Parameters
    ----------
    position : Real
        Distance x from the middle of the contact [m].
    depth : Real
        Depth z >= 0 below the surface [m].
    half_width : Real
        Half-width a of the contact [m].
    peak_pressure : Real
        Peak pressure p_0 [Pa].

    Returns
    -------
    PlaneStress
        Stresses [Pa].

    Notes
    -----
    Half-plane: a much smaller than the radii and walls. At the edges of the contact the stresses are finite, their
    derivatives are not.

    References
    ----------
    The Flamant solution (K. L. Johnson, Contact Mechanics, 1985, equations (2.23)) integrated over the ellipse;
    equivalent to McEwen's form there, equations (4.49). Equation (B5) of :doc:`/equations`.
    """
    w = _potential(position, depth, 0.0, half_width)
    return PlaneStress(
        longitudinal=peak_pressure * (w.imag + w.slope_real),  # (B5)
        normal=peak_pressure * (w.imag - w.slope_real),
        shear=-peak_pressure * w.slope_imag,
    )


def traction_stress(
    *, position: Real, depth: Real, centre: Real, half_width: Real, peak_traction: Real
) -> PlaneStress:
    r"""Stresses under an elliptic shear traction that pulls the surface in the direction of x.

    .. math::
        \sigma_x = q_0\,(-2\,\mathrm{Re}\,W + z\,\mathrm{Im}\,W'), \qquad
        \sigma_z = -q_0\,z\,\mathrm{Im}\,W', \qquad
        \tau_{xz} = q_0\,(\mathrm{Im}\,W + z\,\mathrm{Re}\,W')

    with W of :func:`pressure_stress`.

    Parameters
    ----------
    position : Real
        Place x [m].
    depth : Real
        Depth z >= 0 below the surface [m].
    centre : Real
        Middle of the ellipse [m].
    half_width : Real
        Half-width of the ellipse [m]; where it is 0 there is no traction.
    peak_traction : Real
        Largest traction q_0 on the body [Pa].

    Returns
    -------
    PlaneStress
        Stresses [Pa].

    Notes
    -----
    Half-plane, as for :func:`pressure_stress`.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 7.1(a); equation (B5) of :doc:`/equations`.
    """
    w = _potential(position, depth, centre, half_width)
    return PlaneStress(
        longitudinal=peak_traction * (-2.0 * w.real + w.slope_imag),  # (B5)
        normal=-peak_traction * w.slope_imag,
        shear=peak_traction * (w.imag + w.slope_real),
    )


def rolling_stress(
    *,
    position: Real,
    depth: Real,
    half_width: Real,
    peak_pressure: Real,
    friction_coefficient: Real,
    slip_ratio: Real,
) -> PlaneStress:
    r"""Stresses under a rolling line contact with Carter's traction.

    The pressure, plus :math:`\mu p_0` over the whole contact, minus :math:`\mu p_0 c/a` over the stick zone of (B2).

    Parameters
    ----------
    position : Real
        Distance x from the middle of the contact, positive towards the leading edge [m].
    depth : Real
        Depth z >= 0 below the surface [m].
    half_width : Real
        Half-width a of the contact [m].
    peak_pressure : Real
        Peak pressure p_0 [Pa].
    friction_coefficient : Real
        mu [-].
    slip_ratio : Real
        Q/(mu N) [-]; positive where the traction pulls this body forward, 1 and −1 are full slip.

    Returns
    -------
    PlaneStress
        Stresses [Pa].

    References
    ----------
    Equations (B2) and (B5) of :doc:`/equations`.
    """
    stick = stick_half_width(slip_ratio=slip_ratio, half_width=half_width)
    traction = xp.sign(slip_ratio) * friction_coefficient * peak_pressure
    pressed = pressure_stress(
        position=position, depth=depth, half_width=half_width, peak_pressure=peak_pressure
    )
    full = traction_stress(
        position=position, depth=depth, centre=0.0, half_width=half_width, peak_traction=traction
    )
    stuck = traction_stress(
        position=position,
        depth=depth,
        centre=stick_centre(slip_ratio=slip_ratio, half_width=half_width),
        half_width=stick,
        peak_traction=traction * stick / half_width,
    )
    return PlaneStress(
        longitudinal=pressed.longitudinal + full.longitudinal - stuck.longitudinal,
        normal=pressed.normal + full.normal - stuck.normal,
        shear=pressed.shear + full.shear - stuck.shear,
    )


def _mean_and_radius(stress: PlaneStress) -> tuple[Array, Array]:
    """Centre and radius of Mohr's circle in the plane."""
    difference = 0.5 * (stress.longitudinal - stress.normal)
    square = difference**2 + stress.shear**2
    some = square > 0.0
    radius = xp.where(some, xp.sqrt(xp.where(some, square, 1.0)), 0.0)
    return 0.5 * (stress.longitudinal + stress.normal), radius


def mises_stress(*, stress: PlaneStress, poisson_ratio: Real) -> Array:
    r"""Mises stress in plane strain.

    .. math::
        \sigma_M = \sqrt{3 J_2}, \qquad
        J_2 = \tau_1^2 + \frac{(1-2\nu)^2}{3}\left(\frac{\sigma_x+\sigma_z}{2}\right)^2

    with the largest shear stress in the plane :math:`\tau_1`.

    Parameters
    ----------
    stress : PlaneStress
        In-plane stresses.
    poisson_ratio : Real
        Poisson's ratio of the body [-].

    Returns
    -------
    Array
        Mises stress [Pa]; first yield where it reaches the yield strength.

    References
    ----------
    Definition of :math:`J_2` with :math:`\sigma_y = \nu(\sigma_x + \sigma_z)`.
    """
    mean, radius = _mean_and_radius(stress)
    square = 3.0 * radius**2 + ((1.0 - 2.0 * poisson_ratio) * mean) ** 2
    some = square > 0.0
    return xp.where(some, xp.sqrt(xp.where(some, square, 1.0)), 0.0)

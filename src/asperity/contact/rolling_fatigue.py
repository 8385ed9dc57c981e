"""Rolling-contact fatigue: life of a stressed track, of a system, at a reliability and under a load spectrum."""

from __future__ import annotations

import math

from asperity.engine.arrays import xp
from asperity.types import Real

#: Weibull slope e, stress exponent c and depth exponent h of the life model (Coy, Loewenthal and Zaretsky 1976).
WEIBULL_SLOPE = 10.0 / 9.0
STRESS_EXPONENT = 31.0 / 3.0
DEPTH_EXPONENT = 7.0 / 3.0

#: Material constant K_1 of through-hardened bearing steel in N and m, for lives in millions of stress cycles.
BEARING_STEEL = 1.430e95

#: Survival for which lives are stated.
RATED_RELIABILITY = 0.9


def stressed_track_life(
    *, shear_stress: Real, depth: Real, stressed_volume: Real, material_constant: Real
) -> Real:
    r"""Life of a stressed volume at 90 % survival.

    .. math:: L = \left[\frac{K_1\, z_0^h}{\tau_0^c\, V}\right]^{1/e},
              \qquad e = \tfrac{10}{9}, \; c = \tfrac{31}{3}, \; h = \tfrac73

    Parameters
    ----------
    shear_stress : Real
        Largest orthogonal shear stress tau_0 > 0 [Pa].
    depth : Real
        Depth z_0 at which it acts [m].
    stressed_volume : Real
        Volume V [m^3].
    material_constant : Real
        K_1 [N^(31/3) m^-20], :data:`BEARING_STEEL`. With all four in pounds and inches the lives are the same.

    Returns
    -------
    Real
        Life [10^6 stress cycles].

    Notes
    -----
    Fatigue that begins below the surface, in through-hardened bearing steel. Film thickness and cleanliness are not
    included: apply the factor of ISO 281 for them.

    References
    ----------
    J. J. Coy, S. H. Loewenthal and E. V. Zaretsky, NASA TN D-8362, 1976; equation (B7) of :doc:`/equations`.
    """
    logarithm = (
        xp.log(material_constant)
        + DEPTH_EXPONENT * xp.log(depth)
        - STRESS_EXPONENT * xp.log(shear_stress)
        - xp.log(stressed_volume)
    )
    return xp.exp(logarithm / WEIBULL_SLOPE)  # (B7)


def line_contact_life(
    *,
    peak_pressure: Real,
    half_width: Real,
    contact_length: Real,
    track_radius: Real,
    material_constant: Real,
) -> Real:
    r"""Life of the track of one roller under a line contact at 90 % survival.

    .. math:: \tau_0 = \frac{p_0}{4}, \qquad z_0 = \frac a2, \qquad V = 2\pi R_i\,B\,z_0

    in :func:`stressed_track_life`.

    Parameters
    ----------
    peak_pressure : Real
        Peak pressure p_0 [Pa]; the life is infinite where it is not positive.
    half_width : Real
        Half-width a of the contact [m].
    contact_length : Real
        Contact line length B [m].
    track_radius : Real
        Radius R_i of the track on this roller [m].
    material_constant : Real
        K_1 [N^(31/3) m^-20], :data:`BEARING_STEEL`.

    Returns
    -------
    Real
        Life [10^6 stress cycles]: divide by the stress cycles per turn for turns.

    Notes
    -----
    L is proportional to the load to the power −4.05 (Lundberg and Palmgren 1952: −4). Traction is not included.

    References
    ----------
    J. J. Coy, S. H. Loewenthal and E. V. Zaretsky, NASA TN D-8362, 1976; equation (B7) of :doc:`/equations`.
    """
    loaded = (xp.asarray(peak_pressure) > 0.0) & (xp.asarray(half_width) > 0.0)
    depth = 0.5 * xp.where(loaded, half_width, 1.0)
    life = stressed_track_life(
        shear_stress=0.25 * xp.where(loaded, peak_pressure, 1.0),
        depth=depth,
        stressed_volume=2.0 * math.pi * track_radius * contact_length * depth,
        material_constant=material_constant,
    )
    return xp.where(loaded, life, xp.inf)


def life_at_reliability(*, life: Real, reliability: Real) -> Real:
    r"""Life that a share of all systems survives.

    .. math:: L_S = L_{90\%}\left[\frac{\ln(1/S)}{\ln(1/0.9)}\right]^{1/e}

    Parameters
    ----------
    life : Real
        Life at 90 % survival [any unit].
    reliability : Real
        Survival S, between 0 and 1 [-].

    Returns
    -------
    Real
        Life [unit of the life given].

    Notes
    -----
    Two-parameter Weibull distribution with e = 10/9. Far above 90 % it is on the safe side: actual bearing lives are
    then longer.

    References
    ----------
    W. Weibull 1939, as used by Lundberg and Palmgren 1947; equation (B8) of :doc:`/equations`.
    """
    return life * (xp.log(reliability) / math.log(RATED_RELIABILITY)) ** (1.0 / WEIBULL_SLOPE)  # (B8)


def spectrum_life(*, lives: Real, cycle_rates: Real, time_shares: Real) -> Real:
    r"""Life under a spectrum of loads and speeds.

    .. math:: \frac{1}{T} = \sum_j \frac{\varphi_j\, f_j}{L_j}

    Parameters
    ----------
    lives : Real
        Life L_j at each load of the spectrum, loads first [stress cycles or turns].
    cycle_rates : Real
        Stress cycles or turns per time f_j at each load, not negative [1/s].
    time_shares : Real
        Share of the time phi_j at each load [-].

    Returns
    -------
    Real
        Life in time [s]; infinite where nothing turns or nothing is loaded.

    Notes
    -----
    Damage adds up in any order. The shares must sum to 1; this is not checked here.

    References
    ----------
    A. Palmgren, Z. VDI 68 (1924) 339; M. A. Miner, J. Appl. Mech. 12 (1945) A159. Equation (B8) of :doc:`/equations`.
    """
    rate = xp.sum(time_shares * cycle_rates / lives, axis=0)
    endless = rate == 0.0  # an unknown life stays unknown
    return xp.where(endless, xp.inf, 1.0 / xp.where(endless, 1.0, rate))  # (B8)


def damage_shares(*, lives: Real, cycle_rates: Real, time_shares: Real) -> Real:
    r"""Share of each load of a spectrum in the damage of a part.

    .. math:: d_j = \frac{\varphi_j f_j/L_j}{\sum_k \varphi_k f_k/L_k}

    Parameters
    ----------
    lives : Real
        Life L_j at each load of the spectrum, loads first [stress cycles or turns].
    cycle_rates : Real
        Stress cycles or turns per time f_j at each load, not negative [1/s].
    time_shares : Real
        Share of the time phi_j at each load [-].

    Returns
    -------
    Real
        Shares, loads first [-]; they add up to 1. nan where nothing is damaged.

    References
    ----------
    A. Palmgren, Z. VDI 68 (1924) 339; M. A. Miner, J. Appl. Mech. 12 (1945) A159. Equation (B8) of :doc:`/equations`.
    """
    damage = time_shares * cycle_rates / lives
    total = xp.sum(damage, axis=0)
    return damage / xp.where(total == 0.0, xp.nan, total)

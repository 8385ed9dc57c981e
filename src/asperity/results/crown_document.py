"""Which crown the rollers of a joint need if their axes are tilted, as one JSON document."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from asperity.contact.hertz_line import half_width
from asperity.contact.roller_profiles import (
    ISO_16281_LENGTH,
    iso_16281_coefficient,
    logarithmic_profile,
    lundberg_coefficient,
)
from asperity.contact.tilted_line import (
    PLACES,
    ProfiledLine,
    logarithmic_drop,
    logarithmic_end_drop,
    profiled_line,
)
from asperity.errors import NoSolutionError
from asperity.joint.description import Joint, joint_contacts
from asperity.results.solved import SolvedJoint
from asperity.types import Array, Document

#: Drop over the approach of cylinders with this tilt, at most; and over the least that frees the ends, at most.
_ROUNDEST, _WIDER = 1e3, 10.0
#: Coefficient of Lundberg's profile over that of parallel rollers, at most.
_LARGEST_COEFFICIENT = 100.0


def crown_document(solved: SolvedJoint, tilt: float) -> Document:
    """The contacts of a joint whose axes are tilted [rad] with several profiles, in SI units, for :func:`json.dumps`.

    Under the largest normal force of each contact: without torque, standing and rolling under it. ``profiles``: as the
    file crowns it, then circular and logarithmic ones with half, all and twice the drop of :func:`least_pressed_drop`,
    Lundberg's with half, all and twice the coefficient of :func:`least_pressed_coefficient`, and that of ISO/TS 16281
    for the smaller roller; of both bodies together, and none of a contact without force. ``end_over_mean`` is the line
    load at the ends over the mean, without the stress of an edge. ``edge``: whether an end is loaded; its pressure has
    no bound, and the contact no peak pressure. A ``NoSolutionError`` is raised if no profile takes the tilt up.
    """
    joint, result = solved.joint, solved.result
    pairs, curvatures = joint_contacts(joint).pairs, joint.crown_curvatures or (0.0,)
    profiled = joint.logarithmic_crowns or (False,) * len(joint.contact_names)
    states = (result.rest.normal, result.forces.normal, result.rolling.normal)
    of_all = {
        "normal_force": np.nanmax([np.asarray(normal) for normal in states], axis=0),
        "contact_length": pairs.contact_length,
        "effective_radius": pairs.effective_radius,
        "contact_modulus": pairs.moduli.contact_modulus,
    }
    numbers = np.broadcast_arrays(
        *(np.asarray(values, dtype=float) for values in (*of_all.values(), curvatures, _rollers(joint)))
    )
    contacts = {}
    for name, logarithmic, *values, curvature, diameter in zip(
        joint.contact_names, profiled, *numbers, strict=True
    ):
        pair = dict(zip(of_all, map(float, values), strict=True))
        try:
            pressed = pair["normal_force"] > 0.0
            profiles = (
                list(_profiles(pair, tilt, float(curvature), float(diameter), logarithmic=logarithmic))
                if pressed
                else []
            )
        except NoSolutionError as error:
            raise NoSolutionError(f"{name}: {error}") from None
        force, length = pair["normal_force"], pair["contact_length"]
        contacts[name] = {"normal_force_N": force, "contact_length_m": length, "profiles": profiles}
    return {"tilt_rad": tilt, "contacts": contacts}


def _rollers(joint: Joint) -> Array:
    """Diameter of the smaller body of each contact, shape (contacts,) [m]."""
    first, second = (np.asarray(radius) for radius in (joint.drive.first_radius, joint.drive.second_radius))
    return 2.0 * np.minimum(first, second)


def _profiles(
    pair: dict[str, float], tilt: float, curvature: float, diameter: float, *, logarithmic: bool
) -> Iterator[Document]:
    """One contact with several profiles, first that of the file, last that of ISO/TS 16281, if it has its length."""
    length = pair["contact_length"]
    circle, width = (2.0 * PLACES) ** 2, float(half_width(**pair))
    logarithm = np.asarray(logarithmic_drop(even_half_width=width, contact_length=length))
    end_drop = float(logarithmic_end_drop(even_half_width=width, contact_length=length))
    stated = curvature * length**2 / 8.0
    unit = np.asarray(logarithmic_profile(coefficient=1.0, end_share=1.0))
    if logarithmic:
        numbers: dict[str, float | None] = {"end_drop_m": None, "coefficient_m": stated}
        yield _entry("as_stated", None, unit, stated, tilt, pair, **numbers)
    else:
        yield _entry("as_stated", None, circle, stated, tilt, pair, crown_radius_m=_radius(stated, length))
    for profile, shape in (("circular", circle), ("logarithmic", logarithm)):
        drop = least_pressed_drop(shape, tilt=tilt, **pair)
        for share in (0.5, 1.0, 2.0):
            of_shape = (
                {"crown_radius_m": _radius(share * drop, length)}
                if shape is circle
                else {"coefficient_m": share * drop / end_drop}
            )
            yield _entry(profile, share, shape, share * drop, tilt, pair, **of_shape)
    coefficient = least_pressed_coefficient(tilt=tilt, **pair)
    for share in (0.5, 1.0, 2.0):
        numbers = {"end_drop_m": None, "coefficient_m": share * coefficient}
        yield _entry("lundberg", share, unit, share * coefficient, tilt, pair, **numbers)
    if length <= ISO_16281_LENGTH * diameter:
        standard = float(iso_16281_coefficient(roller_diameter=diameter))
        numbers = {"end_drop_m": None, "coefficient_m": standard}
        yield _entry("iso_16281", None, unit, standard, tilt, pair, **numbers)


def _radius(drop: float, length: float) -> float | None:
    """Radius of a circle that drops by this at the ends; None of a cylinder [m]."""
    return length**2 / (8.0 * drop) if drop else None


def _entry(
    profile: str,
    share: float | None,
    shape: np.ndarray,
    drop: float,
    tilt: float,
    pair: dict[str, float],
    **numbers: float | None,
) -> Document:
    """A contact with a profile, the drop times its shape."""
    line = profiled_line(gap=drop * shape - tilt * pair["contact_length"] * PLACES, **pair)
    peak, end = float(line.peak_pressure), float(line.end_line_load)
    known = math.isfinite(peak) and end == 0.0
    return {
        "profile": profile,
        "share_of_recommended": share,
        "end_drop_m": drop,
        "crown_radius_m": None,
        "coefficient_m": None,
        **numbers,
        "peak_pressure_Pa": peak if known else None,
        "edge": end > 0.0,
        "peak_over_mean": float(np.max(line.line_load)) * pair["contact_length"] / pair["normal_force"],
        "end_over_mean": end * pair["contact_length"] / pair["normal_force"],
    }


def least_pressed_coefficient(*, tilt: float, **pair: float) -> float:
    r"""The coefficient of Lundberg's profile with the lowest peak pressure of tilted rollers.

    .. math:: \min_A \max_y p(y) \quad\text{for}\quad g(y) = A \ln\frac{1}{1 - (2y/B)^2} - \phi y,
        \qquad A \ge \frac{P'}{\pi E^*}

    Not less than that of parallel rollers: slices do not know the edge that less of it makes. Of a ``tilt`` [rad] and a
    ``pair`` as of :func:`~asperity.contact.tilted_line.profiled_line`; [m]. Its ends are free under any tilt. Equation
    (B13) of :doc:`/equations`.
    """
    unit = np.asarray(logarithmic_profile(coefficient=1.0, end_share=1.0))
    mean = pair["normal_force"] / pair["contact_length"]
    least = float(lundberg_coefficient(line_load=mean, contact_modulus=pair["contact_modulus"]))

    def peak(logarithm: float) -> float:
        gap = math.exp(logarithm) * unit - tilt * pair["contact_length"] * PLACES
        found = float(profiled_line(gap=gap, **pair).peak_pressure)
        return found if math.isfinite(found) else math.inf

    bounds = (math.log(least), math.log(_LARGEST_COEFFICIENT * least))
    best = minimize_scalar(peak, bounds=bounds, method="bounded", options={"xatol": 1e-4}).x
    return math.exp(min((bounds[0], best), key=peak))


def least_pressed_drop(shape: Array | np.ndarray, *, tilt: float, **pair: float) -> float:
    r"""The drop of a profile at its ends with the lowest peak pressure of those that free both ends of tilted rollers.

    .. math:: \min_{z_m} \max_y p(y) \quad\text{for}\quad g(y) = z_m\,s(y) - \phi y, \qquad P'(\pm B/2) = 0

    Of ``shape`` s, the drop over that at the ends, shape (slices,) [-], a ``tilt`` [rad], and a ``pair`` as of
    :func:`~asperity.contact.tilted_line.profiled_line`; [m]. A loaded end is a sharp edge, whose pressure has no bound:
    hence the condition. A ``NoSolutionError`` is raised if no drop frees the ends of a contact that is twice as long as
    wide. The criterion of H. Fujiwara and T. Kawase, NTN Tech. Rev. 75 (2007) 140; equation (B13) of :doc:`/equations`.
    """

    def line(drop: float) -> ProfiledLine:
        return profiled_line(gap=drop * shape - tilt * pair["contact_length"] * PLACES, **pair)

    def end_gap(logarithm: float) -> float:
        return float(line(math.exp(logarithm)).end_gap)

    def peak(logarithm: float) -> float:
        return float(line(math.exp(logarithm)).peak_pressure)

    pressed = -float(line(0.0).end_gap)
    low, high = math.log(pressed / _ROUNDEST), math.log(pressed * _ROUNDEST)
    freed = 1e-6 + brentq(end_gap, low, high, xtol=1e-6) if end_gap(high) > 0.0 else high
    bounds = (freed, freed + math.log(_WIDER))
    best = minimize_scalar(peak, bounds=bounds, method="bounded", options={"xatol": 1e-4}).x
    least = min((freed, best), key=peak)
    if freed == high or math.isnan(peak(least)):
        raise NoSolutionError(
            f"no crown takes up a tilt of {1e3 * tilt:.3g} mrad: with free ends the contact would be less than twice "
            "as long as wide; align the rollers better, or press them less"
        )
    return math.exp(least)

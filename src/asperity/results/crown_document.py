"""Which crown the rollers of a joint need if their axes are tilted, as one JSON document."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from asperity.contact.hertz_line import half_width
from asperity.contact.tilted_line import (
    PLACES,
    ProfiledLine,
    logarithmic_drop,
    logarithmic_end_drop,
    profiled_line,
)
from asperity.errors import NoSolutionError
from asperity.joint.description import joint_contacts
from asperity.results.solved import SolvedJoint
from asperity.types import Array, Document

#: Drop over the approach of cylinders with this tilt, at most; and over the least that frees the ends, at most.
_ROUNDEST, _WIDER = 1e3, 10.0


def crown_document(solved: SolvedJoint, tilt: float) -> Document:
    """The contacts of a joint whose axes are tilted [rad] with several profiles, in SI units, for :func:`json.dumps`.

    Under the largest normal force of each contact: without torque, standing and rolling under it. ``profiles``: as the
    file crowns it, then circular and logarithmic ones with half, all and twice the drop of :func:`least_pressed_drop`,
    of both bodies together; none of a contact without force. ``end_over_mean`` is the line load at the ends over the
    mean, without the stress of an edge. A ``NoSolutionError`` is raised if no profile takes the tilt up.
    """
    joint, result = solved.joint, solved.result
    pairs, curvatures = joint_contacts(joint).pairs, joint.crown_curvatures or (0.0,)
    states = (result.rest.normal, result.forces.normal, result.rolling.normal)
    of_all = {
        "normal_force": np.nanmax([np.asarray(normal) for normal in states], axis=0),
        "contact_length": pairs.contact_length,
        "effective_radius": pairs.effective_radius,
        "contact_modulus": pairs.moduli.contact_modulus,
    }
    numbers = np.broadcast_arrays(
        *(np.asarray(values, dtype=float) for values in (*of_all.values(), curvatures))
    )
    contacts = {}
    for name, *values, curvature in zip(joint.contact_names, *numbers, strict=True):
        pair = dict(zip(of_all, map(float, values), strict=True))
        try:
            profiles = list(_profiles(pair, tilt, float(curvature))) if pair["normal_force"] > 0.0 else []
        except NoSolutionError as error:
            raise NoSolutionError(f"{name}: {error}") from None
        force, length = pair["normal_force"], pair["contact_length"]
        contacts[name] = {"normal_force_N": force, "contact_length_m": length, "profiles": profiles}
    return {"tilt_rad": tilt, "contacts": contacts}


def _profiles(pair: dict[str, float], tilt: float, curvature: float) -> Iterator[Document]:
    """One contact with several profiles, first that of the file."""
    length, mean = pair["contact_length"], pair["normal_force"] / pair["contact_length"]
    circle, width = (2.0 * PLACES) ** 2, float(half_width(**pair))
    logarithm = np.asarray(logarithmic_drop(even_half_width=width, contact_length=length))
    end_drop = float(logarithmic_end_drop(even_half_width=width, contact_length=length))
    chosen = [("as_stated", circle, 1.0, curvature * length**2 / 8.0)]
    for profile, shape in (("circular", circle), ("logarithmic", logarithm)):
        drop = least_pressed_drop(shape, tilt=tilt, **pair)
        chosen += [(profile, shape, factor, factor * drop) for factor in (0.5, 1.0, 2.0)]
    for profile, shape, factor, drop in chosen:
        line = profiled_line(gap=drop * shape - tilt * length * PLACES, **pair)
        peak = float(line.peak_pressure)
        yield {
            "profile": profile,
            "share_of_recommended": None if profile == "as_stated" else factor,
            "end_drop_m": drop,
            "crown_radius_m": length**2 / (8.0 * drop) if drop and shape is circle else None,
            "coefficient_m": drop / end_drop if shape is logarithm else None,
            "peak_pressure_Pa": peak if math.isfinite(peak) else None,
            "end_over_mean": float(line.end_line_load) / mean,
        }


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

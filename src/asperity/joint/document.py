"""A solved joint as one JSON document: SI units, the unit at the end of every key."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import asperity
from asperity.contact.fractal import VERIFIED_FRACTAL_DIMENSIONS
from asperity.drive.geometry import CONTACT_NAMES
from asperity.drive.torsional_stiffness import TorsionalStiffness
from asperity.joint.capacity import capacity_document
from asperity.joint.description import Joint
from asperity.joint.diagnostics import Diagnostic, listing
from asperity.joint.evaluation import JointResult
from asperity.joint.examination import Examination

Document = dict[str, Any]


def joint_document(
    *, joint: Joint, examination: Examination, inputs: Document, assumptions: tuple[str, ...]
) -> Document:
    """Everything that is known about a joint, ready for :func:`json.dumps`.

    Parameters
    ----------
    joint : Joint
        The joint that was solved.
    examination : Examination
        What came out.
    inputs : dict
        Tables of the joint file in SI units.
    assumptions : tuple of str
        What the file leaves out, one sentence each.

    Returns
    -------
    dict
        Nested tables of numbers and text. Numbers that are not finite are None; the diagnostics say why.
    """
    result = examination.result
    document = {
        "asperity_version": asperity.__version__,
        "input": inputs,
        "assumptions": list(assumptions),
        "geometry": _geometry(examination),
        "forces": _forces(result),
        "torque_capacity": _capacity(examination),
        "contacts": {name: _contact(result, index) for index, name in enumerate(CONTACT_NAMES)},
        "torsional_stiffness": _torsional_stiffness(result),
        "stiffness_budget": _stiffness_budget(result),
        "diagnostics": [
            {
                "name": entry.name,
                "contact": entry.contact,
                "value": entry.value,
                "limit": entry.limit,
                "ok": entry.ok,
                "meaning": entry.meaning,
            }
            for entry in (*listing(result), *_verified_range(joint))
        ],
    }
    cleaned: Document = _plain(document)
    return cleaned


def _verified_range(joint: Joint) -> tuple[Diagnostic, ...]:
    """Whether each D lies where the contact law is verified to rounding; the limit shown is the nearer bound."""
    low, high = VERIFIED_FRACTAL_DIMENSIONS
    names: tuple[str | None, ...] = (None,) if len(joint.surfaces) == 1 else CONTACT_NAMES
    entries = []
    for contact, surface in zip(names, joint.surfaces, strict=True):
        value = float(surface.fractal_dimension)
        ok = low <= value <= high
        meaning = (
            f"D is {'inside' if ok else 'outside'} the verified range of the contact law, {low} to {high}"
        )
        limit = low if value < 0.5 * (low + high) else high
        entries.append(Diagnostic("fractal_dimension", contact, value, limit, ok, meaning))
    return tuple(entries)


def _geometry(examination: Examination) -> Document:
    angles = examination.result.angles
    return {
        "alpha_rad": angles.polar,
        "theta_rad": angles.direction,
        "wedge_angle_rad": angles.wedge,
        "speed_ratio": examination.result.speed_ratio,
        "clearances": [{"condition": gap.name, "gap_m": gap.gap} for gap in examination.clearances],
    }


def _forces(result: JointResult) -> Document:
    forces = result.forces
    return {
        "normal_N": dict(zip(CONTACT_NAMES, np.asarray(forces.normal), strict=True)),
        "tangential_N": dict(zip(CONTACT_NAMES, np.asarray(forces.tangential), strict=True)),
        "pin_N": {"left": forces.pin_left, "right": forces.pin_right},
        "input_torque_Nm": forces.input_torque,
        "output_torque_Nm": forces.output_torque,
        "bearing_torque_Nm": {"left": forces.left_bearing_torque, "right": forces.right_bearing_torque},
        "planet_mass_kg": result.planet_mass,
        "loading_roller_mass_kg": result.loading_roller_mass,
        "carrier_speed_rad_per_s": result.carrier_speed,
        "balance_residual": forces.balance_residual,
        "closure_residual": forces.closure_residual,
    }


def _capacity(examination: Examination) -> Document:
    return {
        **capacity_document(examination.capacity),
        "reverse": capacity_document(examination.reverse_capacity),
    }


def _contact(result: JointResult, index: int) -> Document:
    contacts, interfaces, diagnostics = result.contacts, result.interfaces, result.diagnostics
    columns = {
        "largest_area_m2": contacts.largest_area,
        "critical_area_m2": contacts.critical_area,
        "real_contact_area_m2": contacts.real_contact_area,
        "contact_factor": contacts.contact_factor,
        "domain_extension_factor": contacts.domain_extension_factor,
        "elastic_load_N": contacts.elastic_load,
        "plastic_load_N": contacts.plastic_load,
        "tangential_stiffness_N_per_m": contacts.tangential_stiffness,
        "normal_stiffness_N_per_m": contacts.normal_stiffness,
        "torsional_stiffness_Nm_per_rad": result.contact_torsional_stiffness,
        "bulk_tangential_stiffness_N_per_m": interfaces.bulk_tangential,
        "bulk_normal_stiffness_N_per_m": interfaces.bulk_normal,
        "hertz_half_width_m": diagnostics.hertz_half_width,
        "hertz_peak_pressure_Pa": diagnostics.hertz_peak_pressure,
    }
    return {name: np.broadcast_to(values, (len(CONTACT_NAMES),))[index] for name, values in columns.items()}


def _torsional_stiffness(result: JointResult) -> Document:
    return {
        "published": _stiffness(result.published),
        "series_with_bulk": _stiffness(result.series_with_bulk),
        "assembly": _stiffness(result.assembly.stiffness),
    }


def _stiffness(stiffness: TorsionalStiffness) -> Document:
    return {
        "sun_Nm_per_rad": stiffness.sun,
        "output_Nm_per_rad": stiffness.output,
        "output_Nm_per_arcmin": stiffness.output_per_arcminute,
    }


def _stiffness_budget(result: JointResult) -> Document:
    """Shares of the assembly's compliance; they add up to 1."""
    shares = vars(result.assembly).items()
    return {
        name: dict(zip(CONTACT_NAMES, np.asarray(share), strict=True)) if np.ndim(share) else share
        for name, share in shares
        if name.endswith("_share")
    }


def _plain(node: Any) -> Any:
    """Python numbers instead of arrays, None instead of what JSON cannot say."""
    if isinstance(node, dict):
        return {name: _plain(value) for name, value in node.items()}
    if isinstance(node, list):
        return [_plain(value) for value in node]
    if isinstance(node, str | bool | None):
        return node
    number = float(node)
    return number if math.isfinite(number) else None

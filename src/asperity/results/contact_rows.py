"""Rows of the table of results: forces, and what they do to each contact."""

from __future__ import annotations

import functools
import operator
from typing import Any

import numpy as np

from asperity.engine.arrays import xp
from asperity.results.result import Column, Result
from asperity.results.solved import ONLY_SPOTS, SolvedJoint, has_spots
from asperity.unit_table import Dimension

_force = functools.partial(Result, group="forces")
_newtons = functools.partial(_force, dimension=Dimension.FORCE, display_unit="N")
_contact_force = functools.partial(_newtons, axis="contact")
_contact = functools.partial(Result, group="contacts", axis="contact")
_bulk = functools.partial(_contact, dimension=Dimension.STIFFNESS, display_unit="N/um")
_spot = functools.partial(
    _contact, present=has_spots, only=ONLY_SPOTS, note="nan for surfaces by their rms_height"
)

_FORCE, _TORQUE, _STIFFNESS = Dimension.FORCE, Dimension.TORQUE, Dimension.STIFFNESS
_AREA, _NUMBER = Dimension.AREA, Dimension.DIMENSIONLESS
_PLASTIC = "nan where every spot of the contact is plastic"


def _elastic(
    name: str, label: str, path: str, dimension: Dimension, unit: str, *, column: Column, note: str = ""
) -> Result:
    """A stiffness of the asperities: the contact law has none where every spot of a loaded contact is plastic."""

    def value(solved: SolvedJoint) -> Any:
        result = solved.result
        plastic = (result.forces.normal > 0.0) & (result.contacts.normal_stiffness <= 0.0)
        return xp.where(plastic, np.nan, operator.attrgetter(path)(result))

    note = f"{note}; {_PLASTIC}" if note else _PLASTIC
    return _contact(name, label, dimension, unit, value, note=note, column=column)


def _crowned(name: str, label: str, path: str, note: str, column: Column) -> Result:
    """A number of crowned contacts; nan for contacts between cylinders in a joint without any crown."""

    def value(solved: SolvedJoint) -> Any:
        quantity = operator.attrgetter(path)(solved.result)
        normal = solved.result.forces.normal
        return xp.full_like(normal, np.nan) if quantity is None else quantity

    note = f"{note}; nan where no roller of the joint is crowned"
    return _contact(name, label, _NUMBER, "1", value, note=note, column=column)


ROWS = (
    _newtons(
        "preload",
        "normal force of the first contact in the assembled drive",
        value="preload",
        needs="geometry",
        note="with a loading cam, that under the output torque",
        place="preload.force_N",
    ),
    _force(
        "interference",
        "interference giving the preload",
        Dimension.LENGTH,
        "um",
        "result.interference",
        needs="geometry",
        note="of smooth bodies: by how much the ring's inner radius lies below that at which all contacts just touch",
        place="preload.interference_m",
    ),
    _force(
        "thermal_interference",
        "interference added by temperature",
        Dimension.LENGTH,
        "um",
        lambda solved: 0.0 if solved.joint.fit is None else solved.joint.fit.thermal_change,
        needs="geometry",
        positive=False,
        note="by the working temperature, to that at the assembly; 0 without [temperature], or where load.preload is a "
        "force",
        place="",
    ),
    _force(
        "cam_angle",
        "angle of the loading cam, at the output",
        Dimension.ANGLE,
        "arcmin",
        "result.cam_angle",
        needs="geometry",
        positive=False,
        note="of a cam without friction; 0 without one",
        place="",
    ),
    _contact_force(
        "normal_force",
        "normal force of the contact",
        value="result.forces.normal",
        column=Column("forces", "normal"),
        place="standing.forces.normal_N.*",
    ),
    _contact_force(
        "tangential_force",
        "tangential force of the contact",
        value="result.forces.tangential",
        positive=False,
        column=Column("forces", "tangential"),
        place="standing.forces.tangential_N.*",
    ),
    _newtons(
        "pin_force",
        "force of a roller on its pin along the push, standing",
        value="result.forces.pins",
        axis="pin",
        positive=False,
        place="",
    ),
    _force(
        "input_torque",
        "torque at the input",
        _TORQUE,
        "N*m",
        "result.forces.input_torque",
        positive=False,
        note="without losses in rolling",
    ),
    _elastic(
        "asperity_tangential_stiffness",
        "tangential stiffness of the contact's asperities",
        "interfaces.asperity_tangential",
        _STIFFNESS,
        "N/um",
        column=Column("stiffness", "tangential, asperities"),
    ),
    _elastic(
        "asperity_normal_stiffness",
        "normal stiffness of the contact's asperities",
        "interfaces.asperity_normal",
        _STIFFNESS,
        "N/um",
        column=Column("stiffness", "normal, asperities"),
    ),
    _bulk(
        "bulk_tangential_stiffness",
        "tangential stiffness of the contact's bodies",
        value="result.interfaces.bulk_tangential",
        column=Column("stiffness", "tangential, bodies"),
    ),
    _bulk(
        "bulk_normal_stiffness",
        "normal stiffness of the contact's bodies",
        value="result.interfaces.bulk_normal",
        column=Column("stiffness", "normal, bodies"),
    ),
    _elastic(
        "contact_torsional_stiffness",
        "torsional stiffness of the contact's asperities",
        "contact_torsional_stiffness",
        Dimension.TORSIONAL_STIFFNESS,
        "N*m/rad",
        note="at the contact's driven roller",
        column=Column("stiffness", "torsional, asperities"),
    ),
    _contact(
        "hertz_half_width",
        "half-width of the Hertzian contact",
        Dimension.LENGTH,
        "mm",
        "result.diagnostics.hertz_half_width",
        column=Column("forces", "Hertz width", factor=2.0),
    ),
    _contact(
        "hertz_pressure",
        "Hertz pressure",
        Dimension.PRESSURE,
        "MPa",
        "result.diagnostics.hertz_pressure",
        note="peak pressure of the smooth line contact, in the middle of a crowned one",
        column=Column("forces", "Hertz pressure"),
    ),
    _crowned(
        "loaded_length_share",
        "loaded share of the contact length",
        "diagnostics.loaded_length_share",
        "below 1 the ends are free",
        Column("crowns", "loaded length", unit="%"),
    ),
    _crowned(
        "peak_line_load_ratio",
        "peak line load over mean line load",
        "diagnostics.peak_line_load_ratio",
        "the mean is the normal force over the whole contact length",
        Column("crowns", "peak over mean load"),
    ),
    _crowned(
        "end_line_load_ratio",
        "line load at the ends over mean line load",
        "diagnostics.end_line_load_ratio",
        "0 where the ends are free; without the stress concentration of an edge",
        Column("crowns", "end over mean load"),
    ),
    _spot("largest_area", "largest contact spot", _AREA, "mm^2", "result.contacts.largest_area"),
    _spot("critical_area", "critical contact spot", _AREA, "mm^2", "result.contacts.critical_area"),
    _spot(
        "real_contact_area",
        "real area of contact",
        _AREA,
        "mm^2",
        "result.contacts.real_contact_area",
        column=Column("forces", "real area"),
    ),
    _contact("elastic_load", "load carried by elastic spots", _FORCE, "N", "result.contacts.elastic_load"),
    _contact("plastic_load", "load carried by plastic spots", _FORCE, "N", "result.contacts.plastic_load"),
    _spot(
        "domain_extension_factor",
        "domain extension factor psi",
        _NUMBER,
        "1",
        "result.contacts.domain_extension_factor",
    ),
    _spot("contact_factor", "contact factor lambda", _NUMBER, "1", "result.contacts.contact_factor"),
)

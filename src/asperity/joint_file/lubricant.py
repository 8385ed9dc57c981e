"""The oil of a joint file: checks of what it states, and the :class:`asperity.rolling.conditions.Lubricant` of it."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Mapping
from typing import TypeVar

import numpy as np

from asperity.contact.fluid import (
    DataSheetTraction,
    FilmTraction,
    Fluid,
    LimitingTraction,
    RheologicalTraction,
    film_slope,
)
from asperity.contact.measured_traction import (
    MeasuredTraction,
    TractionConditions,
    TractionTable,
    traction_curve,
)
from asperity.contact.viscosity import (
    MINERAL_OIL_RISE,
    EstimatedPressureRise,
    ExponentialViscosity,
    RationalPressureRise,
    RoelandsPressureRise,
    Viscosity,
    WaltherViscosity,
    reciprocal_asymptotic_coefficient,
    walther_viscosity,
)
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.errors import InputError
from asperity.joint_file.fluid_entries import CURVES, FluidEntry, rig_contact
from asperity.joint_file.sections import Lubrication
from asperity.library.fluids import LibraryFluid, library_fluid, refuse_unknown_fluid, section_of
from asperity.rolling.conditions import ZERO_CELSIUS, Lubricant
from asperity.types import Document, Real

#: Shear modulus of films [Pa], and the range in which that of oils lies, where a file states none.
SHEAR_MODULUS, SHEAR_MODULI = 0.5e9, (0.3e9, 1.5e9)
#: Thermal conductivity of mineral oils [W/(m K)].
CONDUCTIVITY = 0.14
#: How a film yields of which nothing else is known.
SHEAR_LAW = "eyring"

_Law = TypeVar("_Law", bound=Module)
_VISCOSITIES: dict[str, type[ExponentialViscosity | WaltherViscosity]] = {
    "exponential": ExponentialViscosity,
    "walther": WaltherViscosity,
}
_RISES: dict[str, type[RationalPressureRise | RoelandsPressureRise]] = {
    "rational": RationalPressureRise,
    "roelands": RoelandsPressureRise,
}


def refuse_oil(oil: Lubrication | None, fluids: Mapping[str, FluidEntry], *, temperature: bool) -> None:
    """Refuse a fluid that nobody knows, or of which something is missing.

    ``temperature``: whether the file states one.
    """
    if oil is None or oil.fluid is None:
        return
    try:
        refuse_unknown_fluid(oil.fluid, fluids)
    except InputError as error:
        raise InputError(f"lubrication.fluid: {error}") from None
    if not temperature:
        raise InputError(
            f"lubrication.fluid = '{oil.fluid}': the oil has the temperature of the drive, which is missing: give a "
            'section [temperature] with assembly and working, e.g. "20 degC" and "40 degC", or [heat]'
        )
    known, section = library_fluid(oil.fluid), section_of(oil.fluid, fluids)
    entry, name = (FluidEntry(), oil.fluid) if section is None else (fluids[section], section)
    if entry.viscosity_40 is None and not (known and known.viscosity):
        raise InputError(
            f"fluids.{name}: its viscosity is not known; give viscosity_40, viscosity_100 and density, e.g. "
            '"100 mm^2/s", "11 mm^2/s" and "880 kg/m^3", from its data sheet'
        )
    lonely = [key for key in ("shear_law", "shear_modulus") if getattr(entry, key) is not None]
    if lonely and known is None and entry.limiting_traction is None:
        raise InputError(
            f"fluids.{name}: {' and '.join(lonely)}: without limiting_traction nothing is known of the film's "
            "traction; give it, or leave them out"
        )


def lubricant_of(values: Document, temperature: Real | None) -> Lubricant | None:
    """The oil that the tables of a joint file describe, at a temperature [degC]; None where they name no fluid.

    Its fluid has no traction where none of it is known.
    """
    oil = values.get("lubrication", {})
    if "fluid" not in oil:
        return None
    assert temperature is not None, "a fluid has the temperature of its drive"
    sections, known = values.get("fluids", {}), library_fluid(oil["fluid"])
    section = section_of(oil["fluid"], sections)
    entry = {} if section is None else sections[section]
    points = oil.get("boundary_friction", {}).values()
    lowest = entry.get("lowest_temperature", known and known.lowest_temperature)
    stated = {key: oil[key] for key in ("supply", "creep_limit", "film_law", "load_sharing") if key in oil}
    return Lubricant(
        fluid=Fluid(_viscosity(entry, known), _traction(entry, known), _conductivity(entry, known)),
        temperature=temperature + ZERO_CELSIUS,
        friction_speeds=tuple(point["slip_speed"] for point in points),
        friction_coefficients=tuple(point["coefficient"] for point in points),
        lowest_temperature=None if lowest is None else lowest + ZERO_CELSIUS,
        **stated,
    )


def fluid_document(fluid: LibraryFluid) -> Document:
    """An oil of the library for a JSON document: its entry, and its :func:`fluid_properties`."""
    return dataclasses.asdict(fluid) | {"properties": fluid_properties(fluid)}


def fluid_properties(fluid: LibraryFluid) -> dict[str, float]:
    """What an oil of the library is known by, in SI units; without a viscosity its limiting traction alone.

    ``viscosity_40_Pa_s`` and ``viscosity_100_Pa_s``; ``pressure_coefficient_per_Pa``, the reciprocal asymptotic one,
    and ``limiting_traction`` over the pressure, at 40 degC and 1 GPa.
    """
    warm, pressure = 40.0 + ZERO_CELSIUS, xp.asarray(1e9)
    limit = LimitingTraction(**fluid.limiting_traction).at(pressure, warm) / pressure
    traction = {"limiting_traction": float(limit)}
    if not fluid.viscosity:
        return traction
    viscosity = _viscosity({}, fluid)
    coefficient = reciprocal_asymptotic_coefficient(
        viscosity=viscosity, peak_pressure=pressure, temperature=warm
    )
    return {
        "viscosity_40_Pa_s": float(viscosity.base(warm)),
        "viscosity_100_Pa_s": float(viscosity.base(100.0 + ZERO_CELSIUS)),
        "pressure_coefficient_per_Pa": float(coefficient),
        **traction,
    }


def _viscosity(entry: Document, known: LibraryFluid | None) -> Viscosity:
    """Viscosity of an oil, from its table or the library."""
    if "viscosity_40" in entry:
        base: ExponentialViscosity | WaltherViscosity = walther_viscosity(
            **{key: entry[key] for key in ("viscosity_40", "viscosity_100", "density")}
        )
    else:
        assert known is not None
        base = _of_law(_VISCOSITIES, known.viscosity)
    return Viscosity(base, _pressure_rise(entry, known))


def _pressure_rise(
    entry: Document, known: LibraryFluid | None
) -> RationalPressureRise | RoelandsPressureRise | EstimatedPressureRise:
    """How the viscosity rises with pressure: as stated, as the library has it, or estimated."""
    if "pressure_coefficient" in entry:
        return RoelandsPressureRise(entry["pressure_coefficient"], 0.0, ZERO_CELSIUS)
    if known is not None and known.pressure_rise:
        return _of_law(_RISES, known.pressure_rise)
    return MINERAL_OIL_RISE


def _of_law(laws: Mapping[str, type[_Law]], numbers: Document) -> _Law:
    """The law that numbers of the library name, with them."""
    return laws[numbers["law"]](**{key: value for key, value in numbers.items() if key != "law"})


def _conductivity(entry: Document, known: LibraryFluid | None) -> Real:
    """Thermal conductivity of an oil [W/(m K)]."""
    of_library = None if known is None else known.conductivity
    conductivity: Real = entry.get("conductivity", CONDUCTIVITY if of_library is None else of_library)
    return conductivity


def _traction(entry: Document, known: LibraryFluid | None) -> FilmTraction | None:
    """What the film does when it is sheared; None where nothing is known of it."""
    if CURVES in entry:
        return _of_curves(json.loads(entry[CURVES]))
    if "traction_table" in entry:
        return _of_table(list(entry["traction_table"].values()), entry)
    if "maximum_traction" in entry:
        return DataSheetTraction(entry["maximum_traction"], _slope_of_film(entry, entry))
    if "limiting_traction" in entry:
        limit = LimitingTraction(entry["limiting_traction"])
    elif known is not None:
        limit = LimitingTraction(**known.limiting_traction)
    else:
        return None
    of_library = None if known is None else known.shear_law
    return RheologicalTraction(
        limit, entry.get("shear_modulus", SHEAR_MODULUS), entry.get("shear_law", of_library or SHEAR_LAW)
    )


def _slope_of_film(row: Document, entry: Document) -> Real:
    """First slope of the traction of a film, without the discs of the rig on which it was measured [-]."""
    slope: Real = row["traction_slope"]
    if "rig" not in entry:
        return slope
    modulus, peak = rig_contact(entry["rig"], row.get("pressure"))
    return film_slope(slope=slope, rig_modulus=modulus, rig_peak_pressure=peak)


def _of_table(rows: list[Document], entry: Document) -> DataSheetTraction:
    """A data sheet over its conditions; the rows are all combinations of them, the speed varying fastest."""
    pressures, temperatures, speeds = map(int, entry["traction_grid"].split())
    steps = (temperatures * speeds, speeds, 1)
    axes = (
        tuple(rows[step * place][name] for place in range(count)) if name in rows[0] else ()
        for name, count, step in zip(_AXES, (pressures, temperatures, speeds), steps, strict=True)
    )
    at, warm, fast = axes
    conditions = TractionConditions(at, tuple(celsius + ZERO_CELSIUS for celsius in warm), fast)
    return DataSheetTraction(
        TractionTable(conditions, tuple(row["maximum_traction"] for row in rows)),
        TractionTable(conditions, tuple(_slope_of_film(row, entry) for row in rows)),
    )


def _of_curves(curves: Document) -> MeasuredTraction:
    """Measured curves of the film, as a text of the tables has them."""
    warm = tuple(celsius + ZERO_CELSIUS for celsius in curves["temperatures"])
    columns = [np.array(points).T for points in curves["curves"]]
    return MeasuredTraction(
        TractionConditions(tuple(curves["pressures"]), warm, tuple(curves["speeds"])),
        tuple(traction_curve(creepage=ratio, coefficient=traction) for ratio, traction in columns),
    )


_AXES = ("pressure", "temperature", "speed")

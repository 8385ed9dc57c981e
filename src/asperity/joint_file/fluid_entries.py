"""Oils in a joint file: their viscosity, and the traction that their films bear."""

from __future__ import annotations

import itertools
import json
from typing import TYPE_CHECKING, Annotated, Literal, Self

from pydantic import BeforeValidator, Field, StringConstraints, WithJsonSchema, model_validator

from asperity.contact.hertz_line import half_width, peak_pressure
from asperity.errors import InputError, quoted
from asperity.joint_file import limits
from asperity.joint_file.quantity_key import Key, Quantity
from asperity.joint_file.section import Section
from asperity.joint_file.traction_curves import FEWEST, Points, checked_points, of_film
from asperity.types import Document, Real
from asperity.units import format_quantity

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
    from pydantic_core import CoreSchema

FluidName = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9_-]{1,60}$")]

#: Key of tables at which the curves of a film stand, a text that is none of their numbers.
CURVES = "traction_curves"

_VISCOSITY = ("viscosity_40", "viscosity_100", "density")
_DATA_SHEET = ("maximum_traction", "traction_slope")
_RHEOLOGY = ("limiting_traction", "shear_law", "shear_modulus")


class RigEntry(Section):
    """Discs on which traction was measured: of one material, in line contact."""

    youngs_modulus: Annotated[Quantity, limits.YOUNGS_MODULUS]
    """Young's modulus of both discs."""
    poisson_ratio: Annotated[Quantity, limits.POISSON_RATIO]
    """Poisson's ratio of both discs."""
    peak_pressure: Annotated[Quantity, limits.PEAK_PRESSURE] | None = None
    """Largest Hertz pressure in the middle of the contact; either this, or load, length and first_radius, unless each
    row or curve states its pressure."""
    load: Annotated[Quantity, limits.RIG_LOAD] | None = None
    """Force that presses the discs together."""
    length: Annotated[Quantity, limits.CONTACT_LENGTH] | None = None
    """Length of their contact line."""
    first_radius: Annotated[Quantity, limits.RIG_RADIUS] | None = None
    """Radius of one disc."""
    second_radius: Annotated[Quantity, limits.RIG_RADIUS] | None = None
    """Radius of the other one; flat if absent."""

    @model_validator(mode="after")
    def _one_pressure(self) -> Self:
        sizes = {name: getattr(self, name) for name in ("load", "length", "first_radius")}
        missing = [name for name, value in sizes.items() if value is None]
        stated = len(missing) < len(sizes) or self.second_radius is not None
        if self.peak_pressure is not None and stated:
            raise InputError(
                "exactly one of 'peak_pressure' and the sizes 'load', 'length', 'first_radius' (and 'second_radius') "
                "is needed, got both"
            )
        if stated and missing:
            raise InputError(f"{' and '.join(missing)}: missing beside the other sizes of the rig")
        return self

    def contact(self, pressure: Quantity | float | None) -> tuple[float, float]:
        """Contact modulus E* and peak pressure [Pa] of a measurement, which may state a pressure of its own.

        An ``InputError`` if nobody states it.
        """
        if pressure is None and self.peak_pressure is None and self.load is None:
            raise InputError(
                "rig: its pressure is missing; give 'peak_pressure', or 'load', 'length', 'first_radius' (and "
                "'second_radius')"
            )
        sizes = {name: key.value for name, key in self if key is not None}
        modulus, peak = rig_contact(sizes, _si(pressure))
        return float(modulus), float(peak)


class Fixed:
    """Annotation of a number that no study varies: its value in SI units."""

    def __init__(self, key: Key) -> None:
        self.key = key

    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Tell pydantic to read a value as its key does."""
        from pydantic_core import core_schema  # it is loaded with pydantic

        return core_schema.no_info_plain_validator_function(lambda written: self.key.read(written).value)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> Document:
        """Describe the key to editors."""
        return self.key.__get_pydantic_json_schema__(schema, handler)


def _points(written: object) -> Points:
    """Pairs of a slide-roll ratio and a traction coefficient."""
    numbers = (int, float)
    if not isinstance(written, list | tuple) or not all(
        isinstance(pair, list | tuple) and len(pair) == 2 and all(isinstance(one, numbers) for one in pair)
        for pair in written
    ):
        raise InputError(f"expected pairs [slide-roll ratio, traction coefficient], got {quoted(written)}")
    return checked_points((pair[0], pair[1]) for pair in written)


_PAIRS_SCHEMA = {
    "type": "array",
    "items": {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2},
    "minItems": FEWEST,
}


class CurveEntry(Section):
    """One measured curve of traction over the slide-roll ratio, and the conditions under which it was measured."""

    file: Annotated[str, StringConstraints(min_length=1, max_length=1000)] | None = None
    """Name of a text file with columns for the slide-roll ratio, srr, and the traction coefficient, mu, from the folder
    of the joint file; either this or points."""
    points: Annotated[Points, BeforeValidator(_points), WithJsonSchema(_PAIRS_SCHEMA)] | None = None
    """Points of the curve, pairs [slide-roll ratio, traction coefficient] with rising ratios."""
    pressure: Annotated[float, Fixed(limits.PEAK_PRESSURE)] | None = None
    """Largest Hertz pressure of the measurement."""
    temperature: Annotated[float, Fixed(limits.TEMPERATURE)] | None = None
    """Temperature of the oil."""
    speed: Annotated[float, Fixed(limits.ROLLING_SPEED)] | None = None
    """Mean speed of both surfaces."""

    @model_validator(mode="after")
    def _some_points(self) -> Self:
        if self.points is None:
            raise InputError("a curve needs its file, or points")
        return self


class TractionRow(Section):
    """Maximum traction and slope of a data sheet under one set of conditions."""

    pressure: Annotated[Quantity, limits.PEAK_PRESSURE] | None = None
    """Largest Hertz pressure of the measurement."""
    temperature: Annotated[Quantity, limits.TEMPERATURE] | None = None
    """Temperature of the oil."""
    speed: Annotated[Quantity, limits.ROLLING_SPEED] | None = None
    """Mean speed of both surfaces."""
    maximum_traction: Annotated[Quantity, limits.MAXIMUM_TRACTION]
    """Largest traction coefficient."""
    traction_slope: Annotated[Quantity, limits.TRACTION_SLOPE]
    """First slope over the slide-roll ratio, as traction_slope of the oil."""


_CONDITIONS = ("pressure", "temperature", "speed")


def grid_of(entries: tuple[CurveEntry, ...] | tuple[TractionRow, ...]) -> tuple[int, int, int]:
    """How many pressures, temperatures and speeds rows or curves have, which are all combinations in rising order.

    An ``InputError`` with the first one that is missing, or out of place, if they are not.
    """
    rows = [tuple(_si(getattr(entry, name)) for name in _CONDITIONS) for entry in entries]
    for name, column in zip(_CONDITIONS, zip(*rows, strict=True), strict=True):
        if any(value is None for value in column) and any(value is not None for value in column):
            raise InputError(f"{name}: state it for all of them, or for none")
    axes = [
        sorted({-1.0 if value is None else value for value in column}) for column in zip(*rows, strict=True)
    ]
    wanted = list(itertools.product(*axes))
    given = [tuple(-1.0 if value is None else value for value in row) for row in rows]
    for place, combination in enumerate(wanted):
        if combination not in given:
            raise InputError(f"{_told(combination)} is missing: give all combinations of the conditions")
        if place >= len(given) or given[place] != combination or len(given) > len(wanted):
            raise InputError(
                f"{_told(combination)} must be number {place + 1}, once: sort by pressure, then temperature, then speed"
            )
    return len(axes[0]), len(axes[1]), len(axes[2])


def _si(stated: Quantity | float | None) -> float | None:
    """The number of a condition in SI units."""
    return stated.value if isinstance(stated, Quantity) else stated


def _told(combination: tuple[float, ...]) -> str:
    """Conditions in words."""
    units = ("GPa", "degC", "m/s")
    told = [
        f"{name} {format_quantity(value, unit)}"
        for name, value, unit in zip(_CONDITIONS, combination, units, strict=True)
        if value != -1.0
    ]
    return " at ".join(told) or "an entry without conditions"


def _curves(written: object) -> object:
    """One curve by the name of its file as a list."""
    return [{"file": written}] if isinstance(written, str) else written


_CURVES_SCHEMA = {
    "anyOf": [
        {"type": "string", "minLength": 1},
        {"type": "array", "items": {"type": "object"}, "minItems": 1},
    ]
}


class FluidEntry(Section):
    """An oil, for lubrication.fluid; in a section with the name of an oil of the library, what replaces its values."""

    viscosity_40: Annotated[Quantity, limits.KINEMATIC_VISCOSITY] | None = None
    """Kinematic viscosity at 40 degC; with viscosity_100 and density, viscosity over temperature by Walther's equation
    (ASTM D341)."""
    viscosity_100: Annotated[Quantity, limits.KINEMATIC_VISCOSITY] | None = None
    """Kinematic viscosity at 100 degC."""
    density: Annotated[Quantity, limits.OIL_DENSITY] | None = None
    """Density of the oil, the same at all temperatures."""
    pressure_coefficient: Annotated[Quantity, limits.PRESSURE_COEFFICIENT] | None = None
    """Pressure coefficient of the viscosity without pressure, which then rises after Roelands; estimated from the
    viscosity as that of a paraffinic mineral oil if absent."""
    limiting_traction: Annotated[Quantity, limits.LIMITING_TRACTION] | None = None
    """Largest shear stress of the film over the pressure, Lambda: the plateau of traction at high slip and pressure."""
    shear_law: Literal["eyring", "limit"] | None = None
    """How the film yields below its limiting_traction: it thins by Eyring's law, as paraffinic oils and PAO do, or it
    flows up to the limit, as traction fluids do; eyring if absent."""
    shear_modulus: Annotated[Quantity, limits.SHEAR_MODULUS] | None = None
    """Shear modulus of the film under pressure, 0.3 to 1.5 GPa; 0.5 GPa if absent."""
    maximum_traction: Annotated[Quantity, limits.MAXIMUM_TRACTION] | None = None
    """Largest traction coefficient of a data sheet; with traction_slope in place of limiting_traction."""
    traction_slope: Annotated[Quantity, limits.TRACTION_SLOPE] | None = None
    """First slope of the traction coefficient over the slide-roll ratio of a data sheet. With rig it is that of the
    measurement and what the discs give way is taken off, otherwise that of the film alone."""
    traction_table: Annotated[tuple[TractionRow, ...], Field(min_length=1)] | None = None
    """Maximum traction and slope of a data sheet over pressure, temperature and speed, in place of single ones: a row
    for each combination, sorted by pressure, temperature and speed, between which they are linear, in the logarithm of
    the speed; held beyond them."""
    traction_curve: (
        Annotated[
            tuple[CurveEntry, ...],
            Field(min_length=1),
            BeforeValidator(_curves),
            WithJsonSchema(_CURVES_SCHEMA),
        ]
        | None
    ) = None
    """Measured traction over the slide-roll ratio in place of all other numbers of the traction: name of a file, or a
    list of curves with file or points and pressure, temperature and speed, sorted and interpolated as traction_table
    is."""
    rig: RigEntry | None = None
    """Discs on which slope or curves were measured, whose part is taken off. Without them curves are taken as read, so
    that discs count twice, in the measurement and in the joint."""
    conductivity: Annotated[Quantity, limits.OIL_CONDUCTIVITY] | None = None
    """Thermal conductivity of the oil; 0.14 W/m/K, of mineral oils, if absent."""
    lowest_temperature: Annotated[Quantity, limits.TEMPERATURE] | None = None
    """Lowest temperature of its data: below it results are marked."""

    def stated(self) -> frozenset[str]:
        """The keys that have a value."""
        return frozenset(name for name, value in self if value is not None)

    @model_validator(mode="after")
    def _complete_viscosity(self) -> Self:
        missing = [name for name in _VISCOSITY if getattr(self, name) is None]
        if 0 < len(missing) < len(_VISCOSITY):
            raise InputError(f"{', '.join(_VISCOSITY)} belong together: give {' and '.join(missing)} as well")
        if self.viscosity_40 and self.viscosity_100 and self.viscosity_100.value >= self.viscosity_40.value:
            raise InputError(
                f"viscosity_100: {self.viscosity_100.text} at 100 degC must be below the viscosity_40, "
                f"{self.viscosity_40.text} at 40 degC: exchange them, or correct one"
            )
        return self

    @model_validator(mode="after")
    def _one_traction(self) -> Self:
        stated = self.stated()
        sheet = [name for name in _DATA_SHEET if name in stated]
        ways: list[list[str]] = [
            [name for name in _RHEOLOGY if name in stated],
            sheet,
            *([str(name)] for name in ("traction_table", "traction_curve") if name in stated),
        ]
        used = [way for way in ways if way]
        if len(sheet) == 1:
            other = next(name for name in _DATA_SHEET if name not in sheet)
            raise InputError(f"{sheet[0]} needs {other} beside it: give both, or leave {sheet[0]} out")
        if len(used) > 1:
            first, *others = used
            raise InputError(
                f"{' and '.join(', '.join(way) for way in used)} all say what traction the film bears: leave all but "
                f"one out, a measured one, such as {', '.join(others[-1])}, is better than {', '.join(first)}"
            )
        if self.rig is not None and not stated & {"traction_slope", "traction_table", "traction_curve"}:
            raise InputError(
                "rig: only with traction_slope, traction_table or traction_curve, measured on it; leave it out"
            )
        return self

    @model_validator(mode="after")
    def _less_steep_than_discs(self) -> Self:
        rows = self.traction_table or ()
        if rows:
            grid_of(rows)
        slopes: list[tuple[str, Quantity | None, Quantity]] = []
        if self.traction_slope is not None:
            slopes = [("", None, self.traction_slope)]
        slopes += [
            (f"traction_table.{number}.", row.pressure, row.traction_slope)
            for number, row in enumerate(rows, start=1)
        ]
        for place, pressure, slope in slopes if self.rig else []:
            assert self.rig is not None
            modulus, peak = self.rig.contact(pressure)
            steepest = modulus / peak
            if slope.value >= steepest:
                raise InputError(
                    f"{place}traction_slope: {slope.text} is steeper than the discs alone, whose slope E*/p0 is "
                    f"{steepest:.4g}: below that it must be; look whether the slide-roll ratio is a share and no per "
                    "cent, and whether the sizes of the rig are right"
                )
        return self

    @model_validator(mode="after")
    def _curves_of_films(self) -> Self:
        if self.traction_curve:
            grid_of(self.traction_curve)
            self.film_curves()
        return self

    def film_curves(self) -> list[Points]:
        """The points of each curve without what the discs of the rig yield; as they were read without a rig."""
        films = []
        for number, curve in enumerate(self.traction_curve or (), start=1):
            assert curve.points is not None
            try:
                modulus, peak = (None, None) if self.rig is None else self.rig.contact(curve.pressure)
                films.append(of_film(curve.points, modulus, peak))
            except InputError as error:
                raise InputError(f"traction_curve.{number}: {error}") from None
        return films

    def in_tables(self, plain: Document) -> Document:
        """Its tables in SI units, in which curves are a text, that of their films, and so is the grid of a table."""
        if self.traction_table:
            plain["traction_grid"] = " ".join(map(str, grid_of(self.traction_table)))
        if not self.traction_curve:
            return plain
        axes = {
            f"{name}s": sorted({getattr(curve, name) for curve in self.traction_curve} - {None})
            for name in _CONDITIONS
        }
        curves = json.dumps(axes | {"curves": self.film_curves()})
        left = {name: value for name, value in plain.items() if name not in ("traction_curve", "rig")}
        return left | {CURVES: curves}


def rig_contact(rig: Document, pressure: Real | None = None) -> tuple[Real, Real]:
    """Contact modulus E* and peak pressure of the discs of a rig [Pa], from its table in SI units.

    ``pressure``: that of a measurement which states its own.
    """
    modulus = 0.5 * rig["youngs_modulus"] / (1.0 - rig["poisson_ratio"] ** 2)
    if pressure is not None:
        return modulus, pressure
    if "peak_pressure" in rig:
        return modulus, rig["peak_pressure"]
    curvature = 1.0 / rig["first_radius"] + (1.0 / rig["second_radius"] if "second_radius" in rig else 0.0)
    pressed = {"normal_force": rig["load"], "contact_length": rig["length"]}
    width = half_width(**pressed, effective_radius=1.0 / curvature, contact_modulus=modulus)
    return modulus, peak_pressure(**pressed, half_width=width)

"""What the sections ``[drive]`` of joint files have in common, and the entries that may differ by contact."""

from __future__ import annotations

from typing import Annotated, Any, Literal, NamedTuple

from pydantic import BeforeValidator, Discriminator, StringConstraints, Tag

from asperity.joint_file import limits
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.quantity_key import Entered, Quantity
from asperity.joint_file.section import ONE_FOR_ALL, ONE_FOR_EACH, Section
from asperity.joint_file.sections import ContactLength, Friction, Skew, WearCoefficient
from asperity.units import format_quantity

#: The name of a roller or a contact.
PartName = Annotated[str, StringConstraints(pattern=r"^[A-Za-z][A-Za-z0-9_-]{0,59}$")]


def _number_or_table(written: Any) -> str:
    return ONE_FOR_EACH if isinstance(written, dict) else ONE_FOR_ALL


def _table_or_tables(written: Any) -> str:
    tables = isinstance(written, dict) and any(
        isinstance(value, dict | SurfaceEntry) for value in written.values()
    )
    return ONE_FOR_EACH if tables else ONE_FOR_ALL


PartLengths = Annotated[
    Annotated[ContactLength, Tag(ONE_FOR_ALL)] | Annotated[dict[PartName, ContactLength], Tag(ONE_FOR_EACH)],
    Discriminator(_number_or_table),
]
PartFriction = Annotated[
    Annotated[Friction, Tag(ONE_FOR_ALL)] | Annotated[dict[PartName, Friction], Tag(ONE_FOR_EACH)],
    Discriminator(_number_or_table),
]
PartSurfaces = Annotated[
    Annotated[SurfaceEntry, Tag(ONE_FOR_ALL)] | Annotated[dict[PartName, SurfaceEntry], Tag(ONE_FOR_EACH)],
    Discriminator(_table_or_tables),
]
PartSkews = Annotated[
    Annotated[Skew, Tag(ONE_FOR_ALL)] | Annotated[dict[PartName, Skew], Tag(ONE_FOR_EACH)],
    Discriminator(_number_or_table),
]
PartWear = Annotated[
    Annotated[WearCoefficient, Tag(ONE_FOR_ALL)]
    | Annotated[dict[PartName, WearCoefficient], Tag(ONE_FOR_EACH)],
    Discriminator(_number_or_table),
]
Wall = Annotated[Quantity, limits.WALL_THICKNESS]
Bore = Annotated[Quantity, limits.BORE_DIAMETER]
RingSupport = Literal["rigid_housing", "free", "elastic_housing"]
#: Supports in which a ring bends.
BENT = ("free", "elastic_housing")


def _ratio(written: Any) -> float:
    return limits.RATIO.read(written).value


class OpenRadius(NamedTuple):
    """A radius of the section [drive] that follows from the speed ratio of the file [m], and that ratio."""

    name: str
    radius: float
    ratio: float

    @property
    def words(self) -> str:
        """What was found."""
        found = format_quantity(self.radius, "mm", 6)
        return f"drive.ratio = {self.ratio:g}: {self.name} = {found} follows from it"


class RollerDrive(Section):
    """What the sections [drive] of all types have in common that state radii."""

    ratio: (
        Annotated[float, BeforeValidator(_ratio, json_schema_input_type=float), Entered(limits.RATIO)] | None
    ) = None
    """Speed ratio without its sign, in place of exactly one of the radii, which then follows from it."""

"""From the tables of a joint file to its drive and to what its bodies are."""

from __future__ import annotations

import dataclasses

from asperity.drive.layout.drive import Drive
from asperity.drive.layout.drive_type import ShapeSizes
from asperity.joint.body_shape import BodyShape, ring_shape
from asperity.joint_file.part_names import drive_type_of
from asperity.joint_file.si_tables import Values
from asperity.types import Real

#: A drive, what its bodies are, and the share of its interference at each contact.
Layout = tuple[Drive, tuple[BodyShape, ...], tuple[float, ...]]


def layout_of(values: Values) -> Layout:
    """The drive of tables in SI units, what its bodies are, and the interference of each contact over its own."""
    kind = drive_type_of(values)
    housing = values.get("compliance", {}).get("ring_housing_stiffness")
    shapes = tuple(_shape(sizes, housing) for sizes in kind.shapes(values))
    return kind.drive_of(values), shapes, kind.interference_shares(values)


def _shape(sizes: ShapeSizes, housing: Real | None) -> BodyShape:
    """What a body is, from what the file says of it and the stiffness of the housing around rings [N/m^3]."""
    if sizes.wall is not None:
        ring = ring_shape(sizes.wall, sizes.support, housing)  # type: ignore[arg-type]
        return dataclasses.replace(ring, length=sizes.length)
    return BodyShape("solid" if sizes.bore is None else "hollow", sizes.bore, length=sizes.length)
